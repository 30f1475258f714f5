/* hawser/plan.h - a study of a scene before it is run: which effects are modelled and which are not,
 * the sizes of the models, and estimates of the cost and of the error of their responses.
 *
 * Errors and times are estimated from the modes by formulas (doc/theory-study.md). Quantities are
 * scaled (statics.h) unless the name or the comment says SI.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_PLAN_H
#define HAWSER_PLAN_H

#include <hawser/choose.h>
#include <hawser/study.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An effect, whether it is modelled, and the reason. */
struct hawser_plan_decision {
	const char *subject; /* "out-of-plane motion"; static string */
	int modelled;
	char why[240];
};

/* One of the candidate modes. */
struct hawser_plan_mode {
	int kept;                  /* 1: in the scene's own model */
	int worth;                 /* 1: needed for the scene's accuracy (choose.h) */
	enum hawser_reason reason; /* why it is needed, or not */
	double measure;            /* estimated error if it is omitted */
};

/* The primary resonance of one mode by the method of multiple scales (doc/theory-study.md). */
struct hawser_plan_resonance {
	int mode;           /* index */
	double omega;       /* natural frequency */
	double peak, peak_omega; /* largest amplitude of the mode's coordinate, and its frequency */
	double motion;      /* largest displacement of the cable at the peak, in the mode's shape */
	int folds;          /* 0 or 2 */
	double cubic;       /* effective cubic coefficient, which includes the static response of all
	                     * other modes */
	double unlocked;    /* cubic coefficient without that response: the entry of the tensor */
	double doubt;       /* estimated error of `cubic` */
	int partner;        /* a mode that may exchange energy with it, or -1 */
	int order;          /* ratio of the partner's frequency to this one, rounded */
};

/* The size of the model of one fidelity, and the estimates for its response. */
struct hawser_plan_row {
	struct hawser_fidelity_choice choice;
	int n;               /* coordinates */
	long quads, cubics;  /* tensor entries that are not zero by symmetry */
	double points;       /* of the curve; NAN without one */
	double seconds;      /* processor time on this machine for model and response */
	double least, most;  /* the range in which nine of ten such times are */
	int estimated;       /* 1: the scene has a response, and these are known */
	enum hawser_status status; /* with which the response will end, as far as is foreseen */
	char foreseen[240];  /* why; or "" */
	double omega_error;  /* of condensed models: what hawser_accuracy_fixed would state of their
	                      * response, in motions that are foreseen; of raw ones and multiple scales the
	                      * relative error of the frequencies of folds and peaks for the worst
	                      * resonance. NAN: not known, INFINITY: a mode in the range is missing */
	int worst;           /* index of this resonance, or -1 */
	char why[200];       /* basis of the error estimate */
};

struct hawser_plan {
	double from, to;
	struct hawser_modes modes;   /* the candidates */
	double *load;                /* [modes.n] load on each mode */
	struct hawser_plan_mode *mode; /* [modes.n] */
	int chosen;                  /* 1: worth, reason and measure of the modes are known */
	int resonances, undamped; /* numbers of resonances of damped modes, which are listed, and of
	                           * undamped modes */
	struct hawser_plan_resonance *resonance; /* [resonances] in the range, ascending */
	int decisions;
	struct hawser_plan_decision *decision;   /* [decisions] */
	int rows;
	struct hawser_plan_row *row;             /* [rows] in the order of the given choice; then, of a
	                                          * scene with a load, what hawser frf answers by default */
	double seconds;              /* processor time taken by the plan itself */
};

/* Plan the response of a scene over [from, to] (either order) at the fidelities choice [count].
 * A scene without a load has decisions and sizes, but neither resonances nor
 * estimates. Release with hawser_plan_clear. HAWSER_ERR_ARGUMENT (range), and the statuses of
 * hawser_modes_solve and hawser_rom_build. */
enum hawser_status hawser_plan_make(struct hawser_plan *plan, const struct hawser_statics *statics,
                                    const struct hawser_scene *scene,
                                    const struct hawser_fidelity_choice *choice, int count,
                                    double from, double to,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* Size, points and time of the response of a model over a range; natural [naturals] are its natural
 * frequencies, each of which is taken to bend by e times its width. */
void hawser_plan_model(struct hawser_plan_row *row, const struct hawser_rom *rom, double from,
                       double to, const double *natural, int naturals);
void hawser_plan_clear(struct hawser_plan *plan);

#ifdef __cplusplus
}
#endif
#endif

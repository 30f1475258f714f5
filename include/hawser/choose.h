/* hawser/choose.h - which modes a reduced model of a scene should keep, and why.
 *
 * Modes that are not kept are condensed: they follow the kept ones statically (rom.h). A mode must be
 * kept if this is inaccurate: if the load drives it, if its inertia matters at the frequencies of the
 * quadratic and cubic forces, if it is in resonance with a kept mode, or if the motion of a kept mode
 * makes it unstable. The measure of a mode is the estimated relative error of frequency or amplitude
 * of the response without it. doc/theory-rom.md, "Which modes are kept".
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CHOOSE_H
#define HAWSER_CHOOSE_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_reason {
	HAWSER_NOT_EXCITED = 0, /* no load, no coupling: it stays at rest */
	HAWSER_CONDENSED,       /* its static response is accurate enough */
	HAWSER_DIRECT,          /* the load drives it */
	HAWSER_PARAMETRIC,      /* the motion of other modes can make it unstable */
	HAWSER_INTERNAL,        /* its frequency is near that of a kept mode or near a multiple (2 or more)
	                         * of the forcing frequency, and forces of that frequency act on it */
	HAWSER_DYNAMIC,         /* it follows other modes, but its inertia matters */
	HAWSER_REASONS
};
const char *hawser_reason_name(enum hawser_reason reason); /* "direct", "not excited", ... */

struct hawser_choice_mode {
	int kept;
	enum hawser_reason reason; /* why it is or would be kept, by the last motion that was weighed; if
	                  * that gives none, why it was kept first */
	double measure;  /* estimated relative error of frequency or amplitude if it is not kept. If the
	                  * reason is HAWSER_PARAMETRIC: strength of the excitation over that at which
	                  * instability begins. 0: at rest in all motions weighed, but for round-off */
	double omega;    /* scaled forcing frequency at which the measure was found */
	int harmonic;    /* harmonic of omega to which it responds; HAWSER_PARAMETRIC: order of the
	                  * resonance */
	int partner;     /* index of the mode with which it is in resonance, or -1 */
};

struct hawser_choice {
	int n;                           /* number of candidates, the modes of `modes` */
	const struct hawser_modes *modes; /* owned by the caller */
	double from, to;                 /* scaled, from < to */
	struct hawser_choice_mode *mode; /* [n] */
	int *order;                      /* [n] indices of modes, most important first */
	double *load;                    /* [n] scaled force on each mode at its own frequency, by the
	                                  * load, the fluctuation of the speed and gyroscopic terms */
	int answered;                    /* 1: displacements contain all of the linear response to the
	                                  * load of modes that are not kept */
	int planar;                      /* 1: nothing drives a mode out of plane */
	double largest;                  /* mean square, scaled, of the largest motion in a plane so far */
	struct hawser_rom all;           /* condensed model with all the modes */
	struct hawser_rom exact;         /* the full-order model; n is 0 for an inextensible cable */
	int *twin;                       /* [n] 1 + the index of the mode in `exact`, negative if it has the
	                                  * opposite sign there; 0 if `exact` does not resolve it */
	double truncation;               /* estimated relative error of folds and peaks, to first order, in
	                                  * the motions weighed since _forget, that is due to the energy
	                                  * of fourth order and to the missing inertia and damping of modes
	                                  * that are not candidates; 0 without `exact` */
	double energy;                   /* the part of it that is due to the order of the energy */
	double followed;                 /* the same error with inertia and damping of all modes that are
	                                  * not kept, added with their signs; `measure` adds magnitudes */
};

/* Choose among the modes of `modes`, whose frequencies should reach well above twice the range, for a
 * response in the scaled range [from, to] (either order). The measures follow from the linear response,
 * limited by damping and by how far the resonance can bend within the range. The modes that `accuracy`
 * requires are kept, at least one. Release with hawser_choice_clear. Statuses: HAWSER_ERR_ARGUMENT
 * (range, accuracy outside (0, 1), a scene without a load or a fluctuating speed, or one that drives
 * nothing), and those of hawser_rom_build. */
enum hawser_status hawser_choose(struct hawser_choice *choice, const struct hawser_modes *modes,
                                 const struct hawser_scene *scene, double from, double to,
                                 double accuracy, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* A choice among the coordinates of a model that exists, which are the lowest modes of something else
 * than a span, with all others condensed and their response to the load known; of `modes` n, mode and
 * time_unit are used. No mode is kept yet but those that the load drives. *all is taken over.
 * HAWSER_ERR_ARGUMENT: the load drives nothing; HAWSER_ERR_MEMORY. */
enum hawser_status hawser_choice_of(struct hawser_choice *choice, struct hawser_rom *all,
                                    const struct hawser_modes *modes, double from, double to,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Raise the measures by a motion that was computed with the modes now kept: coordinate[rows][kept]
 * over one period of the scaled forcing frequency `omega`, equidistant. Begin with the largest motion.
 * whole = 0: only modes that the motion makes unstable are sought, since its own amplitude does not
 * matter. Measures never fall, except by _forget. Statuses:
 * HAWSER_ERR_ARGUMENT (fewer than 8 rows), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                       int rows, double omega, int whole,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set all measures to 0, before those of a computed motion replace the first estimates. The reasons of
 * kept modes stay until another reason is found. */
void hawser_choice_forget(struct hawser_choice *choice);

/* Keep more modes, the most important first, until the measures of the others add up to at most
 * `accuracy`. Returns the number of modes added. */
int hawser_choice_raise(struct hawser_choice *choice, double accuracy);

/* Keep the `count` most important of the modes that are not kept. Returns the number added. */
int hawser_choice_add(struct hawser_choice *choice, int count);

/* Keep the `count` most important modes only. Returns the number kept, which is smaller if fewer are
 * excited. */
int hawser_choice_first(struct hawser_choice *choice, int count);

/* Why mode j is kept; HAWSER_CONDENSED or HAWSER_NOT_EXCITED if it is not. */
enum hawser_reason hawser_choice_reason(const struct hawser_choice *choice, int j);

/* kept[n] becomes the indices of the kept modes, ascending; returns their number. */
int hawser_choice_kept(int *kept, const struct hawser_choice *choice);

/* The sum of the measures of the candidates that are not kept; and the extrapolated sum of the measures
 * of all modes above the candidates. */
double hawser_choice_rest(const struct hawser_choice *choice);
double hawser_choice_beyond(const struct hawser_choice *choice);

void hawser_choice_clear(struct hawser_choice *choice);

#ifdef __cplusplus
}
#endif
#endif

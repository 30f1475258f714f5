/* hawser/choose.h - which modes a reduced model of a scene should keep, and why.
 *
 * Every mode that is not kept follows the kept ones statically (rom.h). A mode is worth keeping as far
 * as it does something else than follow: because the load drives it, because its inertia counts at the
 * frequencies of the quadratic and cubic forces, because a resonance with a kept one makes it large, or
 * because a kept motion makes it unstable. How far, one number says, the mode's measure: by what part
 * frequency or amplitude of the response are off without it. doc/theory-rom.md, "Which modes are kept".
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
	HAWSER_CONDENSED,       /* its static answer suffices */
	HAWSER_DIRECT,          /* the load drives it */
	HAWSER_PARAMETRIC,      /* the motion of others can make it unstable */
	HAWSER_INTERNAL,        /* its frequency is near a multiple of the forcing's, 2 or more, or of a
	                         * kept mode's, and forces of that frequency act on it */
	HAWSER_DYNAMIC,         /* it answers, but its inertia counts */
	HAWSER_REASONS
};
const char *hawser_reason_name(enum hawser_reason reason); /* "direct", "not excited", ... */

struct hawser_choice_mode {
	int kept;
	enum hawser_reason reason; /* what it is or would be kept for; where nothing was weighed since
	                  * that tells another, what it was first kept for */
	double measure;  /* part by which frequency or amplitude are off when it is not kept; for a
	                  * parametric one the strength over that which instability needs; 0: at rest
	                  * in all motions weighed, or no more than round-off */
	double omega;    /* scaled forcing frequency at which that was found */
	int harmonic;    /* of omega, that it answers; of a parametric one the order of the resonance */
	int partner;     /* index of the mode that it resonates with, or -1 */
};

struct hawser_choice {
	int n;                           /* modes looked at, those of `modes` */
	const struct hawser_modes *modes; /* the caller's */
	double from, to;                 /* scaled, from < to */
	struct hawser_choice_mode *mode; /* [n] */
	int *order;                      /* [n] indices of modes, most important first */
	double *load;                    /* [n] scaled, what drives each mode at its own frequency: load,
	                                  * the speed's fluctuation, gyroscopic terms */
	int planar;                      /* 1: the load has nothing that drives a mode out of plane */
	double largest;                  /* mean square, scaled, of the largest motion in a plane so far */
	struct hawser_rom all;           /* condensed model with all the modes */
	struct hawser_rom exact;         /* the full-order model; n is 0 for an inextensible cable */
	int *twin;                       /* [n] 1 + the index of a mode in `exact`, negative where its sign
	                                  * is the other one there; 0 where `exact` does not resolve it */
	double truncation;               /* part by which folds and peaks are off, to first order, as
	                                  * the energy of a condensed model ends with the fourth order and
	                                  * modes that are not looked at have neither inertia nor damping,
	                                  * in the motions weighed since _forget; 0 without `exact` */
	double energy;                   /* the same, of the energy's order alone */
	double followed;                 /* the same with inertia and damping of every mode that is not
	                                  * kept, signs and all, where `measure` adds them up one by one */
};

/* Look at the modes of `modes`, which should reach well above twice the range, for a response in the
 * scaled range [from, to] (either order): measures, from the linear response bounded by damping and by
 * how far the resonance can bend within the range; what is worth `accuracy` is kept, one mode at the
 * least. Release with hawser_choice_clear. Statuses: HAWSER_ERR_ARGUMENT (range, accuracy outside (0,
 * 1), a scene without a load or a speed that fluctuates or that drives nothing), and those of
 * hawser_rom_build. */
enum hawser_status hawser_choose(struct hawser_choice *choice, const struct hawser_modes *modes,
                                 const struct hawser_scene *scene, double from, double to,
                                 double accuracy, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Measures anew from a motion that was computed with the modes now kept: coordinate[rows][kept] over
 * one period of the scaled forcing frequency `omega`, equidistant. Begin with the largest motion.
 * whole = 0: look only for what the motion makes unstable, because its own amplitude is not asked for.
 * Measures only grow, until _forget. Statuses:
 * HAWSER_ERR_ARGUMENT (fewer than 8 rows), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                       int rows, double omega, int whole,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Forget all measures, of the guess that a computed motion is to replace; the reasons of kept modes
 * stay until another is found. */
void hawser_choice_forget(struct hawser_choice *choice);

/* Keep more, most important first, until the measures of the rest sum up to no more than `accuracy`;
 * returns the number of modes added. */
int hawser_choice_raise(struct hawser_choice *choice, double accuracy);

/* Add the `count` most important ones of those that are not kept; returns the number added. */
int hawser_choice_add(struct hawser_choice *choice, int count);

/* Keep fewer, leaving out the least important first, as long as the measures of the rest sum up to no
 * more than `accuracy`; returns the number of modes left out. */
int hawser_choice_lower(struct hawser_choice *choice, double accuracy);

/* Keep the `count` most important ones and no others; returns the number kept, which is less where
 * fewer are excited. */
int hawser_choice_first(struct hawser_choice *choice, int count);

/* Why mode j is kept; of one that is not, HAWSER_CONDENSED or HAWSER_NOT_EXCITED. */
enum hawser_reason hawser_choice_reason(const struct hawser_choice *choice, int j);

/* kept[n] becomes the indices of the kept modes, ascending; returns their number. */
int hawser_choice_kept(int *kept, const struct hawser_choice *choice);

/* The sum of the measures of the modes that are not kept; and what those beyond the ones looked at
 * would add to it, extrapolated. */
double hawser_choice_rest(const struct hawser_choice *choice);
double hawser_choice_beyond(const struct hawser_choice *choice);

void hawser_choice_clear(struct hawser_choice *choice);

#ifdef __cplusplus
}
#endif
#endif

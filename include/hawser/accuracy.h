/* hawser/accuracy.h - the frequency response of a scene to a requested accuracy. Modes are added in
 * the order of their importance (choose.h) until folds and peaks no longer move. If no number of
 * modes suffices, the full-order model is used. doc/theory-rom.md, "Which modes are kept".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ACCURACY_H
#define HAWSER_ACCURACY_H

#include <hawser/choose.h>
#include <hawser/study.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One model that was tried. */
struct hawser_accuracy_try {
	int modes;
	int functions;  /* per component, of the full-order model; 0: condensed model */
	double moved;   /* hawser_accuracy_distance from the response of the previous model; NAN for the
	                 * first model */
	double rest;    /* sum of the measures of the omitted modes (choose.h) in this model's motions;
	                 * 0 of the full-order model */
	double truncation; /* error in these motions that further modes do not reduce (choose.h); 0 of
	                    * the full-order model */
	double energy;  /* part of `truncation` that is due to the order of the energy */
	int folds, peaks, points;
	double seconds; /* wall time to build the model and to trace its response */
};
enum { HAWSER_ACCURACY_TRIES = 14 };

struct hawser_accuracy {
	double asked, estimated;     /* relative error of folds and peaks: requested, estimated. The
	                              * estimate is at least asked/10, since the tolerances are chosen
	                              * for the requested accuracy */
	int slack;                   /* 1: the search ended because the tension is negative at a fifth of
	                              * the points or more */
	int reached;                 /* 1: the curve is complete and estimated <= asked */
	struct hawser_modes modes;   /* all candidates */
	struct hawser_choice choice; /* which of them are kept; refers to `modes` */
	int full;                    /* 1: the last model is the full-order model */
	struct hawser_rom rom;       /* the last model */
	struct hawser_frf frf;       /* its response, with tolerances chosen for the accuracy */
	struct hawser_accuracy_try attempt[HAWSER_ACCURACY_TRIES];
	int tries;
	double seconds;              /* wall time of the whole search */
};

struct hawser_accuracy_options {
	double accuracy;         /* in (0, 1); 0: the scene's */
	int most;                /* largest number of kept modes; 0: 40 */
	struct hawser_frf_options frf; /* range and method as in frf.h. tolerance, event_tolerance and
	                                * step_max: 0: chosen for the accuracy. max_points: at most 2500;
	                                * 0: 2500. progress is called for each model in turn */
};

/* The candidate modes for a range and an accuracy, and the choice among them before any response is
 * known, with which hawser_accuracy_trace begins. *modes and *choice are overwritten, also on
 * failure; the choice refers to the modes; clear both. Statuses: those of hawser_modes_solve and
 * hawser_choose. */
enum hawser_status hawser_accuracy_choose(struct hawser_choice *choice, struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_scene *scene, double from, double to,
                                          double accuracy,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* The condensed model of the kept ones. Statuses: those of hawser_rom_build. */
enum hawser_status hawser_choice_build(struct hawser_rom *rom, const struct hawser_choice *choice,
                                       const struct hawser_scene *scene,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Trace. *accuracy must stay where it is (choice refers to modes); release with hawser_accuracy_clear
 * whatever the status. An accuracy that was not reached is HAWSER_OK with reached = 0, as is
 * an interrupted run, frf.end telling. Statuses: HAWSER_ERR_ARGUMENT (accuracy; condense: none, which
 * leaves nothing to follow), those of hawser_accuracy_choose and hawser_frf_trace. */
enum hawser_status hawser_accuracy_trace(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_accuracy_clear(struct hawser_accuracy *accuracy);

/* How far a response may be off for the modes that its model does not keep, to first order:
 * relative error of folds and peaks. */
struct hawser_accuracy_fixed {
	double estimated;  /* of what follows, 1 at most */
	double rest;       /* sum of the measures of the modes left out (choose.h) */
	double beyond;     /* and of those that were not looked at, extrapolated */
	double truncation; /* what no mode makes up for (choose.h) */
	double followed;   /* that together with what the modes left out do, signs and all (choose.h) */
	double located;    /* how well the peaks are located */
	int looked_at;     /* modes */
	int at_risk;       /* number of the first mode left out that the motion can make unstable, so
	                    * that a branch is missing; 0: none. It counts in `rest` by the strength
	                    * over that which instability needs */
	double seconds;    /* wall time that this took */
};

/* That of the response `frf` of a condensed model `rom` of a scene that keeps the lowest `kept`
 * modes, from its own motions, as hawser_accuracy_trace estimates it before it adds modes; no other
 * response is traced. Statuses: HAWSER_ERR_ARGUMENT (condense: none, exact energy, a response
 * without a point), those of hawser_accuracy_choose and hawser_choice_weigh. */
enum hawser_status hawser_accuracy_fixed(struct hawser_accuracy_fixed *fixed,
                                         const struct hawser_rom *rom, const struct hawser_frf *frf,
                                         int kept, const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, double from, double to,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* How far two responses of one scene and range are apart, *distance: the largest of
 *   the relative differences of Omega at folds that both have, and of Omega and amplitude at peaks that
 *     both have, of those components of the probes that reach half of the largest;
 *   the distance of the two curves as a whole, relative in Omega or in amplitude, whichever is nearer
 *     (study/curve.c). What only one of them has counts by how far it stands out from the other.
 * With their models (or NULL), peaks that are not known to `wanted`, relative, are traced again in
 * shorter steps. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_accuracy_distance(double *distance, const struct hawser_frf *a,
                                            const struct hawser_rom *rom_a,
                                            const struct hawser_frf *b,
                                            const struct hawser_rom *rom_b, double wanted,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif

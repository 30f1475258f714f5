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
	                 * first model. Of the full-order model the distance of its draft from that of
	                 * `checked`; of a condensed one with `checked` its distance from the
	                 * exact energy */
	int checked;    /* coordinates of the next full-order model, with whose curve that of this one
	                 * was compared; 0: of a condensed model that was compared with none */
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
	double largest;              /* part of `estimated` that is of folds and the two largest stable
	                              * peaks, if it was found for these; 0: not */
	int slack;                   /* 1: the search ended because the tension is negative at a fifth of
	                              * the points or more */
	int reached;                 /* 1: the curve covers the whole range of Omega, and
	                              * estimated <= asked */
	struct hawser_modes modes;   /* all candidates */
	struct hawser_choice choice; /* which of them are kept; refers to `modes` */
	int full;                    /* 1: the last model is the full-order model */
	struct hawser_rom rom;       /* the last model */
	struct hawser_frf frf;       /* its response, */
	struct hawser_frf_options traced; /* with these options; the tolerances suit the accuracy */
	struct hawser_accuracy_try attempt[HAWSER_ACCURACY_TRIES];
	int tries;
	double seconds;              /* wall time of the whole search */
	double began;                /* s, CLOCK_MONOTONIC: when full-order models began */
	int functions;               /* of the last full-order model that was looked at; 0: none */
	int checked;                 /* options->after: coordinates of the model that confirms it */
	double foreseen;             /* s of processor time of full-order models and what follows, as
	                              * counted: within a factor 2 on a core of 2 GHz */
	int costly;                  /* 1: that is more than options->bearable, and the search ended */
	double until;                /* options->partial: scaled frequency at which the response ends, since
	                              * the rest was not to be had; NAN: it is whole */
	char beyond[640];            /* why the motion there could not be followed; "": it is the work */
};

struct hawser_accuracy_options {
	double accuracy;         /* in (0, 1); 0: the scene's */
	int most;                /* largest number of kept modes; 0: 40 */
	int most_functions;      /* of full-order models, per component; 0: 24. With bending 6 more */
	double bearable;         /* full-order models are given up where `foreseen` is more; 0: never */
	int expected;            /* points of the response, by a reduced model; 0: not known */
	int partial;             /* 1: where the range is not to be had as a whole, the part from `from` on
	                          * that is */
	int agreed;              /* 1: no response of a full-order model that no other agrees with */
	double after;            /* over 0: the full-order model is wanted, not its response, and its use
	                          * takes this many times as long as the coarse curve that chooses it */
	/* hawser_accuracy_exact: a reduced model whose error is not known, and its response, or NULL.
	 * Where that is right to `near` (0: accuracy) it is the answer: `functions` is 0, `estimated` is
	 * its error, and `rom` and `frf` are not set; also, but for `functions`, where more than `bearable`
	 * is foreseen. */
	const struct hawser_rom *rom;
	const struct hawser_frf *response;
	double near;
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

/* Build the condensed model of the kept modes. Statuses: those of hawser_rom_build. */
enum hawser_status hawser_choice_build(struct hawser_rom *rom, const struct hawser_choice *choice,
                                       const struct hawser_scene *scene,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Find the modes and trace the response. *accuracy must not be moved, since its choice refers to
 * its modes. Release with hawser_accuracy_clear, whatever the status. If the accuracy was not
 * reached, the status is HAWSER_OK and `reached` is 0. The same holds for an interrupted run, whose
 * frf.end says so. Statuses: HAWSER_ERR_ARGUMENT (accuracy; condense: none, with which omitted
 * modes do not follow the kept ones), those of hawser_accuracy_choose and hawser_frf_trace. */
enum hawser_status hawser_accuracy_trace(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_accuracy_clear(struct hawser_accuracy *accuracy);

/* The same by full-order models alone, of increasing bases: where a response of a reduced model is not
 * good enough. HAWSER_ERR_ARGUMENT: accuracy; an inextensible cable, which has no such models. */
enum hawser_status hawser_accuracy_exact(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The bases of full-order models that these searches try: those that hold the modes and the load. */
struct hawser_accuracy_bases {
	const struct hawser_modes *modes; /* by a method that converges; at least up to 2*to */
	const struct hawser_scene *scene;
	double to;       /* scaled: the upper end of the range */
	double accuracy; /* the frequencies up to `to` are right to a tenth of it, up to 2*to to the
	                  * whole */
	int most;        /* largest number of functions, and with bending 6 more; 0: 24, which is
	                 * tried whatever it resolves */
};
/* *rom becomes the first of them with more than *functions functions a component, of which *functions
 * then is the number, and more than `coordinates`; rom->n is 0 if there is none. Statuses of
 * hawser_rom_build_full and hawser_rom_full_lacks. */
enum hawser_status hawser_accuracy_basis(struct hawser_rom *rom, int *functions,
                                         const struct hawser_accuracy_bases *bases, int coordinates,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The estimated error of a response, to first order, that is due to the modes that its model does
 * not keep: relative error of folds and peaks. */
struct hawser_accuracy_omission {
	int mode;          /* counted from 1 by frequency */
	int harmonic;      /* of the forcing frequency, to which it responds most */
	double omega, measure; /* scaled natural frequency; of choose.h */
};
enum { HAWSER_ACCURACY_NAMED = 4 };
struct hawser_accuracy_fixed {
	double estimated;  /* total of the following parts, at most 1 */
	double largest;    /* the same of folds and the two largest stable peaks alone; 0: not known */
	double rest;       /* sum of the measures of the omitted candidates (choose.h) */
	double beyond;     /* sum of the measures of the modes above the candidates, extrapolated */
	double truncation; /* error that no further modes reduce (choose.h) */
	double followed;   /* the same with the effect of the omitted modes, added with signs
	                    * (choose.h) */
	double located;    /* estimated error of the location of the peaks */
	int looked_at;     /* number of candidate modes */
	int at_risk;       /* number of the first omitted mode that the motion can make unstable, so
	                    * that a branch is missing; 0: none. Its measure in `rest` is the strength
	                    * of the excitation relative to that at which instability begins */
	double seconds;    /* wall time of this estimate */
	int omissions;     /* omitted modes of the largest measures, the largest first, where the error
	                    * is more than a hundredth by them */
	struct hawser_accuracy_omission omission[HAWSER_ACCURACY_NAMED];
};

/* Estimate this error for the response `frf` of a condensed model `rom` that keeps the lowest
 * `kept` modes of a scene. The motions of the response are examined as hawser_accuracy_trace does
 * before it adds modes; no other response is traced. Statuses: HAWSER_ERR_ARGUMENT (condense: none,
 * exact energy, a response without a point), those of hawser_accuracy_choose and
 * hawser_choice_weigh. */
enum hawser_status hawser_accuracy_fixed(struct hawser_accuracy_fixed *fixed,
                                         const struct hawser_rom *rom, const struct hawser_frf *frf,
                                         int kept, const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, double from, double to,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* With the peaks [count] of that response, by hawser_peaks, which locates them better. */
void hawser_accuracy_locate(struct hawser_accuracy_fixed *fixed, const struct hawser_landmark *peak,
                            int count);

/* The same of a model that keeps the kept modes of a choice, ascending, whose measures become those of
 * the motions of its response. */
enum hawser_status hawser_accuracy_among(struct hawser_accuracy_fixed *fixed,
                                         struct hawser_choice *choice, const struct hawser_rom *rom,
                                         const struct hawser_frf *frf,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same for one forced motion of such a model, of which the period from `state` on is examined:
 * relative error of its amplitudes and of the frequency at which it occurs. What does not repeat itself
 * with the period counts as a jump at its end. Statuses: those of hawser_accuracy_fixed and
 * hawser_integrate. */
struct hawser_accuracy_motion {
	double omega;        /* scaled, of the forcing */
	double time;         /* scaled; the phase of the forcing is omega*time */
	const double *state; /* [2n] u, then u' */
};
enum hawser_status hawser_accuracy_once(struct hawser_accuracy_fixed *fixed,
                                        const struct hawser_rom *rom,
                                        const struct hawser_accuracy_motion *motion, int kept,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* What answers in place of a response of a reduced model that is not good enough, as model.energy: auto
 * does in hawser frf: hawser_accuracy_exact, with these options. */
enum { HAWSER_INSTEAD_POINTS = 1500 }; /* of its response, at most */
#define HAWSER_INSTEAD_FOR_ERROR 3.0 /* s: most work of full-order models for the error of a
                                      * response that nothing else tells; chosen */
/* Whether such an error is reason enough; limit: of the whole error, 0: 0.02. */
int hawser_accuracy_poor(const struct hawser_accuracy_fixed *fixed, double limit);
/* Whether that part of it is, that no number of modes makes up for. */
int hawser_accuracy_truncated(double truncation);
/* fixed: NULL: not known. own: the accuracy asked for is the scene's; 0: 0.01. */
struct hawser_accuracy_options hawser_accuracy_instead(const struct hawser_accuracy_fixed *fixed,
                                                       int own,
                                                       const struct hawser_frf_options *frf);

/* The distance of two responses of one scene over one range, *distance. It is the largest of:
 *    the relative differences of Omega at folds that both have, and of Omega and of the amplitude at
 *      peaks that both have, for components of the probes that reach half of the largest component;
 *    the distance of the two curves as a whole, relative in Omega or in amplitude, whichever is
 *      smaller (study/compare/curve.c). A part that only one curve has counts by its distance from
 *      the other.
 * If the models are given (else NULL), peaks that are not located to the relative error `wanted`
 * are traced again in shorter steps. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_accuracy_distance(double *distance, const struct hawser_frf *a,
                                            const struct hawser_rom *rom_a,
                                            const struct hawser_frf *b,
                                            const struct hawser_rom *rom_b, double wanted,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif

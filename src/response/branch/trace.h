/* response/branch/trace.h - the state of a continuation of periodic orbits, and the functions that its
 * files share.
 *
 * frf.c starts, follows and ends the branch; step.c has the operations of a step
 * (continuation/curve.h); judge.c decides whether a step is accepted; closure.c detects closed
 * curves; slack.c finds where a cable goes slack, which ends its branch; orbits.c keeps orbits and
 * passes them again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_TRACE_H
#define HAWSER_RESPONSE_TRACE_H

#include <complex.h>

#include "continuation/curve.h"
#include "core/hold.h"
#include "response/branch/account.h"
#include "response/time/flow.h"
#include "response/branch/record.h"
#include "response/branch/station.h"
#include "response/branch/vanish.h"

/* Arclength. In a shorter step, events are not separated further; chosen. */
#define HAWSER__SORTING_STEP 1e-4

struct hawser__trace;

/* Whether an orbit takes so much that events are less exact: with exact energy, and with tensors from
 * this number of coordinates on, of which a point takes 5 ms; chosen. */
#define HAWSER__MANY 12
static inline int hawser__is_large(const struct hawser_rom *rom)
{
	return rom->exact || rom->n >= HAWSER__MANY;
}

/* One orbit and the tangent of its curve. */
struct hawser__series {
	double arc;
	int order; /* highest harmonic of either */
	double *y; /* [2][(2 order + 1) n + 1] both, by harmonics as of harmonic balance, then Omega */
};

/* Those of the points of a curve, in their order. */
struct hawser__orbits {
	int n, count;
	struct hawser__series *item;
};

/* A caller that receives the orbits of located events, y [size] in the unknowns of the method. An
 * event may be located again when its step is repeated. `step` is called after each accepted step, from
 * trace->here to trace->next, whose events are in trace->account; it may use the scratch station.
 * `back` takes the last such step back, which is then made again, shorter. Each may be NULL. */
struct hawser__trace_watch {
	void (*event)(void *context, const struct hawser_frf_event *event,
	              const struct hawser__orbit *orbit, const double *y);
	void *context;
	enum hawser_status (*step)(void *context, struct hawser__trace *trace);
	void (*back)(void *context);
	const struct hawser__orbits *known; /* of this curve, from its beginning; NULL: none are known */
	int direct; /* 1: no detours are tried for the first orbit */
	int coarse; /* 1: longer steps: the trace is a detour itself (detour.c) */
	int for_folds; /* 1: of its points only the folds are of interest: longer steps, too */
	double first; /* most work for the first orbit, s (hawser_orbit_work); 0: as much as by default */
};

struct hawser__trace {
	const struct hawser_rom *rom;
	struct hawser_frf_options options;
	struct hawser_frf *frf;
	struct hawser__orbit *orbit;
	const struct hawser__trace_watch *watch; /* or NULL */
	struct hawser__amplitude *amplitude;
	struct hawser__station before, prev, here, next, scratch;
	struct hawser__account account; /* events of the step from here to next */
	int retries;                    /* repetitions of this step because events did not explain the
	                                 * count */
	double *direction, *side; /* [size] */
	double complex *pairs;  /* [7 m/2] workspace of hawser__collide */
	double *start_y, *start_t; /* [size] first point and its tangent, to detect a closed curve */
	double *mark_y, *mark_t; /* [size + m], [size] a later point and its tangent, to detect a jump */
	int marked;             /* index of that point; 0: none */
	int jumped;             /* 1: the curve returned to that point, or to the first one backwards */
	struct hawser__curve curve;
	double lo, hi;
	double began;           /* s, hawser__wall_seconds */
	double reached;         /* furthest place, as a part of the range */
	int enriched;           /* number of finer discretisations already used in this step */
	double undetermined;    /* error of the orbit before the last of them */
	struct hawser__shrinking shrinking;
	/* The first of the last points between which Omega is the same but for an event's error: */
	struct {
		double omega, sign[2]; /* of the tests of a fold and a branch point */
		int point;
	} level;
	int passed;             /* number of the known orbits that lie behind */
	int aimed;              /* the one at which the next step ends, */
	double aim;             /* if it has this length; 0: at none */
	int slow;               /* number of the last cycles that near a homoclinic orbit */
	int slack;              /* 1: the curve ends at next, where the cable goes slack */
	int stopped;            /* 1: the caller has ended the trace */
	int known; /* number of stations before `here`, and `here` itself */
	struct hawser_report *report;
	struct hawser__hold hold;
};

/* Omega, or the parameter of the family. */
static inline double hawser__trace_parameter(const struct hawser__trace *trace,
                                         const struct hawser__station *station)
{
	return station->y[trace->orbit->size - 1];
}

/* Whether longer steps are allowed: of large models, and of traces for their folds alone. */
static inline int hawser__trace_steps_long(const struct hawser__trace *trace)
{
	return hawser__is_large(trace->rom) || (trace->watch && trace->watch->for_folds);
}

/* frf.c: hawser_frf_trace with a receiver of events (or NULL). */
enum hawser_status hawser__frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     const struct hawser__trace_watch *watch,
                                     struct hawser_report *report);

/* step.c: whether the caller's progress function asks to end the trace, in this call or in an earlier
 * one. hawser__trace_tick calls it within a step; the trace then ends before the next step. */
int hawser__trace_told_to_stop(struct hawser__trace *trace);
void hawser__trace_tick(void *owner);

/* step.c: correct station->y in the plane of `row`, with a discretisation that is fine enough.
 * *failed becomes 1 if the corrector fails. */
enum hawser_status hawser__trace_correct(struct hawser__trace *trace,
                                         struct hawser__station *station, const double *row,
                                         int *failed);

/* step.c: whether the error of a corrected orbit is at most 5 % of its size; _determined:
 * HAWSER_ERR_CONVERGENCE if not. */
enum hawser_status hawser__trace_determined(const struct hawser__trace *trace,
                                            const struct hawser__station *station);
/* step.c: correct a station at its Omega (side: sign of the row's entry for Omega) and compute its
 * tangent in the direction `along` (NULL: that of the row), with finer discretisations while it is
 * not determined. *failed becomes 1 if the corrector fails. */
enum hawser_status hawser__trace_settle(struct hawser__trace *trace,
                                        struct hawser__station *station, double side,
                                        const double *along, int *failed);

/* judge.c: whether a corrected point is certainly on the same branch as the one before; angle is that
 * between the two tangents. And whether the events between here and next are not separated. */
int hawser__trace_trusted(const struct hawser__correction *correction, double angle);
enum hawser_status hawser__trace_hides(struct hawser__trace *trace, int *hidden);
/* judge.c: whether the step from prev to here, seen from next, may hide events. */
enum hawser_status hawser__trace_hid(struct hawser__trace *trace, int *hidden);

/* judge.c: whether the branch ends at rest; this event is then stored. */
enum hawser_status hawser__trace_vanish(struct hawser__trace *trace, int *vanished);

/* step.c: the operations of a step (continuation/curve.h); `owner` is the trace. */
int hawser__trace_interrupted(void *owner, int tries);
int hawser__trace_predict(void *owner, double ds);
enum hawser_status hawser__trace_correct_next(void *owner, double ds,
                                              struct hawser__correction *correction, int *failed);
enum hawser_status hawser__trace_refine(void *owner, double ds, double *factor);
enum hawser_status hawser__trace_finish(void *owner, double ds, double *angle);
enum hawser_status hawser__trace_judge(void *owner, double ds, double angle,
                                       enum hawser__verdict *verdict);
double hawser__trace_longest(void *owner);

/* climb.c: HAWSER_ERR_CONVERGENCE where the curve climbs without an end that could be reached. */
enum hawser_status hawser__trace_climbs(const struct hawser__trace *trace);
/* climb.c: whether multipliers of the last point are undecided. */
int hawser__trace_undamped(const struct hawser__trace *trace);

/* closure.c: whether the curve passes its first point between here and next, and at which fraction
 * of the step; `close` moves next to that point. */
int hawser__trace_closed(const struct hawser__trace *trace, double *share);
enum hawser_status hawser__trace_close(struct hawser__trace *trace, double share);
/* closure.c: whether the curve returns to another of its points, or to any of them backwards, which
 * means that a step jumped to another curve or turned round; the failure with this reason; and the
 * storage of the present point for this test. */
int hawser__trace_came_back(const struct hawser__trace *trace);
enum hawser_status hawser__trace_jumped(struct hawser__trace *trace);
void hawser__trace_mark(struct hawser__trace *trace);
/* closure.c: whether a branch has met another one in the step that was just recorded; if so, it ends
 * there. */
enum hawser_status hawser__trace_meet(struct hawser__trace *trace, int *met);

/* orbits.c: the number of values of the orbit of a series, of n coordinates, with Omega. */
size_t hawser__series_length(const struct hawser__series *series, int n);
/* orbits.c: the watch of a trace that fills *orbits, which is all zero; none is kept of another method
 * than harmonic balance, and of motions of several periods. Release with hawser__orbits_clear. */
struct hawser__trace_watch hawser__orbits_watch(struct hawser__orbits *orbits);
void hawser__orbits_clear(struct hawser__orbits *orbits);
/* orbits.c: the orbits of the curve in the opposite direction, from the first one that has reached
 * Omega = `from`; *orbits is cleared. NULL: there are none, or no memory. */
struct hawser__orbits *hawser__orbits_back(struct hawser__orbits *orbits, double from);
void hawser__orbits_free(struct hawser__orbits *orbits);
/* orbits.c: the control of the steps of a trace. */
const struct hawser__step_settings *hawser__known_settings(const struct hawser_rom *rom,
                                                           const struct hawser__trace_watch *watch);
/* orbits.c: the first known orbit, if the trace begins at its Omega, *found, becomes that of `here`. */
enum hawser_status hawser__known_first(struct hawser__trace *trace, int *found);
/* orbits.c: the length of the next step, which ends at a known orbit if one is near enough; and whether
 * a step of this length does, whose orbit is then that of next. */
void hawser__known_aim(struct hawser__trace *trace);
int hawser__known_ahead(struct hawser__trace *trace, double ds);
/* orbits.c: which of the two directions of the tangent at the end of such a step is that of the curve:
 * the known one, as it may turn by more than a right angle; otherwise that at its beginning. */
const double *hawser__known_side(const struct hawser__trace *trace, double ds);

/* slack.c: replace next by the point where the least tension, `from` >= 0 at here and `to` < 0 at next
 * (N), is zero; its event, but for `after`. */
enum hawser_status hawser__trace_slacken(struct hawser__trace *trace, double from, double to,
                                         struct hawser_frf_event *event);

/* detour.c: the ways to a first orbit that pass other orbits. */
enum { HAWSER__WAYS = 2 };
struct hawser__raised;
/* Follow way `way`, given how far the load could be raised. *found: 1: x [m] is the state of an
 * orbit where the trace begins; 0: `tried` says what became of it. */
enum hawser_status hawser__detour(double *x, int *found, char tried[80], struct hawser__trace *trace,
                                  int way, const struct hawser__raised *raised);

/* cycle/begin.c: the method for equilibria or, with options.omega, for cycles; u [n]: the equilibrium
 * at the parameter `begin`; the first cycle, in `here`, which is judged. */
enum hawser_status hawser__own_open(struct hawser__trace *trace, struct hawser_report *report);
enum hawser_status hawser__own_equilibrium(struct hawser__trace *trace, double *u);
enum hawser_status hawser__own_cycle(struct hawser__trace *trace, double side);
/* cycle/begin.c: whether cycles end at `here`. */
enum hawser_status hawser__own_ends(struct hawser__trace *trace, int *ended);
/* cycle/begin.c: an event of an equilibrium, of the state [m], becomes a Hopf point if it is one.
 * *together: 1: several pairs cross the axis there; all of the step's events are recorded then. */
enum hawser_status hawser__trace_hopf(struct hawser__trace *trace, struct hawser_frf_event *event,
                                      const double *state, int *together);

/* frf_begin.c: the first orbit, which is recorded. */
enum hawser_status hawser__trace_begin(struct hawser__trace *trace);

/* frf_check.c: HAWSER_ERR_ARGUMENT: the range, another option, or a model without forcing;
 * HAWSER_ERR_NAN. */
enum hawser_status hawser__frf_check(const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     struct hawser_report *report);

/* step.c: move next to the point at which the branch between here and next has Omega = bound. */
enum hawser_status hawser__trace_cut(struct hawser__trace *trace, double bound);

#endif

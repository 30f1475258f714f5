/* response/trace.h - the state of a continuation, and what its files do for each other.
 *
 * frf.c opens, follows and closes the branch; step.c has the operations of a step
 * (continuation/curve.h); judge.c says whether a step may be kept; closure.c finds
 * closed curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_TRACE_H
#define HAWSER_RESPONSE_TRACE_H

#include <complex.h>

#include "continuation/curve.h"
#include "response/account.h"
#include "response/flow.h"
#include "response/record.h"
#include "response/station.h"
#include "response/vanish.h"

/* Who wants to see the orbits of located events, y [size] in the method's unknowns. An event may be
 * located again when its step is repeated. */
struct hawser__trace_watch {
	void (*event)(void *context, const struct hawser_frf_event *event,
	              const struct hawser__orbit *orbit, const double *y);
	void *context;
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
	int retries;                    /* of this step, for events that did not explain the count */
	double *direction;      /* [size] */
	double complex *pairs;  /* [5 m/2] work space of hawser__collide */
	double *start_y;        /* [size] first point, to notice a closed curve */
	double *mark_y, *mark_t; /* [size] a later point and its tangent, to notice a jump */
	int marked;             /* index of that point, 0: none yet */
	int jumped;             /* the curve passed that point again */
	struct hawser__curve curve;
	double lo, hi;
	double began;           /* s, hawser__wall_seconds */
	int enriched;           /* a finer discretisation was taken in this step already */
	struct hawser__shrinking shrinking;
	int known; /* stations of the branch behind and at `here` */
	struct hawser_report *report;
};

static inline double hawser__trace_omega(const struct hawser__trace *trace,
                                         const struct hawser__station *station)
{
	return station->y[trace->orbit->size - 1];
}

/* frf.c: hawser_frf_trace for one who watches (or NULL). */
enum hawser_status hawser__frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     const struct hawser__trace_watch *watch,
                                     struct hawser_report *report);

/* frf.c: whether the caller's progress function ends the trace. */
int hawser__trace_told_to_stop(const struct hawser__trace *trace);

/* step.c: correct station->y in the plane of `row`, in as fine a discretisation as it needs. *failed
 * is 1 when the corrector fails. */
enum hawser_status hawser__trace_correct(struct hawser__trace *trace,
                                         struct hawser__station *station, const double *row,
                                         int *failed);

/* step.c: HAWSER_ERR_CONVERGENCE where a corrected orbit is determined no better than to 5 % of its
 * size. */
enum hawser_status hawser__trace_determined(const struct hawser__trace *trace,
                                            const struct hawser__station *station);

/* judge.c: whether next is surely on the same branch as here, and whether what happens in between
 * is clear; angle is between the two tangents. */
int hawser__trace_trusted(const struct hawser__trace *trace, double angle);
int hawser__trace_hides(const struct hawser__trace *trace);

/* judge.c: whether the branch ends at rest, which is recorded then. */
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

/* closure.c: whether the curve passes its first point between here and next, and at which share of the
 * step; next is made that point by close. */
int hawser__trace_closed(const struct hawser__trace *trace, double *share);
enum hawser_status hawser__trace_close(struct hawser__trace *trace, double share);
/* closure.c: whether the curve passes another of its points again, which is a jump to another curve;
 * the failure that says so; and the note of the present point for that test. */
int hawser__trace_came_back(const struct hawser__trace *trace);
enum hawser_status hawser__trace_jumped(struct hawser__trace *trace);
void hawser__trace_mark(struct hawser__trace *trace);

/* step.c: replace next by the point where the branch between here and next meets Omega = bound. */
enum hawser_status hawser__trace_cut(struct hawser__trace *trace, double bound);

#endif

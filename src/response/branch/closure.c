/* response/branch/closure.c - detection of closed curves, of branches that meet another one, and of
 * steps that jumped to another curve or turned round.
 *
 * A branch that begins at a period doubling or a pitchfork is symmetric: the motion shifted by a
 * period of the load, or reflected, is a motion of the branch too. Where the branch meets that of
 * the symmetric motions again, it passes to these images and goes back on them, through each event
 * a second time. Its Omega turns there, so that a fold and a branch point are at one place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/trace.h"

#define FEWEST_CLOSED 10 /* least number of points of a closed curve; chosen */
#define FIRST_MARK 16    /* point at which a jump is looked for first; a power of two; chosen */
#define ALIKE 0.5        /* least cosine of the angle between tangents of the same direction;
                          * chosen */
#define SHY 1e-3 /* distance of the last point of a branch from the one that it meets, relative to the
                  * step: there the corrector is singular; chosen */
#define CLOSE 0.02       /* largest distance, in steps, at which a closed curve passes its first
                          * point; chosen */

/* Whether the curve passes `goal` [size] between here and next, and at which fraction of the step. */
static int passes(const struct hawser__trace *trace, const double *goal, double *share)
{
	const struct hawser__node here = hawser__station_node(&trace->here);
	const struct hawser__node next = hawser__station_node(&trace->next);
	const struct hawser__metric metric = hawser__orbit_metric(trace->orbit);

	return hawser__curve_passes(share, goal, &here, &next, trace->next.arc - trace->here.arc, CLOSE,
	                            trace->scratch.y, trace->direction, &metric);
}

/* The same in the direction of the tangent t [size] at that point; side -1: in the opposite one. */
static int passes_along(const struct hawser__trace *trace, const double *goal, const double *t,
                        double side, double *share)
{
	return side*hawser__orbit_dot(trace->orbit, t, trace->here.t) > ALIKE &&
	       passes(trace, goal, share);
}

/* The curve is closed if it passes its first point. */
int hawser__trace_closed(const struct hawser__trace *trace, double *share)
{
	return trace->frf->points >= FEWEST_CLOSED &&
	       passes_along(trace, trace->start_y, trace->start_t, 1.0, share);
}

/* A curve cannot return to a point other than its first one. If it does, a step has jumped from it
 * to a closed curve nearby. The point for the comparison is the last one whose index is a power of
 * two, so that finally one on the closed curve is used (R. Brent, BIT 20 (1980) 176). Nor can it pass
 * any point backwards, not even the first. If it does, it has turned round, as where a step turns by
 * more than a right angle, beyond which the direction of a tangent is that of the way back. */
int hawser__trace_came_back(const struct hawser__trace *trace)
{
	double share;

	return passes_along(trace, trace->start_y, trace->start_t, -1.0, &share) ||
	       (trace->marked &&
	        (passes_along(trace, trace->mark_y, trace->mark_t, -1.0, &share) ||
	         (trace->frf->points >= trace->marked + FEWEST_CLOSED &&
	          passes_along(trace, trace->mark_y, trace->mark_t, 1.0, &share))));
}

void hawser__trace_mark(struct hawser__trace *trace)
{
	int points = trace->frf->points;
	size_t bytes = (size_t)trace->orbit->size*sizeof(double);

	if (points < FIRST_MARK || points & (points - 1))
		return;
	memcpy(trace->mark_y, trace->here.y, bytes);
	memcpy(trace->mark_t, trace->here.t, bytes);
	trace->marked = points;
}

enum hawser_status hawser__trace_jumped(struct hawser__trace *trace)
{
	double at = hawser__trace_parameter(trace, &trace->here);

	trace->jumped = 1;
	return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                       trace->frf->points, trace->here.correction.residual,
	                       "the curve came back to an orbit that it had passed, at %s: a step has "
	                       "jumped to another branch or back; take shorter steps (--step)",
	                       hawser__orbit_where(trace->orbit, at).text);
}

/* Let the last step end at the first point, so that the events up to it are located, but none
 * beyond. */
enum hawser_status hawser__trace_close(struct hawser__trace *trace, double share)
{
	int size = trace->orbit->size, failed;
	enum hawser_status status;

	trace->next.arc = trace->here.arc + share*(trace->next.arc - trace->here.arc);
	memcpy(trace->next.y, trace->start_y, (size_t)size*sizeof(double));
	memcpy(trace->direction, trace->here.t, (size_t)size*sizeof(double));
	if ((status = hawser__trace_correct(trace, &trace->next, trace->direction, &failed)))
		return status;
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->next.correction.iterations,
		                       trace->next.correction.residual,
		                       "the corrector failed where the curve closes, at %s",
		                       hawser__orbit_where(trace->orbit, trace->options.begin).text);
	return hawser__station_finish(&trace->next, trace->orbit, trace->here.t,
	                              trace->report);
}

/* Whether Omega turns at this branch point, as far as the points beside it tell: those before and
 * behind its step too, where the two tests change their signs at a station that is nearly the
 * branch point. A fold beside it would be an event of its own. */
static int turns_at(const struct hawser_frf *frf, const struct hawser_frf_event *at)
{
	int from = at->after > 0 ? at->after - 1 : 0, last = frf->points - 1, folds = 0;

	for (int e = frf->events - 1; e >= 0 && frf->event[e].after >= from; e--)
		folds += frf->event[e].kind == HAWSER_FOLD;
	return (frf->point[from].direction != frf->point[last].direction) != folds%2;
}

/* Index of a branch point of the last two steps where Omega turns, or -1. */
static int turning_point(const struct hawser_frf *frf)
{
	for (int e = frf->events - 1; e >= 0 && frf->event[e].after >= frf->points - 3; e--)
		if (frf->event[e].kind == HAWSER_BRANCH_POINT && frf->event[e].located &&
		    turns_at(frf, &frf->event[e]))
			return e;
	return -1;
}

/* Beside the point where a branch meets another one, test functions, multipliers and the corrector are
 * round-off: steps become short, and what they find in one of them may explain nothing. Both tests
 * have changed their signs behind it, while Omega, which turns there, is still the same. */
static enum hawser_status level_point(int *e, struct hawser__trace *trace)
{
	struct hawser_frf *frf = trace->frf;
	struct hawser__orbit *orbit = trace->orbit;
	const struct hawser__test *test = trace->here.test;
	double omega = trace->here.y[orbit->size - 1], tolerance = trace->options.event_tolerance;
	struct hawser_frf_event event = {.kind = HAWSER_BRANCH_POINT, .turns = 1, .located = 1,
		.arc = trace->here.arc,
		.omega = orbit->own == HAWSER__RESTS ? 0.0 : hawser__orbit_omega(orbit, trace->here.y),
		.parameter = omega, .bracket = {omega, trace->level.omega},
		.error = tolerance + trace->here.mesh, .after = trace->level.point};
	enum hawser_status status;

	if (trace->level.sign[0] == 0.0 || trace->level.point >= frf->points - 1 || /* stepped back */
	    !(fabs(omega - trace->level.omega) <= tolerance*hawser__orbit_extent(orbit, trace->here.y))) {
		trace->level.omega = omega;
		trace->level.sign[0] = test[HAWSER_FOLD].sign;
		trace->level.sign[1] = test[HAWSER_BRANCH_POINT].sign;
		trace->level.point = frf->points - 1;
	}
	if (!(trace->level.sign[0]*test[HAWSER_FOLD].sign < 0.0 &&
	      trace->level.sign[1]*test[HAWSER_BRANCH_POINT].sign < 0.0))
		return HAWSER_OK;
	while (frf->events > 0 && frf->event[frf->events - 1].after >= trace->level.point)
		frf->events--;
	frf->points = trace->level.point + 2;
	orbit->ops->state(orbit, orbit->step, trace->here.y);
	event.unstable[0] = event.unstable[1] = frf->point[trace->level.point].unstable;
	status = hawser__record_event(frf, &event, orbit->step, orbit->rom, trace->report);
	*e = frf->events - 1;
	return status;
}

/* The last point is one shortly before the event; if there is none, the one before. */
enum hawser_status hawser__trace_meet(struct hawser__trace *trace, int *met)
{
	struct hawser_frf *frf = trace->frf;
	struct hawser__orbit *orbit = trace->orbit;
	int e = trace->options.along ? turning_point(frf) : -1, of_last;
	double share;
	enum hawser_status status;

	if (trace->options.along && e < 0 && (status = level_point(&e, trace)))
		return status;
	*met = e >= 0;
	if (!*met)
		return HAWSER_OK;
	of_last = frf->event[e].after == frf->points - 2;
	frf->end = HAWSER_END_MEETS;
	frf->events = e + 1;
	frf->points = frf->event[e].after + 1;
	share = (frf->event[e].arc - trace->prev.arc)/(trace->here.arc - trace->prev.arc) - SHY;
	trace->scratch.arc = trace->prev.arc + share*(trace->here.arc - trace->prev.arc);
	if (of_last && share > SHY &&
	    !hawser__station_inside(&trace->scratch, orbit, &trace->prev, &trace->here, share,
	                            trace->options.tolerance)) {
		if ((status = hawser__station_finish(&trace->scratch, orbit, trace->prev.t, trace->report)) ||
		    (status = hawser__record_point(frf, trace->amplitude, &trace->scratch, orbit,
		                                   trace->report)))
			return status;
	}
	frf->event[e].after = frf->points - 1;
	return HAWSER_OK;
}

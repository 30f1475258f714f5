/* response/closure.c - detection of closed curves, and of steps that jumped to another curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "core/report.h"
#include "response/trace.h"

#define FEWEST_CLOSED 10 /* least number of points of a closed curve; chosen */
#define FIRST_MARK 16    /* point at which a jump is looked for first; a power of two; chosen */
#define ALIKE 0.5        /* least cosine of the angle between tangents of the same direction;
                          * chosen */
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

/* The curve is closed if it passes its first point. */
int hawser__trace_closed(const struct hawser__trace *trace, double *share)
{
	return trace->frf->points >= FEWEST_CLOSED && passes(trace, trace->start_y, share);
}

/* A curve cannot return to a point other than its first one. If it does, a step has jumped from it
 * to a closed curve nearby. The point for the comparison is the last one whose index is a power of
 * two, so that finally one on the closed curve is used (R. Brent, BIT 20 (1980) 176). */
int hawser__trace_came_back(const struct hawser__trace *trace)
{
	double share;

	return trace->marked && trace->frf->points >= trace->marked + FEWEST_CLOSED &&
	       hawser__orbit_dot(trace->orbit, trace->mark_t, trace->here.t) > ALIKE &&
	       passes(trace, trace->mark_y, &share);
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
	                       "the curve came back to an orbit that is not its first one, at %s: "
	                       "a step has jumped to another branch; take shorter steps (--step)",
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

/* response/branch/crossing.c - see crossing.h.
 *
 * Multipliers of an undamped model are on the unit circle all along the curve, and are outside only
 * where they have collided. There a sure test, which shows where one is certainly outside, is all that
 * can be had. With damping a multiplier passes from certainly inside to certainly outside. Where the
 * stations are near to each other, both lie within its error, and the place where it becomes certain
 * would be taken for the event, the farther from it, the smaller the steps are. The curve is therefore
 * followed from the end of the step at which the multiplier is undecided, in steps of double length,
 * until it is certainly inside. The test function itself changes its sign in between, and its zero is
 * located as that of any other event.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/branch/crossing.h"
#include "response/branch/locate.h"
#include "response/branch/trace.h"

/* Arclength of the first step at least; the last one is 2^8 times as long, 0.26, which is a long
 * step of a branch (step.c). Chosen. */
#define FIRST 1e-3

void hawser__crossing_clear(struct hawser__crossing *crossing)
{
	for (int i = 0; i < HAWSER__CROSSING; i++)
		hawser__station_clear(&crossing->walk[i]);
	hawser__station_clear(&crossing->scratch);
}

/* Number of multipliers that are not outside, and are not undecided. */
static int inside(const struct hawser__station *station, int m)
{
	return m - station->circle.unstable - station->circle.undecided;
}

/* The next station of a walk with the curve (way 1) or against it (-1): `step` beyond `last`, which
 * comes after `before`. *failed: 1: it is not certainly on the same curve. */
static enum hawser_status walk_on(struct hawser__station *next, int *failed,
                                  struct hawser__orbit *orbit, const struct hawser__station *before,
                                  const struct hawser__station *last, int way, double step,
                                  double tolerance, struct hawser_report *report)
{
	const struct hawser__station *first = way > 0 ? before : last, *end = way > 0 ? last : before;
	const struct hawser__node node[2] = {hawser__station_node(first), hawser__station_node(end)};
	const struct hawser__metric metric = hawser__orbit_metric(orbit);
	enum hawser_status status = next->memory ? HAWSER_OK : hawser__station_init(next, orbit, report);

	if (status)
		return status;
	next->arc = last->arc + way*step;
	hawser__curve_ahead(next->y, node, 2, next->arc - end->arc, &metric);
	*failed = hawser__orbit_correct(orbit, next->y, &next->correction, last->t, tolerance);
	if (*failed)
		return HAWSER_OK;
	hawser__station_turn(next, orbit, last->t, NULL);
	*failed = !hawser__trace_trusted(&next->correction,
	                                 hawser__metric_angle(&metric, last->t, next->t));
	status = *failed ? HAWSER_OK : hawser__station_judge(next, orbit, report);
	*failed |= status == HAWSER_ERR_CONVERGENCE;
	return status == HAWSER_ERR_CONVERGENCE ? HAWSER_OK : status;
}

/* Two neighbouring stations, in the order of the curve, between which the test changes its sign. */
struct pair {
	const struct hawser__station *a, *b;
	int count; /* of such pairs */
};

static void look(struct pair *pair, const struct hawser__station *from,
                 const struct hawser__station *to, int way, enum hawser_event_kind kind)
{
	const struct hawser__station *a = way > 0 ? from : to, *b = way > 0 ? to : from;

	if (!hawser__station_crossed(a, b, kind, 0))
		return;
	pair->a = a;
	pair->b = b;
	pair->count++;
}

/* Follow the curve to the station at which the multiplier is certainly inside, *end; NULL: there
 * is none. `out` and `edge` are the ends of the step. */
static enum hawser_status follow(struct hawser__crossing *crossing, struct pair *pair,
                                 const struct hawser__station **end, struct hawser__orbit *orbit,
                                 const struct hawser__station *out,
                                 const struct hawser__station *edge, int way,
                                 enum hawser_event_kind kind, double tolerance,
                                 struct hawser_report *report)
{
	const struct hawser__station *before = out, *last = edge;
	int goal = inside(out, orbit->m) + hawser__event_width(kind);
	double first = fmax(fabs(edge->arc - out->arc), FIRST);

	*end = NULL;
	look(pair, out, edge, way, kind);
	for (int i = 0; inside(last, orbit->m) < goal; i++) {
		struct hawser__station *next = &crossing->walk[i];
		int failed = 1;
		enum hawser_status status = HAWSER_OK;

		if (i < HAWSER__CROSSING)
			status = walk_on(next, &failed, orbit, before, last, way, ldexp(first, i), tolerance,
			                 report);
		if (status || failed || next->circle.unstable != edge->circle.unstable)
			return status;
		look(pair, last, next, way, kind);
		before = last;
		last = next;
	}
	*end = last;
	return HAWSER_OK;
}

enum hawser_status hawser__crossing_find(struct hawser__crossing *crossing,
                                         struct hawser_frf_event *event, int *found,
                                         struct hawser__orbit *orbit,
                                         const struct hawser__station *a,
                                         const struct hawser__station *b, double orbit_tolerance,
                                         double tolerance, struct hawser_report *report)
{
	int way = b->circle.unstable > a->circle.unstable ? -1 : 1, last = orbit->size - 1;
	const struct hawser__station *out = way < 0 ? b : a, *edge = way < 0 ? a : b, *end;
	struct pair pair = {NULL, NULL, 0};
	struct hawser_frf_event crossed;
	enum hawser_status status;

	*found = 0;
	if (abs(a->circle.unstable - b->circle.unstable) != hawser__event_width(event->kind))
		return HAWSER_OK;
	status = follow(crossing, &pair, &end, orbit, out, edge, way, event->kind, orbit_tolerance, report);
	if (!status && !crossing->scratch.memory)
		status = hawser__station_init(&crossing->scratch, orbit, report);
	if (status || !end || pair.count != 1)
		return status;
	status = hawser__locate(&crossed, found, orbit, &crossing->scratch, pair.a, pair.b, event->kind,
	                        0, orbit_tolerance, tolerance, report);
	if (status == HAWSER_ERR_CONVERGENCE)
		*found = 0;
	if (*found) {
		crossed.bracket[way < 0] = out->y[last];
		crossed.bracket[way > 0] = end->y[last];
		crossed.unstable[way < 0] = out->circle.unstable;
		crossed.unstable[way > 0] = end->circle.unstable;
		*event = crossed;
	}
	return status == HAWSER_ERR_CONVERGENCE ? HAWSER_OK : status;
}

/* ropeway/statics/ahead.c - which sheaves the rope presses, and how far it is from the others.
 *
 * From a point of departure, the places on its path from which the rope passes above all
 * support sheaves and below all compression sheaves so far are an interval [near, far]. Each
 * further sheave shortens it. When it would be empty, or end B is not in it, the rope touches
 * the sheave that sets the bound in the way: this is the next one. (For a weightless rope it is
 * the funnel algorithm for shortest paths of Lee and Preparata, Networks 14, 1984.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>

#include <math.h>
#include <stddef.h>

#include "ropeway/statics/line.h"

/* A place on the path, and the sheave that sets it (-1: none). */
struct place {
	int segment;
	double q;
	int sheave;
};

static int before(const struct place *a, const struct place *b)
{
	return a->segment < b->segment || (a->segment == b->segment && a->q < b->q);
}

static struct place place_of(const struct hawser__march *march, const struct hawser__path *path, int to)
{
	struct hawser__path copy = *path;
	struct hawser__meet meet;
	struct place place = {.segment = -1, .sheave = to};
	enum hawser__search found = hawser__path_find(&copy, &place.q, &meet, NULL, &march->target[to], 0);

	place.segment = found == HAWSER__MET ? copy.count : found == HAWSER__TOO_LOW ? INT_MAX : -1;
	if (found)
		place.q = 0.0;
	return place;
}

/* The next sheave that the rope presses behind the path's; their number: end B; -1: the tension
 * is too low for *blocked; -2: not found. */
static int next_of(int *blocked, const struct hawser__march *march, const struct hawser__path *path)
{
	struct place near = {.segment = -1, .q = -INFINITY, .sheave = -2};
	struct place far = {.segment = INT_MAX, .q = INFINITY, .sheave = -1};

	for (int to = path->from.index + 1; to <= march->sheaves; to++) {
		struct place at = place_of(march, path, to);
		int last = to == march->sheaves, beyond = last || path->lowers*march->target[to].side > 0;

		*blocked = to;
		if ((last || !beyond) && before(&far, &at))
			return far.sheave;
		if ((last || !beyond) && at.segment == INT_MAX && far.sheave < 0)
			return -1;
		if (beyond && before(&at, &near))
			return near.sheave;
		if (beyond && at.segment < 0)
			return near.sheave;
		if (beyond && before(&at, &far))
			far = at;
		if (!beyond && before(&near, &at) && at.segment >= 0)
			near = at;
	}
	return march->sheaves;
}

int hawser__march_ahead(struct hawser__march *march, double P)
{
	struct hawser__path path;
	int n = march->sheaves, at = -1;

	hawser__path_open(&path, &march->rope, march->A, P);
	for (int k = 0; k < n; k++)
		march->off[k] = 1;
	march->fault = HAWSER__NO_FAULT;
	while (at < n) {
		struct hawser__meet meet;
		double q;
		int blocked = n, next = next_of(&blocked, march, &path);

		if (next < 0) {
			march->fault = next == -1 ? HAWSER__FAULT_TOO_LOW : HAWSER__FAULT_LOST;
			march->from = at;
			march->to = blocked;
			return 0;
		}
		at = next;
		if (at == n)
			break;
		march->off[at] = 0;
		if (hawser__path_find(&path, &q, &meet, NULL, &march->target[at], 0)) {
			march->fault = HAWSER__FAULT_LOST;
			return 0;
		}
		hawser__path_arrive(&path, &march->rope, &march->target[at], &meet);
	}
	return hawser__march(march, P);
}

int hawser__march_clearances(struct hawser__march *march)
{
	const struct hawser__rope_point *from = &march->begin, *to;
	int worst = -1;

	for (int k = 0; k < march->sheaves; k++) {
		struct hawser_line_contact *contact = &march->trace.st->contact[k];
		const struct hawser__target *target = &march->target[k];
		struct hawser__meet meet;
		double far;
		int next = k;

		if (!march->off[k]) {
			from = &march->trace.leave[k];
			continue;
		}
		while (next < march->sheaves && march->off[next])
			next++;
		to = next < march->sheaves ? &march->trace.arrive[next] : &march->end;
		hawser__meet(&meet, &march->rope, from, target->c, target->side < 0 ? 0.1 : 2.0, INFINITY, 0);
		far = meet.distance;
		if (meet.found && meet.at.S > to->S)
			far = copysign(hypot(to->x[0] - target->c[0], to->x[1] - target->c[1]), far);
		*contact = (struct hawser_line_contact){.clearance = target->side*far - target->R};
		if (worst < 0 && contact->clearance < -1e-9*(target->R + fabs(target->c[0]) +
		                                             fabs(target->c[1])))
			worst = k;
	}
	return worst;
}

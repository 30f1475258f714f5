/* ropeway/statics/march.c - the rope laid from end A, where its tension is known, over its sheaves to
 * end B.
 *
 * One scalar problem a sheave: the place on the path of the last sheave (path.c) from which the
 * rope meets the next. Nothing has to be guessed, and an error does not grow from span to span,
 * since each is closed exactly.
 *
 * A sheave that is not pressed shows at the begin of its path: without its force the rope would
 * already pass beyond the next target. Between sheaves of the same side (and before B, which is
 * fixed) it is then the one without contact: it is taken out, and the search returns to the
 * sheave before, as in the scan for a convex hull. Between a support and a compression sheave
 * either may be the one without contact; hawser__march_ahead() decides.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

/* One span: from the path of the last sheave to the target; the path of the next begins there. */
static enum hawser__search span(struct hawser__march *march, struct hawser__path *path, int to)
{
	struct hawser__rope_point leave;
	struct hawser__meet meet;
	double q, change[2];
	int from = path->from.index;
	const struct hawser__target *target = &march->target[to];
	enum hawser__search found = hawser__path_find(path, &q, &meet, &march->trace, target,
	                                              march->slack_behind == from);

	if (found)
		return found;
	hawser__path_at(&leave, change, path, q);
	if (path->kind == HAWSER__ARC)
		hawser__trace_arc(&march->trace, path, q);
	else if (path->kind == HAWSER__MASS)
		hawser__trace_mass(&march->trace, path, q);
	if (from >= 0)
		hawser__trace_leave(&march->trace, from, &leave);
	else
		march->begin = leave;
	hawser__trace_free(&march->trace, &march->rope, &leave, &meet.at);
	if (to < march->sheaves) {
		hawser__trace_arrive(&march->trace, to, &meet);
		hawser__path_arrive(path, &march->rope, target, &meet);
		return HAWSER__MET;
	}
	march->end = meet.at;
	march->miss = hypot(meet.at.x[0] - target->c[0], meet.at.x[1] - target->c[1]);
	return HAWSER__MET;
}

static int fault(struct hawser__march *march, enum hawser__fault kind, int from, int to)
{
	march->fault = kind;
	march->from = from;
	march->to = to;
	return 0;
}

static void save(struct hawser__march *march, const struct hawser__path *path, int depth)
{
	march->start[depth] = *path;
	march->index[depth] = path->from.index;
	march->pieces[depth] = march->trace.st->pieces;
	march->pending[depth] = march->trace.pending;
}

static void restore(struct hawser__march *march, struct hawser__path *path, int depth)
{
	*path = march->start[depth];
	march->trace.st->pieces = march->pieces[depth];
	march->trace.pending = march->pending[depth];
	if (path->from.index >= 0)
		march->trace.st->contact[path->from.index].wrap = 0.0;
}

int hawser__march(struct hawser__march *march, double P)
{
	struct hawser__path path;
	int depth = 0, n = march->sheaves, to = 0;

	march->fault = HAWSER__NO_FAULT;
	march->iterations++;
	march->trace.st->pieces = 0;
	march->trace.pending = -1;
	hawser__path_open(&path, &march->rope, march->A, P);
	save(march, &path, 0);
	while (to <= n) {
		int from = path.from.index;
		enum hawser__search found;

		if (to < n && march->off[to]) {
			to++;
			continue;
		}
		found = span(march, &path, to);
		if (found == HAWSER__MET) {
			if (to < n)
				save(march, &path, ++depth);
			to++;
			continue;
		}
		if (found == HAWSER__TOO_LOW && (to == n || march->target[to].side < 0))
			return fault(march, HAWSER__FAULT_TOO_LOW, from, to);
		if (found == HAWSER__TOO_LOW) {
			march->off[to++] = 1;
		} else if (to == n || march->target[to].side == march->target[from].side) {
			march->off[from] = 1;
			depth--;
		} else {
			return fault(march, HAWSER__FAULT_LOST, from, to);
		}
		restore(march, &path, depth);
	}
	return 1;
}

enum hawser_status hawser__march_open(struct hawser__march *march, struct hawser_line_statics *st,
                                      const struct hawser_line *line, struct hawser_report *report)
{
	size_t n = (size_t)line->sheaves + 1, m = (size_t)line->masses + 1;
	double share = line->rho*line->speed*line->speed/line->EA;

	memset(march, 0, sizeof *march);
	march->line = line;
	march->A = line->A;
	march->sheaves = line->sheaves;
	march->slack_behind = -2;
	march->rope.EA = line->EA;
	march->rope.stretch = 1.0/(1.0 - share);
	march->rope.thrust = line->rho*line->speed*line->speed;
	march->rope.w = line->rho*line->g*(1.0 - share);
	march->rope.masses = line->masses;
	march->trace.room = 3*(int)(n + m) + 8;
	march->target = hawser__hold(&march->hold, n, sizeof *march->target);
	march->start = hawser__hold(&march->hold, n, sizeof *march->start);
	march->index = hawser__hold(&march->hold, 3*n, sizeof *march->index);
	march->off = hawser__hold(&march->hold, 2*n, 1);
	march->rope.S = hawser__hold(&march->hold, 3*m, sizeof *march->rope.S);
	march->trace.arrive = hawser__hold(&march->hold, 2*n, sizeof *march->trace.arrive);
	march->trace.st = st;
	st->piece = calloc((size_t)march->trace.room, sizeof *st->piece);
	st->contact = calloc(n, sizeof *st->contact);
	st->carrier = calloc(m, sizeof *st->carrier);
	if (march->hold.short_of_memory || !st->piece || !st->contact || !st->carrier)
		return hawser__no_memory(report, "line");
	march->kept = march->off + n;
	march->pieces = march->index + n;
	march->pending = march->pieces + n;
	march->trace.leave = march->trace.arrive + n;
	march->rope.weight = march->rope.S + m;
	march->trace.tangent = march->rope.weight + m;
	for (int i = 0; i < line->masses; i++) {
		march->rope.S[i] = line->mass[i].S*march->rope.stretch;
		march->rope.weight[i] = line->mass[i].mass*line->g;
	}
	for (int i = 0; i < line->sheaves; i++) {
		const struct hawser_line_sheave *sheave = &line->sheave[i];

		march->target[i] = (struct hawser__target){{sheave->centre[0], sheave->centre[1]},
		                                           sheave->radius, hawser__line_grip(line, i),
		                                           sheave->side, i};
	}
	march->target[line->sheaves] = (struct hawser__target){{line->B[0], line->B[1]}, 0.0, 0.0, 1,
	                                                       line->sheaves};
	return HAWSER_OK;
}

void hawser__march_clear(struct hawser__march *march)
{
	hawser__hold_clear(&march->hold);
}

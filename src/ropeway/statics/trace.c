/* ropeway/statics/trace.c - the rope as it is laid from A to B: pieces, contacts, carriers.
 *
 * All of it is of the rope at rest (rope.h); solution.c converts it at the end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "ropeway/statics/rope.h"

static double size(const double P[2])
{
	return hypot(P[0], P[1]);
}

static double slope(const double P[2])
{
	return atan2(P[1], P[0]);
}

static void add(struct hawser__rope_trace *trace, const struct hawser_line_piece *piece)
{
	struct hawser_line_statics *st = trace->st;

	if (!(piece->S1 > piece->S0) || st->pieces >= trace->room)
		return;
	st->piece[st->pieces] = *piece;
	st->piece[st->pieces++].mass = trace->pending;
	trace->pending = -1;
}

static void smooth(struct hawser__rope_trace *trace, const struct hawser__rope_point *a,
                   const struct hawser__rope_point *b)
{
	struct hawser_line_piece piece = {.sheave = -1, .S0 = a->S, .S1 = b->S, .angle0 = slope(a->P),
	                                  .angle1 = slope(b->P), .T0 = size(a->P), .T1 = size(b->P)};

	memcpy(piece.x0, a->x, sizeof piece.x0);
	memcpy(piece.x1, b->x, sizeof piece.x1);
	add(trace, &piece);
}

void hawser__trace_free(struct hawser__rope_trace *trace, const struct hawser__rope *rope,
                        const struct hawser__rope_point *from, const struct hawser__rope_point *to)
{
	struct hawser__rope_point a = *from, b;

	if (!trace)
		return;
	while (a.mass < to->mass) {
		struct hawser_line_carrier *carrier = &trace->st->carrier[a.mass];

		b = a;
		hawser__fly(&b, NULL, rope, rope->S[a.mass]);
		smooth(trace, &a, &b);
		*carrier = (struct hawser_line_carrier){.present = 1, .sheave = -1, .T_before = size(b.P),
		                                        .angle_before = slope(b.P)};
		memcpy(carrier->x, b.x, sizeof carrier->x);
		trace->pending = b.mass;
		hawser__pass(&b, rope);
		carrier->T_after = size(b.P);
		carrier->angle_after = slope(b.P);
		a = b;
	}
	b = a;
	hawser__fly(&b, NULL, rope, to->S);
	smooth(trace, &a, &b);
}

void hawser__trace_arc(struct hawser__rope_trace *trace, const struct hawser__path *path, double q)
{
	struct hawser_line_piece piece = {.sheave = path->from.index, .S0 = path->at.S,
	                                  .angle0 = path->angle,
	                                  .angle1 = path->angle - path->arc.side*q, .T0 = path->arc.T0};
	struct hawser__rope_point at;
	double change[2];

	if (!trace)
		return;
	hawser__path_at(&at, change, path, q);
	piece.S1 = at.S;
	piece.T1 = size(at.P);
	memcpy(piece.x0, path->at.x, sizeof piece.x0);
	memcpy(piece.x1, at.x, sizeof piece.x1);
	trace->st->contact[path->from.index].wrap += q;
	add(trace, &piece);
}

void hawser__trace_mass(struct hawser__rope_trace *trace, const struct hawser__path *path,
                        double carried)
{
	struct hawser_line_carrier *carrier;
	struct hawser__rope_point at;
	double change[2], before[2];

	if (!trace)
		return;
	hawser__path_at(&at, change, path, carried);
	before[0] = path->at.P[0];
	before[1] = path->at.P[1] - path->rope->weight[path->at.mass];
	carrier = &trace->st->carrier[path->at.mass];
	*carrier = (struct hawser_line_carrier){
		.present = 1, .sheave = path->from.index,
		.state = path->count == 0 ? 1 : carried < path->end ? 3 : 2,
		.T_before = size(before), .angle_before = slope(before), .T_after = size(at.P),
		.angle_after = slope(at.P), .carried = carried
	};
	memcpy(carrier->x, path->at.x, sizeof carrier->x);
	trace->tangent[path->at.mass] = path->angle;
	trace->pending = path->at.mass;
}

void hawser__trace_arrive(struct hawser__rope_trace *trace, int sheave, const struct hawser__meet *meet)
{
	struct hawser_line_contact *contact = &trace->st->contact[sheave];

	*contact = (struct hawser_line_contact){.touches = 1, .T_in = size(meet->at.P),
	                                        .angle_in = slope(meet->at.P)};
	trace->arrive[sheave] = meet->at;
}

void hawser__trace_leave(struct hawser__rope_trace *trace, int sheave,
                         const struct hawser__rope_point *at)
{
	struct hawser_line_contact *contact = &trace->st->contact[sheave];

	contact->T_out = size(at->P);
	contact->angle_out = slope(at->P);
	trace->leave[sheave] = *at;
}

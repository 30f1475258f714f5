/* ropeway/modes/modes_pieces.c - the pieces of a rope over sheaves, scaled, and the joints between
 * them.
 *
 *   run      the free rope between two sheaves or ends, with the masses on it. Its horizontal tension
 *            is that at its beginning, and its vertical one is summed from there, so that differences
 *            of slopes within a run have no cancellation
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "ropeway/modes/modes.h"

/* A joint without arc and mass is at a sheave if it is as close to its circle as this part of the unit
 * of length. The statics closes to 1e-9 of it. */
static const double beside = 1e-6;

int hawser__lmode_carrier(const struct hawser__lmode *rope, int lane, int mass)
{
	for (int i = 0; i < lane; i++)
		mass += rope->lane[i]->line->masses;
	return mass;
}

double hawser__lmode_delta(const struct hawser__lmode *rope, int lane)
{
	const struct hawser_line *line = rope->lane[lane]->line;

	return line->rho*line->g*rope->length/rope->force;
}

double hawser__lmode_nu(const struct hawser__lmode *rope, int lane)
{
	double nu = rope->lane[lane]->line->speed*sqrt(rope->lane[lane]->line->rho/rope->force);

	return rope->options.backward[lane] ? -nu : nu;
}

static void place_piece(struct hawser__lmode_piece *to, const struct hawser__lmode *rope, int lane,
                        int i)
{
	const struct hawser_line_piece *from = &rope->lane[lane]->piece[i];
	double T = from->T0/rope->force, g = 1.0 + rope->epsilon*T, apparent = T - rope->nu*rope->nu*g;

	*to = (struct hawser__lmode_piece){
		.lane = lane, .piece = i, .sheave = from->sheave, .mass = from->mass, .run = -1,
		.s0 = from->S0/rope->length, .length = (from->S1 - from->S0)/rope->length,
		.delta = hawser__lmode_delta(rope, lane),
		.H = apparent*cos(from->angle0), .V = apparent*sin(from->angle0),
		.angle = {from->angle0, from->angle1}};
}

/* The run of pieces [count]: one horizontal tension, vertical ones from the first piece, and a
 * reference at the middle of its length. */
static void place_run(struct hawser__lmode_piece *piece, int count, int run,
                      const struct hawser__lmode *rope)
{
	double H = piece[0].H, V = piece[0].V, rise = 0.0, middle, at = 0.0;
	const struct hawser__lmode_piece *last = &piece[count - 1];

	middle = 0.5*(last->s0 + last->length - piece[0].s0);
	for (int i = 0; i < count; i++) { /* V - V(A) in `bent` first */
		double weight = i == 0 || piece[i].mass < 0 ? 0.0
			: rope->lane[piece[i].lane]->line->mass[piece[i].mass].mass*
			  rope->lane[piece[i].lane]->line->g/rope->force;

		rise += weight;
		piece[i].bent = rise;
		piece[i].run = run;
		piece[i].H = H;
		piece[i].V = V + rise;
		rise += piece[i].delta*piece[i].length;
	}
	rise = 0.0;
	for (int i = 0; i < count; i++, at += piece[i - 1].length)
		if (middle >= at)
			rise = piece[i].bent + piece[i].delta*fmin(middle - at, piece[i].length);
	for (int i = 0; i < count; i++) {
		piece[i].bent -= rise;
		piece[i].reference[0] = H;
		piece[i].reference[1] = V + rise;
	}
}

/* Of a joint without arc and mass: the sheave on whose circle it is. */
static int nearest_sheave(const struct hawser__lmode *rope, int lane, const double x[2])
{
	const struct hawser_line *line = rope->lane[lane]->line;
	double least = beside*rope->length;
	int found = -1;

	for (int i = 0; i < line->sheaves; i++) {
		double off = fabs(hypot(x[0] - line->sheave[i].centre[0], x[1] - line->sheave[i].centre[1]) -
		                  line->sheave[i].radius);

		if (rope->lane[lane]->contact[i].touches && off < least) {
			least = off;
			found = i;
		}
	}
	return found;
}

struct hawser__lmode_joint hawser__lmode_joint(const struct hawser__lmode *rope, int lane, int i)
{
	const struct hawser_line_statics *st = rope->lane[lane];
	const struct hawser_line_piece *before = &st->piece[i - 1], *behind = &st->piece[i];
	struct hawser__lmode_joint joint = {.sheave = before->sheave >= 0 ? before->sheave : behind->sheave,
	                      .mass = behind->mass, .tangent = {before->angle1, behind->angle0}};
	const struct hawser_line_sheave *sheave;

	if (joint.sheave < 0 && joint.mass >= 0 && st->carrier[joint.mass].state > 0)
		joint.sheave = st->carrier[joint.mass].sheave;
	if (joint.sheave < 0 && joint.mass < 0)
		joint.sheave = nearest_sheave(rope, lane, behind->x0);
	if (joint.sheave < 0)
		return joint;
	sheave = &st->line->sheave[joint.sheave];
	if (before->sheave >= 0)
		joint.tangent[1] = joint.tangent[0];
	else if (behind->sheave >= 0)
		joint.tangent[0] = joint.tangent[1];
	else if (sheave->radius > 0.0)
		joint.tangent[0] = joint.tangent[1] =
			atan2(-sheave->side*(behind->x0[0] - sheave->centre[0]),
			      sheave->side*(behind->x0[1] - sheave->centre[1]));
	return joint;
}

/* 1 if pieces i - 1 and i belong to one run. */
static int joined(const struct hawser__lmode *rope, int lane, int i)
{
	return hawser__lmode_joint(rope, lane, i).sheave < 0;
}

void hawser__lmode_pieces(struct hawser__lmode *rope)
{
	int at = 0;

	for (int lane = 0; lane < rope->lanes; lane++) {
		int count = rope->lane[lane]->pieces, first = -1;

		for (int i = 0; i < count; i++) {
			place_piece(&rope->piece[at + i], rope, lane, i);
			if (rope->piece[at + i].sheave >= 0)
				continue;
			if (first < 0 || rope->piece[at + i - 1].sheave >= 0 || !joined(rope, lane, i))
				first = i;
			if (i + 1 == count || rope->piece[at + i].sheave >= 0 || !joined(rope, lane, i + 1))
				place_run(&rope->piece[at + first], i + 1 - first, rope->runs++, rope);
		}
		at += count;
	}
}

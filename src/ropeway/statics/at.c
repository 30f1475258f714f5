/* ropeway/statics/at.c - the state of a solved line at S.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "ropeway/statics/line.h"

/* The piece that begins at S or contains it. */
static const struct hawser_line_piece *piece_of(const struct hawser_line_statics *st, double S)
{
	int low = 0, high = st->pieces - 1;

	while (low < high) {
		int mid = (low + high + 1)/2;

		if (st->piece[mid].S0 <= S)
			low = mid;
		else
			high = mid - 1;
	}
	return &st->piece[low];
}

/* Angle of contact of the length S from the arc's beginning. */
static double angle_of(double *P, const struct hawser__arc *arc, const struct hawser__rope *rope,
                       double S,
                       double most)
{
	double q = fmin(S*(1.0 + arc->T0/rope->EA)/arc->R, most), at;

	for (int i = 0; i < 50; i++) {
		double next;

		hawser__arc_at(P, &at, arc, rope, q);
		next = fmax(0.0, fmin(most, q + (S - at)*(1.0 + *P/rope->EA)/arc->R));
		if (fabs(next - q) <= 1e-15*(1.0 + q))
			break;
		q = next;
	}
	return q;
}

void hawser_line_at(const struct hawser_line_statics *st, double x[2], double *angle, double *T,
                    double *stretch, double *curvature, double S)
{
	const struct hawser_line *line = st->line;
	const struct hawser_line_piece *piece = piece_of(st, S);
	struct hawser__rope rope = hawser__line_rope(line);
	double P = piece->T0/rope.stretch - rope.thrust, a = piece->angle0, bend, tension, place[2];
	double s = (fmax(piece->S0, fmin(S, piece->S1)) - piece->S0)*rope.stretch;

	if (piece->sheave < 0) {
		struct hawser__rope_point at = {{piece->x0[0], piece->x0[1]}, {P*cos(a), P*sin(a)}, 0.0, 0};

		hawser__fly(&at, NULL, &rope, s);
		P = hypot(at.P[0], at.P[1]);
		a = atan2(at.P[1], at.P[0]);
		place[0] = at.x[0];
		place[1] = at.x[1];
		bend = rope.w*(at.P[0]/P)/P;
	} else {
		struct hawser__arc arc = hawser__line_arc(line, piece, P);
		const struct hawser_line_sheave *sheave = &line->sheave[piece->sheave];

		a -= arc.side*angle_of(&P, &arc, &rope, s, fabs(piece->angle1 - piece->angle0));
		place[0] = sheave->centre[0] - arc.side*arc.R*sin(a);
		place[1] = sheave->centre[1] + arc.side*arc.R*cos(a);
		bend = -arc.side*(1.0 + P/rope.EA)/arc.R;
	}
	tension = (P + rope.thrust)*rope.stretch;
	if (x) {
		x[0] = place[0];
		x[1] = place[1];
	}
	if (angle)
		*angle = a;
	if (T)
		*T = tension;
	if (stretch)
		*stretch = 1.0 + tension/line->EA;
	if (curvature)
		*curvature = bend*rope.stretch;
}

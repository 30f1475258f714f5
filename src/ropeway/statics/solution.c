/* ropeway/statics/solution.c - the result of a line: of the rope that runs, with its forces, and what
 * does not close.
 *
 * The force of a sheave follows from the balance of the rope in contact. It is compared with
 * the sum of the normal forces and of the friction on each arc (by quadrature) and at each
 * mass, which is another way to the same force: their difference, and that of the whole rope,
 * is `balance`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "ropeway/statics/line.h"

struct hawser__rope hawser__line_rope(const struct hawser_line *line)
{
	double share = line->rho*line->speed*line->speed/line->EA;

	return (struct hawser__rope){
		.EA = line->EA, .w = line->rho*line->g*(1.0 - share), .stretch = 1.0/(1.0 - share),
		.thrust = line->rho*line->speed*line->speed};
}

double hawser__line_grip(const struct hawser_line *line, int sheave)
{
	const struct hawser_line_sheave *of = &line->sheave[sheave];

	switch (line->sliding) {
	case HAWSER_LINE_TOWARD_A:
		return -of->friction;
	case HAWSER_LINE_TOWARD_B:
		return of->friction;
	case HAWSER_LINE_HELD:
		return of->grip;
	default:
		return 0.0;
	}
}

void hawser__line_touch(double *from, double *to, const struct hawser_line_statics *st, int sheave)
{
	const double *centre = st->line->sheave[sheave].centre;
	double nearest = INFINITY;

	*from = INFINITY;
	*to = 0.0;
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		double far = hypot(piece->x1[0] - centre[0], piece->x1[1] - centre[1]);

		if (piece->sheave == sheave) {
			*from = fmin(*from, piece->S0);
			*to = fmax(*to, piece->S1);
		} else if (st->line->sheave[sheave].radius == 0.0 && far < nearest) {
			nearest = far; /* a point has no arc */
			*from = *to = piece->S1;
		}
	}
}

struct hawser__arc hawser__line_arc(const struct hawser_line *line,
                                    const struct hawser_line_piece *piece, double T0)
{
	const struct hawser_line_sheave *sheave = &line->sheave[piece->sheave];

	return (struct hawser__arc){sheave->radius, piece->angle0, T0,
	                            hawser__line_grip(line, piece->sheave),
	                            sheave->side};
}

/* Force of the sheaves on the rope by quadrature, [sheaves][2] in the caller's pairs. */
static void press(struct hawser_line_contact *contact, double force[2],
                  const struct hawser__march *march,
                  const struct hawser_line_piece *piece)
{
	struct hawser__arc arc = hawser__line_arc(march->line, piece, piece->T0);
	double sum[2], q = fabs(piece->angle1 - piece->angle0), R = arc.R;

	hawser__arc_total(sum, &arc, &march->rope, q);
	force[0] += sum[0];
	force[1] += sum[1];
	if (!(R > 0.0))
		return;
	contact->pressure_min = fmin(contact->pressure_min,
		fmin(hawser__arc_force(&arc, &march->rope, piece->T0, piece->angle0),
		     hawser__arc_force(&arc, &march->rope, piece->T1, piece->angle1))/R);
	if (arc.side < 0 && piece->angle0 < 0.0 && piece->angle1 > 0.0) {
		double T, S;

		hawser__arc_at(&T, &S, &arc, &march->rope, -piece->angle0);
		contact->pressure_min = fmin(contact->pressure_min,
		                             hawser__arc_force(&arc, &march->rope, T, 0.0)/R);
	}
}

/* The tension behind a mass in contact, with T before it and the friction coefficient m, at the normal
 * force that it has. */
static double past_mass(const struct hawser__march *march, int mass, double T, double m)
{
	const struct hawser_line_carrier *carrier = &march->trace.st->carrier[mass];
	double W = march->rope.weight[mass], N = carrier->carried, tangent = march->trace.tangent[mass];
	double angle = carrier->state == 1 ? march->trace.st->contact[carrier->sheave].angle_in : tangent;

	if (carrier->state == 2)
		return T + W*sin(tangent) + m*N;
	return hypot(T*cos(angle) + N*(sin(tangent) + m*cos(tangent)),
	             T*sin(angle) + W + N*(m*sin(tangent) - cos(tangent)));
}

/* The tension behind the contact if friction acted all along it, towards B (1) or A (-1). */
static double behind(const struct hawser__march *march, int k, int slide)
{
	const struct hawser_line_sheave *sheave = &march->line->sheave[k];
	const struct hawser_line_statics *st = march->trace.st;
	double T = st->contact[k].T_in, m = slide*sheave->friction, S;

	if (!(sheave->radius > 0.0))
		return T*exp(m*st->contact[k].wrap);
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		struct hawser__arc arc = {sheave->radius, piece->angle0, T, m, sheave->side};
		int between = piece->S0 >= march->trace.arrive[k].S && piece->S1 <= march->trace.leave[k].S;

		if (piece->mass >= 0 && st->carrier[piece->mass].sheave == k)
			arc.T0 = T = past_mass(march, piece->mass, T, m);
		if (piece->sheave == k) {
			hawser__arc_at(&T, &S, &arc, &march->rope, fabs(piece->angle1 - piece->angle0));
			if (isnan(T))
				return 0.0;
		} else if (piece->sheave < 0 && between) { /* between two arcs below a circle */
			T += piece->T1 - piece->T0;
			if (piece->mass >= 0)
				T += st->carrier[piece->mass].T_after - st->carrier[piece->mass].T_before;
		}
	}
	return T;
}

static double real(const struct hawser__rope *rope, double P)
{
	return (P + rope->thrust)*rope->stretch;
}

/* Contact k but for its pressure. Returns the defect of its balance, N. */
static double close_contact(struct hawser_line_contact *contact, const double force[2],
                            const struct hawser__march *march, int k)
{
	const struct hawser__rope_point *in = &march->trace.arrive[k], *out = &march->trace.leave[k];
	const struct hawser__rope *rope = &march->rope;
	double between = rope->w*(out->S - in->S), friction = march->line->sheave[k].friction;

	for (int i = in->mass; i < out->mass; i++)
		between += rope->weight[i];
	contact->force[0] = in->P[0] - out->P[0];
	contact->force[1] = in->P[1] - out->P[1] + between;
	contact->margin = friction*contact->wrap - fabs(log(contact->T_out/contact->T_in));
	contact->T_out_min = real(rope, behind(march, k, -1));
	contact->T_out_max = real(rope, behind(march, k, 1));
	contact->T_in = real(rope, contact->T_in);
	contact->T_out = real(rope, contact->T_out);
	if (contact->pressure_min == INFINITY)
		contact->pressure_min = 0.0;
	return hypot(contact->force[0] - force[0], contact->force[1] - force[1]);
}

/* Normal force and friction of the sheave at each mass in contact, and of its arcs. */
static void forces_on(double force[2], struct hawser_line_contact *contact,
                      const struct hawser__march *march,
                      int k)
{
	const struct hawser_line_statics *st = march->trace.st;
	double m = hawser__line_grip(march->line, k), side = march->line->sheave[k].side;

	force[0] = force[1] = 0.0;
	for (int i = march->trace.arrive[k].mass; i < march->trace.leave[k].mass; i++) {
		double N = st->carrier[i].carried, a = march->trace.tangent[i];

		if (st->carrier[i].sheave != k)
			continue;
		force[0] += N*(-side*sin(a) - m*cos(a));
		force[1] += N*(side*cos(a) - m*sin(a));
	}
	if (!(march->line->sheave[k].radius > 0.0)) { /* a point: an arc without length */
		struct hawser__arc arc = {0.0, contact->angle_in, contact->T_in, m,
		                          march->line->sheave[k].side};
		double sum[2];

		hawser__arc_total(sum, &arc, &march->rope, contact->wrap);
		force[0] += sum[0];
		force[1] += sum[1];
	}
	for (int i = 0; i < st->pieces; i++)
		if (st->piece[i].sheave == k)
			press(contact, force, march, &st->piece[i]);
}

static double stretched(const struct hawser__march *march)
{
	const struct hawser_line_statics *st = march->trace.st;
	const struct hawser__rope *rope = &march->rope;
	double sum = 0.0;

	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		double length = piece->S1 - piece->S0, a = piece->angle0;
		double P[2] = {piece->T0*cos(a), piece->T0*sin(a)};

		if (piece->sheave >= 0)
			sum += march->line->sheave[piece->sheave].radius*fabs(piece->angle1 - a);
		else
			sum += length + hawser__fly_stretch(rope, P, length);
	}
	return sum;
}

void hawser__line_finish(struct hawser_line_statics *st, struct hawser__march *march)
{
	const struct hawser_line *line = march->line;
	const struct hawser__rope *rope = &march->rope;
	double whole[2], force[2], weight = rope->w*march->end.S;
	const double *PA = march->begin.P, *PB = march->end.P;

	st->line = line;
	st->iterations = march->iterations;
	st->closure = march->miss;
	st->balance = 0.0;
	whole[0] = PB[0] - PA[0];
	whole[1] = PB[1] - PA[1];
	for (int k = 0; k < line->sheaves; k++) {
		struct hawser_line_contact *contact = &st->contact[k];
		double gap;

		if (march->off[k])
			continue;
		contact->pressure_min = INFINITY;
		gap = hypot(march->trace.arrive[k].x[0] - line->sheave[k].centre[0],
		            march->trace.arrive[k].x[1] - line->sheave[k].centre[1]) - line->sheave[k].radius;
		st->closure = fmax(st->closure, fabs(gap));
		forces_on(force, contact, march, k);
		st->balance = fmax(st->balance, close_contact(contact, force, march, k));
		whole[0] += force[0];
		whole[1] += force[1];
	}
	for (int i = march->end.mass; i < line->masses; i++)
		st->carrier[i] = (struct hawser_line_carrier){.sheave = -1};
	for (int i = 0; i < line->masses; i++) {
		struct hawser_line_carrier *carrier = &st->carrier[i];

		if (!carrier->present) {
			carrier->sheave = -1;
			continue;
		}
		weight += rope->weight[i];
		carrier->T_before = real(rope, carrier->T_before);
		carrier->T_after = real(rope, carrier->T_after);
	}
	st->balance = fmax(st->balance, hypot(whole[0], whole[1] - weight));
	st->length = stretched(march);
	st->length0 = march->end.S/rope->stretch;
	st->T_A = real(rope, hypot(PA[0], PA[1]));
	st->T_B = real(rope, hypot(PB[0], PB[1]));
	st->angle_A = atan2(PA[1], PA[0]);
	st->angle_B = atan2(PB[1], PB[0]);
	st->reaction_A[0] = -st->T_A*cos(st->angle_A);
	st->reaction_A[1] = -st->T_A*sin(st->angle_A);
	st->reaction_B[0] = st->T_B*cos(st->angle_B);
	st->reaction_B[1] = st->T_B*sin(st->angle_B);
	for (int i = 0; i < st->pieces; i++) {
		struct hawser_line_piece *piece = &st->piece[i];

		piece->S0 /= rope->stretch;
		piece->S1 /= rope->stretch;
		piece->T0 = real(rope, piece->T0);
		piece->T1 = real(rope, piece->T1);
	}
}

void hawser_line_statics_clear(struct hawser_line_statics *st)
{
	if (!st)
		return;
	hawser__line_release(st);
	memset(st, 0, sizeof *st);
}

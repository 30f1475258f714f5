/* tests/line-judge.h - whether what hawser_line_solve() states is an equilibrium. Nothing of the
 * solver is used: the differential equations of the rope, free and on a circle, are integrated step
 * by step from A to B.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LINE_JUDGE_H
#define HAWSER_TESTS_LINE_JUDGE_H

#include "tests/line-random.h"

enum { JUDGED = 128 }; /* most sheaves of a line that is integrated */

static inline double size_of(const struct hawser_line *line)
{
	return fabs(line->B[0]) + fabs(line->B[1]);
}

/* What is wrong with an equilibrium; NULL: nothing. */
static inline const char *wrong(const struct hawser_line_statics *st)
{
	const struct hawser_line *line = st->line;
	double size = size_of(line), T = fmax(st->T_A, st->T_B), S = 0.0;

	for (int i = 0; i < st->pieces; i++)
		T = fmax(T, fmax(st->piece[i].T0, st->piece[i].T1));
	if (!(st->closure <= 1e-12*size))
		return "it does not close";
	if (!(st->balance <= 1e-11*T))
		return "its forces do not balance";
	for (int i = 0; i < line->masses; i++)
		if (st->carrier[i].present && st->carrier[i].carried < -1e-10*T)
			return "a sheave pulls a mass";
	for (int k = 0; k < line->sheaves; k++) {
		const struct hawser_line_contact *c = &st->contact[k];

		if (c->touches && (c->wrap < 0.0 || c->pressure_min < -1e-10*T))
			return "a sheave pulls the rope";
		if (!c->touches && c->clearance < -1e-9*size)
			return "the rope is in a sheave without contact";
		if (c->touches && !(c->T_out >= c->T_out_min*(1.0 - 1e-9) &&
		                    c->T_out <= c->T_out_max*(1.0 + 1e-9)))
			return "the tension is beyond friction";
	}
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];

		if (piece->S0 != S || !(piece->S1 > piece->S0))
			return "its pieces do not follow each other";
		S = piece->S1;
	}
	return S == st->length0 || fabs(S - st->length0) <= 1e-14*S ? NULL : "its pieces are not the rope";
}

/* The deepest place of the rope in a sheave, m. */
static inline double inside(const struct hawser_line_statics *st, int places)
{
	const struct hawser_line *line = st->line;
	double worst = 0.0;

	for (int i = 0; i < st->pieces; i++)
		for (int j = 0; j < places; j++) {
			const struct hawser_line_piece *piece = &st->piece[i];
			double x[2];

			hawser_line_at(st, x, NULL, NULL, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*j/places);
			for (int k = 0; k < line->sheaves; k++) {
				const struct hawser_line_sheave *s = &line->sheave[k];

				worst = fmax(worst, s->radius - hypot(x[0] - s->centre[0], x[1] - s->centre[1]));
				if (fabs(x[0] - s->centre[0]) < 0.1*s->radius && s->side*(x[1] - s->centre[1]) < 0.0)
					return INFINITY; /* on the wrong side */
			}
		}
	return worst;
}

/* State of the step-by-step integration: x, y, and the vector P = (T - rho v^2 |x'|) e. */
struct state {
	double x[2], P[2];
};

static inline double tension(const struct hawser_line *line, const double P[2])
{
	double thrust = line->rho*line->speed*line->speed;

	return (hypot(P[0], P[1]) + thrust)/(1.0 - thrust/line->EA);
}

/* Derivatives by S: of the free rope, or of rope on a sheave, which presses it by its curvature. */
static inline struct state slope_of(const struct hawser_line *line, const struct state *s, int sheave)
{
	double P = hypot(s->P[0], s->P[1]), g = 1.0 + tension(line, s->P)/line->EA, N, m;
	double t[2] = {s->P[0]/P, s->P[1]/P}, w = line->rho*line->g, side;
	struct state d = {{g*t[0], g*t[1]}, {0.0, w}};

	if (sheave < 0)
		return d;
	side = line->sheave[sheave].side;
	m = line->sliding == HAWSER_LINE_NONE ? 0.0 : line->sliding == HAWSER_LINE_TOWARD_B
	    ? line->sheave[sheave].friction : -line->sheave[sheave].friction;
	N = P*g/line->sheave[sheave].radius + side*w*t[0];
	d.P[0] -= N*(-side*t[1] - m*t[0]);
	d.P[1] -= N*(side*t[0] - m*t[1]);
	return d;
}

static inline void add(struct state *s, const struct state *d, double h)
{
	for (int k = 0; k < 2; k++) {
		s->x[k] += h*d->x[k];
		s->P[k] += h*d->P[k];
	}
}

/* Runge and Kutta's method of order 4. */
static inline void integrate(struct state *s, const struct hawser_line *line, int sheave,
                             double length, int steps)
{
	double h = length/steps;

	for (int i = 0; i < steps; i++) {
		struct state k1 = slope_of(line, s, sheave), k2, k3, k4, at = *s;

		add(&at, &k1, h/2.0);
		k2 = slope_of(line, &at, sheave);
		at = *s;
		add(&at, &k2, h/2.0);
		k3 = slope_of(line, &at, sheave);
		at = *s;
		add(&at, &k3, h);
		k4 = slope_of(line, &at, sheave);
		add(s, &k1, h/6.0);
		add(s, &k2, h/3.0);
		add(s, &k3, h/3.0);
		add(s, &k4, h/6.0);
	}
}

/* Weight of a mass, and the force of the sheave at it. */
static inline void kink(struct state *s, const struct hawser_line_statics *st, int mass)
{
	const struct hawser_line *line = st->line;
	const struct hawser_line_carrier *c = &st->carrier[mass];
	double N = c->carried, n[2], m;

	s->P[1] += line->mass[mass].mass*line->g;
	if (c->sheave < 0 || N == 0.0)
		return;
	for (int k = 0; k < 2; k++)
		n[k] = (c->x[k] - line->sheave[c->sheave].centre[k])/line->sheave[c->sheave].radius;
	m = line->sliding == HAWSER_LINE_NONE ? 0.0 : line->sliding == HAWSER_LINE_TOWARD_B
	    ? line->sheave[c->sheave].friction : -line->sheave[c->sheave].friction;
	s->P[0] -= N*(n[0] - m*n[1]);
	s->P[1] -= N*(n[1] + m*n[0]);
}

/* The rope passes a sheave of radius 0: by the capstan law, to the direction in which it leaves. */
static inline void turn(struct state *s, const struct hawser_line_statics *st, int k)
{
	const struct hawser_line *line = st->line;
	const struct hawser_line_contact *c = &st->contact[k];
	double m = line->sliding == HAWSER_LINE_NONE ? 0.0 : line->sliding == HAWSER_LINE_TOWARD_B
	           ? line->sheave[k].friction : -line->sheave[k].friction;
	double angle = line->sheave[k].side*(atan2(s->P[1], s->P[0]) - c->angle_out);
	double P = hypot(s->P[0], s->P[1])*exp(m*angle);

	s->P[0] = P*cos(c->angle_out);
	s->P[1] = P*sin(c->angle_out);
}

/* How far the integration from A, through the places at which contacts and masses begin and end,
 * is from B and from the tension there, and the forces of the sheaves by it from those stated, over
 * size and tension. */
static inline double integrated(const struct hawser_line_statics *st, int steps)
{
	const struct hawser_line *line = st->line;
	double thrust = line->rho*line->speed*line->speed, P = st->T_A*(1.0 - thrust/line->EA) - thrust;
	struct state s = {{line->A[0], line->A[1]}, {P*cos(st->angle_A), P*sin(st->angle_A)}}, last;
	double force[JUDGED][2] = {{0.0}}, worst = 0.0, w = line->rho*line->g;
	int next = 0;

	if (line->sheaves > JUDGED)
		return NAN;
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		int sheave = piece->sheave, at;

		last = s;
		at = piece->mass >= 0 ? st->carrier[piece->mass].sheave : -1;
		if (piece->mass >= 0)
			kink(&s, st, piece->mass);
		if (at >= 0)
			for (int d = 0; d < 2; d++)
				force[at][d] += last.P[d] - s.P[d] + d*line->mass[piece->mass].mass*line->g;
		last = s;
		integrate(&s, line, sheave, piece->S1 - piece->S0, steps);
		if (sheave >= 0)
			for (int d = 0; d < 2; d++)
				force[sheave][d] += last.P[d] - s.P[d] + d*w*(piece->S1 - piece->S0);
		for (; next < line->sheaves && line->sheave[next].centre[0] <= s.x[0] + 1e-9*size_of(line);
		     next++) {
			if (!st->contact[next].touches || line->sheave[next].radius > 0.0)
				continue;
			last = s;
			turn(&s, st, next);
			for (int d = 0; d < 2; d++)
				force[next][d] += last.P[d] - s.P[d];
		}
	}
	for (int k = 0; k < line->sheaves; k++)
		for (int d = 0; d < 2; d++)
			worst = fmax(worst, fabs(force[k][d] - st->contact[k].force[d])/st->T_A);
	worst = fmax(worst, fabs(tension(line, s.P)/st->T_B - 1.0));
	return fmax(worst, hypot(s.x[0] - line->B[0], s.x[1] - line->B[1])/size_of(line));
}

#endif

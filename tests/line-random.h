/* tests/line-random.h - random lines: up to 12 sheaves above and below the rope, points or
 * circles, with and without carriers, friction and speed; stiff and soft ropes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LINE_RANDOM_H
#define HAWSER_TESTS_LINE_RANDOM_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <hawser/line.h>

enum { LINE_SHEAVES = 12, LINE_MASSES = 60 };

struct line_random {
	struct hawser_line line;
	struct hawser_line_sheave sheave[LINE_SHEAVES];
	struct hawser_line_mass mass[LINE_MASSES];
	double spacing, weight; /* m between carriers; N/m with carriers */
};

static inline double draw(uint64_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	*state ^= *state << 17;
	return (double)(*state >> 11)*0x1p-53;
}

static inline double between(uint64_t *state, double low, double high)
{
	return low*pow(high/low, draw(state));
}

static inline void line_sheaves(struct line_random *r, uint64_t *state, double length)
{
	int count = (int)(draw(state)*(LINE_SHEAVES + 1)), points = draw(state) < 0.1;
	double drop = (draw(state) - 0.4)*length*between(state, 0.05, 1.0), step = length/(count + 1);
	double R = between(state, 0.05, 0.4)*step/2.0;
	double below = draw(state) < 0.5 ? 0.0 : 0.5*draw(state);

	r->line.B[0] = length;
	r->line.B[1] = drop;
	r->line.sheaves = count;
	for (int k = 0; k < count; k++) {
		struct hawser_line_sheave *s = &r->sheave[k];
		double x = step*(k + 1) + 0.3*step*(draw(state) - 0.5);

		s->radius = points ? 0.0 : R*between(state, 0.3, 1.0);
		s->side = draw(state) < below ? -1 : 1;
		s->centre[0] = x;
		s->centre[1] = drop*x/length + 0.3*step*(draw(state) - 0.5) - s->side*s->radius;
		s->friction = draw(state) < 0.5 ? 0.0 : between(state, 0.005, 0.5);
	}
}

/* The line of a number. */
static inline void line_random(struct line_random *r, int number)
{
	uint64_t state = 88172645463325252u ^ (uint64_t)(number + 1)*0x9E3779B97F4A7C15u;
	double length, w, mass, span;
	int count;

	memset(r, 0, sizeof *r);
	for (int i = 0; i < 10; i++)
		draw(&state);
	length = between(&state, 50.0, 3000.0);
	line_sheaves(r, &state, length);
	count = draw(&state) < 0.2 ? 0 : (int)(draw(&state)*LINE_MASSES);
	r->spacing = 1.3*length/(count + 1);
	r->line.rho = between(&state, 0.1, 30.0);
	r->line.g = 9.81;
	w = r->line.rho*r->line.g;
	mass = between(&state, 0.01, 3.0)*r->line.rho*r->spacing;
	span = draw(&state);
	for (int i = 0; i < count; i++) {
		r->mass[i].S = r->spacing*(i + span);
		r->mass[i].mass = mass*(draw(&state) < 0.5 ? 1.0 : 2.0*draw(&state));
	}
	r->line.EA = draw(&state) < 0.1 ? INFINITY : between(&state, 10.0, 1e7)*w*length;
	r->line.sheave = r->sheave;
	r->line.mass = r->mass;
	r->line.masses = count;
	r->line.lift = 1;
	r->line.sliding = (enum hawser_line_sliding)(int)(3.0*draw(&state));
	r->weight = w + (count ? mass*r->line.g/r->spacing : 0.0);
	span = length/(r->line.sheaves + 1);
	r->line.value = r->weight*(span*between(&state, 0.3, 30.0) + draw(&state)*fmax(0.0, -r->line.B[1]));
	if (draw(&state) < 0.2)
		r->line.speed = 0.9*draw(&state)*sqrt(r->line.value/r->line.rho)/
		                sqrt(1.0 + r->line.value/r->line.EA);
}

#endif

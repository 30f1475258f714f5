/* tests/statics-draw.h - random spans for the tests and the bench of the statics stage, and the
 * closure of a solved span in long double.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_STATICS_DRAW_H
#define HAWSER_TESTS_STATICS_DRAW_H

#include <math.h>
#include <stdint.h>

#include <hawser/statics.h>

static uint64_t draw_state = UINT64_C(0x9e3779b97f4a7c15);

/* Uniform on [0, 1): xorshift64*, the same numbers everywhere. */
static inline double draw(void)
{
	draw_state ^= draw_state >> 12;
	draw_state ^= draw_state << 25;
	draw_state ^= draw_state >> 27;
	return (double)((draw_state*UINT64_C(2685821657736338717)) >> 11)*0x1p-53;
}

static inline double draw_between(double low, double high)
{
	return low + draw()*(high - low);
}

static inline double draw_log(double low, double high)
{
	return low*exp(draw()*log(high/low));
}

/* A span and a horizontal tension: EA 1e4..1e14 N, slope -20..20 (half of them uniform, half down
 * to 1e-8 by the logarithm), weight ratio 1e-7..20 (three quarters by the logarithm, the others
 * uniform), mass per length and span over five decades each. */
static inline double draw_span(struct hawser_span *span)
{
	double slope = draw() < 0.5 ? draw_between(-20.0, 20.0)
	                            : (draw() < 0.5 ? -1.0 : 1.0)*draw_log(1e-8, 20.0);
	double delta = draw() < 0.75 ? draw_log(1e-7, 20.0) : draw_between(1e-7, 20.0);

	span->EA = draw_log(1e4, 1e14);
	span->rho = draw_log(1e-2, 1e3);
	span->g = 9.81;
	span->d = draw_log(0.1, 1e4);
	span->h = slope*span->d;
	return span->rho*span->g*span->d/delta;
}

/* The value of a given quantity in a solved span. */
static inline double value_of(const struct hawser_statics *st, enum hawser_given given)
{
	const double values[] = {0.0, st->H, st->T0, st->T1, st->length0, st->sag};

	return values[given];
}

/* The branch of a solved span for given T0 or T1: the side of the minimum, from the tension at a
 * slightly larger H. */
static inline enum hawser_branch branch_of(const struct hawser_statics *st, enum hawser_given given)
{
	struct hawser_statics next;

	if (hawser_statics_solve(&next, &st->span, HAWSER_GIVEN_H, st->H*(1.0 + 1e-5),
	                         HAWSER_BRANCH_TAUT, NULL))
		return HAWSER_BRANCH_TAUT;
	return value_of(&next, given) > value_of(st, given) ? HAWSER_BRANCH_TAUT
	                                                    : HAWSER_BRANCH_SLACK;
}

/* Distance of end B from the point of B (2.87) for the stored eta and length0, relative to the
 * chord, in long double. */
static inline double draw_closure(const struct hawser_statics *st)
{
	long double d = st->span.d, h = st->span.h, H = st->H, S = st->length0;
	long double w = (long double)st->span.rho*st->span.g, u0 = st->eta, step = w*S/H;
	long double u1 = u0 + step, r0 = sqrtl(1.0L + u0*u0), r1 = sqrtl(1.0L + u1*u1);
	long double tangent = step/(r0 + r1), x, y;

	x = 2.0L*(tangent < 0.9L ? atanhl(tangent) : 0.5L*(asinhl(u1) - asinhl(u0)))*H/w;
	x += S*(H/st->span.EA) - d;
	y = S*(u0 + u1)*(0.5L*H/st->span.EA + 1.0L/(r0 + r1)) - h;
	return (double)(hypotl(x, y)/hypotl(d, h));
}

#endif

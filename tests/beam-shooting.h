/* tests/beam-shooting.h - static speeds of a travelling beam by another route. With l = 0 the
 * equation
 *
 *   (theta - r^2 v^2) y'''' - ((T - v^2) y')' + c v y' = 0
 *
 * integrates once to (theta - r^2 v^2) y''' = (T - v^2) y' - c v y + C. It is integrated from x = 0
 * with the two free constants there. At a static speed the determinant of the end conditions at x =
 * 1 vanishes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_BEAM_SHOOTING_H
#define HAWSER_TESTS_BEAM_SHOOTING_H

#include <math.h>

#include <hawser/beam.h>

enum { SHOOTING_STEPS = 4000 };

struct shot {
	double y[3]; /* y, y', y'' */
};

static inline void shot_slope(double out[3], const struct hawser_beam *beam, double v, double C,
        double x,
                              const double y[3])
{
	double T = beam->tension - beam->weight*(1.0 - x);

	out[0] = y[1];
	out[1] = y[2];
	out[2] = ((T - v*v)*y[1] - beam->drag*v*y[0] + C)/(beam->theta - beam->rotary*v*v);
}

/* Classical Runge and Kutta, step 1/4000: relative error about 1e-13 for gentle coefficients. */
static inline struct shot shoot(const struct hawser_beam *beam, double v, double slope,
        double bend, double C)
{
	struct shot s = {{0.0, slope, bend}};
	double h = 1.0/SHOOTING_STEPS, k[4][3], at[3];

	for (int i = 0; i < SHOOTING_STEPS; i++) {
		static const double part[4] = {0.0, 0.5, 0.5, 1.0};

		for (int stage = 0; stage < 4; stage++) {
			for (int j = 0; j < 3; j++)
				at[j] = s.y[j] + (stage ? part[stage]*h*k[stage - 1][j] : 0.0);
			shot_slope(k[stage], beam, v, C, (i + part[stage])*h, at);
		}
		for (int j = 0; j < 3; j++)
			s.y[j] += h/6.0*(k[0][j] + 2.0*k[1][j] + 2.0*k[2][j] + k[3][j]);
	}
	return s;
}

static inline double shooting_determinant(const struct hawser_beam *beam, double v)
{
	int clamped = beam->ends == HAWSER_ENDS_CLAMPED, second = clamped ? 1 : 2;
	struct shot a = shoot(beam, v, !clamped, clamped, 0.0), b = shoot(beam, v, 0.0, 0.0, 1.0);

	return a.y[0]*b.y[second] - a.y[second]*b.y[0];
}

/* The static speed between low and high, by bisection. */
static inline double shooting_speed(const struct hawser_beam *beam, double low, double high)
{
	double at_low = shooting_determinant(beam, low);

	for (int i = 0; i < 60 && high - low > 1e-15*high; i++) {
		double middle = 0.5*(low + high), value = shooting_determinant(beam, middle);

		if ((value < 0.0) == (at_low < 0.0))
			low = middle;
		else
			high = middle;
	}
	return 0.5*(low + high);
}

#endif

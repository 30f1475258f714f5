/* tests/gyroscopic-shooting.h - frequencies of a travelling cable by another route: the linear
 * equations of motion are integrated from end A for a complex omega, by Gragg-Bulirsch-Stoer
 * extrapolation in extended precision. At an eigenvalue the determinant of the displacements at the
 * far end vanishes.
 *
 *   X' = a e + b n, a = epsilon F.e, b = (g/T) F.n;   F' = -omega^2 X + 2 i nu omega X'
 *
 * This route does not assume that omega is real.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_GYROSCOPIC_SHOOTING_H
#define HAWSER_TESTS_GYROSCOPIC_SHOOTING_H

#include <complex.h>
#include <hawser/gyroscopic.h>
#include <math.h>
#include <string.h>

typedef long double complex turn;

enum { TURN_STATE = 8, TURN_COLUMNS = 8 }; /* two columns of X, Y, Fx, Fy */

struct turn_problem {
	long double eta, delta, epsilon, nu, ec, es;
	turn omega;
	int out_of_plane;
};

static inline void turn_rate(turn *rate, const struct turn_problem *p, long double s, const turn *y)
{
	long double u = p->eta + p->delta*s, T = sqrtl(1.0L + u*u), soft = (1.0L + p->epsilon*T)/T;
	long double ex = (p->ec + u*p->es)/T, ey = (u*p->ec - p->es)/T;

	for (int k = 0; k < TURN_STATE; k += 4) {
		turn a = p->epsilon*(y[k + 2]*ex + y[k + 3]*ey), b = soft*(y[k + 3]*ex - y[k + 2]*ey);

		rate[k] = p->out_of_plane ? 0.0L : a*ex - b*ey;
		rate[k + 1] = p->out_of_plane ? soft*y[k + 3] : a*ey + b*ex;
		for (int c = 0; c < 2; c++)
			rate[k + 2 + c] = -p->omega*p->omega*y[k + c] + 2.0L*I*p->nu*p->omega*rate[k + c];
	}
}

static inline void turn_midpoint(turn *out, const struct turn_problem *p, long double s,
                                 long double H,
                                 int n, const turn *y)
{
	long double h = H/n;
	turn rate[TURN_STATE], old[TURN_STATE], now[TURN_STATE];

	turn_rate(rate, p, s, y);
	for (int i = 0; i < TURN_STATE; i++) {
		old[i] = y[i];
		now[i] = y[i] + h*rate[i];
	}
	for (int k = 1; k < n; k++) {
		turn_rate(rate, p, s + k*h, now);
		for (int i = 0; i < TURN_STATE; i++) {
			turn next = old[i] + 2.0L*h*rate[i];

			old[i] = now[i];
			now[i] = next;
		}
	}
	turn_rate(rate, p, s + H, now);
	for (int i = 0; i < TURN_STATE; i++)
		out[i] = 0.5L*(now[i] + old[i] + h*rate[i]);
}

static inline void turn_step(turn *y, const struct turn_problem *p, long double s, long double H)
{
	turn table[TURN_COLUMNS][TURN_STATE];

	for (int j = 0; j < TURN_COLUMNS; j++) {
		turn_midpoint(table[j], p, s, H, 2*(j + 1), y);
		for (int k = j - 1; k >= 0; k--) {
			long double ratio = (long double)((j + 1)*(j + 1))/((k + 1)*(k + 1)) - 1.0L;

			for (int i = 0; i < TURN_STATE; i++)
				table[k][i] = table[k + 1][i] + (table[k + 1][i] - table[k][i])/ratio;
		}
	}
	memcpy(y, table[0], sizeof table[0]);
}

static inline turn turn_determinant(const struct hawser_statics *st, enum hawser_plane plane,
                                    turn omega,
                                    int steps)
{
	long double um = (long double)st->eta + 0.5L*st->delta*st->l, root = sqrtl(1.0L + um*um), s = 0.0L;
	struct turn_problem p = {st->eta, st->delta, st->epsilon, st->motion.nu, 1.0L/root, um/root,
	                         omega, plane == HAWSER_OUT_OF_PLANE};
	turn y[TURN_STATE] = {0, 0, 1, 0, 0, 0, 0, 1};
	long double first = asinhl(st->eta), last = asinhl(st->eta + (long double)st->delta*st->l);

	for (int k = 1; k <= steps; k++) {
		long double x = first + (last - first)*k/steps, next = (long double)st->l*k/steps;

		if (last - first > 0.5L && k < steps)
			next = (sinhl(x) - st->eta)/st->delta;
		turn_step(y, &p, s, next - s);
		s = next;
	}
	return plane == HAWSER_OUT_OF_PLANE ? y[5] : y[0]*y[5] - y[1]*y[4];
}

/* The complex frequency next to `omega`, by the secant rule; *error is the last correction,
 * relative. */
static inline double complex turn_frequency(const struct hawser_statics *st,
                                            enum hawser_plane plane,
                                            double omega, int steps, double *error)
{
	turn a = omega, b = (long double)omega*(1.0L + 1e-7L + 1e-7L*I);
	turn fa = turn_determinant(st, plane, a, steps), fb = turn_determinant(st, plane, b, steps);

	*error = 1.0;
	for (int k = 0; k < 8 && fa != fb && *error > 1e-17; k++) {
		turn c = b - fb*(b - a)/(fb - fa);

		*error = (double)(cabsl(c - b)/cabsl(c));
		a = b;
		fa = fb;
		b = c;
		fb = turn_determinant(st, plane, b, steps);
	}
	return (double complex)b;
}

#endif

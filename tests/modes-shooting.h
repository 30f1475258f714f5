/* tests/modes-shooting.h - natural frequencies by another route, to 1e-20: the linear equations of
 * motion are integrated in quadruple precision from end A by Gragg-Bulirsch-Stoer extrapolation. At
 * a natural frequency the determinant of the displacements at the far end vanishes.
 *
 *   X' = a e + b n, a = epsilon F.e, b = (g/T) F.n;   F' = -omega^2 X
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_SHOOTING_H
#define HAWSER_TESTS_MODES_SHOOTING_H

#include <hawser/modes.h>
#include <math.h>
#include <string.h>

/* With SHOOT_LONG_DOUBLE 1e-17 instead, 20 times as fast. SHOOT_APART: relative distance of the first
 * two frequencies of the secant rule. */
#if defined __SIZEOF_FLOAT128__ && !defined SHOOT_LONG_DOUBLE
typedef __float128 quad;
#define SHOOT_APART 1e-12
#else
typedef long double quad;
#define SHOOT_APART 1e-9
#endif

enum { SHOOT_STATE = 8, SHOOT_COLUMNS = 9 }; /* two columns of X, Y, Fx, Fy; order 18 */

static inline quad quad_sqrt(quad x)
{
	quad r = (quad)sqrt((double)x);

	r = (quad)0.5*(r + x/r);
	return (quad)0.5*(r + x/r);
}

struct shoot {
	quad eta, delta, epsilon, ec, es; /* frame: tangent at mid-length */
	quad omega2;
	int out_of_plane;
};

/* 1/sqrt(x); without divisions, which are software here. */
static inline quad quad_inverse_sqrt(quad x)
{
	quad r = (quad)(1/sqrt((double)x)), half = (quad)0.5*x;

	r *= (quad)1.5 - half*r*r;
	return r*((quad)1.5 - half*r*r);
}

static inline void shoot_rate(quad *rate, const struct shoot *p, quad s, const quad *y)
{
	quad u = p->eta + p->delta*s, c = quad_inverse_sqrt(1 + u*u), turn = c + p->epsilon;
	quad ex = (p->ec + u*p->es)*c, ey = (u*p->ec - p->es)*c;

	for (int k = 0; k < SHOOT_STATE; k += 4) {
		quad a, b;

		if (p->out_of_plane) { /* Y alone, straight */
			rate[k] = rate[k + 2] = 0;
			rate[k + 1] = turn*y[k + 3];
			rate[k + 3] = -p->omega2*y[k + 1];
			continue;
		}
		a = p->epsilon*(y[k + 2]*ex + y[k + 3]*ey);
		b = turn*(y[k + 3]*ex - y[k + 2]*ey);
		rate[k] = a*ex - b*ey;
		rate[k + 1] = a*ey + b*ex;
		rate[k + 2] = -p->omega2*y[k];
		rate[k + 3] = -p->omega2*y[k + 1];
	}
}

/* Modified midpoint rule with n steps over [s, s+H]. */
static inline void shoot_midpoint(quad *out, const struct shoot *p, quad s, quad H, int n,
                                  const quad *y)
{
	quad h = H/n, rate[SHOOT_STATE], old[SHOOT_STATE], now[SHOOT_STATE];

	shoot_rate(rate, p, s, y);
	for (int i = 0; i < SHOOT_STATE; i++) {
		old[i] = y[i];
		now[i] = y[i] + h*rate[i];
	}
	for (int k = 1; k < n; k++) {
		shoot_rate(rate, p, s + k*h, now);
		for (int i = 0; i < SHOOT_STATE; i++) {
			quad next = old[i] + 2*h*rate[i];

			old[i] = now[i];
			now[i] = next;
		}
	}
	shoot_rate(rate, p, s + H, now);
	for (int i = 0; i < SHOOT_STATE; i++)
		out[i] = (quad)0.5*(now[i] + old[i] + h*rate[i]);
}

static inline void shoot_step(quad *y, const struct shoot *p, quad s, quad H)
{
	quad table[SHOOT_COLUMNS][SHOOT_STATE];

	for (int j = 0; j < SHOOT_COLUMNS; j++) {
		shoot_midpoint(table[j], p, s, H, 2*(j + 1), y);
		for (int k = j - 1; k >= 0; k--) {
			quad ratio = (quad)((j + 1)*(j + 1))/((k + 1)*(k + 1)) - 1;

			for (int i = 0; i < SHOOT_STATE; i++)
				table[k][i] = table[k + 1][i] + (table[k + 1][i] - table[k][i])/ratio;
		}
	}
	memcpy(y, table[0], sizeof table[0]);
}

/* Determinant of the far end's displacements; `steps` macro steps equal in asinh(u). */
static inline quad shoot_determinant(const struct hawser_statics *st, enum hawser_plane plane,
                                     quad omega, int steps)
{
	quad um = (quad)st->eta + (quad)0.5*st->delta*st->l, root = quad_sqrt(1 + um*um), s = 0;
	struct shoot p = {st->eta, st->delta, st->epsilon, 1/root, um/root, omega*omega,
	                  plane == HAWSER_OUT_OF_PLANE};
	quad y[SHOOT_STATE] = {0, 0, 1, 0, 0, 0, 0, 1};
	double first = asinh(st->eta), last = asinh(st->eta + st->delta*st->l);

	for (int k = 1; k <= steps; k++) {
		double equal = st->l*k/steps, x = first + (last - first)*k/steps;
		quad next = k == steps ? st->l : last - first > 0.5 ? (sinh(x) - st->eta)/st->delta
		                                                    : equal;

		shoot_step(y, &p, s, next - s);
		s = next;
	}
	return plane == HAWSER_OUT_OF_PLANE ? y[5] : y[0]*y[5] - y[1]*y[4];
}

/* The frequency next to `omega`, by the secant rule. Its error is the product of the two previous
 * errors times f''/(2 f'). With a product of 1e-24 and a factor below 1e8 it is below 1e-16,
 * relative. error: that of `omega`, relative. */
static inline double shoot_frequency(const struct hawser_statics *st, enum hawser_plane plane,
                                     double omega, int steps, double *error)
{
	quad a = omega, b = (quad)omega*(1 + (quad)SHOOT_APART);
	quad fa = shoot_determinant(st, plane, a, steps), fb = shoot_determinant(st, plane, b, steps);

	for (int k = 0; k < 3 && fa != fb; k++) {
		quad c = b - fb*(b - a)/(fb - fa), left = fabs((double)((c - a)*(c - b)));

		a = b;
		fa = fb;
		b = c;
		if (left < 1e-24*omega*omega)
			break;
		fb = shoot_determinant(st, plane, b, steps);
	}
	*error = fabs((double)((omega - b)/b));
	return (double)b;
}

#endif

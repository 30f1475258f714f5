/* tests/extremes/modes-count.h - the number of natural frequencies below a given one, by the index
 * theorem of Morse: it is the number of lengths s < l for which omega is a natural frequency of the
 * cable fixed at 0 and at s. Let D and F be the displacements and forces of two solutions from the end
 * 0 at this omega. Then
 *
 *   Theta = (F + i w D)^-1 (F - i w D),    w = omega times the wave impedance,
 *
 * is unitary. At each such length one of its eigenvalues passes 1, always in the same direction. The
 * number of lengths is computed from the total rotation of the determinant of Theta, so that two nearly
 * equal lengths count as two.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_COUNT_H
#define HAWSER_TESTS_MODES_COUNT_H

#include <complex.h>

#include "tests/modes-shooting.h"

enum { COUNT_STEPS = 4000 };

/* Places [steps + 1] along the cable, measured from mid-length, so that no digits are lost in the
 * lowest part of a deep sag. Each interval has the same share of the sum of the phase of the waves and
 * of twice the hyperbolic angle asinh u. */
static inline void count_places(double *place, const struct hawser_statics *st, double omega,
                                int steps)
{
	enum { FINE = 4000 };
	double first = asinh(st->eta), last = asinh(st->eta + st->delta*st->l);
	double middle = st->eta + 0.5*st->delta*st->l, sum = 0.0, total, at[FINE + 1], share[FINE + 1];
	int k = 1;

	for (int i = 0; i <= FINE; i++) {
		double x = first + (last - first)*i/FINE;

		at[i] = last - first > 0.5 ? (sinh(x) - middle)/st->delta
		                           : st->l*((double)i/FINE - 0.5);
		if (i > 0) {
			double T = hypot(1.0, middle + 0.5*st->delta*(at[i] + at[i - 1]));

			sum += (at[i] - at[i - 1])*omega*sqrt((1.0 + st->epsilon*T)/T)
			       + 2.0*(last - first)/FINE;
		}
		share[i] = sum;
	}
	total = sum;
	place[0] = -0.5*st->l;
	for (int i = 1; i <= FINE && k < steps; i++)
		while (k < steps && share[i] >= total*k/steps) {
			double part = (total*k/steps - share[i - 1])/(share[i] - share[i - 1]);

			place[k++] = at[i - 1] + part*(at[i] - at[i - 1]);
		}
	place[steps] = 0.5*st->l;
}

/* The angle modulo 2 pi, in (0, 2 pi]. */
static inline double count_angle(double angle)
{
	const double circle = 6.283185307179586;
	double a = fmod(angle, circle);

	return a <= 0.0 ? a + circle : a;
}

/* Eigenvalues of the symmetric matrix A B^-1, [row][column], with a difference without cancellation. */
static inline void count_ratio(double *value, quad A[2][2], quad B[2][2])
{
	quad det = B[0][0]*B[1][1] - B[0][1]*B[1][0];
	quad a = (A[0][0]*B[1][1] - A[0][1]*B[1][0])/det, c = (A[1][1]*B[0][0] - A[1][0]*B[0][1])/det;
	quad b = ((A[0][1]*B[0][0] - A[0][0]*B[0][1]) + (A[1][0]*B[1][1] - A[1][1]*B[1][0]))/(2*det);
	quad square = (a - c)*(a - c)/4 + b*b, half = square > 0 ? quad_sqrt(square) : 0;
	quad big = (a + c)/2 + (a + c < 0 ? -half : half);

	value[0] = (double)big;
	value[1] = big == 0 ? 0.0 : (double)((a*c - b*b)/big);
}

/* Rotation of det(F + i w D) since *last; *sum is the sum of the angles of Theta. */
static inline double count_turn(double *sum, double complex *last, const struct shoot *p, quad s,
                                const quad *y)
{
	quad u = p->eta + p->delta*s, T = quad_sqrt(1 + u*u), soft = (1 + p->epsilon*T)/T;
	quad omega = quad_sqrt(p->omega2), ex = (p->ec + u*p->es)/T, ey = (u*p->ec - p->es)/T;
	quad weight[2] = {quad_sqrt(quad_sqrt(p->epsilon)), quad_sqrt(quad_sqrt(soft))};
	quad D[2][2], F[2][2], detD, detF;
	double complex det;
	double turned, value[2];

	if (p->out_of_plane) {
		det = (double)(y[7]*weight[1]) + I*(double)(omega*y[5]/weight[1]);
		turned = carg(det/ *last);
		*last = det;
		*sum = count_angle(-2.0*carg(det));
		return turned;
	}
	for (int c = 0; c < 2; c++) {
		const quad *v = y + 4*c;

		D[0][c] = omega*(v[0]*ex + v[1]*ey)/weight[0];
		D[1][c] = omega*(v[1]*ex - v[0]*ey)/weight[1];
		F[0][c] = (v[2]*ex + v[3]*ey)*weight[0];
		F[1][c] = (v[3]*ex - v[2]*ey)*weight[1];
	}
	detD = D[0][0]*D[1][1] - D[0][1]*D[1][0];
	detF = F[0][0]*F[1][1] - F[0][1]*F[1][0];
	det = (double)(detF - detD) + I*(double)(F[0][0]*D[1][1] + D[0][0]*F[1][1] - F[0][1]*D[1][0]
	                                         - D[0][1]*F[1][0]);
	turned = carg(det/ *last);
	*last = det;
	if (detF*detF >= detD*detD)
		count_ratio(value, D, F);
	else
		count_ratio(value, F, D);
	*sum = 0.0;
	for (int c = 0; c < 2; c++)
		*sum += count_angle(-2.0*(detF*detF >= detD*detD ? atan(value[c]) : atan2(1.0, value[c])));
	return turned;
}

/* The determinant of the displacements at the far end. *count, if not NULL, is the number of
 * frequencies of the plane below omega. */
static inline quad count_determinant(int *count, const struct hawser_statics *st,
                                     enum hawser_plane plane, quad omega, const double *place,
                                     int steps)
{
	quad um = (quad)st->eta + (quad)0.5*st->delta*st->l, root = quad_sqrt(1 + um*um);
	struct shoot p = {um, st->delta, st->epsilon, 1/root, um/root, omega*omega,
	                  plane == HAWSER_OUT_OF_PLANE};
	quad y[SHOOT_STATE] = {0, 0, 1, 0, 0, 0, 0, 1};
	double turned = 0.0, sum = 0.0, first;
	double complex last = 1.0;
	int planes = p.out_of_plane ? 1 : 2;

	count_turn(&sum, &last, &p, place[0], y);
	for (int k = 0; k < steps; k++) {
		shoot_step(y, &p, place[k], (quad)place[k + 1] - place[k]);
		if (count)
			turned += count_turn(&sum, &last, &p, place[k + 1], y);
	}
	first = (sum + 2.0*turned)/6.283185307179586; /* number of turns, including the start at 1 */
	if (count)
		*count = (int)lround(first) - planes;
	return p.out_of_plane ? y[5] : y[0]*y[5] - y[1]*y[4];
}

/* Number of frequencies of the plane below omega. */
static inline int count_below(const struct hawser_statics *st, enum hawser_plane plane, double omega,
                              int steps)
{
	static double place[COUNT_STEPS + 1];
	int count;

	steps = steps > COUNT_STEPS ? COUNT_STEPS : steps;
	count_places(place, st, omega, steps);
	count_determinant(&count, st, plane, omega, place, steps);
	return count;
}

/* Relative error of a frequency: distance to the nearest zero, by the secant method. */
static inline double count_error(const struct hawser_statics *st, enum hawser_plane plane,
                                 double omega, int steps)
{
	static double place[COUNT_STEPS + 1];
	quad a = omega, b = (quad)omega*(1 + (quad)1e-9), fa, fb;

	steps = steps > COUNT_STEPS ? COUNT_STEPS : steps;
	count_places(place, st, omega, steps);
	fa = count_determinant(NULL, st, plane, a, place, steps);
	fb = count_determinant(NULL, st, plane, b, place, steps);
	for (int k = 0; k < 3 && fa != fb; k++) {
		quad c = b - fb*(b - a)/(fb - fa);

		a = b;
		fa = fb;
		b = c;
		fb = count_determinant(NULL, st, plane, b, place, steps);
	}
	return fabs((double)((omega - b)/b));
}

#endif

/* tests/travel-chain.h - a cable that travels through its ends, as a chain of straight elastic
 * rods: exact strain, explicit Runge-Kutta steps. It shares nothing with the library but the shape
 * to begin from.
 *
 *   q, w     positions and velocities [n + 1][2] of the joints, which stand where they are along
 *   the cable
 *            while the cable goes through
 *   v        travel speed; a particle has the acceleration w. + 2 v w' + v. q' + v^2 q''
 *
 * Each rod's force is EA (|q'| - 1) along it less rho v^2 q', half of rho (2 v w' + v. q') goes to
 * either end, and a joint has the mass of one rod. Second order in the length of a rod.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TRAVEL_CHAIN_H
#define HAWSER_TESTS_TRAVEL_CHAIN_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct chain {
	int n;
	double L, EA, rho, g, alpha; /* m unstretched, N, kg/m, m/s^2, kg/m/s */
	double from, to, time;       /* m/s, m/s, s: braking begins at t = 0 */
};

/* Smallest tension, smallest tension less rho v^2, largest tension (N), and their times (s). */
struct chain_extremes {
	double least, spare, most, least_at, spare_at, most_at;
};

static double chain_tension(const struct chain *c, const double *q, int e)
{
	double h = c->L/c->n;

	return c->EA*(hypot(q[2*e + 2] - q[2*e], q[2*e + 3] - q[2*e + 1])/h - 1.0);
}

static void chain_acceleration(const struct chain *c, double *a, const double *q, const double *w,
                               double v, double rate)
{
	double h = c->L/c->n, mass = c->rho*h;

	memset(a, 0, 2*((size_t)c->n + 1)*sizeof *a);
	for (int e = 0; e < c->n; e++) {
		double d[2] = {(q[2*e + 2] - q[2*e])/h, (q[2*e + 3] - q[2*e + 1])/h};
		double r = sqrt(d[0]*d[0] + d[1]*d[1]), k = c->EA*(r - 1.0)/r - c->rho*v*v;

		for (int i = 0; i < 2; i++) {
			double carried = -c->rho*(v*(w[2*e + 2 + i] - w[2*e + i]) + 0.5*rate*h*d[i]);

			a[2*e + i] += carried + k*d[i];
			a[2*e + 2 + i] += carried - k*d[i];
		}
	}
	for (int i = 0; i <= c->n; i++)
		for (int x = 0; x < 2; x++)
			a[2*i + x] = i%c->n == 0 ? 0.0 : a[2*i + x]/mass - (x ? c->g : 0.0) -
			                                 c->alpha/c->rho*w[2*i + x];
}

/* Stiffness [4] of rod e, at rest. */
static void chain_stiffness(const struct chain *c, double k[4], const double *q, int e)
{
	double h = c->L/c->n, d[2] = {(q[2*e + 2] - q[2*e])/h, (q[2*e + 3] - q[2*e + 1])/h};
	double r = hypot(d[0], d[1]);

	for (int i = 0; i < 4; i++)
		k[i] = (c->EA*((i%3 == 0)*(1.0 - 1.0/r) + d[i/2]*d[i%2]/(r*r*r)) -
		        (i%3 == 0)*c->rho*c->from*c->from)/h;
}

/* One step of Newton's method towards the steady state, by elimination from joint to joint; returns
 * its largest component. */
static double chain_newton(const struct chain *c, double *q, double *a, const double *w, double *U,
                           double *x)
{
	double mass = c->rho*c->L/c->n, worst = 0.0, before[4], after[4];

	chain_acceleration(c, a, q, w, c->from, 0.0);
	for (int i = 1; i < c->n; i++) {
		double A[4], b[2] = {mass*a[2*i], mass*a[2*i + 1]}, det, *u = U + 4*i;

		chain_stiffness(c, before, q, i - 1);
		chain_stiffness(c, after, q, i);
		for (int j = 0; j < 4; j++)
			A[j] = before[j] + after[j];
		for (int r = 0; r < 2 && i > 1; r++) {
			for (int s = 0; s < 2; s++)
				A[2*r + s] -= before[2*r]*u[s - 4] + before[2*r + 1]*u[s - 2];
			b[r] += before[2*r]*x[2*i - 2] + before[2*r + 1]*x[2*i - 1];
		}
		det = A[0]*A[3] - A[1]*A[2];
		for (int s = 0; s < 2; s++) {
			u[s] = (A[3]*after[s] - A[1]*after[2 + s])/det;
			u[2 + s] = (A[0]*after[2 + s] - A[2]*after[s])/det;
		}
		x[2*i] = (A[3]*b[0] - A[1]*b[1])/det;
		x[2*i + 1] = (A[0]*b[1] - A[2]*b[0])/det;
	}
	for (int i = c->n - 1; i > 0; i--)
		for (int r = 0; r < 2; r++) {
			if (i < c->n - 1)
				x[2*i + r] += U[4*i + 2*r]*x[2*i + 2] + U[4*i + 2*r + 1]*x[2*i + 3];
			q[2*i + r] += x[2*i + r];
			worst = fmax(worst, fabs(x[2*i + r])/c->L);
		}
	return worst;
}

static void chain_watch(const struct chain *c, struct chain_extremes *found, const double *q, double t,
                        double v)
{
	for (int e = 0; e < c->n; e++) {
		double T = chain_tension(c, q, e), spare = T - c->rho*v*v;

		if (T < found->least) {
			found->least = T;
			found->least_at = t;
		}
		if (spare < found->spare) {
			found->spare = spare;
			found->spare_at = t;
		}
		if (T > found->most) {
			found->most = T;
			found->most_at = t;
		}
	}
}

/* One step of the classical fourth-order Runge-Kutta method; work has room for 10 half states. */
static void chain_step(const struct chain *c, double *q, double *w, double *work, double t, double h,
                       int braking)
{
	static const double at[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
	size_t N = 2*((size_t)c->n + 1);
	double *y = work + 8*N, *z = work + 9*N, rate = braking ? (c->to - c->from)/c->time : 0.0;

	for (int g = 0; g < 4; g++) {
		double v = braking ? c->from + rate*(t + at[g]*h) : c->to;
		const double *dq = g ? work + 2*(size_t)(g - 1)*N : NULL, *dw = g ? dq + N : NULL;
		double *kq = work + 2*(size_t)g*N, *kw = kq + N;

		for (size_t i = 0; i < N; i++) {
			y[i] = q[i] + (g ? at[g]*h*dq[i] : 0.0);
			z[i] = w[i] + (g ? at[g]*h*dw[i] : 0.0);
		}
		memcpy(kq, z, N*sizeof *kq);
		chain_acceleration(c, kw, y, z, v, rate);
	}
	for (int g = 0; g < 4; g++)
		for (size_t i = 0; i < N; i++) {
			q[i] += h*weight[g]/6.0*work[2*(size_t)g*N + i];
			w[i] += h*weight[g]/6.0*work[(2*(size_t)g + 1)*N + i];
		}
}

/* Integrate from the steady state at `from` to `until`; q [n + 1][2] is an approximate shape.
 * Returns 0 if Newton's method does not converge. */
static int chain_run(struct chain_extremes *found, const struct chain *c, double *q, double until)
{
	size_t N = 2*((size_t)c->n + 1);
	double *w = calloc(15*N, sizeof *w), *work = w + N, worst = 1.0, t = 0.0;
	double most = 0.7*c->L/c->n/sqrt(c->EA/c->rho);

	*found = (struct chain_extremes){HUGE_VAL, HUGE_VAL, -HUGE_VAL, 0.0, 0.0, 0.0};
	for (int i = 0; w && i < 30 && worst > 1e-13; i++)
		worst = chain_newton(c, q, work, w, work + N, work + 4*N);
	for (int part = 0; w && worst <= 1e-13 && part < 2; part++) {
		double end = part ? until : fmin(c->time, until), begin = t;
		int steps = (int)ceil((end - begin)/most);

		for (int j = 0; j < steps; j++) {
			double h = (end - begin)/steps, v;

			chain_step(c, q, w, work, begin + j*h, h, !part);
			t = begin + (j + 1)*h;
			v = part ? c->to : c->from + (c->to - c->from)*t/c->time;
			chain_watch(c, found, q, t, v);
		}
	}
	free(w);
	return worst <= 1e-13;
}

#endif

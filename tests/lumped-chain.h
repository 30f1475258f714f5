/* tests/lumped-chain.h - a cable in space as a chain of straight elastic rods with masses at the
 * joints, bending stiffness between the rods, masses and dampers at joints, and ends that move or
 * are on springs. It shares nothing with the library.
 *
 *   x      positions of the joints [n + 1][3], m; the rods have the unstretched length h = L0/n
 *   t      unit vector along a rod; `straight` are those of the shape without bending moments
 *   m      change of direction at a joint: (t2 - straight2) - (t1 - straight1)
 *   energy of a rod EA/(2 h) (length - h)^2, of a joint EI/(2 h) |m|^2, of a clamped end
 *          EI/h |t - straight|^2
 *   r      forces on the joints; K = -dr/dx, a band of 8 diagonals on either side
 *
 * Second order in h. Time steps are implicit (Newmark, average acceleration), of second order in
 * dt, so that one extrapolation of n and dt together gives fourth order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LUMPED_CHAIN_H
#define HAWSER_TESTS_LUMPED_CHAIN_H

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LUMPED_MOST = 512, LUMPED_BAND = 8, LUMPED_ROWS = 3*LUMPED_BAND + 1 };

struct lumped {
	int n;
	double L0, EA, EI, rho;            /* m, N, N m^2, kg/m */
	double end[3];                     /* of end B; end A is at 0 */
	double weight[3];                  /* N/m, static */
	double gravity;                    /* m/s^2, of the masses at joints */
	double alpha;                      /* 1/s: damping force per mass and velocity */
	double attached[LUMPED_MOST + 1];  /* kg */
	double dead[LUMPED_MOST + 1][3];   /* N, constant, on the joints */
	double damper[LUMPED_MOST + 1][3]; /* N s/m */
	double spring[LUMPED_MOST + 1][3]; /* N/m, relaxed at the positions `relaxed` [n + 1][3] */
	const double *relaxed;             /* NULL: without the springs */
	double load[3];                    /* N/m times cos(omega t) */
	double motion[2][3], phase[2];     /* m times cos(omega t + phase), ends A and B */
	double omega;                      /* rad/s */
	void (*path)(double moved[2][3], double t); /* in place of that motion, unless NULL; m */
	int clamped;
	/* 1: the first and the last rod are springs, and the joints 0 and n their foundations
	 * (lumped_hold) */
	int held;
	double stiffness[2][3], held_mass[2]; /* N/m, kg: of ends A and B */
	double preload[2][3];                 /* N, on the ends of the cable at rest */
	double straight[LUMPED_MOST][3];
};

/* Unstretched length of a rod, and of the cable at a joint. */
static double lumped_part(const struct lumped *c)
{
	return c->L0/(c->n - 2*c->held);
}

static double lumped_share(const struct lumped *c, int joint)
{
	return lumped_part(c)*(joint <= c->held || joint >= c->n - c->held ? 0.5 : 1.0);
}

static double lumped_mass(const struct lumped *c, int joint)
{
	return c->rho*lumped_share(c, joint) + c->attached[joint] +
	       (c->held && joint == 1 ? c->held_mass[0] : 0.0) +
	       (c->held && joint == c->n - 1 ? c->held_mass[1] : 0.0);
}

static double lumped_rod(double t[3], const double *x, int e)
{
	double l = 0.0;

	for (int i = 0; i < 3; i++) {
		t[i] = x[3*e + 3 + i] - x[3*e + i];
		l += t[i]*t[i];
	}
	l = sqrt(l);
	for (int i = 0; i < 3; i++)
		t[i] /= l;
	return l;
}

static inline double lumped_tension(const struct lumped *c, const double *x, int e)
{
	double t[3];

	return c->EA*(lumped_rod(t, x, e)/lumped_part(c) - 1.0);
}

/* K [.] in the band storage of dgbsv (column-major), of the joints 1 to n - 1. */
static void lumped_add(double *K, int size, int row, int column, double value)
{
	if (K && row >= 0 && column >= 0 && row < size && column < size)
		K[(size_t)column*LUMPED_ROWS + (size_t)(2*LUMPED_BAND + row - column)] += value;
}

/* Derivative of component i of t2 - t1 by coordinate a of the three vertices. */
static double lumped_turn(double P[2][3][3], int i, int a)
{
	double first = a < 6 ? P[0][i][a%3] : 0.0, second = a > 2 ? P[1][i][a%3] : 0.0;

	return (a < 3 ? first : -first) + (a < 6 ? -second : second);
}

/* The moment of the joint between the rods e and e + 1; a rod that does not exist is the clamped
 * end. */
static void lumped_bend(double *r, double *K, const struct lumped *c, const double *x, int e)
{
	int size = 3*(c->n - 1), has[2] = {e >= 0, e + 1 < c->n};
	double t[2][3] = {{0}}, l[2] = {1.0, 1.0}, m[3],
	                 k = c->EI/(c->L0/c->n)*(has[0] && has[1] ? 1.0 : 2.0);
	double P[2][3][3], d[12];

	for (int i = 0; i < 2; i++)
		if (has[i])
			l[i] = lumped_rod(t[i], x, e + i);
	for (int i = 0; i < 3; i++)
		m[i] = (has[1] ? t[1][i] - c->straight[e + 1][i] : 0.0) -
		       (has[0] ? t[0][i] - c->straight[e][i] : 0.0);
	for (int q = 0; q < 2; q++)
		for (int i = 0; i < 9; i++)
			P[q][i/3][i%3] = has[q] ? ((i/3 == i%3) - t[q][i/3]*t[q][i%3])/l[q] : 0.0;
	/* gradient: dE = k m . (dt1 - dt0), dt = P d(x2 - x1) */
	for (int i = 0; i < 3; i++) {
		double g0 = 0.0, g1 = 0.0;

		for (int j = 0; j < 3; j++) {
			g0 += k*P[0][i][j]*m[j];
			g1 += k*P[1][i][j]*m[j];
		}
		d[i] = g0;
		d[3 + i] = -g0 - g1;
		d[6 + i] = g1;
	}
	for (int v = 0; v < 9; v++) {
		int row = 3*(e - 1) + v;

		if (row >= 0 && row < size)
			r[row] -= d[v];
	}
	if (!K)
		return;
	/* the exact second derivative; of t: -(t_a P_bc + t_b P_ac + t_c P_ab)/l */
	for (int a = 0; a < 9; a++)
		for (int b = 0; b < 9; b++) {
			double value = 0.0;

			for (int i = 0; i < 3; i++) {
				value += k*lumped_turn(P, i, a)*lumped_turn(P, i, b);
			}
			for (int q = 0; q < 2; q++) {
				/* sign of vertex in rod q: rod 0 joins vertices 0, 1; rod 1 joins 1, 2 */
				int va = a/3 - q, vb = b/3 - q, A = a%3, B = b%3;
				double sign = (va == 0 ? -1.0 : 1.0)*(vb == 0 ? -1.0 : 1.0)*(q ? k : -k),
				              curl = 0.0;

				if (!has[q] || va < 0 || va > 1 || vb < 0 || vb > 1)
					continue;
				for (int i = 0; i < 3; i++)
					curl -= m[i]*(t[q][i]*P[q][A][B] + t[q][A]*P[q][i][B] +
					              t[q][B]*P[q][i][A])/l[q];
				value += sign*curl;
			}
			lumped_add(K, size, 3*(e - 1) + a, 3*(e - 1) + b, value);
		}
}

/* The springs of the ends. */
static void lumped_springs(double *r, double *K, const struct lumped *c, const double *x)
{
	int size = 3*(c->n - 1);

	for (int end = 0; end < 2; end++) {
		int at = end ? c->n - 1 : 1, foot = end ? c->n : 0;

		for (int i = 0; i < 3; i++) {
			int v = 3*(at - 1) + i;
			double k = c->stiffness[end][i];

			r[v] += c->preload[end][i] - k*(x[3*at + i] - x[3*foot + i]);
			lumped_add(K, size, v, v, k);
		}
	}
}

/* r: forces of the rods and of the static load on the joints between the ends; K: their stiffness.
 * */
static void lumped_forces(double *r, double *K, const struct lumped *c, const double *x)
{
	int size = 3*(c->n - 1);
	double h = lumped_part(c);

	if (K)
		memset(K, 0, (size_t)size*LUMPED_ROWS*sizeof *K);
	for (int v = 0; v < size; v++)
		r[v] = c->weight[v%3]*lumped_share(c, v/3 + 1) -
		       (v%3 == 1 ? c->attached[v/3 + 1]*c->gravity : 0.0) + c->dead[v/3 + 1][v%3];
	for (int e = c->held; e < c->n - c->held; e++) {
		double t[3], l = lumped_rod(t, x, e), T = c->EA*(l/h - 1.0);

		for (int i = 0; i < 3; i++) {
			if (e > 0)
				r[3*(e - 1) + i] += T*t[i];
			if (e < c->n - 1)
				r[3*e + i] -= T*t[i];
		}
		for (int i = 0; K && i < 9; i++) {
			double k = (c->EA/h - T/l)*t[i/3]*t[i%3] + (i/3 == i%3 ? T/l : 0.0);

			for (int corner = 0; corner < 4; corner++) {
				int p = e - 1 + corner/2, q = e - 1 + corner%2;

				if (p >= 0 && q >= 0 && p < c->n - 1 && q < c->n - 1)
					lumped_add(K, size, 3*p + i/3, 3*q + i%3, p == q ? k : -k);
			}
		}
	}
	for (int v = 0; c->relaxed && v < size; v++) {
		double k = c->spring[v/3 + 1][v%3];

		r[v] -= k*(x[3 + v] - c->relaxed[3 + v]);
		lumped_add(K, size, v, v, k);
	}
	if (c->held)
		lumped_springs(r, K, c, x);
	if (c->EI > 0.0)
		for (int e = c->clamped ? -1 : 0; e < c->n - (c->clamped ? 0 : 1); e++)
			lumped_bend(r, K, c, x, e);
}

static int lumped_solve(double *K, double *b, int size)
{
	static lapack_int pivot[3*LUMPED_MOST];

	return !LAPACKE_dgbsv(LAPACK_COL_MAJOR, size, LUMPED_BAND, LUMPED_BAND, 1, K, LUMPED_ROWS,
	                      pivot, b,
	                      size);
}

/* The static shape, from the start in x; 1 if it converges. */
static int lumped_statics(double *x, const struct lumped *c)
{
	static double K[3*LUMPED_MOST*LUMPED_ROWS], r[3*LUMPED_MOST];
	int size = 3*(c->n - 1);

	for (int k = 0; k < 60; k++) {
		double most = 0.0;

		lumped_forces(r, K, c, x);
		if (!lumped_solve(K, r, size))
			return 0;
		for (int v = 0; v < size; v++) {
			x[3 + v] += r[v];
			most = fmax(most, fabs(r[v]));
		}
		if (most < 1e-9)
			return 1;
	}
	return 0;
}

/* c->straight: the static shape without bending stiffness, which takes the place of the start in x. */
static inline int lumped_straighten(struct lumped *c, double *x)
{
	double EI = c->EI;
	int done;

	c->EI = 0.0;
	done = lumped_statics(x, c);
	c->EI = EI;
	for (int e = 0; e < c->n; e++)
		lumped_rod(c->straight[e], x, e);
	return done;
}

/* Put the ends of the chain on springs (and masses), whose preload balances the forces of the shape x,
 * at which the springs of joints are relaxed: x and c->relaxed are numbered anew, from 1 on. */
static inline void lumped_hold(struct lumped *c, double *x)
{
	static double r[3*LUMPED_MOST];
	int n = c->n;

	memmove(x + 3, x, 3*((size_t)n + 1)*sizeof *x);
	memcpy(x + 3*n + 6, x + 3*n + 3, 3*sizeof *x);
	memmove(c->attached + 1, c->attached, ((size_t)n + 1)*sizeof *c->attached);
	memmove(c->damper + 1, c->damper, ((size_t)n + 1)*sizeof *c->damper);
	memmove(c->spring + 1, c->spring, ((size_t)n + 1)*sizeof *c->spring);
	memmove(c->dead + 1, c->dead, ((size_t)n + 1)*sizeof *c->dead);
	c->attached[0] = 0.0;
	memset(c->dead[0], 0, sizeof c->dead[0]);
	c->n = n + 2;
	c->held = 1;
	c->relaxed = NULL;
	memset(c->preload, 0, sizeof c->preload);
	lumped_forces(r, NULL, c, x);
	for (int i = 0; i < 3; i++) {
		c->preload[0][i] = -r[i];
		c->preload[1][i] = -r[3*n + i];
	}
}

/* omega[count]: natural frequencies about the static shape x, rad/s. */
static inline int lumped_frequencies(double *omega, int count, const struct lumped *c, const double *x)
{
	static double K[3*LUMPED_MOST*LUMPED_ROWS], r[3*LUMPED_MOST], w[3*LUMPED_MOST];
	static double A[3*LUMPED_MOST*(LUMPED_BAND + 1)];
	static lapack_int fail[3*LUMPED_MOST];
	int size = 3*(c->n - 1), done;
	double none;
	lapack_int found;

	memset(A, 0, sizeof A);
	lumped_forces(r, K, c, x);
	for (int j = 0; j < size; j++)
		for (int i = j; i <= j + LUMPED_BAND && i < size; i++)
			A[(size_t)j*(LUMPED_BAND + 1) + (size_t)(i - j)] =
				K[(size_t)j*LUMPED_ROWS + (size_t)(2*LUMPED_BAND + i - j)]/
				sqrt(lumped_mass(c, 1 + i/3)*lumped_mass(c, 1 + j/3));
	done = !LAPACKE_dsbevx(LAPACK_COL_MAJOR, 'N', 'I', 'L', size, LUMPED_BAND, A, LUMPED_BAND + 1,
	                       &none, 1, 0.0, 0.0, 1, count, 0.0, &found, w, &none, 1, fail);
	for (int k = 0; k < count; k++)
		omega[k] = sqrt(w[k]);
	return done;
}

static void lumped_ends(double *x, const struct lumped *c, double t)
{
	double moved[2][3];

	for (int e = 0; e < 2; e++)
		for (int i = 0; i < 3; i++)
			moved[e][i] = c->motion[e][i]*cos(c->omega*t + c->phase[e]);
	if (c->path)
		c->path(moved, t);
	for (int i = 0; i < 3; i++) {
		x[i] = moved[0][i];
		x[3*c->n + i] = c->end[i] + moved[1][i];
	}
}

/* v: velocity of the joints that follow the ends quasi-statically at the time t, about x. */
static inline int lumped_follow(double *v, const struct lumped *c, const double *x, double t)
{
	static double K[3*LUMPED_MOST*LUMPED_ROWS], r[3*LUMPED_MOST], there[3*LUMPED_MOST];
	static double moved[3*LUMPED_MOST + 3];
	int size = 3*(c->n - 1);
	double step = 1e-4/c->omega;

	for (int side = 0; side < 2; side++) {
		memcpy(moved, x, 3*((size_t)c->n + 1)*sizeof *x);
		lumped_ends(moved, c, t + (side ? step : -step));
		lumped_forces(side ? r : there, K, c, moved);
	}
	lumped_forces(moved, K, c, x);
	for (int i = 0; i < size; i++)
		v[3 + i] = (r[i] - there[i])/(2.0*step);
	memset(v, 0, 3*sizeof *v);
	memset(v + 3*c->n, 0, 3*sizeof *v);
	return lumped_solve(K, v + 3, size);
}

/* Acceleration times mass: forces on the joints at the time t. */
static void lumped_rate(double *r, double *K, const struct lumped *c, const double *x,
                        const double *v,
                        double t)
{
	lumped_forces(r, K, c, x);
	for (int i = 0; i < 3*(c->n - 1); i++)
		r[i] += c->load[i%3]*lumped_share(c, 1 + i/3)*cos(c->omega*t) -
		        (c->alpha*lumped_mass(c, 1 + i/3) + c->damper[1 + i/3][i%3])*v[3 + i];
}

/* Motion from x and v at the time `from`, `steps` steps to `until`; seen(x, data) after every
 * `every`-th. Average acceleration with Newton's method. */
static inline int lumped_run(const struct lumped *c, double *x, double *v, double from, double until,
                      int steps,
                      int every, void (*seen)(const double *x, void *data), void *data)
{
	static double K[3*LUMPED_MOST*LUMPED_ROWS], r[3*LUMPED_MOST], a[3*LUMPED_MOST],
		was[3*LUMPED_MOST + 3];
	static double speed[3*LUMPED_MOST + 3];
	int size = 3*(c->n - 1);
	double dt = (until - from)/steps;

	lumped_rate(r, NULL, c, x, v, from);
	for (int i = 0; i < size; i++)
		a[i] = r[i]/lumped_mass(c, 1 + i/3);
	for (int s = 1; s <= steps; s++) {
		double t = from + s*dt, most = 1.0;

		memcpy(was, x, 3*((size_t)c->n + 1)*sizeof *x);
		memcpy(speed, v, 3*((size_t)c->n + 1)*sizeof *v);
		lumped_ends(x, c, t);
		for (int i = 0; i < size; i++)
			x[3 + i] += dt*speed[3 + i] + 0.5*dt*dt*a[i];
		for (int k = 0; k < 20 && most > 1e-11; k++) {
			for (int i = 0; i < size; i++)
				v[3 + i] = 2.0/dt*(x[3 + i] - was[3 + i]) - speed[3 + i];
			lumped_rate(r, K, c, x, v, t);
			for (int i = 0; i < size; i++) {
				double m = lumped_mass(c, 1 + i/3);

				r[i] -= m*(4.0/(dt*dt)*(x[3 + i] - was[3 + i] - dt*speed[3 + i]) - a[i]);
				lumped_add(K, size, i, i, 4.0*m/(dt*dt) +
				           2.0/dt*(c->alpha*m + c->damper[1 + i/3][i%3]));
			}
			if (!lumped_solve(K, r, size))
				return 0;
			most = 0.0;
			for (int i = 0; i < size; i++) {
				x[3 + i] += r[i];
				most = fmax(most, fabs(r[i]));
			}
		}
		if (!(most <= 1e-11))
			return 0;
		for (int i = 0; i < size; i++) {
			double next = 4.0/(dt*dt)*(x[3 + i] - was[3 + i] - dt*speed[3 + i]) - a[i];

			v[3 + i] = speed[3 + i] + 0.5*dt*(a[i] + next);
			a[i] = next;
		}
		if (s%every == 0)
			seen(x, data);
	}
	return 1;
}

#endif

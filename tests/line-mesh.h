/* tests/line-mesh.h - the nonlinear energy of a rope over sheaves, by polynomials: its gradient and its
 * inertia. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LINE_MESH_H
#define HAWSER_TESTS_LINE_MESH_H

#include <complex.h>
#include <math.h>
#include <string.h>

#include <hawser/line.h>

enum { LONG = 11, SHORT = 4, NODES = LONG + 1, GAUSS = 15, PIECES = 40, UNKNOWNS = 700 };
/* The gradient is evaluated at complex displacements. */
typedef long double complex number;
static const long double step = 1e-30L; /* m, imaginary */

struct mesh {
	const struct hawser_line *line;
	const struct hawser_line_statics *st;
	int degree[PIECES];        /* low on short pieces: their high modes cost the low ones digits */
	int at[PIECES][NODES];     /* first unknown of each node; -1: fixed */
	int circle[PIECES][NODES]; /* sheave on which it is, or -1 */
	int pendulum[PIECES];      /* first unknown of the mass at the beginning of a piece; -1 */
	int carriage;              /* unknown, or -1 */
	double carriage_mass;
	int unknowns;
	long double fixed[PIECES][NODES][3];
	long double N[PIECES][GAUSS][NODES], dN[PIECES][GAUSS][NODES], weight[GAUSS]; /* on [0, 1] */
};

/* Gauss points of [0, 1], and the polynomials through equidistant nodes there. */
static void reference(struct mesh *t)
{
	for (int g = 0; g < GAUSS; g++) {
		long double x = cosl(3.14159265358979323846L*(g + 0.75L)/(GAUSS + 0.5L)), f = 0.0L, d = 1.0L;

		for (int k = 0; k < 60; k++) {
			long double below = 1.0L;

			f = x;
			for (int j = 2; j <= GAUSS; j++) {
				long double next = ((2*j - 1)*x*f - (j - 1)*below)/j;

				below = f;
				f = next;
			}
			d = GAUSS*(below - x*f)/(1.0L - x*x);
			x -= f/d;
		}
		t->weight[g] = 1.0L/((1.0L - x*x)*d*d);
		x = 0.5L*(1.0L - x);
		for (int p = 0; p < t->st->pieces; p++)
			for (int i = 0, degree = t->degree[p]; i <= degree; i++) {
				long double value = 1.0L, slope = 0.0L;

				for (int j = 0; j <= degree; j++) {
					if (j == i)
						continue;
					slope = slope*(x*degree - j)/(i - j) + value*degree/(i - j);
					value *= (x*degree - j)/(i - j);
				}
				t->N[p][g][i] = value;
				t->dN[p][g][i] = slope;
			}
	}
}

/* Sheave at the joint before a piece, or -1. */
static int joint(const struct mesh *t, int piece)
{
	const struct hawser_line_piece *before = &t->st->piece[piece - 1], *behind = &t->st->piece[piece];

	if (before->sheave >= 0 || behind->sheave >= 0)
		return before->sheave >= 0 ? before->sheave : behind->sheave;
	return behind->mass >= 0 && t->st->carrier[behind->mass].state > 0
	       ? t->st->carrier[behind->mass].sheave : -1;
}

static void place(struct mesh *t, double carriage)
{
	t->unknowns = 0;
	t->carriage_mass = carriage;
	t->carriage = carriage > 0.0 ? t->unknowns++ : -1;
	for (int p = 0; p < t->st->pieces; p++) {
		const struct hawser_line_piece *piece = &t->st->piece[p];
		int degree = t->degree[p] = piece->S1 - piece->S0 < 5.0 ? SHORT : LONG;

		t->pendulum[p] = -1;
		for (int i = 0; i <= degree; i++) {
			int end = (p == 0 && i == 0) || (p + 1 == t->st->pieces && i == degree);
			double x[2];

			hawser_line_at(t->st, x, NULL, NULL, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*i/degree);
			t->fixed[p][i][0] = i == 0 ? piece->x0[0] : i == degree ? piece->x1[0] : x[0];
			t->fixed[p][i][1] = i == 0 ? piece->x0[1] : i == degree ? piece->x1[1] : x[1];
			t->fixed[p][i][2] = 0.0L;
			t->circle[p][i] = piece->sheave;
			if (i == 0 && p > 0)
				t->circle[p][0] = joint(t, p);
			if (i == degree && p + 1 < t->st->pieces)
				t->circle[p][degree] = joint(t, p + 1);
			if (i == 0 && p > 0)
				t->at[p][0] = t->at[p - 1][t->degree[p - 1]];
			else
				t->at[p][i] = end ? -1 : t->unknowns;
			if (!end && (i > 0 || p == 0))
				t->unknowns += t->circle[p][i] >= 0 ? 1 : 3;
		}
		if (piece->mass >= 0 && t->line->mass[piece->mass].hanger > 0.0) {
			t->pendulum[p] = t->unknowns;
			t->unknowns += t->circle[p][0] >= 0 ? 1 : 2;
		}
	}
}

/* Position of a node at displacements q, and its derivatives by its unknowns: d[3][3]. */
static void position(number x[3], number d[3][3], const struct mesh *t, int p, int i, const number *q)
{
	int at = t->at[p][i], s = t->circle[p][i];

	memset(d, 0, 9*sizeof d[0][0]);
	for (int c = 0; c < 3; c++)
		x[c] = t->fixed[p][i][c];
	if (at < 0 && p == 0 && t->carriage >= 0) {
		x[0] += q[t->carriage];
		d[0][0] = 1.0L;
	} else if (at >= 0 && s < 0) {
		for (int c = 0; c < 3; c++) {
			x[c] += q[at + c];
			d[c][c] = 1.0L;
		}
	} else if (at >= 0) { /* q is the arc along the circle, positive along the rope */
		const struct hawser_line_sheave *sheave = &t->line->sheave[s];
		number R = sheave->radius, a = -sheave->side*q[at]/R;
		long double r[2] = {x[0] - sheave->centre[0], x[1] - sheave->centre[1]};

		x[0] = sheave->centre[0] + r[0]*ccosl(a) - r[1]*csinl(a);
		x[1] = sheave->centre[1] + r[0]*csinl(a) + r[1]*ccosl(a);
		d[0][0] = -sheave->side/R*(-r[0]*csinl(a) - r[1]*ccosl(a));
		d[0][1] = -sheave->side/R*(r[0]*ccosl(a) - r[1]*csinl(a));
	}
}

static int first_of(const struct mesh *t, int p, int i)
{
	return t->at[p][i] < 0 && p == 0 && i == 0 ? t->carriage : t->at[p][i];
}

static int unknowns_of(const struct mesh *t, int p, int i)
{
	return first_of(t, p, i) < 0 ? 0 : t->at[p][i] < 0 || t->circle[p][i] >= 0 ? 1 : 3;
}

/* Add the force f on a node to the gradient. */
static void pull(number *gradient, const struct mesh *t, int p, int i, const number d[3][3],
                 const number f[3])
{
	for (int k = 0; k < unknowns_of(t, p, i); k++)
		for (int c = 0; c < 3; c++)
			gradient[first_of(t, p, i) + k] += d[k][c]*f[c];
}

/* On an arc the nodes give the arclength along the circle: energy of an angle, not of a chord. */
static void arc_gradient(number *gradient, const struct mesh *t, int p, const number *q)
{
	const struct hawser_line_piece *piece = &t->st->piece[p];
	const struct hawser_line_sheave *sheave = &t->line->sheave[piece->sheave];
	long double L = (long double)piece->S1 - piece->S0, R = sheave->radius;
	number a[NODES];

	for (int i = 0; i <= t->degree[p]; i++) {
		long double x = t->fixed[p][i][0] - sheave->centre[0], y = t->fixed[p][i][1] -
			sheave->centre[1];

		a[i] = -sheave->side*R*atan2l(-sheave->side*x, sheave->side*y) + q[t->at[p][i]];
	}
	for (int g = 0; g < GAUSS; g++) {
		number along = 0.0L, slope = 0.0L, T, weight;

		for (int i = 0; i <= t->degree[p]; i++) {
			along += t->N[p][g][i]*a[i];
			slope += t->dN[p][g][i]*(a[i] - a[0])/L;
		}
		T = t->line->EA*(slope - 1.0L);
		/* y = yc + side R cos(angle), angle = -side along/R */
		weight = -t->line->rho*t->line->g*csinl(along/R)*sheave->side;
		for (int i = 0; i <= t->degree[p]; i++)
			gradient[t->at[p][i]] += t->weight[g]*(T*t->dN[p][g][i] + L*weight*t->N[p][g][i]);
	}
}

static void free_gradient(number *gradient, const struct mesh *t, int p, const number *q)
{
	const struct hawser_line_piece *piece = &t->st->piece[p];
	long double L = (long double)piece->S1 - piece->S0;
	number x[NODES][3], d[NODES][3][3];

	for (int i = 0; i <= t->degree[p]; i++)
		position(x[i], d[i], t, p, i, q);
	for (int g = 0; g < GAUSS; g++) {
		number e[3] = {0.0L}, length, T;

		for (int i = 0; i <= t->degree[p]; i++)
			for (int c = 0; c < 3; c++)
				e[c] += t->dN[p][g][i]*(x[i][c] - x[0][c])/L;
		length = csqrtl(e[0]*e[0] + e[1]*e[1] + e[2]*e[2]);
		T = t->line->EA*(length - 1.0L)/length;
		for (int i = 0; i <= t->degree[p]; i++) {
			number f[3];

			for (int c = 0; c < 3; c++)
				f[c] = t->weight[g]*(T*e[c]*t->dN[p][g][i] +
				                     (c == 1 ? L*t->line->rho*t->line->g*t->N[p][g][i] : 0.0L));
			pull(gradient, t, p, i, d[i], f);
		}
	}
}

static void mass_gradient(number *gradient, const struct mesh *t, int p, const number *q)
{
	const struct hawser_line_mass *mass = &t->line->mass[t->st->piece[p].mass];
	number x[3], d[3][3], f[3] = {0.0L, mass->mass*t->line->g, 0.0L};
	int at = t->pendulum[p];

	position(x, d, t, p, 0, q);
	pull(gradient, t, p, 0, d, f);
	if (at >= 0) { /* the mass is sqrt(h^2 - u^2 - v^2) below the rope, u and v aside */
		int count = t->circle[p][0] >= 0 ? 1 : 2;
		number u = q[at], v = count > 1 ? q[at + 1] : 0.0L, h = mass->hanger;
		number low = csqrtl(h*h - u*u - v*v);

		for (int k = 0; k < count; k++)
			gradient[at + k] += mass->mass*t->line->g*q[at + k]/low;
	}
}

/* 1 if unknown j moves piece p, or -1: any. */
static int moves(const struct mesh *t, int p, int j)
{
	for (int i = 0; i <= t->degree[p]; i++)
		if (j < 0 || (j >= first_of(t, p, i) && j < first_of(t, p, i) + unknowns_of(t, p, i)))
			return 1;
	return t->pendulum[p] >= 0 && j >= t->pendulum[p] && j < t->pendulum[p] + 2;
}

/* Of the pieces that unknown j moves; -1: of all. */
static void gradient_of(number *gradient, const struct mesh *t, const number *q, int j)
{
	memset(gradient, 0, (size_t)t->unknowns*sizeof *gradient);
	for (int p = 0; p < t->st->pieces; p++) {
		if (!moves(t, p, j))
			continue;
		if (t->st->piece[p].sheave >= 0)
			arc_gradient(gradient, t, p, q);
		else
			free_gradient(gradient, t, p, q);
		if (t->st->piece[p].mass >= 0)
			mass_gradient(gradient, t, p, q);
	}
}

static void add_inertia(double *M, const struct mesh *t, int p, int i, int k, double m,
                        const number *q)
{
	number x[3], a[3][3], b[3][3];

	position(x, a, t, p, i, q);
	position(x, b, t, p, k, q);
	for (int r = 0; r < unknowns_of(t, p, i); r++)
		for (int s = 0; s < unknowns_of(t, p, k); s++)
			for (int c = 0; c < 3; c++)
				M[(first_of(t, p, i) + r)*t->unknowns + first_of(t, p, k) + s] +=
					m*(double)creall(a[r][c]*b[s][c]);
}

static void mass_inertia(double *M, const struct mesh *t, int p, const number *q)
{
	const struct hawser_line_mass *mass = &t->line->mass[t->st->piece[p].mass];
	int at = t->pendulum[p], n = t->unknowns, first = first_of(t, p, 0);
	int count = t->circle[p][0] >= 0 ? 1 : 2;
	number x[3], d[3][3];

	add_inertia(M, t, p, 0, 0, mass->mass, q);
	if (at < 0)
		return;
	position(x, d, t, p, 0, q);
	for (int k = 0; k < count; k++) { /* velocities of rope and pendulum add along x and z */
		M[(at + k)*n + at + k] += mass->mass;
		for (int r = 0; r < unknowns_of(t, p, 0); r++) {
			M[(at + k)*n + first + r] += mass->mass*(double)creall(d[r][2*k]);
			M[(first + r)*n + at + k] += mass->mass*(double)creall(d[r][2*k]);
		}
	}
}

static void inertia(double *M, const struct mesh *t, const number *q)
{
	for (int p = 0; p < t->st->pieces; p++) {
		const struct hawser_line_piece *piece = &t->st->piece[p];
		double L = piece->S1 - piece->S0;

		for (int g = 0; g < GAUSS; g++)
			for (int i = 0; i <= t->degree[p]; i++)
				for (int k = 0; k <= t->degree[p]; k++) {
					double m = t->line->rho*L*(double)(t->weight[g]*t->N[p][g][i]*t->N[p][g][k]);

					if (piece->sheave >= 0) /* velocity along the circle */
						M[t->at[p][i]*t->unknowns + t->at[p][k]] += m;
					else
						add_inertia(M, t, p, i, k, m, q);
				}
		if (piece->mass >= 0)
			mass_inertia(M, t, p, q);
	}
	if (t->carriage >= 0)
		M[t->carriage*(t->unknowns + 1)] += t->carriage_mass;
}

/* K: column j is the derivative of the gradient, by a complex step, which has no truncation error and
 * no cancellation (W. Squire, G. Trapp, SIAM Rev. 40 (1998) 110). */
static void differences(long double *K, const struct mesh *t, number *q)
{
	static number g[UNKNOWNS];

	for (int j = 0; j < t->unknowns; j++) {
		q[j] = step*I;
		gradient_of(g, t, q, j);
		q[j] = 0.0L;
		for (int i = 0; i < t->unknowns; i++)
			K[i*t->unknowns + j] = cimagl(g[i])/step;
	}
}

#endif

/* response/torus/torus_growth.c - growth of small differences from an invariant circle.
 *
 *    A(theta)  derivative of the period map along the circle [m][m], known at its N points
 *    q         x'(theta)/|x'(theta)|, which A turns into its own direction at theta + rho
 *    Q         orthonormal directions normal to q, as rows [m - 1][m]
 *
 * A small difference from the motion at theta becomes A(theta) times it, at theta + rho. Along the
 * circle it neither grows nor decays on average, which is the multiplier 1 that every circle has. It is
 * told apart by construction: after each period the directions are made orthogonal to q first, then to
 * each other, and the logarithms of their lengths are averaged with the weights of lyapunov.c, for
 * which the error on a quasi-periodic motion falls faster than every power of the number of periods.
 * The averages are the logarithms of the moduli of the eigenvalues of Jorba's operator, A psi at theta
 * = lambda psi at theta + rho, discretised a matrix of order N m; its eigenvalues form m circles of N,
 * of which only some are accurate. tests/property/test-torus compares both.
 *
 * Error: the difference from half as many periods, and the gap from Liouville's formula: the sum of the
 * exponents is the mean over the circle of log|det A|, without the part along it.
 *
 * Reference: A. Jorba, Nonlinearity 14 (2001) 943; S. Das, Y. Saiki, E. Sander and J. Yorke,
 * Nonlinearity 30 (2017) 4111.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/torus/torus.h"

#define FEWEST 512 /* periods of the first average; chosen */
#define TURNS 16 /* least number of turns of a slow circle in the first average; chosen */
#define MOST 131072 /* periods of the last average; chosen */
#define NUMBERS 4000000 /* logarithms that are stored; chosen */
#define ENOUGH 1e-7 /* difference of two averages; chosen */

struct walk {
	struct hawser__torus *torus;
	int m;
	double *slope;    /* [N][m] x' at the points */
	double *turn;     /* [N][2] cos and sin of pi i/N */
	double *value;    /* [N] cardinal functions */
	double *A;        /* [m][m] at the present theta */
	double *q, *Q, *next; /* [m], [m - 1][m] twice */
	double *g;        /* [most][m - 1] */
};

/* value [N] of the cardinal functions at theta, by the addition theorem. */
static void cardinals(struct walk *walk, double *value, double theta)
{
	int N = walk->torus->points;
	double whole = sin(0.5*N*theta)/N, s = sin(0.5*theta), c = cos(0.5*theta);

	for (int i = 0; i < N; i++, whole = -whole) {
		double half = s*walk->turn[2*i] - c*walk->turn[2*i + 1];

		value[i] = fabs(half) > 1e-3 ? whole/half
		           : hawser__torus_cardinal(N, theta - 2.0*M_PI*i/N, 0);
	}
}

/* A at theta, and q at the end of the period, theta + rho. */
static void place(struct walk *walk, double theta)
{
	const struct hawser__torus *torus = walk->torus;
	int N = torus->points, m = walk->m;

	cardinals(walk, walk->value, theta);
	cblas_dgemv(CblasRowMajor, CblasTrans, N, m*m, 1.0, torus->A, m*m, walk->value, 1, 0.0, walk->A,
	            1);
	cardinals(walk, walk->value, theta + torus->rho);
	cblas_dgemv(CblasRowMajor, CblasTrans, N, m, 1.0, walk->slope, m, walk->value, 1, 0.0, walk->q, 1);
	cblas_dscal(m, 1.0/cblas_dnrm2(m, walk->q, 1), walk->q, 1);
}

/* Q becomes orthonormal and normal to q; the logarithms of the lengths are g [m - 1], unless NULL. */
static void straighten(struct walk *walk, double *g)
{
	int m = walk->m;

	for (int i = 0; i < m - 1; i++) {
		double *row = walk->Q + (size_t)i*m, length;

		for (int pass = 0; pass < 2; pass++) { /* the second removes the round-off of the first */
			cblas_daxpy(m, -cblas_ddot(m, walk->q, 1, row, 1), walk->q, 1, row, 1);
			for (int k = 0; k < i; k++)
				cblas_daxpy(m, -cblas_ddot(m, walk->Q + (size_t)k*m, 1, row, 1),
				            walk->Q + (size_t)k*m, 1, row, 1);
		}
		length = cblas_dnrm2(m, row, 1);
		if (g)
			g[i] = log(length);
		cblas_dscal(m, 1.0/length, row, 1);
	}
}

static void period(struct walk *walk, long k)
{
	int m = walk->m;
	double *swap = walk->next;

	place(walk, fmod(k*walk->torus->rho, 2.0*M_PI));
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m - 1, m, m, 1.0, walk->Q, m, walk->A, m,
	            0.0, walk->next, m);
	walk->next = walk->Q;
	walk->Q = swap;
	straighten(walk, walk->g + (size_t)k*(size_t)(m - 1));
}

/* Unit vectors, of which the one that is nearest to q is left out. */
static void begin(struct walk *walk)
{
	int m = walk->m, out = 0;

	place(walk, -walk->torus->rho);
	for (int j = 1; j < m; j++)
		if (fabs(walk->q[j]) > fabs(walk->q[out]))
			out = j;
	for (int i = 0; i < m - 1; i++)
		walk->Q[(size_t)i*m + (i < out ? i : i + 1)] = 1.0;
	straighten(walk, NULL);
}

/* Averages over `count` periods, of which the first tenth lets the directions settle. */
static void average(double *mean, const struct walk *walk, long count)
{
	long first = count/10;
	int w = walk->m - 1;
	double weights = 0.0;

	memset(mean, 0, (size_t)w*sizeof *mean);
	for (long k = first; k < count; k++) {
		double s = ((double)(k - first) + 0.5)/(double)(count - first);
		double weight = exp(-1.0/(s*(1.0 - s)));

		weights += weight;
		cblas_daxpy(w, weight, walk->g + (size_t)k*(size_t)w, 1, mean, 1);
	}
	cblas_dscal(w, 1.0/weights, mean, 1);
}

/* Mean over the circle of log|det A|; A is overwritten. */
static double liouville(struct walk *walk)
{
	const struct hawser__torus *torus = walk->torus;
	int m = walk->m;
	double sum = 0.0;

	for (int i = 0; i < torus->points; i++) {
		memcpy(walk->A, torus->A + (size_t)i*m*m, (size_t)m*(size_t)m*sizeof *walk->A);
		(void)LAPACKE_dgetrf(LAPACK_ROW_MAJOR, m, m, walk->A, m, torus->pivot);
		for (int j = 0; j < m; j++)
			sum += log(fabs(walk->A[(size_t)j*m + j]))/torus->points;
	}
	return sum;
}

int hawser__torus_growth(struct hawser__torus *torus, double *exponent, double *error)
{
	size_t m = (size_t)torus->m, w = m - 1, N = (size_t)torus->points;
	double *memory, *before, gap = 0.0;
	struct walk walk = {.torus = torus, .m = torus->m};
	long done = 0, count = FEWEST, most = MOST;
	double slow = fabs(remainder(torus->rho/(2.0*M_PI), 1.0));

	while (most*(long)w > NUMBERS)
		most /= 2;
	while (count*slow < TURNS && 4*count <= most)
		count *= 2;
	memory = calloc(N*(m + 3) + 3*m*m + 2*m + (size_t)most*w, sizeof *memory);
	if (!memory)
		return 1;
	walk.slope = memory;
	walk.A = memory + N*m;
	walk.Q = walk.A + m*m;
	walk.next = walk.Q + m*m;
	walk.q = walk.next + m*m;
	before = walk.q + m;
	walk.turn = before + m;
	walk.value = walk.turn + 2*N;
	walk.g = walk.value + N;
	for (size_t i = 0; i < N; i++) {
		walk.turn[2*i] = cos(M_PI*(double)i/(double)N);
		walk.turn[2*i + 1] = sin(M_PI*(double)i/(double)N);
	}
	hawser__torus_shifted(walk.slope, torus, 0.0, 1);
	begin(&walk);
	for (int round = 0;; round++, count *= 2) {
		memcpy(before, exponent, w*sizeof *before);
		for (; done < count; done++)
			period(&walk, done);
		average(exponent, &walk, count);
		*error = 0.0;
		for (size_t i = 0; i < w; i++)
			*error = fmax(*error, fabs(exponent[i] - before[i]));
		if ((round > 0 && *error < ENOUGH) || 2*count > most)
			break;
	}
	for (size_t i = 0; i < w; i++)
		gap += exponent[i];
	*error += fabs(gap - liouville(&walk));
	for (size_t i = 1; i < w; i++) /* neighbours may be out of order */
		for (size_t k = i; k > 0 && exponent[k] > exponent[k - 1]; k--) {
			double kept = exponent[k];

			exponent[k] = exponent[k - 1];
			exponent[k - 1] = kept;
		}
	free(memory);
	return 0;
}

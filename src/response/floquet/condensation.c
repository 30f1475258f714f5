/* response/floquet/condensation.c - the slow manifold of variational equations, by iteration of its
 * equation (symbols as in monodromy_condense.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/floquet/condensation.h"

#define SINGULAR 1e-8      /* ratio of a pivot of K_ff to the mean below which it counts as 0: far
                            * above round-off */
#define ITERATIONS 12      /* largest number; chosen */

/* Whether the pivots of K_ff at one phase, in its factor U, are safely positive. The mean of K_ff
 * is positive (hawser__fast_separate), so that if K_ff is not positive at one phase, it is singular
 * at another. A pivot that is 0 but for round-off must not count as positive with any BLAS kernel:
 * the limit is far above the round-off of the largest entry. */
static int positive(const double *factor, int stride, const struct hawser__monodromy *monodromy,
                    const struct hawser__block *block)
{
	for (int f = 0; f < block->nf; f++) {
		double mean = monodromy->frequency[monodromy->fast[block->f + f]];
		double pivot = factor[(size_t)f*stride + f];

		if (!(pivot*pivot > SINGULAR*mean*mean))
			return 0;
	}
	return 1;
}

/* The inverse of K_ff at one phase; returns 1 if K_ff is singular, or symmetric and not positive. */
int hawser__condense_invert(const struct hawser__condensation *work,
                            const struct hawser__monodromy *monodromy,
                            const struct hawser__block *block, int row)
{
	int n = work->n, stride = work->nf, nf = block->nf, first = work->ns + block->f;
	const double *K_ff = work->K + (size_t)row*n*n + (size_t)first*(n + 1);
	double *inverse = work->inverse + (size_t)row*stride*stride + (size_t)block->f*(stride + 1);

	for (int f = 0; f < nf; f++)
		memcpy(inverse + (size_t)f*stride, K_ff + (size_t)f*n, nf*sizeof(double));
	if (!work->symmetric) /* the transpose of the inverse is the inverse of the transpose */
		return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, nf, nf, inverse, stride, work->pivot) ||
		       LAPACKE_dgetri_work(LAPACK_COL_MAJOR, nf, inverse, stride, work->pivot,
		                           work->part, nf);
	if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', nf, inverse, stride) ||
	    !positive(inverse, stride, monodromy, block) ||
	    LAPACKE_dpotri_work(LAPACK_COL_MAJOR, 'U', nf, inverse, stride))
		return 1;
	for (int f = 0; f < nf; f++)
		for (int e = 0; e < f; e++)
			inverse[(size_t)e*stride + f] = inverse[(size_t)f*stride + e];
	return 0;
}

/* out [rows][2 ns] += factor a b; a has as many columns a row as `stride`. */
static void add_product(const struct hawser__block *block, double *out, double factor,
                        const double *a, int stride, int rows, int inner, const double *b)
{
	if (block->ns == 0) /* a matrix without columns is an error of the reference BLAS */
		return;
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, 2*block->ns, inner, factor, a,
	            stride, b, 2*block->ns, 1.0, out, 2*block->ns);
}

/* N at one phase; returns its change relative to the squared frequency `top` (columns of x_s) and to
 * top (columns of x_s'). */
static double reduce(const struct hawser__condensation *work, const struct hawser__block *block,
                     int row, double top)
{
	int n = work->n, ns = block->ns, nf = block->nf;
	size_t corner = (size_t)block->s*n, at = (size_t)row*work->wide_F + block->F;
	const double *K = work->K + (size_t)row*n*n + corner, *D = work->D + row*work->next_D + corner;
	double *N = work->N + (size_t)row*work->wide_N + block->N;
	double *before = work->before + (size_t)row*work->wide_N + block->N;
	double change[2] = {0.0, 0.0};

	memcpy(before, N, 2*(size_t)ns*ns*sizeof(double));
	for (int s = 0; s < ns; s++) {
		memcpy(N + 2*(size_t)s*ns, K + (size_t)s*n + block->s, ns*sizeof(double));
		memcpy(N + 2*(size_t)s*ns + ns, D + (size_t)s*n + block->s, ns*sizeof(double));
	}
	add_product(block, N, 1.0, K + work->ns + block->f, n, ns, nf, work->F + at);
	if (!work->apart)
		add_product(block, N, 1.0, D + work->ns + block->f, n, ns, nf, work->F1 + at);
	for (int half = 0; half < 2*ns; half++)
		for (int e = half*ns; e < (half + 1)*ns; e++) {
			double moved = fabs(N[e] - before[e]);

			if (moved > change[half%2])
				change[half%2] = moved;
		}
	return fmax(change[0]/(top*top), change[1]/top);
}

/* out [nf][2 ns] = rate + F Y, the derivative of F y in time at one phase. */
static void derive(const struct hawser__condensation *work, const struct hawser__block *block,
                   double *out, const double *F, int row)
{
	int ns = block->ns, nf = block->nf;
	const double *rate = work->rate + (size_t)row*work->wide_F + block->F;

	if (out != rate)
		memcpy(out, rate, 2*(size_t)nf*ns*sizeof(double));
	for (int f = 0; f < nf; f++)
		cblas_daxpy(ns, 1.0, F + 2*(size_t)f*ns, 1, out + (2*(size_t)f + 1)*ns, 1);
	add_product(block, out, -1.0, F + ns, 2*ns, nf, ns,
	            work->N + (size_t)row*work->wide_N + block->N);
}

/* F at one phase from F_2 [nf][2 ns], which is overwritten, and F_1. */
static void follow(const struct hawser__condensation *work, const struct hawser__block *block,
                   double *F2, int row)
{
	int n = work->n, ns = block->ns, nf = block->nf;
	size_t corner = (size_t)(work->ns + block->f)*n, at = (size_t)row*work->wide_F + block->F;
	const double *K = work->K + (size_t)row*n*n + corner, *D = work->D + row*work->next_D + corner;
	const double *inverse = work->inverse + (size_t)row*work->nf*work->nf;

	for (int f = 0; f < nf; f++) {
		cblas_daxpy(ns, 1.0, K + (size_t)f*n + block->s, 1, F2 + 2*(size_t)f*ns, 1);
		cblas_daxpy(ns, 1.0, D + (size_t)f*n + block->s, 1, F2 + (2*(size_t)f + 1)*ns, 1);
	}
	if (!work->apart)
		add_product(block, F2, 1.0, D + work->ns + block->f, n, nf, nf, work->F1 + at);
	for (int f = 0; f < nf && work->apart; f++)
		cblas_daxpy(2*ns, D[(size_t)f*(n + 1) + work->ns + block->f],
		            work->F1 + at + 2*(size_t)f*ns, 1, F2 + 2*(size_t)f*ns, 1);
	memset(work->F + at, 0, 2*(size_t)nf*ns*sizeof(double));
	add_product(block, work->F + at, -1.0, inverse + (size_t)block->f*(work->nf + 1), work->nf, nf,
	            nf, F2);
}

/* The static response, which has no part of x_s'. */
static void follow_at_rest(const struct hawser__condensation *work,
                           const struct hawser__block *block, int row)
{
	int n = work->n, ns = block->ns, nf = block->nf;
	double *F = work->F + (size_t)row*work->wide_F + block->F;
	const double *K_fs = work->K + ((size_t)row*n + work->ns + block->f)*n + block->s;
	const double *inverse = work->inverse + (size_t)row*work->nf*work->nf;

	memset(F, 0, 2*(size_t)nf*ns*sizeof(double));
	if (ns > 0) /* see add_product */
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, nf, ns, nf, -1.0,
		            inverse + (size_t)block->f*(work->nf + 1), work->nf, K_fs, n, 0.0, F, 2*ns);
}

/* F from that of the last iteration, its derivatives and N, at one phase: the first derivative
 * (0), then F itself (1). */
static void iterate(const struct hawser__condensation *work, const struct hawser__block *block,
                    int row, int second)
{
	size_t at = (size_t)row*work->wide_F + block->F;

	if (!second) {
		derive(work, block, work->F1 + at, work->F + at, row);
		return;
	}
	derive(work, block, work->rate + at, work->F1 + at, row);
	follow(work, block, work->rate + at, row);
}

/* The largest change of N over all phases. */
static double reduce_all(const struct hawser__condensation *work, double top)
{
	double change = 0.0;

	for (int i = 0; i < work->rows; i++)
		for (int b = 0; b < work->blocks; b++)
			change = fmax(change, reduce(work, &work->block[b], i, top));
	return change;
}

/* Iterates F from the static response, until N changes by less than `goal` or no longer less.
 * Returns the last change of N. */
double hawser__condense_settle(const struct hawser__condensation *work,
                               const struct hawser__monodromy *monodromy, double omega, double goal)
{
	double change, last = INFINITY, top = monodromy->top;

	memset(work->N, 0, work->rows*work->wide_N*sizeof(double));
	memset(work->F1, 0, work->rows*work->wide_F*sizeof(double));
	for (int i = 0; i < work->rows; i++)
		for (int b = 0; b < work->blocks; b++)
			follow_at_rest(work, &work->block[b], i);
	reduce_all(work, top);
	if (work->wide_F == 0) /* nothing that is condensed is coupled to anything that is kept */
		return 0.0;
	for (int k = 0; k < ITERATIONS; k++) {
		for (int second = 0; second < 2; second++) {
			cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, work->rows,
			            (int)work->wide_F, work->rows, omega, work->turn, work->rows,
			            second ? work->F1 : work->F, (int)work->wide_F, 0.0, work->rate,
			            (int)work->wide_F);
			for (int i = 0; i < work->rows; i++)
				for (int b = 0; b < work->blocks; b++)
					iterate(work, &work->block[b], i, second);
		}
		change = reduce_all(work, top);
		if (change < goal || !(change < last))
			return change;
		last = change;
	}
	return last;
}

/* response/floquet/half_multipliers.c - see half.h.
 *
 *    A, b   derivatives of the end of the half period by its start and by Omega
 *    M      monodromy matrix R A^-1 R A, since the second half period has the matrix R A^-1 R
 *    f      direction of the motion at phase 0: b is a multiple of A f
 *    g      direction from a motion of the curve to the next one, from the curve's tangent
 *
 * M f = f, since the start of the motion is free, and M g = g + c f, since the next motion has another
 * period: two multipliers are 1 and have one eigenvector. An error of M moves them by its square root,
 * 1e-6 and more, which is far above the error of the others, and is easily taken for an unstable one.
 * The space of f and g is therefore split off: with Q = [f g | W] orthogonal, Q'MQ has zeros below its
 * first two columns, and the other multipliers are the eigenvalues of W'MW. R reverses f and keeps g,
 * so that the two are independent.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/torus/circle.h"
#include "response/floquet/half.h"

static const char where[] = "backbone";

/* Error of the derivatives of the half-period map over that of its orbit, which is that of integration
 * and the residual; an estimate. */
#define DERIVATIVES 10.0
#define ROUND_OFF 1e-13 /* of the entries of the monodromy matrix */

static void reflect(const struct hawser__half *half, double *whole)
{
	int n = half->base.n, m = 2*n;

	for (int j = 0; j < m; j++)
		for (int k = 0; k < m; k++)
			whole[(size_t)j*m + k] *= j < n ? half->sign[j] : -half->sign[j - n];
}

/* whole [m][m] = M, row-major, and the factors of A. Returns LAPACK's info. */
static int monodromy(const struct hawser__half *half, double *whole, double *factors, int *pivot)
{
	int m = 2*half->base.n, info;

	memcpy(factors, half->A, (size_t)m*(size_t)m*sizeof *factors);
	memcpy(whole, half->A, (size_t)m*(size_t)m*sizeof *factors);
	reflect(half, whole);
	info = LAPACKE_dgesv(LAPACK_ROW_MAJOR, m, m, factors, m, pivot, whole, m);
	reflect(half, whole);
	return info;
}

/* pair [2][m]: f and g, with the factors of A. */
static int trivial(const struct hawser__half *half, double *pair, const double *factors,
                   const int *pivot, const double *t)
{
	int n = half->base.n, m = 2*n;
	double omega = half->y[n], *next = pair + m;

	memcpy(pair, half->b, (size_t)m*sizeof *pair);
	for (int j = 0; j < n; j++) {
		next[j] = half->sign[j] < 0 ? 0.0 : t[j];
		next[n + j] = half->sign[j] < 0 ? t[j]*omega + half->y[j]*t[n] : 0.0;
	}
	return LAPACKE_dgetrs(LAPACK_ROW_MAJOR, 'N', m, 1, factors, m, pivot, pair, 1);
}

/* Factor on displacement j, with which a linear free motion has displacements as large as its
 * velocities, so that the entries of M have one size. */
static double unit_of(const struct hawser__half *half, int j)
{
	double k = half->model.K[(size_t)j*((size_t)half->base.n + 1)];

	return k > 0.0 ? sqrt(k) : half->y[half->base.n];
}

static void equalise(const struct hawser__half *half, double *whole, double *pair)
{
	int n = half->base.n, m = 2*n;

	for (int j = 0; j < n; j++) {
		double unit = unit_of(half, j);

		pair[j] *= unit;
		pair[m + j] *= unit;
		for (int k = 0; k < m; k++) {
			whole[(size_t)j*m + k] *= unit;
			whole[(size_t)k*m + j] /= unit;
		}
	}
	for (int i = 0; i < 2; i++) {
		double length = cblas_dnrm2(m, pair + (size_t)i*m, 1);

		cblas_dscal(m, 1.0/length, pair + (size_t)i*m, 1);
	}
}

/* whole becomes Q'MQ, row-major; pair is lost. */
static int split(double *whole, double *pair, double *tau, int m)
{
	int info = LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, 2, pair, m, tau);

	if (!info)
		info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'R', 'N', m, m, 2, pair, m, tau, whole, m);
	return info ? info
	            : LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'T', m, m, 2, pair, m, tau, whole, m);
}

/* size: of the entries of the matrix, whose round-off may be more than the multipliers on the circle:
 * then those that are larger are counted. */
static int count_outside(double *re, double *im, int count, double loss, double size)
{
	for (int i = 0; i < count; i++) {
		double angle = atan2(im[i], re[i]);

		re[i] = log(hypot(re[i], im[i]));
		im[i] = angle;
	}
	return hawser__circle_count(NULL, re, im, count, loss, log1p(ROUND_OFF*size)).unstable;
}

enum hawser_status hawser__half_unstable(const struct hawser__half *half, int *unstable,
                                         const double *t, double residual,
                                         struct hawser_report *report)
{
	double loss = DERIVATIVES*(half->base.mesh/half->base.X + residual) + ROUND_OFF, size = 0.0;
	int m = 2*half->base.n, rest = m - 2, info;
	size_t square = (size_t)m*(size_t)m;
	double *whole = malloc((2*square + 4*(size_t)m)*sizeof *whole), *pair, *re, *im;
	int *pivot = malloc((size_t)m*sizeof *pivot);

	*unstable = 0;
	if (!whole || !pivot) {
		free(whole);
		free(pivot);
		return hawser__no_memory(report, where);
	}
	pair = whole + 2*square;
	re = pair + 2*m;
	im = re + m;
	info = monodromy(half, whole, whole + square, pivot);
	if (!info)
		info = trivial(half, pair, whole + square, pivot, t);
	if (!info) {
		equalise(half, whole, pair);
		size = fabs(whole[cblas_idamax((int)square, whole, 1)]);
		info = split(whole, pair, re, m);
	}
	if (!info && rest > 0)
		info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', rest, whole + 2*(size_t)m + 2, m, re, im,
		                     NULL, rest, NULL, rest);
	if (!info)
		*unstable = count_outside(re, im, rest, loss, size);
	free(whole);
	free(pivot);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, where);
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
	                           "the multipliers of a free motion were not found")
	            : HAWSER_OK;
}

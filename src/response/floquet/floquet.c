/* response/floquet/floquet.c - Floquet multipliers from a product of transition matrices.
 *
 * The monodromy matrix is M = A[s-1] ... A[0]. If the product is formed, all multipliers that are
 * smaller than round-off times the largest are lost (those of a strongly damped mode beside a
 * lightly damped one). The periodic QR algorithm (Bojanczyk, Golub and Van Dooren 1992; Kressner
 * 2001; SLICOT MB03VD, MB03BD) finds orthogonal Z_i with Z_{i+1}' A_i Z_i triangular, one of them
 * quasi-triangular. It returns each multiplier with a separate exponent, so that none under- or
 * overflows. MB03WD is not used: with 16 factors or more it sets nonzero entries to zero, and the
 * first digits of complex pairs are wrong (tests/unit/test-floquet.c).
 *
 * Row-major A_i read in column-major order is A_i'; M' = A[0]' ... A[s-1]' has the same
 * eigenvalues, so the segments are passed as they are, first factor first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/floquet.h"

void mb03vd_(const int *n, const int *p, const int *ilo, const int *ihi, double *a, const int *lda1,
             const int *lda2, double *tau, const int *ldtau, double *dwork, int *info);
void mb03bd_(const char *job, const char *defl, const char *compq, const int *qind, const int *k,
             const int *n, const int *h, const int *ilo, const int *ihi, const int *s, double *a,
             const int *lda1, const int *lda2, double *q, const int *ldq1, const int *ldq2,
             double *alphar, double *alphai, double *beta, int *scal, int *iwork,
             const int *liwork, double *dwork, const int *ldwork, int *iwarn, int *info,
             size_t job_len, size_t defl_len, size_t compq_len);

static int real_work(int segments, int m)
{
	return segments + (2*m > 8*segments ? 2*m : 8*segments);
}

/* Number of factors to which a product is reduced: more of them cost time and hardly ever save a
 * digit. */
enum { MOST = 64 };
#define SMALLEST (-1e5) /* smallest logarithm of a multiplier; chosen, so that all logarithms are
                         * finite */

size_t hawser__floquet_work(int segments, int m)
{
	/* tau, dwork of both routines, alphar, alphai, beta; then s, iwork, scal, which are integers */
	return (size_t)segments*(size_t)m + (size_t)real_work(segments, m) + 3*(size_t)m +
	       3*(size_t)segments + 2*(size_t)m;
}

/* Below the Hessenberg (first factor) or triangular (others) part MB03VD leaves its reflectors. */
static void drop_reflectors(double *segment, int segments, int m)
{
	for (int s = 0; s < segments; s++)
		for (int col = 0; col < m; col++)
			for (int row = col + (s == 0 ? 2 : 1); row < m; row++)
				segment[(size_t)s*m*m + (size_t)col*m + row] = 0.0;
}

/* Entry (row, col) of factor s, column-major. */
static double at(const double *segment, int m, int s, int row, int col)
{
	return segment[(size_t)s*m*m + (size_t)col*m + row];
}

static double log_real(const double *segment, int segments, int m, int i)
{
	double sum = 0.0;

	for (int s = 0; s < segments; s++)
		sum += log(fabs(at(segment, m, s, i, i)));
	return sum;
}

static int sign_of(const double *segment, int segments, int m, int i)
{
	int sign = 1;

	for (int s = 0; s < segments; s++)
		if (at(segment, m, s, i, i) < 0.0)
			sign = -sign;
	return sign;
}

/* Determinant of the 2 by 2 diagonal block at i of factor s; only the first factor's is full. */
static double block_determinant(const double *segment, int m, int s, int i)
{
	double det = at(segment, m, s, i, i)*at(segment, m, s, i + 1, i + 1);

	return s ? det : det - at(segment, m, s, i, i + 1)*at(segment, m, s, i + 1, i);
}

/* Trace of the product of the blocks at i over exp(*scale): the product is kept at size 1. */
static double block_trace(double *scale, const double *segment, int segments, int m, int i)
{
	double p[4] = {1.0, 0.0, 0.0, 1.0};

	*scale = 0.0;
	for (int s = 0; s < segments; s++) {
		double a = at(segment, m, s, i, i), b = at(segment, m, s, i, i + 1);
		double c = s ? 0.0 : at(segment, m, s, i + 1, i), d = at(segment, m, s, i + 1, i + 1);
		double q[4] = {p[0]*a + p[1]*c, p[0]*b + p[1]*d, p[2]*a + p[3]*c, p[2]*b + p[3]*d};
		double size = fmax(fmax(fabs(q[0]), fabs(q[1])), fmax(fabs(q[2]), fabs(q[3])));

		for (int e = 0; e < 4; e++)
			p[e] = size > 0.0 ? q[e]/size : 0.0;
		*scale += size > 0.0 ? log(size) : 0.0;
	}
	return p[0] + p[3];
}

/* The two multipliers of a block, from its trace and the logarithm of its determinant: nothing
 * under- or overflows, and the smaller of two real ones is not computed as a difference. */
static void read_block(double *log_modulus, double *argument, const double *segment, int segments,
                       int m, int i)
{
	double scale, trace = block_trace(&scale, segment, segments, m, i), log_det = 0.0, gap;
	int sign = 1;

	for (int s = 0; s < segments; s++) {
		double det = block_determinant(segment, m, s, i);

		log_det += log(fabs(det));
		if (det < 0.0)
			sign = -sign;
	}
	gap = trace*trace/4.0 - sign*exp(log_det - 2.0*scale);
	if (gap < 0.0) {
		log_modulus[i] = log_modulus[i + 1] = log_det/2.0;
		argument[i] = atan2(sqrt(-gap), trace/2.0);
		argument[i + 1] = -argument[i];
		return;
	}
	log_modulus[i] = log(fabs(trace)/2.0 + sqrt(gap)) + scale;
	/* the block has underflowed */
	log_modulus[i + 1] = isinf(log_det) ? -INFINITY : log_det - log_modulus[i];
	argument[i] = trace < 0.0 ? M_PI : 0.0;
	argument[i + 1] = (trace < 0.0) != (sign < 0) ? M_PI : 0.0;
}

static void read_schur(double *log_modulus, double *argument, const double *segment, int segments,
                       int m)
{
	for (int i = 0; i < m; i++) {
		if (i + 1 < m && at(segment, m, 0, i + 1, i) != 0.0) {
			read_block(log_modulus, argument, segment, segments, m, i);
			i++;
		} else {
			log_modulus[i] = log_real(segment, segments, m, i);
			argument[i] = sign_of(segment, segments, m, i) < 0 ? M_PI : 0.0;
		}
	}
}

/* Scale every factor to size 1 by powers of two, since the routine forms products for its shifts.
 * Returns the logarithm of the product of the scales. */
static double scale_factors(double *segment, int segments, int m)
{
	size_t block = (size_t)m*m;
	double taken = 0.0;

	for (int s = 0; s < segments; s++) {
		double *factor = segment + (size_t)s*block, size = 0.0;
		int exponent;

		for (size_t e = 0; e < block; e++)
			size = fmax(size, fabs(factor[e]));
		frexp(size, &exponent);
		for (size_t e = 0; e < block; e++)
			factor[e] = ldexp(factor[e], -exponent);
		taken += exponent*M_LN2;
	}
	return taken;
}

/* A conjugate pair counts as one item of width 2. */
static int width(const double *argument, int i)
{
	return argument[i] != 0.0 && fabs(argument[i]) < M_PI ? 2 : 1;
}

/* Insertion sort by falling modulus that moves pairs whole; m is small. */
void hawser__floquet_sort(double *log_modulus, double *argument, double *kind, int m)
{
	for (int i = 0, w; i < m; i += w) {
		double modulus = log_modulus[i], angle[2] = {argument[i], 0.0}, own = kind ? kind[i] : 0.0;
		int to = i;

		w = width(argument, i);
		if (w == 2)
			angle[1] = argument[i + 1];
		while (to > 0 && log_modulus[to - 1] < modulus)
			to--;
		for (int k = i - 1; k >= to; k--) {
			log_modulus[k + w] = log_modulus[k];
			argument[k + w] = argument[k];
			if (kind)
				kind[k + w] = kind[k];
		}
		for (int k = 0; k < w; k++) {
			log_modulus[to + k] = modulus;
			argument[to + k] = angle[k];
			if (kind)
				kind[to + k] = own;
		}
	}
}

enum hawser_status hawser__floquet(double *log_modulus, double *argument, double *segment,
                                   int segments, int m, double *work, struct hawser_report *report)
{
	const int one = 1, none = 0;
	double *tau = work, *dwork = tau + (size_t)segments*(size_t)m;
	double *alpha = dwork + real_work(segments, m), unused = 0.0;
	double taken = scale_factors(segment, segments, m);
	/* cppcheck-suppress invalidPointerCast ; memory of malloc, and ints alone */
	int *s = (int *)(alpha + 3*(size_t)m), *iwork = s + segments, *scal = iwork + 2*segments + m;
	int ldtau = m > 1 ? m - 1 : 1, ldwork = real_work(segments, m), liwork = 2*segments + m;
	int info = 0, warning = 0;

	for (int i = 0; i < segments; i++)
		s[i] = 1;
	mb03vd_(&m, &segments, &one, &m, segment, &m, &m, tau, &ldtau, dwork, &info);
	drop_reflectors(segment, segments, m);
	if (!info)
		mb03bd_("S", "C", "N", &none, &segments, &m, &one, &one, &m, s, segment, &m, &m, &unused,
		        &one, &one, alpha, alpha + m, alpha + 2*m, scal, iwork, &liwork, dwork, &ldwork,
		        &warning, &info, 1, 1, 1);
	if (info) /* a warning refers to the routine's own values for 2 by 2 blocks, which are not used */
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "floquet", info, 0.0,
		                       "the periodic QR algorithm for the Floquet multipliers did "
		                       "not converge (%d factors of order %d, info %d)", segments, m,
		                       info);
	read_schur(log_modulus, argument, segment, segments, m);
	/* -inf is replaced by a finite number, since the continuation uses differences */
	for (int i = 0; i < m; i++) {
		log_modulus[i] += taken;
		if (log_modulus[i] < SMALLEST) {
			log_modulus[i] = SMALLEST;
			argument[i] = 0.0;
		}
	}
	hawser__floquet_sort(log_modulus, argument, NULL, m);
	return HAWSER_OK;
}

/* next = factor*product, then product = next. */
static void multiply(double *product, double *next, const double *factor, int m)
{
	for (int r = 0; r < m; r++)
		for (int c = 0; c < m; c++) {
			double sum = 0.0;

			for (int i = 0; i < m; i++)
				sum += factor[r*m + i]*product[i*m + c];
			next[r*m + c] = sum;
		}
	memcpy(product, next, (size_t)m*m*sizeof *product);
}

/* Multiply neighbours until MOST factors are left; room is [2][m][m]. Returns their number. Such a
 * product loses what is smaller than round-off times its largest entry. This is harmless as long as
 * one part in MOST of the period does not damp by 1e-16. */
static int gather(double *segment, int segments, int m, double *room)
{
	size_t square = (size_t)m*m;

	if (segments <= MOST)
		return segments;
	for (int f = 0; f < MOST; f++) {
		int from = (int)((long)f*segments/MOST), end = (int)((long)(f + 1)*segments/MOST);

		memcpy(room, segment + (size_t)from*square, square*sizeof *room);
		for (int s = from + 1; s < end; s++)
			multiply(room, room + square, segment + (size_t)s*square, m);
		memcpy(segment + (size_t)f*square, room, square*sizeof *room);
	}
	return MOST;
}

enum hawser_status hawser_floquet_product(double *log_modulus, double *argument, double *segment,
                                          int segments, int m, struct hawser_report *report)
{
	enum hawser_status status;
	size_t size;
	double *work;

	if (segments < 1 || m < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "floquet",
		                    "%d segments of order %d: both must be 1 or more", segments, m);
	for (size_t i = 0; i < (size_t)segments*m*m; i++)
		if (!isfinite(segment[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, "floquet",
			                    "segment matrix entry %zu is %g", i, segment[i]);
	size = hawser__floquet_work(segments < MOST ? segments : MOST, m);
	work = calloc(size + 2*(size_t)m*m, sizeof *work);
	if (!work)
		return hawser__no_memory(report, "floquet");
	segments = gather(segment, segments, m, work + size);
	status = hawser__floquet(log_modulus, argument, segment, segments, m, work, report);
	free(work);
	return status;
}

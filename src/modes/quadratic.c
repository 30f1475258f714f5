/* modes/quadratic.c - eigenvalues of M q'' + B q' + K q = 0, B = C + G.
 *
 *   M = N N'         Cholesky factor; then p = N'q, B := N^-1 B N^-T, K := N^-1 K N^-T, M = 1
 *   gamma            sqrt|K|: lambda = gamma mu evens out the norms of mu^2 + (B/gamma) mu +
 *                    K/gamma^2 (H.-Y. Fan, W.-W. Lin, P. Van Dooren, SIAM J. Matrix Anal. Appl. 26
 *                    (2004) 252)
 *   P(lambda)        lambda^2 + lambda B + K
 *   x, y             right and left vector: P x = 0, y*P = 0
 *
 * Three routes, by what there is to build on:
 *
 *  definite     B skew, K = L L': (L'q, q') turns by a skew matrix; the eigenvalues of i times its
 *               inverse, which is Hermitian, are 1/omega. No real part, however it is rounded.
 *  Hamiltonian  B skew, K of any sign: with p = q' + (B/2) q the matrix [-B/2, 1; -(K + B'B/4),
 *               -B/2] of (q, p) is Hamiltonian. SLICOT's MB03XD (symplectic URV, periodic Schur) is
 *               backward stable and keeps the pairs +-lambda exact, so what leaves the imaginary
 *               axis, leaves it in a pair that met. A general solver sees sqrt(u) of growth at
 *               every such meeting.
 *  damped       the companion matrix, balanced, by LAPACK.
 *
 * Then each eigenvalue is refined by two-sided inverse iteration, lambda -= y*P x/(y*P'x), which
 * has the backward error of the problem itself and not that of its linearisation; in the first two
 * routes along the axis it lies on, where P is Hermitian on the imaginary one, so that y = x. It
 * keeps the digits of low eigenvalues of a graded problem (a diagonal K from 1 to 1/epsilon), which
 * linearisations lose; the condition is therefore by entries, |y|'(|lambda|^2 + |lambda B| +
 * |K|)|x|/|lambda y*P'x| (D. J. Higham, N. J. Higham, SIAM J. Matrix Anal. Appl. 20 (1998) 493),
 * the residual F. Tisseur's backward error (Linear Algebra Appl. 309 (2000) 339) in Frobenius'
 * norm.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <complex.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/quadratic.h"

enum { STEPS = 4 };
static const char where[] = "eigenvalues";
/* A correction larger than this, relative, says that the eigenvalue is not one by itself. */
static const double farthest = 1e-3;

/* SLICOT, Fortran conventions. */
void mb03xd_(const char *balance, const char *job, const char *jobu, const char *jobv, const int *n,
             double *a, const int *lda, double *qg, const int *ldqg, double *t, const int *ldt,
             double *u1, const int *ldu1, double *u2, const int *ldu2, double *v1, const int *ldv1,
             double *v2, const int *ldv2, double *wr, double *wi, int *ilo, double *scale,
             double *dwork, const int *ldwork, int *info, size_t l1, size_t l2, size_t l3, size_t l4);

/* Matrices row-major, scaled: M = 1, |K| = 1. */
struct work {
	int n;
	double gamma;
	double *N;         /* [n][n] lower factor of M, or NULL */
	double *B, *K;     /* [n][n] */
	double normB, normK;
	double *a;         /* [2n][2n] and more: what LAPACK overwrites */
	double complex *h; /* [2n][2n] */
	double complex *z; /* [n] vectors x, y and two more of work */
	double *wr, *wi;   /* [2n] */
	lapack_int *pivot; /* [2n] */
};

static void work_clear(struct work *w)
{
	free(w->N);
	free(w->B);
	free(w->K);
	free(w->a);
	free(w->h);
	free(w->z);
	free(w->wr);
	free(w->wi);
	free(w->pivot);
}

static int work_init(struct work *w, const struct hawser__quadratic *problem)
{
	size_t n = (size_t)problem->n, square = n*n;

	*w = (struct work){.n = problem->n};
	if (problem->M)
		w->N = malloc(square*sizeof *w->N);
	w->B = calloc(square, sizeof *w->B);
	w->K = malloc(square*sizeof *w->K);
	w->a = malloc((8*square + 32*n + 64)*sizeof *w->a);
	w->h = malloc(4*square*sizeof *w->h);
	w->z = malloc(4*n*sizeof *w->z);
	w->wr = malloc(2*n*sizeof *w->wr);
	w->wi = malloc(2*n*sizeof *w->wi);
	w->pivot = malloc(2*n*sizeof *w->pivot);
	return (w->N || !problem->M) && w->B && w->K && w->a && w->h && w->z && w->wr && w->wi && w->pivot;
}

/* --- to M = 1 and |K| = 1 --- */

/* A := N^-1 A N^-T. */
static void reduce(double *A, const struct work *w)
{
	if (!w->N)
		return;
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, w->n, w->n, 1.0,
	            w->N, w->n, A, w->n);
	cblas_dtrsm(CblasRowMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, w->n, w->n, 1.0,
	            w->N, w->n, A, w->n);
}

/* What is symmetric or skew is made so again, which the two solves spoil in the last digits. */
static void even_out(double *A, int n, double sign)
{
	for (int i = 0; i < n; i++)
		for (int j = 0; j <= i; j++) {
			double mean = 0.5*(A[i*n + j] + sign*A[j*n + i]);

			A[i*n + j] = mean;
			A[j*n + i] = sign*mean;
		}
}

static enum hawser_status prepare(struct work *w, const struct hawser__quadratic *problem,
                                  struct hawser_report *report)
{
	int n = w->n, square = n*n;

	if (problem->M) {
		memcpy(w->N, problem->M, (size_t)square*sizeof *w->N);
		if (LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'L', n, w->N, n))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the mass matrix is not positive: a kinetic energy has to be");
	}
	memcpy(w->K, problem->K, (size_t)square*sizeof *w->K);
	reduce(w->K, w);
	even_out(w->K, n, 1.0);
	if (problem->G) {
		memcpy(w->B, problem->G, (size_t)square*sizeof *w->B);
		reduce(w->B, w);
		even_out(w->B, n, -1.0);
	}
	if (problem->C) {
		memcpy(w->a, problem->C, (size_t)square*sizeof *w->a);
		reduce(w->a, w);
		even_out(w->a, n, 1.0);
		cblas_daxpy(square, 1.0, w->a, 1, w->B, 1);
	}
	w->gamma = sqrt(cblas_dnrm2(square, w->K, 1));
	if (!(w->gamma > 0.0))
		w->gamma = fmax(cblas_dnrm2(square, w->B, 1), DBL_MIN);
	cblas_dscal(square, 1.0/w->gamma, w->B, 1);
	cblas_dscal(square, 1.0/w->gamma/w->gamma, w->K, 1);
	w->normB = cblas_dnrm2(square, w->B, 1);
	w->normK = cblas_dnrm2(square, w->K, 1);
	if (!isfinite(w->normB + w->normK))
		return hawser__fail(report, HAWSER_ERR_NAN, where,
		                    "a matrix of %d degrees of freedom holds a not-a-number", n);
	return HAWSER_OK;
}

/* --- the three routes: wr, wi of *count eigenvalues with wi >= 0 --- */

/* i times the inverse of [0, L'; -L, -B]: z = L'q to i(-L^-1 B L^-T z - L^-1 p), p to i L^-T z. */
static int definite(struct work *w, int *count)
{
	int n = w->n, order = 2*n;
	double *L = w->a, *S = w->a + n*n, *X = S + n*n;

	memcpy(L, w->K, (size_t)(n*n)*sizeof *L);
	if (LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'L', n, L, n))
		return 0;
	memset(X, 0, (size_t)(n*n)*sizeof *X);
	for (int i = 0; i < n; i++)
		X[i*n + i] = 1.0;
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n, n, 1.0, L, n,
	            X, n);
	memcpy(S, w->B, (size_t)(n*n)*sizeof *S);
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n, n, 1.0, L, n,
	            S, n);
	cblas_dtrsm(CblasRowMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, n, n, 1.0, L, n, S,
	            n);
	memset(w->h, 0, (size_t)order*(size_t)order*sizeof *w->h);
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			if (j <= i)
				w->h[i*order + j] = -I*S[i*n + j];
			w->h[(n + i)*order + j] = I*X[j*n + i];
		}
	if (LAPACKE_zheevd(LAPACK_ROW_MAJOR, 'N', 'L', order, w->h, order, w->wr) || !(w->wr[n] > 0.0))
		return 0;
	for (int k = 0; k < n; k++) {
		w->wi[k] = 1.0/w->wr[order - 1 - k];
		w->wr[k] = 0.0;
	}
	*count = n;
	return 1;
}

static int hamiltonian(struct work *w, int *count)
{
	int n = w->n, square = n*n, one = 1, ilo = 0, info = 0, length = 2*square + 16*n + 32, found = n;
	double *A = w->a, *QG = A + square, *T = QG + square + n, *scale = T + square;
	double *dwork = scale + n, unused = 0.0;

	/* column-major: A = -B/2, Q = -(K + B'B/4) in the lower triangle, G = 1 in the upper one */
	memset(QG, 0, (size_t)(square + n)*sizeof *QG);
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			A[j*n + i] = -0.5*w->B[i*n + j];
			if (i >= j)
				QG[j*n + i] = -w->K[i*n + j] - 0.25*cblas_ddot(n, w->B + i, n, w->B + j, n);
		}
	for (int i = 0; i < n; i++)
		QG[(i + 1)*n + i] = 1.0;
	mb03xd_("S", "E", "N", "N", &n, A, &n, QG, &n, T, &n, &unused, &one, &unused, &one, &unused,
	        &one, &unused, &one, w->wr, w->wi, &ilo, scale, dwork, &length, &info, 1, 1, 1, 1);
	if (info)
		return 0;
	for (int k = 0; k < n; k++) /* of each pair +-lambda the one with wi >= 0, of a real one both */
		if (w->wi[k] < 0.0) {
			w->wr[k] = -w->wr[k];
			w->wi[k] = -w->wi[k];
		} else if (w->wi[k] == 0.0) {
			w->wi[found] = 0.0;
			w->wr[found++] = -w->wr[k];
		}
	*count = found;
	return 1;
}

static int damped(struct work *w, int *count)
{
	int n = w->n, order = 2*n, found = 0;
	lapack_int ilo, ihi;
	double *scale = w->a + order*order, norm, unused = 0.0;

	memset(w->a, 0, (size_t)order*(size_t)order*sizeof *w->a);
	for (int i = 0; i < n; i++) {
		w->a[i*order + n + i] = 1.0;
		for (int j = 0; j < n; j++) {
			w->a[(n + i)*order + j] = -w->K[i*n + j];
			w->a[(n + i)*order + n + j] = -w->B[i*n + j];
		}
	}
	if (LAPACKE_dgeevx(LAPACK_ROW_MAJOR, 'B', 'N', 'N', 'N', order, w->a, order, w->wr, w->wi,
	                   &unused, order, &unused, order, &ilo, &ihi, scale, &norm, &unused, &unused))
		return 0;
	for (int k = 0; k < order; k++)
		if (w->wi[k] >= 0.0) {
			w->wr[found] = w->wr[k];
			w->wi[found++] = w->wi[k];
		}
	*count = found;
	return 1;
}

/* --- refinement --- */

static void polynomial(double complex *P, const struct work *w, double complex lambda)
{
	for (int i = 0; i < w->n*w->n; i++)
		P[i] = lambda*w->B[i] + w->K[i];
	for (int i = 0; i < w->n; i++)
		P[i*w->n + i] += lambda*lambda;
}

/* y'(conjugated) A x, with A = factor*1 + second*B + third*K; A x is left in out. */
static double complex form(double complex *out, const struct work *w, const double complex *y,
                           const double complex *x, double complex factor, double complex second,
                           double third)
{
	double complex sum = 0.0;

	for (int i = 0; i < w->n; i++) {
		double complex line = factor*x[i];

		for (int j = 0; j < w->n; j++)
			line += (second*w->B[i*w->n + j] + third*w->K[i*w->n + j])*x[j];
		out[i] = line;
		sum += conj(y[i])*line;
	}
	return sum;
}

static double unit(double complex *x, int n)
{
	double norm = cblas_dznrm2(n, x, 1);

	if (norm > 0.0 && isfinite(norm))
		cblas_zdscal(n, 1.0/norm, x, 1);
	return norm;
}

/* Odd starts, another one for each eigenvalue, so that equal ones get vectors of their own. */
static void start(double complex *x, int n, int k)
{
	for (int i = 0; i < n; i++)
		x[i] = sin(1.0 + 1.7*i + 0.9*k*(i + 1.0)) + I*cos(2.0 + 0.8*i*(k + 1.0));
	unit(x, n);
}

/* x := P^-1 x, y := P^-* y, both unit. P is singular but for round-off: a zero pivot is made one of
 * the size of the round-off, which is what inverse iteration wants. */
static int iterate(struct work *w, double complex lambda)
{
	int n = w->n;
	double complex *x = w->z, *y = w->z + n;

	polynomial(w->h, w, lambda);
	if (LAPACKE_zgetrf(LAPACK_ROW_MAJOR, n, n, w->h, n, w->pivot) < 0)
		return 0;
	for (int i = 0; i < n; i++)
		if (cabs(w->h[i*n + i]) < DBL_EPSILON*1e-3)
			w->h[i*n + i] = DBL_EPSILON*1e-3;
	for (int twice = 0; twice < 2; twice++) {
		if (LAPACKE_zgetrs(LAPACK_ROW_MAJOR, 'N', n, 1, w->h, n, w->pivot, x, 1) ||
		    LAPACKE_zgetrs(LAPACK_ROW_MAJOR, 'C', n, 1, w->h, n, w->pivot, y, 1))
			return 0;
		if (!isfinite(unit(x, n)) || !isfinite(unit(y, n)))
			return 0;
	}
	return 1;
}

/* |y|'(|lambda|^2 + |lambda B| + |K|)|x|. */
static double entries(const struct work *w, double complex lambda, const double complex *y,
                      const double complex *x)
{
	double size = cabs(lambda), sum = 0.0;

	for (int i = 0; i < w->n; i++) {
		double line = size*size*cabs(x[i]);

		for (int j = 0; j < w->n; j++)
			line += (size*fabs(w->B[i*w->n + j]) + fabs(w->K[i*w->n + j]))*cabs(x[j]);
		sum += cabs(y[i])*line;
	}
	return sum;
}

/* Eigenvalue k; its vector goes to `best`. Stops where the corrections do not fall any more. */
static struct hawser__eigenvalue refine(struct work *w, double complex *best, int k,
                                        enum hawser__structure structure)
{
	int n = w->n, own = structure != HAWSER__DAMPED && w->wr[k] == 0.0 && w->wi[k] != 0.0;
	double complex lambda = w->wr[k] + I*w->wi[k];
	double complex *x = w->z, *y = x + n, *Px = x + 2*n;
	struct hawser__eigenvalue value = {w->wr[k], w->wi[k], INFINITY, INFINITY, INFINITY};

	start(x, n, k);
	start(y, n, k);
	for (int step = 0; step < STEPS && iterate(w, lambda); step++) {
		const double complex *left = own ? x : y;
		double complex miss = form(Px, w, left, x, lambda*lambda, lambda, 1.0), slope, change;
		double size = cabs(lambda), residual = cblas_dznrm2(n, Px, 1)
		                                       /(size*size + size*w->normB + w->normK);
		double condition;

		slope = form(Px, w, left, x, 2.0*lambda, 1.0, 0.0);
		condition = entries(w, lambda, left, x)/(size*cabs(slope));
		change = -miss/slope;
		if (own)
			change = I*cimag(change);
		else if (w->wi[k] == 0.0)
			change = creal(change);
		if (!isfinite(creal(change) + cimag(change)) || !(cabs(change)/size < value.error))
			break;
		value = (struct hawser__eigenvalue){creal(lambda), cimag(lambda), residual, condition,
			cabs(change)/size};
		memcpy(best, x, (size_t)n*sizeof *best);
		if (cabs(change) > farthest*fmax(size, sqrt(DBL_EPSILON)))
			break;
		lambda += change;
	}
	value.error += 4.0*DBL_EPSILON*value.condition;
	return value;
}

/* --- all of it --- */

struct entry {
	double re, im;
};

static int by_modulus(const void *a, const void *b)
{
	const struct entry *x = a, *y = b;
	double left = hypot(x->re, x->im), right = hypot(y->re, y->im);

	if (left != right)
		return left < right ? -1 : 1;
	return (x->re > y->re) - (x->re < y->re);
}

static int sort(struct work *w, int count)
{
	struct entry *entry = malloc((size_t)count*sizeof *entry);

	if (!entry)
		return 0;
	for (int k = 0; k < count; k++)
		entry[k] = (struct entry){w->wr[k], w->wi[k]};
	qsort(entry, (size_t)count, sizeof *entry, by_modulus);
	for (int k = 0; k < count; k++) {
		w->wr[k] = entry[k].re;
		w->wi[k] = entry[k].im;
	}
	free(entry);
	return 1;
}

/* q = N^-T x, unit. */
static void hand_over(struct hawser__spectrum *spectrum, const struct work *w, int k,
                      double complex *x)
{
	int n = w->n;
	double *out = spectrum->right + (size_t)k*2*(size_t)n, norm;

	for (int i = 0; i < n; i++) {
		out[i] = creal(x[i]);
		out[n + i] = cimag(x[i]);
	}
	for (int part = 0; part < 2 && w->N; part++)
		cblas_dtrsv(CblasRowMajor, CblasLower, CblasTrans, CblasNonUnit, n, w->N, n, out + part*n,
		            1);
	norm = cblas_dnrm2(2*n, out, 1);
	cblas_dscal(2*n, 1.0/norm, out, 1);
}

static enum hawser_status solve(struct hawser__spectrum *spectrum, struct work *w, int undamped,
                                int wanted, struct hawser_report *report)
{
	int n = w->n, count = 0, done;
	double complex *best;

	spectrum->structure = undamped ? HAWSER__DEFINITE : HAWSER__DAMPED;
	done = undamped ? definite(w, &count) : damped(w, &count);
	if (undamped && !done) {
		spectrum->structure = HAWSER__HAMILTONIAN;
		done = hamiltonian(w, &count);
	}
	if (!done)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
		                    "the eigenvalues of %d degrees of freedom did not come out: take fewer",
		                    n);
	if (!sort(w, count))
		return hawser__no_memory(report, where);
	count = wanted > 0 && wanted < count ? wanted : count;
	spectrum->count = count;
	spectrum->value = calloc((size_t)count, sizeof *spectrum->value);
	spectrum->right = calloc((size_t)count, 2*(size_t)n*sizeof *spectrum->right);
	if (!spectrum->value || !spectrum->right)
		return hawser__no_memory(report, where);
	best = w->z + 3*n;
	for (int k = 0; k < count; k++) {
		memset(best, 0, (size_t)n*sizeof *best);
		spectrum->value[k] = refine(w, best, k, spectrum->structure);
		spectrum->value[k].re *= w->gamma;
		spectrum->value[k].im *= w->gamma;
		hand_over(spectrum, w, k, best);
	}
	return HAWSER_OK;
}

void hawser__spectrum_clear(struct hawser__spectrum *spectrum)
{
	if (!spectrum)
		return;
	free(spectrum->value);
	free(spectrum->right);
	*spectrum = (struct hawser__spectrum){0};
}

enum hawser_status hawser__quadratic_eigen(struct hawser__spectrum *spectrum,
                                           const struct hawser__quadratic *problem, int wanted,
                                           struct hawser_report *report)
{
	struct work w = {0};
	enum hawser_status status;

	*spectrum = (struct hawser__spectrum){.n = problem->n};
	if (problem->n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a problem of %d degrees of freedom: give at least one", problem->n);
	status = work_init(&w, problem) ? prepare(&w, problem, report)
	                                : hawser__no_memory(report, where);
	if (!status)
		status = solve(spectrum, &w, problem->C == NULL, wanted, report);
	work_clear(&w);
	if (status)
		hawser__spectrum_clear(spectrum);
	return status;
}

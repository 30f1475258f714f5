/* modes/complex/quadratic.c - see quadratic.h.
 *
 * The largest eigenvalues of a discretised cable or beam are many orders of magnitude larger than
 * the wanted ones, whose accuracy would be lost to their round-off. The linearised problem is
 * therefore inverted about a real shift s: with x = (q, l q) and P = s^2 M + s C + K,
 *
 *   x/(l - s) = [ -P^-1 (C + s M)          -P^-1 M   ] x
 *               [ I - s P^-1 (C + s M)   -s P^-1 M   ]
 *
 * Its largest eigenvalues belong to the l nearest to s. The dense QR algorithm computes all of
 * them. Each wanted one is then refined on the quadratic problem by inverse iteration with the
 * Rayleigh functional. For a gyroscopic system Q(i w) = K - w^2 M + i w C is Hermitian, and the
 * functional has a real root w, so that an eigenvalue on the imaginary axis stays there exactly.
 * For other eigenvalues this iteration does not converge; they are refined with a complex l.
 *
 * References: Tisseur and Meerbergen, SIAM Review 43 (2001) 235; Tisseur, LAA 309 (2000) 339.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define lapack_complex_double double complex
#include <cblas.h>
#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/complex/quadratic.h"

static const char where[] = "eigenvalues";

enum { REFINEMENTS = 4 };
/* An eigenvalue whose |re| is below this fraction of its modulus may be on the imaginary axis. */
#define NEAR_AXIS 1e-3
/* Backward error at which an eigenvalue is accepted as converged. */
#define ACCEPTED 1e3

struct work {
	const struct hawser__quadratic *system;
	int n;
	double size[3];        /* Frobenius norms of M, C, K */
	double *T, *vectors;   /* [2n][2n] row-major */
	double *re, *im;       /* [2n] */
	double complex *Q;     /* [n][n] column-major: Q(l), then its factors */
	double complex *q, *y, *r; /* [n] right and left vectors, scratch */
	int *pivot;            /* [2n] */
	struct hawser__hold hold;
};

/* --- the inverted linearisation --- */

/* T as above. Returns LAPACK's info. */
static int invert(struct work *work, double s)
{
	const struct hawser__quadratic *system = work->system;
	size_t n = (size_t)work->n, m = 2*n;
	double *P = work->vectors, *right = P + n*n; /* [n][2n]: C + s M and M */
	int info;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < n; k++) {
			size_t x = i*n + k;

			P[x] = s*s*system->M[x] + s*system->C[x] + system->K[x];
			right[i*m + k] = system->C[x] + s*system->M[x];
			right[i*m + n + k] = system->M[x];
		}
	info = LAPACKE_dgesv(LAPACK_ROW_MAJOR, work->n, 2*work->n, P, work->n, work->pivot, right,
	                     2*work->n);
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < m; k++) {
			double solved = -right[i*m + k];

			work->T[i*m + k] = solved;
			work->T[(n + i)*m + k] = s*solved + (k == i);
		}
	return info;
}

static int solve_linear(struct work *work)
{
	int m = 2*work->n, ilo, ihi;
	double norm, unused;
	double *scale = malloc((size_t)m*sizeof *scale);
	int info = scale ? LAPACKE_dgeevx(LAPACK_ROW_MAJOR, 'B', 'N', 'V', 'N', m, work->T, m, work->re,
	                                  work->im, &unused, m, work->vectors, m, &ilo, &ihi, scale,
	                                  &norm, NULL, NULL)
	                 : LAPACK_WORK_MEMORY_ERROR;

	free(scale);
	return info;
}

/* --- refinement on the quadratic problem --- */

void hawser__quadratic_apply(double complex *product, const double *A, const double complex *q, int n)
{
	for (int part = 0; part < 2; part++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, A, n, (const double *)q + part, 2, 0.0,
		            (double *)product + part, 2);
}

double complex hawser__quadratic_dot(const double complex *y, const double complex *q, int n)
{
	double complex sum = 0.0;

	for (int i = 0; i < n; i++)
		sum += conj(y[i])*q[i];
	return sum;
}

/* y* A q; r is overwritten. */
static double complex bilinear(const struct work *work, const double *A, const double complex *y)
{
	hawser__quadratic_apply(work->r, A, work->q, work->n);
	return hawser__quadratic_dot(y, work->r, work->n);
}

static void assemble(struct work *work, double complex l)
{
	const struct hawser__quadratic *system = work->system;
	int n = work->n;

	for (int i = 0; i < n; i++)
		for (int k = 0; k < n; k++) {
			size_t x = (size_t)i*n + k;

			work->Q[(size_t)k*n + i] = l*(l*system->M[x] + system->C[x]) + system->K[x];
		}
}

static double scale_of(const struct work *work, double complex l)
{
	double modulus = cabs(l);

	return modulus*(modulus*work->size[0] + work->size[1]) + work->size[2];
}

/* Backward error |Q(l) q| over the sum of the norms; assembles Q and sets r = Q(l) q. */
static double residual(struct work *work, double complex l)
{
	static const double complex one = 1.0, zero = 0.0;

	cblas_zgemv(CblasColMajor, CblasNoTrans, work->n, work->n, &one, work->Q, work->n, work->q, 1,
	            &zero, work->r, 1);
	return cblas_dznrm2(work->n, work->r, 1)/(scale_of(work, l)*cblas_dznrm2(work->n, work->q, 1));
}

static void normalise(double complex *q, int n)
{
	cblas_zdscal(n, 1.0/cblas_dznrm2(n, q, 1), q, 1);
}

/* q = Q^-1 q and y = Q^-H y, normalised. If Q is exactly singular, its diagonal is perturbed by
 * round-off, which inverse iteration tolerates. */
static void iterate(struct work *work)
{
	int n = work->n;

	LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, n, n, work->Q, n, work->pivot);
	for (int i = 0; i < n; i++)
		if (work->Q[(size_t)i*n + i] == 0.0)
			work->Q[(size_t)i*n + i] = DBL_EPSILON*work->size[2]/n + DBL_MIN;
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'N', n, 1, work->Q, n, work->pivot, work->q, n);
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'C', n, 1, work->Q, n, work->pivot, work->y, n);
	normalise(work->q, n);
	normalise(work->y, n);
}

/* The root nearest to l of y* Q(l) q. */
static double complex functional(const struct work *work, double complex l)
{
	const struct hawser__quadratic *system = work->system;
	double complex a = bilinear(work, system->M, work->y);
	double complex b = bilinear(work, system->C, work->y);
	double complex c = bilinear(work, system->K, work->y);
	double complex root = csqrt(b*b - 4.0*a*c), large, first, second;

	large = cabs(b + root) > cabs(b - root) ? -0.5*(b + root) : -0.5*(b - root);
	if (large == 0.0 || a == 0.0)
		return l;
	first = large/a;
	second = c/large;
	return cabs(first - l) < cabs(second - l) ? first : second;
}

/* The real root w nearest to im l of q* Q(i w) q, or NAN: h - w^2 m + w g = 0 with g = i q* C q. */
static double on_axis(const struct work *work, double w)
{
	const struct hawser__quadratic *system = work->system;
	double m = creal(bilinear(work, system->M, work->q));
	double g = -cimag(bilinear(work, system->C, work->q));
	double h = creal(bilinear(work, system->K, work->q));
	double under = g*g + 4.0*m*h, large, first, second;

	if (!(under >= 0.0))
		return NAN;
	large = 0.5*(g + copysign(sqrt(under), g));
	if (large == 0.0)
		return 0.0;
	first = large/m;
	second = -h/large;
	return fabs(first - w) < fabs(second - w) ? first : second;
}

/* Refine *l and its vector q; with `axis` nonzero *l stays on the imaginary axis. Returns the
 * backward error. */
static double refine(struct work *work, double complex *l, int axis)
{
	double best = INFINITY;
	double complex kept = *l;

	for (int i = 0; i <= REFINEMENTS; i++) {
		double w = axis ? on_axis(work, cimag(*l)) : 0.0;
		double error;

		if (axis && isnan(w))
			return best;
		if (axis)
			*l = I*w;
		else if (i > 0)
			*l = functional(work, *l);
		assemble(work, *l);
		error = residual(work, *l);
		if (!(error < 0.5*best) || i == REFINEMENTS) {
			*l = error < best ? *l : kept;
			return fmin(error, best);
		}
		best = error;
		kept = *l;
		iterate(work);
	}
	return best;
}

static double condition(const struct work *work, double complex l)
{
	const struct hawser__quadratic *system = work->system;
	double complex slope = 2.0*l*bilinear(work, system->M, work->y)
	                       + bilinear(work, system->C, work->y);

	return scale_of(work, l)/(cabs(l)*cabs(slope));
}

static void load_vector(struct work *work, int column)
{
	int n = work->n, m = 2*n, pair = work->im[column] != 0.0;

	for (int i = 0; i < n; i++) {
		double re = work->vectors[(size_t)i*m + column];
		double im = pair ? work->vectors[(size_t)i*m + column + 1] : 0.0;

		work->q[i] = re + I*im;
		work->y[i] = work->q[i];
	}
	normalise(work->q, n);
	normalise(work->y, n);
}

/* Refine the eigenvalue l whose eigenvector is `column` of the inverted problem; its vector is left
 * in q. */
static struct hawser__eigenvalue polish(struct work *work, int column, double complex l)
{
	struct hawser__eigenvalue value;
	double error = INFINITY;
	double complex held = I*cimag(l);

	load_vector(work, column);
	if (work->system->gyroscopic && fabs(creal(l)) <= NEAR_AXIS*cabs(l) && cimag(l) != 0.0)
		error = refine(work, &held, 1);
	if (error <= ACCEPTED*DBL_EPSILON*work->n) {
		l = held;
	} else {
		load_vector(work, column);
		error = refine(work, &l, 0);
	}
	value = (struct hawser__eigenvalue){creal(l) + 0.0, cimag(l), error, condition(work, l)};
	return value;
}

/* --- all together --- */

struct candidate {
	double complex l;
	int column;
};

static int by_modulus(const void *left, const void *right)
{
	const struct candidate *a = left, *b = right;
	double d = cabs(a->l) - cabs(b->l);

	return (d > 0.0) - (d < 0.0);
}

static int candidates(struct candidate *list, const struct work *work, double shift)
{
	int m = 2*work->n, kept = 0;

	for (int i = 0; i < m; i++) {
		double complex mu = work->re[i] + I*work->im[i];
		double complex l = shift + 1.0/mu;

		/* of a pair LAPACK stores the vector of mu with im > 0, whose l has im < 0 */
		if (work->im[i] < 0.0 || mu == 0.0)
			continue;
		list[kept++] = (struct candidate){l, i};
	}
	qsort(list, (size_t)kept, sizeof *list, by_modulus);
	return kept;
}

static void store(double *vector, const double complex *q, int n, int mirrored)
{
	for (int i = 0; i < n; i++) {
		vector[i] = creal(q[i]);
		vector[n + i] = mirrored ? -cimag(q[i]) : cimag(q[i]);
	}
}

static double frobenius(const double *A, int n)
{
	return cblas_dnrm2(n*n, A, 1);
}

static enum hawser_status room(struct work *work, struct hawser_report *report)
{
	size_t n = (size_t)work->n, m = 2*n;

	work->T = hawser__hold(&work->hold, m*m, sizeof *work->T);
	work->vectors = hawser__hold(&work->hold, m*m, sizeof *work->vectors);
	work->re = hawser__hold(&work->hold, m, sizeof *work->re);
	work->im = hawser__hold(&work->hold, m, sizeof *work->im);
	work->Q = hawser__hold(&work->hold, n*n, sizeof *work->Q);
	work->q = hawser__hold(&work->hold, 3*n, sizeof *work->q);
	work->pivot = hawser__hold(&work->hold, m, sizeof *work->pivot);
	if (work->hold.short_of_memory)
		return hawser__no_memory(report, where);
	work->y = work->q + n;
	work->r = work->y + n;
	return HAWSER_OK;
}

static enum hawser_status check(const struct work *work, double shift, int count,
                                struct hawser_report *report)
{
	if (work->n < 1 || count < 1 || !(shift > 0.0 && isfinite(shift)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d of %d unknowns' eigenvalues, shift %g: all have to be positive", count,
		                    work->n, shift);
	for (int i = 0; i < 3; i++)
		if (!isfinite(work->size[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, where, "the %s matrix is not finite",
			                    i == 0 ? "mass" : i == 1 ? "damping" : "stiffness");
	return HAWSER_OK;
}

enum hawser_status hawser__quadratic_eigen(struct hawser__eigenvalue *value, double *vector,
                                           double *left, int *found,
                                           const struct hawser__quadratic *system, double shift,
                                           int count, struct hawser_report *report)
{
	struct work work = {.system = system, .n = system->n,
		.size = {frobenius(system->M, system->n), frobenius(system->C, system->n),
		         frobenius(system->K, system->n)}};
	struct candidate *list;
	enum hawser_status status = check(&work, shift, count, report);
	int many, info;

	*found = 0;
	if (status || (status = room(&work, report)))
		goto done;
	list = hawser__hold(&work.hold, 2*(size_t)work.n, sizeof *list);
	if (!list) {
		status = hawser__no_memory(report, where);
		goto done;
	}
	info = invert(&work, shift);
	if (!info)
		info = solve_linear(&work);
	if (info) {
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, where)
			: hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
			               "the eigenvalues of %d unknowns were not found about %g", work.n,
			               shift);
		goto done;
	}
	many = candidates(list, &work, shift);
	for (; *found < many && *found < count; ++*found) {
		struct hawser__eigenvalue got = polish(&work, list[*found].column, list[*found].l);
		int mirrored = got.im < 0.0;

		got.im = fabs(got.im);
		value[*found] = got;
		if (vector)
			store(vector + (size_t)*found*2*(size_t)work.n, work.q, work.n, mirrored);
		if (left)
			store(left + (size_t)*found*2*(size_t)work.n, work.y, work.n, mirrored);
	}
done:
	hawser__hold_clear(&work.hold);
	return status;
}

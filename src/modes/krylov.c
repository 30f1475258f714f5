/* modes/krylov.c - block Krylov method with an explicit projection.
 *
 *   V, W   rows: orthonormal basis of the Krylov space, and W = A V
 *   H      V W': the projection; theta, y its eigenpairs, and V'y, the Ritz vector
 *
 * The block size is two, since a frequency can be double within a plane (at a crossing), of which a
 * single starting vector finds only one. Every vector is orthogonalised twice against all others. W
 * is stored, not computed from H, so that the residual `miss` is that of A itself. Restarts are not
 * needed: the operators are compact with eigenvalues of order 1/j^2, and about three vectors per
 * mode suffice.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/halving.h"

enum { BLOCK = 2 };
static const double converged = 1e-12;

struct space {
	int size, m, most, projected;
	double *V, *W; /* [most][size] */
	double *H;     /* [most][most] H_ij = v_i.w_j */
	double *small; /* [most][most] copy of H, which the eigensolver overwrites */
	double *y;     /* [most][most] eigenvectors of H, in columns */
	double *re, *im;
	int *order;
	unsigned seed;
	struct hawser__hold hold;
};

static void space_free(struct space *t)
{
	hawser__hold_clear(&t->hold);
}

static int space_init(struct space *t, int size, int count)
{
	int most = 6*count + 60 < size ? 6*count + 60 : size;
	size_t n = (size_t)size, m = (size_t)most;

	*t = (struct space){.size = size, .most = most, .seed = 2385u};
	t->V = hawser__hold(&t->hold, m*n, sizeof *t->V);
	t->W = hawser__hold(&t->hold, m*n, sizeof *t->W);
	t->H = hawser__hold(&t->hold, m*m, sizeof *t->H);
	t->small = hawser__hold(&t->hold, m*m, sizeof *t->small);
	t->y = hawser__hold(&t->hold, m*m, sizeof *t->y);
	t->re = hawser__hold(&t->hold, m, sizeof *t->re);
	t->im = hawser__hold(&t->hold, m, sizeof *t->im);
	t->order = hawser__hold(&t->hold, m, sizeof *t->order);
	return !t->hold.short_of_memory;
}

/* Numerical Recipes' quick generator: the same on every machine. */
static void fill_random(double *v, int size, unsigned *seed)
{
	for (int i = 0; i < size; i++) {
		*seed = *seed*1664525u + 1013904223u;
		v[i] = (*seed >> 8)/16777216.0 - 0.5;
	}
}

/* Append the component of v[size] orthogonal to the space. If it is 0, the space is invariant, and
 * a random direction is appended. */
static void append(struct space *t, const double *v, double *project)
{
	int size = t->size, m = t->m;
	double *row = t->V + (size_t)m*(size_t)size, before, after;

	memcpy(row, v, (size_t)size*sizeof *row);
	for (int tries = 0; tries < 4; tries++) {
		before = cblas_dnrm2(size, row, 1);
		for (int pass = 0; pass < 2 && m > 0; pass++) {
			cblas_dgemv(CblasRowMajor, CblasNoTrans, m, size, 1.0, t->V, size, row, 1,
			            0.0, project, 1);
			cblas_dgemv(CblasRowMajor, CblasTrans, m, size, -1.0, t->V, size, project,
			            1, 1.0, row, 1);
		}
		after = cblas_dnrm2(size, row, 1);
		if (after > 1e-13*before)
			break;
		fill_random(row, size, &t->seed);
	}
	cblas_dscal(size, 1.0/after, row, 1);
	t->m++;
}

/* Compute the new rows and columns of H. */
static void project(struct space *t)
{
	int size = t->size, m = t->m, known = t->projected, fresh = m - known;
	size_t skip = (size_t)known*(size_t)size;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m, fresh, size, 1.0, t->V, size,
	            t->W + skip, size, 0.0, t->H + known, t->most);
	if (known > 0)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, fresh, known, size, 1.0,
		            t->V + skip, size, t->W, size, 0.0, t->H + known*t->most, t->most);
	t->projected = m;
}

/* Eigenpairs of H, sorted by descending real part. Complex pairs stay together: LAPACK returns them
 * as neighbours with equal real parts, and the sort is stable. */
static int small_eigen(struct space *t, int symmetric)
{
	int m = t->m, failed;

	for (int i = 0; i < m; i++)
		memcpy(t->small + i*m, t->H + i*t->most, (size_t)m*sizeof *t->small);
	if (symmetric) {
		memcpy(t->y, t->small, (size_t)m*(size_t)m*sizeof *t->y);
		memset(t->im, 0, (size_t)m*sizeof *t->im);
		failed = LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', m, t->y, m, t->re);
	} else {
		failed = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', m, t->small, m, t->re, t->im,
		                       NULL, 1, t->y, m);
	}
	if (failed)
		return failed;
	for (int i = 0; i < m; i++) {
		int k = i;

		for (; k > 0 && t->re[t->order[k - 1]] < t->re[i]; k--)
			t->order[k] = t->order[k - 1];
		t->order[k] = i;
	}
	return 0;
}

/* Vector and residual of Ritz pair k. work[size]. */
static void expand(struct hawser__ritz *ritz, const struct space *t, int k, double *work)
{
	/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): k is below m */
	int j = t->order[k], size = t->size, m = t->m, partner;
	double *x = ritz->x + (size_t)k*(size_t)size, norm;

	ritz->re[k] = t->re[j];
	ritz->im[k] = t->im[j];
	cblas_dgemv(CblasRowMajor, CblasTrans, m, size, 1.0, t->V, size, t->y + j, m, 0.0, x, 1);
	cblas_dgemv(CblasRowMajor, CblasTrans, m, size, 1.0, t->W, size, t->y + j, m, 0.0, work, 1);
	norm = cblas_dnrm2(size, x, 1);
	cblas_daxpy(size, -t->re[j], x, 1, work, 1);
	if (t->im[j] != 0.0) {
		partner = t->im[j] > 0.0 ? j + 1 : j - 1;
		cblas_dgemv(CblasRowMajor, CblasTrans, m, size, fabs(t->im[j])*(partner > j ? 1 : -1),
		            t->V, size, t->y + partner, m, 1.0, work, 1);
	}
	ritz->miss[k] = cblas_dnrm2(size, work, 1)/(fabs(t->re[j])*norm);
	cblas_dscal(size, 1.0/norm, x, 1);
}

void hawser__ritz_clear(struct hawser__ritz *ritz)
{
	free(ritz->re);
	free(ritz->im);
	free(ritz->miss);
	free(ritz->x);
	*ritz = (struct hawser__ritz){0};
}

static int ritz_init(struct hawser__ritz *ritz, int count, int size)
{
	size_t k = (size_t)count;

	*ritz = (struct hawser__ritz){.count = count, .size = size};
	ritz->re = malloc(k*sizeof *ritz->re);
	ritz->im = malloc(k*sizeof *ritz->im);
	ritz->miss = malloc(k*sizeof *ritz->miss);
	ritz->x = malloc(k*(size_t)size*sizeof *ritz->x);
	return ritz->re && ritz->im && ritz->miss && ritz->x;
}

static void grow(struct space *t, const struct hawser__operator *A, int to, double *work)
{
	while (t->m < to) {
		int m = t->m;

		if (m < BLOCK) {
			fill_random(work, t->size, &t->seed);
			append(t, work, t->re);
		} else {
			append(t, t->W + (size_t)(m - BLOCK)*(size_t)t->size, t->re);
		}
		A->apply(t->W + (size_t)m*(size_t)t->size, t->V + (size_t)m*(size_t)t->size,
		         A->context);
	}
}

enum hawser_status hawser__krylov(struct hawser__ritz *ritz, const struct hawser__operator *A,
                                  int count, struct hawser_report *report)
{
	double *work = malloc((size_t)A->size*sizeof *work), worst;
	enum hawser_status status = HAWSER_OK;
	struct space t;
	int to, info;

	count = count < A->size ? count : A->size;
	if (!space_init(&t, A->size, count) || !ritz_init(ritz, count, A->size) || !work) {
		status = hawser__no_memory(report, "modes");
		goto done;
	}
	to = 3*count + 12;
	do {
		to = to < t.most ? to : t.most;
		grow(&t, A, to, work);
		project(&t);
		info = small_eigen(&t, A->symmetric);
		if (info) {
			status = hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
				: hawser__fail(report, HAWSER_ERR_NAN, "modes",
				               "the eigenvalue solver met a not-a-number: check EA, "
				               "rho, d and the tension of the span, or take a smaller "
				               "basis");
			goto done;
		}
		worst = 0.0;
		for (int k = 0; k < count; k++) {
			expand(ritz, &t, k, work);
			worst = fmax(worst, ritz->miss[k]);
		}
		to += 4 + t.m/4;
	} while (worst > converged && t.m < t.most);
done:
	free(work);
	space_free(&t);
	if (status)
		hawser__ritz_clear(ritz);
	return status;
}

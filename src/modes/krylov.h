/* modes/krylov.h - the largest eigenvalues of a linear operator given by its product with a vector.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_KRYLOV_H
#define HAWSER_MODES_KRYLOV_H

#include <hawser/status.h>

/* y[size] = A x[size]. */
struct hawser__operator {
	int size;
	void (*apply)(double *y, const double *x, void *context);
	void *context;
	int symmetric;
};

/* `count` eigenvalues by descending real part. A complex pair occupies two neighbours, whose
 * vectors are the real and the imaginary part of the eigenvector. */
struct hawser__ritz {
	int count, size;
	double *re, *im; /* [count] */
	double *miss;    /* [count] relative residual: norm of (A - theta) x over that of theta x */
	double *x;       /* [count][size] unit vectors */
};

/* count is reduced to the size of the operator if it is larger. Pairs that have not converged have
 * a large `miss`; the status does not report them. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__krylov(struct hawser__ritz *ritz, const struct hawser__operator *A,
                                  int count, struct hawser_report *report);
void hawser__ritz_clear(struct hawser__ritz *ritz);

#endif

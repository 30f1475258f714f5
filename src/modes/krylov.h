/* modes/krylov.h - the largest eigenvalues of a linear operator that is known by what it does.
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

/* `count` eigenvalues, descending real part. A complex pair stands as two neighbours, its vectors
 * being real and imaginary part. */
struct hawser__ritz {
	int count, size;
	double *re, *im; /* [count] */
	double *miss;    /* [count] norm of (A - theta) x over that of theta x */
	double *x;       /* [count][size] unit vectors */
};

/* count is cut to the operator's size. What has not converged is told by `miss`, not by the status.
 * Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__krylov(struct hawser__ritz *ritz, const struct hawser__operator *A,
                                  int count, struct hawser_report *report);
void hawser__ritz_clear(struct hawser__ritz *ritz);

#endif

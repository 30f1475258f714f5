/* modes/complex/quadratic.h - the eigenvalues of least modulus of M q'' + C q' + K q = 0, for
 * any real C and K. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_QUADRATIC_H
#define HAWSER_MODES_QUADRATIC_H

#include <complex.h>

#include <hawser/status.h>

struct hawser__quadratic {
	int n;
	const double *M, *C, *K; /* [n][n] row-major, M symmetric and positive definite */
	int gyroscopic;          /* C is skew, K symmetric: eigenvalues mirrored about both axes */
};

struct hawser__eigenvalue {
	double re, im;    /* im >= 0: of a conjugate pair the one above the real axis */
	double residual;  /* backward error: |(l^2 M + l C + K) q| over the sum of the norms */
	double condition; /* condition number of l for relative changes of M, C, K (Tisseur 2000) */
};

/* Compute the `count` eigenvalues of least modulus, ascending, without conjugates: value [count].
 * Real and imaginary parts of the unit vectors q are stored in vector [count][2][n], those of the
 * left vectors y, y* Q(l) = 0, in left [count][2][n]; both may be NULL. *found is less than count
 * if there are fewer eigenvalues. `shift` is a positive real number of the size of the wanted
 * eigenvalues and not close to any eigenvalue (a positive real eigenvalue is a divergence). An
 * eigenvalue of a gyroscopic system on the imaginary axis has re = 0 exactly. Statuses:
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__quadratic_eigen(struct hawser__eigenvalue *value, double *vector,
                                           double *left, int *found,
                                           const struct hawser__quadratic *system, double shift,
                                           int count, struct hawser_report *report);

/* product [n] = A q, A [n][n] row-major, q [n]. */
void hawser__quadratic_apply(double complex *product, const double *A, const double complex *q, int n);

/* y* q, both [n]. */
double complex hawser__quadratic_dot(const double complex *y, const double complex *q, int n);

#endif

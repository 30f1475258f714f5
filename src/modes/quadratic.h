/* modes/quadratic.h - eigenvalues of M q'' + C q' + K q = 0 for any real C and K, by their size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
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
	double re, im;    /* im >= 0: of a pair, the one above the real axis */
	double residual;  /* |(l^2 M + l C + K) q| over the norms' sum, backward error */
	double condition; /* by how much relative errors of M, C, K can grow in l (Tisseur 2000) */
};

/* The `count` eigenvalues of least modulus, ascending, conjugates left out, in value [count]; vector
 * [count][2][n] real and imaginary parts of q of length 1, or NULL, and those of the left vectors y,
 * y* Q(l) = 0, in left [count][2][n] or NULL. *found may be less than count when
 * there are not as many. `shift` is a positive real number of the size of the wanted ones, near no
 * eigenvalue (a real positive one is a divergence). A gyroscopic system's eigenvalue on the imaginary
 * axis has re = 0 exactly. HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_CONVERGENCE,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__quadratic_eigen(struct hawser__eigenvalue *value, double *vector,
                                           double *left, int *found,
                                           const struct hawser__quadratic *system, double shift,
                                           int count, struct hawser_report *report);

/* product [n] = A q, A [n][n] row-major, q [n]. */
void hawser__quadratic_apply(double complex *product, const double *A, const double complex *q, int n);

/* y* q, both [n]. */
double complex hawser__quadratic_dot(const double complex *y, const double complex *q, int n);

#endif

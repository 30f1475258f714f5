/* modes/quadratic.h - eigenvalues of M q'' + (C + G) q' + K q = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_QUADRATIC_H
#define HAWSER_MODES_QUADRATIC_H

#include <hawser/status.h>

/* Row-major, [n][n] each. M symmetric and positive (NULL: the identity), C symmetric (NULL: none),
 * G skew and the whole factor of q' (NULL: none), K symmetric of any sign. */
struct hawser__quadratic {
	int n;
	const double *M, *C, *G, *K;
};

/* What the solve could build on, best first. */
enum hawser__structure {
	HAWSER__DEFINITE,    /* no C, K positive: a Hermitian problem, re is 0 */
	HAWSER__HAMILTONIAN, /* no C: the spectrum is symmetric about both axes, to the last bit */
	HAWSER__DAMPED
};

struct hawser__eigenvalue {
	double re, im;    /* im >= 0: conjugates are left out */
	double residual;  /* backward error: relative change of M, C + G, K that makes it exact */
	double condition; /* by how much relative changes of their entries grow in it; huge where it is
	                   * about to meet another one */
	double error;     /* relative: what a further step would change, and what rounding does */
};

struct hawser__spectrum {
	int n, count; /* count is n, but for real eigenvalues, which stand alone: then up to 2n */
	enum hawser__structure structure;
	struct hawser__eigenvalue *value; /* [count] ascending modulus, then re */
	double *right; /* [count][2][n] real and imaginary part of q, unit length */
};

/* The `wanted` eigenvalues of least modulus (0: all) are refined by Newton's method on both
 * eigenvectors, and get vectors, residual and condition; the others are dropped. Release with
 * hawser__spectrum_clear. Statuses: _ARGUMENT (M is not positive), _NAN (a matrix has one),
 * _CONVERGENCE (LAPACK or SLICOT gave up), _MEMORY. */
enum hawser_status hawser__quadratic_eigen(struct hawser__spectrum *spectrum,
                                           const struct hawser__quadratic *problem, int wanted,
                                           struct hawser_report *report);
void hawser__spectrum_clear(struct hawser__spectrum *spectrum);

#endif

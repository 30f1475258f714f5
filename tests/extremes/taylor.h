/* tests/extremes/taylor.h - reference solution for motions of a model: Taylor series of order 30 in
 * long double (64 bits of mantissa), from the entries of K, D, Q and C. It shares neither the force
 * kernel, nor the integrator, nor the precision with the library.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TAYLOR_H
#define HAWSER_TESTS_TAYLOR_H

#include <hawser/rom.h>

struct taylor;

/* NULL when there is no memory. `rom` (polynomial, n <= 60) must outlive it. */
struct taylor *taylor_new(const struct hawser_rom *rom);
void taylor_free(struct taylor *taylor);

/* Steps that one motion may take; a longer one fails. */
void taylor_limit(struct taylor *taylor, long steps);

/* x [2n], u then u', from the time t to `until` under the load at Omega. Of the motion on the way
 * most [n] receives the largest |u_j| of the steps' own polynomials; NULL: not wanted. Returns 0,
 * or 1 when the motion escapes or takes too many steps. */
int taylor_move(struct taylor *taylor, long double *x, double *most, double omega, long double t,
                long double until);

/* The flow's derivative over the time, M [2n][2n] row-major, by central differences around x of the
 * size `size`; and by_omega [2n] at a fixed number of periods, or NULL. Exact for linear models. */
int taylor_derivative(struct taylor *taylor, long double *M, long double *by_omega,
                      const long double *x, double omega, double periods, double size);

/* A periodic orbit near x [2n] by Newton's method on one period: x is replaced, M and most as
 * above, along [2n] = d x/d Omega at phase 0 (each may be NULL). Returns 0, or 1: none was found. */
int taylor_orbit(struct taylor *taylor, long double *x, long double *M, long double *along,
                 double *most, double omega);

/* Root of the mean square of the state [2n] over the periodic orbit through x at phase 0. */
double taylor_size(struct taylor *taylor, const long double *x, double omega);

/* A x = b by elimination with column pivoting; A [m][m] and b [m] are overwritten, the latter by
 * x. */
int taylor_solve(long double *A, long double *b, int m);

#endif

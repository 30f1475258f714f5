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

/* Largest number of steps of one motion; a longer motion fails. */
void taylor_limit(struct taylor *taylor, long steps);

/* Integrate x [2n] (u, then u') from the time t to `until` under the load at Omega. most [n]
 * receives the largest |u_j| of the polynomials of the steps; it may be NULL. Returns 1 if the
 * motion escapes or needs too many steps, otherwise 0. */
int taylor_move(struct taylor *taylor, long double *x, double *most, double omega, long double t,
                long double until);

/* Derivative of the flow over `periods` periods, by central differences of the size `size` around x:
 * M [2n][2n] row-major with respect to x, and by_omega [2n] with respect to Omega (may be NULL).
 * Exact for linear models. */
int taylor_derivative(struct taylor *taylor, long double *M, long double *by_omega,
                      const long double *x, double omega, double periods, double size);

/* Periodic orbit near x [2n], by Newton's method on one period. x is replaced; M and most are as
 * above; along [2n] = d x/d Omega at phase 0. Each of M, along and most may be NULL. Returns 1 if no
 * orbit was found, otherwise 0. */
int taylor_orbit(struct taylor *taylor, long double *x, long double *M, long double *along,
                 double *most, double omega);

/* Root mean square of the state over the periodic orbit through x [2n] at phase 0. */
double taylor_size(struct taylor *taylor, const long double *x, double omega);

/* Solve A x = b by elimination with column pivoting. A [m][m] is overwritten; x replaces b [m]. */
int taylor_solve(long double *A, long double *b, int m);

#endif

/* response/torus.h - invariant circles of the period map: quasi-periodic responses.
 *
 *    theta_i  2 pi i/N, i = 0 .. N - 1, N odd
 *    x        points of the circle [N][m], values of a trigonometric polynomial of order (N - 1)/2
 *    P        map over a period of the load
 *    rho      rotation number (rad per period): P(x(theta)) = x(theta + rho)
 *
 * Newton's method on P(x(theta_i)) = x(theta_i + rho), where the right-hand side is the polynomial. The
 * phase is that of the guess: the difference from it is orthogonal to its derivative by theta. Either
 * Omega is given, or the size of the circle, of which the difference from the guess is orthogonal to
 * the guess; the latter begins a branch at a torus point, where x = x0 + a Re(v exp(i theta)) with the
 * eigenvector v and rho the angle of its multiplier.
 *
 * Reference: A. Jorba, Numerical computation of the normal behaviour of invariant curves of
 * n-dimensional maps, Nonlinearity 14 (2001) 943; F. Schilder, H. M. Osinga and W. Vogt, SIAM J. Appl.
 * Dyn. Syst. 4 (2005) 459.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_TORUS_H
#define HAWSER_RESPONSE_TORUS_H

#include "response/flow.h"

struct hawser__torus {
	struct hawser__flow flow;
	int m, points, steps;    /* points: N; steps: of integration per period */
	int size;                /* unknowns: x, rho, Omega */
	double omega, rho;
	double *x;               /* [N][m] */
	double residual;         /* of the last correction, relative to the size of the circle's points */
	double defect;           /* largest |P(x(theta)) - x(theta + rho)| between the points, with half
	                          * the length of steps, relative to the largest |x| */
	double tail;             /* largest of the last two coefficients over the largest of all but the
	                          * mean */
	int iterations;
	double *image, *guess, *A, *b, *matrix, *right, *kernel;
	int *pivot;
};

enum hawser_status hawser__torus_open(struct hawser__torus *torus, const struct hawser_rom *rom,
                                      int points, double omega, struct hawser_report *report);
void hawser__torus_clear(struct hawser__torus *torus);
/* The linear circle about the orbit x0 [m] at a torus point, with this largest distance. */
enum hawser_status hawser__torus_begin(struct hawser__torus *torus, const double *x0, double omega,
                                       double distance, struct hawser_report *report);
/* Correct x and rho, and with `sized` omega, at the size of the guess. HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__torus_correct(struct hawser__torus *torus, int sized,
                                         struct hawser_report *report);

#endif

/* response/torus/torus.h - invariant circles of the period map: quasi-periodic responses.
 *
 *    theta_i  2 pi i/N, i = 0 .. N - 1, N odd
 *    x        points of the circle [N][m], values of a trigonometric polynomial of order (N - 1)/2
 *    P        map over a period of the load
 *    rho      rotation number (rad per period): P(x(theta)) = x(theta + rho)
 *
 * Newton's method on P(x(theta_i)) = x(theta_i + rho), where the right-hand side is the polynomial. The
 * phase is that of the guess: the difference from it is orthogonal to its derivative by theta. Either
 * Omega is given, or the size of the circle, of which the difference from the guess is orthogonal to
 * the guess; the latter begins a branch at a torus point, where x = x0 + a Re(v exp(i theta)) with
 * the eigenvector v and rho the angle of its multiplier. In general the last equation is that the
 * difference from the guess, of x, rho and Omega, is orthogonal to a row: that of a continuation's step
 * (torus_follow.c).
 *
 * Reference: A. Jorba, Numerical computation of the normal behaviour of invariant curves of
 * n-dimensional maps, Nonlinearity 14 (2001) 943; F. Schilder, H. M. Osinga and W. Vogt, SIAM J. Appl.
 * Dyn. Syst. 4 (2005) 459.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_TORUS_H
#define HAWSER_RESPONSE_TORUS_H

#include <hawser/torus.h>

#include "continuation/curve.h"
#include "response/time/flow.h"

#define HAWSER_TORUS_FIRST 21 /* points of the first circle of a curve; chosen */
#define HAWSER_TORUS_NUMBERS 2400 /* of a circle, largest: the work grows with the third power;
                                   * chosen */

struct hawser__torus {
	struct hawser__flow flow;
	int m, points, steps;    /* points: N; steps: of integration per period */
	int size;                /* unknowns: x, rho, Omega */
	int most;                /* largest N for which there is room */
	const struct hawser_rom_family *family; /* NULL, or the models, whose parameter is the place */
	double place, omega, rho; /* place: Omega, or the parameter */
	double extent;           /* of a range of the parameter */
	double mesh;             /* largest estimated error of a period, relative, with which the number of
	                          * steps is chosen */
	double *x;               /* [N][m] */
	double residual;         /* of the last correction, relative to the size of the circle's points */
	double defect;           /* largest |P(x(theta)) - x(theta + rho)| between the points, with half
	                          * the length of steps, relative to the largest |x| */
	double tail;             /* largest of the last two coefficients over the largest of all but the
	                          * mean */
	double period_error;     /* estimated error of a period at the last evaluation, relative */
	int iterations;
	double *other; /* [N][m] images in another model of the family */
	double *image, *A, *b, *matrix, *right, *kernel;
	double *guess, *along, *row; /* [size] x, rho, Omega of the guess; [N][m] its derivative by theta;
	                              * [size] row of the last equation */
	int *pivot;
};

/* Room for up to `most` points (0: `points`). */
enum hawser_status hawser__torus_open(struct hawser__torus *torus, const struct hawser_rom *rom,
                                      int points, double omega, struct hawser_report *report);
enum hawser_status hawser__torus_room(struct hawser__torus *torus, const struct hawser_rom *rom,
                                      int points, int most, double omega,
                                      struct hawser_report *report);
void hawser__torus_clear(struct hawser__torus *torus);
/* The linear circle about the orbit x0 [m] at a torus point, with this largest distance. */
enum hawser_status hawser__torus_begin(struct hawser__torus *torus, const double *x0, double place,
                                       double distance, struct hawser_report *report);
/* Correct x and rho, and with `sized` the place, at the size of the guess. HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__torus_correct(struct hawser__torus *torus, int sized,
                                         struct hawser_report *report);

/* The guess becomes the present circle, and the phase condition its derivative. */
void hawser__torus_guess(struct hawser__torus *torus);
/* Newton's method from the guess with torus->row as the last equation; lengths of its steps are in the
 * metric weight [size] (NULL: not computed). 1 if it does not converge. Sets torus->residual. */
int hawser__torus_newton(struct hawser__torus *torus, struct hawser__correction *did,
                         const double *weight);
/* After it: t [size], of any length, for which the product with torus->row is 1. 1 if singular. */
int hawser__torus_tangent(struct hawser__torus *torus, double *t);
/* Sets defect and tail. */
void hawser__torus_judge(struct hawser__torus *torus);
/* y [size] of N points becomes y of `points`; `work` has that room. */
void hawser__torus_resample(double *y, double *work, int m, int N, int points);
/* The number of points becomes N, which is odd and at most torus->most; torus->x is not changed. */
void hawser__torus_points(struct hawser__torus *torus, int N);
/* out [N][m] = the polynomial, or its derivative, at theta_i + shift. */
void hawser__torus_shifted(double *out, struct hawser__torus *torus, double shift, int derivative);
/* Value at t of the polynomial of order (N - 1)/2 that is 1 at 0 and 0 at the other points, or its
 * derivative. */
double hawser__torus_cardinal(int N, double t, int derivative);

/* torus_growth.c: exponents [m - 1], descending, logarithms of growth per period normal to the circle,
 * after hawser__torus_newton; *error of them. 1: no memory. */
int hawser__torus_growth(struct hawser__torus *torus, double *exponent, double *error);

/* torus_measure.c: the quantities of point `index` of `list`, for which there is room. 1: no memory. */
struct hawser__torus_ruler;
struct hawser__torus_ruler *hawser__torus_ruler_new(const struct hawser_rom *rom);
void hawser__torus_ruler_free(struct hawser__torus_ruler *ruler);
int hawser__torus_measure(struct hawser__torus_ruler *ruler, struct hawser_tori *list, int index,
                          struct hawser__torus *torus);

/* torus_list.c: room for one more point; 1: no memory. Whether tori of this event can be followed. */
int hawser__tori_room(struct hawser_tori *list, const struct hawser_rom *rom);
enum hawser_status hawser__tori_check(const struct hawser_rom *rom, const struct hawser_frf *frf,
                                      int event, const struct hawser_tori_options *options,
                                      struct hawser_report *report);

#endif

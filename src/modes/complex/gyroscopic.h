/* modes/complex/gyroscopic.h - the code common to the methods for modes of a travelling cable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_GYROSCOPIC_H
#define HAWSER_MODES_GYROSCOPIC_H

#include <complex.h>

#include <hawser/gyroscopic.h>

#include "modes/cable.h"

enum hawser_status hawser__gyroscopic_solve(struct hawser_modes *modes,
                                            const struct hawser_statics *statics,
                                            const struct hawser_modes_options *options,
                                            struct hawser_report *report);
enum hawser_status hawser__gyroscopic_analytic(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_modes_options *options,
                                               struct hawser_report *report);
enum hawser_status hawser__gyroscopic_fdm(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* gyroscopic_spectral.c: the `count` largest eigenvalues mu [2n], ascending, of the Hermitian matrix of
 * modes with the frequencies omega [n] at rest, which G [n][n] couples, with the vectors z [count][2n];
 * mu is 1 over the frequency. *found: how many. Returns as LAPACK. */
int hawser__gyroscopic_pairs(double *mu, double complex *z, int *found, int count, const double *G,
                             const double *omega, int n);

/* Modes by a method for cables at rest, converted to complex modes, for a cable that does not
 * travel. */
enum hawser_status hawser__gyroscopic_at_rest(struct hawser_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              const char *method, struct hawser_report *report);

/* Set norm, phase, shares, family and symmetry of complex mode k from its eigenvalue, shape and
 * slope; returns its norm before. For hawser__modes_label. */
double hawser__complex_label(struct hawser_modes *modes, int k);

/* --- complex_mode.c: refinement and error bound of one mode of a travelling cable --- */

/* Fields of [2][D][points], real and imaginary part, in the frame of the tangent at mid-length. */
struct hawser__complex {
	const struct hawser__cable *cable;
	int plane, D, rows; /* rows = D*points */
	double nu, omega;
	double condition;   /* of omega, as in struct hawser_mode */
	double *x, *gradient, *strain; /* [2*rows] */
	double *scratch;               /* [(D + 1)*points] */
	double *before, *x0, *strain0; /* [2*rows] of the two previous iterates */
};

/* Initialise *t with work [HAWSER__COMPLEX_WORK][points], which holds all fields of a mode of
 * either plane. */
enum { HAWSER__COMPLEX_WORK = 13*HAWSER__MAX_D + 1 };
void hawser__complex_init(struct hawser__complex *t, const struct hawser__cable *cable, int plane,
                          double nu, double *work);

/* Set x and gradient from shape and slope [2][points][3] in the local frame. */
void hawser__complex_load(struct hawser__complex *t, const double *shape, const double *slope);
/* Compute shape and slope [2][points][3], zero on entry, from x and strain. */
void hawser__complex_store(const struct hawser__complex *t, double *shape, double *slope);

/* A step of inverse iteration, x := K^-1(omega^2 x - 2 i nu omega x') with gradient and strain.
 * Then omega := the positive root of x*(K + i omega B - omega^2)x = 0. */
void hawser__complex_step(struct hawser__complex *t);

/* An upper bound of the relative distance of omega from an eigenvalue: the smallest of the bounds
 * after each of `steps` further steps of inverse iteration. It holds for any x, since the matrix of
 * the first-order system for (K^1/2 q, q') is skew. Destroys x and the other fields. */
double hawser__complex_bound(struct hawser__complex *t, int steps);

#endif

/* modes/complex_mode.h - one mode of a travelling cable under the exact operator.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_COMPLEX_MODE_H
#define HAWSER_MODES_COMPLEX_MODE_H

#include "modes/cable.h"

/* Fields of [2][D][points], real and imaginary part, in the frame of the tangent at mid-length. */
struct hawser__complex {
	const struct hawser__cable *cable;
	int plane, D, rows; /* rows = D*points */
	double nu, omega;
	double condition;   /* of omega, as struct hawser_complex_mode has it */
	double *x, *gradient, *strain; /* [2*rows] */
	double *scratch;               /* [(D + 1)*points] */
	double *before, *x0, *strain0; /* [2*rows] of the two iterates before */
};

/* Work [HAWSER__COMPLEX_WORK][points] for a mode of either plane; all fields are laid out in
 * it. */
enum { HAWSER__COMPLEX_WORK = 13*HAWSER__MAX_D + 1 };
void hawser__complex_init(struct hawser__complex *t, const struct hawser__cable *cable, int plane,
                          double nu, double *work);

/* x and gradient from shape and slope [2][points][3] in the local frame. */
void hawser__complex_load(struct hawser__complex *t, const double *shape, const double *slope);
/* Shape and slope [2][points][3], zero before, from x and strain. */
void hawser__complex_store(const struct hawser__complex *t, double *shape, double *slope);

/* x := K^-1(omega^2 x - 2 i nu omega x'), with its gradient and strain: a step of inverse
 * iteration. Then omega becomes the root of x*(K + i omega B - omega^2)x = 0. */
void hawser__complex_step(struct hawser__complex *t);

/* How far omega can be from an eigenvalue, relative to that: a bound that holds for any x (the
 * inverse of the motion of (K^1/2 q, q') is skew), taken after each of `steps` further steps; the
 * smallest is returned. x, omega and all else are used up. */
double hawser__complex_bound(struct hawser__complex *t, int steps);

#endif

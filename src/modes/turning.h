/* modes/turning.h - one mode of a travelling cable under the exact operator.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_TURNING_H
#define HAWSER_MODES_TURNING_H

#include "modes/cable.h"

/* Fields of [2][D][points], real and imaginary part, in the frame of the tangent at mid-length. */
struct hawser__turning {
	const struct hawser__cable *cable;
	int plane, D, rows; /* rows = D*points */
	double nu, omega;
	double condition;   /* of omega, as struct hawser_complex_mode has it */
	double *x, *gradient, *strain; /* [2*rows] */
	double *scratch;               /* [(D + 1)*points] */
	double *before, *x0, *strain0; /* [2*rows] of the two iterates before */
};

/* Work [HAWSER__TURNING_WORK][points] for a mode of either plane; all fields are laid out in
 * it. */
enum { HAWSER__TURNING_WORK = 13*HAWSER__MAX_D + 1 };
void hawser__turning_init(struct hawser__turning *t, const struct hawser__cable *cable, int plane,
                          double nu, double *work);

/* x and gradient from shape and slope [2][points][3] in the local frame. */
void hawser__turning_load(struct hawser__turning *t, const double *shape, const double *slope);
/* Shape and slope [2][points][3], zero before, from x and strain. */
void hawser__turning_store(const struct hawser__turning *t, double *shape, double *slope);

/* x := K^-1(omega^2 x - 2 i nu omega x'), with its gradient and strain: a step of inverse
 * iteration. Then omega becomes the root of x*(K + i omega B - omega^2)x = 0. */
void hawser__turning_step(struct hawser__turning *t);

/* How far omega can be from an eigenvalue, relative to that: a bound that holds for any x (the
 * inverse of the motion of (K^1/2 q, q') is skew), taken after each of `steps` further steps; the
 * smallest is returned. x, omega and all else are used up. */
double hawser__turning_bound(struct hawser__turning *t, int steps);

#endif

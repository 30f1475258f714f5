/* response/half.h - free motions that start at zero velocity, by shooting over half a period
 * (hawser/backbone.h), with the operations of method.h that a correction and a tangent need.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_HALF_H
#define HAWSER_RESPONSE_HALF_H

#include "response/flow.h"
#include "response/method.h"

struct hawser__half {
	struct hawser__orbit base; /* y: u0 [n], Omega; samples of the half period, then mirrored */
	struct hawser_rom model;   /* the model without damping and load; shares its other members */
	double *no_damping;        /* [n][n] */
	struct hawser__flow flow;
	int steps;                 /* number of steps of the half period */
	int periods;               /* the motion repeats after so many periods of Omega; 1 */
	double *x, *A, *b;         /* [m] end of the half period, its derivatives [m][m], [m] */
	double *scale;             /* [n] metric: sizes of the coordinates */
	double *matrix;            /* [n + 1][n + 1] factors, column-major */
	int *pivot;                /* [n + 1] */
};

enum hawser_status hawser__half_init(struct hawser__half *half, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__half_release(struct hawser__half *half);

/* Double the number of steps. */
enum hawser_status hawser__half_refine(struct hawser__half *half, struct hawser_report *report);

/* Multipliers outside the unit circle by more than their error, which follows from the error of
 * integration; at the last derived defects. */
enum hawser_status hawser__half_unstable(struct hawser__half *half, int *unstable,
                                         struct hawser_report *report);

/* Sign and logarithm of the determinant of the factors, scaled. */
double hawser__half_determinant(const struct hawser__half *half, double *sign);
/* s [n + 1]: the vector in the kernel of the last derived defects, without the last row, that is normal
 * to the tangent t in the metric, of length 1. At a branch point. */
enum hawser_status hawser__half_other(const struct hawser__half *half, double *s, const double *t,
                                      struct hawser_report *report);

#endif

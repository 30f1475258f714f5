/* response/floquet/half.h - free motions that equal their own reverse in time, with some coordinates
 * reflected, by shooting over half a period (hawser/backbone.h), with the operations of method.h
 * that a correction and a tangent need.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_HALF_H
#define HAWSER_RESPONSE_HALF_H

#include "core/hold.h"
#include "response/time/flow.h"
#include "response/orbit/method.h"

struct hawser__half {
	struct hawser__orbit base; /* y: u0, or v0/Omega where sign is -1 [n], Omega; samples of the half
	                            * period, then mirrored */
	struct hawser_rom model;   /* the model without damping and load; shares its other members */
	double *G;                 /* [n][n] gyroscopic forces: the skew part of D */
	int *sign;                 /* [n] 1: the coordinate is even in time; -1: odd. Set by the owner */
	int *class_of;             /* [n] signs.h; those not of class 0 stay at rest. Set by the owner */
	int classes;
	double *y;                 /* [n + 1] of the last defects */
	struct hawser__flow flow;
	int steps;                 /* number of steps of the half period */
	int guessing;              /* 1: Jacobians may be extrapolated; near branch points that finds orbits
	                            * beside the curve */
	int periods;               /* the motion repeats after so many periods of Omega; 1 */
	double *x, *A, *b;         /* [m] end of the half period, its derivatives [m][m], [m] behind
	                            * each other */
	double *scale;             /* [n] metric: sizes of the coordinates */
	double *matrix;            /* [n + 1][n + 1] factors, column-major */
	int *pivot;                /* [n + 1] */
	struct hawser__hold hold;
};

enum hawser_status hawser__half_init(struct hawser__half *half, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__half_release(struct hawser__half *half);

/* Double the number of steps. */
enum hawser_status hawser__half_refine(struct hawser__half *half, struct hawser_report *report);

/* half_multipliers.c: multipliers outside the unit circle by more than their error, which follows
 * from the error of integration and the residual, relative, without the two that are 1 in every free
 * motion; at the last derived defects, where the curve has the tangent t [n + 1]. */
enum hawser_status hawser__half_unstable(const struct hawser__half *half, int *unstable,
                                         const double *t, double residual,
                                         struct hawser_report *report);

/* Sign and logarithm of the determinant of the factors, scaled. */
double hawser__half_determinant(const struct hawser__half *half, double *sign);
/* s [n + 1]: the vector in the kernel of the last derived defects, without the last row, that is normal
 * to the tangent t in the metric, of length 1. At a branch point. */
enum hawser_status hawser__half_other(const struct hawser__half *half, double *s, const double *t,
                                      struct hawser_report *report);

/* x [m]: the state at phase 0. */
void hawser__half_state(const struct hawser__half *half, double *x, const double *y);

/* Entry (j, k) of the derivative of what is bound at half the period by what is open at 0, in units
 * of the coordinates, with the signs or (other) the opposite ones; and the length of the whole row
 * j. */
double hawser__half_entry(const struct hawser__half *half, int j, int k, int other);
double hawser__half_length(const struct hawser__half *half, int j, int other);

/* half_class.c: at the last derived defects, for a class that is at rest: the determinant whose
 * zero says that a motion of it begins, of its signs or (other) of the opposite ones; relative, and
 * 0 where a pivot is below `least`. The factors are lost. And s [n + 1]: that motion, of length 1. */
double hawser__half_class_determinant(struct hawser__half *half, int c, int other, double least);
enum hawser_status hawser__half_class_other(struct hawser__half *half, double *s, int c, int other,
                                            struct hawser_report *report);

#endif

/* study/hill/mathieu.h - values of delta at which Mathieu's equation has a multiplier +1 or -1,
 * from its Hill matrices, with full precision for any width of a tongue.
 *
 *    r    order of a tongue: at its boundaries the harmonic r of the motion is the largest; the
 *         multiplier is +1 if r is even, -1 if it is odd. Tongue 0 is the region of negative stiffness
 *         and has an upper boundary only
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MATHIEU_H
#define HAWSER_STUDY_MATHIEU_H

#include <hawser/hill.h>

struct hawser__tongue {
	double edge[2]; /* delta of the lower and of the upper boundary; of tongue 0 the upper one
	                 * twice */
	double width;   /* its relative error is that of round-off, however small the width is */
	double truncation; /* if requested: change of an edge by eight further harmonics */
	int open;       /* 0: with this damping the tongue does not exist */
};

/* Compute tongue r at epsilon, with damping c >= 0; `certain`: also its truncation error.
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_tongue(struct hawser__tongue *tongue, int r, double epsilon,
                                          double c, int certain, struct hawser_report *report);

/* The highest harmonic required for boundary r at epsilon. */
int hawser__mathieu_highest(int r, double epsilon);

/* *delta becomes the boundary without damping whose motion is even or odd in the standard form, an
 * eigenvalue of the Hill matrix of the harmonics up to top. HAWSER_ERR_CONVERGENCE,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_eigenvalue(double *delta, int r, int odd, double epsilon, int top,
                                              struct hawser_report *report);

#endif

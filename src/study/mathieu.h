/* study/mathieu.h - values of delta at which Mathieu's equation has a multiplier +1 or -1, from its
 * Hill matrices, which tell them to the last digits however narrow a tongue is.
 *
 *   r    order of a tongue: at its boundaries the harmonic r is the largest of the motion; the
 *        multiplier is +1 where r is even, -1 where it is odd. Tongue 0 is the side of negative
 *        stiffness: it has an upper boundary alone
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MATHIEU_H
#define HAWSER_STUDY_MATHIEU_H

#include <hawser/hill.h>

struct hawser__tongue {
	double edge[2]; /* delta of the lower and of the upper boundary; of tongue 0 the upper, twice */
	double width;   /* relatively as precise, however small it is */
	double truncation; /* where it is asked for: change of an edge by eight harmonics more */
	int open;       /* 0: with this damping there is no instability */
};

/* Tongue r at epsilon, with damping c >= 0; certain: with its truncation. HAWSER_ERR_CONVERGENCE,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_tongue(struct hawser__tongue *tongue, int r, double epsilon,
                                          double c, int certain, struct hawser_report *report);

/* The highest harmonic that boundary r needs at epsilon. */
int hawser__mathieu_highest(int r, double epsilon);

/* *delta: the boundary without damping whose motion is even or odd in the standard form, as eigenvalue
 * of the Hill matrix of the harmonics up to top. HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_eigenvalue(double *delta, int r, int odd, double epsilon, int top,
                                              struct hawser_report *report);

#endif

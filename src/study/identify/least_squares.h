/* study/identify/least_squares.h - nonlinear least squares by Levenberg and Marquardt's method.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_LEAST_SQUARES_H
#define HAWSER_STUDY_LEAST_SQUARES_H

#include <hawser/status.h>

struct hawser__least_squares {
	int unknowns, count; /* count >= unknowns */
	/* Residuals r [count] at x [unknowns] or, with r NULL, their derivatives J [unknowns][count].
	 * HAWSER_ERR_MEMORY ends the fit; after another status from residuals x is not accepted. */
	enum hawser_status (*residuals)(void *context, double *r, double *J, const double *x);
	void *context;
	double least_step; /* the fit has converged if a step changes no unknown by more than this */
	int steps;         /* largest number */
};

/* Improve x [unknowns] from where it is. *sum: the sum of squares there. *steps: those made; if it is
 * problem->steps, the fit has not converged. The status is that of `residuals` at the beginning, of
 * the derivatives, or HAWSER_ERR_MEMORY. */
enum hawser_status hawser__least_squares(double *x, double *sum, int *steps,
                                         const struct hawser__least_squares *problem);

#endif

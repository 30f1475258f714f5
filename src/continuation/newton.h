/* continuation/newton.h - Newton's method for a point of a curve: equations and a plane across it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTINUATION_NEWTON_H
#define HAWSER_CONTINUATION_NEWTON_H

#include "continuation/curve.h"
#include "continuation/metric.h"

struct hawser__newton {
	void *owner;
	const struct hawser__metric *metric;
	double tolerance; /* of the residual, and of what the last step leaves */
	/* *residual of the equations at z [size], relative to the size of the point. */
	enum hawser_status (*evaluate)(void *owner, double *residual, double *z);
	/* The same residual without derivatives, which remain those of the point before; or NULL. */
	enum hawser_status (*check)(void *owner, double *residual, const double *z);
	/* The step dz [size] from z within the plane across row [size]; 1: there is none. */
	int (*solve)(void *owner, double *dz, const double *z, const double *row);
	/* After a step of this length; 1: z is no point any more. */
	int (*moved)(void *owner, const double *z, double length);
};

/* Corrects z [size]; dz [size] is work space. *failed is 0 where it converges: the residual is within
 * the tolerance, and by the ratio of the last two steps the next would be shorter than a tenth of it.
 * With `check` the ratio may be that of the residuals before and after a step below 1e-6, and the
 * derivatives may be those before the last step, if that is below 1e-5. It is given up when steps
 * shrink by less than 0.7, grow beyond 1, or are too many. */
enum hawser_status hawser__newton_correct(const struct hawser__newton *newton, double *z, double *dz,
                                          const double *row, struct hawser__correction *did,
                                          int *failed) HAWSER_MUST_CHECK;

#endif

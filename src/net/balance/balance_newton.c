/* net/balance/balance_newton.c - Newton's method for motions of a mesh, with factors that are made anew
 * where they reduce its steps too slowly.
 *
 *   along    normal of the plane in which a motion is looked for, then its tangent
 *   sweep    F^-1 dR/dOmega: of the motion, -sweep dOmega is what Omega changes
 *
 * The border of the matrix is eliminated last, although F is nearly singular at a fold: a fold is met
 * within some 1e-4 of the arc, so that F loses no more digits than that, and residuals are exact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "net/balance/balance.h"

enum { STEPS = 30 };
static const double enough = 1e-8;   /* of a step, in the metric: the next one is a third at most */
static const double straight = 1e-7; /* of a change of the tangent; its effect is of second order */
static const double slow = 0.3;      /* factor of successive steps above which factors are made anew */

/* The right side r [size - 1] becomes the step [size] in the plane. */
static void step_of(struct hawser__mesh_balance *balance, double *r, const double *along)
{
	int size = (int)balance->size;
	double part;

	hawser__nodal_solve(&balance->blocks, r);
	r[size - 1] = 0.0;
	part = hawser__mesh_balance_dot(balance, along, r)/
	       hawser__mesh_balance_dot(balance, along, balance->sweep);
	cblas_dscal(size, -1.0, r, 1);
	cblas_daxpy(size, part, balance->sweep, 1, r, 1);
}

static double length(const struct hawser__mesh_balance *balance, const double *a)
{
	return sqrt(hawser__mesh_balance_dot(balance, a, a));
}

/* 0: there is no motion within the distance. */
static int descend(struct hawser__mesh_balance *balance, double *y, const double *along, double far)
{
	double before = INFINITY, moved = 0.0;

	for (int i = 0; i < STEPS; i++) {
		double size;

		if (!balance->factored) {
			if (!hawser__mesh_balance_factor(balance, y))
				return 0;
			before = INFINITY;
		}
		hawser__mesh_balance_residual(balance, balance->work, y);
		step_of(balance, balance->work, along);
		size = length(balance, balance->work);
		if (size > slow*before) {
			balance->factored = 0;
			continue;
		}
		moved += size;
		if (!(moved <= far))
			return 0;
		cblas_daxpy((int)balance->size, 1.0, balance->work, 1, y, 1);
		if (size < enough)
			return 1;
		before = size;
	}
	return 0;
}

/* The tangent of the last motion by the factors there are; 0: they are too far off. */
static int tangent(struct hawser__mesh_balance *balance, double *t, const double *along)
{
	double before = INFINITY, size = 1.0;

	memcpy(t, balance->sweep, balance->size*sizeof *t);
	cblas_dscal((int)balance->size, 1.0/hawser__mesh_balance_dot(balance, along, t), t, 1);
	while (size > straight) {
		hawser__mesh_balance_product(balance, balance->work, t);
		step_of(balance, balance->work, along);
		size = length(balance, balance->work)/length(balance, t);
		if (!(size <= slow*before))
			return 0;
		cblas_daxpy((int)balance->size, 1.0, balance->work, 1, t, 1);
		before = size;
	}
	return 1;
}

void hawser__mesh_balance_correct(struct hawser__mesh_balance *balance, double *y, double *along,
                                  int *lost, double far)
{
	double *t = balance->spare;

	*lost = !descend(balance, y, along, far);
	if (*lost)
		return;
	if (!tangent(balance, t, along))
		*lost = !hawser__mesh_balance_factor(balance, y) || !tangent(balance, t, along);
	if (*lost)
		return;
	memcpy(along, t, balance->size*sizeof *t);
	cblas_dscal((int)balance->size, 1.0/length(balance, t), along, 1);
}

/* continuation/newton.c - see newton.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "continuation/newton.h"

#define MAX_ITERATIONS 10     /* with the worst contraction, the step is halved before; chosen */
#define NEAR 1e-5             /* length of a last step before which derivatives are good enough for
                               * tangents and signs of test functions; chosen */
#define NEARER 1e-6           /* the same of a step that does not show convergence yet, as the only
                               * one of a point: many in a row may have the derivatives of their
                               * predictions; chosen */
#define WORST_CONTRACTION 0.7 /* largest ratio of successive steps; chosen */

enum hawser_status hawser__newton_correct(const struct hawser__newton *newton, double *z, double *dz,
                                          const double *row, struct hawser__correction *did,
                                          int *failed)
{
	double tolerance = newton->tolerance, previous = 0.0;
	int done = 0;

	*failed = 1;
	did->contraction = 0.0;
	for (int i = 0; i <= MAX_ITERATIONS; i++) {
		double length, ratio, before;
		enum hawser_status status = newton->evaluate(newton->owner, &did->residual, z);

		if (status || !isfinite(did->residual))
			return status;
		if (done && did->residual <= tolerance) {
			*failed = 0;
			return HAWSER_OK;
		}
		if (newton->solve(newton->owner, dz, z, row))
			return HAWSER_OK;
		length = hawser__metric_length(newton->metric, dz);
		ratio = previous > 0.0 ? length/previous : 0.0;
		did->iterations = i + 1;
		if (i == 0)
			did->first = length;
		if (i == 1)
			did->contraction = ratio;
		if (!isfinite(length) || length > 1.0 ||
		    (ratio > WORST_CONTRACTION && length > tolerance))
			return HAWSER_OK;
		for (int k = 0; k < newton->metric->size; k++)
			z[k] += dz[k];
		if (newton->moved(newton->owner, z, length))
			return HAWSER_OK;
		done = length <= 0.1*tolerance || (i > 0 && ratio*length <= 0.1*tolerance);
		previous = length;
		before = did->residual;
		if (!newton->check || length > (done ? NEAR : NEARER))
			continue;
		if ((status = newton->check(newton->owner, &did->residual, z)))
			return status;
		done |= length*did->residual <= 0.1*tolerance*before;
		*failed = !(done && did->residual <= tolerance);
		if (!*failed)
			return HAWSER_OK;
	}
	return HAWSER_OK;
}

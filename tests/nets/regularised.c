/* tests/nets/regularised.c - equilibrium with the one-sided law: Newton's method with B's
 * regularised tangent.
 *
 * eps  strain of an element, l/length0 - 1
 *
 * Internal forces are those of the one-sided law (B 3.25). The tangent (B 3.26) is exact for elements
 * with eps >= 0; those below, whose tangent is zero, get the stiffness
 * (EA/length0)*|eps|/(1 + |eps|) in all directions, which makes the matrix positive definite. It is
 * no derivative: full steps converge slowly or circle where many elements begin compressed. For
 * comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "tests/nets/comparison.h"

enum { MOST = 500 };

/* Blocks of the matrix, and the right side; work->T has the tensions at mesh->q. */
static void assemble(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i), k = mesh->EA[i]/mesh->length0[i];
		double eps = (l - mesh->length0[i])/mesh->length0[i];

		work->a[i] = mesh->density[i] > 0.0 ? mesh->density[i] : k*fabs(eps)/(1.0 + fabs(eps));
		work->b[i] = mesh->density[i] > 0.0 || eps < 0.0 ? 0.0 : k/(1.0 + eps);
	}
	hawser__net_right(work, work->T);
}

enum hawser_status net_regularised(struct hawser__net_work *work, int *done,
                                   struct hawser_report *report)
{
	int most = work->most ? work->most : MOST, definite = 1;
	enum hawser_status status = HAWSER_OK;
	double residual;

	*done = 0;
	net_start(work);
	residual = hawser__net_residual(work);
	while (!status && !*done && work->iterations < most && isfinite(residual)) {
		assemble(work);
		status = hawser__net_factor(work, &definite, report);
		if (!status && definite)
			status = hawser__sparse_solve(work->x, work->sparse, report);
		if (status || !definite)
			break;
		hawser__net_move(work, 1.0);
		work->factored = 0;
		work->iterations++;
		residual = hawser__net_residual(work);
		*done = residual <= work->tolerance;
	}
	return status;
}

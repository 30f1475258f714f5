/* tests/nets/mixed.c - equilibrium of a net without slack members: Newton's method for positions
 * and forces.
 *
 * N  force of an element, an unknown of its own beside the positions q
 *
 * That of net/statics/finish.c, but that no element turns slack: where a member is slack it does not
 * converge.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "tests/nets/comparison.h"

enum { MOST = 40, CLIPPED = 4 };
#define LONGEST 2.0 /* most change of an element's vector, over its length0. It matters far
                     * from the equilibrium alone: from straight cables with noise all random cables
                     * are solved with 1 to 4, six in ten without it */

static void assemble(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = fmax(hawser__mesh_direction(e, mesh, i), 1e-12*mesh->length0[i]), along;

		if (mesh->density[i] > 0.0) {
			work->a[i] = mesh->density[i];
			work->b[i] = 0.0;
			continue;
		}
		work->a[i] = work->N[i]/l;
		along = fmin(mesh->EA[i]/mesh->length0[i], HAWSER__NET_RIGID*work->a[i]);
		work->b[i] = along - work->a[i];
		work->T[i] = work->N[i] + along*(l - mesh->length0[i] -
		                                 work->N[i]*mesh->length0[i]/mesh->EA[i]);
	}
	hawser__net_right(work, work->T);
}

/* The new forces; returns 1 if one of them is at its lower bound. */
static int forces(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	int clipped = 0;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], d[3], N;

		if (mesh->density[i] > 0.0)
			continue;
		hawser__mesh_direction(e, mesh, i);
		hawser__net_stretch(d, work, i);
		N = work->T[i] + (work->a[i] + work->b[i])*(e[0]*d[0] + e[1]*d[1] + e[2]*d[2]);
		clipped |= N < 1e-6*work->weight;
		work->N[i] = fmax(N, fmax(0.1*work->N[i], 1e-6*work->weight));
	}
	return clipped;
}

/* The part of the step for which no element changes by more than LONGEST. */
static double part(const struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double part = 1.0;

	for (int i = 0; i < mesh->elements; i++) {
		double d[3], size;

		hawser__net_stretch(d, work, i);
		size = sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
		if (part*size > LONGEST*mesh->length0[i])
			part = LONGEST*mesh->length0[i]/size;
	}
	return part;
}

enum hawser_status net_mixed(struct hawser__net_work *work, int *done, struct hawser_report *report)
{
	int most = work->most ? work->most : MOST, clipped = 0;
	enum hawser_status status = HAWSER_OK;

	*done = 0;
	net_start(work);
	work->own = 1;
	for (int i = 0; i < most && !*done; i++) {
		double residual, floor;
		int definite;

		assemble(work);
		status = hawser__net_factor(work, &definite, report);
		if (!status && definite)
			status = hawser__sparse_solve(work->x, work->sparse, report);
		if (status || !definite)
			break;
		clipped = forces(work) ? clipped + 1 : 0;
		hawser__net_move(work, part(work));
		work->iterations++;
		*done = hawser__net_settled(work, &residual, &floor);
		if (!isfinite(residual) || (!work->most && clipped > CLIPPED))
			break;
	}
	if (!status && !*done)
		*done = hawser__net_lawful(work);
	return status;
}

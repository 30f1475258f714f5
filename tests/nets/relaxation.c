/* tests/nets/relaxation.c - equilibrium by dynamic relaxation with kinetic damping.
 *
 * m  mass of a node, chosen so that the time step is 1
 * v  velocity of a node, at half steps
 *
 * Explicit steps of a motion without damping, which begins at rest; where its kinetic energy has passed
 * a peak, the net is put where it was at the peak and begins at rest again (Cundall; Barnes). The
 * stiffness of an element is at most k = EA/length0 in any direction, so that steps of 1 are stable
 * with m > sum of k over the elements of a node, divided by 2 (Gerschgorin). No matrix is factored, but
 * the number of steps grows with the square root of its condition number: 2e5 for a net that Newton's
 * method solves in 7 iterations. For comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "tests/nets/comparison.h"

enum { MOST = 1000000 };
#define SAFETY 1.05 /* of the masses */

static void masses(double *m, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++)
		m[i] = 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double k = mesh->density[i] > 0.0 ? mesh->density[i] : mesh->EA[i]/mesh->length0[i];

		m[mesh->end[i][0]] += SAFETY*k/2.0;
		m[mesh->end[i][1]] += SAFETY*k/2.0;
	}
}

/* New velocities; returns the kinetic energy. first: the half step from rest. */
static double accelerate(double (*v)[3], const double *m, const struct hawser__net_work *work,
                         int first)
{
	const struct hawser__mesh *mesh = work->mesh;
	double energy = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0) {
				double a = -work->residual[i][k]/m[i];

				v[i][k] = first ? a/2.0 : v[i][k] + a;
				energy += m[i]*v[i][k]*v[i][k]/2.0;
			}
	return energy;
}

/* q += factor*v + half*a/2. */
static void move(struct hawser__net_work *work, double (*v)[3], const double *m, double factor,
                 double half)
{
	struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] += factor*v[i][k] - half*work->residual[i][k]/(2.0*m[i]);
}

enum hawser_status net_relaxation(struct hawser__net_work *work, int *done,
                                  struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	double *m = malloc((size_t)mesh->nodes*sizeof *m), residual, last = 0.0;
	double (*v)[3] = calloc((size_t)mesh->nodes, sizeof *v);
	int most = work->most ? work->most : MOST, first = 1;
	enum hawser_status status = m && v ? HAWSER_OK : hawser__no_memory(report, "net");

	*done = 0;
	net_start(work);
	if (!status) {
		masses(m, mesh);
		residual = hawser__net_residual(work);
		while (!(*done = residual <= work->tolerance) && work->iterations < most &&
		       isfinite(residual)) {
			double energy = accelerate(v, m, work, first);

			first = energy < last;
			/* at the end of this step the peak is 3/2 steps back: half a step before its beginning */
			move(work, v, m, first ? -0.5 : 1.0, first ? 1.0 : 0.0);
			last = first ? 0.0 : energy;
			work->iterations++;
			residual = hawser__net_residual(work);
		}
	}
	work->factored = 0;
	free(m);
	free(v);
	return status;
}

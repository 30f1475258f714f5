/* tests/nets/descent.c - equilibrium with the one-sided law: Newton's method with the true
 * tangent, made definite, and steps that lower the energy.
 *
 * Pi      energy, convex in the positions
 * lambda  added to the diagonal of the tangent, N/m
 *
 * The tangent of the energy, sum of k*e*e' + (T/l)*(I - e*e') over the taut elements, is positive
 * semidefinite, and zero where all elements of a node are slack. With lambda it gives a direction of
 * descent. The step is halved until Armijo's condition holds; lambda falls by 10 after a full step and
 * grows by 10 after a short one. It cannot go wrong, and is slow: while elements are slack their nodes
 * are held by lambda alone. For comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "tests/nets/comparison.h"

enum { MOST = 500, HALVINGS = 40 };

/* Pi at mesh->q. */
static double energy_of(const struct hawser__mesh *mesh)
{
	double sum = 0.0, e[3];

	for (int i = 0; i < mesh->elements; i++) {
		double l = hawser__mesh_direction(e, mesh, i), p = l - mesh->length0[i];

		if (mesh->density[i] > 0.0)
			sum += mesh->density[i]*l*l/2.0;
		else if (p > 0.0)
			sum += mesh->EA[i]/mesh->length0[i]*p*p/2.0;
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			sum -= mesh->force[i][k]*mesh->q[i][k];
	return sum;
}

/* Gradient times the step x, at mesh->q; sets work->residual and work->T. */
static double slope(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double sum = 0.0;

	hawser__net_residual(work);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				sum += work->residual[i][k]*work->x[mesh->unknown[i][k]];
	return sum;
}

/* The step for the tangent at mesh->q with lambda. */
static enum hawser_status direction(struct hawser__net_work *work, double lambda, int *definite,
                                    struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	hawser__sparse_zero(work->sparse);
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i), across;

		across = mesh->density[i] > 0.0 ? mesh->density[i] : work->T[i] > 0.0 ? work->T[i]/l : 0.0;
		hawser__sparse_add(work->sparse, i, across, mesh->density[i] > 0.0 || work->T[i] <= 0.0 ? 0.0
		                   : mesh->EA[i]/mesh->length0[i] - across, e);
	}
	for (int j = 0; j < mesh->unknowns; j++)
		hawser__sparse_diagonal(work->sparse, j, lambda);
	hawser__net_right(work, work->T);
	status = hawser__sparse_factor(work->sparse, definite, report);
	return status || !*definite ? status : hawser__sparse_solve(work->x, work->sparse, report);
}

/* Go along x as far as the energy falls; returns the part of the step, 0 if there is none. Close to the
 * least energy its differences are round-off, and the slope decides. */
static double line(struct hawser__net_work *work)
{
	struct hawser__mesh *mesh = work->mesh;
	size_t size = (size_t)mesh->nodes*sizeof *mesh->q;
	double before = energy_of(mesh), first = slope(work), step = 1.0;
	double scale = 1e-13*(fabs(before) + work->weight*work->reach);

	memcpy(work->start, mesh->q, size);
	for (int i = 0; i < HALVINGS; i++, step *= 0.5) {
		double now, change;

		hawser__net_move(work, step);
		now = slope(work);
		change = energy_of(mesh) - before;
		if (change <= 1e-4*step*first || (change <= scale && fabs(now) <= 0.9*fabs(first)))
			return step;
		memcpy(mesh->q, work->start, size);
	}
	return 0.0;
}

enum hawser_status net_descent(struct hawser__net_work *work, int *done,
                               struct hawser_report *report)
{
	int most = work->most ? work->most : MOST, definite = 1;
	enum hawser_status status = HAWSER_OK;
	double residual, lambda = work->weight/work->reach;

	*done = 0;
	net_start(work);
	residual = hawser__net_residual(work);
	while (!status && !*done && work->iterations < most && isfinite(residual)) {
		double step;

		status = direction(work, lambda, &definite, report);
		if (status || !definite)
			break;
		step = line(work);
		work->iterations++;
		residual = hawser__net_residual(work);
		*done = residual <= work->tolerance;
		lambda = step == 1.0 ? lambda/10.0 : lambda*10.0;
	}
	work->factored = 0;
	return status;
}

/* net/statics/start.c - where the methods of statics begin.
 *
 * N  force of an element
 *
 * Every element is given a force density N/length0: one linear problem, from which the positions follow
 * without any guess of a shape.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"

static double chord_of(const struct hawser__mesh *mesh, int from, int to)
{
	const double *a = mesh->q[from], *b = mesh->q[to];

	return sqrt((a[0] - b[0])*(a[0] - b[0]) + (a[1] - b[1])*(a[1] - b[1]) +
	            (a[2] - b[2])*(a[2] - b[2]));
}

static int held(const struct hawser__mesh *mesh, int node)
{
	const int *unknown = mesh->unknown[node];

	return unknown[0] < 0 && unknown[1] < 0 && unknown[2] < 0;
}

/* If they are not known: a fifth of all loads or, between nodes that are held, what the strain of the
 * chord gives. */
void hawser__net_start_forces(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; work->first && i < mesh->elements; i++)
		work->N[i] = mesh->touches ? work->first[i] : fmax(work->first[i], 1e-6*work->weight);
	for (int c = 0; !work->first && c < mesh->cables; c++) {
		int first = mesh->first[c], last = mesh->first[c + 1] - 1;
		int from = mesh->end[first][0], to = mesh->end[last][1];
		double length0 = 0.0, N = 0.2*work->weight;

		for (int i = first; i <= last; i++)
			length0 += mesh->length0[i];
		if (held(mesh, from) && held(mesh, to) && length0 > 0.0)
			N = fmax(N, mesh->EA[first]*(chord_of(mesh, from, to)/length0 - 1.0));
		for (int i = first; i <= last; i++)
			work->N[i] = N;
	}
}

/* Around an obstacle: what the strain of the straight cables gives, of all together. */
static void stretched(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double chords = 0.0;

	for (int c = 0; c < mesh->cables; c++)
		chords += chord_of(mesh, mesh->end[mesh->first[c]][0], mesh->end[mesh->first[c + 1] - 1][1]);
	for (int i = 0; i < mesh->elements; i++)
		work->N[i] = fmax(work->N[i], mesh->EA[i]*(chords/work->reach - 1.0));
}

/* The positions that the force densities N/length0 give. */
static enum hawser_status densities(struct hawser__net_work *work, struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	int definite = 0;
	enum hawser_status status;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] = 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i);

		work->a[i] = mesh->density[i] > 0.0 ? mesh->density[i] : work->N[i]/mesh->length0[i];
		work->b[i] = 0.0;
		work->T[i] = work->a[i]*l; /* of positions 0 */
	}
	hawser__net_right(work, work->T);
	status = hawser__net_factor(work, &definite, report);
	if (!status && !definite)
		return hawser__fail(report, HAWSER_ERR_NAN, "net",
		                    "the matrix of the force densities is not positive definite: the loads or "
		                    "stiffnesses are out of range");
	if (!status)
		status = hawser__sparse_solve(work->x, work->sparse, report);
	if (!status)
		hawser__net_move(work, 1.0);
	return status;
}

/* Cables straight between their ends. */
static void straighten(struct hawser__mesh *mesh)
{
	for (int c = 0; c < mesh->cables; c++) {
		int first = mesh->first[c], n = mesh->first[c + 1] - first;
		const double *from = mesh->q[mesh->end[first][0]], *to = mesh->q[mesh->end[first + n - 1][1]];

		for (int i = 1; i < n; i++)
			for (int k = 0; k < 3; k++)
				mesh->q[mesh->inner[c] + i - 1][k] = from[k] + (to[k] - from[k])*i/n;
	}
}

enum hawser_status hawser__net_begin(struct hawser__net_work *work,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = HAWSER_OK;

	work->first = options->keep_start ? options->N : NULL;
	hawser__net_start_forces(work);
	if (!options->keep_start && mesh->around)
		stretched(work);
	else if (!options->keep_start)
		status = densities(work, report);
	if (!status && !options->keep_start && mesh->touches) {
		/* a cable that hangs low would have circles between its nodes */
		if (!hawser__touch_convex(mesh))
			straighten(mesh);
		status = hawser__touch_start(mesh, report);
	}
	memcpy(work->start, mesh->q, (size_t)mesh->nodes*sizeof *mesh->q);
	return status;
}

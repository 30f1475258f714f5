/* rom/condense_load.c - the load on the modes that are not kept.
 *
 *   f      load per length;  w_jk  what the others do in answer to the pair (condense.h)
 *   P      f summed along the cable, from end A to s
 *
 * Modes that follow statically follow the load as well: the potential that is left after they have
 * found their place is, beside -1/2 K[w, w], less by the work of the load on w = 1/2 u_j u_k w_jk. So
 * coordinate j feels the force cos(Omega t) u_k (f, w_jk): the load tightens and slackens the cable as
 * it goes, above all the part of it that acts along the cable, on modes that no one would keep. What
 * the load does to the others to second order is left out.
 *
 * w vanishes at both ends, so the integral of f.w is that of -P.w', and w' is what is known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/build.h"
#include "rom/condense.h"

/* Entries below this part of the sum of the sizes of their terms are zero by a symmetry. */
#define ROUND_OFF 1e-11

struct work {
	const struct hawser_modes *modes;
	double *running;  /* [3][points] f summed from end A, in global axes */
	double *unit;     /* [points] zero but for one node */
	double *weight;   /* [points][3] of the strains at the grid's points, in -(f, w) */
	double from, to;  /* loaded part */
	double start[3], end[3]; /* running sums there */
};

static enum hawser_status sum_up(struct work *work, const struct hawser_scene *scene,
                                 struct hawser_report *report)
{
	const struct hawser_grid *grid = &work->modes->grid;
	struct hawser__reference reference;
	int points = grid->points;
	double *global = malloc(3*(size_t)points*sizeof *global), local[3];
	enum hawser_status status;

	if (!global)
		return hawser__no_memory(report, "rom");
	status = hawser__reference_init(&reference, grid, grid->order - 1, report);
	for (int p = 0; !status && p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&work->modes->statics, grid->s[p]);

		hawser__load_at(local, scene, work->modes, grid->s[p]);
		global[p] = local[0]*at.ex - local[1]*at.ey;
		global[points + p] = local[0]*at.ey + local[1]*at.ex;
		global[2*points + p] = local[2];
	}
	for (int axis = 0; !status && axis < 3; axis++) {
		double *running = work->running + axis*points;

		hawser__grid_running(running, grid, &reference, global + axis*points);
		hawser__grid_at(&work->start[axis], grid, running, 1, 1, work->from);
		hawser__grid_at(&work->end[axis], grid, running, 1, 1, work->to);
	}
	if (!status)
		hawser__reference_clear(&reference);
	free(global);
	return status;
}

/* P at s, in the local frame. */
static void sum_at(double local[3], const struct work *work, double s)
{
	const struct hawser_grid *grid = &work->modes->grid;
	struct hawser_frame_point at = hawser_statics_frame(&work->modes->statics, s);
	double global[3];

	for (int axis = 0; axis < 3; axis++) {
		double sum = work->end[axis];

		if (s < work->to)
			hawser__grid_at(&sum, grid, work->running + axis*grid->points, 1, 1, s);
		global[axis] = s > work->from ? sum - work->start[axis] : 0.0;
	}
	local[0] = global[0]*at.ex + global[1]*at.ey;
	local[1] = global[1]*at.ex - global[0]*at.ey;
	local[2] = global[2];
}

/* The part [from, to] of element e: its own rule, shrunk, on the strains' interpolant. */
static void add_panel(struct work *work, int e, double from, double to)
{
	const struct hawser_grid *grid = &work->modes->grid;
	double shrink = (to - from)/(grid->edge[e + 1] - grid->edge[e]);
	int first = e*grid->order;

	for (int i = 0; i < grid->order; i++) {
		double s = from + 0.5*(to - from)*(1.0 + grid->node[i]), sum[3], part;

		sum_at(sum, work, s);
		for (int k = 0; k < grid->order; k++) {
			work->unit[first + k] = 1.0;
			hawser__grid_at(&part, grid, work->unit, 1, 1, s);
			work->unit[first + k] = 0.0;
			for (int axis = 0; axis < 3; axis++)
				work->weight[3*(first + k) + axis] += shrink*grid->weight[first + i]*
				                                      part*sum[axis];
		}
	}
}

static void add_whole(struct work *work, int e)
{
	const struct hawser_grid *grid = &work->modes->grid;

	for (int p = e*grid->order; p < (e + 1)*grid->order; p++) {
		double sum[3];

		sum_at(sum, work, grid->s[p]);
		for (int axis = 0; axis < 3; axis++)
			work->weight[3*p + axis] = grid->weight[p]*sum[axis];
	}
}

/* P has corners where the loaded part ends: the elements are cut there. */
static void add_element(struct work *work, int e)
{
	const double *edge = work->modes->grid.edge + e;
	double cut[4] = {edge[0], fmin(fmax(work->from, edge[0]), edge[1]),
		fmin(fmax(work->to, edge[0]), edge[1]), edge[1]};

	for (int i = 0; i < 3; i++)
		if (cut[i] == edge[0] && cut[i + 1] == edge[1])
			add_whole(work, e);
		else if (cut[i] < cut[i + 1])
			add_panel(work, e, cut[i], cut[i + 1]);
}

/* The sum of the products' sizes, against which a sum is round-off. */
static double size_of(const double *a, const double *b, int count)
{
	double sum = 0.0;

	for (int i = 0; i < count; i++)
		sum += fabs(a[i]*b[i]);
	return sum;
}

enum hawser_status hawser__condensed_load(const struct hawser__condensed *condensed, double *force,
                                          const struct hawser_modes *modes,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	size_t points = (size_t)modes->grid.points;
	int width = 3*modes->grid.points;
	struct work work = {.modes = modes, .from = scene->load.extent[0]*modes->statics.l,
		.to = scene->load.extent[1]*modes->statics.l,
		.running = malloc(3*points*sizeof(double)), .unit = calloc(points, sizeof(double)),
		.weight = calloc(3*points, sizeof(double))};
	enum hawser_status status = work.running && work.unit && work.weight
	                            ? sum_up(&work, scene, report)
	                            : hawser__no_memory(report, "rom");

	if (status)
		goto done;
	for (int e = 0; e < modes->grid.elements; e++)
		add_element(&work, e);
	for (int x = 0; x < condensed->pairs; x++) {
		const double *strain = condensed->strain + (size_t)x*3*points;

		force[x] = -cblas_ddot(width, strain, 1, work.weight, 1);
		if (fabs(force[x]) <= ROUND_OFF*size_of(strain, work.weight, width))
			force[x] = 0.0;
	}
done:
	free(work.running);
	free(work.unit);
	free(work.weight);
	return status;
}

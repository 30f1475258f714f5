/* rom/condense_load.c - effect of the load on the modes that are not kept.
 *
 *    f      load per length
 *    P      integral of f along the cable from end A to s
 *
 * Condensed modes also respond to the load, which adds cos(Omega t) T_jk to the stiffness of the
 * kept modes (follow.h): the load varies the tension. The largest effect is due to its component
 * along the cable, acting on longitudinal modes, which are hardly ever kept. Second-order effects
 * of the load on the condensed modes are neglected.
 *
 * Since a displacement vanishes at both ends, the work of f on it is that of -P on its derivative.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/build.h"
#include "rom/follow.h"

/* The running sum, in global axes. */
struct sums {
	const struct hawser_modes *modes;
	double *along;           /* [3][points] from end A, as if the whole cable were loaded */
	double from, to;         /* loaded part */
	double start[3], end[3]; /* `along` at its ends */
};

static enum hawser_status sum_up(struct sums *sums, const struct hawser_scene *scene,
                                 struct hawser_report *report)
{
	const struct hawser_grid *grid = &sums->modes->grid;
	struct hawser__reference reference;
	int points = grid->points;
	double *global = malloc(3*(size_t)points*sizeof *global), local[3];
	enum hawser_status status;

	if (!global)
		return hawser__no_memory(report, "rom");
	status = hawser__reference_init(&reference, grid, grid->order - 1, report);
	for (int p = 0; !status && p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&sums->modes->statics, grid->s[p]);

		hawser__load_at(local, scene, sums->modes, grid->s[p]);
		global[p] = local[0]*at.ex - local[1]*at.ey;
		global[points + p] = local[0]*at.ey + local[1]*at.ex;
		global[2*points + p] = local[2];
	}
	for (int axis = 0; !status && axis < 3; axis++) {
		double *along = sums->along + axis*points;

		hawser__grid_running(along, grid, &reference, global + axis*points);
		hawser__grid_at(&sums->start[axis], grid, along, 1, 1, sums->from);
		hawser__grid_at(&sums->end[axis], grid, along, 1, 1, sums->to);
	}
	if (!status)
		hawser__reference_clear(&reference);
	free(global);
	return status;
}

/* -P at s, in the local frame. */
static void pull_at(double local[3], const struct sums *sums, double s)
{
	const struct hawser_grid *grid = &sums->modes->grid;
	struct hawser_frame_point at = hawser_statics_frame(&sums->modes->statics, s);
	double global[3];

	for (int axis = 0; axis < 3; axis++) {
		double sum = sums->end[axis];

		if (s < sums->to)
			hawser__grid_at(&sum, grid, sums->along + axis*grid->points, 1, 1, s);
		global[axis] = s > sums->from ? sums->start[axis] - sum : 0.0;
	}
	local[0] = global[0]*at.ex + global[1]*at.ey;
	local[1] = global[1]*at.ex - global[0]*at.ey;
	local[2] = global[2];
}

void hawser__load_ends(double ends[2], const struct hawser_modes *modes,
                       const struct hawser_scene *scene)
{
	for (int i = 0; i < 2; i++)
		ends[i] = scene->load.extent[i]*modes->statics.l;
}

enum hawser_status hawser__load_pull(struct hawser__stations *stations,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	const struct hawser_modes *modes = stations->modes;
	size_t points = (size_t)modes->grid.points;
	struct sums sums = {.modes = modes, .along = malloc(3*points*sizeof(double))};
	double ends[2];
	enum hawser_status status;

	hawser__load_ends(ends, modes, scene);
	sums.from = ends[0];
	sums.to = ends[1];
	status = sums.along ? sum_up(&sums, scene, report) : hawser__no_memory(report, "rom");
	for (int i = 0; !status && i < stations->count; i++)
		pull_at(stations->p + 3*i, &sums, stations->s[i]);
	for (int axis = 0; !status && axis < 3; axis++)
		stations->beyond[axis] = sums.end[axis] - sums.start[axis];
	free(sums.along);
	return status;
}

enum hawser_status hawser__follow_load(double *T, int *any, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report)
{
	struct hawser__stations stations;
	double ends[2];
	enum hawser_status status;

	hawser__load_ends(ends, modes, scene);
	status = hawser__stations_make(&stations, modes, moving, ends[0], ends[1], report);
	if (!status)
		status = hawser__load_pull(&stations, scene, report);
	if (!status) {
		hawser__follow(&stations);
		*any = hawser__follow_stiffness(T, &stations);
	}
	hawser__stations_clear(&stations);
	return status;
}

/* modes/select.c - a subset of the modes as a result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"

static enum hawser_status check(const struct hawser_modes *modes, const int *kept, int count,
                                struct hawser_report *report)
{
	if (count < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes selected: keep one at least", count);
	for (int i = 0; i < count; i++)
		if (kept[i] < 0 || kept[i] >= modes->n || (i > 0 && kept[i] <= kept[i - 1]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
			                    "mode %d selected as number %d of %d: indices ascend, from 0 "
			                    "to %d", kept[i], i + 1, count, modes->n - 1);
	return HAWSER_OK;
}

/* Copy the grid exactly. Recomputing it from the edges would lose accuracy in the element
 * lengths. */
static enum hawser_status copy_grid(struct hawser_grid *copy, const struct hawser_grid *grid,
                                    struct hawser_report *report)
{
	enum hawser_status status = hawser__grid_init(copy, grid->elements, grid->order, grid->edge,
	                                              NULL, report);

	if (status)
		return status;
	memcpy(copy->s, grid->s, (size_t)grid->points*sizeof *grid->s);
	memcpy(copy->weight, grid->weight, (size_t)grid->points*sizeof *grid->weight);
	return HAWSER_OK;
}

/* *copy is all of *modes but the modes themselves. */
static enum hawser_status begin_like(struct hawser_modes *copy, const struct hawser_modes *modes,
                                     struct hawser_report *report)
{
	*copy = (struct hawser_modes){.statics = modes->statics, .method = modes->method,
		.gyroscopic = modes->gyroscopic, .basis = modes->basis, .time_unit = modes->time_unit};
	return copy_grid(&copy->grid, &modes->grid, report);
}

enum hawser_status hawser__modes_extend(struct hawser_modes *with, const struct hawser_modes *modes,
                                        int more, struct hawser_report *report)
{
	size_t values = hawser__modes_row(modes)*(size_t)modes->n;
	enum hawser_status status;

	status = begin_like(with, modes, report);
	if (!status)
		status = hawser__modes_allocate(with, modes->n + more, modes->grid.points, report);
	if (status) {
		hawser_modes_clear(with);
		return status;
	}
	memcpy(with->mode, modes->mode, (size_t)modes->n*sizeof *modes->mode);
	memcpy(with->shape, modes->shape, values*sizeof *modes->shape);
	memcpy(with->slope, modes->slope, values*sizeof *modes->slope);
	if (modes->stroke)
		memcpy(with->stroke, modes->stroke,
		       (size_t)modes->n*(size_t)modes->statics.attachments*sizeof *modes->stroke);
	return HAWSER_OK;
}

enum hawser_status hawser_modes_select(struct hawser_modes *subset,
                                       const struct hawser_modes *modes, const int *kept,
                                       int count, struct hawser_report *report)
{
	size_t row = hawser__modes_row(modes);
	enum hawser_status status;

	*subset = (struct hawser_modes){.n = 0};
	status = check(modes, kept, count, report);
	if (status)
		return status;
	status = begin_like(subset, modes, report);
	if (!status)
		status = hawser__modes_allocate(subset, count, modes->grid.points, report);
	for (int i = 0; !status && i < count; i++) {
		size_t from = (size_t)kept[i]*row, to = (size_t)i*row;

		subset->mode[i] = modes->mode[kept[i]];
		memcpy(subset->shape + to, modes->shape + from, row*sizeof *modes->shape);
		memcpy(subset->slope + to, modes->slope + from, row*sizeof *modes->slope);
		if (modes->stroke)
			memcpy(subset->stroke + i*modes->statics.attachments,
			       modes->stroke + kept[i]*modes->statics.attachments,
			       (size_t)modes->statics.attachments*sizeof *modes->stroke);
	}
	if (status)
		hawser_modes_clear(subset);
	return status;
}

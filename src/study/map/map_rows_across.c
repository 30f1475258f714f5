/* study/map/map_rows_across.c - columns of a map by rows: curves along the other coordinate, whose
 * responses at the rows begin curves along these. So a row has detached responses that others join. The
 * same over the frequency, at one point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map_rows.h"

enum hawser_status hawser__map_row_at(struct hawser__map_row *row, const struct hawser_rom *rom,
                                      double omega, const struct hawser_progress *progress,
                                      struct hawser_report *report)
{
	const double at[3] = {0.7*omega, omega, 1.4*omega};
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status;

	*row = (struct hawser__map_row){.at = at, .count = 3, .keep = 1, .keeps = 1,
		.progress = progress, .answer = calloc(3, sizeof *row->answer)};
	if (!row->answer)
		return hawser__no_memory(report, "map");
	status = hawser__map_row_follow(row, rom, NULL, omega, 1, &local);
	if (status == HAWSER_ERR_MEMORY && report)
		*report = local;
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

static int told(void *data, const struct hawser_progress_state *state)
{
	(void)state;
	return hawser__rows_told_to_stop(data);
}

static enum hawser_status add_seed(struct hawser__rows_mapper *mapper, int j, double at,
                                   const double *state, int coordinates, struct hawser_report *report)
{
	size_t size = 2*(size_t)coordinates*sizeof *state;
	struct hawser__map_row *row = &mapper->row[j];
	struct hawser__map_seed seed = {at, coordinates, malloc(size)};

	if (!seed.state || hawser__more(&mapper->seed[j], row->seeds, sizeof *mapper->seed[j])) {
		free(seed.state);
		return hawser__no_memory(report, "map");
	}
	memcpy(seed.state, state, size);
	mapper->seed[j][row->seeds++] = seed;
	row->seed = mapper->seed[j];
	return HAWSER_OK;
}

/* The column at this value, with the curves through `start`, or NULL. */
static enum hawser_status follow(struct hawser__rows_mapper *mapper, double fixed,
                                 const struct hawser_map_start *start, struct hawser_report *report)
{
	const struct hawser_map *map = mapper->map;
	const struct hawser_progress progress = {told, mapper};
	struct hawser__map_seed seed = {.at = 0.0};
	struct hawser__map_row column = {.at = mapper->along ? map->x : map->y, .count = mapper->rows,
		.fixed = fixed, .across = 1, .keeps = 1, .keep = HAWSER__MAP_KEEPS_ALL, .seed = &seed,
		.seeds = start != NULL, .progress = &progress};
	enum hawser_status status;

	if (start)
		seed = (struct hawser__map_seed){start->at[1 - mapper->along], start->coordinates,
			(double *)start->state};
	status = mapper->field->row(mapper->worker[0], &column, report);
	for (int i = 0; i < column.kept && !status; i++)
		status = add_seed(mapper, column.kept_at[i], fixed,
		                  column.state + 2*(size_t)column.coordinates*(size_t)i, column.coordinates,
		                  report);
	hawser__map_row_clear(&column);
	return status;
}

enum hawser_status hawser__rows_across(struct hawser__rows_mapper *mapper,
                                       struct hawser_report *report)
{
	const struct hawser_map *map = mapper->map;
	const struct hawser_map_field *field = mapper->field;
	int last = (mapper->along ? map->ny : map->nx) - 1;
	const double *at = mapper->along ? map->y : map->x;
	enum hawser_status status = HAWSER_OK;

	if (field->start)
		status = follow(mapper, field->start->at[mapper->along], field->start, report);
	for (int k = 0; k < field->columns && !status && mapper->rows > 1; k++)
		status = follow(mapper, at[k*last/(field->columns - 1)], NULL, report);
	return status;
}

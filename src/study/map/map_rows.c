/* study/map/map_rows.c - a map by rows, from its options to its result.
 *
 * Rows are independent: they are tasks (map_rows_ranks.c) of the threads and of other processes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "core/share.h"
#include "study/map/map_rows.h"

enum { SETTINGS = 320 };

int hawser__rows_told_to_stop(struct hawser__rows_mapper *mapper)
{
	struct hawser_progress_state state =
		hawser__progress_state("rows of the map", "rows", mapper->done, mapper->began);

	state.expected = mapper->rows;
	state.fresh = mapper->fresh;
	if (hawser__told_to_stop(&mapper->options->progress, &state))
		atomic_store(&mapper->stop, 1);
	return atomic_load(&mapper->stop);
}

/* The status of a row in which a point has no value, if the map is strict. */
enum hawser_status hawser__rows_refuse(const struct hawser__rows_mapper *mapper,
                                       const struct hawser__map_row *row,
                                       struct hawser_report *report)
{
	for (int i = 0; i < row->count && mapper->options->strict && row->ready; i++) {
		enum hawser_map_code code = row->answer[i].sample.code;
		double at[2];

		if (!hawser_map_uncomputed(code))
			continue;
		at[mapper->along] = row->at[i];
		at[1 - mapper->along] = row->fixed;
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "map",
		                    "the point x = %.9g, y = %.9g could not be computed (%s%s%.300s)",
		                    at[0], at[1], hawser_map_code_name(code), row->why[code] ? ": " : "",
		                    row->why[code] ? row->why[code] : "");
	}
	return HAWSER_OK;
}

static enum hawser_status open_results(struct hawser__rows_mapper *mapper, struct hawser_report *report)
{
	struct hawser_map *map = mapper->map;
	size_t points = (size_t)map->nx*(size_t)map->ny;

	map->least = calloc(2*points, sizeof *map->least);
	map->branches = calloc(2*points, sizeof *map->branches);
	if (!map->least || !map->branches)
		return hawser__no_memory(report, "map");
	map->most = map->least + points;
	map->stable = map->branches + points;
	mapper->row = calloc((size_t)mapper->rows, sizeof *mapper->row);
	mapper->seed = calloc((size_t)mapper->rows, sizeof *mapper->seed);
	mapper->x = calloc(2*(size_t)mapper->rows, sizeof *mapper->x);
	mapper->y = mapper->x + mapper->rows;
	mapper->worker = calloc((size_t)mapper->threads, sizeof *mapper->worker);
	if (!mapper->row || !mapper->seed || !mapper->x || !mapper->worker)
		return hawser__no_memory(report, "map");
	for (int j = 0; j < mapper->rows; j++)
		mapper->row[j] = (struct hawser__map_row){
			.at = mapper->along ? map->y : map->x, .count = mapper->along ? map->ny : map->nx,
			.fixed = (mapper->along ? map->x : map->y)[j],
			.only_stable = mapper->options->only_stable};
	return HAWSER_OK;
}

static enum hawser_status open_mapper(struct hawser__rows_mapper *mapper, char settings[SETTINGS],
                                      struct hawser_report *report)
{
	const struct hawser_map_options *options = mapper->options;
	const struct hawser_map_field *field = mapper->field;
	enum hawser_status status = open_results(mapper, report);

	snprintf(settings, SETTINGS, "rows %a %a %d %a %a %d only stable %d", options->from[0],
	         options->to[0], options->points[0], options->from[1], options->to[1],
	         options->points[1], options->only_stable);
	if (!status && (!options->ranks || options->ranks->rank == 0))
		status = hawser__map_rows_file_open(&mapper->file, options->checkpoint, field->identity,
		                                    settings, mapper->row, mapper->rows, report);
	for (int t = 0; t < mapper->threads && !status; t++)
		status = field->open(&mapper->worker[t], field->context, report);
	return status;
}

static void close_mapper(struct hawser__rows_mapper *mapper)
{
	for (int t = 0; mapper->worker && t < mapper->threads; t++)
		mapper->field->close(mapper->worker[t]);
	for (int j = 0; mapper->seed && j < mapper->rows; j++) {
		for (int i = 0; i < mapper->row[j].seeds; i++)
			free(mapper->seed[j][i].state);
		free(mapper->seed[j]);
	}
	for (int j = 0; mapper->row && j < mapper->rows; j++)
		hawser__map_row_clear(&mapper->row[j]);
	free(mapper->seed);
	free(mapper->worker);
	free(mapper->pending);
	free(mapper->row);
	free(mapper->x);
	hawser__map_checkpoint_close(&mapper->file.checkpoint);
}

static void collect_row(struct hawser_map *map, const struct hawser__map_row *row, int j, int along)
{
	for (int i = 0; i < row->count; i++) {
		const struct hawser__map_answer *answer = row->answer ? &row->answer[i] : NULL;
		size_t place = along ? (size_t)i*(size_t)map->nx + (size_t)j
		                     : (size_t)j*(size_t)map->nx + (size_t)i;

		map->point[place].sample.code = HAWSER_MAP_LEFT;
		if (!row->ready)
			continue;
		map->point[place] = (struct hawser_map_point){answer->sample, 1};
		map->least[place] = answer->least;
		map->most[place] = answer->most;
		map->branches[place] = answer->branches;
		map->stable[place] = answer->stable;
		map->count[answer->sample.code]++;
		map->visited++;
	}
}

static void collect(struct hawser__rows_mapper *mapper)
{
	struct hawser_map *map = mapper->map;

	for (int j = 0; j < mapper->rows; j++) {
		const struct hawser__map_row *row = &mapper->row[j];

		collect_row(map, row, j, mapper->along);
		if (!row->ready)
			continue;
		for (int k = 0; k < HAWSER_MAP_CODES; k++)
			if (row->why[k] && !*map->reason[k])
				snprintf(map->reason[k], sizeof map->reason[k], "%.319s", row->why[k]);
		if (row->incomplete && map->incomplete++ == 0)
			snprintf(map->broken, sizeof map->broken, "%.319s",
			         row->broken ? row->broken : "");
	}
}

enum hawser_status hawser__map_rows(struct hawser_map *map, const struct hawser_map_field *field,
                                    const struct hawser_map_options *options,
                                    struct hawser_report *report)
{
	struct hawser__rows_mapper mapper = {.map = map, .field = field, .options = options,
		.along = field->along, .rows = field->along ? map->nx : map->ny,
		.threads = options->threads > 0 ? options->threads : hawser__processors(),
		.began = hawser__wall_seconds(),
		.file = {.checkpoint = {.fd = -1}}};
	char settings[SETTINGS];
	enum hawser_status status = open_mapper(&mapper, settings, report);

	if (!status)
		status = hawser__rows_compute(&mapper, settings, report);
	if (!status && !(options->ranks && options->ranks->rank > 0)) {
		collect(&mapper);
		status = hawser__map_rows_lines(map, mapper.row, mapper.rows, mapper.along, report);
	}
	close_mapper(&mapper);
	return status;
}

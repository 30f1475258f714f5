/* study/map/map_rows.c - a map by rows, from its options to its result.
 *
 * Rows are independent and shared out to threads. They are computed several at a time, as many as take
 * about a tenth of a second, so that the caller's progress function is asked often; while a row is
 * computed, its traces ask it in the caller's thread.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "core/share.h"
#include "study/map/map_rows_mapper.h"

#define LEAST_SECS 0.1 /* of rows that are computed together; chosen */
#define SURE_SECS 1.0  /* shortest time from which the remaining time is estimated; chosen */
enum { MOST_CHUNK = 256, SETTINGS = 320 };

int hawser__rows_told_to_stop(struct hawser__rows_mapper *mapper)
{
	struct hawser_progress_state state =
		hawser__progress_state("rows of the map", "rows", mapper->done, mapper->began);

	state.expected = mapper->rows;
	state.fresh = mapper->fresh;
	state.fraction = (double)state.done/mapper->rows;
	if (state.fresh > 0 && state.seconds > SURE_SECS)
		state.left = state.seconds*(double)(mapper->rows - mapper->done)/(double)state.fresh;
	if (hawser__told_to_stop(&mapper->options->progress, &state))
		atomic_store(&mapper->stop, 1);
	return atomic_load(&mapper->stop);
}

/* Asked by the traces of rows. The caller's function is called in its own thread only. */
static int asked(void *data, const struct hawser_progress_state *state)
{
	struct hawser__rows_mapper *mapper = data;

	(void)state;
	return pthread_equal(pthread_self(), mapper->caller) ? hawser__rows_told_to_stop(mapper)
	                                                     : atomic_load(&mapper->stop);
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

int hawser__rows_has(const struct hawser__rows_mapper *mapper, int j)
{
	return mapper->options->parts == 0 || j%mapper->options->parts == mapper->options->part - 1;
}

static void one_row(void *context, long item, int thread)
{
	struct hawser__rows_mapper *mapper = context;
	int j = mapper->from + (int)item;
	struct hawser__map_row *row = &mapper->row[j];
	const struct hawser_progress progress = {asked, mapper};
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status;

	if (row->ready || !hawser__rows_has(mapper, j) || atomic_load(&mapper->stop))
		return;
	row->progress = &progress;
	status = mapper->field->row(mapper->worker[thread], row, &local);
	row->progress = NULL;
	if (!status)
		status = hawser__rows_refuse(mapper, row, &local);
	if (!status)
		return;
	pthread_mutex_lock(&mapper->lock);
	if (!mapper->status || j < mapper->failed) {
		mapper->status = status;
		mapper->failed = j;
		mapper->report = local;
	}
	pthread_mutex_unlock(&mapper->lock);
}

static enum hawser_status compute(struct hawser__rows_mapper *mapper, int from, int count,
                                  struct hawser_report *report)
{
	const struct hawser_map_field *field = mapper->field;
	int wanted = 0;
	unsigned char had[MOST_CHUNK] = {0};
	enum hawser_status status = HAWSER_OK;

	for (int j = from; j < from + count; j++) {
		had[j - from] = (unsigned char)mapper->row[j].ready;
		if (mapper->row[j].ready || !hawser__rows_has(mapper, j))
			continue;
		mapper->x[wanted] = mapper->along == 0 ? mapper->map->x[0] : mapper->row[j].fixed;
		mapper->y[wanted++] = mapper->along == 1 ? mapper->map->y[0] : mapper->row[j].fixed;
	}
	if (wanted > 0 && field->prepare)
		status = field->prepare(field->context, mapper->x, mapper->y, wanted, mapper->threads, report);
	if (status)
		return status;
	mapper->from = from;
	hawser__share(count, mapper->threads, one_row, mapper);
	for (int j = from; j < from + count && !status; j++) {
		if (!mapper->row[j].ready)
			continue;
		mapper->done++;
		if (had[j - from]) {
			mapper->map->restored += mapper->row[j].count;
			continue;
		}
		mapper->fresh++;
		status = hawser__map_rows_file_add(&mapper->file, &mapper->row[j], report);
	}
	if (!status)
		status = hawser__map_checkpoint_flush(&mapper->file.checkpoint, report);
	if (!status && mapper->status) {
		if (report)
			*report = mapper->report;
		status = mapper->status;
	}
	return status;
}

static enum hawser_status compute_all(struct hawser__rows_mapper *mapper, const char *settings,
                                      struct hawser_report *report)
{
	int chunk = mapper->threads < MOST_CHUNK ? mapper->threads : MOST_CHUNK;
	enum hawser_status status = HAWSER_OK;

	if (mapper->options->ranks)
		return hawser__rows_by_ranks(mapper, settings, report);
	for (int at = 0; at < mapper->rows && !status && !hawser__rows_told_to_stop(mapper);) {
		int count = mapper->rows - at < chunk ? mapper->rows - at : chunk;
		double began = hawser__wall_seconds();

		status = compute(mapper, at, count, report);
		at += count;
		if (hawser__wall_seconds() - began < LEAST_SECS && 2*chunk <= MOST_CHUNK)
			chunk *= 2;
	}
	mapper->map->interrupted = atomic_load(&mapper->stop);
	return status;
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
	mapper->x = calloc(2*(size_t)mapper->rows, sizeof *mapper->x);
	mapper->y = mapper->x + mapper->rows;
	mapper->worker = calloc((size_t)mapper->threads, sizeof *mapper->worker);
	if (!mapper->row || !mapper->x || !mapper->worker)
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
	for (int j = 0; mapper->row && j < mapper->rows; j++)
		hawser__map_row_clear(&mapper->row[j]);
	free(mapper->worker);
	free(mapper->pending);
	free(mapper->row);
	free(mapper->x);
	hawser__map_checkpoint_close(&mapper->file.checkpoint);
	pthread_mutex_destroy(&mapper->lock);
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
		.along = field->along, .rows = field->along ? map->nx : map->ny, .caller = pthread_self(),
		.threads = options->threads > 0 ? options->threads : hawser__processors(),
		.lock = PTHREAD_MUTEX_INITIALIZER, .began = hawser__wall_seconds(),
		.file = {.checkpoint = {.fd = -1}}};
	char settings[SETTINGS];
	enum hawser_status status = open_mapper(&mapper, settings, report);

	if (!status)
		status = compute_all(&mapper, settings, report);
	if (!status && !(options->ranks && options->ranks->rank > 0)) {
		collect(&mapper);
		status = hawser__map_rows_lines(map, mapper.row, mapper.rows, mapper.along, report);
	}
	close_mapper(&mapper);
	return status;
}

/* study/map/map.c - a map from its options to its result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/names.h"
#include "core/report.h"
#include "core/settle.h"
#include "study/map/map.h"
#include "study/map/map_rows.h"

enum { SETTINGS = 320 }; /* characters of the settings of a map */
enum { MOST_POINTS = 20000 }; /* largest number of points along an axis; chosen */

HAWSER__NAMES(hawser_map_code_name, enum hawser_map_code, [HAWSER_MAP_OK] = "ok",
	[HAWSER_MAP_NO_STATE] = "no-state", [HAWSER_MAP_SLACK] = "slack",
	[HAWSER_MAP_NOT_CONVERGED] = "not-converged", [HAWSER_MAP_NOT_FINITE] = "not-finite",
	[HAWSER_MAP_REFUSED] = "refused", [HAWSER_MAP_NO_RESPONSE] = "no-response",
	[HAWSER_MAP_LEFT] = "left")

int hawser_map_uncomputed(enum hawser_map_code code)
{
	return code == HAWSER_MAP_NOT_CONVERGED || code == HAWSER_MAP_NOT_FINITE ||
	       code == HAWSER_MAP_REFUSED;
}

void hawser_map_settle(struct hawser_map_options *options)
{
	hawser__settle_count(&options->points[0], 200);
	hawser__settle_count(&options->points[1], 200);
	hawser__settle_count(&options->coarse, 8);
	hawser__settle(&options->jump, 0.05);
	hawser__settle(&options->tolerance, 1e-4);
}

static enum hawser_status check(const struct hawser_map_options *options,
                                struct hawser_report *report)
{
	for (int k = 0; k < 2; k++) {
		double from = options->from[k], to = options->to[k];

		if (!isfinite(from) || !isfinite(to) || from == to)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
			                    "range of %c from %.9g to %.9g: both ends must be finite and "
			                    "different", "xy"[k], from, to);
		if (options->points[k] < 2 || options->points[k] > MOST_POINTS)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
			                    "%d points along %c: it must be 2 to %d", options->points[k],
			                    "xy"[k], MOST_POINTS);
	}
	if (options->parts < 0 || options->part < (options->parts > 0) || options->part > options->parts ||
	    (options->parts > 0 && !options->checkpoint))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "part %d of %d: a part is numbered from 1, and its points are in a "
		                    "checkpoint", options->part, options->parts);
	if (options->coarse < 1 || isnan(options->jump) || options->threads < 0 ||
	    options->threads > 1024 || !(options->tolerance >= 1e-14 && options->tolerance < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "coarse %d (1 or more), jump %g (a number), %d threads (0 to 1024), "
		                    "tolerance %g (1e-14 to 1): one is out of range", options->coarse,
		                    options->jump, options->threads, options->tolerance);
	return HAWSER_OK;
}

/* Both ends have exactly the values that were given. */
static double *axis_of(double from, double to, int points)
{
	double *at = malloc((size_t)points*sizeof *at);

	for (int i = 0; at && i < points; i++)
		at[i] = i == points - 1 ? to : from + (to - from)*i/(points - 1);
	return at;
}

static void settings_of(char text[SETTINGS], const struct hawser_map_options *options)
{
	snprintf(text, SETTINGS, "%a %a %d %a %a %d coarse %d jump %a tolerance %a", options->from[0],
	         options->to[0], options->points[0], options->from[1], options->to[1],
	         options->points[1], options->coarse, options->jump, options->tolerance);
}

static enum hawser_status open_mapper(struct hawser__mapper *mapper, struct hawser_map *map,
                                      const struct hawser_map_field *field,
                                      const struct hawser_map_options *options,
                                      struct hawser_report *report)
{
	size_t nodes = (size_t)options->points[0]*(size_t)options->points[1];
	char settings[SETTINGS];

	map->nx = mapper->nx = options->points[0];
	map->ny = mapper->ny = options->points[1];
	map->x = mapper->x = axis_of(options->from[0], options->to[0], map->nx);
	map->y = mapper->y = axis_of(options->from[1], options->to[1], map->ny);
	map->point = calloc(nodes, sizeof *map->point);
	mapper->node = malloc(nodes*sizeof *mapper->node);
	mapper->hot = calloc(nodes, 1);
	mapper->field = field;
	mapper->options = options;
	mapper->low = INFINITY;
	mapper->high = -INFINITY;
	if (!map->x || !map->y || !map->point || !mapper->node || !mapper->hot)
		return hawser__no_memory(report, "map");
	for (size_t p = 0; p < nodes; p++)
		mapper->node[p] = -1;
	settings_of(settings, options);
	return hawser__map_memo_open(&mapper->memo, field, options, settings, report);
}

static void close_mapper(struct hawser__mapper *mapper)
{
	hawser__map_memo_close(&mapper->memo);
	free(mapper->node);
	free(mapper->hot);
	free(mapper->leaf.cell);
	free(mapper->probe);
	free(mapper->tongues.item);
	free(mapper->tongues.found);
}

static double mix(const struct hawser__mapper *mapper, const struct hawser__map_cell *cell, int i,
                  int j)
{
	double s = (double)(i - cell->i0)/(cell->i1 - cell->i0);
	double t = (double)(j - cell->j0)/(cell->j1 - cell->j0);
	double value[4];

	for (int k = 0; k < 4; k++) {
		long place = (long)(k & 2 ? cell->j1 : cell->j0)*mapper->nx + (k & 1 ? cell->i1 : cell->i0);

		value[k] = hawser__map_sample(mapper, mapper->node[place])->value;
	}
	return (1.0 - t)*((1.0 - s)*value[0] + s*value[1]) + t*((1.0 - s)*value[2] + s*value[3]);
}

/* Points inside a cell whose corners agree are interpolated. */
static void fill_cell(struct hawser_map *map, const struct hawser__mapper *mapper,
                      const struct hawser__map_cell *cell)
{
	long first = mapper->node[(long)cell->j0*mapper->nx + cell->i0];

	for (int j = cell->j0; j <= cell->j1; j++)
		for (int i = cell->i0; i <= cell->i1; i++) {
			struct hawser_map_point *point = &map->point[(long)j*map->nx + i];

			if (point->computed)
				continue;
			point->sample = *hawser__map_sample(mapper, first);
			if (point->sample.code == HAWSER_MAP_OK)
				point->sample.value = mix(mapper, cell, i, j);
		}
}

static void collect(struct hawser_map *map, struct hawser__mapper *mapper)
{
	const struct hawser__map_memo *memo = &mapper->memo;
	long nodes = (long)map->nx*map->ny;

	for (long p = 0; p < nodes; p++) {
		long index = mapper->node[p];

		map->point[p].computed = index >= 0 && memo->record[index].ready;
		map->point[p].sample.code = HAWSER_MAP_LEFT;
		if (map->point[p].computed)
			map->point[p].sample = memo->record[index].sample;
	}
	for (size_t c = 0; c < mapper->leaf.count; c++)
		fill_cell(map, mapper, &mapper->leaf.cell[c]);
	for (long r = 0; r < memo->count; r++)
		if (memo->record[r].visited && memo->record[r].ready)
			map->count[memo->record[r].sample.code]++;
	map->visited = memo->visited;
	map->restored = memo->restored;
	map->interrupted = memo->interrupted;
	hawser__ridge_unresolved(&map->narrow, &mapper->tongues);
}

/* Messages for the codes without a value: the first point of each code is computed again for its
 * report. */
static void explain(struct hawser_map *map, const struct hawser__mapper *mapper)
{
	const struct hawser_map_field *field = mapper->field;
	int found[HAWSER_MAP_CODES] = {0};

	for (int j = 0; j < map->ny; j++)
		for (int i = 0; i < map->nx; i++) {
			const struct hawser_map_point *point = &map->point[(long)j*map->nx + i];
			enum hawser_map_code code = point->sample.code;
			struct hawser_map_sample sample = {0.0, 0, HAWSER_MAP_OK};
			struct hawser_report local = {.status = HAWSER_OK};

			if (code == HAWSER_MAP_OK || code == HAWSER_MAP_LEFT || !point->computed ||
			    found[code]++)
				continue;
			if (field->prepare &&
			    field->prepare(field->context, &map->x[i], &map->y[j], 1, 1, NULL))
				return;
			if (!field->point(mapper->memo.worker[0], &sample, NULL, map->x[i], map->y[j],
			                  &local))
				snprintf(map->reason[code], sizeof map->reason[code], "%.319s",
				         local.message);
		}
}

/* A worker has no grid: it computes the points that rank 0 asks for. */
static enum hawser_status serve(struct hawser__mapper *mapper, const struct hawser_map_field *field,
                                const struct hawser_map_options *options,
                                struct hawser_report *report)
{
	char settings[SETTINGS];
	enum hawser_status status;

	settings_of(settings, options);
	status = hawser__map_memo_open(&mapper->memo, field, options, settings, report);
	if (!status)
		hawser__map_ranks_serve(&mapper->memo);
	hawser__map_memo_close(&mapper->memo);
	return status;
}

enum hawser_status hawser_map_trace(struct hawser_map *map, const struct hawser_map_field *field,
                                    const struct hawser_map_options *options,
                                    struct hawser_report *report)
{
	struct hawser__mapper mapper = {.memo = {.checkpoint = {.fd = -1}}};
	struct hawser_map_options settled = *options;
	struct hawser_map_condensed others;
	enum hawser_status status;

	*map = (struct hawser_map){.nx = 0};
	hawser_map_settle(&settled);
	options = &settled;
	status = check(options, report);
	if (status)
		return status;
	if (field->row) {
		map->nx = options->points[0];
		map->ny = options->points[1];
		map->x = axis_of(options->from[0], options->to[0], map->nx);
		map->y = axis_of(options->from[1], options->to[1], map->ny);
		map->point = calloc((size_t)map->nx*(size_t)map->ny, sizeof *map->point);
		return map->x && map->y && map->point ? hawser__map_rows(map, field, options, report)
		                                      : hawser__no_memory(report, "map");
	}
	if (options->ranks && options->ranks->rank > 0)
		return serve(&mapper, field, options, report);
	status = open_mapper(&mapper, map, field, options, report);
	if (!status)
		status = hawser__map_grow(&mapper, report);
	if (!status && !mapper.memo.interrupted)
		status = hawser__map_boundaries(map, &mapper, report);
	if (!status) {
		collect(map, &mapper);
		explain(map, &mapper);
	}
	hawser__map_ranks_end(&mapper.memo);
	others = mapper.memo.others;
	close_mapper(&mapper);
	if (field->condensed)
		map->condensed = *field->condensed;
	hawser__map_condensed_merge(&map->condensed, &others);
	return status;
}

void hawser_map_clear(struct hawser_map *map)
{
	if (!map)
		return;
	free(map->x);
	free(map->y);
	free(map->point);
	free(map->boundary);
	free(map->segment);
	free(map->least);
	free(map->branches);
	free(map->narrow.item);
	*map = (struct hawser_map){.nx = 0};
}

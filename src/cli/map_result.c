/* cli/map_result.c - a map as tables and as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cli/cli.h"

const char *cli_map_value_unit(const struct cli_map_result *result)
{
	const struct cli_model *model = result->model;
	enum hawser_beam_form form = model->has_scene ? model->scene.beam.form : HAWSER_BEAM_NONE;

	return form == HAWSER_BEAM_NONE || form == HAWSER_BEAM_EI ? result->quantity->unit : "1";
}

/* "1/s" as the end of a column's name: "_1_s"; nothing for a pure number. */
static void suffix(char *text, size_t size, const char *unit)
{
	size_t used = 1;

	snprintf(text, size, "%s", "");
	if (!*unit || strcmp(unit, "1") == 0)
		return;
	text[0] = '_';
	for (; *unit && used + 1 < size; unit++)
		text[used++] = isalnum((unsigned char)*unit) ? *unit : '_';
	text[used] = '\0';
}

static void column(struct hawser__table *table, const char *name, const char *unit)
{
	char end[24];

	suffix(end, sizeof end, unit);
	hawser__table_column(table, "%s%s", name, end);
}

static void comments(struct hawser__table *table, const struct cli_map_result *result)
{
	const struct hawser_map *map = result->map;
	const struct hawser_map_options *options = &result->options;

	cli_echo_table(table, result->common, "map",
	               result->model->has_scene ? &result->model->scene : NULL,
	               result->quantity->name);
	hawser__table_comment(table, "quantity: %s; number: %s", result->quantity->summary,
	                      result->quantity->counts);
	for (int k = 0; k < 2; k++)
		hawser__table_comment(table, "%c: %s from %.12g to %.12g%s%s, %d points", "xy"[k],
		                      result->key[k], options->from[k], options->to[k],
		                      *result->unit[k] ? " " : "", result->unit[k],
		                      options->points[k]);
	if (result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega,
		                      result->model->has_scene || result->model->rom.scaled ? " rad/s"
		                                                                            : "");
	hawser__table_comment(table, "computed: %ld points of a lattice of %ld, those on boundaries "
	                             "included; first cells %d, tolerance %.3g", map->visited,
	                      (long)map->nx*map->ny, options->coarse, options->tolerance);
	hawser__table_comment(table, "boundaries: %d points", map->boundaries);
	for (int k = 1; k < HAWSER_MAP_CODES; k++)
		if (map->count[k] > 0)
			hawser__table_comment(table, "%s: %d points%s%s",
			                      hawser_map_code_name((enum hawser_map_code)k),
			                      map->count[k], *map->reason[k] ? ", the first: " : "",
			                      map->reason[k]);
	if (result->model->has_scene && result->model->scene.travel.braking > 0.0)
		hawser__table_comment(table, "travel.braking is left out: the map is of travel.speed");
	if (map->interrupted)
		hawser__table_comment(table, "interrupted: the rest is left");
}

static int has_value(const struct hawser_map_sample *sample)
{
	return sample->code == HAWSER_MAP_OK || sample->code == HAWSER_MAP_SLACK;
}

static int shown(const struct cli_map_result *result, const struct hawser_map_point *point)
{
	return point->computed || (result->full && point->sample.code != HAWSER_MAP_LEFT);
}

static void point_row(struct hawser__table *row, const void *context, size_t index)
{
	const struct cli_map_result *result = context;
	const struct hawser_map *map = result->map;
	const struct hawser_map_point *point = &map->point[index];

	if (!shown(result, point))
		return;
	hawser__table_number(row, map->x[index % (size_t)map->nx]);
	hawser__table_number(row, map->y[index/(size_t)map->nx]);
	if (has_value(&point->sample))
		hawser__table_number(row, point->sample.value);
	else
		hawser__table_word(row, "");
	hawser__table_number(row, point->sample.number);
	hawser__table_word(row, hawser_map_code_name(point->sample.code));
	hawser__table_number(row, point->computed);
}

void cli_map_table(struct hawser__table *table, const void *of)
{
	const struct cli_map_result *result = of;
	const struct hawser_map *map = result->map;

	comments(table, result);
	column(table, result->key[0], result->unit[0]);
	column(table, result->key[1], result->unit[1]);
	column(table, result->quantity->name, cli_map_value_unit(result));
	hawser__table_column(table, "number");
	hawser__table_column(table, "status");
	hawser__table_column(table, "computed");
	hawser__table_rows(table, (size_t)map->nx*(size_t)map->ny, point_row, result);
}

void cli_map_boundary(struct hawser__table *table, const struct cli_map_result *result)
{
	const struct hawser_map *map = result->map;

	comments(table, result);
	column(table, result->key[0], result->unit[0]);
	column(table, result->key[1], result->unit[1]);
	hawser__table_column(table, "along");
	hawser__table_column(table, "width");
	hawser__table_column(table, "number_before");
	hawser__table_column(table, "status_before");
	hawser__table_column(table, "number_after");
	hawser__table_column(table, "status_after");
	for (int k = 0; k < map->boundaries; k++) {
		const struct hawser_map_boundary *at = &map->boundary[k];

		hawser__table_number(table, at->x);
		hawser__table_number(table, at->y);
		hawser__table_word(table, at->along == 0 ? "x" : "y");
		hawser__table_number(table, at->width);
		for (int s = 0; s < 2; s++) {
			hawser__table_number(table, at->number[s]);
			hawser__table_word(table, hawser_map_code_name(at->code[s]));
		}
	}
}

/* --- JSON --- */

static void axes_json(struct hawser__json *json, const struct cli_map_result *result)
{
	for (int k = 0; k < 2; k++) {
		json_t *axis = hawser__json_object(json, json->root, k == 0 ? "x" : "y");

		hawser__json_text(json, axis, "key", result->key[k]);
		hawser__json_text(json, axis, "unit", result->unit[k]);
		hawser__json_number(json, axis, "from", result->options.from[k]);
		hawser__json_number(json, axis, "to", result->options.to[k]);
		hawser__json_integer(json, axis, "points", result->options.points[k]);
	}
}

enum point_part { POINT_X, POINT_Y, POINT_VALUE, POINT_NUMBER, POINT_STATUS, POINT_COMPUTED };

static void point_json(struct hawser__json *json, json_t *list, const void *context, int part,
                       size_t index)
{
	const struct cli_map_result *result = context;
	const struct hawser_map *map = result->map;
	const struct hawser_map_point *point = &map->point[index];

	if (!shown(result, point))
		return;
	if (part == POINT_X)
		hawser__json_number(json, list, NULL, map->x[index % (size_t)map->nx]);
	else if (part == POINT_Y)
		hawser__json_number(json, list, NULL, map->y[index/(size_t)map->nx]);
	else if (part == POINT_VALUE && has_value(&point->sample))
		hawser__json_number(json, list, NULL, point->sample.value);
	else if (part == POINT_VALUE)
		hawser__json_null(json, list, NULL);
	else if (part == POINT_NUMBER)
		hawser__json_integer(json, list, NULL, point->sample.number);
	else if (part == POINT_STATUS)
		hawser__json_text(json, list, NULL, hawser_map_code_name(point->sample.code));
	else
		hawser__json_flag(json, list, NULL, point->computed);
}

static void points_json(struct hawser__json *json, const struct cli_map_result *result)
{
	static const char *const name[] = {"x", "y", "value", "number", "status", "computed"};
	json_t *points = hawser__json_object(json, json->root, "points");
	size_t count = (size_t)result->map->nx*(size_t)result->map->ny;

	for (int part = POINT_X; part <= POINT_COMPUTED; part++)
		hawser__json_list(json, points, name[part], count, point_json, result, part);
}

static void boundaries_json(struct hawser__json *json, const struct hawser_map *map)
{
	json_t *list = hawser__json_array(json, json->root, "boundaries"), *row, *pair;
	json_t *lines = hawser__json_array(json, json->root, "lines");

	for (int k = 0; k < map->boundaries; k++) {
		const struct hawser_map_boundary *at = &map->boundary[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "x", at->x);
		hawser__json_number(json, row, "y", at->y);
		hawser__json_text(json, row, "along", at->along == 0 ? "x" : "y");
		hawser__json_number(json, row, "width", at->width);
		pair = hawser__json_array(json, row, "number");
		hawser__json_integer(json, pair, NULL, at->number[0]);
		hawser__json_integer(json, pair, NULL, at->number[1]);
		pair = hawser__json_array(json, row, "status");
		hawser__json_text(json, pair, NULL, hawser_map_code_name(at->code[0]));
		hawser__json_text(json, pair, NULL, hawser_map_code_name(at->code[1]));
	}
	for (int k = 0; k < map->segments; k++)
		hawser__json_numbers(json, lines, NULL, map->segment + 4*k, 4, 1.0);
}

static void counts_json(struct hawser__json *json, const struct hawser_map *map)
{
	json_t *list = hawser__json_object(json, json->root, "status"), *row;

	for (int k = 0; k < HAWSER_MAP_CODES; k++) {
		if (map->count[k] == 0)
			continue;
		row = hawser__json_object(json, list, hawser_map_code_name((enum hawser_map_code)k));
		hawser__json_integer(json, row, "points", map->count[k]);
		if (*map->reason[k])
			hawser__json_text(json, row, "first", map->reason[k]);
	}
}

void cli_map_json(struct hawser__json *json, const void *of)
{
	const struct cli_map_result *result = of;
	const struct hawser_map *map = result->map;
	json_t *quantity, *stats;

	cli_echo_json(json, result->common, "map",
	              result->model->has_scene ? &result->model->scene : NULL);
	quantity = hawser__json_object(json, json->root, "quantity");
	hawser__json_text(json, quantity, "name", result->quantity->name);
	hawser__json_text(json, quantity, "unit", cli_map_value_unit(result));
	hawser__json_text(json, quantity, "number", result->quantity->counts);
	axes_json(json, result);
	if (result->omega > 0.0)
		hawser__json_number(json, json->root, "Omega", result->omega);
	points_json(json, result);
	boundaries_json(json, map);
	counts_json(json, map);
	hawser__json_flag(json, json->root, "interrupted", map->interrupted);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "computed", map->visited);
	if (!result->common->reproducible)
		hawser__json_integer(json, stats, "restored", map->restored);
}

/* cli/map_result.c - a map as tables and as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cli/condensed.h"
#include "cli/view.h"

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

static void column(char *text, size_t size, const char *name, const char *unit)
{
	char end[24];

	suffix(end, sizeof end, unit);
	snprintf(text, size, "%s%s", name, end);
}

static void x_name(char *text, size_t size, const void *context)
{
	const struct cli_map_result *result = context;

	column(text, size, result->key[0], result->unit[0]);
}

static void y_name(char *text, size_t size, const void *context)
{
	const struct cli_map_result *result = context;

	column(text, size, result->key[1], result->unit[1]);
}

static void value_name(char *text, size_t size, const void *context)
{
	const struct cli_map_result *result = context;

	column(text, size, result->quantity->name, cli_map_value_unit(result));
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
	cli_condensed_comment(table, &map->condensed);
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

HAWSER__LABELS(code_name, hawser_map_code_name, enum hawser_map_code)

struct point {
	double x, y, value; /* value: NAN where there is none */
	int number, computed;
	enum hawser_map_code code;
};
#define OF(member) HAWSER__AT(struct point, member)
static const struct hawser__field point_field[] = {
	{"x", "KEY", "first parameter", OF(x), .named = x_name},
	{"y", "KEY", "second parameter", OF(y), .named = y_name},
	{"value", "KEY", "the quantity; null: none", OF(value), .flags = HAWSER__NULL,
	 .named = value_name},
	{"number", "number", "of instabilities", OF(number)},
	{"status", "status", "ok, or why there is no value",
	 HAWSER__LABEL_AT(struct point, code, code_name)},
	{"computed", "computed", "0: interpolated", HAWSER__FLAG_AT(struct point, computed)},
	HAWSER__END,
};
#undef OF

/* A point that is not finite has a code that says so, and no value. */
static const void *point_row(void *to, const void *parent, size_t index)
{
	const struct cli_map_result *result = parent;
	const struct hawser_map *map = result->map;
	const struct hawser_map_point *point = &map->point[index];

	if (!shown(result, point))
		return NULL;
	*(struct point *)to = (struct point){
		.x = map->x[index % (size_t)map->nx], .y = map->y[index/(size_t)map->nx],
		.value = has_value(&point->sample) ? point->sample.value : NAN,
		.number = point->sample.number, .code = point->sample.code,
		.computed = point->computed};
	return to;
}

static size_t points(const void *parent)
{
	const struct hawser_map *map = ((const struct cli_map_result *)parent)->map;

	return (size_t)map->nx*(size_t)map->ny;
}
static const struct hawser__list point_list = {
	.field = point_field, .size = sizeof(struct point), .count = points, .row = point_row};

static const char *along_name(int along)
{
	return along == 0 ? "x" : "y";
}

static void sides_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_map_boundary *at = row;
	json_t *pair = hawser__json_array(json, into, "status");

	hawser__json_text(json, pair, NULL, hawser_map_code_name(at->code[0]));
	hawser__json_text(json, pair, NULL, hawser_map_code_name(at->code[1]));
}

#define OF(member) HAWSER__AT(struct hawser_map_boundary, member)
#define LABEL(member, function) HAWSER__LABEL_AT(struct hawser_map_boundary, member, function)
static const struct hawser__field boundary_field[] = {
	{"x", "KEY", "first parameter", OF(x), .named = x_name},
	{"y", "KEY", "second parameter", OF(y), .named = y_name},
	{"along", "along", "direction of the bracket: x or y", LABEL(along, along_name)},
	{"width", "width", "of the bracket", OF(width)},
	{"number", NULL, "on both sides", OF(number)},
	{"status", NULL, "on both sides", HAWSER__CALLS(sides_json)},
	{NULL, "number_before", "on the side of the smaller coordinate", OF(number[0])},
	{NULL, "status_before", "on that side", LABEL(code[0], code_name)},
	{NULL, "number_after", "on the other side", OF(number[1])},
	{NULL, "status_after", "on that side", LABEL(code[1], code_name)},
	HAWSER__END,
};
#undef LABEL
#undef OF
static const struct hawser__list boundary_list =
	HAWSER__STORED_ROWS(struct hawser_map, boundary, boundaries, boundary_field);

static const struct hawser__field boundaries_field[] = {
	{"boundaries", NULL, "where the number or the status changes",
	 HAWSER__OBJECTS_OF(boundary_list)},
	HAWSER__END,
};
static const struct hawser__field points_field[] = {
	{"points", NULL, "lists by name", HAWSER__ARRAYS_OF(point_list), .flags = HAWSER__STREAM},
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, map, boundaries_field)},
	HAWSER__END,
};

const struct cli_listing cli_map_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Columns with --boundary:", boundary_field, 0},
	{"Keys of JSON:", points_field, 1},
	{NULL, NULL, 0},
};

static struct hawser__view view_of(const struct cli_map_result *result)
{
	struct hawser__view view = cli_si_view(0);

	view.context = result;
	return view;
}

void cli_map_table(struct hawser__table *table, const void *of)
{
	struct hawser__view view = view_of(of);

	comments(table, of);
	hawser__fields_table(table, &point_list, of, &view);
}

void cli_map_boundary(struct hawser__table *table, const struct cli_map_result *result)
{
	struct hawser__view view = view_of(result);

	comments(table, result);
	hawser__fields_table(table, &boundary_list, result->map, &view);
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

static void lines_json(struct hawser__json *json, const struct hawser_map *map)
{
	json_t *lines = hawser__json_array(json, json->root, "lines");

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
	struct hawser__view view = view_of(result);
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
	hawser__fields_json(json, json->root, points_field, result, &view);
	lines_json(json, map);
	counts_json(json, map);
	cli_condensed_json(json, &map->condensed);
	hawser__json_flag(json, json->root, "interrupted", map->interrupted);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "computed", map->visited);
	if (!result->common->reproducible)
		hawser__json_integer(json, stats, "restored", map->restored);
}

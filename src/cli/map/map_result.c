/* cli/map/map_result.c - comments and fields of a map.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "cli/model/condensed.h"
#include "cli/model/exact.h"
#include "cli/model/judged.h"
#include "cli/map/map_part.h"
#include "cli/map/tongues.h"
#include "cli/frame/view.h"

const char *cli_map_value_unit(const struct cli_map_result *result)
{
	const struct cli_model *model = result->model;
	enum hawser_beam_form form = model->has_scene ? model->scene.beam.form : HAWSER_BEAM_NONE;

	return form == HAWSER_BEAM_NONE || form == HAWSER_BEAM_EI ? result->quantity->unit : "1";
}

/* Suffix of a column for a unit such as "1/s": "_1_s"; "" for a pure number. */
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

static void least_name(char *text, size_t size, const void *context)
{
	column(text, size, "min", cli_map_value_unit(context));
}

static void most_name(char *text, size_t size, const void *context)
{
	column(text, size, "max", cli_map_value_unit(context));
}

HAWSER__OF(x_unit, const char *, struct cli_map_result, of->unit[0])

HAWSER__OF(y_unit, const char *, struct cli_map_result, of->unit[1])

static const char *value_unit(const void *context)
{
	return cli_map_value_unit(context);
}

static void basin_comment(struct hawser__table *table, const struct cli_map_result *result, int a)
{
	const struct hawser_basin *basin = &result->basins.basin[a];
	const struct cli_model *model = result->model;

	hawser__table_comment(table, "response %d: share %.4f +- %.4f, amplitude %.9g%s, %d period%s, "
	                      "largest multiplier %.4g, neighbourhood of %.2g of its size%s%s", a + 1,
	                      basin->share, basin->error, basin->amplitude,
	                      model->has_scene || model->rom.scaled ? " m" : "", basin->period,
	                      basin->period > 1 ? "s" : "", basin->multiplier, basin->radius,
	                      basin->followed ? "" : ", found by motions only",
	                      basin->tension < 0.0 ? "; the cable would be slack" : "");
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_map_result *result = of;
	const struct hawser_map *map = result->map;
	const struct hawser_map_options *options = &result->options;

	hawser__table_comment(table, "quantity: %s; number: %s", result->quantity->summary,
	                      result->quantity->counts);
	if (!result->quantity->nonlinear)
		hawser__table_comment(table, result->responds ? "about: the periodic response, or rest where "
		                      "nothing moves the model" : "about: rest");
	for (int k = 0; k < 2; k++)
		hawser__table_comment(table, "%c: %s from %.12g to %.12g%s%s, %d points", "xy"[k],
		                      result->key[k], options->from[k], options->to[k],
		                      *result->unit[k] ? " " : "", result->unit[k],
		                      options->points[k]);
	if (result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega,
		                      result->model->has_scene || result->model->rom.scaled ? " rad/s"
		                                                                            : "");
	if (map->branches)
		hawser__table_comment(table, "computed: %ld points of a lattice of %ld, on curves that are "
		                      "followed along %s; min, max and branches are of %s responses",
		                      map->visited, (long)map->nx*map->ny, result->key[result->along],
		                      options->only_stable ? "the stable" : "all");
	else
		hawser__table_comment(table, "computed: %ld points of a lattice of %ld, those on boundaries "
		                      "included; first cells %d, tolerance %.3g", map->visited,
		                      (long)map->nx*map->ny, options->coarse, options->tolerance);
	for (int a = 0; a < result->basins.count; a++)
		basin_comment(table, result, a);
	if (result->basins.count > 0)
		hawser__table_comment(table, "at none within %d periods of the load: share %.4f +- %.4f; "
		                      "without bounds: %.4f +- %.4f; basin entropy %.4f, of boundary boxes "
		                      "%.4f",
		                      result->basins.periods, result->basins.other,
		                      result->basins.other_error, result->basins.escaped,
		                      result->basins.escaped_error, result->basins.entropy,
		                      result->basins.boundary_entropy);
	if (map->incomplete > 0)
		hawser__table_comment(table, "incomplete: %d rows, in which responses may be missing; the "
		                      "first: %s", map->incomplete, map->broken);
	hawser__table_comment(table, "boundaries: %d points", map->boundaries);
	if (*result->flat)
		hawser__table_comment(table, "%s", result->flat);
	cli_condensed_comment(table, &map->condensed);
	cli_tongues_comment(table, &map->narrow);
	cli_judged_comment(table, &result->judged);
	cli_exact_range_comments(table, result->model);
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

/* Relative to the largest value: no picture shows less. */
static const double VISIBLE = 1e-6;

void cli_map_judge(struct cli_map_result *result)
{
	const struct hawser_map *map = result->map;
	double low = INFINITY, high = -INFINITY;
	int least = INT_MAX, most = 0, values = 0;

	for (long i = 0; i < (long)map->nx*map->ny; i++) {
		const struct hawser_map_sample *at = &map->point[i].sample;

		if (!has_value(at) || !isfinite(at->value))
			continue;
		values++;
		low = fmin(low, at->value);
		high = fmax(high, at->value);
		least = at->number < least ? at->number : least;
		most = at->number > most ? at->number : most;
	}
	if (map->interrupted || map->boundaries > 0 || map->narrow.count > 0 || result->basins.count > 0)
		return;
	if (values == 0)
		snprintf(result->flat, sizeof result->flat, "empty: no point of this plane has a value; the "
		         "comments of the table count why");
	else if (!(high - low > VISIBLE*fmax(fabs(low), fabs(high))))
		snprintf(result->flat, sizeof result->flat, "constant: %s is %.6g at all points: it does not "
		         "depend on %s and %s here", result->quantity->name, high, result->key[0],
		         result->key[1]);
	else if (!result->quantity->nonlinear && least == most)
		snprintf(result->flat, sizeof result->flat, "empty: no boundary of stability is in this "
		         "plane: all points are %s, with %s from %.4g to %.4g", most > 0 ? "unstable"
		         : "stable", result->quantity->name, low, high);
}

static int shown(const struct cli_map_result *result, const struct hawser_map_point *point)
{
	return point->computed || (result->full && point->sample.code != HAWSER_MAP_LEFT);
}

enum { OMEGA = 1, CONDENSED = 2, TIMES = 4, ROWS = 8, BASINS = 16, NARROW = 32, LINEAR = 64 };

HAWSER__LABELS(code_name, hawser_map_code_name, enum hawser_map_code)

struct point {
	double x, y, value, least, most; /* of values: NAN if there is none */
	int number, computed, branches, stable;
	enum hawser_map_code code;
};
#define OF(member) HAWSER__AT(struct point, member)
static const struct hawser__field point_field[] = {
	{"x", "KEY", "first parameter", OF(x), .named = x_name, .si = x_unit},
	{"y", "KEY", "second parameter", OF(y), .named = y_name, .si = y_unit},
	{"value", "KEY", "the quantity; null: none", OF(value), .flags = HAWSER__NULL,
	 .named = value_name, .si = value_unit},
	{"min", "KEY", "amplitude: the smallest of the coexisting responses; null: none", OF(least),
	 .flags = HAWSER__NULL, .named = least_name, .si = value_unit, .when = ROWS},
	{"max", "KEY", "amplitude: the largest of them", OF(most), .flags = HAWSER__NULL,
	 .named = most_name, .si = value_unit, .when = ROWS},
	{"branches", "branches", "amplitude: number of coexisting responses", OF(branches),
	 .when = ROWS},
	{"stable", "stable", "amplitude: number of those that are stable", OF(stable), .when = ROWS},
	{"number", "number", "number of instabilities, see QUANTITIES", OF(number)},
	{"status", "status", "ok, or why there is no value",
	 HAWSER__LABEL_AT(struct point, code, code_name)},
	{"computed", "computed", "whether it was computed; 0: interpolated",
	 HAWSER__FLAG_AT(struct point, computed)},
	HAWSER__END,
};
#undef OF

/* A point that is not finite has a status and no value. */
static const void *point_row(void *to, const void *parent, size_t index)
{
	const struct cli_map_result *result = parent;
	const struct hawser_map *map = result->map;
	const struct hawser_map_point *point = &map->point[index];
	int rows = map->branches && has_value(&point->sample);

	if (!shown(result, point))
		return NULL;
	*(struct point *)to = (struct point){
		.x = map->x[index % (size_t)map->nx], .y = map->y[index/(size_t)map->nx],
		.value = has_value(&point->sample) ? point->sample.value : NAN,
		.least = rows ? map->least[index] : NAN, .most = rows ? map->most[index] : NAN,
		.branches = rows ? map->branches[index] : 0, .stable = map->branches ? map->stable[index] : 0,
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
	.field = point_field, .size = HAWSER__MADE_SIZE(struct point), .count = points,
	.row = point_row};

static const char *along_name(int along)
{
	return along == 0 ? "x" : "y";
}

#define OF(member) HAWSER__AT(struct hawser_map_boundary, member)
#define LABEL(member, function) HAWSER__LABEL_AT(struct hawser_map_boundary, member, function)
static const struct hawser__field boundary_field[] = {
	{"x", "KEY", "first parameter", OF(x), .named = x_name, .si = x_unit},
	{"y", "KEY", "second parameter", OF(y), .named = y_name, .si = y_unit},
	{"along", "along", "direction of the bracket: x or y", LABEL(along, along_name)},
	{"width", "width", "of the bracket", OF(width)},
	{"number", NULL, "on both sides", OF(number)},
	{"status", NULL, "on both sides", HAWSER__WORDS_AT(struct hawser_map_boundary, code, code_name)},
	{NULL, "number_before", "on the side of the smaller coordinate", OF(number[0])},
	{NULL, "status_before", "on that side", LABEL(code[0], code_name)},
	{NULL, "number_after", "on the other side", OF(number[1])},
	{NULL, "status_after", "on that side", LABEL(code[1], code_name)},
	{"event", "event", "amplitude: what is there on a curve; empty: not located", OF(event),
	 .when = ROWS},
	{"branches", NULL, "amplitude: number of responses on both sides", OF(branches),
	 .when = ROWS},
	{NULL, "branches_before", "amplitude: number of responses on the side of the smaller coordinate",
	 OF(branches[0]), .when = ROWS},
	{NULL, "branches_after", "on the other side", OF(branches[1]), .when = ROWS},
	HAWSER__END,
};
#undef LABEL
#undef OF
static const struct hawser__list boundary_list =
	HAWSER__STORED_ROWS(struct hawser_map, boundary, boundaries, boundary_field);

static const struct hawser__field line_field[] = {
	{"lines", NULL, "pieces of the boundary lines: x, y of both ends", .kind = HAWSER__NUMBERS,
	 .size = 4*sizeof(double)},
	HAWSER__END,
};
static const struct hawser__list line_list = {
	.field = line_field, .size = 4*sizeof(double), .rows_at = offsetof(struct hawser_map, segment),
	.count_at = offsetof(struct hawser_map, segments)};

static void counts_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_map *map = row;
	json_t *list = hawser__json_object(json, into, "status"), *count;

	for (int k = 0; k < HAWSER_MAP_CODES; k++) {
		if (map->count[k] == 0)
			continue;
		count = hawser__json_object(json, list, hawser_map_code_name((enum hawser_map_code)k));
		hawser__json_integer(json, count, "points", map->count[k]);
		if (*map->reason[k])
			hawser__json_text(json, count, "first", map->reason[k]);
	}
}

#define OF(member) HAWSER__AT(struct hawser_map, member)
static const struct hawser__field map_field[] = {
	{"boundaries", NULL, "where the number or the status changes",
	 HAWSER__OBJECTS_OF(boundary_list)},
	{"", NULL, "", HAWSER__ARRAYS_OF(line_list)},
	{"status", NULL, "number of points by status, and why the first of them has no value",
	 HAWSER__CALLS(counts_json)},
	{"", NULL, "", HAWSER__PART_OF(struct hawser_map, condensed, cli_condensed_field),
	 .when = CONDENSED},
	{"", NULL, "", HAWSER__PART_OF(struct hawser_map, narrow, cli_tongues_field), .when = NARROW},
	{"incomplete.rows", NULL, "amplitude: number of rows in which responses may be missing",
	 OF(incomplete), .when = ROWS},
	{"incomplete.first", NULL, "why, in the first of them; empty: there is none", OF(broken),
	 .when = ROWS},
	{"interrupted", NULL, "whether the map is incomplete",
	 HAWSER__FLAG_AT(struct hawser_map, interrupted)},
	HAWSER__END,
};
static const struct hawser__field visits_field[] = {
	{"computed", NULL, "points computed", OF(visited)},
	{"restored", NULL, "points from a checkpoint", OF(restored), .when = TIMES},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct hawser_basin, member)
static const struct hawser__field basin_field[] = {
	{"period", NULL, "periods of the load in one of the response", OF(period)},
	{"amplitude", NULL, "largest displacement of a probe along an axis, or of a coordinate",
	 OF(amplitude)},
	{"tension", NULL, "least tension over the period; null: the model has none", OF(tension),
	 .flags = HAWSER__NULL},
	{"multiplier", NULL, "largest modulus of its multipliers, over its period", OF(multiplier)},
	{"radius", NULL, "of its neighbourhood, relative to its size", OF(radius)},
	{"followed", NULL, "whether it is on a curve that was followed",
	 HAWSER__FLAG_AT(struct hawser_basin, followed)},
	{"share", NULL, "of the area of the map", OF(share)},
	{"error", NULL, "of the share, at most", OF(error)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list basin_list =
	HAWSER__STORED_ROWS(struct hawser_basins, basin, count, basin_field);
#define OF(member) HAWSER__AT(struct hawser_basins, member)
static const struct hawser__field basins_field[] = {
	{"basins", NULL, "basin: the responses, in the order of their numbers from 1",
	 HAWSER__OBJECTS_OF(basin_list)},
	{"other.share", NULL, "basin: share of motions that end at none of them", OF(other)},
	{"other.error", NULL, "of this share", OF(other_error)},
	{"escaped.share", NULL, "basin: share of motions without bounds", OF(escaped)},
	{"escaped.error", NULL, "of this share", OF(escaped_error)},
	{"entropy.all", NULL, "basin entropy of boxes of 5 x 5 points", OF(entropy)},
	{"entropy.boundary", NULL, "of the boxes with several numbers; above log 2: a fractal boundary",
	 OF(boundary_entropy)},
	{"periods", NULL, "basin: most periods of the load of a motion", OF(periods)},
	HAWSER__END,
};
#undef OF
static const struct hawser__field quantity_field[] = {
	{"quantity.name", NULL, "mapped quantity", HAWSER__AT(struct hawser_map_quantity, name)},
	HAWSER__END,
};
static const struct hawser__field counts_field[] = {
	{"quantity.number", NULL, "what `number` counts",
	 HAWSER__AT(struct hawser_map_quantity, counts)},
	HAWSER__END,
};
static const char *about_name(int responds)
{
	return responds ? "orbit" : "rest";
}
#define OF(member) HAWSER__AT(struct cli_map_result, member)
#define AXIS(name, k) \
	{name ".key", NULL, "parameter", OF(key[k])}, {name ".unit", NULL, "its unit", OF(unit[k])}, \
	{name ".from", NULL, "its range", OF(options.from[k])}, \
	{name ".to", NULL, "its range", OF(options.to[k])}, \
	{name ".points", NULL, "number of values", OF(options.points[k])}
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, model, cli_exact_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, quantity, quantity_field)},
	{"quantity.unit", NULL, "its unit", HAWSER__TEXT_BY(value_unit)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, quantity, counts_field)},
	{"about", NULL, "growth, multipliers: of motions about the periodic response (orbit) or rest",
	 HAWSER__LABEL_AT(struct cli_map_result, responds, about_name), .when = LINEAR},
	AXIS("x", 0), AXIS("y", 1),
	{"Omega", NULL, "frequency of the excitation, if it is no parameter", OF(omega),
	 .unit = HAWSER__RADIAN_S, .when = OMEGA},
	{"", NULL, "", HAWSER__PART_OF(struct cli_map_result, judged, cli_judged_field)},
	{"points", NULL, "lists by name", HAWSER__ARRAYS_OF(point_list), .flags = HAWSER__STREAM},
	{"", NULL, "", HAWSER__PART_OF(struct cli_map_result, basins, basins_field), .when = BASINS},
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, map, map_field)},
	HAWSER__END,
};
#undef OF
static const struct hawser__field cost_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_map_result, map, visits_field)},
	HAWSER__END,
};

const struct cli_listing cli_map_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Columns with --boundary:", boundary_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_map_result *result = of;

	return (struct cli_head){
		result->common, "map", result->quantity->name,
		result->model->has_scene ? &result->model->scene : NULL,
		{.scale = hawser__si, .context = result,
		 .options = (result->omega > 0.0 ? OMEGA : 0u) |
		            (result->map->condensed.points > 0 ? CONDENSED : 0u) |
		            (result->map->branches ? ROWS : 0u) |
		            (result->quantity->nonlinear ? 0u : LINEAR) |
		            (result->map->narrow.count > 0 || result->map->narrow.beyond ? NARROW : 0u) |
		            (result->basins.count > 0 ? BASINS : 0u) |
		            (result->common->reproducible ? 0u : TIMES)}, NULL, NULL, NULL};
}

const struct cli_showing cli_map_showing = {
	.head = head, .comments = comments, .rows = &point_list, .fields = result_field,
	.stats = cost_field, .draw = cli_map_draw};

void cli_map_boundary(struct hawser__table *table, const struct cli_map_result *result)
{
	struct cli_head shown = head(result);

	cli_echo_table(table, result->common, shown.command, shown.scene, shown.method);
	comments(table, result);
	hawser__fields_table(table, &boundary_list, result->map, &shown.view);
}

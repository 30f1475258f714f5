/* cli/map/hill_result.c - comments and fields of boundaries and multipliers, see hill_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/condensed.h"
#include "cli/model/exact.h"
#include "cli/map/hill_result.h"
#include "cli/map/tongues.h"
#include "cli/frame/view.h"

/* Width of a tongue in delta below which round-off exceeds it. */
#define NARROWEST 2e-15

static void head(struct hawser__table *table, const struct cli_hill_result *result,
                 const char *method)
{
	if (result->model) {
		cli_echo_table(table, result->common, "hill",
		               result->model->has_scene ? &result->model->scene : NULL, method);
		return;
	}
	hawser__table_comment(table, "hawser %s hill", hawser_version());
	hawser__table_comment(table,
	                      "Mathieu's equation x'' + 2 c x' + (delta + 2 epsilon cos 2t) x = 0, "
	                      "c = %.9g",
	                      result->damping);
	hawser__table_comment(table, "method: %s", method);
}

/* --- boundaries --- */

/* Whether boundaries are those of Mathieu's equation without damping, which have characteristic
 * values. */
static int characteristic(const struct cli_hill_result *result)
{
	return !result->model && result->damping == 0.0;
}

/* Distance of a point from the characteristic value of its boundary. a_r is the upper boundary of
 * tongue r, b_r the lower one; where epsilon is negative those of odd order change places. */
static double off(const struct hawser_hill_boundary *boundary, const double *at)
{
	int r = boundary->order, swapped = r%2 && at[1] < 0.0;
	int odd = r > 0 && (boundary->upper ? swapped : !swapped);
	double distance;

	return hawser_mathieu_distance(&distance, at[0], r, odd, at[1], NULL) ? NAN : distance;
}

/* Comments that describe the tongues of Mathieu's equation. */
static void tongues(struct hawser__table *table, const struct cli_hill_result *result)
{
	const struct hawser_hill_chart *chart = &result->chart;
	double worst = 0.0;

	for (int i = 0; i < chart->tongues; i++) {
		const struct hawser_hill_tongue *tongue = &chart->tongue[i];

		if (isinf(tongue->opens))
			hawser__table_comment(table, "tongue %d: closed by the damping in this plane",
			                      tongue->order);
		else if (result->damping > 0.0)
			hawser__table_comment(table, "tongue %d: begins at epsilon %.9g; %.2e to %.2e wide",
			                      tongue->order, tongue->opens, tongue->width[0],
			                      tongue->width[1]);
		else
			hawser__table_comment(table, "tongue %d: %.2e to %.2e wide%s", tongue->order,
			                      tongue->width[0], tongue->width[1],
			                      tongue->width[1] < NARROWEST*tongue->order*tongue->order
			                      ? ", less than digits of delta can tell" : "");
	}
	hawser__table_comment(table, "truncation of the Hill matrices: %.1e of delta", chart->truncation);
	if (!characteristic(result))
		return;
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < chart->boundary[b].points; i++)
			worst = fmax(worst, fabs(off(&chart->boundary[b], chart->boundary[b].at + 2*i)));
	hawser__table_comment(table, "largest distance from a characteristic value: %.2e", worst);
}

HAWSER__LABELS(kind_name, hawser_hill_kind_name, enum hawser_hill_kind)

enum { CHARACTERISTIC = 1, MATHIEU = 2, CONDENSED = 4, NARROW = 8, MODEL = 16 };

static void axis_name(char *text, size_t size, const struct cli_map_axis *axis)
{
	const char *of = strcmp(axis->unit, "1") != 0 ? axis->unit : "";

	snprintf(text, size, "%s%s%s", axis->key, *of ? "_" : "", of);
}

HAWSER__OF(x_unit, const char *, struct cli_hill_result, of->axis[0].unit)

HAWSER__OF(y_unit, const char *, struct cli_hill_result, of->axis[1].unit)

static void x_name(char *text, size_t size, const void *context)
{
	axis_name(text, size, &((const struct cli_hill_result *)context)->axis[0]);
}

static void y_name(char *text, size_t size, const void *context)
{
	axis_name(text, size, &((const struct cli_hill_result *)context)->axis[1]);
}

/* A point of boundary `number`, from 1. */
struct bounded {
	const struct hawser_hill_boundary *boundary;
	int number, points;
};
struct point {
	struct bounded of;
	enum hawser_hill_kind kind;
	double x, y, off;
};

static const void *point_row(void *to, const void *parent, size_t i)
{
	const struct bounded *of = parent;
	const double *at = of->boundary->at + 2*i;

	*(struct point *)to = (struct point){*of, of->boundary->kind, at[0], at[1],
	                                     off(of->boundary, at)};
	return to;
}

static const struct hawser__field point_field[] = {
	{NULL, "boundary", "number of the boundary", HAWSER__AT(struct point, of.number)},
	{NULL, "kind", "of the boundary, see there", HAWSER__LABEL_AT(struct point, kind, kind_name)},
	{NULL, "KEY", "first parameter", HAWSER__AT(struct point, x), .named = x_name,
	 .si = x_unit},
	{NULL, "KEY", "second parameter", HAWSER__AT(struct point, y), .named = y_name,
	 .si = y_unit},
	{NULL, "off_characteristic", "distance from the characteristic value of Mathieu's equation "
	 "without damping", HAWSER__AT(struct point, off), .when = CHARACTERISTIC},
	HAWSER__END,
};
static const struct hawser__list point_list =
	HAWSER__MADE_ROWS(struct point, point_field, struct bounded, points, point_row);

HAWSER__OF(order_of, double, struct hawser_hill_boundary,
	of->named ? of->order : HAWSER__NO_INTEGER)

HAWSER__OF(closed, double, struct hawser_hill_tongue, isinf(of->opens))

static const struct hawser__field pair_field[] = {
	{"points", NULL, "list of the two parameters", .kind = HAWSER__NUMBERS,
	 .size = 2*sizeof(double)},
	HAWSER__END,
};
static const struct hawser__list pair_list = {
	.field = pair_field, .size = 2*sizeof(double),
	.rows_at = offsetof(struct hawser_hill_boundary, at),
	.count_at = offsetof(struct hawser_hill_boundary, points)};
static const struct hawser__field boundary_field[] = {
	{"kind", NULL, "what happens there",
	 HAWSER__LABEL_AT(struct hawser_hill_boundary, kind, kind_name)},
	{"tongue", NULL, "order of its tongue, where that is known", HAWSER__COUNT_BY(order_of),
	 .flags = HAWSER__OMIT},
	{"limited", NULL, "whether it was not followed to its end, since it has the most points",
	 HAWSER__FLAG_AT(struct hawser_hill_boundary, limited)},
	{"", NULL, "", HAWSER__ARRAYS_OF(pair_list)},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct hawser_hill_tongue, member)
static const struct hawser__field tongue_field[] = {
	{"tongue", NULL, "order", OF(order)},
	{"width", NULL, "least and greatest width, of delta", OF(width)},
	{"closed", NULL, "whether the damping closes it in this plane", HAWSER__FLAG_BY(closed)},
	{"opens", NULL, "least |epsilon| at which it is open", OF(opens),
	 .flags = HAWSER__OMIT | HAWSER__INFINITE},
	HAWSER__END,
};
#undef OF
static const struct hawser__field condensing_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct hawser_hill_field, condensed, cli_condensed_field)},
	HAWSER__END,
};
static const char *about_name(int orbit)
{
	return orbit ? "orbit" : "rest";
}
static const struct hawser__field about_field[] = {
	{"about", NULL, "of the periodic response (orbit) or of rest",
	 HAWSER__LABEL_AT(struct hawser_hill_field, responds, about_name)},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct cli_hill_result, member)
static const struct hawser__field boundaries_field[] = {
	{"damping", NULL, "of Mathieu's equation", OF(damping), .when = MATHIEU},
	{"", NULL, "", HAWSER__THROUGH(struct cli_hill_result, field, about_field), .when = MODEL},
	{"axes.x", NULL, "first parameter", OF(axis[0].key)},
	{"axes.y", NULL, "second parameter", OF(axis[1].key)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_hill_result, judged, cli_judged_field)},
	{"boundaries", NULL, "of stability",
	 HAWSER__STORED(struct cli_hill_result, chart.boundary, chart.boundaries, boundary_field)},
	{"tongues", NULL, "of Mathieu's equation",
	 HAWSER__STORED(struct cli_hill_result, chart.tongue, chart.tongues, tongue_field),
	 .when = MATHIEU},
	{"", NULL, "", HAWSER__THROUGH(struct cli_hill_result, field, condensing_field),
	 .when = CONDENSED},
	{"", NULL, "", HAWSER__PART_OF(struct cli_hill_result, chart.narrow, cli_tongues_field),
	 .when = NARROW},
	{"missed", NULL, "points at which no response was found: boundaries may be missing there",
	 OF(chart.missed), .when = MODEL},
	{"interrupted", NULL, "whether boundaries are missing",
	 HAWSER__FLAG_AT(struct cli_hill_result, chart.interrupted)},
	{"evaluations", NULL, "points of the plane, or eigenvalue problems", OF(chart.evaluations)},
	HAWSER__END,
};
#undef OF

static struct hawser__view boundaries_view(const struct cli_hill_result *result)
{
	const struct hawser_map_condensed *condensed = result->field->condensed;

	return (struct hawser__view){
		hawser__si, result, (characteristic(result) ? CHARACTERISTIC : 0u) |
		(result->model ? MODEL : MATHIEU) |
		(result->chart.narrow.count > 0 || result->chart.narrow.beyond ? NARROW : 0u) |
		(result->model && condensed && condensed->points > 0 ? CONDENSED : 0u)};
}

static const char *limited(const struct hawser_hill_boundary *boundary)
{
	return boundary->limited ? ", the most: not followed to its end" : "";
}

static void boundaries_table(struct hawser__table *table, const void *of)
{
	const struct cli_hill_result *result = of;
	const struct hawser_hill_chart *chart = &result->chart;
	struct hawser__view view = boundaries_view(result);

	head(table, result, result->model ? "boundaries of stability by continuation"
	                                  : "boundaries of stability by the Hill matrices");
	if (result->model)
		hawser__table_comment(table, result->field->responds ? "about: the periodic response, or rest "
		                      "where nothing moves the model" : "about: rest");
	for (int b = 0; b < chart->boundaries; b++)
		if (chart->boundary[b].named)
			hawser__table_comment(table, "boundary %d: %s, tongue %d, %d points%s", b + 1,
			                      hawser_hill_kind_name(chart->boundary[b].kind),
			                      chart->boundary[b].order, chart->boundary[b].points,
			                      limited(&chart->boundary[b]));
		else
			hawser__table_comment(table, "boundary %d: %s, %d points%s", b + 1,
			                      hawser_hill_kind_name(chart->boundary[b].kind),
			                      chart->boundary[b].points, limited(&chart->boundary[b]));
	if (!result->model)
		tongues(table, result);
	else if (result->field->condensed)
		cli_condensed_comment(table, result->field->condensed);
	cli_tongues_comment(table, &chart->narrow);
	cli_judged_comment(table, &result->judged);
	if (chart->missed > 0)
		hawser__table_comment(table, "at %ld points no response was found, and boundaries may be "
		                      "missing there: %s", chart->missed, chart->why);
	if (chart->interrupted)
		hawser__table_comment(table, "interrupted: boundaries are missing");
	if (result->model)
		cli_exact_range_comments(table, result->model);
	hawser__table_comment(table, result->model ? "%ld points of the plane"
	                                           : "%ld eigenvalue problems", chart->evaluations);
	hawser__fields_columns(table, point_field, &view);
	for (int b = 0; b < chart->boundaries; b++) {
		const struct bounded of_this = {&chart->boundary[b], b + 1, chart->boundary[b].points};

		hawser__fields_rows(table, NULL, &point_list, &of_this, &view);
	}
}

static void boundaries_json(struct hawser__json *json, const void *of)
{
	const struct cli_hill_result *result = of;
	struct hawser__view view = boundaries_view(result);

	if (result->model) {
		cli_echo_json(json, result->common, "hill",
		              result->model->has_scene ? &result->model->scene : NULL);
	} else {
		hawser__json_begin(json);
		hawser__json_text(json, json->root, "version", hawser_version());
		hawser__json_text(json, json->root, "command", "hill");
	}
	hawser__fields_json(json, json->root, boundaries_field, result, &view);
	cli_stats_json(json, result->common);
}

const struct cli_showing cli_hill_boundaries = {
	.table = boundaries_table, .json = boundaries_json, .draw = cli_hill_draw};

/* --- multipliers --- */

static const char *verdict(const struct cli_hill_result *result)
{
	return result->outside > 0 ? "unstable" : result->undecided > 0 ? "undecided" : "stable";
}

static void multiplier_comments(struct hawser__table *table, const void *of)
{
	const struct cli_hill_result *result = of;
	double sum = 0.0;
	char more[80] = "";

	for (int i = 0; i < result->m; i++)
		sum += result->log_modulus[i];
	if (result->undecided > 0)
		snprintf(more, sizeof more, ", %d undecided (on it within the error)", result->undecided);
	hawser__table_comment(table,
	                      "Omega = %.12g%s: %s, %d of %d multipliers outside the unit circle%s",
	                      result->omega, cli_unit(result->model, " rad/s"), verdict(result),
	                      result->outside, result->m, more);
	cli_judged_comment(table, &result->judged);
	hawser__table_comment(table, "sum of the logarithms: %.15g; estimated error of one: %.1e", sum,
	                      result->error);
}

struct multiplier {
	double log_modulus, argument, modulus, re, im;
};

static const void *multiplier_row(void *to, const void *parent, size_t i)
{
	const struct cli_hill_result *result = parent;
	double log_modulus = result->log_modulus[i], argument = result->argument[i];
	double period = 2.0*M_PI*cli_per_omega(result->model)/result->omega;

	*(struct multiplier *)to = (struct multiplier){
		log_modulus, argument, exp(fmin(log_modulus, 700.0)), log_modulus/period, argument/period};
	return to;
}

#define OF(member) HAWSER__AT(struct multiplier, member)
static const struct hawser__field multiplier_field[] = {
	{NULL, "multiplier", "number", .kind = HAWSER__INDEX},
	{"log_modulus", "log_modulus", "logarithm of the modulus", OF(log_modulus)},
	{"argument", NULL, "argument", OF(argument), .unit = HAWSER__RADIAN},
	{NULL, "argument", "argument", OF(argument), .unit = HAWSER__RADIAN},
	{NULL, "modulus", "e^700 at most", OF(modulus)},
	{NULL, "exponent_re", "real part of the exponent", OF(re), .unit = HAWSER__PER_S},
	{NULL, "exponent_im", "imaginary part", OF(im), .unit = HAWSER__RAD_S},
	HAWSER__END,
};
#undef OF
static const struct hawser__list multiplier_list = HAWSER__MADE_ROWS(
	struct multiplier, multiplier_field, struct cli_hill_result, m, multiplier_row);

HAWSER__GIVEN(is_judged, struct cli_hill_result, of->judged.stated)
#define OF(member) HAWSER__AT(struct cli_hill_result, member)
static const struct hawser__field multipliers_field[] = {
	{"Omega", NULL, "frequency of the excitation", OF(omega), .unit = HAWSER__RADIAN_S},
	{"about", NULL, "orbit or rest", HAWSER__LABEL_AT(struct cli_hill_result, orbit, about_name)},
	{"error", NULL, "estimated error of log_modulus", OF(error)},
	{"frequency_error", NULL, "largest relative error of a natural frequency of the travelling cable",
	 OF(judged.error), .given = is_judged},
	{"multipliers", NULL, "Floquet multipliers", HAWSER__OBJECTS_OF(multiplier_list)},
	HAWSER__END,
};
#undef OF

static struct cli_head multipliers_head(const void *of)
{
	const struct cli_hill_result *result = of;

	return cli_model_head(result->common, "hill",
	                      result->orbit ? "Floquet multipliers about the periodic response"
	                                    : "Floquet multipliers about rest", result->model, 0);
}

const struct cli_showing cli_hill_multipliers = {
	.head = multipliers_head, .comments = multiplier_comments, .rows = &multiplier_list,
	.fields = multipliers_field};

const struct cli_listing cli_hill_listing[] = {
	{"Columns of boundaries:", point_field, 0},
	{"Columns of multipliers (--Omega alone):", multiplier_field, 0},
	{"Keys of JSON of boundaries:", boundaries_field, 1},
	{"Keys of multipliers:", multipliers_field, 1},
	{NULL, NULL, 0},
};

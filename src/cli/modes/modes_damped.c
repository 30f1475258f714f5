/* cli/modes/modes_damped.c - hawser modes --damped and --over: see modes_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_rom.h>

#include "cli/model/axis.h"
#include "cli/modes/modes_result.h"
#include "core/report.h"
#include "output/drawing/figure.h"

static const double least_gain = 1e-3; /* of a best value over the worst, relative; chosen */

/* The values of --over, in SI. */
static enum hawser_status read_over(struct cli_damped_result *result, const char *over,
                                    struct hawser_report *report)
{
	struct cli_key_sweep *range = &result->range;
	enum hawser_status status;
	char text[64];

	range->command = "modes";
	range->over = over;
	range->example = "attach.0.at=0.02:0.1:41";
	status = cli_key_sweep_read(range, report);
	result->key = range->key;
	for (int i = 0; i < range->points && !status && *range->si; i++) {
		snprintf(text, sizeof text, "%.17g %s", range->value[i], range->si);
		status = cli_quantity(&range->value[i], text, cli_key_unit(range->key), CLI_ANY, "modes",
		                      "over", report);
	}
	return status;
}

/* A net at a value of the key, with the elements that it has. */
static enum hawser_status net_at(void *context, struct hawser_damped *state, double value,
                                 struct hawser_report *report)
{
	const struct cli_damped_result *result = context;
	char set[CLI_KEY_SWEEP_SET];
	struct cli_common common;
	struct hawser_net net;
	enum hawser_status status;

	cli_key_sweep_at(&common, set, &result->range, result->common, value);
	status = cli_read_net(&net, &common, report);
	if (status)
		return cli_key_sweep_blame(report, status, &result->range, set);
	for (int c = 0; c < net.cables; c++)
		net.cable[c].elements = result->net.cable[c].elements;
	status = hawser_net_damped_solve(state, &net, result->n, report);
	hawser_net_clear(&net);
	return status;
}

/* A sweep of one point: the scene as it is. */
static enum hawser_status solve_one(struct cli_damped_result *result, int n,
                                    struct hawser_report *report)
{
	const struct hawser_damped_options options = {.n = n};
	struct hawser_statics statics;
	enum hawser_status status = result->net.cables ? HAWSER_OK
		: hawser_statics_scene(&statics, &result->scene, report);

	if (status)
		return status;
	result->sweep.state = calloc(1, sizeof *result->sweep.state);
	result->sweep.value = calloc(1, sizeof *result->sweep.value);
	if (!result->sweep.state || !result->sweep.value)
		return hawser__no_memory(report, "modes");
	result->sweep.points = 1;
	if (result->net.cables)
		return hawser_net_damped_solve(result->sweep.state, &result->net, n, report);
	return hawser_damped_solve(result->sweep.state, &statics, &result->scene, &options, report);
}

/* Mode `number` of a plane, or NULL. */
static const struct hawser_damped_mode *mode_of(const struct hawser_damped *state, int plane,
                                                int number)
{
	for (int k = 0; k < state->n; k++)
		if ((int)state->mode[k].plane == plane && state->mode[k].number == number)
			return &state->mode[k];
	return NULL;
}

/* Modes 1 to n of a plane at one value: the smallest damping ratio; *number: of that mode. */
static double least_damping(int *number, const struct hawser_damped *state, int plane, int n)
{
	double least = INFINITY;

	for (int k = 1; k <= n; k++)
		if (mode_of(state, plane, k)->ratio < least) {
			least = mode_of(state, plane, k)->ratio;
			*number = k;
		}
	return least;
}

/* Of the modes that a plane has at all values. Without a difference there is nothing to choose. */
static void find_best(struct cli_damped_result *result, int plane)
{
	const struct hawser_damped_sweep *sweep = &result->sweep;
	struct cli_damped_best best = {.plane = plane, .modes = INT_MAX, .ratio = -INFINITY};
	double worst = INFINITY;

	for (int i = 0; i < sweep->points; i++) {
		int count = 0;

		while (mode_of(&sweep->state[i], plane, count + 1))
			count++;
		best.modes = count < best.modes ? count : best.modes;
	}
	for (int i = 0; i < sweep->points && best.modes > 0; i++) {
		int number = 0;
		double ratio = least_damping(&number, &sweep->state[i], plane, best.modes);

		worst = fmin(worst, ratio);
		if (ratio > best.ratio) {
			best.ratio = ratio;
			best.value = sweep->value[i];
			best.number = number;
			best.end = i == 0 || i == sweep->points - 1;
		}
	}
	if (best.ratio > 0.0 && best.ratio - worst > least_gain*best.ratio)
		result->best[result->bests++] = best;
}

enum hawser_status cli_damped_solve(struct cli_damped_result *result, const char *over, int n,
                                    struct hawser_report *report)
{
	struct hawser_damped_sweep_options options = {.modes = {.n = n}};
	const struct hawser_damped_source source = {net_at, result};
	enum hawser_status status;

	result->n = n;
	result->wind = result->scene.wind.present || result->net.winds > 0;
	if (!over)
		return solve_one(result, n, report);
	status = read_over(result, over, report);
	options.key = result->key;
	options.value = result->range.value;
	options.points = result->range.points;
	*result->range.si = '\0'; /* the values are in SI */
	if (!status)
		status = result->net.cables ? hawser_damped_follow(&result->sweep, &source, &options, report)
			: hawser_damped_trace(&result->sweep, &result->scene, &options, report);
	for (int plane = 0; plane < 2 && !status && !result->wind; plane++)
		find_best(result, plane);
	return status;
}

void cli_damped_free(struct cli_damped_result *result)
{
	hawser_damped_sweep_clear(&result->sweep);
	hawser_scene_clear(&result->scene);
	hawser_net_clear(&result->net);
	free(result->range.value);
}

/* --- fields --- */

enum { SWEPT = 1, SINGLE = 2 };

/* A mode at a value of the key. */
struct row {
	double value, omega, re, ratio, residual;
	int index, number;
	const char *plane;
};

/* Unit of the values. The place of an attachment is in m where the scene gives it so. */
static const char *unit_of(const struct cli_damped_result *result)
{
	const struct hawser_scene *scene = &result->scene;
	size_t length = strlen(result->key);
	double at = NAN;

	if (strncmp(result->key, "attach.", 7) == 0 && strcmp(result->key + length - 3, ".at") == 0 &&
	    !hawser_scene_get(scene, &at, result->key, NULL))
		for (int i = 0; i < scene->attachments; i++)
			if (scene->attach[i].at == at && scene->attach[i].by_length)
				return "m";
	return cli_key_unit(result->key);
}

static const char *per_s(const void *context)
{
	(void)context;
	return "1/s";
}

HAWSER__OF(key_unit, const char *, struct cli_damped_result, of ? unit_of(of) : "")

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_damped_field[] = {
	{"value", "value", "with --over: of the key, in SI", OF(value), .when = SWEPT,
	 .si = key_unit},
	{"index", "index", "from 1, by damped frequency", OF(index)},
	{"omega", "omega", "damped circular frequency: imaginary part of the eigenvalue", OF(omega),
	 .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "damped frequency", OF(omega), .unit = HAWSER__HERTZ},
	{"re", "re_per_s", "real part of the eigenvalue (1/s)", OF(re), .si = per_s},
	{"damping_ratio", "damping_ratio", "fraction of critical damping", OF(ratio),
	 .axis = "Damping ratio {/:Italic ζ}"},
	{"plane", "plane", "in-plane or out-of-plane", OF(plane)},
	{"number", "number", "from 1, by damped frequency, in its plane", OF(number)},
	{"residual", "residual", "error estimate of the eigenvalue, relative", OF(residual)},
	HAWSER__END,
};
#undef OF

static size_t count_rows(const void *parent)
{
	const struct cli_damped_result *result = parent;
	size_t count = 0;

	for (int i = 0; i < result->sweep.points; i++)
		count += (size_t)result->sweep.state[i].n;
	return count;
}

static const void *row_at(void *to, const void *parent, size_t index)
{
	const struct cli_damped_result *result = parent;
	const struct hawser_damped *state = result->sweep.state;
	const struct hawser_damped_mode *mode;

	for (; index >= (size_t)state->n; state++)
		index -= (size_t)state->n;
	mode = &state->mode[index];
	*(struct row *)to = (struct row){
		.value = result->sweep.value[state - result->sweep.state], .index = (int)index + 1,
		.omega = mode->omega/state->time_unit, .re = mode->re/state->time_unit,
		.ratio = mode->ratio, .residual = mode->residual, .number = mode->number,
		.plane = hawser_plane_name(mode->plane)};
	return to;
}
static const struct hawser__list row_list = {
	.field = cli_damped_field, .size = HAWSER__MADE_SIZE(struct row), .count = count_rows,
	.row = row_at};

/* An event of the sweep. */
struct event_row {
	double value, frequency;
	const char *kind, *plane;
	int number;
};
#define OF(member) HAWSER__AT(struct event_row, member)
static const struct hawser__field event_field[] = {
	{"kind", NULL, "onset: from here on the mode grows; end: it no longer does", OF(kind)},
	{"value", NULL, "value of the key, in SI", OF(value)},
	{"frequency", NULL, "of the mode, Hz", OF(frequency)},
	{"plane", NULL, "in-plane or out-of-plane", OF(plane)},
	{"number", NULL, "as that of the modes", OF(number)},
	HAWSER__END,
};
#undef OF

HAWSER__OF(count_events, size_t, struct cli_damped_result, (size_t)of->sweep.events)

static const void *event_at(void *to, const void *parent, size_t index)
{
	const struct hawser_damped_event *event =
		&((const struct cli_damped_result *)parent)->sweep.event[index];

	*(struct event_row *)to = (struct event_row){
		.kind = event->onset ? "onset" : "end", .value = event->value,
		.frequency = event->frequency, .plane = hawser_plane_name(event->plane),
		.number = event->number};
	return to;
}
static const struct hawser__list event_list = {
	.field = event_field, .size = HAWSER__MADE_SIZE(struct event_row), .count = count_events,
	.row = event_at};
HAWSER__LABELS(best_plane, hawser_plane_name, enum hawser_plane)
#define OF(member) HAWSER__AT(struct cli_damped_best, member)
static const struct hawser__field best_field[] = {
	{"plane", NULL, "in-plane or out-of-plane",
	 HAWSER__LABEL_AT(struct cli_damped_best, plane, best_plane)},
	{"modes", NULL, "looked at, from 1", OF(modes)},
	{"value", NULL, "of the key, in SI: there the least damped of them is damped most", OF(value)},
	{"damping_ratio", NULL, "of that mode", OF(ratio)},
	{"number", NULL, "its number", OF(number)},
	HAWSER__END,
};
#undef OF
const struct hawser__field cli_damped_member[] = {
	{"over", NULL, "with --over: the key", HAWSER__AT(struct cli_damped_result, key),
	 .flags = HAWSER__OMIT},
	{"damped", NULL, "with --damped or --over: damped modes", HAWSER__OBJECTS_OF(row_list)},
	{"best", NULL, "with --over, without wind: for each plane the value of the largest least damping",
	 HAWSER__STORED_WITHIN(struct cli_damped_result, best, bests, best_field), .flags = HAWSER__OMIT},
	{"events", NULL, "with --over, in a wind: where modes begin or cease to grow",
	 HAWSER__OBJECTS_OF(event_list), .flags = HAWSER__OMIT},
	HAWSER__END,
};

static struct cli_head head(const void *of)
{
	const struct cli_damped_result *result = of;
	struct cli_head head = cli_si_head(result->common, "modes", "damped", result,
	                                   result->key ? SWEPT : SINGLE);

	head.scene = result->net.cables ? NULL : &result->scene;
	return head;
}

static void over_comments(struct hawser__table *table, const struct cli_damped_result *result)
{
	const char *unit = unit_of(result), *blank = strcmp(unit, "1") ? " " : "";
	const struct hawser__shown_unit shown = hawser__shown_unit(unit);

	unit = *blank ? unit : "";
	hawser__table_comment(table, "damped modes over %s, %d values (%s)", result->key,
	                      result->sweep.points, *blank ? shown.name : "-");
	for (int i = 0; i < result->sweep.events; i++) {
		const struct hawser_damped_event *event = &result->sweep.event[i];

		hawser__table_comment(table, "event: %s of growth at %s = %.10g%s%s, %s %d, %.6g Hz",
		                      event->onset ? "onset" : "end", result->key, event->value, blank, unit,
		                      hawser_plane_name(event->plane), event->number, event->frequency);
	}
	for (int i = 0; i < result->bests; i++) {
		const struct cli_damped_best *best = &result->best[i];

		hawser__table_comment(table, "best of these values for %s modes 1 to %d: %s = %.6g%s%s; the "
		                      "least damped, mode %d, has %.4g %% there%s",
		                      hawser_plane_name((enum hawser_plane)best->plane), best->modes,
		                      result->key, best->value, blank, unit, best->number,
		                      100.0*best->ratio,
		                      best->end ? " (an end of the range: widen it)" : "");
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_damped_result *result = of;
	const struct hawser_damped *state = result->sweep.state;

	if (result->key) {
		over_comments(table, result);
		return;
	}
	hawser__table_comment(table, "%d %s, time unit %.12g s", state->basis, result->net.cables
	                      ? "modes without damping" : "functions a component", state->time_unit);
	if (state->overdamped > 0)
		hawser__table_comment(table, "%d further motion%s of this range, with dampers above the "
		                      "critical size, creep%s without oscillation, the slowest at %.6g 1/s",
		                      state->overdamped, state->overdamped == 1 ? "" : "s",
		                      state->overdamped == 1 ? "s" : "", state->slowest/state->time_unit);
}

/* --- picture: damping over the key, a curve for each mode that is damped --- */

/* In per cent, or the frequency in Hz. */
static double drawn_of(const struct hawser_damped *state, int plane, int number, int frequency)
{
	const struct hawser_damped_mode *mode = mode_of(state, plane, number);

	return !mode ? NAN : frequency ? mode->omega/state->time_unit/(2.0*M_PI) : 100.0*mode->ratio;
}

/* Modes of the plane: solid; those out of it: dashed, in the same colours. */
static void draw_curves(struct hawser__figure *figure, const struct cli_damped_result *result,
                        int frequency)
{
	enum { CURVES = 8 };
	const struct hawser_damped_sweep *sweep = &result->sweep;
	char title[40];

	for (int number = 1, curves = 0; number <= sweep->state->n; number++)
		for (int plane = 0; plane < 2 && curves < CURVES; plane++) {
			double most = 0.0;

			for (int i = 0; i < sweep->points; i++)
				most = fmax(most, fabs(drawn_of(&sweep->state[i], plane, number, 0)));
			if (most < 1e-7) /* not damped */
				continue;
			for (int i = 0; i < sweep->points; i++)
				hawser__figure_put(figure, sweep->value[i],
				                   drawn_of(&sweep->state[i], plane, number, frequency));
			snprintf(title, sizeof title, "%s %d", hawser_plane_name((enum hawser_plane)plane), number);
			hawser__figure_draw(figure, title, "with lines lt %d%s", ++curves,
			                    plane ? " dt (9,5)" : "");
		}
	for (int i = 0; i < result->bests && !frequency; i++)
		hawser__figure_put(figure, result->best[i].value, 100.0*result->best[i].ratio);
	if (result->bests > 0 && !frequency)
		hawser__figure_draw(figure, "largest least damping of a plane", HAWSER__CROSSING);
	for (int i = 0; i < sweep->events; i++)
		hawser__figure_put(figure, sweep->event[i].value, frequency ? sweep->event[i].frequency : 0.0);
	if (sweep->events > 0)
		hawser__figure_draw(figure, "growth begins or ends", HAWSER__CROSSING);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	static const struct hawser__axis shown[] = {{"Damping ratio {/:Italic ζ} (%)", "", 1.0},
	                                            {"Frequency (Hz)", "", 1.0}};
	static const double end[] = {HAWSER__LEGEND_CM/11.0, 0.97, HAWSER__LEGEND_CM/16.0, 0.5, 0.55, 0.97};
	const struct cli_damped_result *result = of;
	const struct hawser_damped_sweep *sweep = &result->sweep;
	struct hawser__figure figure = {0};
	struct hawser__axis axis;
	enum hawser_status status;
	int panels = result->wind ? 2 : 1;
	double ends[2];

	if (!result->key)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "--plot with --damped shows the damping over a key: give "
		                    "--over KEY=FROM:TO:POINTS");
	status = hawser__figure_begin(&figure, path, 16.0, panels > 1 ? 16.0 : 11.0, report);
	if (status)
		return status;
	ends[0] = ends[1] = sweep->value[0];
	for (int i = 1; i < sweep->points; i++) {
		ends[0] = fmin(ends[0], sweep->value[i]);
		ends[1] = fmax(ends[1], sweep->value[i]);
	}
	axis = cli_axis(result->key, unit_of(result), fmax(fabs(ends[0]), fabs(ends[1])));
	for (int p = 0; p < panels; p++) {
		const double *at = end + (panels > 1 ? p ? 2 : 4 : 0);

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, at[0], at[1],
			.x = {&axis, ends[0], ends[1], .tics = 8, .logarithmic = result->range.logarithmic,
			      .untitled = p < panels - 1},
			.y = {&shown[p], .zero = panels == 1, .tics = 7, .room = 0.06}});
		draw_curves(&figure, result, p);
	}
	return hawser__figure_finish(&figure, report);
}

const struct cli_showing cli_damped_showing = {
	.head = head, .comments = comments, .rows = &row_list, .fields = cli_damped_member, .draw = draw};

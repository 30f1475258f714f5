/* cli/measure/cmd_identify.c - hawser identify: parameters of a scene from measured natural
 * frequencies. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/identify.h>

#include "cli/model/axis.h"
#include "cli/measure/series.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/figure.h"

#define WIDE 0.3       /* half width of an interval, relative: the parameter can hardly be seen */
#define UNLIKELY 0.01  /* probability of a larger chi2 */
#define CLEAR 10.0     /* margin of the assignment of modes */
#define TOGETHER 0.995 /* correlation of two parameters that can hardly be told apart */

struct settings {
	struct cli_common common;
	const char *free, *fitted;
	double confidence;
};
static const struct settings defaults = {.confidence = 0.95};

static const struct cli_option options[] = {
	CLI_TEXT_OPTION(free, "KEY,...", "parameters to be fitted, such as tension.T0,cable.EA"),
	{"confidence", 0, "P", "confidence level of the intervals (0.95)", CLI_POSITIVE(confidence)},
	CLI_TEXT_OPTION(fitted, "FILE", "write the scene with the fitted values"),
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Fits parameters of the scene to measured natural frequencies by weighted least squares, with",
	"confidence intervals, and tells what the frequencies cannot determine. Fitted values start",
	"from those of the scene.",
	"FREQUENCIES: a table with a column frequency_Hz or omega_rad_s and, where they are known,",
	"deviation_Hz, plane, index (number of the mode) or number (in its plane).",
	NULL,
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	struct hawser_measured *measured; /* [count] */
	int count;
	char *names; /* copy of --free, in pieces */
	const char *key[HAWSER_IDENTIFY_KEYS + 1];
	int keys;
	struct hawser_identified found;
	char warning[CLI_WARNING_SIZE];
};

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)

#define OF(member) HAWSER__AT(struct hawser_identified_mode, member)
static const struct hawser__field mode_field[] = {
	{"index", "index", "number of the mode by frequency, both planes together", OF(place)},
	{"plane", "plane", "in-plane or out-of-plane",
	 HAWSER__LABEL_AT(struct hawser_identified_mode, plane, plane_name)},
	{"number", "number", "number in its plane", OF(number)},
	{"matched", "matched", "1: the mode was found by its frequency; 0: it was given",
	 HAWSER__FLAG_AT(struct hawser_identified_mode, matched)},
	{"measured", "measured", "measured frequency", OF(measured), .unit = HAWSER__HERTZ},
	{"computed", "computed", "computed frequency, with the fitted values", OF(computed),
	 .unit = HAWSER__HERTZ},
	{"before", "before", "computed frequency, with the values of the scene", OF(before),
	 .unit = HAWSER__HERTZ, .flags = HAWSER__NULL},
	{"difference", "difference", "computed/measured - 1", OF(difference)},
	{"deviation", "deviation", "standard deviation of the measurement, relative: as given, or "
	 "estimated from the differences", OF(deviation), .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
static const struct hawser__list mode_list =
	HAWSER__STORED_ROWS(struct hawser_identified, mode, count, mode_field);

HAWSER__OF(unit_of, const char *, struct hawser_identified_key, cli_key_unit(of->key))

#define OF(member) HAWSER__AT(struct hawser_identified_key, member)
static const struct hawser__field key_field[] = {
	{"key", NULL, "key of the scene", OF(key)},
	{"unit", NULL, "its unit", HAWSER__TEXT_BY(unit_of)},
	{"value", NULL, "fitted value", OF(value)},
	{"low", NULL, "lower end of its confidence interval", OF(low), .flags = HAWSER__NULL},
	{"high", NULL, "upper end", OF(high), .flags = HAWSER__NULL},
	{"relative", NULL, "half of the interval's width, relative", OF(relative),
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"start", NULL, "value in the scene", OF(start)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list key_list =
	HAWSER__ROWS_WITHIN(struct hawser_identified, key, keys, key_field);

#define OF(member) HAWSER__AT(struct hawser_identified, member)
static const struct hawser__field found_field[] = {
	{"parameters", NULL, "fitted parameters", HAWSER__OBJECTS_OF(key_list)},
	{"frequencies", NULL, "measurements and their modes", HAWSER__OBJECTS_OF(mode_list)},
	{"freedom", NULL, "degrees of freedom: measurements less parameters", OF(freedom)},
	{"spread", NULL, "root mean square of log(computed/measured) by the degrees of freedom",
	 OF(spread), .flags = HAWSER__NULL},
	{"chi2", NULL, "sum of squares of differences over deviations", OF(chi2),
	 .flags = HAWSER__NULL},
	{"probability", NULL, "of a larger chi2 if scene and deviations are right", OF(probability),
	 .flags = HAWSER__NULL},
	{"weakness", NULL, "standard deviation, relative, of the combination of parameters that is "
	 "known worst", OF(weakness), .flags = HAWSER__NULL},
	{"skipped", NULL, "modes below the highest measured one without a measurement", OF(skipped)},
	{"margin", NULL, "by which the next best assignment of modes is worse, in chi2 and 6 for each "
	 "mode skipped", OF(margin), .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"doubtful", NULL, "measurement that could most easily belong to another mode, from 1",
	 OF(doubtful), .flags = HAWSER__FROM_1 | HAWSER__NULL},
	{"doubt", NULL, "by which chi2 would be larger then", OF(doubt),
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"evaluations", NULL, "number of computations of modes", OF(evaluations)},
	HAWSER__END,
};
#undef OF
HAWSER__OF(confidence, double, struct result, of->settings->confidence)

static const struct hawser__field result_field[] = {
	{"confidence", NULL, "level of the intervals",
	 HAWSER__BY(confidence)},
	{"", NULL, "", HAWSER__PART_OF(struct result, found, found_field)},
	HAWSER__END,
};
const struct cli_listing cli_identify_listing[] = {
	{"Columns of the table:", mode_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* --- output --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return (struct cli_head){&result->settings->common, "identify",
	                         "least squares of the logarithms of the frequencies", &result->scene,
	                         cli_si_view(0), &result->found, NULL, NULL};
}

static void key_comment(struct hawser__table *table, const struct result *result, int k)
{
	const struct hawser_identified_key *key = &result->found.key[k];
	const char *unit = cli_key_unit(key->key), *space = strcmp(unit, "1") == 0 ? "" : " ";

	unit = *space ? unit : "";
	if (isnan(key->low))
		hawser__table_comment(table, "%s = %.9g%s%s (no interval: as many parameters as "
		                      "frequencies; start %.9g%s%s)", key->key, key->value, space, unit,
		                      key->start, space, unit);
	else
		hawser__table_comment(table, "%s = %.9g%s%s (%g %%: %.9g to %.9g%s%s; start %.9g%s%s)",
		                      key->key, key->value, space, unit,
		                      100.0*result->settings->confidence, key->low, key->high, space, unit,
		                      key->start, space, unit);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_identified *found = &result->found;

	for (int k = 0; k < found->keys; k++)
		key_comment(table, result, k);
	if (!isnan(found->chi2) && found->freedom > 0)
		hawser__table_comment(table, "chi2 = %.4g with %d degrees of freedom; probability of a "
		                      "larger one %.3g", found->chi2, found->freedom, found->probability);
	else if (found->freedom > 0)
		hawser__table_comment(table, "standard deviation of the measurements, from the "
		                      "differences: %.3g, relative", found->spread);
	if (*result->warning)
		hawser__table_comment(table, "%s", result->warning);
}

/* Differences in per cent, of the scene as given, or of the fitted one with the deviations of the
 * measurements; the range is even about 0. */
static void draw_differences(struct hawser__figure *figure, struct hawser__panel_frame *at,
                             const struct hawser_identified *found, int fitted)
{
	static const char *const style[] = {"lt 1 pt 7 ps 0.7", "lt 2 pt 6 ps 0.8"};
	static const char *const title[] = {"in-plane", "out-of-plane"};
	double most = 0.0;

	for (int i = 0; i < found->count; i++) {
		const struct hawser_identified_mode *mode = &found->mode[i];
		double value = fabs(fitted ? mode->difference : mode->before/mode->measured - 1.0);

		most = fmax(most, isfinite(value) ? value : 0.0);
		if (fitted && isfinite(mode->deviation))
			most = fmax(most, value + mode->deviation);
	}
	at->y.to = most > 0.0 ? 1.15*100.0*most : 1.0;
	at->y.from = -at->y.to;
	hawser__figure_panel(figure, at);
	hawser__figure_function(figure, NULL, "0 with lines lc rgb '#909090' lw 1");
	for (int plane = 0; plane < 2; plane++) {
		for (int i = 0; i < found->count; i++) {
			const struct hawser_identified_mode *mode = &found->mode[i];
			double value = fitted ? mode->difference : mode->before/mode->measured - 1.0;
			const double row[] = {mode->measured/(2.0*M_PI), 100.0*value,
			                      isnan(mode->deviation) ? 0.0 : 100.0*mode->deviation};

			if ((mode->plane == HAWSER_OUT_OF_PLANE) == plane && isfinite(value))
				hawser__figure_row(figure, "xyY", row);
		}
		hawser__figure_draw(figure, NULL, "using %s %s", fitted ? "1:2:3 with yerrorbars"
		                    : "1:2 with points", style[plane]);
		hawser__figure_again(figure, title[plane], "using 1:(NaN) with points %s", style[plane]);
	}
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	static const struct hawser__axis given = {"As given (%)", "", 1.0};
	static const struct hawser__axis fitted = {"Fitted (%)", "", 1.0};
	const struct hawser_identified *found = &((const struct result *)of)->found;
	const struct hawser__axis axis = hawser__axis_of("Measured frequency", "Hz", 0.0);
	struct hawser__panel_frame at = {0.14, 0.97, 0.63, 0.97, .x = {&axis, .bare = 1},
	                                 .y = {&given, .tics = 6}};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, 12.8, report);
	double low = INFINITY, high = 0.0;

	if (status)
		return status;
	for (int i = 0; i < found->count; i++) {
		low = fmin(low, found->mode[i].measured/(2.0*M_PI));
		high = fmax(high, found->mode[i].measured/(2.0*M_PI));
	}
	at.x.from = 0.9*low;
	at.x.to = high + 0.1*low;
	at.x.tics = 8;
	draw_differences(&figure, &at, found, 0);
	at.bottom = 0.235;
	at.top = 0.575;
	at.x.bare = 0;
	at.y.axis = &fitted;
	draw_differences(&figure, &at, found, 1);
	hawser__legend_once(&figure.legend, "bars: standard deviation", "with lines lt 7 lw 1");
	return hawser__figure_finish(&figure, report);
}
static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &mode_list, .fields = result_field, .draw = draw};

/* --- what to warn of --- */

static void judge(struct result *result)
{
	const struct hawser_identified *found = &result->found;
	char *text = result->warning;
	size_t size = sizeof result->warning;

	for (int a = 0; a < found->keys; a++)
		for (int b = 0; b < a; b++)
			if (fabs(found->correlation[a][b]) > TOGETHER && found->key[a].relative > WIDE/10.0) {
				snprintf(text, size, "%s and %s can hardly be told apart by these frequencies "
				         "(correlation %.4f): keep one of them fixed, or measure further modes",
				         found->key[b].key, found->key[a].key, found->correlation[a][b]);
				return;
			}
	for (int k = 0; k < found->keys; k++)
		if (found->key[k].relative > WIDE) {
			snprintf(text, size, "%s can hardly be seen in these frequencies: its interval is "
			         "+-%.0f %% wide", found->key[k].key, 100.0*found->key[k].relative);
			return;
		}
	if (found->doubt < CLEAR)
		snprintf(text, size, "frequency %d of the table could as well belong to %s mode %d: give its "
		         "plane or number if it is known", found->doubtful + 1,
		         hawser_plane_name(found->other_plane), found->other_number);
	else if (found->margin < CLEAR)
		snprintf(text, size, "another assignment of modes fits nearly as well (%.2g more in chi2 "
		         "and for skipped modes): give the numbers of modes that are known",
		         found->margin);
	else if (found->probability < UNLIKELY)
		snprintf(text, size, "the differences are larger than the deviations explain (probability "
		         "%.2g): a mode is assigned wrongly, the scene lacks something, or the deviations "
		         "are too small; the intervals are too narrow then", found->probability);
}

/* --- the command --- */

static enum hawser_status split(struct result *result, const char *text,
                                struct hawser_report *report)
{
	char *at;

	if (!text)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "identify",
		                    "identify needs --free KEY,...: the parameters to be fitted, such as "
		                    "--free tension.T0");
	result->names = at = strdup(text);
	if (!at)
		return hawser__no_memory(report, "identify");
	for (char *key = strtok_r(at, ", ", &at); key; key = strtok_r(NULL, ", ", &at)) {
		if (result->keys == HAWSER_IDENTIFY_KEYS)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "identify",
			                    "--free %s: more than %d parameters", text, HAWSER_IDENTIFY_KEYS);
		result->key[result->keys++] = key;
	}
	return HAWSER_OK;
}

static enum hawser_status write_fitted(const struct result *result, struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status = hawser__file_begin(&file, result->settings->fitted, report);

	if (status)
		return status;
	status = hawser_scene_write(&result->found.scene, file.stream, report);
	if (!status)
		return hawser__file_commit(&file, report);
	hawser__file_abort(&file);
	return status;
}

static enum hawser_status prepare(struct result *result, const struct settings *settings,
                                  struct hawser_report *report)
{
	const struct cli_output more[] = {{"fitted", settings->fitted}};
	enum hawser_status status = cli_outputs_check_with(&settings->common, more, 1, report);

	if (!status && !settings->common.second)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "identify",
		                      "identify needs a SCENE and a table of FREQUENCIES (hawser identify "
		                      "--help)");
	if (!status)
		status = cli_state_check("frequencies", settings->common.second, &settings->common, report);
	if (!status)
		status = split(result, settings->free, report);
	if (!status)
		status = cli_scene_load(&result->scene, &settings->common, 0, report);
	if (!status)
		status = cli_measured_read(&result->measured, &result->count, settings->common.second,
		                           report);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result result = {.settings = settings};
	enum hawser_status status = prepare(&result, settings, report);
	struct hawser_identify_options choice = {.key = result.key, .keys = result.keys,
	                                         .confidence = settings->confidence};

	if (!status)
		status = hawser_identify(&result.found, &result.scene, result.measured, result.count,
		                         &choice, report);
	if (!status) {
		judge(&result);
		if (*result.warning)
			cli_warn(result.warning);
	}
	if (!status && settings->fitted)
		status = write_fitted(&result, report);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	hawser_identified_clear(&result.found);
	free(result.names);
	free(result.measured);
	hawser_scene_clear(&result.scene);
	return status;
}

const struct cli_command cli_identify = {
	"identify", "SCENE FREQUENCIES", "Parameters from measured natural frequencies", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_identify_listing,
	.takes = CLI_CABLE | CLI_TRAVELLING,
};

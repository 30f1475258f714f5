/* cli/cmd_damping.c - hawser damping: damping ratios from measured series.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/decay.h>

#include "cli/cli.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	double confidence;
	int half_power, x, y;
};
static const struct settings defaults = {.confidence = 0.95, .x = 1, .y = 2};

static const struct cli_option options[] = {
	{"half-power", 0, "", "the file is a response over rad/s, not a free decay", cli_store_flag,
	 offsetof(struct settings, half_power)},
	{"confidence", 0, "P", "of the intervals (0.95)", cli_store_positive,
	 offsetof(struct settings, confidence)},
	{"x", 0, "COLUMN", "with times or frequencies, from 1 (1)", cli_store_integer,
	 offsetof(struct settings, x)},
	{"y", 0, "COLUMN", "with displacements or amplitudes (2)", cli_store_integer,
	 offsetof(struct settings, y)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"From a free decay, a table of times and displacements: frequency and damping ratio by least",
	"squares, with confidence intervals, and the logarithmic decrement. With --half-power, from a",
	"table of frequencies and amplitudes: the damping ratio from the half-power points.",
	"FILE: columns of numbers; lines that begin with # or a letter are passed over.",
	NULL,
};

struct series {
	double *x, *y;
	int count, room;
};

static enum hawser_status grow(struct series *series, struct hawser_report *report)
{
	int more = series->room ? 2*series->room : 1024;
	double *x = realloc(series->x, (size_t)more*sizeof *x), *y;

	if (x)
		series->x = x;
	y = realloc(series->y, (size_t)more*sizeof *y);
	if (y)
		series->y = y;
	if (!x || !y)
		return hawser__no_memory(report, "damping");
	series->room = more;
	return HAWSER_OK;
}

/* The number in column `want` of a line, or 0 returned. */
static int column(double *value, const char *line, int want)
{
	char *end;

	for (int k = 1;; k++) {
		line += strspn(line, " \t,;");
		*value = strtod(line, &end);
		if (end == line)
			return 0;
		if (k == want)
			return 1;
		line = end;
	}
}

static enum hawser_status read_lines(struct series *series, FILE *stream,
                                     const struct settings *settings,
                                     struct hawser_report *report)
{
	char line[65536];
	enum hawser_status status = HAWSER_OK;

	for (int number = 1; !status && fgets(line, sizeof line, stream); number++) {
		const char *first = line + strspn(line, " \t\r\n");
		double x, y;

		if (!*first || *first == '#' || (isalpha((unsigned char)*first) && series->count == 0))
			continue;
		if (!column(&x, line, settings->x) || !column(&y, line, settings->y))
			return hawser__fail(report, HAWSER_ERR_SCENE, "damping",
			                    "%s:%d: no numbers in columns %d and %d", settings->common.input,
			                    number,
			                    settings->x, settings->y);
		if (series->count == series->room)
			status = grow(series, report);
		if (!status) {
			series->x[series->count] = x;
			series->y[series->count++] = y;
		}
	}
	if (!status && ferror(stream))
		status = hawser__fail(report, HAWSER_ERR_IO, "damping", "%s cannot be read",
		                      settings->common.input);
	return status;
}

static enum hawser_status read_series(struct series *series, const struct settings *settings,
                                      struct hawser_report *report)
{
	int standard = strcmp(settings->common.input, "-") == 0;
	FILE *stream = standard ? stdin : fopen(settings->common.input, "r");
	enum hawser_status status;

	if (!stream)
		return hawser__fail(report, HAWSER_ERR_IO, "damping", "%s cannot be opened",
		                    settings->common.input);
	status = read_lines(series, stream, settings, report);
	if (!standard)
		fclose(stream);
	return status;
}

/* Names and numbers, as a table of one row and as JSON. */
struct figure {
	const char *name;
	double number;
};

static enum hawser_status deliver(const struct settings *settings, const struct figure *figure,
                                  int count,
                                  const char *method, int samples, struct hawser_report *report)
{
	struct hawser__table table = {0};
	struct hawser__json json = {0};
	enum hawser_status status;

	cli_echo_table(&table, &settings->common, "damping", NULL, method);
	hawser__table_comment(&table, "%d samples", samples);
	for (int k = 0; k < count; k++)
		hawser__table_column(&table, "%s", figure[k].name);
	for (int k = 0; k < count; k++)
		hawser__table_number(&table, figure[k].number);
	if (settings->common.json) {
		cli_echo_json(&json, &settings->common, "damping", NULL);
		hawser__json_integer(&json, json.root, "samples", samples);
		for (int k = 0; k < count; k++)
			hawser__json_number(&json, json.root, figure[k].name, figure[k].number);
		cli_stats_json(&json, &settings->common);
	}
	status = cli_deliver(&settings->common, &table, &json, NULL, report);
	hawser__json_clear(&json);
	hawser__table_clear(&table);
	return status;
}

static enum hawser_status decay(const struct settings *settings, const struct series *series,
                                struct hawser_report *report)
{
	struct hawser_decay fit;
	enum hawser_status status = hawser_decay_fit(&fit, series->x, series->y, series->count,
	                                             settings->confidence, report);
	const struct figure figure[] = {
		{"ratio", fit.ratio}, {"ratio_low", fit.ratio - fit.ratio_error},
		{"ratio_high", fit.ratio + fit.ratio_error}, {"omega_rad_s", fit.omega},
		{"omega_low", fit.omega - fit.omega_error}, {"omega_high", fit.omega + fit.omega_error},
		{"log_decrement_ratio", fit.log_decrement}, {"amplitude", fit.amplitude},
		{"offset", fit.offset}, {"noise", fit.noise}, {"extremes", fit.extremes},
	};

	return status ? status : deliver(settings, figure, sizeof figure/sizeof *figure,
	                                 "least squares of a free decay", series->count, report);
}

static enum hawser_status half_power(const struct settings *settings, const struct series *series,
                                     struct hawser_report *report)
{
	struct hawser_half_power half = {0};
	enum hawser_status status = hawser_half_power_find(&half, series->x, series->y, series->count,
	                                                   report);
	const struct figure figure[] = {{"ratio", half.ratio}, {"peak_rad_s", half.peak},
		{"low_rad_s", half.low}, {"high_rad_s", half.high}};

	return status ? status : deliver(settings, figure, sizeof figure/sizeof *figure,
	                                 "half-power points",
	                                 series->count, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct series series = {NULL, NULL, 0, 0};
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	if (!status && settings->common.plot)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping", "damping has no picture");
	if (!status && settings->common.sets)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping",
		                      "--set is for scenes; damping reads a table");
	if (!status)
		status = read_series(&series, settings, report);
	if (!status)
		status = (settings->half_power ? half_power : decay)(settings, &series, report);
	free(series.x);
	free(series.y);
	return status;
}

const struct cli_command cli_damping = {
	"damping", "FILE", "Damping ratios from measured decays and responses", notes, options,
	        &defaults,
	sizeof(struct settings), 1, run,
};

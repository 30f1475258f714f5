/* cli/cmd_damping.c - hawser damping: damping ratios from measured series.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stddef.h>

#include <hawser/decay.h>

#include "cli/cli.h"
#include "cli/series.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	double confidence;
	int half_power;
	const char *x, *y;
};
static const struct settings defaults = {.confidence = 0.95, .x = "1"};

static const struct cli_option options[] = {
	{"half-power", 0, "", "the file is a response over rad/s, not a free decay", cli_store_flag,
	 offsetof(struct settings, half_power)},
	{"confidence", 0, "P", "confidence level of the intervals (0.95)", cli_store_positive,
	 offsetof(struct settings, confidence)},
	CLI_TEXT_OPTION(x, "COLUMN", "number or name of the column of times or frequencies (1)"),
	CLI_TEXT_OPTION(y, "COLUMN", "the same of displacements or amplitudes (2, or the largest)"),
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"From a free decay, a table of times and displacements: frequency and damping ratio by least",
	"squares, with confidence intervals, and the logarithmic decrement. With --half-power, from a",
	"table of frequencies and amplitudes: the damping ratio from the half-power points, with an",
	"interval.",
	"FILE: columns of numbers, such as the --tsv of hawser integrate or frf. Lines that begin with #",
	"are skipped. A line of words above the numbers names the columns.",
	NULL,
};

/* Names and numbers, as a table of one row and as JSON. */
struct figure {
	const char *name;
	double number;
};

static enum hawser_status deliver(const struct settings *settings, const struct figure *figure,
                                  int count, const char *method, const struct cli_series *series,
                                  struct hawser_report *report)
{
	struct hawser__table table = {0};
	struct hawser__json json = {0};
	enum hawser_status status;

	cli_echo_table(&table, &settings->common, "damping", NULL, method);
	hawser__table_comment(&table, "%d samples of %s over %s", series->count, series->y_name,
	                      series->x_name);
	for (int k = 0; k < count; k++)
		hawser__table_column(&table, "%s", figure[k].name);
	for (int k = 0; k < count; k++)
		hawser__table_number(&table, figure[k].number);
	if (settings->common.json) {
		cli_echo_json(&json, &settings->common, "damping", NULL);
		hawser__json_integer(&json, json.root, "samples", series->count);
		hawser__json_text(&json, json.root, "x", series->x_name);
		hawser__json_text(&json, json.root, "y", series->y_name);
		for (int k = 0; k < count; k++)
			hawser__json_number(&json, json.root, figure[k].name, figure[k].number);
		cli_stats_json(&json, &settings->common);
	}
	status = cli_deliver(&settings->common, &table, &json, NULL, report);
	hawser__json_clear(&json);
	hawser__table_clear(&table);
	return status;
}

static enum hawser_status decay(const struct settings *settings, const struct cli_series *series,
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
	                                 "least squares of a free decay", series, report);
}

static enum hawser_status half_power(const struct settings *settings, const struct cli_series *series,
                                     struct hawser_report *report)
{
	struct hawser_half_power half = {0};
	enum hawser_status status = hawser_half_power_find(&half, series->x, series->y, series->count,
	                                                   settings->confidence, report);
	const struct figure figure[] = {{"ratio", half.ratio}, {"peak_rad_s", half.peak},
		{"low_rad_s", half.low}, {"high_rad_s", half.high},
		{"ratio_low", half.ratio - half.ratio_error},
		{"ratio_high", half.ratio + half.ratio_error},
		{"peak_low", half.peak - half.peak_error}, {"peak_high", half.peak + half.peak_error}};

	return status ? status : deliver(settings, figure, sizeof figure/sizeof *figure,
	                                 "half-power points", series, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_series series = {0};
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	if (!status && settings->common.plot)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping", "damping has no picture");
	if (!status && settings->common.sets)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping",
		                      "--set is for scenes; damping reads a table");
	if (!status)
		status = cli_series_read(&series, settings->common.input, settings->x, settings->y, report);
	if (!status)
		status = (settings->half_power ? half_power : decay)(settings, &series, report);
	cli_series_clear(&series);
	return status;
}

const struct cli_command cli_damping = {
	"damping", "FILE", "Damping ratios from measured decays and responses", notes, options,
	        &defaults,
	sizeof(struct settings), 1, run, NULL,
};

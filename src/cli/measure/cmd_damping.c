/* cli/measure/cmd_damping.c - hawser damping: damping ratios from measured series.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>

#include <hawser/decay.h>

#include "cli/measure/series.h"
#include "cli/frame/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	double confidence;
	int half_power;
	const char *x, *y;
};
static const struct settings defaults = {.confidence = 0.95, .x = "1"};

static const struct cli_option options[] = {
	{"half-power", 0, "", "the file is a response over rad/s, not a free decay",
	 CLI_FLAG(half_power)},
	{"confidence", 0, "P", "confidence level of the intervals (0.95)", CLI_POSITIVE(confidence)},
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

/* Both methods have the fields of `decay` or `half`. */
struct result {
	const struct settings *settings;
	struct cli_series series;
	int rows; /* number of rows of the table: 1 */
	struct hawser_decay decay[1];
	struct hawser_half_power half[1];
};
enum { DECAY = 1, HALF_POWER = 2 };

/* An end of the confidence interval. */
#define INTERVAL(name, type, member, sign) \
	static double name(const void *row) \
	{ \
		const struct type *of = row; \
\
		return of->member sign of->member##_error; \
	}
INTERVAL(ratio_low, hawser_decay, ratio, -)
INTERVAL(ratio_high, hawser_decay, ratio, +)
INTERVAL(omega_low, hawser_decay, omega, -)
INTERVAL(omega_high, hawser_decay, omega, +)
INTERVAL(half_low, hawser_half_power, ratio, -)
INTERVAL(half_high, hawser_half_power, ratio, +)
INTERVAL(peak_low, hawser_half_power, peak, -)
INTERVAL(peak_high, hawser_half_power, peak, +)

HAWSER__OF(extremes, double, struct hawser_decay, of->extremes)

static const char *rad_s(const void *context)
{
	(void)context;
	return "rad/s";
}

#define BOTH(name) name, name
#define OF(member) HAWSER__AT(struct hawser_decay, member)
static const struct hawser__field decay_field[] = {
	{BOTH("ratio"), "damping ratio", OF(ratio)},
	{BOTH("ratio_low"), "lower end of its confidence interval", HAWSER__BY(ratio_low)},
	{BOTH("ratio_high"), "upper end", HAWSER__BY(ratio_high)},
	{BOTH("omega_rad_s"), "damped frequency (rad/s)", OF(omega), .si = rad_s},
	{BOTH("omega_low"), "lower end of its confidence interval", HAWSER__BY(omega_low),
	 .si = rad_s},
	{BOTH("omega_high"), "upper end", HAWSER__BY(omega_high), .si = rad_s},
	{BOTH("log_decrement_ratio"), "damping ratio from the logarithmic decrement",
	 OF(log_decrement)},
	{BOTH("amplitude"), "initial amplitude of the fit, in the unit of the series", OF(amplitude)},
	{BOTH("offset"), "offset of the fit", OF(offset)},
	{BOTH("noise"), "standard deviation of the series from the fit", OF(noise)},
	{BOTH("extremes"), "number of extremes of the series", HAWSER__BY(extremes)},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct hawser_half_power, member)
static const struct hawser__field half_field[] = {
	{BOTH("ratio"), "damping ratio", OF(ratio)},
	{BOTH("peak_rad_s"), "frequency of the peak (rad/s)", OF(peak), .si = rad_s},
	{BOTH("low_rad_s"), "lower half-power frequency (rad/s)", OF(low), .si = rad_s},
	{BOTH("high_rad_s"), "upper half-power frequency (rad/s)", OF(high), .si = rad_s},
	{BOTH("ratio_low"), "lower end of the interval of ratio", HAWSER__BY(half_low)},
	{BOTH("ratio_high"), "upper end", HAWSER__BY(half_high)},
	{BOTH("peak_low"), "lower end of the interval of the peak's frequency", HAWSER__BY(peak_low),
	 .si = rad_s},
	{BOTH("peak_high"), "upper end", HAWSER__BY(peak_high), .si = rad_s},
	{BOTH("modes"), "2: two close modes; ratio is the mean of both, and peak and half-power "
	 "frequencies are those of their sum", OF(modes)},
	{BOTH("noise"), "random scatter of the points relative to the peak, or 0. With modes 1 the "
	 "interval leaves out two modes of different ratios that it hides", OF(noise)},
	{BOTH("pair_error"), "the error of ratio that contains the ratios of two modes that the points may "
	 "hide, the weaker part a tenth of the other or more", OF(pair_error)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list
	decay_list = HAWSER__ROWS_WITHIN(struct result, decay, rows, decay_field),
	half_list = HAWSER__ROWS_WITHIN(struct result, half, rows, half_field);

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field result_field[] = {
	{"samples", NULL, "rows of the input", OF(series.count)},
	{"x", NULL, "name of the column of times or frequencies", OF(series.x_name)},
	{"y", NULL, "name of the column of displacements or amplitudes", OF(series.y_name)},
	{"", NULL, "", HAWSER__PART_OF(struct result, decay, decay_field), .when = DECAY,
	 .flags = HAWSER__BRIEF},
	{"", NULL, "", HAWSER__PART_OF(struct result, half, half_field), .when = HALF_POWER,
	 .flags = HAWSER__BRIEF},
	HAWSER__END,
};
#undef OF
const struct cli_listing cli_damping_listing[] = {
	{"Columns of the table, keys of JSON:", decay_field, 0},
	{"Columns and keys with --half-power:", half_field, 0},
	{"Further keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;
	int half = result->settings->half_power;

	return cli_si_head(&result->settings->common, "damping", half ? "half-power points"
	                   : "least squares of a free decay", NULL, half ? HALF_POWER : DECAY);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	struct hawser__view view = cli_si_view(0);

	hawser__table_comment(table, "%d samples of %s over %s", result->series.count,
	                      result->series.y_name, result->series.x_name);
	hawser__fields_table(table, result->settings->half_power ? &half_list : &decay_list, result,
	                     &view);
}
static const struct cli_showing showing = {.head = head, .more = rows, .fields = result_field};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result result = {.settings = settings, .rows = 1};
	struct cli_series *series = &result.series;
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	if (!status && settings->common.plot)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping", "damping has no picture");
	if (!status && settings->common.sets)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "damping",
		                      "--set is for scenes; damping reads a table");
	if (!status)
		status = cli_series_read(series, settings->common.input, settings->x, settings->y, report);
	if (!status)
		status = settings->half_power
		         ? hawser_half_power_find(result.half, series->x, series->y, series->count,
		                                  settings->confidence, report)
		         : hawser_decay_fit(result.decay, series->x, series->y, series->count,
		                            settings->confidence, report);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	cli_series_clear(series);
	return status;
}

const struct cli_command cli_damping = {
	"damping", "FILE", "Damping ratios from measured decays and responses", notes, options,
	        &defaults,
	sizeof(struct settings), 1, run, cli_damping_listing,
	.takes = 0,
};

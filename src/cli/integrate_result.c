/* cli/integrate_result.c - a time response as a table and as JSON.
 *
 * What is shown are signals: displacement components at the probes or, where a model has none, its
 * coordinates; in SI where the model has units. Spectra are those of the run's second half, so that
 * the start weighs less.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

enum { fewest_rows = 16 };

static const char axis[] = "xyz";

static const char *unit(const struct cli_integrate_result *result, const char *name)
{
	return result->model->rom.scaled ? name : "";
}

static size_t rows_of(const struct cli_integrate_result *result)
{
	return (size_t)result->run->rows;
}

void cli_signal_name(char name[CLI_NAME_SIZE], const struct cli_integrate_result *result, int k)
{
	if (result->probed)
		snprintf(name, CLI_NAME_SIZE, "%c_%s", axis[k % 3], result->model->rom.shapes.name[k/3]);
	else
		snprintf(name, CLI_NAME_SIZE, "u_%d", k + 1);
}

static void fill_row(struct cli_integrate_result *result, size_t row)
{
	const struct hawser_rom *rom = &result->model->rom;
	const double *u = result->run->state + row*2*(size_t)rom->n, *v = u + rom->n;
	double length = cli_per_length(result->model), rate = length*cli_per_omega(result->model);
	double here[3], speed[3];
	int k, p;

	for (k = 0; k < result->signals; k++) {
		if (result->probed && k % 3 == 0) {
			hawser_rom_displacement(rom, here, k/3, u);
			hawser_rom_displacement(rom, speed, k/3, v);
		}
		result->value[(size_t)k*rows_of(result) + row] =
			length*(result->probed ? here[k % 3] : u[k]);
		result->rate[(size_t)k*rows_of(result) + row] =
			rate*(result->probed ? speed[k % 3] : v[k]);
	}
	for (p = 0; result->tension && p < rom->shapes.points; p++)
		result->tension[(size_t)p*rows_of(result) + row] = hawser_rom_tension(rom, p, u);
}

/* Rows of the second half, at equal intervals: the last one may be an odd one out. */
static int spectrum_rows(const struct cli_integrate_result *result, int *first)
{
	const double *time = result->run->time;
	int rows = result->run->rows;

	while (rows > 1 && fabs(time[rows - 1] - time[rows - 2] - result->every) > 1e-6*result->every)
		rows--;
	*first = rows/2;
	return rows - *first;
}

static enum hawser_status spectra(struct cli_integrate_result *result,
                                  struct hawser_report *report)
{
	int first, rows = spectrum_rows(result, &first), bins = rows/2 + 1, k;
	double dt = result->every/cli_per_omega(result->model);
	enum hawser_status status = HAWSER_OK;

	if (rows < fewest_rows)
		return !result->spectrum ? HAWSER_OK
		       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "a spectrum needs %d rows or more in the second half of the run, "
		                      "which has %d", fewest_rows, rows);
	result->frequency = calloc((size_t)bins, sizeof *result->frequency);
	result->amplitude = calloc((size_t)bins*(size_t)result->signals, sizeof *result->amplitude);
	if (!result->frequency || !result->amplitude)
		return hawser__no_memory(report, "integrate");
	for (k = 0; k < result->signals && !status; k++)
		status = hawser_spectrum(result->frequency, result->amplitude + (size_t)k*(size_t)bins,
		                         &result->bins,
		                         result->value + (size_t)k*rows_of(result) + first, rows, dt,
		                         report);
	return status;
}

static void fill_extremes(struct cli_integrate_result *result, int row)
{
	const struct hawser_rom *rom = &result->model->rom;
	double least, most;

	if (!rom->scaled || !hawser_rom_tensions(rom, &least, &most,
	                                         result->run->state + (size_t)row*2*(size_t)rom->n))
		return;
	if (!(least >= result->least))
		result->least_at = row;
	result->least = fmin(result->least, least);
	result->most = fmax(result->most, most);
}

int cli_integrate_slack(char *text, size_t size, const struct cli_integrate_result *result)
{
	double missing = cli_speeding_tension(result->model, result->omega);

	if (result->least >= 0.0 && result->least - missing < 0.0) {
		snprintf(text, size, "slack: of the tension, %.4g N at least in the model, the change of speed "
		         "takes up to %.4g N more, which the model has not: model.energy: exact has it",
		         result->least, missing);
		return 1;
	}
	if (!(result->least < 0.0))
		return 0;
	snprintf(text, size, "slack: the model's tension falls to %.4g N at t = %.9g s; a cable bears no "
	         "compression, so what follows is not the motion of a cable", result->least,
	         result->run->time[result->least_at]/cli_per_omega(result->model));
	return 1;
}

enum hawser_status cli_integrate_fill(struct cli_integrate_result *result,
                                      struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	size_t rows = rows_of(result), row;

	result->probed = rom->shapes.points > 0;
	result->signals = result->probed ? 3*rom->shapes.points : rom->n;
	result->value = calloc((size_t)result->signals*rows + 1, sizeof *result->value);
	result->rate = calloc((size_t)result->signals*rows + 1, sizeof *result->rate);
	if (!result->value || !result->rate)
		return hawser__no_memory(report, "integrate");
	if (result->probed && rom->scaled && rom->shapes.EA > 0.0) {
		result->tension = calloc((size_t)rom->shapes.points*rows + 1, sizeof *result->tension);
		if (!result->tension)
			return hawser__no_memory(report, "integrate");
	}
	result->least = result->most = NAN;
	for (row = 0; row < rows; row++) {
		fill_row(result, row);
		fill_extremes(result, (int)row);
	}
	if (result->spectrum || result->common->plot)
		return spectra(result, report);
	return HAWSER_OK;
}

void cli_integrate_free(struct cli_integrate_result *result)
{
	free(result->value);
	free(result->rate);
	free(result->tension);
	free(result->frequency);
	free(result->amplitude);
}

static const char *end_of(const struct cli_integrate_result *result)
{
	return result->failed ? "failed" : result->run->interrupted ? "interrupted" : "complete";
}

/* --- table --- */

static void history_columns(struct hawser__table *table, const struct cli_integrate_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;
	char name[CLI_NAME_SIZE];
	int k;

	hawser__table_column(table, "t%s", unit(result, "_s"));
	for (k = 0; k < result->signals && result->probed; k++) {
		cli_signal_name(name, result, k);
		hawser__table_column(table, "%s%s", name, unit(result, "_m"));
	}
	for (k = 0; k < result->signals && result->probed; k++) {
		cli_signal_name(name, result, k);
		hawser__table_column(table, "v%s%s", name, unit(result, "_m_s"));
	}
	for (k = 0; k < rom->shapes.points && result->tension; k++)
		hawser__table_column(table, "T_%s_N", rom->shapes.name[k]);
	for (k = 0; k < rom->n; k++)
		hawser__table_column(table, "u_%d%s", k + 1, unit(result, "_m"));
	for (k = 0; k < rom->n; k++)
		hawser__table_column(table, "v_%d%s", k + 1, unit(result, "_m_s"));
	hawser__table_column(table, "energy%s", unit(result, "_J"));
}

static double joule(const struct cli_integrate_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;

	return rom->scaled ? rom->force*rom->length : 1.0;
}

static void history_row(struct hawser__table *table, const struct cli_integrate_result *result,
                        size_t row)
{
	const struct hawser_rom *rom = &result->model->rom;
	const double *state = result->run->state + row*2*(size_t)rom->n;
	double length = cli_per_length(result->model), rate = length*cli_per_omega(result->model);
	int k;

	hawser__table_number(table, result->run->time[row]/cli_per_omega(result->model));
	for (k = 0; k < result->signals && result->probed; k++)
		hawser__table_number(table, result->value[(size_t)k*rows_of(result) + row]);
	for (k = 0; k < result->signals && result->probed; k++)
		hawser__table_number(table, result->rate[(size_t)k*rows_of(result) + row]);
	for (k = 0; k < rom->shapes.points && result->tension; k++)
		hawser__table_number(table, result->tension[(size_t)k*rows_of(result) + row]);
	for (k = 0; k < 2*rom->n; k++)
		hawser__table_number(table, state[k]*(k < rom->n ? length : rate));
	hawser__table_number(table, result->run->energy[row]*joule(result));
}

static void spectrum_rows_out(struct hawser__table *table,
                              const struct cli_integrate_result *result)
{
	char name[CLI_NAME_SIZE];
	int i, k;

	hawser__table_column(table, "frequency%s", unit(result, "_Hz"));
	for (k = 0; k < result->signals; k++) {
		cli_signal_name(name, result, k);
		hawser__table_column(table, "%s%s", name, unit(result, "_m"));
	}
	for (i = 0; i < result->bins; i++) {
		hawser__table_number(table, result->frequency[i]);
		for (k = 0; k < result->signals; k++)
			hawser__table_number(table, result->amplitude[(size_t)k*(size_t)result->bins +
			                                              (size_t)i]);
	}
}

void cli_integrate_table(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct hawser_trajectory *run = result->run;
	double per_omega = cli_per_omega(result->model);
	char text[CLI_WARNING_SIZE];
	size_t row;

	cli_echo_table(table, result->common, "integrate",
	               result->model->has_scene ? &result->model->scene : NULL, run->method);
	cli_choice_comments(table, result->model);
	if (result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega*per_omega,
		                      unit(result, " rad/s"));
	hawser__table_comment(table, "period T = %.12g%s, output every %.12g%s",
	                      result->period/per_omega, unit(result, " s"), result->every/per_omega,
	                      unit(result, " s"));
	hawser__table_comment(table, "%ld steps, %ld evaluations, %ld Jacobians", run->steps,
	                      run->evaluations, run->jacobians);
	if (isfinite(result->least))
		hawser__table_comment(table, "tension anywhere on the cable: %.6g to %.6g N", result->least,
		                      result->most);
	cli_speeding_comment(table, result->model, result->omega);
	if (cli_integrate_slack(text, sizeof text, result))
		hawser__table_comment(table, "warning: %s", text);
	hawser__table_comment(table, "end: %s", end_of(result));
	if (result->spectrum) {
		hawser__table_comment(table, "amplitude spectrum of the second half, Hann window");
		spectrum_rows_out(table, result);
		return;
	}
	history_columns(table, result);
	for (row = 0; row < rows_of(result); row++)
		history_row(table, result, row);
}

/* --- JSON --- */

static void probes_json(struct hawser__json *json, const struct cli_integrate_result *result)
{
	json_t *probes = hawser__json_object(json, json->root, "probes"), *probe = NULL;
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	int rows = result->run->rows, k;
	const char rate[3][3] = {"vx", "vy", "vz"}, value[3][2] = {"x", "y", "z"};

	for (k = 0; k < result->signals && result->probed; k++) {
		size_t start = (size_t)k*rows_of(result);

		if (k % 3 == 0)
			probe = hawser__json_object(json, probes, shapes->name[k/3]);
		hawser__json_numbers(json, probe, value[k % 3], result->value + start, rows, 1.0);
		hawser__json_numbers(json, probe, rate[k % 3], result->rate + start, rows, 1.0);
		if (k % 3 == 2 && result->tension)
			hawser__json_numbers(json, probe, "T",
			                     result->tension + (size_t)(k/3)*rows_of(result), rows, 1.0);
	}
}

static void states_json(struct hawser__json *json, const struct cli_integrate_result *result)
{
	double length = cli_per_length(result->model), rate = length*cli_per_omega(result->model);
	json_t *states = hawser__json_array(json, json->root, "states"), *state;
	int n = result->model->rom.n, i, k;

	for (i = 0; i < result->run->rows; i++) {
		const double *row = result->run->state + (size_t)i*2*(size_t)n;

		state = hawser__json_array(json, states, NULL);
		for (k = 0; k < 2*n; k++)
			hawser__json_number(json, state, NULL, row[k]*(k < n ? length : rate));
	}
}

static void spectrum_json(struct hawser__json *json, const struct cli_integrate_result *result)
{
	json_t *spectrum = hawser__json_object(json, json->root, "spectrum");
	char name[CLI_NAME_SIZE];
	int k;

	hawser__json_numbers(json, spectrum, "frequency", result->frequency, result->bins, 1.0);
	for (k = 0; k < result->signals; k++) {
		cli_signal_name(name, result, k);
		hawser__json_numbers(json, spectrum, name,
		                     result->amplitude + (size_t)k*(size_t)result->bins, result->bins,
		                     1.0);
	}
}

void cli_integrate_json(struct hawser__json *json, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct hawser_trajectory *run = result->run;
	double per_omega = cli_per_omega(result->model);
	char text[CLI_WARNING_SIZE];
	json_t *stats;

	cli_echo_json(json, result->common, "integrate",
	              result->model->has_scene ? &result->model->scene : NULL);
	hawser__json_flag(json, json->root, "si", result->model->rom.scaled);
	cli_choice_json(json, result->model);
	hawser__json_text(json, json->root, "method", run->method);
	hawser__json_number(json, json->root, "Omega", result->omega*per_omega);
	hawser__json_text(json, json->root, "end", end_of(result));
	hawser__json_numbers(json, json->root, "times", run->time, run->rows, 1.0/per_omega);
	states_json(json, result);
	probes_json(json, result);
	hawser__json_numbers(json, json->root, "energy", run->energy, run->rows, joule(result));
	if (isfinite(result->least))
		cli_tension_json(json, json->root, result->least, result->most);
	if (cli_speeding_tension(result->model, result->omega) > 0.0)
		hawser__json_number(json, json->root, "tension_of_speeding",
		                    cli_speeding_tension(result->model, result->omega));
	cli_warnings_json(json, cli_integrate_slack(text, sizeof text, result) ? text : NULL);
	if (result->spectrum)
		spectrum_json(json, result);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "steps", run->steps);
	hawser__json_integer(json, stats, "evaluations", run->evaluations);
	hawser__json_integer(json, stats, "jacobians", run->jacobians);
}

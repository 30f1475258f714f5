/* cli/integrate_result.c - a time response as a table and as JSON.
 *
 * What is shown are signals: displacement components at the probes or, where a model has none, its
 * coordinates; in SI where the model has units. Spectra are those of whole periods in the run's second
 * half, so that the start weighs less.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/integrate_result.h"
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

static const double *state_at(const struct cli_integrate_result *result, size_t row)
{
	return result->run->state + row*2*(size_t)result->model->rom.n;
}

static struct hawser_rom_moment moment_at(const struct cli_integrate_result *result, size_t row)
{
	double t = result->run->time[row];

	return (struct hawser_rom_moment){.tau = result->omega*t, .omega = result->omega, .time = t};
}

/* Signal k in that row; rate: its derivative by time. */
static double signal_of(const struct cli_integrate_result *result, int k, size_t row, int rate)
{
	const struct hawser_rom *rom = &result->model->rom;
	const double *u = state_at(result, row), *v = u + rom->n;
	double length = cli_per_length(result->model), here[3];
	double factor = rate ? length*cli_per_omega(result->model) : length;
	struct hawser_rom_moment moment = moment_at(result, row);

	if (!result->probed)
		return factor*(rate ? v : u)[k];
	if (rate)
		hawser_rom_velocity_at(rom, here, k/3, u, v, &moment);
	else
		hawser_rom_displacement_at(rom, here, k/3, u, &moment);
	return factor*here[k % 3];
}

static double tension_of(const struct cli_integrate_result *result, int p, size_t row)
{
	struct hawser_rom_moment moment = moment_at(result, row);

	return hawser_rom_tension_at(&result->model->rom, p, state_at(result, row), &moment);
}

static void fill_row(struct cli_integrate_result *result, size_t row)
{
	for (int k = 0; k < result->signals; k++) {
		result->value[(size_t)k*rows_of(result) + row] = signal_of(result, k, row, 0);
		result->rate[(size_t)k*rows_of(result) + row] = signal_of(result, k, row, 1);
	}
}

/* The rows at equal intervals: the last interval may be shorter. */
static int equidistant(const struct cli_integrate_result *result)
{
	const double *time = result->run->time;
	int rows = result->run->rows;

	while (rows > 1 && fabs(time[rows - 1] - time[rows - 2] - result->every) > 1e-6*result->every)
		rows--;
	return rows;
}

static enum hawser_status spectra(struct cli_integrate_result *result,
                                  struct hawser_report *report)
{
	int all = equidistant(result), half = all - all/2, rows, bins, k;
	double dt = result->every/cli_per_omega(result->model);
	enum hawser_status status = HAWSER_OK;

	if (half < fewest_rows)
		return !result->spectrum ? HAWSER_OK
		       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "a spectrum needs %d rows or more in the second half of the run, "
		                      "which has %d", fewest_rows, half);
	result->window = hawser_spectrum_window(half, result->period/result->every);
	rows = result->window.rows;
	bins = rows/2 + 1;
	result->frequency = calloc((size_t)bins, sizeof *result->frequency);
	result->amplitude = calloc((size_t)bins*(size_t)result->signals, sizeof *result->amplitude);
	if (!result->frequency || !result->amplitude)
		return hawser__no_memory(report, "integrate");
	for (k = 0; k < result->signals && !status; k++)
		status = hawser_spectrum(result->frequency, result->amplitude + (size_t)k*(size_t)bins,
		                         &result->bins,
		                         result->value + (size_t)k*rows_of(result) + (all - rows),
		                         rows, dt, report);
	return status;
}

static void fill_extremes(struct cli_integrate_result *result, int row)
{
	const struct hawser_rom *rom = &result->model->rom;
	struct hawser_rom_moment moment = moment_at(result, (size_t)row);
	double least, most;

	if (!rom->scaled || !hawser_rom_tensions_at(rom, &least, &most, state_at(result, (size_t)row),
	                                            &moment))
		return;
	if (!(least >= result->least))
		result->least_at = row;
	result->least = fmin(result->least, least);
	result->most = fmax(result->most, most);
}

int cli_integrate_slack(char *text, size_t size, const struct cli_integrate_result *result)
{
	if (result->surges)
		return cli_surge_warning(text, size, result);
	if (result->least < 0.0) {
		snprintf(text, size, "slack: the model's tension falls to %.4g N at t = %.9g s; a cable bears "
		         "no compression, so what follows is not the motion of a cable", result->least,
		         result->run->time[result->least_at]/cli_per_omega(result->model));
		return 1;
	}
	return 0;
}

enum hawser_status cli_integrate_fill(struct cli_integrate_result *result,
                                      struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	size_t rows = rows_of(result), row;
	enum hawser_status status;

	result->probed = rom->shapes.points > 0;
	result->signals = result->probed ? 3*rom->shapes.points : rom->n;
	result->tensions = result->probed && rom->scaled && rom->shapes.EA > 0.0;
	result->least = result->most = NAN;
	for (row = 0; row < rows; row++)
		fill_extremes(result, (int)row);
	status = cli_surge_look(result, report);
	if (status)
		return status;
	if (!result->spectrum && !result->common->plot)
		return HAWSER_OK;
	result->value = calloc((size_t)result->signals*rows + 1, sizeof *result->value);
	result->rate = calloc((size_t)result->signals*rows + 1, sizeof *result->rate);
	if (!result->value || !result->rate)
		return hawser__no_memory(report, "integrate");
	for (row = 0; row < rows; row++)
		fill_row(result, row);
	return spectra(result, report);
}

void cli_integrate_free(struct cli_integrate_result *result)
{
	free(result->error);
	free(result->value);
	free(result->rate);
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
	for (k = 0; k < rom->shapes.points && result->tensions; k++)
		hawser__table_column(table, "T_%s_N", rom->shapes.name[k]);
	for (k = 0; k < rom->n; k++)
		hawser__table_column(table, "u_%d%s", k + 1, unit(result, "_m"));
	for (k = 0; k < rom->n; k++)
		hawser__table_column(table, "v_%d%s", k + 1, unit(result, "_m_s"));
	hawser__table_column(table, "energy%s", unit(result, "_J"));
	if (result->error)
		hawser__table_column(table, "error");
}

static double joule(const struct cli_integrate_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;

	return rom->scaled ? rom->force*rom->length : 1.0;
}

static void history_row(struct hawser__table *table, const void *context, size_t row)
{
	const struct cli_integrate_result *result = context;
	const struct hawser_rom *rom = &result->model->rom;
	const double *state = state_at(result, row);
	double length = cli_per_length(result->model), rate = length*cli_per_omega(result->model);
	int k;

	hawser__table_number(table, result->run->time[row]/cli_per_omega(result->model));
	for (k = 0; k < result->signals && result->probed; k++)
		hawser__table_number(table, signal_of(result, k, row, 0));
	for (k = 0; k < result->signals && result->probed; k++)
		hawser__table_number(table, signal_of(result, k, row, 1));
	for (k = 0; k < rom->shapes.points && result->tensions; k++)
		hawser__table_number(table, tension_of(result, k, row));
	for (k = 0; k < 2*rom->n; k++)
		hawser__table_number(table, state[k]*(k < rom->n ? length : rate));
	hawser__table_number(table, result->run->energy[row]*joule(result));
	if (result->error)
		hawser__table_number(table, result->error[row]);
}

/* Which rows the spectrum is of, and what it shows too low. With one period the removal of the mean
 * takes part of the first bin. */
static void window_comments(struct hawser__table *table, const struct cli_integrate_result *result)
{
	const struct hawser_spectrum_window *window = &result->window;
	const char *what = result->omega > 0.0 ? "the forcing" : "the first natural frequency";
	const struct hawser_rom *rom = &result->model->rom;
	int k = 0;

	for (int h = 0; h < rom->harmonics; h++)
		k = rom->harmonic[h].k > k ? rom->harmonic[h].k : k;

	hawser__table_comment(table, "amplitude spectrum of the last %d rows at equal intervals, %.9g "
	                      "periods; Hann window", window->rows, window->periods);
	if (window->periods < 1.5)
		hawser__table_comment(table, "the spectrum has fewer than two periods: amplitudes are not "
		                      "resolved; give a later --until");
	else if (window->off != 0.0)
		hawser__table_comment(table, "%s is on no bin, %.2g bins from the nearest, where its "
		                      "amplitude is shown %.1e (relative) too low: give an --every of "
		                      "which a whole number makes a period", what, fabs(window->off),
		                      window->loss);
	if (2.0*k*result->every > result->period)
		hawser__table_comment(table, "harmonic %d of the forcing is above the highest frequency of the "
		                      "spectrum, and shown at a lower one (aliasing): give an --every below "
		                      "%.4gT", k, 0.5/k);
}

static void spectrum_rows(struct hawser__table *table, const struct cli_integrate_result *result)
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

/* Of a run in time no error of the model is known: its motion settles only at the end, if at all. */
static const char *unknown_error(const struct cli_integrate_result *result)
{
	const struct cli_model *model = result->model;

	return !model->has_scene || model->automatic || model->rom.exact
	       ? NULL : "this run tells nothing of the modes left out; hawser frf, over a range about the "
	                "frequency, states how far its periodic motions are off";
}

void cli_integrate_table(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct hawser_trajectory *run = result->run;
	double per_omega = cli_per_omega(result->model);
	char text[CLI_WARNING_SIZE];

	cli_echo_table(table, result->common, "integrate",
	               result->model->has_scene ? &result->model->scene : NULL, run->method);
	cli_choice_comments(table, result->model);
	if (unknown_error(result))
		hawser__table_comment(table, "error of the model: not estimated: %s", unknown_error(result));
	if (result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega*per_omega,
		                      unit(result, " rad/s"));
	hawser__table_comment(table, "period T = %.12g%s, output every %.12g%s",
	                      result->period/per_omega, unit(result, " s"), result->every/per_omega,
	                      unit(result, " s"));
	hawser__table_comment(table, "%ld steps, %ld evaluations, %ld Jacobians", run->steps,
	                      run->evaluations, run->jacobians);
	if (result->error)
		hawser__table_comment(table, "largest estimated error of a state, over the largest state: "
		                             "%.1e", result->error[run->rows - 1]);
	if (isfinite(result->least))
		hawser__table_comment(table, "tension anywhere on the cable: %.6g to %.6g N", result->least,
		                      result->most);
	cli_surge_comments(table, result);
	if (cli_integrate_slack(text, sizeof text, result))
		hawser__table_comment(table, "warning: %s", text);
	hawser__table_comment(table, "end: %s", end_of(result));
	if (result->spectrum) {
		window_comments(table, result);
		spectrum_rows(table, result);
		return;
	}
	history_columns(table, result);
	hawser__table_rows(table, rows_of(result), history_row, result);
}

/* --- JSON --- */

/* Lists over the rows; `part` says which: of displacements, velocities, tensions the index. */
enum history_list {
	VALUES = 0, RATES = 1000000, TENSIONS = 2000000, TIMES = 3000000, STATES, ENERGIES
};

static void state_json(struct hawser__json *json, json_t *list,
                       const struct cli_integrate_result *result, size_t row)
{
	double length = cli_per_length(result->model), rate = length*cli_per_omega(result->model);
	int n = result->model->rom.n;
	const double *x = result->run->state + row*2*(size_t)n;
	json_t *state = hawser__json_array(json, list, NULL);

	for (int k = 0; k < 2*n; k++)
		hawser__json_number(json, state, NULL, x[k]*(k < n ? length : rate));
}

static void history_json(struct hawser__json *json, json_t *list, const void *context, int part,
                         size_t row)
{
	const struct cli_integrate_result *result = context;
	double per_omega = cli_per_omega(result->model), number;

	if (part == STATES) {
		state_json(json, list, result, row);
		return;
	}
	if (part == TIMES)
		number = result->run->time[row]*(1.0/per_omega);
	else if (part == ENERGIES)
		number = result->run->energy[row]*joule(result);
	else if (part >= TENSIONS)
		number = tension_of(result, part - TENSIONS, row);
	else
		number = part >= RATES ? signal_of(result, part - RATES, row, 1)
		                       : signal_of(result, part - VALUES, row, 0);
	hawser__json_number(json, list, NULL, number);
}

static void list_json(struct hawser__json *json, json_t *into, const char *key,
                      const struct cli_integrate_result *result, int part)
{
	hawser__json_list(json, into, key, rows_of(result), history_json, result, part);
}

static void probes_json(struct hawser__json *json, const struct cli_integrate_result *result)
{
	json_t *probes = hawser__json_object(json, json->root, "probes"), *probe = NULL;
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	const char rate[3][3] = {"vx", "vy", "vz"}, value[3][2] = {"x", "y", "z"};

	for (int k = 0; k < result->signals && result->probed; k++) {
		if (k % 3 == 0)
			probe = hawser__json_object(json, probes, shapes->name[k/3]);
		list_json(json, probe, value[k % 3], result, VALUES + k);
		list_json(json, probe, rate[k % 3], result, RATES + k);
		if (k % 3 == 2 && result->tensions)
			list_json(json, probe, "T", result, TENSIONS + k/3);
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
	cli_choice_json(json, result->model, result->common);
	if (unknown_error(result)) {
		json_t *error = hawser__json_object(json, json->root, "model_error");

		hawser__json_null(json, error, "estimated");
		hawser__json_text(json, error, "reason", unknown_error(result));
	}
	hawser__json_text(json, json->root, "method", run->method);
	hawser__json_number(json, json->root, "Omega", result->omega*per_omega);
	hawser__json_text(json, json->root, "end", end_of(result));
	list_json(json, json->root, "times", result, TIMES);
	list_json(json, json->root, "states", result, STATES);
	probes_json(json, result);
	list_json(json, json->root, "energy", result, ENERGIES);
	if (result->error)
		hawser__json_numbers(json, json->root, "error", result->error, run->rows, 1.0);
	if (isfinite(result->least))
		cli_tension_json(json, json->root, result->least, result->most);
	cli_surge_json(json, result);
	cli_warnings_json(json, cli_integrate_slack(text, sizeof text, result) ? text : NULL);
	if (result->spectrum) {
		spectrum_json(json, result);
		hawser__json_number(json, json->root, "spectrum_periods", result->window.periods);
		hawser__json_number(json, json->root, "spectrum_loss", result->window.loss);
	}
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "steps", run->steps);
	hawser__json_integer(json, stats, "evaluations", run->evaluations);
	hawser__json_integer(json, stats, "jacobians", run->jacobians);
}

/* cli/integrate_result.c - a time response: what is computed from a run to be shown, comments, fields.
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
#include "cli/view.h"
#include "core/report.h"

enum { fewest_rows = 16 };

static const char axis[] = "xyz";

static const char *unit(const struct cli_integrate_result *result, const char *name)
{
	return result->model->rom.scaled ? name : "";
}

static size_t rows_of(const struct cli_integrate_result *result)
{
	return (size_t)result->run.rows;
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
	return result->run.state + row*2*(size_t)result->model->rom.n;
}

static struct hawser_rom_moment moment_at(const struct cli_integrate_result *result, size_t row)
{
	double t = result->run.time[row];

	return (struct hawser_rom_moment){.tau = result->omega*t, .omega = result->omega, .time = t};
}

/* Signal k in that row, scaled; rate: its derivative by time. */
static double signal_of(const struct cli_integrate_result *result, int k, size_t row, int rate)
{
	const struct hawser_rom *rom = &result->model->rom;
	const double *u = state_at(result, row), *v = u + rom->n;
	struct hawser_rom_moment moment = moment_at(result, row);
	double here[3];

	if (!result->probed)
		return (rate ? v : u)[k];
	if (rate)
		hawser_rom_velocity_at(rom, here, k/3, u, v, &moment);
	else
		hawser_rom_displacement_at(rom, here, k/3, u, &moment);
	return here[k % 3];
}

static double tension_of(const struct cli_integrate_result *result, int p, size_t row)
{
	struct hawser_rom_moment moment = moment_at(result, row);

	return hawser_rom_tension_at(&result->model->rom, p, state_at(result, row), &moment);
}

static void fill_row(struct cli_integrate_result *result, size_t row)
{
	struct hawser__scale scale = cli_scale(result->model);

	for (int k = 0; k < result->signals; k++) {
		size_t at = (size_t)k*rows_of(result) + row;

		result->value[at] = hawser__in_unit(signal_of(result, k, row, 0), HAWSER__M, &scale);
		result->rate[at] = hawser__in_unit(signal_of(result, k, row, 1), HAWSER__M_S, &scale);
	}
}

/* The rows at equal intervals: the last interval may be shorter. */
static int equidistant(const struct cli_integrate_result *result)
{
	const double *time = result->run.time;
	int rows = result->run.rows;

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
		         result->run.time[result->least_at]/cli_per_omega(result->model));
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
	hawser_trajectory_clear(&result->run);
}

static const char *end_of(const void *of)
{
	const struct cli_integrate_result *result = of;

	return result->failed ? "failed" : result->run.interrupted ? "interrupted" : "complete";
}

/* --- comments --- */

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

/* Of a run in time no error of the model is known: its motion settles only at the end, if at all. */
static const char *unknown_error(const void *of)
{
	const struct cli_model *model = ((const struct cli_integrate_result *)of)->model;

	return !model->has_scene || model->automatic || model->rom.exact
	       ? NULL : "this run tells nothing of the modes left out; hawser frf, over a range about the "
	                "frequency, states how far its periodic motions are off";
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct hawser_trajectory *run = &result->run;
	double per_omega = cli_per_omega(result->model);
	char text[CLI_WARNING_SIZE];

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
	if (result->spectrum)
		window_comments(table, result);
}

/* --- fields --- */

enum { PROBED = 1, TENSIONS = 2, ERROR = 4, SPECTRUM = 8, KNOWN = 16, SURGES = 32, UNKNOWN = 64 };

static double signal_at(const void *context, const void *parent, size_t row, int k)
{
	const struct cli_integrate_result *result = parent;

	(void)context;
	return signal_of(result, k % result->signals, row, k >= result->signals);
}

static double tension_at(const void *context, const void *parent, size_t row, int k)
{
	(void)context;
	return tension_of(parent, k, row);
}

static double amplitude_at(const void *context, const void *parent, size_t bin, int k)
{
	const struct cli_integrate_result *result = parent;

	(void)context;
	return result->amplitude[(size_t)k*(size_t)result->bins + bin];
}

static int signals(const void *context)
{
	return ((const struct cli_integrate_result *)context)->signals;
}

static int rates_too(const void *context)
{
	return 2*signals(context);
}

static int states(const void *context)
{
	return 2*((const struct cli_integrate_result *)context)->model->rom.n;
}

static int probes(const void *context)
{
	return signals(context)/3;
}

static void signal_name(char *text, size_t size, const void *context, int k)
{
	char name[CLI_NAME_SIZE];

	cli_signal_name(name, context, k % signals(context));
	snprintf(text, size, "%s%s", k < signals(context) ? "" : "v", name);
}

static void probe_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_integrate_result *result = context;

	snprintf(text, size, "%s", result->model->rom.shapes.name[k]);
}

static void state_name(char *text, size_t size, const void *context, int k)
{
	int n = states(context)/2;

	snprintf(text, size, "%c_%d", k < n ? 'u' : 'v', k % n + 1);
}
static const struct hawser__vector
	signal_vector = {.shown = "x_PROBE", .count = rates_too, .name = signal_name,
	                 .number = signal_at, .rate = HAWSER__M_S},
	tension_vector = {.shown = "PROBE", .count = probes, .name = probe_name, .number = tension_at},
	state_vector = {.shown = "u_J", .count = states, .name = state_name, .rate = HAWSER__M_S},
	amplitude_vector = {.shown = "x_PROBE", .count = signals, .name = signal_name,
	                    .number = amplitude_at, .object = 1};

#define OF(member) HAWSER__ALONG(struct cli_integrate_result, run.member)
#define STATES HAWSER__VECTOR_ALONG(struct cli_integrate_result, run.state, state_vector), \
	.unit = HAWSER__M
static const struct hawser__field history_field[] = {
	{"times", "t", "time", OF(time), .unit = HAWSER__S},
	{"states", NULL, "a list a time: coordinates, then velocities", STATES},
	{NULL, "", "displacement at a probe; vx_PROBE_m_s: its velocity",
	 HAWSER__VECTOR_OF(signal_vector), .unit = HAWSER__M, .when = PROBED},
	{NULL, "T_", "tension at a probe", HAWSER__VECTOR_OF(tension_vector), .unit = HAWSER__NEWTON,
	 .when = TENSIONS},
	{NULL, "", "coordinate; v_J_m_s: its velocity", STATES},
	{NULL, "energy", "of the model", OF(energy), .unit = HAWSER__J},
	{NULL, "error", "estimated error of the state, relative to the largest, with --error",
	 HAWSER__ALONG(struct cli_integrate_result, error), .when = ERROR},
	HAWSER__END,
};
static const struct hawser__field energy_field[] = {
	{"energy", NULL, "of the model", OF(energy), .unit = HAWSER__J},
	{"error", NULL, "estimated error of the state, relative to the largest, with --error",
	 HAWSER__ALONG(struct cli_integrate_result, error), .when = ERROR},
	HAWSER__END,
};
static const struct hawser__field spectrum_field[] = {
	{"frequency", "frequency", "of the bin", HAWSER__ALONG(struct cli_integrate_result, frequency),
	 .unit = HAWSER__HZ},
	{"SIGNAL", "", "amplitude of the displacement at a probe, or of a coordinate u_J",
	 HAWSER__VECTOR_OF(amplitude_vector), .unit = HAWSER__M_ALREADY},
	HAWSER__END,
};
#undef OF
#define ROWS(number, fields) \
	{.field = (fields), .count_at = offsetof(struct cli_integrate_result, number)}
static const struct hawser__list history_list = ROWS(run.rows, history_field),
                                 energy_list = ROWS(run.rows, energy_field),
                                 spectrum_list = ROWS(bins, spectrum_field);

static void choice_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_integrate_result *result = row;

	(void)into;
	cli_choice_json(json, result->model, result->common);
}

/* part: 3 components of each probe, 0 on, and the same of the rates; then tensions */
static void signal_json(struct hawser__json *json, json_t *list, const void *context, int part,
                        size_t row)
{
	const struct cli_integrate_result *result = context;
	struct hawser__scale scale = cli_scale(result->model);
	int k = part % result->signals, kind = part/result->signals;

	hawser__json_number(json, list, NULL, kind == 2 ? tension_of(result, k, row)
	                    : hawser__in_unit(signal_of(result, k, row, kind),
	                                      kind ? HAWSER__M_S : HAWSER__M, &scale));
}

static void probes_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_integrate_result *result = row;
	json_t *probes = hawser__json_object(json, into, "probes"), *probe = NULL;
	size_t rows = rows_of(result);
	int signals = result->signals;

	for (int k = 0; k < signals && result->probed; k++) {
		const char value[] = {axis[k % 3], '\0'}, rate[] = {'v', axis[k % 3], '\0'};

		if (k % 3 == 0)
			probe = hawser__json_object(json, probes, result->model->rom.shapes.name[k/3]);
		hawser__json_list(json, probe, value, rows, signal_json, result, k);
		hawser__json_list(json, probe, rate, rows, signal_json, result, signals + k);
		if (k % 3 == 2 && result->tensions)
			hawser__json_list(json, probe, "T", rows, signal_json, result, 2*signals + k/3);
	}
}

static void warnings_json(struct hawser__json *json, json_t *into, const void *row)
{
	char text[CLI_WARNING_SIZE];

	(void)into;
	cli_warnings_json(json, cli_integrate_slack(text, sizeof text, row) ? text : NULL);
}

#define OF(member) HAWSER__AT(struct cli_integrate_result, member)
static const struct hawser__field integrate_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_integrate_result, model, cli_si_field)},
	{"accuracy", NULL, "of chosen modes, see hawser-frf(1)", HAWSER__CALLS(choice_json)},
	{"model_error.estimated", NULL, "null: a run states no error of the model",
	 HAWSER__CONSTANT_IS(HAWSER__NO_INTEGER), .when = UNKNOWN},
	{"model_error.reason", NULL, "why", HAWSER__TEXT_BY(unknown_error), .when = UNKNOWN},
	{"method", NULL, "integrator", OF(run.method)},
	{"Omega", NULL, "forcing frequency; 0: none", OF(omega), .unit = HAWSER__RAD_S},
	{"end", NULL, "complete, interrupted or failed", HAWSER__TEXT_BY(end_of)},
	{"", NULL, "", HAWSER__ARRAYS_OF(history_list), .flags = HAWSER__STREAM},
	{"probes", NULL, "by name: lists x, y, z, vx, vy, vz, T", HAWSER__CALLS(probes_json)},
	{"", NULL, "", HAWSER__ARRAYS_OF(energy_list), .flags = HAWSER__STREAM},
	{"tension.min", NULL, "least tension anywhere on the cable, at the times of the output",
	 OF(least), .unit = HAWSER__NEWTON, .when = KNOWN},
	{"tension.max", NULL, "greatest", OF(most), .unit = HAWSER__NEWTON, .when = KNOWN},
	{"", NULL, "", HAWSER__PART_OF(struct cli_integrate_result, surge, cli_surge_field),
	 .when = SURGES},
	{"warnings", NULL, "of slack", HAWSER__CALLS(warnings_json)},
	{"spectrum", NULL, "with --spectrum", HAWSER__ARRAYS_OF(spectrum_list),
	 .when = SPECTRUM},
	{"spectrum_periods", NULL, "periods of which the spectrum is", OF(window.periods),
	 .when = SPECTRUM},
	{"spectrum_loss", NULL, "part of its amplitude that the forcing lacks on its bin",
	 OF(window.loss), .when = SPECTRUM},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"steps", NULL, "of the integrator", OF(run.steps)},
	{"evaluations", NULL, "of the equations", OF(run.evaluations)},
	{"jacobians", NULL, "of the equations", OF(run.jacobians)},
	HAWSER__END,
};
#undef OF
const struct cli_listing cli_integrate_listing[] = {
	{"Columns of the table:", history_field, 0},
	{"Columns with --spectrum:", spectrum_field, 0},
	{"Keys of JSON:", integrate_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_integrate_result *result = of;
	struct cli_head head = cli_model_head(
		result->common, "integrate", result->run.method, result->model,
		(result->probed ? PROBED : 0u) | (result->tensions ? TENSIONS : 0u) |
		(result->error ? ERROR : 0u) | (result->spectrum ? SPECTRUM : 0u) |
		(isfinite(result->least) ? KNOWN : 0u) | (result->surges ? SURGES : 0u) |
		(unknown_error(result) ? UNKNOWN : 0u));

	head.view.context = result;
	return head;
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	struct hawser__view view = head(of).view;

	hawser__fields_table(table, result->spectrum ? &spectrum_list : &history_list, result, &view);
}

const struct cli_showing cli_integrate_showing = {
	.head = head, .comments = comments, .more = rows, .fields = integrate_field,
	.stats = cost_field, .draw = cli_integrate_draw};

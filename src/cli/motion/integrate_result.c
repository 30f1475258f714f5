/* cli/motion/integrate_result.c - a time response: signals, spectra, extreme tensions, and comments.
 *
 * Signals are displacement components at the probes or, if a model has none, its coordinates; in SI if
 * the model has units. Spectra are computed from whole periods in the second half of the run, so that
 * the transient at the start is left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/motion/integrate_result.h"
#include "cli/model/state.h"
#include "core/report.h"

enum { fewest_rows = 16 };
/* Of the largest line, a folded line that is told: as pictures show, above what leaks. Chosen. */
static const double part_folded = 2e-4;

static const char axis[] = "xyz";

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
	return hawser_integrate_moment(&result->forcing, result->run.time[row]);
}

double cli_integrate_signal(const struct cli_integrate_result *result, int k, size_t row, int rate)
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

double cli_integrate_tension(const struct cli_integrate_result *result, int p, size_t row)
{
	struct hawser_rom_moment moment = moment_at(result, row);

	return hawser_rom_tension_at(&result->model->rom, p, state_at(result, row), &moment);
}

static void fill_row(struct cli_integrate_result *result, size_t row)
{
	struct hawser__scale scale = cli_scale(result->model);

	for (int k = 0; k < result->signals; k++) {
		size_t at = (size_t)k*rows_of(result) + row;

		result->value[at] = hawser__in_unit(cli_integrate_signal(result, k, row, 0), HAWSER__M,
		                                    &scale);
		result->rate[at] = hawser__in_unit(cli_integrate_signal(result, k, row, 1), HAWSER__M_S,
		                                   &scale);
	}
}

/* Number of rows at equal intervals: the last interval may be shorter. */
static int equidistant(const struct cli_integrate_result *result)
{
	const double *time = result->run.time;
	int rows = result->run.rows;

	while (rows > 1 && fabs(time[rows - 1] - time[rows - 2] - result->every) > 1e-6*result->every)
		rows--;
	return rows;
}

/* Look for lines of signal k above its spectrum, whose samples begin at row `first`. */
static enum hawser_status fold(struct cli_integrate_result *result, int k, int first, double dt,
                               struct hawser_report *report)
{
	const double *amplitude = result->amplitude + (size_t)k*(size_t)result->bins;
	size_t at = (size_t)k*rows_of(result) + (size_t)first;
	double folded, frequency, peak = 0.0;
	enum hawser_status status = hawser_spectrum_folded(&folded, &frequency, result->value + at,
	                                                   result->rate + at, result->window.rows, dt,
	                                                   report);

	for (int i = 1; i < result->bins; i++)
		peak = fmax(peak, amplitude[i]);
	if (!status && folded > part_folded*peak && folded > result->folded[1]) {
		result->folded[0] = frequency;
		result->folded[1] = folded;
		result->folds = k;
	}
	return status;
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
	for (k = 0; k < result->signals && !status; k++) {
		status = hawser_spectrum(result->frequency, result->amplitude + (size_t)k*(size_t)bins,
		                         &result->bins,
		                         result->value + (size_t)k*rows_of(result) + (all - rows),
		                         rows, dt, report);
		if (!status)
			status = fold(result, k, all - rows, dt, report);
	}
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

int cli_integrate_moves(char *text, size_t size, const struct cli_integrate_result *result)
{
	return result->rest &&
	       cli_motion_warning(text, size, result->model, result->forcing.begin);
}

/* Part of wind.speed at which a probe moves and from which the force to the third order is off by 1 %
 * (doc/theory-rom.md). */
#define FAST 0.25

int cli_integrate_wind(char *text, size_t size, const struct cli_integrate_result *result)
{
	const struct cli_model *model = result->model;
	const struct hawser_wind *wind = &model->scene.wind;
	struct hawser__scale scale = cli_scale(model);
	double most = 0.0;

	if (!model->has_scene || !wind->present || !result->probed)
		return 0;
	for (size_t row = 0; row < rows_of(result); row++)
		for (int k = 0; k < result->signals; k++)
			most = fmax(most, fabs(cli_integrate_signal(result, k, row, 1)));
	most = hawser__in_unit(most, HAWSER__M_S, &scale);
	if (most == 0.0 && model->rom.harmonics == 0)
		snprintf(text, size, "nothing moves: at rest the wind is in equilibrium with the cable, stable "
		         "or not; give a state to start from (--initial), such as {\"u\": [0.01, ...]} "
		         "for %d coordinates", model->rom.n);
	else if (!model->rom.drag && !wind->wake.present && most > FAST*wind->speed)
		snprintf(text, size, "the cable moves at %.3g m/s, %.2g of wind.speed, where the force of the "
		         "wind to the third order (wind.form: cubic) is off by more than 1 %%: "
		         "--set wind.form=exact has the whole force", most, most/wind->speed);
	else
		return 0;
	return 1;
}

/* --- the error of the model --- */

/* Why no period of the run stands for it, or NULL. */
static const char *irregular(const struct cli_integrate_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;

	if (result->failed || result->run.interrupted)
		return "the run did not come to its end";
	if (!(result->omega > 0.0) && rom->history)
		return "no period of the run stands for it; compare with a run of more modes (-n)";
	if (!(result->omega > 0.0))
		return "nothing drives the model; compare with a run of more modes (-n)";
	if (rom->history || rom->ramp || result->forcing.omega_to > 0.0)
		return "no period of a run with a changing excitation stands for the others; hawser frf, over "
		       "a range about a frequency, states how far periodic motions are off";
	if (result->orbit && result->orbit->period > 1)
		return "that of motions of several periods is not";
	return NULL;
}

enum hawser_status cli_integrate_judge(struct cli_integrate_result *result,
                                       struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	const char *why = irregular(result);
	int last = result->run.rows - 1;
	struct hawser_accuracy_motion motion = {.omega = result->omega};

	if ((!model->has_scene && !model->made) || model->automatic || model->rom.exact || last < 0 ||
	    result->model_error.stated)
		return HAWSER_OK;
	motion.time = result->run.time[last];
	motion.state = result->run.state + 2*(size_t)last*(size_t)model->rom.n;
	if (!why)
		return cli_fixed_once(&result->model_error, model, result->common, &motion, report);
	result->model_error = (struct cli_model_error){.stated = 1, .fixed = {.estimated = NAN}};
	snprintf(result->model_error.unknown, sizeof result->model_error.unknown, "%s", why);
	return HAWSER_OK;
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
	if (!status)
		status = cli_integrate_judge(result, report);
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
	hawser_lyapunov_clear(&result->lyapunov);
	hawser_trajectory_clear(&result->run);
}

const char *cli_integrate_end(const void *of)
{
	const struct cli_integrate_result *result = of;

	return result->failed ? "failed" : result->run.interrupted ? "interrupted" : "complete";
}

/* --- comments --- */

/* The rows of the spectrum, and amplitudes that are too low in it. With one period the removal of the
 * mean reduces the first bin. */
static void window_comments(struct hawser__table *table, const struct cli_integrate_result *result)
{
	const struct hawser_spectrum_window *window = &result->window;
	const char *what = result->omega > 0.0 ? "the forcing" : "the first natural frequency";
	const double *folded = result->folded;
	char name[CLI_NAME_SIZE];

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
	if (folded[1] > 0.0) {
		cli_signal_name(name, result, result->folds);
		hawser__table_comment(table, "the line of %.2g%s at %.6g%s in %s is one of a frequency "
		                      "above the highest of the spectrum, folded down (aliasing; %.6g%s, "
		                      "if folded once): give a smaller --every", folded[1],
		                      cli_unit(result->model, " m"), folded[0],
		                      cli_unit(result->model, " Hz"), name,
		                      cli_per_omega(result->model)/result->every - folded[0],
		                      cli_unit(result->model, " Hz"));
	}
}

void cli_integrate_comments(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct hawser_trajectory *run = &result->run;
	double per_omega = cli_per_omega(result->model);
	char text[CLI_WARNING_SIZE];

	cli_choice_comments(table, result->model);
	cli_drag_comment(table, result->model, "at every instant");
	cli_exact_comment(table, result->model);
	cli_fixed_comments(table, &result->model_error, 0);
	if (result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega*per_omega,
		                      cli_unit(result->model, " rad/s"));
	if (result->forcing.omega_to > 0.0)
		hawser__table_comment(table, "Omega changes linearly to %.12g%s",
		                      result->forcing.omega_to*per_omega,
		                      cli_unit(result->model, " rad/s"));
	hawser__table_comment(table, "period T = %.12g%s, output every %.12g%s",
	                      result->period/per_omega, cli_unit(result->model, " s"),
	                      result->every/per_omega,
	                      cli_unit(result->model, " s"));
	hawser__table_comment(table, "%ld steps, %ld evaluations, %ld Jacobians", run->steps,
	                      run->evaluations, run->jacobians);
	if (result->lyapunov.averaged > 0)
		hawser__table_comment(table, "largest Lyapunov exponent %.9g +- %.1e%s, from %ld periods",
		                      result->lyapunov.exponent[0]*per_omega,
		                      result->lyapunov.error[0]*per_omega,
		                      cli_unit(result->model, " 1/s"), result->lyapunov.averaged);
	if (result->error)
		hawser__table_comment(table, "largest estimated error of a state, over the largest state: "
		                             "%.1e", result->error[run->rows - 1]);
	if (isfinite(result->least))
		hawser__table_comment(table, "tension anywhere on the cable: %.6g to %.6g N", result->least,
		                      result->most);
	cli_surge_comments(table, result);
	if (cli_integrate_slack(text, sizeof text, result))
		hawser__table_comment(table, "warning: %s", text);
	if (cli_integrate_moves(text, sizeof text, result))
		hawser__table_comment(table, "warning: %s", text);
	hawser__table_comment(table, "end: %s", cli_integrate_end(result));
	if (result->spectrum)
		window_comments(table, result);
}

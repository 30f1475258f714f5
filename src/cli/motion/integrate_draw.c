/* cli/motion/integrate_draw.c - the signals in the picture of a time response: z and y at
 * mid-span or, for a model without probes, its first coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_result.h"
#include "core/report.h"

enum { label_size = CLI_NAME_SIZE + 32, periods_shown = 20 };

static size_t rows_of(const struct cli_integrate_result *result)
{
	return (size_t)result->run.rows;
}

static double reach(const struct cli_integrate_result *result, int k)
{
	double most = 0.0;
	size_t i;

	for (i = 0; i < rows_of(result); i++)
		most = fmax(most, fabs(result->value[(size_t)k*rows_of(result) + i]));
	return most;
}

/* z and y at mid-span (or the first coordinates), without a signal that does not move. */
static int choose(int *signal, const struct cli_integrate_result *result)
{
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	int middle = shapes->points/2, count = 0, p;

	for (p = 0; p < shapes->points; p++)
		if (strcmp(shapes->name[p], "mid") == 0)
			middle = p;
	if (!result->probed) {
		for (p = 0; p < 2 && p < result->signals; p++)
			signal[count++] = p;
		return count;
	}
	if (reach(result, 3*middle + 2) > 1e-9*reach(result, 3*middle + 1))
		signal[count++] = 3*middle + 2;
	if (count == 0 || reach(result, 3*middle + 1) > 1e-9*reach(result, 3*middle + 2))
		signal[count++] = 3*middle + 1;
	return count;
}

/* Names come from files: only letters and digits are written to the script. */
static void label_of(char *label, const struct cli_integrate_result *result, int k)
{
	char name[CLI_NAME_SIZE];
	char *c;

	cli_signal_name(name, result, k);
	for (c = name; *c; c++)
		if (strspn(c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") == 0)
			*c = '-';
	if (result->probed)
		snprintf(label, label_size, "{/:Italic %c}, %s%s", name[0], name + 2,
		         strcmp(name + 2, "mid") == 0 ? "-span" : "");
	else
		snprintf(label, label_size, "{/:Italic u}_{%s}", name + 2);
}

static int settled_from(const struct cli_integrate_result *result)
{
	double shown = periods_shown*result->period/result->every;
	int rows = result->run.rows;

	if (cli_integrate_section(result)) /* all of a section after a transient */
		return result->forcing.begin > 0.0 ? 0 : rows/2;
	/* NOLINTNEXTLINE(bugprone-integer-division): the whole part is meant */
	return shown < rows/2 ? rows - (int)shown - 1 : rows/2;
}

enum hawser_status cli_integrate_draw(const char *path, const void *context,
                                      struct hawser_report *report)
{
	const struct cli_integrate_result *result = context;
	struct hawser__axis axis = cli_integrate_axis(result);
	char label[2][label_size];
	struct hawser__plot_signal signal[2];
	struct hawser__history history = {0};
	double *time;
	int chosen[2], count = choose(chosen, result), i;
	enum hawser_status status;

	if (result->bins == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
		                    "the run has too few rows for a picture: make --every smaller");
	time = calloc(rows_of(result), sizeof *time);
	if (!time)
		return hawser__no_memory(report, "picture");
	for (i = 0; i < result->run.rows; i++)
		time[i] = result->run.time[i]/cli_per_omega(result->model)/axis.per;
	for (i = 0; i < count; i++) {
		label_of(label[i], result, chosen[i]);
		signal[i].label = label[i];
		signal[i].value = result->value + (size_t)chosen[i]*rows_of(result);
		signal[i].rate = result->rate + (size_t)chosen[i]*rows_of(result);
		signal[i].amplitude = result->amplitude + (size_t)chosen[i]*(size_t)result->bins;
	}
	history.rows = result->run.rows;
	history.bins = result->bins;
	history.signals = count;
	history.settled_from = settled_from(result);
	history.time = time;
	history.frequency = result->frequency;
	history.forcing = result->omega*cli_per_omega(result->model)/(2.0*M_PI);
	history.section = cli_integrate_section(result);
	history.scaled = result->model->rom.scaled;
	history.time_title = axis.title;
	history.y = cli_model_axis(result->model, "", "m");
	history.rate = cli_model_axis(result->model, "Velocity", "m/s");
	history.amplitude = cli_model_axis(result->model, "Amplitude", "m");
	history.spectrum = hawser__axis_of("Frequency", history.scaled ? "Hz" : "1/time", 0.0);
	history.signal = signal;
	status = hawser__plot_integrate(path, &history, report);
	free(time);
	return status;
}

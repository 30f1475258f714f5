/* cli/motion/integrate_draw.c - the signals in the picture of a time response: z and y at
 * mid-span, or where a ropeway moves most, or, for a model without probes, its first coordinates;
 * history, phase plane of the settled part, spectrum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/motion/integrate_result.h"
#include "core/report.h"
#include "output/drawing/figure.h"

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

/* The middle of a span, or of other models the probe whose y or z is largest. */
static int choose_probe(const struct cli_integrate_result *result)
{
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	double most = -1.0;
	int at = 0;

	for (int p = 0; p < shapes->points; p++) {
		double size = fmax(reach(result, 3*p + 1), reach(result, 3*p + 2));

		if (strcmp(shapes->name[p], "mid") == 0)
			return p;
		at = size > most ? p : at;
		most = fmax(most, size);
	}
	return at;
}

/* z and y at that probe (or the first coordinates), without a signal that does not move. */
static int choose(int *signal, const struct cli_integrate_result *result)
{
	int count = 0, middle;

	if (!result->probed) {
		for (int p = 0; p < 2 && p < result->signals; p++)
			signal[count++] = p;
		return count;
	}
	middle = choose_probe(result);
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
	return shown < rows/2 ? rows - (int)shown - 1 : rows/2;
}

/* One row of panels for each signal, history and phase plane; below them the spectra of all signals. */
struct drawing {
	struct hawser__figure figure;
	const struct cli_integrate_result *result;
	struct hawser__axis time, spectrum, amplitude;
	double tall, top; /* of a row of panels, and of the first one: parts of the height */
};

/* The unit of a displacement or a velocity. In SI each signal has the largest prefix with which its tic
 * labels are short; what the user has chosen is shown as it is, and spectra are in m. */
static struct hawser__axis axis_with_prefix(const struct drawing *of, int k, const char *what,
                                            const char *si)
{
	static const struct {
		double least, per; /* m: it is for signals of at least this size */
		const char *prefix;
	} prefix[] = {{0.02, 1.0, ""}, {2e-5, 1e-3, "m"}, {0.0, 1e-6, "µ"}};
	struct hawser__axis axis = cli_model_axis(of->result->model, "", si);
	double largest = reach(of->result, k);
	int p = 0, plain = of->result->model->rom.scaled && strcmp(axis.unit, si) == 0 &&
	                   strcmp(cli_model_axis(of->result->model, "", "m").unit, "m") == 0;

	while (plain && largest > 0.0 && largest < prefix[p].least)
		p++;
	axis.per *= prefix[p].per;
	snprintf(axis.title, sizeof axis.title, "%.80s%s%s%.*s%s", what, *axis.unit ? " (" : "",
	         *axis.unit ? prefix[p].prefix : "", HAWSER__MARKUP_SIZE - 1, axis.unit, *axis.unit
	         ? ")" : "");
	return axis;
}

/* Lines, or points of a section. */
static void draw_signal(struct hawser__figure *figure, const struct cli_integrate_result *result,
                        int row)
{
	if (cli_integrate_section(result))
		hawser__figure_draw(figure, NULL, "with points lt %d pt 7 ps 0.15", row + 1);
	else
		hawser__figure_draw(figure, NULL, "with lines lt %d lw 0.8", row + 1);
}

static void draw_row(struct drawing *of, int row, int k, int last)
{
	const struct cli_integrate_result *result = of->result;
	const double *value = result->value + (size_t)k*rows_of(result);
	const double *rate = result->rate + (size_t)k*rows_of(result);
	double base = of->top - of->tall*(row + 1) + 1.95/of->figure.out.height;
	double roof = of->top - of->tall*row, unit = cli_per_omega(result->model);
	int from = settled_from(result), rows = result->run.rows;
	struct hawser__axis y, velocity = axis_with_prefix(of, k, "Velocity", "m/s");
	char label[label_size];

	label_of(label, result, k);
	y = axis_with_prefix(of, k, label, "m");
	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){0.13, 0.60, base, roof,
		.y = {.axis = &y},
		.x = {&of->time, result->run.time[0]/unit, result->run.time[rows - 1]/unit, .bare = !last}});
	for (int i = 0; i < rows; i++)
		hawser__figure_put(&of->figure, result->run.time[i]/unit, value[i]);
	draw_signal(&of->figure, result, row);
	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){0.775, 0.975, base, roof,
		.x = {&y, .tics = 3, .open = 1}, .y = {&velocity, .tics = 5, .open = 1}});
	hawser__figure_bind(&of->figure, rows - from, value + from, sizeof *value, rate + from,
	                    sizeof *rate);
	draw_signal(&of->figure, result, row);
}

/* Spectra are drawn for some decades below their peak, up to the last frequency at which one exceeds a
 * part of it: smaller values are leakage of the window, or round-off. The Nyquist frequency may be much
 * larger. */
static void draw_spectra(struct drawing *of, const int *chosen, int count)
{
	const double decades = 7.0, part_of_peak = 1e-4;
	const struct cli_integrate_result *result = of->result;
	double forcing = result->omega*cli_per_omega(result->model)/(2.0*M_PI), peak = 0.0, end;
	int last = 1;
	char label[label_size];

	for (int k = 0; k < count; k++)
		for (int i = 1; i < result->bins; i++)
			peak = fmax(peak, result->amplitude[(size_t)chosen[k]*(size_t)result->bins + (size_t)i]);
	for (int k = 0; k < count; k++)
		for (int i = last + 1; i < result->bins; i++)
			if (result->amplitude[(size_t)chosen[k]*(size_t)result->bins + (size_t)i] >
			    part_of_peak*peak)
				last = i;
	end = fmin(fmax(1.1*result->frequency[last], 3.0*forcing), result->frequency[result->bins - 1]);
	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){0.13, 0.975,
		2.3/of->figure.out.height,
		of->top - of->tall*count, .x = {&of->spectrum, 0.0, end, .tics = 10},
		.y = {&of->amplitude, peak*pow(10.0, -decades), 5.0*peak, .logarithmic = peak > 0.0,
		      .tics = 6}});
	fputs("unset xzeroaxis\n", of->figure.out.script);
	if (forcing > 0.0) {
		hawser__figure_upright(&of->figure, NULL, forcing, "lt 7 lw 0.5 dt (4,4)");
		hawser__figure_above(&of->figure, forcing, "offset 0.3,-0.3 font ',8'", "forcing");
	}
	for (int k = 0; k < count; k++) {
		const double *amplitude = result->amplitude + (size_t)chosen[k]*(size_t)result->bins;

		hawser__figure_bind(&of->figure, result->bins - 1, result->frequency + 1, sizeof *amplitude,
		                    amplitude + 1, sizeof *amplitude);
		label_of(label, result, chosen[k]);
		hawser__figure_draw(&of->figure, label, "with lines lt %d lw 1", k + 1);
	}
}

enum hawser_status cli_integrate_draw(const char *path, const void *context,
                                      struct hawser_report *report)
{
	struct drawing of = {.result = context};
	int chosen[2], count = choose(chosen, of.result);
	double height = 7.2 + 5.0*count;
	enum hawser_status status;

	if (of.result->bins == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
		                    "the run has too few rows for a picture: make --every smaller");
	status = hawser__figure_begin(&of.figure, path, 17.0, height, report);
	if (status)
		return status;
	of.time = cli_integrate_axis(of.result);
	of.spectrum = hawser__axis_of("Frequency", of.result->model->rom.scaled ? "Hz" : "1/time", 0.0);
	of.amplitude = cli_model_axis(of.result->model, "Amplitude", "m");
	of.tall = 5.0/height;
	of.top = 1.0 - 0.4/height;
	fputs("set xzeroaxis lt 7 lw 0.4\n", of.figure.out.script);
	for (int k = 0; k < count; k++)
		draw_row(&of, k, chosen[k], k + 1 == count);
	draw_spectra(&of, chosen, count);
	return hawser__figure_finish(&of.figure, report);
}

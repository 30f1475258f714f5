/* cli/beam/beam_motion.c - free motion of hawser beam: the initial shape, comments, picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/beam/beam_result.h"
#include "core/report.h"
#include "output/drawing/figure.h"

enum { SAMPLES = 401, LINES = 10000 };

static double length_of(const struct hawser_beam *beam)
{
	return beam->time > 0.0 ? beam->length : 1.0;
}

static double time_of(const struct hawser_beam *beam)
{
	return beam->time > 0.0 ? beam->time : 1.0;
}

/* --- the initial shape --- */

/* Number of rows of x, y and rate; 0 if a line has other contents, or x is not ascending. */
static int read_lines(double *row, int *count, FILE *stream)
{
	char line[512], rest;

	*count = 0;
	while (fgets(line, sizeof line, stream)) {
		double *at = row + 3**count;
		int got;

		if (line[strspn(line, " \t\r\n")] == '\0' || *line == '#')
			continue;
		at[2] = 0.0;
		/* NOLINTNEXTLINE(cert-err34-c): overflow is seen as not finite */
		got = sscanf(line, "%lf%*[ \t,]%lf%*[ \t,]%lf %c", &at[0], &at[1], &at[2], &rest);
		if (got < 2 || got > 3 || ++*count == LINES || !isfinite(at[0] + at[1] + at[2]) ||
		    (*count > 1 && !(at[0] > at[-3])))
			return 0;
	}
	return *count >= 2;
}

/* Linear interpolation between the rows. */
static void sample(double *value, const double *row, int count, int column, double x_scale,
        double scale)
{
	for (int i = 0, k = 0; i < SAMPLES; i++) {
		double x = x_scale*i/(SAMPLES - 1.0), t;

		while (k < count - 2 && x > row[3*(k + 1)])
			k++;
		t = fmin(fmax((x - row[3*k])/(row[3*(k + 1)] - row[3*k]), 0.0), 1.0);
		value[i] = scale*(row[3*k + column] + t*(row[3*(k + 1) + column] - row[3*k + column]));
	}
}

enum hawser_status cli_beam_shape(double **shape, struct hawser_beam_motion_options *options,
                                  const char *path, const struct hawser_beam *beam,
                                  struct hawser_report *report)
{
	FILE *stream = fopen(path, "r");
	int error = errno;
	double *row = malloc(3*(size_t)LINES*sizeof *row), L = length_of(beam);
	int count = 0, fine;

	*shape = malloc(2*(size_t)SAMPLES*sizeof **shape);
	if (!stream || !row || !*shape) {
		free(row);
		if (!stream)
			return hawser__fail(report, hawser__unreadable(error), "beam", "cannot read %s: %s",
			                    path, strerror(error));
		fclose(stream);
		return hawser__no_memory(report, "beam");
	}
	fine = read_lines(row, &count, stream);
	fclose(stream);
	if (fine) {
		sample(*shape, row, count, 1, L, 1.0/L);
		sample(*shape + SAMPLES, row, count, 2, L, time_of(beam)/L);
		options->points = SAMPLES;
		options->deflection = *shape;
		options->rate = *shape + SAMPLES;
	}
	free(row);
	if (fine)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
	                    "%s, after %d lines: a shape is 2 to %d lines of x, y and perhaps dy/dt, x "
	                    "ascending from 0 to %g", path, count, LINES - 1, L);
}

/* --- results --- */

double cli_beam_unbalanced(const struct hawser_beam_motion *motion)
{
	double off = 0.0, size = 0.0;

	for (int i = 0; i < motion->rows; i++) {
		off = fmax(off, fabs(motion->ends[i] + motion->weight[i] + motion->drag[i] -
		                     motion->change[i]));
		size = fmax(size, fabs(motion->ends[i]) + fabs(motion->weight[i]) + fabs(motion->drag[i]));
	}
	return size > 0.0 ? off/size : 0.0;
}

double cli_beam_growth(const struct hawser_beam_motion *motion)
{
	int from = 4*motion->rows/5, half = (motion->rows + from)/2;
	double first = 0.0, second = 0.0;

	for (int i = from; i < motion->rows; i++) {
		double *most = i < half ? &first : &second;

		*most = fmax(*most, fabs(motion->y[i]));
	}
	if (!(first > 0.0 && second > 0.0))
		return 0.0;
	return log(second/first)/(motion->time[motion->rows - 1] - motion->time[half - 1]);
}

static void comments(struct hawser__table *table, const struct cli_beam_variant *v)
{
	const struct hawser_beam_motion *motion = &v->motion;

	hawser__table_comment(table,
	        "integrator: %s, %ld steps; energy balance with the fields at the ends "
	                             "off by %.1e of its largest term", motion->method, motion->steps,
	                      cli_beam_unbalanced(motion));
	hawser__table_comment(table, "growth of the deflection in the last fifth: %.6g (scaled)",
	                      cli_beam_growth(motion));
}

void cli_beam_motion_comments(struct hawser__table *table, const struct cli_beam_result *result)
{
	for (int i = 0; i < result->variants; i++)
		comments(table, &result->variant[i]);
	if (result->variant[0].beam.time > 0.0)
		hawser__table_comment(table, "energies and powers are scaled: by T L, and by that over the "
		                             "unit of time");
}

/* Panel k, from the top: the deflection, its logarithm, the rate of the energy of the material. */
static void draw_panel(struct hawser__figure *figure, const struct cli_beam_result *result,
                       const struct hawser__axis axis[CLI_BEAM_AXES], int k)
{
	const double high = 4.0, gap = 0.6, above = 0.3; /* cm */
	double height = figure->out.height, upper = height - above - k*(high + gap);
	struct hawser__axis size = axis[CLI_BEAM_Y];
	const struct hawser__axis *y[] = {&axis[CLI_BEAM_Y], &size, &axis[CLI_BEAM_RATE]};
	char label[120];

	snprintf(size.title, sizeof size.title, "|{/:Italic y}| (%s)", size.unit);
	hawser__figure_panel(figure, &(struct hawser__panel_frame){
		0.15, 0.97, (upper - high)/height, upper/height,
		.x = {&axis[CLI_BEAM_TIME], .tics = 8, .bare = k < 2},
		.y = {y[k], .logarithmic = k == 1, .tics = k == 1 ? 0 : 5, .room = 0.06}});
	for (int i = 0; i < result->variants; i++) {
		const struct cli_beam_variant *v = &result->variant[i];
		double per = time_of(&v->beam), length = length_of(&v->beam);

		for (int n = 0; n < v->motion.rows; n++) {
			double deflection = v->motion.y[n]*length;

			hawser__figure_put(figure, v->motion.time[n]*per, k == 0 ? deflection
			                   : k == 1 ? fabs(deflection) : v->motion.material[n]);
		}
		cli_beam_label(label, sizeof label, result, v, "");
		hawser__figure_draw(figure, result->variants > 1 ? label : NULL, "with lines lt %d lw 1.3",
		                    i + 1);
	}
}

enum hawser_status cli_beam_motion_draw(const char *path, const struct cli_beam_result *result,
                                        struct hawser_report *report)
{
	struct hawser__axis axis[CLI_BEAM_AXES];
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(
		&figure, path, 15.0, result->variants > 1 ? 16.5 : 15.5, report);

	if (status)
		return status;
	cli_beam_motion_axes(axis, result);
	for (int k = 0; k < 3; k++)
		draw_panel(&figure, result, axis, k);
	return hawser__figure_finish(&figure, report);
}

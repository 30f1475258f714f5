/* study/hill/hill_lines.c - stability boundaries in a rectangle: search lines, and the boundaries that
 * cross them.
 *
 * Several threads compute the three test functions at the points of a line; the results do not
 * depend on the thread. One thread then follows the boundaries, in the order of the lines, so that
 * the chart does not depend on the number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "core/share.h"
#include "study/hill/hill.h"

struct scan {
	struct hawser__hill *hill;
	const struct hawser__hill_line *line;
	int kinds;
};

static void sample(void *context, long i, int number)
{
	const struct scan *scan = context;
	const struct hawser__hill_line *line = scan->line;
	struct hawser__hill_worker *worker = &scan->hill->worker[number];
	double s = (double)i/line->samples;
	double at[2] = {line->from[0] + s*line->along[0], line->from[1] + s*line->along[1]};

	for (int kind = 0; kind < scan->kinds; kind++)
		line->g[i*HAWSER_HILL_KINDS + kind] = NAN;
	if (hawser__hill_multipliers(scan->hill, worker, at, 1))
		return;
	for (int kind = 0; kind < scan->kinds; kind++)
		line->g[i*HAWSER_HILL_KINDS + kind] = hawser__hill_test(worker, kind);
}

enum hawser_status hawser__hill_prepare(struct hawser__hill *hill,
                                        const struct hawser__hill_line *line,
                                        const double *place, int places)
{
	const struct hawser_hill_options *options = hill->options;
	size_t count = (size_t)(place ? places : line->samples + 1);
	double *x, *y;
	enum hawser_status status;

	if (!hill->field->prepare)
		return HAWSER_OK;
	if (!(x = malloc(2*count*sizeof *x)))
		return hawser__no_memory(hill->report, "hill");
	y = x + count;
	for (size_t i = 0; i < count; i++) {
		double s = place ? place[i] : (double)i/line->samples;

		x[i] = options->from[0] + (options->to[0] - options->from[0])*
		                          (line->from[0] + s*line->along[0]);
		y[i] = options->from[1] + (options->to[1] - options->from[1])*
		                          (line->from[1] + s*line->along[1]);
	}
	status = hill->field->prepare(hill->field->context, x, y, (int)count, hill->threads,
	                              hill->report);
	free(x);
	return status;
}

static void search(struct hawser__hill *hill, const struct hawser__hill_line *line)
{
	double ds = 1.0/line->samples;
	struct scan scan = {hill, line, hill->field->m > 2 ? HAWSER_HILL_KINDS : HAWSER_HILL_TORUS};

	if ((hill->status = hawser__hill_prepare(hill, line, NULL, 0)))
		return;
	hawser__share((long)line->samples + 1, hill->threads, sample, &scan);
	for (int t = 0; t < hill->threads && !hill->status; t++)
		if ((hill->status = hill->worker[t].status))
			*hill->report = hill->worker[t].report;
	hill->chart->interrupted |= hawser__hill_told_to_stop(hill->options, hill->chart->boundaries, 0,
	                                                      &hill->span);
	for (int kind = 0; kind < scan.kinds; kind++)
		for (int i = 0; i < line->samples && !hill->status && !hill->chart->interrupted; i++) {
			const double *g = line->g + i*HAWSER_HILL_KINDS + kind;
			double next = g[HAWSER_HILL_KINDS], sign = *g < 0.0 ? -1.0 : 1.0;

			if (sign*next < 0.0)
				hawser__hill_try(hill, kind, line, i*ds, (i + 1)*ds);
			else if (!hill->worker->linear && i > 0 && sign*g[-HAWSER_HILL_KINDS] > fabs(*g) &&
			         sign*next > fabs(*g))
				hawser__hill_between(hill, kind, line, (i - 1)*ds, (i + 1)*ds, sign);
		}
	if (!hill->chart->interrupted)
		hawser__hill_ridges(hill, line);
}

static void all_lines(struct hawser__hill *hill, double *g)
{
	int lines = hill->options->lines;

	/* the upper edge first, since most tongues are widest there */
	for (int k = lines; k >= 0 && !hill->status && !hill->chart->interrupted; k--) {
		const struct hawser__hill_line across = {{0.0, k > 0 ? (double)k/lines : 1e-3}, {1.0, 0.0},
		                                         hill->options->samples, g};
		const struct hawser__hill_line up = {{(double)k/lines, 1e-3}, {0.0, 0.999},
		                                     hill->options->samples, g};

		hawser__span_stage(&hill->span, (double)(lines - k)/(lines + 1),
		                   (lines - k + 1.0)/(lines + 1));
		search(hill, &across);
		hawser__span_stage(&hill->span, (lines - k + 0.5)/(lines + 1), (lines - k + 1.0)/(lines + 1));
		if (!hill->status && !hill->chart->interrupted)
			search(hill, &up);
	}
}

/* Convert to the units of the caller. */
static void scale(struct hawser_hill_chart *chart, const struct hawser_hill_options *options)
{
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < 2*chart->boundary[b].points; i++) {
			double *at = &chart->boundary[b].at[i];

			*at = options->from[i%2] + (options->to[i%2] - options->from[i%2])**at;
		}
}

enum hawser_status hawser__hill_check(const struct hawser_hill_options *options,
                                      struct hawser_report *report)
{
	for (int k = 0; k < 2; k++)
		if (!(isfinite(options->from[k]) && isfinite(options->to[k]) &&
		      options->from[k] < options->to[k]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
			                    "a rectangle from %g to %g: give the smaller end first",
			                    options->from[k], options->to[k]);
	if (options->lines < 1 || options->samples < 4 || !(options->step > 1e-5 &&
	                                                    options->step < 0.5))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "%d lines of %d samples, steps of %g: give 1, 4 and 1e-5 at least",
		                    options->lines, options->samples, options->step);
	return HAWSER_OK;
}

/* --- workers --- */

void hawser__hill_close(struct hawser__hill *hill)
{
	for (int t = 0; hill->worker && t < hill->threads; t++) {
		struct hawser__hill_worker *worker = &hill->worker[t];

		if (hill->chart) {
			hill->chart->evaluations += worker->evaluations;
			if (worker->missed > 0 && hill->chart->missed == 0)
				memcpy(hill->chart->why, worker->why, sizeof worker->why);
			hill->chart->missed += worker->missed;
		}
		hawser_linear_free(worker->linear);
		hawser__hill_matrix_release(&worker->matrix);
		free(worker->memory);
		free(worker->used);
		free(worker->part);
	}
	free(hill->worker);
	hill->worker = NULL;
}

static enum hawser_status open_worker(struct hawser__hill_worker *worker, int number,
                                      const struct hawser_hill_field *field,
                                      struct hawser_report *report)
{
	size_t m = (size_t)field->m;

	worker->number = number;
	worker->m = field->m;
	worker->memory = calloc(5*m, sizeof(double));
	worker->used = calloc(m, sizeof *worker->used);
	if (!worker->memory || !worker->used)
		return hawser__no_memory(report, "hill");
	worker->log_modulus = worker->memory;
	worker->argument = worker->log_modulus + m;
	worker->work = worker->argument + m;
	return field->model ? hawser_linear_open(&worker->linear, field->m/2, report) : HAWSER_OK;
}

enum hawser_status hawser__hill_open(struct hawser__hill *hill)
{
	const struct hawser_hill_field *field = hill->field;
	enum hawser_status status = HAWSER_OK;

	hill->threads = 1;
	if (field->model && field->workers > 1)
		hill->threads = field->workers;
	hill->worker = calloc((size_t)hill->threads, sizeof *hill->worker);
	if (!hill->worker)
		return hawser__no_memory(hill->report, "hill");
	for (int t = 0; t < hill->threads && !status; t++)
		status = open_worker(&hill->worker[t], t, field, hill->report);
	return status;
}

enum hawser_status hawser_hill_trace(struct hawser_hill_chart *chart,
                                     const struct hawser_hill_field *field,
                                     const struct hawser_hill_options *options,
                                     struct hawser_report *report)
{
	struct hawser_report unused = {.message = ""};
	struct hawser_hill_options settled = *options;
	struct hawser__hill hill = {.field = field, .options = &settled, .chart = chart, .report =
	                            report ? report : &unused, .span.began = hawser__wall_seconds()};
	double *g;

	memset(chart, 0, sizeof *chart);
	hawser_hill_settle(&settled);
	options = &settled;
	if ((hill.status = hawser__hill_check(options, report)))
		return hill.status;
	g = calloc(((size_t)options->samples + 1)*HAWSER_HILL_KINDS, sizeof *g);
	hill.status = g ? hawser__hill_open(&hill) : hawser__no_memory(report, "hill");
	if (!hill.status) {
		all_lines(&hill, g);
		scale(chart, options);
		hawser__ridge_unresolved(&chart->narrow, &hill.tongues);
	}
	hawser__hill_close(&hill);
	free(hill.tongues.item);
	free(hill.tongues.found);
	free(g);
	if (hill.status)
		hawser_hill_clear(chart);
	return hill.status;
}

void hawser_hill_clear(struct hawser_hill_chart *chart)
{
	if (!chart)
		return;
	for (int b = 0; b < chart->boundaries; b++)
		free(chart->boundary[b].at);
	free(chart->boundary);
	free(chart->tongue);
	free(chart->narrow.item);
	memset(chart, 0, sizeof *chart);
}

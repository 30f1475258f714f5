/* cli/irvine_draw.c - a sweep's picture: frequencies into the unit asked for, and the analytic ones to
 * be laid over.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/irvine_result.h"
#include "core/report.h"

static const char analytic[] = "analytic";

static int has_method(const char *name)
{
	int count, i;
	const struct hawser_modes_method *method = hawser_modes_methods(&count);

	for (i = 0; i < count; i++)
		if (strcmp(method[i].name, name) == 0)
			return 1;
	return 0;
}

/* A row of the overlay: the lowest in each plane, in ascending order. Where the approximation has no
 * answer the row stays empty. */
static void fill_row(double *row, const struct hawser_irvine *irvine, int i)
{
	struct hawser_modes_options choice = {.n = irvine->branches + 6, .method = analytic};
	struct hawser_modes modes;
	int next[2] = {0, irvine->in_plane};
	int end[2] = {irvine->in_plane, irvine->branches};
	int k;

	if (hawser_modes_solve(&modes, &irvine->station[i].statics, &choice, NULL))
		return;
	for (k = 0; k < modes.n; k++) {
		int plane = modes.mode[k].plane == HAWSER_IN_PLANE ? 0 : 1;

		if (next[plane] < end[plane])
			row[next[plane]++] = modes.mode[k].omega/modes.time_unit;
	}
	hawser_modes_clear(&modes);
}

enum hawser_status cli_irvine_overlay(struct cli_irvine_result *result,
                                      struct hawser_report *report)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int cells = irvine->stations*irvine->branches, i;

	result->overlaid = has_method(analytic);
	if (!result->common->plot || !result->overlaid || strcmp(irvine->method, analytic) == 0)
		return HAWSER_OK;
	result->analytic = malloc((size_t)cells*sizeof *result->analytic);
	if (!result->analytic)
		return hawser__no_memory(report, "irvine");
	for (i = 0; i < cells; i++)
		result->analytic[i] = NAN;
	for (i = 0; i < irvine->stations; i++)
		fill_row(result->analytic + i*irvine->branches, irvine, i);
	return HAWSER_OK;
}

/* A tension or a length in a unit that leaves numbers one can read. */
static double abscissa(const struct cli_irvine_result *result, double value, double lambda)
{
	int length = strcmp(cli_irvine_si(result->irvine.sweep), "m") == 0;

	return !result->over_value ? lambda/M_PI : length ? value : value/1e3;
}

static void title_x(char *title, size_t size, const struct cli_irvine_result *result)
{
	static const char *const words[] = {
		[HAWSER_GIVEN_NONE] = "", [HAWSER_GIVEN_H] = "Horizontal tension {/:Italic H} (kN)",
		[HAWSER_GIVEN_T0] = "Tension at end A {/:Italic T}_0 (kN)",
		[HAWSER_GIVEN_T1] = "Tension at end B {/:Italic T}_1 (kN)",
		[HAWSER_GIVEN_LENGTH0] = "Unstretched length (m)", [HAWSER_GIVEN_SAG] = "Sag (m)"};

	snprintf(title, size, "%s", result->over_value ? words[result->irvine.sweep]
	                                               : "Irvine parameter {/:Italic λ}/π");
}

/* A meeting's place on the branch with that number, `part` of the gap from its middle. */
static double mark_on(const struct cli_irvine_result *result,
                      const struct hawser_irvine_crossover *at, int number, double part)
{
	return number > result->irvine.in_plane
		? NAN : cli_irvine_in_unit(result, at->omega + part*at->gap, at->H);
}

/* Everything the picture shows, into data (4 arrays one after the other) and kind. */
static void fill(struct hawser__diagram *picture, double *data, int *kind,
                 const struct cli_irvine_result *result)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int cells = irvine->stations*irvine->branches, i;
	double *x = data + 2*cells, *mark_x = x + irvine->stations;
	double *mark_y = mark_x + irvine->crossovers;

	for (i = 0; i < cells; i++) {
		double H = irvine->station[i/irvine->branches].statics.H;

		data[i] = cli_irvine_in_unit(result, irvine->omega[i], H);
		data[cells + i] = result->analytic ? cli_irvine_in_unit(result, result->analytic[i], H)
		                                   : NAN;
	}
	for (i = 0; i < irvine->stations; i++)
		x[i] = abscissa(result, irvine->station[i].value,
		                irvine->station[i].statics.irvine_source);
	for (i = 0; i < irvine->crossovers; i++) {
		const struct hawser_irvine_crossover *at = &irvine->crossover[i];

		mark_x[i] = abscissa(result, at->value, at->irvine_source);
		mark_y[2*i] = mark_on(result, at, at->below, -0.5);
		mark_y[2*i + 1] = mark_on(result, at, at->above, 0.5);
		kind[i] = at->kind == HAWSER_VEERING;
	}
	picture->y = data;
	picture->overlay = result->analytic ? data + cells : NULL;
	picture->x = x;
	picture->mark_x = mark_x;
	picture->mark_y = mark_y;
	picture->veers = kind;
}

enum hawser_status cli_irvine_draw(const char *path, const void *context,
                                   struct hawser_report *report)
{
	static const char *const titles[] = {
		[CLI_NORMALISED] = "Frequency {/:Italic ω} / {/:Italic ω}_{string}",
		[CLI_RAD_S] = "Frequency {/:Italic ω} (rad/s)", [CLI_HZ] = "Frequency (Hz)",
		[CLI_PERIOD] = "Period (s)"};
	const struct cli_irvine_result *result = context;
	const struct hawser_irvine *irvine = &result->irvine;
	size_t cells = (size_t)irvine->stations*(size_t)irvine->branches;
	size_t marks = (size_t)irvine->crossovers;
	double *data = malloc((2*cells + (size_t)irvine->stations + 3*marks)*sizeof *data);
	int *kind = malloc((marks + 1)*sizeof *kind);
	char title[80];
	struct hawser__diagram picture = {
		.stations = irvine->stations, .branches = irvine->branches,
		.in_plane = irvine->in_plane, .marks = irvine->crossovers, .x_title = title,
		.y_title = titles[result->unit], .logarithmic = irvine->sweep != HAWSER_GIVEN_LENGTH0};
	enum hawser_status status;

	picture.logarithmic |= !result->over_value;
	title_x(title, sizeof title, result);
	if (data && kind) {
		fill(&picture, data, kind, result);
		status = hawser__plot_irvine(path, &picture, report);
	} else {
		status = hawser__no_memory(report, "irvine");
	}
	free(data);
	free(kind);
	return status;
}

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

int cli_irvine_has_analytic(void)
{
	int count, i;
	const struct hawser_modes_method *method = hawser_modes_methods(&count);

	for (i = 0; i < count; i++)
		if (strcmp(method[i].name, analytic) == 0)
			return 1;
	return 0;
}

/* Curves go by place: where they cross, nothing shows; and the analytic ones cross elsewhere than the
 * converged ones, so that a branch has no other meaning for them. `in`: curves in the plane. */
static void fill_row(double *row, const struct cli_irvine_result *result, int i, int in)
{
	const struct hawser_irvine *irvine = &result->irvine;
	struct hawser_modes_options choice = {.n = 2*result->overlays + 2, .method = analytic};
	const int *place = irvine->place + i*irvine->branches;
	struct hawser_modes modes;
	int found[2] = {0, 0}, b, k;

	for (b = 0; b < result->overlays; b++)
		row[b] = NAN;
	if (hawser_modes_solve(&modes, &irvine->station[i].statics, &choice, NULL))
		return; /* no answer here: the curves have a hole */
	for (k = 0; k < modes.n; k++) {
		int plane = modes.mode[k].plane, here = found[plane]++;

		for (b = 0; b < irvine->branches; b++)
			if ((int)irvine->branch[b].plane == plane && place[b] == here)
				row[(plane == HAWSER_IN_PLANE ? 0 : in) + here] =
					modes.mode[k].omega/modes.time_unit;
	}
	hawser_modes_clear(&modes);
}

enum hawser_status cli_irvine_overlay(struct cli_irvine_result *result,
                                      struct hawser_report *report)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int in = 0, i, b;

	if (!result->common->plot || !cli_irvine_has_analytic() ||
	    strcmp(irvine->method, analytic) == 0)
		return HAWSER_OK;
	for (i = 0; i < irvine->stations; i++)
		for (b = 0; b < irvine->in_plane; b++)
			in = irvine->place[i*irvine->branches + b] + 1 > in
				? irvine->place[i*irvine->branches + b] + 1 : in;
	result->overlays = in + irvine->branches - irvine->in_plane;
	result->analytic = malloc((size_t)irvine->stations*(size_t)result->overlays*
	                          sizeof *result->analytic);
	if (!result->analytic)
		return hawser__no_memory(report, "irvine");
	for (i = 0; i < irvine->stations; i++)
		fill_row(result->analytic + i*result->overlays, result, i, in);
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

/* What the picture shows, in its units; [] as in struct hawser__diagram. */
struct arrays {
	double *x, *y, *overlay, *mark_x, *mark_y;
	int *veers;
};

static void fill(struct arrays *to, const struct cli_irvine_result *result)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int i, b;

	for (i = 0; i < irvine->stations; i++) {
		double H = irvine->station[i].statics.H;

		to->x[i] = abscissa(result, irvine->station[i].value,
		                    irvine->station[i].statics.irvine_source);
		for (b = 0; b < irvine->branches; b++)
			to->y[i*irvine->branches + b] =
				cli_irvine_in_unit(result, irvine->omega[i*irvine->branches + b], H);
		for (b = 0; b < result->overlays; b++)
			to->overlay[i*result->overlays + b] =
				cli_irvine_in_unit(result, result->analytic[i*result->overlays + b], H);
	}
	for (i = 0; i < irvine->crossovers; i++) {
		const struct hawser_irvine_crossover *at = &irvine->crossover[i];

		to->mark_x[i] = abscissa(result, at->value, at->irvine_source);
		to->mark_y[2*i] = mark_on(result, at, at->below, -0.5);
		to->mark_y[2*i + 1] = mark_on(result, at, at->above, 0.5);
		to->veers[i] = at->kind == HAWSER_VEERING;
	}
}

static enum hawser_status allocate(struct arrays *to, const struct cli_irvine_result *result,
                                   struct hawser_report *report)
{
	size_t stations = (size_t)result->irvine.stations, marks = (size_t)result->irvine.crossovers;

	to->x = calloc(stations, sizeof *to->x);
	to->y = calloc(stations*(size_t)result->irvine.branches, sizeof *to->y);
	to->overlay = calloc(stations*(size_t)result->overlays + 1, sizeof *to->overlay);
	to->mark_x = calloc(marks + 1, sizeof *to->mark_x);
	to->mark_y = calloc(2*marks + 1, sizeof *to->mark_y);
	to->veers = calloc(marks + 1, sizeof *to->veers);
	if (to->x && to->y && to->overlay && to->mark_x && to->mark_y && to->veers)
		return HAWSER_OK;
	return hawser__no_memory(report, "irvine");
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
	struct arrays to = {0};
	enum hawser_status status = allocate(&to, result, report);
	char title[80];

	if (!status) {
		const struct hawser__diagram picture = {
			.stations = irvine->stations, .branches = irvine->branches,
			.in_plane = irvine->in_plane, .overlays = result->overlays,
			.marks = irvine->crossovers, .x_title = title, .y_title = titles[result->unit],
			.logarithmic = !result->over_value || irvine->sweep != HAWSER_GIVEN_LENGTH0,
			.x = to.x, .y = to.y, .overlay = to.overlay, .mark_x = to.mark_x,
			.mark_y = to.mark_y, .veers = to.veers};

		fill(&to, result);
		title_x(title, sizeof title, result);
		status = hawser__plot_irvine(path, &picture, report);
	}
	free(to.x);
	free(to.y);
	free(to.overlay);
	free(to.mark_x);
	free(to.mark_y);
	free(to.veers);
	return status;
}

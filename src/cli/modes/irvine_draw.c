/* cli/modes/irvine_draw.c - the picture of a sweep: conversion of frequencies to the requested
 * unit, and the frequencies of the analytic method for comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/modes/irvine_result.h"
#include "core/report.h"

static const char analytic[] = "analytic";

static int moves(const struct hawser_irvine *irvine)
{
	return irvine->speed != 0.0 || irvine->fluctuation != 0.0;
}

int cli_irvine_has_analytic(const struct hawser_irvine *irvine)
{
	const struct hawser_modes_method *(*row)(int index) =
		moves(irvine) ? hawser_complex_modes_method : hawser_modes_method;
	const struct hawser_statics *st = irvine->stations > 0 ? &irvine->station[0].statics : NULL;

	if (st && (st->attachments > 0 || st->elastic)) /* which the closed forms do not have */
		return 0;
	for (int i = 0; row(i); i++)
		if (strcmp(row(i)->name, analytic) == 0)
			return 1;
	return 0;
}

/* Frequencies (rad/s) and planes by the analytic method, [choice->n] of them; 0 if it fails. */
static int solve(double *omega, enum hawser_plane *plane, const struct hawser_irvine *irvine, int i,
                 const struct hawser_modes_options *choice)
{
	const struct hawser_statics *statics = &irvine->station[i].statics;
	struct hawser_modes modes;

	if (moves(irvine) ? hawser_complex_modes_solve(&modes, statics, choice, NULL)
	                  : hawser_modes_solve(&modes, statics, choice, NULL))
		return 0;
	for (int k = 0; k < modes.n; k++) {
		omega[k] = modes.mode[k].omega/modes.time_unit;
		plane[k] = modes.mode[k].plane;
	}
	hawser_modes_clear(&modes);
	return choice->n;
}

/* Room for the results of solve(). */
struct found {
	double *omega;
	enum hawser_plane *plane;
};

/* The analytic frequencies are assigned to places, not to branches: their curves cross at other
 * points than those of the converged method. `in`: number of curves in the plane. */
static void fill_row(double *row, const struct cli_irvine_sweep *sweep, int i, int in,
                     const struct found *room)
{
	const struct hawser_irvine *irvine = &sweep->irvine;
	struct hawser_modes_options choice = {.n = 2*sweep->overlays + 2, .method = analytic};
	const int *place = irvine->place + i*irvine->branches;
	int found[2] = {0, 0}, count, b, k;

	for (b = 0; b < sweep->overlays; b++)
		row[b] = NAN;
	count = solve(room->omega, room->plane, irvine, i, &choice); /* no frequency: the curves have a
	                                                              * gap */
	for (k = 0; k < count; k++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): solve() fills `count` */
		int plane = room->plane[k], here = found[plane]++;

		for (b = 0; b < irvine->branches; b++)
			if ((int)irvine->branch[b].plane == plane && place[b] == here)
				row[(plane == HAWSER_IN_PLANE ? 0 : in) + here] = room->omega[k];
	}
}

static enum hawser_status overlay(struct cli_irvine_sweep *sweep, struct hawser_report *report)
{
	const struct hawser_irvine *irvine = &sweep->irvine;
	struct found room;
	int in = 0, i, b;

	for (i = 0; i < irvine->stations; i++)
		for (b = 0; b < irvine->in_plane; b++)
			in = irvine->place[i*irvine->branches + b] + 1 > in
				? irvine->place[i*irvine->branches + b] + 1 : in;
	sweep->overlays = in + irvine->branches - irvine->in_plane;
	sweep->analytic = malloc((size_t)irvine->stations*(size_t)sweep->overlays*
	                         sizeof *sweep->analytic);
	room.omega = malloc((2*(size_t)sweep->overlays + 2)*sizeof *room.omega);
	room.plane = malloc((2*(size_t)sweep->overlays + 2)*sizeof *room.plane);
	for (i = 0; i < irvine->stations && sweep->analytic && room.omega && room.plane; i++)
		fill_row(sweep->analytic + i*sweep->overlays, sweep, i, in, &room);
	free(room.omega);
	free(room.plane);
	return i < irvine->stations ? hawser__no_memory(report, "irvine") : HAWSER_OK;
}

enum hawser_status cli_irvine_overlay(struct cli_irvine_result *result,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int k;

	for (k = 0; k < result->sweeps && !status; k++)
		if (result->common->plot && cli_irvine_has_analytic(&result->sweep[k].irvine) &&
		    strcmp(result->sweep[k].irvine.method, analytic) != 0)
			status = overlay(&result->sweep[k], report);
	return status;
}

/* Axis of the swept quantity, or of Irvine's parameter. */
static struct hawser__axis abscissa(const struct cli_irvine_result *result)
{
	enum hawser_given sweep = result->sweep[0].irvine.sweep;
	double largest = 0.0;
	char key[32];

	if (!result->over_value)
		return (struct hawser__axis){"Irvine parameter {/:Italic λ}/π", "", M_PI};
	for (int k = 0; k < result->sweeps; k++)
		for (int i = 0; i < result->sweep[k].irvine.stations; i++)
			largest = fmax(largest, result->sweep[k].irvine.station[i].value);
	snprintf(key, sizeof key, "tension.%s", hawser_given_name(sweep));
	return cli_axis(key, cli_irvine_si(sweep), largest);
}

/* Axis of the frequencies. */
static struct hawser__axis ordinate(const struct cli_irvine_result *result)
{
	static const struct {
		const char *quantity, *si;
	} of[] = {
		[CLI_NORMALISED] = {"Frequency {/:Italic ω} / {/:Italic ω}_{string}", ""},
		[CLI_RAD_S] = {"Frequency {/:Italic ω}", "rad/s"}, [CLI_HZ] = {"Frequency", "Hz"},
		[CLI_PERIOD] = {"Period", "s"}};

	return hawser__axis_of(of[result->unit].quantity, of[result->unit].si, 0.0);
}

/* Frequency at which a crossover is marked on the branch with that number: offset from the middle
 * of the gap by `part` of the gap. */
static double mark_on(const struct cli_irvine_result *result, const struct hawser_irvine *irvine,
                      const struct hawser_irvine_crossover *at, int number, double part)
{
	return number > irvine->in_plane
		? NAN : cli_irvine_in_unit(result, at->omega + part*at->gap, at->H);
}

/* What the picture shows, in its units; [] as in struct hawser__diagram. */
struct arrays {
	double *x, *y, *overlay, *mark_x, *mark_y;
	int *veers;
	char note[HAWSER__MARKUP_SIZE + 40];
};

static void fill(struct arrays *to, const struct cli_irvine_result *result,
                 const struct cli_irvine_sweep *sweep, double per, double per_y)
{
	const struct hawser_irvine *irvine = &sweep->irvine;
	int i, b;

	for (i = 0; i < irvine->stations; i++) {
		double H = cli_irvine_tension(&irvine->station[i]);

		to->x[i] = (result->over_value ? irvine->station[i].value
		                               : irvine->station[i].statics.irvine_source)/per;
		for (b = 0; b < irvine->branches; b++)
			to->y[i*irvine->branches + b] =
				cli_irvine_in_unit(result, irvine->omega[i*irvine->branches + b], H)/per_y;
		for (b = 0; b < sweep->overlays; b++)
			to->overlay[i*sweep->overlays + b] =
				cli_irvine_in_unit(result, sweep->analytic[i*sweep->overlays + b], H)/
				per_y;
	}
	for (i = 0; i < irvine->crossovers; i++) {
		const struct hawser_irvine_crossover *at = &irvine->crossover[i];

		to->mark_x[i] = (result->over_value ? at->value : at->irvine_source)/per;
		to->mark_y[2*i] = mark_on(result, irvine, at, at->below, -0.5)/per_y;
		to->mark_y[2*i + 1] = mark_on(result, irvine, at, at->above, 0.5)/per_y;
		to->veers[i] = at->kind == HAWSER_VEERING;
	}
}

static void release(struct arrays *from)
{
	free(from->x);
	free(from->veers);
}

static enum hawser_status allocate(struct arrays *to, const struct cli_irvine_sweep *sweep,
                                   struct hawser_report *report)
{
	size_t stations = (size_t)sweep->irvine.stations, marks = (size_t)sweep->irvine.crossovers;
	size_t branches = (size_t)sweep->irvine.branches, overlays = (size_t)sweep->overlays;

	to->x = calloc(stations*(1 + branches + overlays) + 3*marks, sizeof *to->x);
	to->veers = calloc(marks + 1, sizeof *to->veers);
	if (!to->x || !to->veers)
		return hawser__no_memory(report, "irvine");
	to->y = to->x + stations;
	to->overlay = to->y + stations*branches;
	to->mark_x = to->overlay + stations*overlays;
	to->mark_y = to->mark_x + marks;
	return HAWSER_OK;
}

static struct hawser__diagram diagram_of(const struct arrays *from,
                                         const struct cli_irvine_result *result,
                                         const struct cli_irvine_sweep *sweep,
                                         const struct hawser__axis *x, const struct hawser__axis *y)
{
	const struct hawser_irvine *irvine = &sweep->irvine;

	return (struct hawser__diagram){
		.stations = irvine->stations, .branches = irvine->branches,
		.in_plane = irvine->in_plane, .overlays = sweep->overlays, .marks = irvine->crossovers,
		.x_title = x->title, .y_title = y->title,
		.logarithmic = !result->over_value || irvine->sweep != HAWSER_GIVEN_LENGTH0,
		.note = from->note, .x = from->x, .y = from->y,
		.overlay = from->overlay, .mark_x = from->mark_x, .mark_y = from->mark_y,
		.veers = from->veers};
}

enum hawser_status cli_irvine_draw(const char *path, const void *context,
                                   struct hawser_report *report)
{
	const struct cli_irvine_result *result = context;
	struct hawser__diagram diagram[CLI_IRVINE_SPEEDS];
	struct arrays arrays[CLI_IRVINE_SPEEDS] = {{0}};
	enum hawser_status status = HAWSER_OK;
	const struct hawser__axis x = abscissa(result), y = ordinate(result);
	const struct hawser__axis speed = hawser__axis_of("", "m/s", 0.0);
	int k;

	for (k = 0; k < result->sweeps && !status; k++) {
		status = allocate(&arrays[k], &result->sweep[k], report);
		if (status)
			break;
		fill(&arrays[k], result, &result->sweep[k], x.per, y.per);
		if (result->moving)
			snprintf(arrays[k].note, sizeof arrays[k].note, "{/:Italic v} = %.6g %s",
			         result->sweep[k].irvine.speed/speed.per, speed.unit);
		diagram[k] = diagram_of(&arrays[k], result, &result->sweep[k], &x, &y);
	}
	if (!status)
		status = hawser__plot_irvine(path, diagram, result->sweeps, report);
	for (k = 0; k < result->sweeps; k++)
		release(&arrays[k]);
	return status;
}

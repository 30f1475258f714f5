/* cli/modes/irvine_draw.c - the picture of a sweep: conversion of frequencies to the requested
 * unit, and the frequencies of the analytic method for comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/modes/modes_result.h"
#include "core/report.h"
#include "output/drawing/figure.h"

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

/* Abscissa of a station. */
static double place_of(const struct cli_irvine_result *result,
                       const struct hawser_irvine_station *station)
{
	return result->over_value ? station->value : station->statics.irvine_source;
}

/* The largest of the frequencies shown, and the range of the abscissa, of all panels. */
static void measure(double *low, double *high, double *top, const struct cli_irvine_result *result)
{
	*low = INFINITY;
	*high = *top = 0.0;
	for (int k = 0; k < result->sweeps; k++) {
		const struct hawser_irvine *irvine = &result->sweep[k].irvine;

		for (int i = 0; i < irvine->stations; i++) {
			double x = place_of(result, irvine->station + i);
			double H = cli_irvine_tension(irvine->station + i);

			*low = fmin(*low, x);
			*high = fmax(*high, x);
			for (int b = 0; b < irvine->branches; b++)
				*top = fmax(*top, cli_irvine_in_unit(
					result, irvine->omega[i*irvine->branches + b], H));
		}
	}
}

static void put_branch(struct hawser__figure *figure, const struct cli_irvine_result *result,
                       const struct hawser_irvine *irvine, const double *omega, int stride)
{
	for (int i = 0; i < irvine->stations; i++)
		hawser__figure_put(figure, place_of(result, irvine->station + i), cli_irvine_in_unit(
			result, omega[i*stride], cli_irvine_tension(&irvine->station[i])));
}

/* The place of the scene itself, where it is within the range. */
static void draw_own(struct hawser__figure *figure, const struct cli_irvine_result *result,
                     const struct hawser_irvine *irvine, double top)
{
	const struct hawser_irvine_station own = {
		.statics = result->own, .value = hawser_irvine_value(&result->own, irvine->sweep)};
	double x = place_of(result, &own), a = place_of(result, irvine->station);
	double b = place_of(result, irvine->station + irvine->stations - 1);

	if (!(result->own.H > 0.0) || (x - a)*(x - b) > 0.0)
		return;
	hawser__figure_put(figure, x, 0.0);
	hawser__figure_put(figure, x, top);
	hawser__figure_draw(figure, "the scene", "with lines lt 7 lw 1.2");
}

/* A point on each of the two branches where they are closest. */
static void put_crossovers(struct hawser__figure *figure, const struct cli_irvine_result *result,
                           const struct hawser_irvine *irvine, int veers)
{
	for (int k = 0; k < irvine->crossovers; k++) {
		const struct hawser_irvine_crossover *at = &irvine->crossover[k];
		double x = result->over_value ? at->value : at->irvine_source;

		if ((at->kind == HAWSER_VEERING) != veers)
			continue;
		hawser__figure_gap(figure);
		if (at->below <= irvine->in_plane)
			hawser__figure_put(figure, x, cli_irvine_in_unit(result, at->omega - 0.5*at->gap, at->H));
		if (at->above <= irvine->in_plane)
			hawser__figure_put(figure, x, cli_irvine_in_unit(result, at->omega + 0.5*at->gap, at->H));
	}
}

/* Branches of the two planes often coincide: a thin line is drawn on a thick one. */
static void draw_panel(struct hawser__figure *figure, const struct cli_irvine_result *result,
                       const struct cli_irvine_sweep *sweep, double top)
{
	const struct hawser_irvine *irvine = &sweep->irvine;

	draw_own(figure, result, irvine, top);
	put_crossovers(figure, result, irvine, 1);
	hawser__figure_draw(figure, NULL, "with lines lt 7 lw 0.8 dt (2,3)");
	hawser__legend_once(&figure->legend, "in plane", "with lines lt 1 lw 2.2");
	hawser__legend_once(&figure->legend, "out of plane", "with lines lt 2 lw 1.1");
	for (int b = 0; b < irvine->branches; b++) {
		put_branch(figure, result, irvine, irvine->omega + b, irvine->branches);
		hawser__figure_draw(figure, NULL, b < irvine->in_plane ? "with lines lt 1 lw 2.2"
		                                                       : "with lines lt 2 lw 1.1");
	}
	for (int b = 0; b < sweep->overlays; b++) {
		put_branch(figure, result, irvine, sweep->analytic + b, sweep->overlays);
		hawser__figure_draw(figure, "analytic", "with lines lt 7 lw 1.0 dt (14,12)");
	}
	put_crossovers(figure, result, irvine, 0);
	hawser__figure_draw(figure, NULL, "with points pt 7 ps 1.0 lc rgb 'white'");
	hawser__figure_again(figure, "crossing", HAWSER__CROSSING);
	put_crossovers(figure, result, irvine, 1);
	hawser__figure_draw(figure, "veering", HAWSER__VEERING);
}

/* A panel for each speed, in a grid filled row by row; axes have titles in the left column and in the
 * bottom row only. */
enum hawser_status cli_irvine_draw(const char *path, const void *context,
                                   struct hawser_report *report)
{
	static const int columns_of[CLI_IRVINE_SPEEDS + 1] = {1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 4, 4, 4};
	const double logarithmic_from = 5.0; /* ratio of the ends: in a smaller range may be no tic */
	const struct cli_irvine_result *result = context;
	const struct hawser__axis x = abscissa(result), y = ordinate(result);
	const struct hawser__axis speed = hawser__axis_of("", "m/s", 0.0);
	int count = result->sweeps, columns = columns_of[count], rows = (count + columns - 1)/columns;
	double width = columns == 1 ? 16.0 : 8.5*columns, low, high, top;
	double height = columns == 1 ? 12.5 : 6.5*rows + 2.3, foot = HAWSER__LEGEND_CM/height;
	double margin = 0.13*16.0/width, wide = (0.985 - margin)/columns, tall = (0.985 - foot)/rows;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, width, height, report);

	if (status)
		return status;
	measure(&low, &high, &top, result);
	for (int k = 0; k < count; k++) {
		int above = rows - 1 - k/columns;
		double left = margin + k % columns*wide, bottom = foot + above*tall;
		int logarithmic = (!result->over_value ||
		                   result->sweep->irvine.sweep != HAWSER_GIVEN_LENGTH0) &&
		                  high > logarithmic_from*low;

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){
			left, count == 1 ? 0.97 : left + 0.9*wide,
			bottom, count == 1 ? 0.97 : bottom + 0.86*tall, .aside = 0.107*16.0/width,
			.x = {&x, low, high, .logarithmic = 2*logarithmic, .tics = count == 1 ? 8 : 5,
			      .untitled = k + columns < count},
			.y = {&y, 0.0, 1.04*top, .tics = 9, .untitled = k % columns > 0}});
		if (result->moving)
			fprintf(figure.out.script,
			        "set label '{/:Italic v} = %.6g %s' at graph 0.97,0.06 right front\n",
			        result->sweep[k].irvine.speed/speed.per, speed.unit);
		draw_panel(&figure, result, &result->sweep[k], 1.04*top);
	}
	return hawser__figure_finish(&figure, report);
}

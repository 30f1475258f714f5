/* cli/curves/locus_draw.c - the picture of `locus`: its curves in the plane of both parameters; every
 * special point has its name beside it, where no other name is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/curves/locus_result.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/figure.h"

struct picture {
	const struct hawser_locus *locus;
	struct hawser__axis axis[2];
	double per_omega;      /* what is put, per frequency of the model */
	double from[2], to[2]; /* ends of the axes, as put */
};

/* A name, in parts of the panel. */
struct name {
	const char *text;
	double x, y, left, low;
};
#define LETTER 0.0125 /* width of a letter, in parts of the panel */
#define LINE 0.036    /* height of a name */
#define ASIDE 0.009   /* distance of a name from its point */
enum { PARTS = 6 };   /* of a step of a curve, as points that a name may cover */

static double right_of(const struct name *name)
{
	return name->left + LETTER*(double)strlen(name->text);
}

static int is_free(const struct name *name, const struct name *other, int count)
{
	if (name->left < 0.0 || right_of(name) > 1.0 || name->low < 0.0 || name->low + LINE > 1.0)
		return 0;
	for (int k = 0; k < count; k++)
		if (name->left < right_of(&other[k]) && other[k].left < right_of(name) &&
		    fabs(name->low - other[k].low) < LINE)
			return 0;
	return 1;
}

/* The point in parts of the panel. */
static void panel_place(double at[2], const struct picture *picture, double omega,
                        double parameter)
{
	double value[2] = {omega*picture->per_omega, parameter};

	for (int k = 0; k < 2; k++)
		at[k] = (value[k] - picture->from[k])/(picture->to[k] - picture->from[k]);
}

static int is_in(const struct name *name, const double at[2])
{
	return at[0] > name->left && at[0] < right_of(name) && at[1] > name->low &&
	       at[1] < name->low + LINE;
}

/* From the point to the name. */
static double distance(const struct name *name, const double at[2])
{
	double x = fmax(fmax(name->left - at[0], at[0] - right_of(name)), 0.0);
	double y = fmax(fmax(name->low - at[1], at[1] - name->low - LINE), 0.0);

	return hypot(x, y);
}

/* How much of the picture the name covers, and of how many points it may seem to be the name. */
static int covered(const struct name *name, const struct picture *picture)
{
	const struct hawser_locus *locus = picture->locus;
	int count = 0;

	for (int c = 0; c < locus->curves; c++)
		for (int i = 1; i < locus->curve[c].points; i++) {
			const struct hawser_locus_point *point = &locus->point[locus->curve[c].first + i];
			double a[2], b[2];

			panel_place(a, picture, point[-1].omega, point[-1].parameter);
			panel_place(b, picture, point->omega, point->parameter);
			for (int k = 0; k < PARTS; k++) {
				double s = (double)k/PARTS;
				double at[2] = {a[0] + s*(b[0] - a[0]), a[1] + s*(b[1] - a[1])};

				count += is_in(name, at);
			}
		}
	for (int e = 0; e < locus->events; e++) {
		const double own[2] = {name->x, name->y};
		double at[2];

		panel_place(at, picture, locus->event[e].omega, locus->event[e].parameter);
		if (locus->event[e].kind != HAWSER_LOCUS_START)
			count += PARTS*(is_in(name, at) + 2*(distance(name, at) < distance(name, own)));
	}
	return count;
}

/* Beside the point, above or below it: where it covers least. */
static void place_name(struct name *name, const struct name *other, int count,
                       const struct picture *picture)
{
	static const double rise[] = {0.0, -1.0, -0.5, 0.4, -1.4, 1.4, -2.4, 2.4}; /* lines */
	double width = LETTER*(double)strlen(name->text);
	struct name best = *name;
	int least = INT_MAX;

	best.left = name->x + ASIDE;
	best.low = name->y;
	for (size_t level = 0; level < sizeof rise/sizeof *rise; level++)
		for (int side = 0; side < 3; side++) {
			const double left[] = {name->x + ASIDE, name->x - ASIDE - width, name->x - 0.5*width};
			int cost;

			name->left = left[side];
			name->low = name->y + rise[level]*LINE;
			cost = covered(name, picture) + (int)(2*level) + side;
			if (cost < least && is_free(name, other, count)) {
				least = cost;
				best = *name;
			}
		}
	*name = best;
}

static enum hawser_status names(FILE *script, const struct picture *picture,
                                struct hawser_report *report)
{
	const struct hawser_locus *locus = picture->locus;
	struct name *name = malloc(((size_t)locus->events + 1)*sizeof *name);
	int count = 0;

	if (!name)
		return hawser__no_memory(report, "plot");
	for (int e = 0; e < locus->events; e++) {
		const struct hawser_locus_event *event = &locus->event[e];
		struct name *at = &name[count];
		int again = event->kind == HAWSER_LOCUS_START;
		double place[2];

		panel_place(place, picture, event->omega, event->parameter);
		*at = (struct name){.text = hawser_locus_special_name(locus->kind, event->kind),
			.x = place[0], .y = place[1]};
		for (int k = 0; k < count; k++) /* the same point of another curve, nearly */
			again |= at->text == name[k].text &&
			         hypot(at->x - name[k].x, at->y - name[k].y) < 2.0*ASIDE;
		if (again)
			continue;
		place_name(at, name, count, picture);
		fprintf(script, "set label \"%s\" at graph %.6g,%.6g left\n", at->text, at->left,
		        at->low + 0.5*LINE);
		count++;
	}
	free(name);
	return HAWSER_OK;
}

/* The line of the value where the search began, the curves, and the special points. */
static void draw_curves(struct hawser__figure *figure, const struct picture *of)
{
	const struct hawser_locus *locus = of->locus;

	hawser__legend_once(&figure->legend, hawser_event_name(locus->kind), "with lines lt 1");
	hawser__figure_function(figure, "begun here", "%.12g with lines lc rgb '#404040' lw 0.8 dt (4,4)",
	                        locus->at/of->axis[1].per);
	for (int c = 0; c < locus->curves; c++) {
		const struct hawser_locus_point *point = locus->point + locus->curve[c].first;

		for (int i = 0; i < locus->curve[c].points; i++)
			hawser__figure_put(figure, point[i].omega*of->per_omega, point[i].parameter);
		hawser__figure_draw(figure, NULL, "with lines lt 1");
	}
	for (int e = 0; e < locus->events; e++)
		if (locus->event[e].kind != HAWSER_LOCUS_START)
			hawser__figure_put(figure, locus->event[e].omega*of->per_omega, locus->event[e].parameter);
	hawser__figure_draw(figure, "special points", "with points pt 7 ps 0.6 lc rgb '#D55E00'");
}

enum hawser_status cli_locus_draw(const char *path, const void *context,
                                  struct hawser_report *report)
{
	const struct cli_locus_result *result = context;
	const struct hawser_locus *locus = result->locus;
	struct picture picture = {.locus = locus};
	struct hawser__figure figure = {0};
	enum hawser_status status;

	picture.axis[0] = result->first ? cli_axis(result->first, result->first_unit,
	                                           fmax(fabs(result->from), fabs(result->to)))
	                  : cli_frf_axis(result->model);
	picture.axis[1] = cli_axis(result->key, result->unit, fmax(fabs(result->parameter_from),
	                                                           fabs(result->parameter_to)));
	picture.per_omega = result->first ? 1.0 : cli_per_omega(result->model);
	picture.from[0] = fmin(result->from, result->to)*picture.per_omega;
	picture.to[0] = fmax(result->from, result->to)*picture.per_omega;
	picture.from[1] = fmin(result->parameter_from, result->parameter_to);
	picture.to[1] = fmax(result->parameter_from, result->parameter_to);
	status = hawser__figure_begin(&figure, path, 17.0, 12.8, report);
	if (status)
		return status;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.965, 0.25, 0.97,
		.x = {&picture.axis[0], picture.from[0], picture.to[0], .tics = 10},
		.y = {&picture.axis[1], picture.from[1], picture.to[1], .tics = 8}});
	status = names(figure.out.script, &picture, report);
	draw_curves(&figure, &picture);
	if (!status)
		return hawser__figure_finish(&figure, report);
	hawser__figure_abort(&figure);
	return status;
}

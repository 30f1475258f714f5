/* output/plot_locus.c - loci of bifurcations in the plane of two parameters; every special point has
 * its name beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/plot_locus.h"
#include "output/style.h"

static const char start_style[] = "lc rgb '#404040' lw 0.8 dt (4,4)";

static void curve_data(FILE *script, const struct hawser__locus_picture *picture, int c)
{
	const struct hawser_locus *locus = picture->locus;
	const struct hawser_locus_curve *curve = &locus->curve[c];

	fprintf(script, "$curve%d << END\n", c);
	for (int i = curve->first; i < curve->first + curve->points; i++)
		fprintf(script, "%.12g %.12g\n", locus->point[i].omega*picture->per_omega,
		        locus->point[i].parameter/picture->axis[1].per);
	fputs("NaN NaN\nEND\n", script);
}

static int mark_data(FILE *script, const struct hawser__locus_picture *picture)
{
	const struct hawser_locus *locus = picture->locus;
	int count = 0;

	fputs("$marks << END\n", script);
	for (int e = 0; e < locus->events; e++) {
		const struct hawser_locus_event *event = &locus->event[e];

		if (event->kind == HAWSER_LOCUS_START)
			continue;
		fprintf(script, "%.12g %.12g \"%s\"\n", event->omega*picture->per_omega,
		        event->parameter/picture->axis[1].per,
		        hawser_locus_special_name(locus->kind, event->kind));
		count++;
	}
	fputs("NaN NaN \"\"\nEND\n", script);
	return count;
}

enum hawser_status hawser__plot_locus(const char *path, const struct hawser__locus_picture *of,
                                      struct hawser_report *report)
{
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 12.8, report);
	FILE *script = picture.script;
	int marks;

	if (status)
		return status;
	for (int c = 0; c < of->locus->curves; c++)
		curve_data(script, of, c);
	marks = mark_data(script, of);
	hawser__picture_panel(&picture, 0.13, 0.965, 0.25, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n", of->from[0], of->to[0],
	        of->from[1], of->to[1]);
	hawser__picture_tics(&picture, 'x', of->from[0], of->to[0], 10);
	hawser__picture_tics(&picture, 'y', of->from[1], of->to[1], 8);
	fprintf(script, "set xlabel '%s'\n", of->axis[0].title);
	hawser__picture_ylabel(&picture, "%s", of->axis[1].title);
	fprintf(script, "plot %.12g with lines %s", of->locus->at/of->axis[1].per, start_style);
	for (int c = 0; c < of->locus->curves; c++)
		fprintf(script, ", $curve%d with lines lt 1", c);
	fputs(", $marks with points pt 7 ps 0.6 lc rgb '#D55E00', $marks using 1:2:3 with labels left "
	      "offset char 0.6,0.5\n", script);
	hawser__legend_add(&entries, hawser_event_name(of->locus->kind), "with lines lt 1");
	hawser__legend_add(&entries, "begun here", "with lines %s", start_style);
	if (marks)
		hawser__legend_add(&entries, "special points", "with points pt 7 ps 0.6 lc rgb '#D55E00'");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

/* output/cable/plot_identify.c - differences of computed from measured frequencies: above those
 * of the scene as given, below those of the fitted one with the deviations of the measurements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static const char *const style[] = {"lt 1 pt 7 ps 0.7", "lt 2 pt 6 ps 0.8"};
static const char *const title[] = {"in-plane", "out-of-plane"};

static void data(FILE *script, const struct hawser__identified *row, int rows)
{
	for (int plane = 0; plane < 2; plane++) {
		fprintf(script, "$plane%d << END\nNaN NaN NaN NaN\n", plane);
		for (int i = 0; i < rows; i++)
			if (row[i].plane == plane)
				fprintf(script, "%.9g %.9g %.9g %.9g\n", row[i].frequency,
				        100.0*row[i].before, 100.0*row[i].after,
				        isnan(row[i].deviation) ? 0.0 : 100.0*row[i].deviation);
		fputs("END\n", script);
	}
}

/* A range about 0 with room at both sides. */
static void range(struct hawser__picture *picture, const struct hawser__identified *row, int rows,
                  int after)
{
	double most = 0.0;

	for (int i = 0; i < rows; i++) {
		double value = fabs(after ? row[i].after : row[i].before);

		if (isfinite(value))
			most = fmax(most, value);
		if (after && isfinite(row[i].deviation))
			most = fmax(most, fabs(row[i].after) + row[i].deviation);
	}
	most = most > 0.0 ? 1.15*100.0*most : 1.0;
	fprintf(picture->script, "set yrange [%.9g:%.9g]\n", -most, most);
	hawser__picture_tics(picture, 'y', -most, most, 6);
}

static void points(FILE *script, int after)
{
	fputs("plot 0 with lines lc rgb '#909090' lw 1", script);
	for (int plane = 0; plane < 2; plane++)
		if (after)
			fprintf(script, ", $plane%d using 1:3:4 with yerrorbars %s", plane, style[plane]);
		else
			fprintf(script, ", $plane%d using 1:2 with points %s", plane, style[plane]);
	fputc('\n', script);
}

enum hawser_status hawser__plot_identify(const char *path, const struct hawser__identified *row,
                                         int rows, const char *x_title,
                                         struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 12.8, report);
	struct hawser__legend entries = {0};
	FILE *script = picture.script;
	double low = INFINITY, high = 0.0;

	if (status)
		return status;
	data(script, row, rows);
	for (int i = 0; i < rows; i++) {
		low = fmin(low, row[i].frequency);
		high = fmax(high, row[i].frequency);
	}
	fprintf(script, "set xrange [%.9g:%.9g]\nset format x ''\n", 0.9*low, high + 0.1*low);
	hawser__picture_tics(&picture, 'x', low, high, 8);
	range(&picture, row, rows, 0);
	hawser__picture_panel(&picture, 0.14, 0.97, 0.63, 0.97);
	hawser__picture_ylabel(&picture, "As given (%%)");
	points(script, 0);
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", x_title);
	range(&picture, row, rows, 1);
	hawser__picture_panel(&picture, 0.14, 0.97, 0.235, 0.575);
	hawser__picture_ylabel(&picture, "Fitted (%%)");
	points(script, 1);
	for (int plane = 0; plane < 2; plane++)
		hawser__legend_add(&entries, title[plane], "with points %s", style[plane]);
	hawser__legend_add(&entries, "bars: standard deviation", "with lines lt 7 lw 1");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

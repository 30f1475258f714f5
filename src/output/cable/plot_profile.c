/* output/cable/plot_profile.c - see plot_profile.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/cable/plot_profile.h"
#include "output/drawing/style.h"

enum { MOST = 150 }; /* points of a curve, so that files stay small, and dashes visible */
static const char *const colours[] = {"black", "#0072B2", "#8C564B", "#009E73", "#56B4E9", "#D55E00",
                                      "#E69F00", "#CC79A7", "#7F7F7F"};
enum { COLOURS = sizeof colours/sizeof *colours };

static int solved(const struct hawser__profile *of, int c, int by)
{
	int count = 0;

	while (count < of->problems && isfinite(of->curve[c].value[by][count]))
		count++;
	return count;
}

/* The end of the axis: the next power of ten above all values. */
static double end_of(const struct hawser__profile *of, int by)
{
	double most = 1.0;

	for (int c = 0; c < of->curves; c++) {
		int count = solved(of, c, by);

		if (count > 0)
			most = fmax(most, of->curve[c].value[by][count - 1]);
	}
	return pow(10.0, fmax(ceil(log10(most) + 0.01), 1.0));
}

/* Corners of a stair, from 1 to the end of the axis. */
static void data(FILE *script, const struct hawser__profile *of, int c, int by, double end)
{
	const double *value = of->curve[c].value[by];
	int count = solved(of, c, by), step = 1 + count/MOST;

	fprintf(script, "$curve%d_%d << END\n", by, c);
	if (count == 0 || value[0] > 1.0)
		fputs("1 0\n", script);
	for (int i = 0; i < count; i++)
		if (i == count - 1 || (value[i + 1] > value[i] && (i % step == 0 || value[i] <= 1.0)))
			fprintf(script, "%.7g %.6g\n", value[i], 100.0*(i + 1)/of->problems);
	fprintf(script, "%.7g %.6g\nEND\n", end, 100.0*count/of->problems);
}

static void plot(FILE *script, const struct hawser__profile *of, int by)
{
	fputs("plot ", script);
	for (int c = 0; c < of->curves; c++) {
		const struct hawser__profile_curve *curve = &of->curve[c];

		fprintf(script, "%s$curve%d_%d using 1:2 with steps lw %g lc rgb '%s'%s", c ? ", " : "", by, c,
		        curve->colour ? 1.6 : 3.0, colours[curve->colour % COLOURS],
		        curve->dashed ? " dt (6,4)" : "");
	}
	fputs("\n", script);
}

enum hawser_status hawser__plot_profile(const char *path, const struct hawser__profile *of,
                                        struct hawser_report *report)
{
	static const char *const title[] = {"Processor time, over that of the fastest",
	                                    "Number of iterations"};
	static const double width = 17.0, tall = 7.6; /* cm */
	struct hawser__legend legend = {0};
	struct hawser__picture picture;
	double bottom, height;
	enum hawser_status status;

	for (int c = 0; c < of->curves; c++) {
		const struct hawser__profile_curve *curve = &of->curve[c];
		char label[80];

		snprintf(label, sizeof label, "%s: %.1f %%", curve->label,
		         of->problems > 0 ? 100.0*solved(of, c, 1)/of->problems : 0.0);
		hawser__legend_add(&legend, label, "with lines lw %g lc rgb '%s'%s", curve->colour ? 1.6 : 3.0,
		                   colours[curve->colour % COLOURS], curve->dashed ? " dt (6,4)" : "");
	}
	bottom = hawser__legend_cm(&legend, width);
	height = bottom + tall + 0.4;
	status = hawser__picture_begin(&picture, path, width, height, report);
	if (status)
		return status;
	fputs("unset key\nset yrange [0:103]\nset ytics 20\n", picture.script);
	for (int by = of->timed ? 0 : 1; by < 2; by++) {
		double end = end_of(of, by), left = by && of->timed ? 0.6 : 0.14;

		for (int c = 0; c < of->curves; c++)
			data(picture.script, of, c, by, end);
		hawser__picture_panel(&picture, left, by ? 0.97 : 0.53, bottom/height, 1.0 - 0.4/height);
		if (by == !of->timed)
			hawser__picture_ylabel(&picture, "%s (%%)", of->unit);
		fprintf(picture.script, "set logscale x\nset xrange [1:%g]\nset xlabel '%s'\n", end, title[by]);
		hawser__picture_log_tics(&picture, "x", 1.0, end, 30.0);
		plot(picture.script, of, by);
	}
	hawser__legend_draw(&picture, &legend);
	return hawser__picture_finish(&picture, report);
}

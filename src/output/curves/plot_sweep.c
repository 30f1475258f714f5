/* output/curves/plot_sweep.c - results over a varied key: a panel for each quantity, one below the
 * other, a colour for each curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/curves/plot_sweep.h"
#include "output/drawing/style.h"

static const double width = 16.0, single = 7.0, stacked = 4.6; /* cm, of a panel */

static void data(FILE *script, const struct hawser__sweep_picture *of)
{
	for (int p = 0; p < of->panels; p++)
		for (int c = 0; c < of->curves; c++) {
			const double *y = of->y + (size_t)(p*of->curves + c)*(size_t)of->points;

			fprintf(script, "$c%d_%d << END\nNaN NaN\n", p, c);
			for (int i = 0; i < of->points; i++)
				if (isfinite(y[i]))
					fprintf(script, "%.12g %.12g\n", of->x[i], y[i]);
			fputs("END\n", script);
		}
}

static void abscissa(FILE *script, const struct hawser__sweep_picture *of,
                     struct hawser__picture *picture)
{
	double low = of->x[0], high = of->x[of->points - 1];

	if (!(high > low)) {
		double part = fmax(0.05*fabs(low), 1e-9);

		low -= part;
		high += part;
	}
	fprintf(script, "set xrange [%.12g:%.12g]\nset format x '%%g'\n", low, high);
	if (of->logarithmic && low > 0.0)
		hawser__picture_log_tics(picture, "x", low, high, 30.0);
	else
		hawser__picture_tics(picture, 'x', low, high, 8);
}

/* The range of the values, a little wider; one value alone gets one too. */
static void ordinate(struct hawser__picture *picture, const struct hawser__sweep_picture *of, int p)
{
	size_t count = (size_t)of->curves*(size_t)of->points;
	const double *y = of->y + (size_t)p*count;
	double low = INFINITY, high = -INFINITY, part;

	for (size_t i = 0; i < count; i++)
		if (isfinite(y[i])) {
			low = fmin(low, y[i]);
			high = fmax(high, y[i]);
		}
	if (!(high >= low))
		low = high = 0.0;
	/* what varies by round-off alone is drawn as a straight line */
	part = high - low > 1e-9*fmax(fabs(high), fabs(low)) ? 0.06*(high - low)
	                                                     : fmax(0.05*fabs(high), 1e-12);
	fprintf(picture->script, "set yrange [%.12g:%.12g]\nset format y '%%g'\n", low - part, high + part);
	hawser__picture_tics(picture, 'y', low - part, high + part, of->panels == 1 ? 7 : 4);
}

static void curves(FILE *script, const struct hawser__sweep_picture *of, int p)
{
	for (int c = 0; c < of->curves; c++)
		fprintf(script, "%s$c%d_%d with linespoints lt %d lw 1.3%s pt 7 ps %s", c ? ", " : "plot ", p,
		        c, c % 6 + 1, c < 6 ? "" : " dt (8,5)", of->points > 40 ? "0.25" : "0.5");
	fputc('\n', script);
}

enum hawser_status hawser__plot_sweep(const char *path, const struct hawser__sweep_picture *of,
                                      struct hawser_report *report)
{
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	double foot, tall = of->panels == 1 ? single : stacked, height;
	enum hawser_status status;

	for (int c = 0; c < of->curves; c++)
		if (*of->label[c])
			hawser__legend_add(&entries, of->label[c], "with linespoints lt %d lw 1.3%s pt 7 ps 0.5",
			                   c % 6 + 1, c < 6 ? "" : " dt (8,5)");
	foot = entries.count ? hawser__legend_cm(&entries, width) : 1.7;
	height = foot + of->panels*tall + 0.3;
	status = hawser__picture_begin(&picture, path, width, height, report);
	if (status)
		return status;
	data(picture.script, of);
	for (int p = 0; p < of->panels; p++) {
		double bottom = foot + (of->panels - 1 - p)*tall;
		int lowest = p + 1 == of->panels;

		hawser__picture_panel(&picture, 0.135, 0.965, bottom/height,
		                      (bottom + tall - (lowest && p == 0 ? 0.0 : 0.35))/height);
		hawser__picture_ylabel(&picture, "%s", of->y_title[p]);
		ordinate(&picture, of, p);
		if (lowest)
			fprintf(picture.script, "set xlabel '%s' offset 0,0.2\n", of->x_title);
		abscissa(picture.script, of, &picture);
		if (!lowest)
			fputs("set format x ''\n", picture.script);
		curves(picture.script, of, p);
	}
	if (entries.count)
		hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

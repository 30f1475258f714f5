/* output/curves/plot_motions.c - see plot_motions.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/curves/plot_motions.h"
#include "output/drawing/figure.h"

enum { MOST = 4000 }; /* points of a curve, so that files stay small */
static const char *const colours[] = {"black", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00",
                                      "#56B4E9"};
enum { COLOURS = sizeof colours/sizeof *colours };

/* Every so many rows; of a band the largest value between. */
static void put_curve(struct hawser__figure *figure, const struct hawser__motions *of,
                      const struct hawser__motion_panel *panel,
                      const struct hawser__motion_curve *curve)
{
	int step = 1 + of->rows/MOST;

	for (int i = 0; i < of->rows; i += step) {
		double value = curve->value[(size_t)i*(size_t)panel->stride];

		for (int j = i; curve->colour < 0 && j < i + step && j < of->rows; j++)
			value = fmax(fabs(value), fabs(curve->value[(size_t)j*(size_t)panel->stride]));
		if (curve->colour < 0)
			hawser__figure_row(figure, "xyy", (double[]){of->time[i], -value, value});
		else
			hawser__figure_row(figure, "xy", (double[]){of->time[i], value});
	}
	if (curve->colour < 0) {
		hawser__figure_draw(figure, NULL, "using 1:2:3 with filledcurves lc rgb '#CCCCCC'");
		hawser__legend_once(&figure->legend, curve->label, "with lines lw 6 lc rgb '#CCCCCC'");
	} else {
		hawser__figure_draw(figure, curve->label, "with lines lw %g lc rgb '%s'",
		                    curve->colour ? 1.2 : 3.0, colours[curve->colour % COLOURS]);
	}
}

enum hawser_status hawser__plot_motions(const char *path, const struct hawser__motions *of,
                                        struct hawser_report *report)
{
	static const double tall = 4.2, gap = 0.7, bottom = HAWSER__LEGEND_CM; /* cm */
	double height = bottom + tall*of->panels - gap + 0.4;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, height, report);

	if (status)
		return status;
	for (int p = 0; p < of->panels; p++) {
		double low = (bottom + tall*(of->panels - 1 - p))/height;

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, low,
			low + (tall - gap)/height,
			.x = {&of->axis, of->time[0], of->time[of->rows - 1], .bare = p < of->panels - 1},
			.y = {.axis = &of->panel[p].axis, .tics = 6, .room = 0.04}});
		for (int c = 0; c < of->panel[p].curves; c++)
			put_curve(&figure, of, &of->panel[p], &of->panel[p].curve[c]);
	}
	return hawser__figure_finish(&figure, report);
}

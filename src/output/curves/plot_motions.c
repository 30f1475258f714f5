/* output/curves/plot_motions.c - see plot_motions.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/curves/plot_motions.h"
#include "output/drawing/style.h"

enum { MOST = 4000 }; /* points of a curve, so that files stay small */
static const char *const colours[] = {"black", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00",
                                      "#56B4E9"};
enum { COLOURS = sizeof colours/sizeof *colours };

/* Every so many rows; of a band the largest value between. */
static void data(FILE *script, const struct hawser__motions *of,
                 const struct hawser__motion_panel *panel, int number)
{
	int step = 1 + of->rows/MOST;

	fprintf(script, "$panel%d << END\n", number);
	for (int i = 0; i < of->rows; i += step) {
		fprintf(script, "%.9g", of->time[i]/of->axis.per);
		for (int c = 0; c < panel->curves; c++) {
			const struct hawser__motion_curve *curve = &panel->curve[c];
			double value = curve->value[(size_t)i*(size_t)panel->stride];

			for (int j = i; curve->colour < 0 && j < i + step && j < of->rows; j++)
				value = fmax(fabs(value), fabs(curve->value[(size_t)j*(size_t)panel->stride]));
			fprintf(script, " %.7g", value/panel->per);
		}
		fputs("\n", script);
	}
	fputs("END\n", script);
}

static void legend_of(struct hawser__legend *legend, const struct hawser__motion_panel *panel)
{
	for (int c = 0; c < panel->curves; c++) {
		const struct hawser__motion_curve *curve = &panel->curve[c];
		int known = !*curve->label;

		for (int i = 0; i < legend->count; i++)
			known |= strcmp(legend->entry[i].title, curve->label) == 0;
		if (!known && curve->colour < 0)
			hawser__legend_add(legend, curve->label, "with lines lw 6 lc rgb '#CCCCCC'");
		else if (!known)
			hawser__legend_add(legend, curve->label, "with lines lw %g lc rgb '%s'",
			                   curve->colour ? 1.5 : 3.0, colours[curve->colour % COLOURS]);
	}
}

static void plot(FILE *script, const struct hawser__motion_panel *panel, int number)
{
	fputs("plot ", script);
	for (int c = 0; c < panel->curves; c++) {
		const struct hawser__motion_curve *curve = &panel->curve[c];

		if (curve->colour < 0)
			fprintf(script, "%s$panel%d using 1:(-$%d):%d with filledcurves lc rgb '#CCCCCC'",
			        c ? ", " : "", number, c + 2, c + 2);
		else
			fprintf(script, "%s$panel%d using 1:%d with lines lw %g lc rgb '%s'", c ? ", " : "",
			        number, c + 2, curve->colour ? 1.2 : 3.0, colours[curve->colour % COLOURS]);
	}
	fputs("\n", script);
}

enum hawser_status hawser__plot_motions(const char *path, const struct hawser__motions *of,
                                        struct hawser_report *report)
{
	static const double width = 17.0, tall = 4.2, gap = 0.7; /* cm */
	struct hawser__legend legend = {0};
	struct hawser__picture picture;
	double bottom, height;
	FILE *script;
	enum hawser_status status;

	for (int p = 0; p < of->panels; p++)
		legend_of(&legend, &of->panel[p]);
	bottom = hawser__legend_cm(&legend, width);
	height = bottom + tall*of->panels - gap + 0.4;
	status = hawser__picture_begin(&picture, path, width, height, report);
	if (status)
		return status;
	script = picture.script;
	for (int p = 0; p < of->panels; p++)
		data(script, of, &of->panel[p], p);
	fprintf(script, "unset key\nset xrange [%.9g:%.9g]\n", of->time[0]/of->axis.per,
	        of->time[of->rows - 1]/of->axis.per);
	for (int p = 0; p < of->panels; p++) {
		double low = (bottom + tall*(of->panels - 1 - p))/height;
		int last = p == of->panels - 1;

		hawser__picture_panel(&picture, 0.13, 0.97, low, low + (tall - gap)/height);
		hawser__picture_ylabel(&picture, "%s", of->panel[p].title);
		if (last)
			fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", of->axis.title);
		else
			fputs("set format x ''\nunset xlabel\n", script);
		plot(script, &of->panel[p], p);
	}
	hawser__legend_draw(&picture, &legend);
	return hawser__picture_finish(&picture, report);
}

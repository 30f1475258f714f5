/* output/curves/plot_folds.c - fold curves in the plane of frequency and load, with their special
 * points and a line at the load of the model; below, the response at that load and the curves
 * detached from it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static const char unstable_dash[] = HAWSER__UNSTABLE_DASH;
static const char load_style[] = "lc rgb '#404040' lw 0.8 dt (4,4)";

/* Symbols of the special points: gnuplot's point types, size, colour, name for the legend. */
static const struct {
	int type;
	double size;
	const char *colour, *label;
} symbol[] = {
	[HAWSER_FOLDS_NOMINAL] = {7, 0.5, "#404040", "folds at that load"},
	[HAWSER_FOLDS_CUSP] = {9, 0.9, "#D55E00", "cusp"},
	[HAWSER_FOLDS_ISOLA] = {7, 0.8, "#009E73", "isola centre"},
	[HAWSER_FOLDS_BIFURCATION] = {13, 1.0, "#CC79A7", "curves join or part"},
};
enum { kinds = sizeof symbol/sizeof *symbol };

static void line_data(FILE *script, const char *name, int index,
                      const struct hawser__folds_line *line)
{
	int i;

	fprintf(script, "$%s%d << END\n", name, index);
	for (i = 0; i < line->points; i++)
		fprintf(script, "%.12g %.9g\n", line->x[i], line->y[i]);
	fputs("NaN NaN\nEND\n", script);
}

/* The stable or the unstable parts of a response; each part begins at the end of the previous
 * one. */
static void part_data(FILE *script, int index, const struct hawser__folds_line *line, int unstable)
{
	int i;

	fprintf(script, "$%s%d << END\n", unstable ? "unstable" : "stable", index);
	for (i = 0; i < line->points; i++) {
		int mine = line->unstable[i] == unstable;

		if (mine || (i > 0 && line->unstable[i - 1] == unstable))
			fprintf(script, "%.12g %.9g\n", line->x[i], line->y[i]);
		if (!mine)
			fputc('\n', script);
	}
	fputs("NaN NaN\nEND\n", script);
}

static int mark_data(FILE *script, const struct hawser__folds_picture *folds, int kind)
{
	int k, count = 0;

	fprintf(script, "$mark%d << END\n", kind);
	for (k = 0; k < folds->marks; k++)
		if ((int)folds->mark[k].kind == kind) {
			fprintf(script, "%.12g %.9g\n", folds->mark[k].omega, folds->mark[k].load);
			count++;
		}
	fputs("NaN NaN\nEND\n", script);
	return count;
}

static void plane(struct hawser__picture *picture, const struct hawser__folds_picture *folds)
{
	FILE *script = picture->script;
	int k;

	fprintf(script, "set yrange [0:%.9g]\n", folds->load_to);
	hawser__picture_tics(picture, 'y', 0.0, folds->load_to, 8);
	hawser__picture_ylabel(picture, "Load, as a factor of the given one");
	fprintf(script, "plot 1 with lines %s", load_style);
	for (k = 0; k < folds->curves; k++)
		fprintf(script, ", $curve%d with lines lt 1", k);
	for (k = 0; k < kinds; k++)
		fprintf(script, ", $mark%d with points pt %d ps %g lc rgb '%s'", k, symbol[k].type,
		        symbol[k].size,
		        symbol[k].colour);
	fputc('\n', script);
}

static void responses(struct hawser__picture *picture, const struct hawser__folds_picture *folds)
{
	FILE *script = picture->script;
	double most = 0.0;
	int k, i;

	for (k = 0; k < folds->responses; k++)
		for (i = 0; i < folds->response[k].points; i++)
			most = fmax(most, folds->response[k].y[i]);
	fprintf(script, "set yrange [0:%s]\nset format x '%%g'\n"
	                "set xlabel '%s'\n", most > 0.0 ? "*" : "1", folds->x_title);
	hawser__picture_tics(picture, 'y', 0.0, most, 6);
	hawser__picture_ylabel(picture, "%s", folds->label);
	fputs("plot ", script);
	for (k = 0; k < folds->responses; k++)
		fprintf(script, "%s$unstable%d with lines lt %d lw 1 %s, $stable%d with lines lt %d",
		        k ? ", " : "", k, k ? 2 : 7, unstable_dash, k, k ? 2 : 7);
	fputc('\n', script);
}

static void legend(struct hawser__picture *picture, const struct hawser__folds_picture *folds,
                   const int count[kinds])
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "folds", "with lines lt 1");
	hawser__legend_add(&entries, "given load", "with lines %s", load_style);
	for (int k = 0; k < kinds; k++)
		if (count[k])
			hawser__legend_add(&entries, symbol[k].label, "with points pt %d ps %g lc rgb '%s'",
			                   symbol[k].type, symbol[k].size, symbol[k].colour);
	hawser__legend_add(&entries, "stable", "with lines lt 7");
	hawser__legend_add(&entries, "unstable", "with lines lt 7 lw 1 %s", unstable_dash);
	if (folds->responses > 1)
		hawser__legend_add(&entries, "detached", "with lines lt 2");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_folds(const char *path, const struct hawser__folds_picture *folds,
                                      struct hawser_report *report)
{
	const double height = 16.5, bottom = 3.5/height, top = 1.0 - 0.4/height;
	const double middle = 0.5*(bottom + top);
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, height, report);
	FILE *script = picture.script;
	int k, count[kinds];

	if (status)
		return status;
	for (k = 0; k < folds->curves; k++)
		line_data(script, "curve", k, &folds->curve[k]);
	for (k = 0; k < kinds; k++)
		count[k] = mark_data(script, folds, k);
	for (k = 0; k < folds->responses; k++) {
		part_data(script, k, &folds->response[k], 0);
		part_data(script, k, &folds->response[k], 1);
	}
	fprintf(script, "set xrange [%.12g:%.12g]\nset format x ''\n", folds->from, folds->to);
	hawser__picture_tics(&picture, 'x', folds->from, folds->to, 10);
	hawser__picture_panel(&picture, 0.13, 0.965, middle + 0.25/height, top);
	plane(&picture, folds);
	hawser__picture_panel(&picture, 0.13, 0.965, bottom, middle - 0.25/height);
	responses(&picture, folds);
	legend(&picture, folds, count);
	return hawser__picture_finish(&picture, report);
}

/* output/cable/plot_irvine.c - the Irvine diagram: natural frequencies over a parameter, the planes in
 * two colours, with marks at crossings and veerings, as in B figures 3.19, 4.4 and 4.5.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static const char in_style[] = "with lines lt 1 lw 2.2";
static const char out_style[] = "with lines lt 2 lw 1.1";
static const char overlay_style[] = "with lines lt 7 lw 1.0 dt (14,12)";
static const char crossing_style[] = "with points pt 6 ps 1.0 lw 1.2 lc rgb 'black'";
static const char veering_style[] = "with points pt 7 ps 0.5 lc rgb 'black'";

/* Curves of panel number `panel`. */
static void curves(FILE *script, const struct hawser__diagram *diagram, const char *name, int panel,
                   const double *y, int columns)
{
	int i, b;

	fprintf(script, "$%s%d << END\n", name, panel);
	for (i = 0; i < diagram->stations; i++) {
		fprintf(script, "%.12g", diagram->x[i]);
		for (b = 0; b < columns; b++)
			fprintf(script, " %.9g", y[i*columns + b]);
		fputc('\n', script);
	}
	fputs("END\n", script);
}

static int count_marks(const struct hawser__diagram *diagram, int count, int veers)
{
	int i, k, marks = 0;

	for (i = 0; i < count; i++)
		for (k = 0; k < diagram[i].marks; k++)
			marks += diagram[i].veers[k] == veers;
	return marks;
}

/* A point on each branch, joined by a line if both branches are shown. */
static void marks(FILE *script, const struct hawser__diagram *diagram, int panel, int veers)
{
	int k, end;

	fprintf(script, "$mark%d_%d << END\n", veers, panel);
	for (k = 0; k < diagram->marks; k++) {
		if (diagram->veers[k] != veers)
			continue;
		for (end = 0; end < 2; end++)
			if (!isnan(diagram->mark_y[2*k + end]))
				fprintf(script, "%.12g %.9g\n", diagram->mark_x[k],
				        diagram->mark_y[2*k + end]);
		fputc('\n', script);
	}
	fputs("NaN NaN\nEND\n", script);
}

/* Ranges of the abscissa and of all curves. */
static void ranges(double *low, double *high, double *top, const struct hawser__diagram *diagram,
                   int count)
{
	int i, k;

	*low = INFINITY;
	*high = *top = 0.0;
	for (k = 0; k < count; k++) {
		double first = diagram[k].x[0], last = diagram[k].x[diagram[k].stations - 1];

		*low = fmin(*low, fmin(first, last));
		*high = fmax(*high, fmax(first, last));
		for (i = 0; i < diagram[k].stations*diagram[k].branches; i++)
			*top = fmax(*top, diagram[k].y[i]);
	}
}

/* Least ratio of the ends of a range with logarithmic tics; a smaller range might contain none of
 * them. */
static const double logarithmic_from = 5.0;

/* Tics at 1, 2 and 5 of each decade if there are few decades, else at powers of ten. */
static void logarithmic_tics(FILE *script, double low, double high)
{
	int first = (int)floor(log10(low)), last = (int)ceil(log10(high)), k;
	const char *comma = "";

	fputs("set logscale x\n", script);
	if (last - first > 4)
		return;
	fputs("set xtics (", script);
	for (k = first; k < last; k++, comma = ", ")
		fprintf(script, "%s%.9g, %.9g, %.9g", comma, pow(10.0, k), 2.0*pow(10.0, k),
		        5.0*pow(10.0, k));
	fprintf(script, ", %.9g)\nset mxtics\n", pow(10.0, last));
}

/* Layout of the panels: a grid, filled row by row. */
struct layout {
	int columns, rows;
	double width, height; /* cm */
};

static struct layout layout_of(int count)
{
	static const int columns[HAWSER__DIAGRAMS + 1] = {1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 4, 4, 4};
	struct layout layout = {.columns = columns[count]};

	layout.rows = (count + layout.columns - 1)/layout.columns;
	layout.width = layout.columns == 1 ? 16.0 : 8.5*layout.columns;
	layout.height = layout.columns == 1 ? 12.5 : 6.5*layout.rows + 2.3;
	return layout;
}

/* Axes have titles in the left column and in the bottom row only. */
static void axes(struct hawser__picture *picture, const struct layout *layout,
                 const struct hawser__diagram *diagram, int count, int panel)
{
	int column = panel%layout->columns, row = panel/layout->columns, one = count == 1;
	int below = panel + layout->columns < count;
	double foot = HAWSER__LEGEND_CM/layout->height, margin = 0.13*16.0/layout->width;
	double wide = (0.985 - margin)/layout->columns, high = (0.985 - foot)/layout->rows;
	double left = margin + column*wide, bottom = foot + (layout->rows - 1 - row)*high;
	double low, most, top;

	hawser__picture_panel(picture, left, one ? 0.97 : left + 0.9*wide, bottom,
	                      one ? 0.97 : bottom + 0.86*high);
	ranges(&low, &most, &top, diagram, count);
	fprintf(picture->script, "set xrange [%.17g:%.17g]\nset yrange [0:%.9g]\nunset label\n", low,
	        most, 1.04*top);
	if (diagram->logarithmic && most > logarithmic_from*low)
		logarithmic_tics(picture->script, low, most);
	else
		hawser__picture_tics(picture, 'x', low, most, one ? 8 : 5);
	hawser__picture_tics(picture, 'y', 0.0, top, 8);
	fprintf(picture->script, "set xlabel '%s' offset 0,0.2\n", below ? "" : diagram->x_title);
	picture->left = left + 0.107*(1.0 - 16.0/layout->width);
	if (column == 0)
		hawser__picture_ylabel(picture, "%s", diagram->y_title);
	if (*diagram[panel].note)
		fprintf(picture->script, "set label 1 '%s' at graph 0.97,0.06 right front\n",
		        diagram[panel].note);
}

/* Branches of the two planes often coincide: a thin line is drawn on a thick one. */
static void lines(FILE *script, const struct hawser__diagram *diagram, int panel)
{
	int b, in = diagram->in_plane;

	fprintf(script, "plot $mark1_%d with lines lt 7 lw 0.8 dt (2,3)", panel);
	for (b = 0; b < diagram->branches; b++)
		fprintf(script, ", $solid%d using 1:%d %s", panel, b + 2, b < in ? in_style : out_style);
	for (b = 0; b < diagram->overlays; b++)
		fprintf(script, ", $dashed%d using 1:%d %s", panel, b + 2, overlay_style);
	fprintf(script, ", $mark0_%d with points pt 7 ps 1.0 lc rgb 'white', $mark0_%d %s, "
	                "$mark1_%d %s\n", panel, panel, crossing_style, panel, veering_style);
}

static void legend(struct hawser__picture *picture, const struct hawser__diagram *diagram, int count)
{
	struct hawser__legend entries = {0};
	int overlays = 0, k;

	for (k = 0; k < count; k++)
		overlays += diagram[k].overlays;
	hawser__legend_add(&entries, "in plane", "%s", in_style);
	hawser__legend_add(&entries, "out of plane", "%s", out_style);
	if (overlays)
		hawser__legend_add(&entries, "analytic", "%s", overlay_style);
	if (count_marks(diagram, count, 0))
		hawser__legend_add(&entries, "crossing", "%s", crossing_style);
	if (count_marks(diagram, count, 1))
		hawser__legend_add(&entries, "veering", "%s", veering_style);
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_irvine(const char *path, const struct hawser__diagram *diagram,
                                       int count, struct hawser_report *report)
{
	const struct layout layout = layout_of(count);
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, layout.width, layout.height,
	                                                  report);
	FILE *script = picture.script;
	int k;

	if (status)
		return status;
	for (k = 0; k < count; k++) {
		curves(script, &diagram[k], "solid", k, diagram[k].y, diagram[k].branches);
		if (diagram[k].overlays)
			curves(script, &diagram[k], "dashed", k, diagram[k].overlay, diagram[k].overlays);
		marks(script, &diagram[k], k, 0);
		marks(script, &diagram[k], k, 1);
	}
	for (k = 0; k < count; k++) {
		axes(&picture, &layout, diagram, count, k);
		lines(script, &diagram[k], k);
	}
	legend(&picture, diagram, count);
	return hawser__picture_finish(&picture, report);
}

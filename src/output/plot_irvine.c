/* output/plot_irvine.c - the Irvine diagram: natural frequencies over a parameter, the planes in two
 * colours, crossings and veerings marked; the form of B figures 3.19, 4.4 and 4.5.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

static const char in_style[] = "with lines lt 1 lw 2.2";
static const char out_style[] = "with lines lt 2 lw 1.1";
static const char overlay_style[] = "with lines lt 7 lw 1.0 dt (14,12)";
static const char crossing_style[] = "with points pt 6 ps 1.0 lw 1.2 lc rgb 'black'";
static const char veering_style[] = "with points pt 7 ps 0.5 lc rgb 'black'";

static void curves(FILE *script, const struct hawser__diagram *diagram, const char *name,
                   const double *y, int columns)
{
	int i, b;

	fprintf(script, "$%s << END\n", name);
	for (i = 0; i < diagram->stations; i++) {
		fprintf(script, "%.12g", diagram->x[i]);
		for (b = 0; b < columns; b++)
			fprintf(script, " %.9g", y[i*columns + b]);
		fputc('\n', script);
	}
	fputs("END\n", script);
}

static int count_marks(const struct hawser__diagram *diagram, int veers)
{
	int k, count = 0;

	for (k = 0; k < diagram->marks; k++)
		count += diagram->veers[k] == veers;
	return count;
}

/* A point on each branch, and a line between them where there are two. */
static void marks(FILE *script, const struct hawser__diagram *diagram, int veers)
{
	int k, end;

	fprintf(script, "$mark%d << END\n", veers);
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

/* Range of all curves; of the abscissa too. */
static void ranges(double *low, double *high, double *top, const struct hawser__diagram *diagram)
{
	int i;

	*low = fmin(diagram->x[0], diagram->x[diagram->stations - 1]);
	*high = fmax(diagram->x[0], diagram->x[diagram->stations - 1]);
	*top = 0.0;
	for (i = 0; i < diagram->stations*diagram->branches; i++)
		*top = fmax(*top, diagram->y[i]);
}

/* 1, 2 and 5 in each decade, where a few decades are shown; else whole decades. */
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

static void axes(struct hawser__picture *picture, const struct hawser__diagram *diagram)
{
	double low, high, top;

	ranges(&low, &high, &top, diagram);
	fprintf(picture->script, "set xrange [%.12g:%.12g]\nset yrange [0:%.9g]\n", low, high,
	        1.04*top);
	if (diagram->logarithmic)
		logarithmic_tics(picture->script, low, high);
	else
		hawser__picture_tics(picture, 'x', low, high, 8);
	hawser__picture_tics(picture, 'y', 0.0, top, 8);
	fprintf(picture->script, "set xlabel '%s' offset 0,0.2\n", diagram->x_title);
	hawser__picture_ylabel(picture, "%s", diagram->y_title);
}

/* Branches of the two planes often lie on each other: the thin line runs on the thick one. */
static void lines(FILE *script, const struct hawser__diagram *diagram)
{
	int b, in = diagram->in_plane;

	fputs("plot $mark1 with lines lt 7 lw 0.8 dt (2,3)", script);
	for (b = 0; b < diagram->branches; b++)
		fprintf(script, ", $solid using 1:%d %s", b + 2, b < in ? in_style : out_style);
	for (b = 0; b < diagram->overlays; b++)
		fprintf(script, ", $dashed using 1:%d %s", b + 2, overlay_style);
	fprintf(script, ", $mark0 with points pt 7 ps 1.0 lc rgb 'white', $mark0 %s, $mark1 %s\n",
	        crossing_style, veering_style);
}

static void legend(struct hawser__picture *picture, const struct hawser__diagram *diagram)
{
	FILE *script = picture->script;

	hawser__picture_panel(picture, 0.05, 0.95, 0.001, 0.004);
	fputs("unset label\nunset border\nunset tics\nunset grid\nunset xlabel\nunset logscale x\n"
	      "set xrange [0:1]\nset yrange [0:1]\n"
	      "set key at screen 0.55,0.012 center bottom horizontal samplen 2.5 width -1 maxrows 1\n"
	      "plot ", script);
	fprintf(script, "NaN %s title 'in plane', NaN %s title 'out of plane'", in_style, out_style);
	if (diagram->overlays)
		fprintf(script, ", NaN %s title 'analytic'", overlay_style);
	if (count_marks(diagram, 0))
		fprintf(script, ", NaN %s title 'crossing'", crossing_style);
	if (count_marks(diagram, 1))
		fprintf(script, ", NaN %s title 'veering'", veering_style);
	fputc('\n', script);
}

enum hawser_status hawser__plot_irvine(const char *path, const struct hawser__diagram *diagram,
                                       struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 12.0, report);
	FILE *script = picture.script;

	if (status)
		return status;
	curves(script, diagram, "solid", diagram->y, diagram->branches);
	if (diagram->overlays)
		curves(script, diagram, "dashed", diagram->overlay, diagram->overlays);
	marks(script, diagram, 0);
	marks(script, diagram, 1);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.19, 0.97);
	axes(&picture, diagram);
	lines(script, diagram);
	legend(&picture, diagram);
	return hawser__picture_finish(&picture, report);
}

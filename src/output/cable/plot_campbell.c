/* output/cable/plot_campbell.c - the Campbell diagram: one column per plane, imaginary parts
 * above, real parts below, as in B figure 5.5. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

enum { COLOURS = 6 };
static const char line_style[] = "with lines lt 7 lw 0.7 dt (3,4)";
static const char limit_style[] = "lc rgb '#909090' lw 1.2 dt (8,5)";
static const char crossing_style[] = "with points pt 6 ps 1.0 lw 1.2 lc rgb 'black'";
static const char veering_style[] = "with points pt 7 ps 0.5 lc rgb 'black'";

/* One plane: branches first..end-1. */
struct column {
	int first, end;
	const char *title;
	double left, right;
};

static void curves(FILE *script, const struct hawser__campbell *diagram, const char *name,
                   const double *y)
{
	int i, b;

	fprintf(script, "$%s << END\n", name);
	for (i = 0; i < diagram->stations; i++) {
		fprintf(script, "%.12g", diagram->speed[i]);
		for (b = 0; b < diagram->branches; b++)
			fprintf(script, " %.9g", y[i*diagram->branches + b]);
		fputc('\n', script);
	}
	fputs("END\n", script);
}

static void marks(FILE *script, const struct hawser__campbell *diagram)
{
	int veers, k, end;

	for (veers = 0; veers < 2; veers++) {
		fprintf(script, "$mark%d << END\n", veers);
		for (k = 0; k < diagram->marks; k++)
			for (end = 0; end < 2; end++)
				if (diagram->veers[k] == veers && !isnan(diagram->mark_y[2*k + end]))
					fprintf(script, "%.12g %.9g\n", diagram->mark_x[k],
					        diagram->mark_y[2*k + end]);
		fputs("NaN NaN\nEND\n", script);
	}
}

static int has_marks(const struct hawser__campbell *diagram, int veers)
{
	int k;

	for (k = 0; k < diagram->marks; k++)
		if (diagram->veers[k] == veers)
			return 1;
	return 0;
}

static double largest(const double *y, int count)
{
	double top = 0.0;
	int i;

	for (i = 0; i < count; i++)
		top = fmax(top, fabs(y[i]));
	return top;
}

static void branches(FILE *script, const char *name, const struct column *column)
{
	int b;

	for (b = column->first; b < column->end; b++)
		fprintf(script, "%s$%s using 1:%d with lines lt %d lw 1.3", b > column->first ? ", " : "",
		        name, b + 2, (b - column->first)%COLOURS + 1);
}

/* Excitation lines. */
static void lines(FILE *script, const struct hawser__campbell *diagram)
{
	int n;

	for (n = 1; n <= diagram->harmonics; n++)
		fprintf(script, ", %.9g*x %s", n*diagram->slope, line_style);
}

/* Numbers of the harmonics where their lines leave the panel. */
static void numbers(FILE *script, const struct hawser__campbell *diagram, double top)
{
	double last = diagram->speed[diagram->stations - 1];
	int n;

	for (n = 1; n <= diagram->harmonics; n++) {
		double slope = n*diagram->slope, speed = fmin(0.97*last, 0.94*top/slope);

		fprintf(script, "set label %d '%d' at %.9g,%.9g right offset -0.5,0.3 font ',9'\n",
		        10 + n, n, speed, slope*speed);
	}
}

static void speed_axis(FILE *script, const struct hawser__campbell *diagram)
{
	fprintf(script, "set format x '%%g'\nset xlabel '%s' offset 0,0.3\n", diagram->speed_title);
}

/* Panel of the imaginary parts, from `bottom`; with the title of the abscissa if there is no panel
 * below. */
static void imaginary(struct hawser__picture *picture, const struct hawser__campbell *diagram,
                      const struct column *column, double bottom, int lowest)
{
	FILE *script = picture->script;
	double top = 1.04*largest(diagram->im, diagram->stations*diagram->branches);

	hawser__picture_panel(picture, column->left, column->right, bottom, 0.94);
	fprintf(script, "set yrange [0:%.9g]\nset format x ''\nunset xlabel\n", top);
	if (lowest)
		speed_axis(script, diagram);
	hawser__picture_tics(picture, 'y', 0.0, top, 8);
	if (column->first == 0)
		hawser__picture_ylabel(picture, "%s", diagram->im_title);
	fprintf(script, "set label 1 '%s%s' at graph 0.5,1.04 center\n", column->title,
	        lowest ? ", no damping: all real parts 0" : "");
	numbers(script, diagram, top);
	fputs("plot ", script);
	branches(script, "im", column);
	lines(script, diagram);
	if (column->first == 0)
		fprintf(script, ", $mark0 %s, $mark1 %s", crossing_style, veering_style);
	fputs("\nunset label\nset format x '%g'\n", script);
}

/* 1 if an eigenvalue has a real part; without damping and below the first instability none has. */
static int has_real(const struct hawser__campbell *diagram)
{
	return largest(diagram->re, diagram->stations*diagram->branches) > 0.0;
}

static void real(struct hawser__picture *picture, const struct hawser__campbell *diagram,
                 const struct column *column)
{
	FILE *script = picture->script;
	double low = 0.0, high = 0.0;
	int i;

	for (i = 0; i < diagram->stations*diagram->branches; i++) {
		low = fmin(low, diagram->re[i]);
		high = fmax(high, diagram->re[i]);
	}
	hawser__picture_panel(picture, column->left, column->right, 0.25, 0.40);
	fprintf(script, "set yrange [%.9g:%.9g]\n", low - 0.1*(high - low), high + 0.1*(high - low));
	speed_axis(script, diagram);
	hawser__picture_tics(picture, 'y', low, high, 3);
	if (column->first == 0)
		hawser__picture_ylabel(picture, "%s", diagram->re_title);
	fputs("plot ", script);
	branches(script, "re", column);
	fputs("\nunset label\n", script);
}

static void legend(struct hawser__picture *picture, const struct hawser__campbell *diagram)
{
	struct hawser__legend entries = {0};
	int in = diagram->in_plane, out = diagram->branches - in, most = in > out ? in : out, b;
	char name[32];

	for (b = 0; b < most && b < COLOURS; b++) {
		snprintf(name, sizeof name, "mode %d", b + 1);
		hawser__legend_add(&entries, name, "with lines lt %d lw 1.3", b + 1);
	}
	if (diagram->harmonics > 0)
		hawser__legend_add(&entries, "excitation", "%s", line_style);
	if (!isnan(diagram->limit))
		hawser__legend_add(&entries, "limit speed", "with lines %s", limit_style);
	if (has_marks(diagram, 0))
		hawser__legend_add(&entries, "crossing", "%s", crossing_style);
	if (has_marks(diagram, 1))
		hawser__legend_add(&entries, "veering", "%s", veering_style);
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_campbell(const char *path, const struct hawser__campbell *diagram,
                                         struct hawser_report *report)
{
	const int in = diagram->in_plane, all = diagram->branches, both = in > 0 && in < all;
	const struct column column[] = {{0, in, "in plane", 0.13, both ? 0.54 : 0.97},
	                                {in, all, "out of plane", both ? 0.60 : 0.13, 0.97}};
	double first = diagram->speed[0], last = diagram->speed[diagram->stations - 1];
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(
		&picture, path, 16.0, has_real(diagram) ? 14.5 : 11.5, report);
	FILE *script = picture.script;
	int k;

	if (status)
		return status;
	curves(script, diagram, "im", diagram->im);
	curves(script, diagram, "re", diagram->re);
	marks(script, diagram);
	if (!isnan(diagram->limit)) {
		last = diagram->limit;
		fprintf(script, "set arrow 1 from %.12g,graph 0 to %.12g,graph 1 nohead %s\n", last, last,
		        limit_style);
	}
	fprintf(script, "set xrange [%.17g:%.17g]\n", first, last + 0.02*(last - first));
	hawser__picture_tics(&picture, 'x', first, last, both && last - first < 0.05*last ? 4 : 8);
	for (k = 0; k < 2; k++)
		if (column[k].end > column[k].first) {
			imaginary(&picture, diagram, &column[k], has_real(diagram) ? 0.44 : 0.31,
			          !has_real(diagram));
			if (has_real(diagram))
				real(&picture, diagram, &column[k]);
		}
	legend(&picture, diagram);
	return hawser__picture_finish(&picture, report);
}

/* output/cable/plot_speeds.c - steady states of a travelling cable over its speed: sag above, tension
 * below. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static const char *const style[HAWSER__SPEEDS_CURVES] = {
	"with lines lt 1", "with lines lt 1 dt (9,5)", "with lines lt 2"};
static const char *const title[HAWSER__SPEEDS_CURVES] = {
	"tension held: taut", "tension held: slack", "length held"};
static const char limit_style[] = "lc rgb '#909090' lw 1.2 dt (3,3)";

static void data(FILE *script, const struct hawser__speeds *speeds)
{
	const struct hawser__axis *axis = speeds->axis;
	int k, i;

	for (k = 0; k < HAWSER__SPEEDS_CURVES; k++) {
		const double *row = speeds->curve[k].rows;

		fprintf(script, "$curve%d << END\n", k);
		for (i = 0; i < speeds->curve[k].points; i++, row += 3)
			fprintf(script, "%.9g %.9g %.9g\n", row[0]/axis[0].per, row[1]/axis[1].per,
			        row[2]/axis[2].per);
		fputs("END\n", script);
	}
	if (!isnan(speeds->limit))
		fprintf(script, "set arrow 1 from %.12g,graph 0 to %.12g,graph 1 nohead %s\n",
		        speeds->limit/axis[0].per, speeds->limit/axis[0].per, limit_style);
}

static void curves(FILE *script, const struct hawser__speeds *speeds, int column)
{
	const char *comma = "plot ";
	int k;

	for (k = 0; k < HAWSER__SPEEDS_CURVES; k++)
		if (speeds->curve[k].points > 0) {
			fprintf(script, "%s$curve%d using 1:%d %s", comma, k, column, style[k]);
			comma = ", ";
		}
	fputc('\n', script);
}

static void legend(struct hawser__picture *picture, const struct hawser__speeds *speeds)
{
	struct hawser__legend entries = {0};

	for (int k = 0; k < HAWSER__SPEEDS_CURVES; k++)
		if (speeds->curve[k].points > 0)
			hawser__legend_add(&entries, title[k], "%s", style[k]);
	if (!isnan(speeds->limit))
		hawser__legend_add(&entries, "limit speed", "with lines %s", limit_style);
	hawser__legend_draw(picture, &entries);
}

/* Range of a column over all curves. */
static void range(double *low, double *high, const struct hawser__speeds *speeds, int column)
{
	int k, i;

	*low = INFINITY;
	*high = 0.0;
	for (k = 0; k < HAWSER__SPEEDS_CURVES; k++)
		for (i = 0; i < speeds->curve[k].points; i++) {
			*low = fmin(*low, speeds->curve[k].rows[3*i + column]);
			*high = fmax(*high, speeds->curve[k].rows[3*i + column]);
		}
	*low /= speeds->axis[column].per;
	*high /= speeds->axis[column].per;
}

enum hawser_status hawser__plot_speeds(const char *path, const struct hawser__speeds *speeds,
                                       struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 12.8, report);
	FILE *script = picture.script;
	double low, high;

	if (status)
		return status;
	data(script, speeds);
	range(&low, &high, speeds, 0);
	fprintf(script, "set xrange [%.9g:%.9g]\nset format x ''\nset logscale y\n", low, high);
	hawser__picture_tics(&picture, 'x', low, high, 8);
	range(&low, &high, speeds, 1);
	fprintf(script, "set yrange [%.9g:%.9g]\n", low/1.5, high*1.5);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.63, 0.97);
	hawser__picture_ylabel(&picture, "%s", speeds->axis[1].title);
	curves(script, speeds, 2);
	range(&low, &high, speeds, 2);
	fprintf(script, "unset logscale y\nset yrange [0:%.9g]\nset format x '%%g'\n"
	        "set xlabel '%s'\n", 1.08*high, speeds->axis[0].title);
	hawser__picture_tics(&picture, 'y', 0.0, high, 6);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.235, 0.575);
	hawser__picture_ylabel(&picture, "%s", speeds->axis[2].title);
	curves(script, speeds, 3);
	legend(&picture, speeds);
	return hawser__picture_finish(&picture, report);
}

/* output/curves/plot_energy.c - frequency of free motions over their energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

enum hawser_status hawser__plot_energy(const char *path, const double *at, int points,
                                       const char *x_title, const char *y_title,
                                       struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 14.0, 9.0, report);
	FILE *script = picture.script;
	double low = INFINITY, high = -INFINITY;

	if (status)
		return status;
	fputs("$energy << END\n", script);
	for (int i = 0; i < points; i++)
		if (at[2*i] > 0.0) {
			fprintf(script, "%.12g %.12g\n", at[2*i], at[2*i + 1]);
			low = fmin(low, at[2*i + 1]);
			high = fmax(high, at[2*i + 1]);
		}
	fputs("NaN NaN\nEND\n", script);
	hawser__picture_panel(&picture, 0.175, 0.95, 0.18, 0.95);
	picture.left = 0.145; /* tics of frequencies that hardly differ are long */
	fputs("set logscale x\nset format x '10^{%T}'\nunset key\n", script);
	if (high > low)
		hawser__picture_tics(&picture, 'y', low, high, 7);
	fprintf(script, "set xlabel '%s'\n", x_title);
	hawser__picture_ylabel(&picture, "%s", y_title);
	fputs("plot $energy with lines lt 1\n", script);
	return hawser__picture_finish(&picture, report);
}

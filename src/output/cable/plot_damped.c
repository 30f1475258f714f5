/* output/cable/plot_damped.c - damping ratios of modes over a key of the scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/cable/plot_damped.h"
#include "output/drawing/style.h"

/* Modes of the plane: solid; those out of it: dashed, in the same colours. */
static const char *dash_of(int plane)
{
	return plane == 0 ? "" : " dt (9,5)";
}

static void data(FILE *script, const struct hawser__damped *of)
{
	fputs("$damped << END\n", script);
	for (int i = 0; i < of->points; i++) {
		fprintf(script, "%.12g", of->x[i]/of->axis.per);
		for (int k = 0; k < of->curves; k++)
			fprintf(script, " %.9g", 100.0*of->y[k*of->points + i]);
		fputc('\n', script);
	}
	fputs("END\n", script);
}

enum hawser_status hawser__plot_damped(const char *path, const struct hawser__damped *of,
                                       struct hawser_report *report)
{
	double low = fmin(of->x[0], of->x[of->points - 1])/of->axis.per, top = 0.0;
	double high = fmax(of->x[0], of->x[of->points - 1])/of->axis.per;
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 11.0, report);
	FILE *script = picture.script;

	if (status)
		return status;
	for (int i = 0; i < of->points*of->curves; i++)
		top = isnan(of->y[i]) ? top : fmax(top, 100.0*of->y[i]);
	data(script, of);
	hawser__picture_panel(&picture, 0.13, 0.97, HAWSER__LEGEND_CM/11.0, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [0:%.9g]\nset datafile missing 'nan'\n"
	        "set xlabel '%s'\n", low, high, top > 0.0 ? 1.06*top : 1.0, of->axis.title);
	if (of->logarithmic)
		hawser__picture_log_tics(&picture, "x", low, high);
	else
		hawser__picture_tics(&picture, 'x', low, high, 8);
	hawser__picture_tics(&picture, 'y', 0.0, top > 0.0 ? 1.06*top : 1.0, 7);
	hawser__picture_ylabel(&picture, "%s", "Damping ratio {/:Italic ζ} (%)");
	fputs("plot ", script);
	for (int k = 0; k < of->curves; k++)
		fprintf(script, "%s$damped using 1:%d with lines lt %d%s", k > 0 ? ", " : "", k + 2,
		        k % 8 + 1, dash_of(of->plane[k]));
	if (of->curves == 0)
		fputs("NaN", script);
	fputc('\n', script);
	for (int k = 0; k < of->curves; k++)
		hawser__legend_add(&entries, of->title[k], "with lines lt %d%s", k % 8 + 1,
		                   dash_of(of->plane[k]));
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

/* output/plot_modes.c - mode shapes: one panel a mode, components against unstretched arclength.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

enum { most_panels = 12, samples = 161 };

static void data(FILE *script, const struct hawser_modes *modes, int k)
{
	const struct hawser_statics *statics = &modes->statics;
	double shape[3];
	int i;

	fprintf(script, "$mode%d << END\n", k);
	for (i = 0; i < samples; i++) {
		double s = statics->l*i/(samples - 1);

		hawser_modes_at(modes, shape, NULL, k, s);
		fprintf(script, "%.9g %.9g %.9g %.9g\n", s*statics->span.d, shape[0], shape[1], shape[2]);
	}
	fputs("END\n", script);
}

/* One range for all panels, so that they compare; shapes are O(1) by their norm. */
static double extent(const struct hawser_modes *modes, int panels)
{
	double largest = 0.0, shape[3];
	int k, i, c;

	for (k = 0; k < panels; k++)
		for (i = 0; i < samples; i++) {
			hawser_modes_at(modes, shape, NULL, k, modes->statics.l*i/(samples - 1));
			for (c = 0; c < 3; c++)
				largest = fmax(largest, fabs(shape[c]));
		}
	return 1.12*largest;
}

static void panel(FILE *script, const struct hawser_modes *modes, int k)
{
	const struct hawser_mode *mode = &modes->mode[k];

	fprintf(script, "set title '%d:  %.4g Hz,  %s%s' offset 0,-0.6\n", k + 1,
	        mode->omega/modes->time_unit/(2.0*M_PI), hawser_plane_name(mode->plane),
	        mode->family == HAWSER_LONGITUDINAL ? ", longitudinal" : "");
	if (mode->plane == HAWSER_OUT_OF_PLANE)
		fprintf(script, "plot $mode%d using 1:4 with lines lt 3\n", k);
	else
		fprintf(script, "plot $mode%d using 1:2 with lines lt 2 dt (10,5), "
		                "$mode%d using 1:3 with lines lt 1\n", k, k);
}

static void legend(struct hawser__picture *picture)
{
	hawser__picture_panel(picture, 0.05, 0.95, 0.001, 0.01);
	fputs("unset title\nunset border\nunset tics\nunset grid\nunset xlabel\nunset label\n"
	      "unset xzeroaxis\n"
	      "set key at screen 0.53,0.012 center bottom horizontal samplen 3\n"
	      "plot NaN with lines lt 2 dt (10,5) title 'axial {/:Italic P}', "
	      "NaN with lines lt 1 title 'normal {/:Italic Q}', "
	      "NaN with lines lt 3 title 'out of plane {/:Italic B}'\n", picture->script);
}

enum hawser_status hawser__plot_modes(const char *path, const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	int panels = modes->n < most_panels ? modes->n : most_panels, k;
	int columns = panels == 1 ? 1 : panels <= 4 ? 2 : 3, rows = (panels + columns - 1)/columns;
	double height = 2.4 + 4.0*rows, bottom = 1.9/height, top = 1.0 - 0.05/height;
	double left = 0.122, width = (1.0 - left)/columns, tall = (top - bottom)/rows;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, height, report);
	FILE *script = picture.script;
	double range;

	if (status)
		return status;
	range = extent(modes, panels);
	for (k = 0; k < panels; k++)
		data(script, modes, k);
	fprintf(script, "set xrange [0:%.9g]\nset yrange [%.4g:%.4g]\nset xzeroaxis lt 7 lw 0.4\n",
	        modes->statics.length0, -range, range);
	hawser__picture_tics(&picture, 'x', 0.0, modes->statics.length0, columns > 2 ? 4 : 6);
	for (k = 0; k < panels; k++) {
		int row = k/columns, column = k % columns, last = k + columns >= panels;
		double x = left + width*column, y = top - tall*(row + 1);

		fprintf(script, "set format x '%s'\nset format y '%s'\n", last ? "%g" : "",
		        column == 0 ? "%g" : "");
		fprintf(script, last ? "set xlabel 'Arclength {/:Italic S} (m)' offset 0,0.4\n"
		                     : "unset xlabel\n");
		hawser__picture_panel(&picture, x, x + width - 0.032, y, y + tall - 0.75/height);
		if (column == 0)
			hawser__picture_ylabel(&picture, "Shape (–)");
		else
			fputs("unset label\n", script);
		panel(script, modes, k);
	}
	legend(&picture);
	return hawser__picture_finish(&picture, report);
}

/* output/plot_beam_lines.c - stability boundaries: speeds over a parameter; the form of D figures
 * 9.2, 9.3,
 * 9.6 and 9.8.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

static void data(FILE *script, const struct hawser__beam_lines *picture)
{
	for (int i = 0; i < picture->lines; i++) {
		const struct hawser__beam_line *line = &picture->line[i];

		fprintf(script, "$l%d << END\n", i);
		for (int k = 0; k < line->points; k++)
			if (isnan(line->y[k]))
				fputc('\n', script);
			else
				fprintf(script, "%.12g %.12g\n", line->x[k], line->y[k]);
		fputs("END\n", script);
	}
}

enum hawser_status hawser__plot_beam_lines(const char *path, const struct hawser__beam_lines *picture,
                                           struct hawser_report *report)
{
	struct hawser__picture out;
	enum hawser_status status = hawser__picture_begin(&out, path, 15.0, 10.5, report);
	double low = INFINITY, high = -INFINITY, top = 0.0;
	FILE *script = out.script;

	if (status)
		return status;
	for (int i = 0; i < picture->lines; i++)
		for (int k = 0; k < picture->line[i].points; k++) {
			low = fmin(low, picture->line[i].x[k]);
			high = fmax(high, picture->line[i].x[k]);
			top = fmax(top, picture->line[i].y[k]);
		}
	data(script, picture);
	hawser__picture_panel(&out, 0.13, 0.97, 0.22, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [0:%.12g]\n", low, high,
	        top > 0.0 ? 1.05*top : 1.0);
	hawser__picture_tics(&out, 'x', low, high, 8);
	hawser__picture_tics(&out, 'y', 0.0, top, 8);
	fprintf(script, "set xlabel '%s' offset 0,0.3\n", picture->x_title);
	hawser__picture_ylabel(&out, "Speed {/:Italic v} (%s)", picture->dimensional ? "m/s" : "–");
	fputs("set key at screen 0.55,0.012 center bottom horizontal samplen 3 width -1\nplot ", script);
	for (int i = 0; i < picture->lines; i++)
		fprintf(script, "%s$l%d using 1:2 with lines lt %d lw 1.6 dt %s title '%s'", i ? ", " : "", i,
		        picture->line[i].colour, picture->line[i].dashed ? "(10,6)" : "solid",
		        picture->line[i].label);
	fputc('\n', script);
	return hawser__picture_finish(&out, report);
}

/* output/cable/plot_beam_lines.c - stability boundaries: speeds over a parameter, as in D figures 9.2,
 * 9.3, 9.6 and 9.8.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static void data(FILE *script, const struct hawser__beam_lines *picture)
{
	for (int i = 0; i < picture->lines; i++) {
		const struct hawser__beam_line *line = &picture->line[i];

		fprintf(script, "$l%d << END\n", i);
		for (int k = 0; k < line->points; k++)
			if (isnan(line->y[k]))
				fputc('\n', script);
			else
				fprintf(script, "%.12g %.12g\n", line->x[k]/picture->x.per,
				        line->y[k]/picture->speed.per);
		fputs("END\n", script);
	}
}

static void draw(FILE *script, const struct hawser__beam_lines *picture)
{
	for (int i = 0; i < picture->lines; i++)
		fprintf(script, "%s$l%d using 1:2 with lines lt %d lw 1.6 dt %s", i ? ", " : "plot ", i,
		        picture->line[i].colour, picture->line[i].dashed ? "(10,6)" : "solid");
	fputc('\n', script);
}

static void legend(struct hawser__picture *out, const struct hawser__beam_lines *picture)
{
	struct hawser__legend entries = {0};

	for (int i = 0; i < picture->lines; i++)
		if (*picture->line[i].label)
			hawser__legend_add(&entries, picture->line[i].label, "with lines lt %d lw 1.6 dt %s",
			                   picture->line[i].colour, picture->line[i].dashed ? "(10,6)" : "solid");
	hawser__legend_draw(out, &entries);
}

enum hawser_status hawser__plot_beam_lines(const char *path, const struct hawser__beam_lines *picture,
                                           struct hawser_report *report)
{
	struct hawser__picture out;
	enum hawser_status status = hawser__picture_begin(&out, path, 15.0, 11.0, report);
	double low = INFINITY, high = -INFINITY, top = 0.0;
	FILE *script = out.script;

	if (status)
		return status;
	for (int i = 0; i < picture->lines; i++)
		for (int k = 0; k < picture->line[i].points; k++) {
			low = fmin(low, picture->line[i].x[k]/picture->x.per);
			high = fmax(high, picture->line[i].x[k]/picture->x.per);
			top = fmax(top, picture->line[i].y[k]/picture->speed.per);
		}
	data(script, picture);
	hawser__picture_panel(&out, 0.13, 0.95, 0.28, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [0:%.12g]\n", low, high,
	        top > 0.0 ? 1.05*top : 1.0);
	hawser__picture_tics(&out, 'x', low, high, 8);
	hawser__picture_tics(&out, 'y', 0.0, top, 8);
	fprintf(script, "set xlabel '%s' offset 0,0.3\n", picture->x.title);
	hawser__picture_ylabel(&out, "%s", picture->speed.title);
	draw(script, picture);
	legend(&out, picture);
	return hawser__picture_finish(&out, report);
}

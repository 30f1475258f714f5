/* output/cable/plot_statics.c - the span: profile and chord above, tension along the cable
 * below; between them the view from above, if the cable hangs in another plane than the vertical
 * one. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "output/output.h"
#include "output/drawing/style.h"

#define MARK "pt 7 ps 0.7 lc rgb 'black'"

static void line(FILE *script, const struct hawser__spot *at, const struct hawser__axis *axis)
{
	fprintf(script, "%.9g %.9g %.12g %.9g\n", at->x/axis[0].per, at->y/axis[1].per, at->T/axis[2].per,
	        at->z/axis[3].per);
}

/* The profile with both sides of each mass, at which the tension jumps, and the attachments. */
static void data(FILE *script, const struct hawser__span_picture *of, const struct hawser__axis *axis)
{
	int i, next = 0;

	fputs("$profile << END\n", script);
	for (i = 0; i < of->points; i++) {
		for (; next < 2*of->kinks && of->kink[next].S <= of->profile[i].S; next++)
			line(script, &of->kink[next], axis);
		line(script, &of->profile[i], axis);
	}
	fputs("END\n$attached << END\n", script);
	for (i = 0; i < of->kinks; i++)
		line(script, &of->kink[2*i], axis);
	fputs("END\n$chord << END\n", script); /* from where one end is to where the other is */
	line(script, &of->profile[0], axis);
	line(script, &of->profile[of->points - 1], axis);
	fputs("END\n", script);
}

/* A cable that hangs in another plane may be beside its ends in x too. */
static void range(FILE *script, const struct hawser__span_picture *of, double per)
{
	double low = 0.0, high = of->scene->span.d;

	for (int i = 0; i < of->points; i++) {
		low = of->profile[i].x < low ? of->profile[i].x : low;
		high = of->profile[i].x > high ? of->profile[i].x : high;
	}
	fprintf(script, "set xrange [%.9g:%.9g]\nset format x ''\n", low/per, high/per);
}

/* Panel `index` from the top, of `count`. */
static void panel(struct hawser__picture *picture, int index, int count, const char *title)
{
	const double high = 0.97, low = count == 2 ? 0.21 : 0.16, gap = count == 2 ? 0.06 : 0.04;
	double step = (high - low + gap)/count, top = high - index*step;

	hawser__picture_panel(picture, 0.13, 0.97, top - step + gap, top);
	hawser__picture_ylabel(picture, "%s", title);
}

/* Chord, cable and attachments in this column of the data. */
static void view(FILE *script, const struct hawser__span_picture *of, int column)
{
	fprintf(script, "plot $chord using 1:%d with lines lt 7 lw 0.8 dt (8,6), "
	        "$profile using 1:%d with lines lt 1", column, column);
	if (of->kinks > 0)
		fprintf(script, ", $attached using 1:%d with points " MARK, column);
	fputs("\n", script);
}

enum hawser_status hawser__plot_statics(const char *path, const struct hawser__span_picture *of,
                                        const struct hawser__axis *axis,
                                        struct hawser_report *report)
{
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	int panels = of->turned ? 3 : 2;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0,
	                                                  of->turned ? 16.4 : 12.4, report);
	FILE *script = picture.script;

	if (status)
		return status;
	data(script, of, axis);
	range(script, of, axis[0].per);
	panel(&picture, 0, panels, axis[1].title);
	view(script, of, 2);
	if (of->turned) {
		panel(&picture, 1, panels, axis[3].title);
		view(script, of, 4);
	}
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", axis[0].title);
	panel(&picture, panels - 1, panels, axis[2].title);
	fputs("plot $profile using 1:3 with lines lt 2\n", script);
	hawser__legend_add(&entries, "chord", "with lines lt 7 lw 0.8 dt (8,6)");
	hawser__legend_add(&entries, "cable", "with lines lt 1");
	if (of->kinks > 0)
		hawser__legend_add(&entries, "attachments", "with points " MARK);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

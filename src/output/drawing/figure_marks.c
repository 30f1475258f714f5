/* output/drawing/figure_marks.c - lines and texts at places of a panel. They go into the script after
 * the points, and stay away where the user's range ends before them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>

#include "output/drawing/figure.h"

void hawser__figure_upright(struct hawser__figure *figure, const char *title, double x,
                            const char *style,
                            ...)
{
	char look[HAWSER__STYLE];
	double at = x;
	va_list args;

	va_start(args, style);
	vsnprintf(look, sizeof look, style, args);
	va_end(args);
	if (hawser__figure_marked(figure, 0, &at))
		fprintf(figure->marks,
		        "set arrow from first %.12g, graph 0 to first %.12g, graph 1 nohead %s\n", at, at,
		        look);
	if (title && *title) {
		char entry[HAWSER__STYLE];

		snprintf(entry, sizeof entry, "with lines %.180s", look);
		hawser__legend_once(&figure->legend, title, entry);
	}
}

/* Begin a label there; returns 0 if it has none. */
static int begin_label(double at[2], struct hawser__figure *figure, double x, double y)
{
	at[0] = x;
	at[1] = y;
	if (!hawser__figure_marked(figure, 0, &at[0]) || !hawser__figure_marked(figure, 1, &at[1]))
		return 0;
	fputs("set label '", figure->marks);
	return 1;
}

static void end_label(struct hawser__figure *figure, const double at[2], const char *settings)
{
	fprintf(figure->marks, "' at %.9g,%.9g %s front\n", at[0], at[1], settings);
}

void hawser__figure_label(struct hawser__figure *figure, double x, double y, const char *settings,
                          const char *text, ...)
{
	double at[2];
	va_list args;

	if (!begin_label(at, figure, x, y))
		return;
	va_start(args, text);
	vfprintf(figure->marks, text, args);
	va_end(args);
	end_label(figure, at, settings);
}

void hawser__figure_name(struct hawser__figure *figure, double x, double y, const char *settings,
                         const char *name)
{
	double at[2];

	if (!begin_label(at, figure, x, y))
		return;
	hawser__picture_literal(figure->marks, name, 0);
	end_label(figure, at, settings);
}

void hawser__figure_above(struct hawser__figure *figure, double x, const char *settings,
                          const char *text)
{
	double at = x;

	if (hawser__figure_marked(figure, 0, &at))
		fprintf(figure->marks, "set label '%s' at first %.12g, graph 1 %s\n", text, at, settings);
}

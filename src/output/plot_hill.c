/* output/plot_hill.c - boundaries of stability in a plane of two parameters, and what they are compared
 * with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

static const struct {
	int kind;
	const char *label, *style;
} rows[] = {
	{HAWSER_HILL_PLUS, "multiplier +1", "lt 1"},
	{HAWSER_HILL_MINUS, "multiplier −1", "lt 2"},
	{HAWSER_HILL_TORUS, "complex pair", "lt 3"},
	{-1, "characteristic values", "lc rgb 'black' lw 0.8 dt (3,7)"},
	{-2, "second order", "lc rgb '#707070' lw 0.8 dt (10,6)"},
};
enum { ROWS = sizeof rows/sizeof *rows };

static int has(const struct hawser__hill_picture *hill, int kind)
{
	for (int k = 0; k < hill->lines; k++)
		if (hill->line[k].kind == kind)
			return 1;
	return 0;
}

static void data(FILE *script, const struct hawser__hill_picture *hill, int row)
{
	fprintf(script, "$kind%d << END\n", row);
	for (int k = 0; k < hill->lines; k++) {
		const struct hawser__hill_line *line = &hill->line[k];

		for (int i = 0; line->kind == rows[row].kind && i < line->points; i++)
			fprintf(script, "%.12g %.12g\n", line->at[2*i], line->at[2*i + 1]);
		if (line->kind == rows[row].kind)
			fputc('\n', script);
	}
	fputs("NaN NaN\nEND\n", script);
}

enum hawser_status hawser__plot_hill(const char *path, const struct hawser__hill_picture *hill,
                                     struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 11.5, report);
	FILE *script = picture.script;
	const char *comma = "plot ";

	if (status)
		return status;
	for (int row = 0; row < ROWS; row++)
		data(script, hill, row);
	hawser__picture_panel(&picture, 0.13, 0.965, 0.15, 0.86);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n", hill->from[0], hill->to[0],
	        hill->from[1], hill->to[1]);
	hawser__picture_tics(&picture, 'x', hill->from[0], hill->to[0], 10);
	hawser__picture_tics(&picture, 'y', hill->from[1], hill->to[1], 8);
	fprintf(script, "set xlabel '%s'\n", hill->x_title);
	hawser__picture_ylabel(&picture, "%s", hill->y_title);
	fputs("set key at screen 0.55,0.985 center top horizontal maxrows 2 samplen 2.5 width 2\n", script);
	for (int row = 0; row < ROWS; row++)
		if (has(hill, rows[row].kind)) {
			fprintf(script, "%s$kind%d with lines %s title '%s'", comma, row, rows[row].style,
			        rows[row].label);
			comma = ", ";
		}
	fputs(*comma == 'p' ? "plot NaN notitle\n" : "\n", script);
	return hawser__picture_finish(&picture, report);
}

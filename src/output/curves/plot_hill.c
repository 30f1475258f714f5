/* output/curves/plot_hill.c - stability boundaries in a plane of two parameters, with the
 * results they are compared with. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

static const struct {
	int kind;
	const char *label, *style;
} rows[] = {
	{HAWSER_HILL_PLUS, "multiplier +1", "lt 1"},
	{HAWSER_HILL_MINUS, "multiplier −1", "lt 2"},
	{HAWSER_HILL_TORUS, "complex pair", "lt 3"},
	{-1, "characteristic values", "lc rgb 'black' lw 0.8 dt (3,7)"},
	{-2, "expansion to second order", "lc rgb '#707070' lw 0.8 dt (10,6)"},
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
		const struct hawser__hill_boundary *line = &hill->line[k];

		for (int i = 0; line->kind == rows[row].kind && i < line->points; i++)
			fprintf(script, "%.12g %.12g\n", line->at[2*i]/hill->axis[0].per,
			        line->at[2*i + 1]/hill->axis[1].per);
		if (line->kind == rows[row].kind)
			fputc('\n', script);
	}
	fputs("NaN NaN\nEND\n", script);
}

/* Columns: x and y of two opposite corners of a box. */
static void unstable_data(FILE *script, const struct hawser__hill_picture *hill)
{
	fputs("$unstable << END\n", script);
	for (int k = 0; k < hill->boxes; k++)
		fprintf(script, "%.12g %.12g %.12g %.12g\n", hill->box[4*k]/hill->axis[0].per,
		        hill->box[4*k + 1]/hill->axis[1].per, hill->box[4*k + 2]/hill->axis[0].per,
		        hill->box[4*k + 3]/hill->axis[1].per);
	fputs("NaN NaN NaN NaN\nEND\n", script);
}

static void legend(struct hawser__picture *picture, const struct hawser__hill_picture *hill)
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, hill->boxes ? "unstable" : "no instability found",
	                   "with boxes fs solid border lc rgb '#808080' fc rgb '%s'",
	                   hill->boxes ? HAWSER__UNSTABLE_FILL : "#ffffff");
	for (int row = 0; row < ROWS; row++)
		if (has(hill, rows[row].kind))
			hawser__legend_add(&entries, rows[row].label, "with lines %s", rows[row].style);
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_hill(const char *path, const struct hawser__hill_picture *hill,
                                     struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 12.8, report);
	const double x[2] = {hill->from[0]/hill->axis[0].per, hill->to[0]/hill->axis[0].per};
	const double y[2] = {hill->from[1]/hill->axis[1].per, hill->to[1]/hill->axis[1].per};
	FILE *script = picture.script;

	if (status)
		return status;
	for (int row = 0; row < ROWS; row++)
		data(script, hill, row);
	unstable_data(script, hill);
	hawser__picture_panel(&picture, 0.13, 0.965, 0.28, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n", x[0], x[1], y[0], y[1]);
	hawser__picture_tics(&picture, 'x', x[0], x[1], 10);
	hawser__picture_tics(&picture, 'y', y[0], y[1], 8);
	fprintf(script, "set xlabel '%s'\n", hill->axis[0].title);
	hawser__picture_ylabel(&picture, "%s", hill->axis[1].title);
	fprintf(script, "plot $unstable using 1:2:1:3:2:4 with boxxyerror fs solid noborder lc rgb '%s'",
	        HAWSER__UNSTABLE_FILL);
	for (int row = 0; row < ROWS; row++)
		if (has(hill, rows[row].kind))
			fprintf(script, ", $kind%d with lines %s", row, rows[row].style);
	fputc('\n', script);
	legend(&picture, hill);
	return hawser__picture_finish(&picture, report);
}

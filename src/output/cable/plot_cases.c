/* output/cable/plot_cases.c - load cases of a span: tensions above, sags below, a case each along x.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "output/output.h"
#include "output/cable/plot_cases.h"
#include "output/drawing/style.h"

/* Column, title, symbol and place beside the case of each quantity. */
static const struct {
	const char *title, *style;
	double shift;
} shown[HAWSER__CASE_VALUES] = {
	{"largest tension", "pt 7 ps 0.7 lt 1", -0.08},
	{"H, across the static force", "pt 6 ps 0.7 lt 2", 0.08},
	{"sag", "pt 5 ps 0.7 lt 3", -0.08},
	{"blowout", "pt 4 ps 0.7 lt 4", 0.08},
};

static void data(FILE *script, const struct hawser__cases_picture *of)
{
	fputs("$cases << END\n", script);
	for (int i = 0; i < of->cases; i++) {
		fprintf(script, "%d", i);
		for (int k = 0; k < HAWSER__CASE_VALUES; k++)
			fprintf(script, " %.9g", of->value[HAWSER__CASE_VALUES*i + k]/
			        (k < 2 ? of->tension.per : of->length.per));
		fputc('\n', script);
	}
	fprintf(script, "END\nset xrange [-0.6:%.9g]\nset yrange [0:*]\n", of->cases - 0.4);
}

/* The names along x, or only tics. */
static void tics(FILE *script, const struct hawser__cases_picture *of, int named)
{
	fputs("set xtics rotate by 30 right (", script);
	for (int i = 0; i < of->cases; i++) {
		fputs(i ? ", '" : "'", script);
		hawser__picture_literal(script, named ? of->name[i] : "", 0);
		fprintf(script, "' %d", i);
	}
	fputs(")\n", script);
}

static void pair(FILE *script, int from)
{
	for (int k = from; k < from + 2; k++)
		fprintf(script, "%s$cases using ($1 + %g):%d with impulses %s lw 1.2, "
		        "$cases using ($1 + %g):%d with points %s", k > from ? ", " : "plot ",
		        shown[k].shift, k + 2, shown[k].style + 12, shown[k].shift, k + 2,
		        shown[k].style);
	fputc('\n', script);
}

enum hawser_status hawser__plot_cases(const char *path, const struct hawser__cases_picture *of,
                                      struct hawser_report *report)
{
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 13.4, report);
	FILE *script = picture.script;

	if (status)
		return status;
	data(script, of);
	tics(script, of, 0);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.68, 0.97);
	hawser__picture_ylabel(&picture, "%s", of->tension.title);
	pair(script, 0);
	tics(script, of, 1);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.34, 0.63);
	hawser__picture_ylabel(&picture, "%s", of->length.title);
	pair(script, 2);
	for (int k = 0; k < HAWSER__CASE_VALUES; k++)
		hawser__legend_add(&entries, shown[k].title, "with points %s", shown[k].style);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

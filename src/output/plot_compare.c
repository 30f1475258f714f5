/* output/plot_compare.c - work-precision diagram of methods: error over time, one colour per
 * method. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/output.h"
#include "output/style.h"

/* Smaller errors are drawn at this value, since a logarithmic axis has no zero. */
static const double least = 1e-17;

/* 1 if a run is labelled: some of the runs of a method, but not those that coincide. */
static int labelled(const struct hawser__cost *run, int place, int count)
{
	int step = (count + 5)/6;

	if (run[place].automatic || place % step != 0)
		return 0;
	return place == 0 || fabs(run[place].frequency - run[place - 1].frequency)
	                         > 0.01*run[place].frequency;
}

/* One data block per method: time (ms), two errors, resolution, whether it is automatic, label. */
static int blocks(FILE *script, const struct hawser__cost *run, int runs, int *first)
{
	int methods = 0, begin, end, i;

	for (begin = 0; begin < runs; begin = end) {
		for (end = begin + 1; end < runs && !strcmp(run[end].method, run[begin].method); end++)
			;
		first[methods] = begin;
		fprintf(script, "$method%d << END\n", methods++);
		for (i = begin; i < end; i++)
			fprintf(script, "%.9g %.9g %.9g %d %d %d\n", 1e3*run[i].seconds,
			        fmax(run[i].frequency, least), fmax(run[i].shape, least), run[i].basis,
			        run[i].automatic, labelled(run + begin, i - begin, end - begin));
		fputs("END\n", script);
	}
	return methods;
}

static void panel(FILE *script, int methods, int column)
{
	int m;

	fputs("plot ", script);
	for (m = 0; m < methods; m++) {
		const char *side = m % 2 ? "right offset -0.6,-0.4" : "left offset 0.6,0.4";

		fprintf(script, "%s$method%d using 1:($5 == 0 ? $%d : NaN) with linespoints lt %d pt 7 "
		                "ps 0.45, $method%d using 1:($5 == 1 ? $%d : NaN) with points lt %d pt 6 "
		                "ps 1.3, ", m ? ", " : "", m, column, m + 1, m, column, m + 1);
		fprintf(script, "$method%d using 1:%d:($6 == 1 ? sprintf('%%d', $4) : '') with labels %s "
		                "tc lt %d font ',7'", m, column, side, m + 1);
	}
	fputs("\n", script);
}

static void legend(struct hawser__picture *picture, const struct hawser__cost *run,
                   const int *first, int methods)
{
	struct hawser__legend entries = {0};

	for (int m = 0; m < methods; m++)
		hawser__legend_add(&entries, run[first[m]].method, "with linespoints lt %d pt 7 ps 0.45",
		                   m + 1);
	hawser__legend_add(&entries, "its own choice", "with points lt 7 pt 6 ps 1.3");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_compare(const char *path, const struct hawser__cost *run, int runs,
                                        struct hawser_report *report)
{
	enum { most_methods = 32 };
	int first[most_methods], methods;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 10.2, report);
	FILE *script = picture.script;

	if (status)
		return status;
	methods = blocks(script, run, runs, first);
	fputs("set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\n"
	      "set xlabel 'Time (ms); numbers: resolution'\n"
	      "set offsets graph 0.06, graph 0.10, graph 0.06, graph 0.03\n", script);
	hawser__picture_panel(&picture, 0.13, 0.52, 0.30, 0.96);
	hawser__picture_ylabel(&picture, "Largest relative error of a frequency (–)");
	panel(script, methods, 2);
	fputs("unset label\n", script);
	hawser__picture_panel(&picture, 0.64, 0.985, 0.30, 0.96);
	hawser__picture_ylabel(&picture, "Largest error of a shape (–)");
	panel(script, methods, 3);
	legend(&picture, run, first, methods);
	return hawser__picture_finish(&picture, report);
}

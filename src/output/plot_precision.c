/* output/plot_precision.c - work-precision diagram of fidelities: error over time and over the
 * number of modes, one colour per family.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/output.h"
#include "output/style.h"

enum { most_families = 16 };

/* Smaller errors are drawn at this value, since a logarithmic axis has no zero. */
static const double least = 1e-12;

/* The larger error of fold and peak frequencies; NAN if there is none. */
static double frequency_error(const struct hawser__precision *run)
{
	return fmax(isnan(run->fold) ? run->peak : fmax(run->fold, run->peak), least);
}

static int anything(const struct hawser__precision *run, int runs)
{
	for (int i = 0; i < runs; i++)
		if (isfinite(run[i].fold) || isfinite(run[i].peak))
			return 1;
	return 0;
}

/* One data block per family: time (s), number, error of frequencies, whether incomplete. */
static int blocks(FILE *script, const struct hawser__precision *run, int runs, const char **family)
{
	int families = 0;

	for (int i = 0; i < runs; i++) {
		int known = 0;

		for (int f = 0; f < families; f++)
			known |= strcmp(family[f], run[i].family) == 0;
		if (known || families == most_families)
			continue;
		fprintf(script, "$family%d << END\n", families);
		for (int k = i; k < runs; k++)
			if (!strcmp(run[k].family, run[i].family) && isfinite(frequency_error(&run[k])))
				fprintf(script, "%.9g %d %.9g %d\n", run[k].seconds, run[k].number,
				        frequency_error(&run[k]), run[k].incomplete);
		fputs("END\n", script);
		family[families++] = run[i].family;
	}
	return families;
}

/* Panel over column x. With `numbers` the numbers of modes are written beside the points,
 * alternately above and below for successive families, whose curves may be close. */
static void panel(FILE *script, int families, int x, int numbers)
{
	fputs("plot ", script);
	for (int f = 0; f < families; f++) {
		fprintf(script, "%s$family%d using %d:3 with lines lt %d, "
		                "$family%d using %d:($4 == 0 ? $3 : NaN) with points lt %d pt 7 ps 0.6, "
		                "$family%d using %d:($4 == 1 ? $3 : NaN) with points lt %d pt 6 ps 0.8",
		        f ? ", " : "", f, x, f + 1, f, x, f + 1, f, x, f + 1);
		if (numbers)
			fprintf(script, ", $family%d using %d:3:(sprintf('%%d', $2)) with labels %s "
			                "tc lt %d font ',7'", f, x,
			        f % 2 ? "left offset 0.4,0.6" : "right offset -0.4,-0.6", f + 1);
	}
	fputs("\n", script);
}

/* Integer tics, for numbers of modes. */
static void whole_tics(struct hawser__picture *picture, const struct hawser__precision *run, int runs)
{
	enum { most = 8 };
	double low = INFINITY, high = 0.0;

	for (int i = 0; i < runs; i++) {
		low = fmin(low, run[i].number);
		high = fmax(high, run[i].number);
	}
	hawser__picture_tics(picture, 'x', 0.0, fmax(high - low, most), most);
}

static void legend(struct hawser__picture *picture, const char *const *family, int families)
{
	struct hawser__legend entries = {0};

	for (int f = 0; f < families; f++)
		hawser__legend_add(&entries, family[f], "with linespoints lt %d pt 7 ps 0.6", f + 1);
	hawser__legend_add(&entries, "folds or peaks missing or extra", "with points lt 7 pt 6 ps 0.8");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_precision(const char *path, const struct hawser__precision *run,
                                          int runs, const char *reference,
                                          struct hawser_report *report)
{
	const char *family[most_families];
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 9.8, report);
	FILE *script = picture.script;
	int families;

	if (status)
		return status;
	families = blocks(script, run, runs, family);
	if (!anything(run, runs)) {
		fprintf(script, "unset border\nunset tics\nunset grid\nset xrange [0:1]\nset yrange [0:1]\n"
		        "set label 1 'Nothing that a fidelity found in the range is on the curve of %s too' "
		        "at screen 0.5, screen 0.5 center\nplot NaN\n", reference);
		return hawser__picture_finish(&picture, report);
	}
	fputs("set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\n"
	      "set xlabel 'Processor time (s); numbers: modes'\n"
	      "set offsets graph 0.08, graph 0.14, graph 0.08, graph 0.04\n", script);
	hawser__picture_panel(&picture, 0.13, 0.50, 0.31, 0.96);
	hawser__picture_ylabel(&picture, "Frequency error, off %s", reference);
	panel(script, families, 1, 1);
	fputs("unset label\nunset logscale x\nset format x '%g'\nset xlabel 'Number of modes'\n"
	      "set offsets graph 0.05, graph 0.05, graph 0.08, graph 0.04\n", script);
	hawser__picture_panel(&picture, 0.64, 0.985, 0.31, 0.96);
	hawser__picture_ylabel(&picture, "Largest frequency error of folds, peaks");
	whole_tics(&picture, run, runs);
	panel(script, families, 2, 0);
	legend(&picture, family, families);
	return hawser__picture_finish(&picture, report);
}

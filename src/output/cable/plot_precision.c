/* output/cable/plot_precision.c - work-precision diagram of fidelities: error over time and over the
 * number of modes, one colour per family.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/drawing/labels.h"
#include "output/output.h"
#include "output/drawing/style.h"

enum { most_families = 16 };

/* Smaller errors are drawn at this value, since a logarithmic axis has no zero. */
static const double least = 1e-12;

/* The larger error of fold and peak frequencies; NAN where neither was found. */
static double frequency_error(const struct hawser__precision *run)
{
	double error = isnan(run->fold) ? run->peak : fmax(run->fold, run->peak);

	return isnan(error) ? NAN : fmax(error, least);
}

static int anything(const struct hawser__precision *run, int runs)
{
	for (int i = 0; i < runs; i++)
		if (isfinite(frequency_error(&run[i])))
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

/* Against column x. */
static void panel(FILE *script, int families, int x)
{
	fputs("plot ", script);
	for (int f = 0; f < families; f++)
		fprintf(script, "%s$family%d using %d:3 with lines lt %d, "
		                "$family%d using %d:($4 == 0 ? $3 : NaN) with points lt %d pt 7 ps 0.6, "
		                "$family%d using %d:($4 == 1 ? $3 : NaN) with points lt %d pt 6 ps 0.8",
		        f ? ", " : "", f, x, f + 1, f, x, f + 1, f, x, f + 1);
	fputs("\n", script);
}

static double across(const struct hawser__precision *run, int numbers)
{
	return numbers ? run->number : run->seconds;
}

/* Ranges of the points that are drawn, over the numbers of modes or over the time. */
static void ranges(struct hawser__labels *labels, const struct hawser__precision *run, int runs,
                   int numbers)
{
	double low[2] = {INFINITY, INFINITY}, high[2] = {0.0, 0.0};

	for (int i = 0; i < runs; i++) {
		const double at[2] = {across(&run[i], numbers), frequency_error(&run[i])};

		for (int axis = 0; axis < 2 && isfinite(at[1]); axis++) {
			low[axis] = fmin(low[axis], at[axis]);
			high[axis] = fmax(high[axis], at[axis]);
		}
	}
	hawser__labels_range(labels, 0, low[0], high[0], !numbers);
	hawser__labels_range(labels, 1, low[1], high[1], 1);
}

/* Numbers of modes beside the points over the time. */
static void numbers(struct hawser__labels *labels, struct hawser__picture *picture,
                    const struct hawser__precision *run, int runs, const char *const *family,
                    int families)
{
	for (int i = 0; i < runs; i++)
		hawser__labels_symbol(labels, run[i].seconds, frequency_error(&run[i]));
	for (int f = 0; f < families; f++)
		for (int i = 0, last = -1; i < runs; i++) {
			if (strcmp(run[i].family, family[f]) != 0 || !isfinite(frequency_error(&run[i])))
				continue;
			if (last >= 0)
				hawser__labels_line(labels,
				                    (double[]){run[last].seconds, frequency_error(&run[last])},
				                    (double[]){run[i].seconds, frequency_error(&run[i])});
			last = i;
		}
	for (int f = 0; f < families; f++)
		for (int i = 0; i < runs; i++)
			if (!strcmp(run[i].family, family[f]) && isfinite(frequency_error(&run[i])))
				hawser__labels_put(labels, picture, run[i].seconds, frequency_error(&run[i]),
				                   run[i].number, f + 1);
}

/* Numbers of modes are whole. */
static void whole_tics(struct hawser__picture *picture, const struct hawser__labels *labels)
{
	enum { most = 8 };

	hawser__picture_tics(picture, 'x', 0.0, fmax(labels->high[0] - labels->low[0], most), most);
}

/* A family of which no fold and no peak is on the reference's curve has no point in the picture. */
static int drawn(const struct hawser__precision *run, int runs, const char *family)
{
	for (int i = 0; i < runs; i++)
		if (!strcmp(run[i].family, family) && isfinite(frequency_error(&run[i])))
			return 1;
	return 0;
}

static void legend(struct hawser__picture *picture, const struct hawser__precision *run, int runs,
                   const char *const *family, int families)
{
	struct hawser__legend entries = {0};
	char title[80];

	for (int f = 0; f < families; f++) {
		snprintf(title, sizeof title, "%s%s", family[f],
		         drawn(run, runs, family[f]) ? "" : " (none found)");
		hawser__legend_add(&entries, title, "with linespoints lt %d pt 7 ps 0.6", f + 1);
	}
	hawser__legend_add(&entries, "folds or peaks missing or extra", "with points lt 7 pt 6 ps 0.8");
	hawser__legend_draw(picture, &entries);
}

/* Both panels have the same errors. */
static void panels(struct hawser__picture *picture, const struct hawser__precision *run, int runs,
                   const char *const *family, int families, const char *reference)
{
	static const char *const x_title[] = {"Processor time (s); numbers: modes", "Number of modes"};
	static const double left[] = {0.13, 0.64}, right[] = {0.50, 0.985};
	struct hawser__labels labels;

	for (int k = 0; k < 2; k++) {
		ranges(&labels, run, runs, k);
		hawser__labels_panel(&labels, picture, left[k], right[k], 0.30, 0.92);
		fprintf(picture->script, "set xlabel '%s'\n", x_title[k]);
		if (k == 0)
			numbers(&labels, picture, run, runs, family, families);
		else
			whole_tics(picture, &labels);
		fprintf(picture->script, "set label 999 'reference: %s' at graph 0.5, graph 1.06 center\n",
		        reference);
		hawser__picture_ylabel(picture, "Frequency error of folds, peaks (–)");
		panel(picture->script, families, 1 + k);
	}
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
	panels(&picture, run, runs, family, families, reference);
	legend(&picture, run, runs, family, families);
	return hawser__picture_finish(&picture, report);
}

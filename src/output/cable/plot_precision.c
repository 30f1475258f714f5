/* output/cable/plot_precision.c - work-precision diagram of fidelities: error over time and over the
 * number of modes, one colour per family.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "output/drawing/labels.h"

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

static int families_of(const char **family, const struct hawser__precision *run, int runs)
{
	int families = 0;

	for (int i = 0; i < runs; i++) {
		int known = families == most_families;

		for (int f = 0; f < families; f++)
			known |= strcmp(family[f], run[i].family) == 0;
		if (!known)
			family[families++] = run[i].family;
	}
	return families;
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

/* A family of which no fold and no peak is on the reference's curve has no point in the picture. */
static int drawn(const struct hawser__precision *run, int runs, const char *family)
{
	for (int i = 0; i < runs; i++)
		if (!strcmp(run[i].family, family) && isfinite(frequency_error(&run[i])))
			return 1;
	return 0;
}

/* Runs of a family; hollow where folds or peaks are missing or spurious. */
static void draw_family(struct hawser__figure *figure, const struct hawser__precision *run, int runs,
                        const char *family, int by_number, int colour)
{
	for (int incomplete = -1; incomplete < 2; incomplete++) {
		for (int i = 0; i < runs; i++)
			if (!strcmp(run[i].family, family) && isfinite(frequency_error(&run[i])) &&
			    (incomplete < 0 || incomplete == run[i].incomplete))
				hawser__figure_put(figure, across(&run[i], by_number), frequency_error(&run[i]));
		hawser__figure_draw(figure, NULL, incomplete < 0 ? "with lines lt %d" : incomplete
		                    ? "with points lt %d pt 6 ps 0.8" : "with points lt %d pt 7 ps 0.6",
		                    colour);
	}
}

static void add_entries(struct hawser__legend *legend, const struct hawser__precision *run, int runs,
                        const char *const *family, int families)
{
	char title[80];

	for (int f = 0; f < families; f++) {
		snprintf(title, sizeof title, "%s%s", family[f],
		         drawn(run, runs, family[f]) ? "" : " (none found)");
		hawser__legend_add(legend, title, "with linespoints lt %d pt 7 ps 0.6", f + 1);
	}
	hawser__legend_once(legend, "folds or peaks missing or extra", "with points lt 7 pt 6 ps 0.8");
}

enum hawser_status hawser__plot_precision(const char *path, const struct hawser__precision *run,
                                          int runs, const char *reference,
                                          struct hawser_report *report)
{
	static const struct hawser__axis x[] = {{"Processor time (s); numbers: modes", "", 1.0},
	                                        {"Number of modes", "", 1.0}};
	static const struct hawser__axis y = {"Frequency error of folds, peaks (–)", "", 1.0};
	const char *family[most_families];
	int families = families_of(family, run, runs), any = anything(run, runs);
	struct hawser__labels labels;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, 9.8, report);

	if (status)
		return status;
	if (!any) {
		hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.1, 0.9, 0.3, 0.9, .view = 1,
			.x = {.to = 1.0}, .y = {.to = 1.0}});
		fprintf(figure.out.script,
		        "set label 'Nothing that a fidelity found in the range is on the curve "
		        "of %s too' at graph 0.5, graph 0.5 center\n", reference);
	}
	for (int k = 0; k < 2 && any; k++) { /* both panels have the same errors */
		ranges(&labels, run, runs, k);
		hawser__labels_panel(&labels, &figure, &(struct hawser__panel_frame){k ? 0.64 : 0.13,
			k ? 0.985 : 0.50, 0.30, 0.92, .x = {&x[k], .tics = 7}, .y = {&y, .tics = 6}});
		fprintf(figure.out.script, "set label 'reference: %s' at graph 0.5, graph 1.06 center\n",
		        reference);
		if (k == 0)
			numbers(&labels, &figure.out, run, runs, family, families);
		for (int f = 0; f < families; f++)
			draw_family(&figure, run, runs, family[f], k, f + 1);
	}
	if (any)
		add_entries(&figure.legend, run, runs, family, families);
	return hawser__figure_finish(&figure, report);
}

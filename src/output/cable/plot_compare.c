/* output/cable/plot_compare.c - work-precision diagram of methods: error over time, one colour per
 * method. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/drawing/labels.h"
#include "output/output.h"
#include "output/drawing/style.h"

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

/* One data block a method: time (ms), two errors, the method's own choice. */
static int blocks(FILE *script, const struct hawser__cost *run, int runs, int *first)
{
	int methods = 0, begin, end, i;

	for (begin = 0; begin < runs; begin = end) {
		for (end = begin + 1; end < runs && !strcmp(run[end].method, run[begin].method); end++)
			;
		first[methods] = begin;
		fprintf(script, "$method%d << END\n", methods++);
		for (i = begin; i < end; i++)
			fprintf(script, "%.9g %.9g %.9g %d\n", 1e3*run[i].seconds,
			        fmax(run[i].frequency, least), fmax(run[i].shape, least), run[i].automatic);
		fputs("END\n", script);
	}
	return methods;
}

/* Of frequencies or of shapes. */
static double error_of(const struct hawser__cost *run, int shape)
{
	return fmax(shape ? run->shape : run->frequency, least);
}

static void ranges(struct hawser__labels *labels, const struct hawser__cost *run, int runs, int shape)
{
	double low[2] = {INFINITY, INFINITY}, high[2] = {0.0, 0.0};

	for (int i = 0; i < runs; i++) {
		const double at[2] = {1e3*run[i].seconds, error_of(&run[i], shape)};

		for (int axis = 0; axis < 2; axis++) {
			low[axis] = fmin(low[axis], at[axis]);
			high[axis] = fmax(high[axis], at[axis]);
		}
	}
	for (int axis = 0; axis < 2; axis++)
		hawser__labels_range(labels, axis, low[axis], high[axis], 1);
}

/* Resolutions beside some of the points; a method's own choice is on no line. */
static void numbers(struct hawser__labels *labels, struct hawser__picture *picture,
                    const struct hawser__cost *run, int runs, const int *first, int methods,
                    int shape)
{
	for (int i = 0; i < runs; i++)
		hawser__labels_symbol(labels, 1e3*run[i].seconds, error_of(&run[i], shape));
	for (int m = 0; m < methods; m++)
		for (int i = first[m] + 1; i < first[m + 1]; i++)
			if (!run[i].automatic && !run[i - 1].automatic)
				hawser__labels_line(labels,
				                    (double[]){1e3*run[i - 1].seconds, error_of(&run[i - 1], shape)},
				                    (double[]){1e3*run[i].seconds, error_of(&run[i], shape)});
	for (int m = 0; m < methods; m++)
		for (int i = first[m]; i < first[m + 1]; i++)
			if (labelled(run + first[m], i - first[m], first[m + 1] - first[m]))
				hawser__labels_put(labels, picture, 1e3*run[i].seconds, error_of(&run[i], shape),
				                   run[i].basis, m + 1);
}

static void panel(FILE *script, int methods, int column)
{
	fputs("plot ", script);
	for (int m = 0; m < methods; m++)
		fprintf(script, "%s$method%d using 1:($4 == 0 ? $%d : NaN) with linespoints lt %d pt 7 "
		                "ps 0.45, $method%d using 1:($4 == 1 ? $%d : NaN) with points lt %d pt 6 "
		                "ps 1.3", m ? ", " : "", m, column, m + 1, m, column, m + 1);
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
	static const char *const y_title[] = {"Largest relative error of a frequency (–)",
	                                      "Largest error of a shape (–)"};
	static const double left[] = {0.13, 0.64}, right[] = {0.52, 0.97};
	int first[most_methods + 1], methods;
	struct hawser__labels labels;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 10.2, report);
	FILE *script = picture.script;

	if (status)
		return status;
	methods = blocks(script, run, runs, first);
	first[methods] = runs;
	fputs("set xlabel 'Time (ms); numbers: resolution'\n", script);
	for (int shape = 0; shape < 2; shape++) {
		ranges(&labels, run, runs, shape);
		hawser__labels_panel(&labels, &picture, left[shape], right[shape], 0.30, 0.96);
		numbers(&labels, &picture, run, runs, first, methods, shape);
		hawser__picture_ylabel(&picture, "%s", y_title[shape]);
		panel(script, methods, 2 + shape);
	}
	legend(&picture, run, first, methods);
	return hawser__picture_finish(&picture, report);
}

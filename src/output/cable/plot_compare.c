/* output/cable/plot_compare.c - work-precision diagram of methods: error over time, one colour per
 * method. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "output/drawing/labels.h"

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

/* The first run of each method; returns their number. */
static int methods_of(int *first, const struct hawser__cost *run, int runs)
{
	int methods = 0;

	for (int i = 0; i < runs; i++)
		if (i == 0 || strcmp(run[i].method, run[i - 1].method) != 0)
			first[methods++] = i;
	first[methods] = runs;
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

/* Runs of a method on a line; its own choice apart from it. */
static void draw_method(struct hawser__figure *figure, const struct hawser__cost *run, int count,
                        int shape,
                        int colour)
{
	for (int i = 0; i < count; i++)
		hawser__figure_put(figure, run[i].automatic ? NAN : 1e3*run[i].seconds,
		                   error_of(&run[i], shape));
	hawser__figure_draw(figure, run->method, "with linespoints lt %d pt 7 ps 0.45", colour);
	for (int i = 0; i < count; i++)
		if (run[i].automatic)
			hawser__figure_put(figure, 1e3*run[i].seconds, error_of(&run[i], shape));
	hawser__figure_draw(figure, NULL, "with points lt %d pt 6 ps 1.3", colour);
}

enum hawser_status hawser__plot_compare(const char *path, const struct hawser__cost *run, int runs,
                                        struct hawser_report *report)
{
	enum { most_methods = 32 };
	static const struct hawser__axis time = {"Time (ms); numbers: resolution", "", 1.0};
	static const struct hawser__axis error[] = {
		{"Largest relative error of a frequency (–)", "", 1.0},
		{"Largest error of a shape (–)", "", 1.0}};
	int first[most_methods + 1], methods = methods_of(first, run, runs);
	struct hawser__labels labels;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, 10.2, report);

	if (status)
		return status;
	for (int shape = 0; shape < 2; shape++) {
		ranges(&labels, run, runs, shape);
		hawser__labels_panel(&labels, &figure, &(struct hawser__panel_frame){shape ? 0.64 : 0.13,
			shape ? 0.97 : 0.52, 0.30, 0.96, .x = {&time, .tics = 6}, .y = {&error[shape], .tics = 6}});
		numbers(&labels, &figure.out, run, runs, first, methods, shape);
		for (int m = 0; m < methods; m++)
			draw_method(&figure, run + first[m], first[m + 1] - first[m], shape, m + 1);
	}
	hawser__legend_once(&figure.legend, "its own choice", "with points lt 7 pt 6 ps 1.3");
	return hawser__figure_finish(&figure, report);
}

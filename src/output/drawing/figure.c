/* output/drawing/figure.c - see figure.h.
 *
 * Blocks of data go into the script as they are put. What the plot draws is kept until the panel ends,
 * since the ranges of its axes stand before it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "output/drawing/figure.h"
#include "output/drawing/picture_choice.h"

static const char axis_name[] = "xy";

enum hawser_status hawser__figure_begin(struct hawser__figure *figure, const char *path, double width,
                                        double height, struct hawser_report *report)
{
	return hawser__picture_begin(&figure->out, path, width, height, report);
}

static const struct hawser__panel_axis *panel_axis(const struct hawser__figure *figure, int axis)
{
	return axis ? &figure->at.y : &figure->at.x;
}

static double per_of(const struct hawser__figure *figure, int axis)
{
	const struct hawser__axis *of = panel_axis(figure, axis)->axis;

	return of ? of->per : 1.0;
}

/* 1 if the values vary by round-off alone, or by less than numbers at gnuplot's own tics show: they are
 * drawn as a straight line. */
static int is_even(const double ends[2], const struct hawser__panel_axis *scale)
{
	double size = fmax(fabs(ends[0]), fabs(ends[1]));

	return !(ends[1] - ends[0] > (scale->tics ? 1e-9 : 1e-7)*size);
}

/* Ends of an axis with tics, as they are shown, from those of the points. */
static void widen(double ends[2], const struct hawser__panel_axis *scale)
{
	double size, part;

	if (!(ends[0] <= ends[1]))
		ends[0] = ends[1] = 0.0;
	if (scale->zero) {
		ends[0] = 0.0;
		ends[1] = ends[1] > 0.0 ? (1.0 + scale->room)*ends[1] : 1.0;
		return;
	}
	if (scale->logarithmic && ends[0] > 0.0) {
		part = ends[1] > ends[0] ? pow(ends[1]/ends[0], scale->room) : 3.0;
		ends[0] /= part;
		ends[1] *= part;
		return;
	}
	size = fmax(fabs(ends[0]), fabs(ends[1]));
	part = !is_even(ends, scale) ? scale->room*(ends[1] - ends[0]) : size > 0.0 ? 0.05*size : 1.0;
	ends[0] -= part;
	ends[1] += part;
}

/* The title of an axis, whether the panel shows it or not. */
static const char *title_of(const struct hawser__figure *figure, int axis)
{
	const struct hawser__axis *of = panel_axis(figure, axis)->axis;

	return axis && figure->at.title ? figure->at.title : of ? of->title : "";
}

/* The range that the user has chosen, which is for the first panel and those with its axis, or NULL. */
static const struct hawser__picture_range *chosen_range(const struct hawser__figure *figure, int axis)
{
	return !panel_axis(figure, axis)->other && !strcmp(title_of(figure, axis), figure->first[axis])
		? hawser__picture_range_of(axis) : NULL;
}

int hawser__figure_marked(const struct hawser__figure *figure, int axis, double *place)
{
	const struct hawser__picture_range *range = chosen_range(figure, axis);

	*place /= per_of(figure, axis);
	return figure->marks && !(range && (*place < range->low || *place > range->high));
}

static void put_limit(FILE *to, double limit, const char *after)
{
	if (isfinite(limit))
		fprintf(to, "%.12g%s", limit, after);
	else
		fprintf(to, "*%s", after);
}

static void set_tics(struct hawser__figure *figure, int axis, double low, double high)
{
	const struct hawser__panel_axis *scale = panel_axis(figure, axis);
	const char name[] = {axis_name[axis], '\0'};

	if (scale->logarithmic && scale->tics && low > 0.0 && high > low && isfinite(high))
		hawser__picture_log_tics(&figure->out, name, low, high, scale->logarithmic > 1 ? 1e4 : 30.0);
	else if (scale->logarithmic)
		fprintf(figure->out.script, "set logscale %s\nset format %s '10^{%%T}'\n", name, name);
	else if (scale->tics && isfinite(low) && isfinite(high))
		hawser__picture_tics(&figure->out, *name, low, high, scale->tics);
}

static void set_chosen(struct hawser__figure *figure, int axis,
                       const struct hawser__picture_range *range)
{
	FILE *script = figure->out.script;

	fprintf(script, "set %crange [", axis_name[axis]);
	put_limit(script, range->low, ":");
	put_limit(script, range->high, "]\n");
	set_tics(figure, axis, range->low, range->high);
}

static void set_range(struct hawser__figure *figure, int axis)
{
	const struct hawser__panel_axis *scale = panel_axis(figure, axis);
	int given = scale->from != scale->to, even;
	double per = per_of(figure, axis), low = given ? scale->from/per : figure->low[axis];
	double high = given ? scale->to/per : figure->high[axis], ends[] = {low, high};
	FILE *script = figure->out.script;

	if (!given)
		widen(ends, scale);
	even = scale->zero ? !(high > 0.0) : is_even((double[]){low, high}, scale);
	if (given || even || (scale->tics && !scale->open))
		fprintf(script, "set %crange [%.12g:%.12g]\n", axis_name[axis], ends[0], ends[1]);
	else
		fprintf(script, scale->zero ? "set %crange [0:*]\n" : "set %crange [*:*]\n",
		        axis_name[axis]);
	if (scale->logarithmic)
		set_tics(figure, axis, ends[0], ends[1]);
	else
		set_tics(figure, axis, scale->zero ? 0.0 : fmin(low, high), fmax(low, high));
}

static void set_scale(struct hawser__figure *figure, int axis)
{
	const struct hawser__panel_axis *scale = panel_axis(figure, axis);
	const struct hawser__picture_range *chosen = chosen_range(figure, axis);
	const char *title = scale->bare || scale->untitled ? "" : title_of(figure, axis);
	FILE *script = figure->out.script;
	char name = axis_name[axis];

	if (!scale->as_set)
		fprintf(script, "unset logscale %c\nset format %c '%%g'\nset %ctics autofreq\n", name,
		        name, name);
	figure->logarithmic[axis] |= chosen && scale->logarithmic;
	if (chosen)
		set_chosen(figure, axis, chosen);
	else if (!scale->as_set)
		set_range(figure, axis);
	if (scale->bare)
		fprintf(script, "set format %c ''\n", name);
	if (axis && *title)
		hawser__picture_ylabel(&figure->out, "%s", title);
	else if (*title)
		fprintf(script, "set xlabel '%s' offset 0,0.3\n", title);
	else if (!axis)
		fputs("unset xlabel\n", script);
}

/* The ranges of a view, and no axes. */
static void set_view(struct hawser__figure *figure)
{
	struct hawser__box seen = {.any = 0};

	for (int axis = 0; axis < 2; axis++) {
		const struct hawser__panel_axis *scale = panel_axis(figure, axis);
		int given = scale->from != scale->to;

		seen.low[axis] = given ? scale->from : figure->low[axis];
		seen.high[axis] = given ? scale->to : figure->high[axis];
	}
	fputs("unset border\nunset xtics\nunset ytics\nunset grid\nunset xlabel\n", figure->out.script);
	hawser__eye_fit(figure->out.script, &seen, (figure->at.right - figure->at.left)*figure->out.width,
	                (figure->at.top - figure->at.bottom)*figure->out.height);
}

static void end_block(struct hawser__figure *figure)
{
	if (figure->rows)
		fputs("END\n", figure->out.script);
	figure->rows = 0;
}

static void release(struct hawser__figure *figure)
{
	free(figure->text);
	free(figure->mark_text);
	figure->plot = figure->marks = NULL;
	figure->text = figure->mark_text = NULL;
}

static void end_panel(struct hawser__figure *figure)
{
	if (!figure->plot || !figure->marks)
		return;
	end_block(figure);
	figure->out.scale = figure->at.view ? HAWSER__NO_SCALE
	                    : (figure->at.x.logarithmic > 0) + 2*(figure->at.y.logarithmic > 0);
	if (figure->at.view)
		set_view(figure);
	for (int axis = 0; axis < 2 && !figure->at.view; axis++)
		set_scale(figure, axis);
	if (fclose(figure->marks) == 0)
		fputs(figure->mark_text, figure->out.script);
	if (fclose(figure->plot) == 0 && figure->size > 0)
		fprintf(figure->out.script, "plot %s\n", figure->text);
	else
		fputs("plot NaN notitle\n", figure->out.script);
	release(figure);
}

void hawser__panel_even(struct hawser__panel_frame *at, const struct hawser__box *box, int k,
                        double width, double height)
{
	double x = 0.5*(box->low[0] + box->high[0]), y = 0.5*(box->low[k] + box->high[k]);
	/* a margin of 8 % on each side */
	double per_cm = 1.16*fmax((box->high[0] - box->low[0])/width, (box->high[k] - box->low[k])/height);
	double half;

	if (!(per_cm > 0.0))
		per_cm = 0.1; /* a point: 1 m in 10 cm */
	half = k == 2 ? -0.5*per_cm*height : 0.5*per_cm*height;
	at->x.from = x - 0.5*per_cm*width;
	at->x.to = x + 0.5*per_cm*width;
	at->y.from = y - half;
	at->y.to = y + half;
}

void hawser__figure_panel(struct hawser__figure *figure, const struct hawser__panel_frame *at)
{
	end_panel(figure);
	if (figure->at.view)
		fputs(hawser__picture_axes, figure->out.script);
	figure->at = *at;
	if (at->x.axis)
		figure->at.x.axis = memcpy(&figure->axis[0], at->x.axis, sizeof *figure->axis);
	if (at->y.axis)
		figure->at.y.axis = memcpy(&figure->axis[1], at->y.axis, sizeof *figure->axis);
	for (int axis = 0; axis < 2; axis++) {
		figure->low[axis] = INFINITY;
		figure->high[axis] = -INFINITY;
	}
	hawser__picture_panel(&figure->out, at->left, at->right, at->bottom, at->top);
	if (at->aside > 0.0)
		figure->out.left += 0.107 - at->aside;
	fputs("unset label\nunset arrow\nunset object\n", figure->out.script);
	if (!figure->panels++) {
		hawser__picture_title(figure->out.script);
		for (int axis = 0; axis < 2; axis++)
			snprintf(figure->first[axis], sizeof figure->first[axis], "%s", title_of(figure, axis));
	}
	if (at->keys)
		fputs("set key at graph 1, graph 1.03 bottom right horizontal maxrows 1 samplen 2 font ',9'\n",
		      figure->out.script);
	if (!figure->lacks_memory) {
		figure->plot = open_memstream(&figure->text, &figure->size);
		figure->marks = open_memstream(&figure->mark_text, &figure->mark_size);
	}
	figure->lacks_memory |= !figure->plot || !figure->marks;
}

/* 1 if a place is beyond the ends that the panel gives. */
static int is_outside(const struct hawser__panel_axis *scale, double value)
{
	return scale->from != scale->to &&
	       !(value >= fmin(scale->from, scale->to) && value <= fmax(scale->from, scale->to));
}

static void see(struct hawser__figure *figure, int axis, double value)
{
	if (!isfinite(value) || (panel_axis(figure, axis)->logarithmic && !(value > 0.0)))
		return;
	figure->low[axis] = fmin(figure->low[axis], value);
	figure->high[axis] = fmax(figure->high[axis], value);
}

void hawser__figure_gap(struct hawser__figure *figure)
{
	if (figure->rows && !figure->gap)
		fputc('\n', figure->out.script);
	figure->gap = 1;
}

void hawser__figure_row(struct hawser__figure *figure, const char *columns, const double *value)
{
	static const char letters[] = "xyXY";

	if (!figure->rows++)
		fprintf(figure->out.script, "$d%d << END\n", figure->blocks++);
	for (int k = 0; columns[k]; k++) {
		const char *letter = strchr(letters, columns[k]);
		int axis = letter ? (int)(letter - letters) % 2 : 0;
		double shown = letter ? value[k]/per_of(figure, axis) : value[k];

		if (letter && letter - letters < 2 && (axis == 0 || !is_outside(&figure->at.x, value[0])))
			see(figure, axis, shown);
		if (isnan(shown))
			fputs(" NaN", figure->out.script);
		else
			fprintf(figure->out.script, k ? " %.9g" : "%.12g", shown);
	}
	fputc('\n', figure->out.script);
	figure->gap = 0;
}

void hawser__figure_put(struct hawser__figure *figure, double x, double y)
{
	if (isfinite(x) && isfinite(y))
		hawser__figure_row(figure, "xy", (double[]){x, y});
	else
		hawser__figure_gap(figure);
}

void hawser__figure_see(struct hawser__figure *figure, const struct hawser__eye *eye, const double x[3])
{
	double to[2];

	hawser__eye_see(to, eye, x);
	hawser__figure_put(figure, to[0], to[1]);
}

void hawser__figure_bind(struct hawser__figure *figure, int count, const double *x, size_t x_step,
                         const double *y, size_t y_step)
{
	for (int i = 0; i < count; i++)
		hawser__figure_put(figure, *(const double *)(const void *)((const char *)x + (size_t)i*x_step),
		                   *(const double *)(const void *)((const char *)y + (size_t)i*y_step));
}

/* Add to the plot, and to the legend unless it has that name. */
static void add(struct hawser__figure *figure, const char *data, const char *title, const char *style)
{
	const char *look = strstr(style, "with ");

	fflush(figure->plot);
	fprintf(figure->plot, "%s%s%s%s", figure->size ? ", " : "", data, *data ? " " : "", style);
	/* without keys it is the name of the series in SVG alone */
	fprintf(figure->plot, " title '%s'", title ? title : "");
	if (title && *title && !figure->at.keys)
		hawser__legend_once(&figure->legend, title, look ? look : style);
}

static void draw_block(struct hawser__figure *figure, const char *title, const char *style,
                       va_list args)
{
	char look[HAWSER__STYLE], name[24];

	vsnprintf(look, sizeof look, style, args);
	snprintf(name, sizeof name, "$d%d", figure->blocks - 1);
	if (figure->plot)
		add(figure, name, title, look);
}

void hawser__figure_draw(struct hawser__figure *figure, const char *title, const char *style, ...)
{
	va_list args;

	figure->drawn = figure->rows > 0;
	end_block(figure);
	va_start(args, style);
	if (figure->drawn)
		draw_block(figure, title, style, args);
	va_end(args);
}

void hawser__figure_again(struct hawser__figure *figure, const char *title, const char *style, ...)
{
	va_list args;

	va_start(args, style);
	if (figure->drawn)
		draw_block(figure, title, style, args);
	va_end(args);
}

void hawser__figure_function(struct hawser__figure *figure, const char *title, const char *formula, ...)
{
	char look[HAWSER__STYLE];
	va_list args;

	va_start(args, formula);
	vsnprintf(look, sizeof look, formula, args);
	va_end(args);
	if (figure->plot)
		add(figure, "", title, look);
}

enum hawser_status hawser__figure_finish(struct hawser__figure *figure, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	end_panel(figure);
	if (figure->lacks_memory)
		status = hawser__no_memory(report, "picture");
	for (int axis = 0; axis < 2 && !status; axis++)
		if (figure->logarithmic[axis])
			status = hawser__picture_logarithmic(axis_name[axis], report);
	if (status) {
		hawser__figure_abort(figure);
		return status;
	}
	hawser__legend_cautions(&figure->legend);
	if (figure->legend.count)
		hawser__legend_draw(&figure->out, &figure->legend);
	return hawser__picture_finish(&figure->out, report);
}

void hawser__figure_abort(struct hawser__figure *figure)
{
	if (figure->plot)
		fclose(figure->plot);
	if (figure->marks)
		fclose(figure->marks);
	release(figure);
	hawser__picture_abort(&figure->out);
}

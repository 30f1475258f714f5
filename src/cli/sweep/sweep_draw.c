/* cli/sweep/sweep_draw.c - the picture of a sweep: which key is the abscissa, which columns are
 * drawn, and what makes a curve. See sweep.h.
 *
 * The abscissa is the key with the most different numbers. The values of the other keys, and
 * the place of a row among those of its variation, make a curve of its own each.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/sweep/sweep.h"
#include "core/append.h"
#include "core/order.h"
#include "core/report.h"
#include "output/fields/fields.h"
#include "output/drawing/figure.h"

enum { PANELS = 6, CURVES = 12, LABEL = 120 };

struct drawing {
	const struct cli_sweep_result *result;
	const struct cli_sweep_plan *plan;
	int key, axis;            /* the abscissa */
	long points;              /* different values of it */
	double *x;                /* [points] in its own unit, ascending */
	int column[PANELS], panels;
	double largest[PANELS];   /* modulus */
	long curves;
	long *place;              /* [lines] of a line among those of its variation */
	long places;              /* the largest number of them */
};

/* --- the abscissa --- */

/* The different numbers of a key; 0 without memory. */
static long different(double **values, const struct cli_sweep_key *key, long count)
{
	long kept = 0;

	*values = malloc((size_t)count*sizeof **values);
	if (!*values)
		return 0;
	memcpy(*values, key->number, (size_t)count*sizeof **values);
	qsort(*values, (size_t)count, sizeof **values, hawser__ascending);
	for (long i = 0; i < count; i++)
		if (i == 0 || (*values)[i] != (*values)[kept - 1])
			(*values)[kept++] = (*values)[i];
	return kept;
}

static enum hawser_status choose_abscissa(struct drawing *of, struct hawser_report *report)
{
	const struct cli_sweep_plan *plan = of->plan;

	of->key = -1;
	for (int a = 0; a < plan->axes; a++)
		for (int k = plan->axis[a].first; k < plan->axis[a].first + plan->axis[a].keys; k++) {
			double *values = NULL;
			long count = plan->key[k].numbers ? different(&values, &plan->key[k], plan->axis[a].values)
			                                  : 0;

			if (count > of->points) {
				free(of->x);
				of->x = values;
				of->points = count;
				of->key = k;
				of->axis = a;
			} else {
				free(values);
			}
		}
	if (of->key < 0 || of->points < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--plot: no varied key has two "
		                    "different numbers to draw over; leave it out");
	if (of->points < plan->axis[of->axis].values)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--plot: values of %s repeat among "
		                    "those that vary together: there is no curve over it; leave it out",
		                    plan->key[of->key].key);
	of->curves = plan->count/plan->axis[of->axis].values;
	return HAWSER_OK;
}

/* Values at equal ratios, as ":log" makes them. */
static int is_logarithmic(const struct drawing *of)
{
	double ratio = of->x[1]/of->x[0];

	for (long i = 2; i < of->points; i++)
		if (!(fabs(of->x[i]/of->x[i - 1] - ratio) < 1e-6*ratio))
			return 0;
	return of->points > 2 && of->x[0] > 0.0 && ratio > 1.0 &&
	       of->x[of->points - 1] > 3.0*of->x[0];
}

/* --- the columns --- */

/* largest: the largest modulus in a column. Returns 0 if it does not vary by more than
 * round-off. */
static int varies(double *largest, const struct cli_sweep_result *result, int column)
{
	double low = INFINITY, high = -INFINITY;

	for (long i = 0; i < result->lines; i++) {
		double value = cli_sweep_number(&result->line[i], column);

		if (isfinite(value)) {
			low = fmin(low, value);
			high = fmax(high, value);
		}
	}
	*largest = fmax(fabs(high), fabs(low));
	return high > low && high - low > 1e-9**largest;
}

/* The first that vary. */
static void choose_columns(struct drawing *of)
{
	const struct cli_sweep_result *result = of->result;

	for (int c = 0; c < result->columns && of->panels < PANELS; c++)
		if (varies(&of->largest[of->panels], result, c) &&
		    strcmp(result->column[c], "index") != 0)
			of->column[of->panels++] = c;
}

/* "sag (m)" of "sag_m", in gnuplot's markup. */
struct hawser__axis cli_sweep_column_axis(const char *column, double largest)
{
	const char *unit = "";
	char bare[LABEL], shown[HAWSER__AXIS_SIZE - 32], ending[HAWSER__UNIT_SIZE + 2];
	size_t length = strlen(column), best = 0;

	for (int u = HAWSER__NONE + 1; u < HAWSER__UNITS; u++) {
		struct hawser__shown_unit one = hawser__shown_unit(hawser__unit_name((enum hawser__unit)u));
		const char *suffix = hawser__unit_suffix((enum hawser__unit)u, &hawser__si);
		size_t size;

		hawser__unit_end(ending, sizeof ending, one.name);
		suffix = one.changed ? ending : suffix;
		size = strlen(suffix);
		if (size > best && size < length && strcmp(column + length - size, suffix) == 0) {
			best = size;
			unit = hawser__unit_name((enum hawser__unit)u);
		}
	}
	snprintf(bare, sizeof bare, "%.*s", (int)(length - best), column);
	cli_key_title(shown, sizeof shown, bare);
	return hawser__axis_of(shown, best ? unit : "", largest);
}

/* --- the curves --- */

/* The number of a line's curve: by the other keys' values, and by its place. */
static long curve_of(const struct drawing *of, long line)
{
	const struct cli_sweep_plan *plan = of->plan;
	long number = 0;

	for (int a = 0; a < plan->axes; a++)
		if (a != of->axis)
			number = number*plan->axis[a].values +
			         cli_sweep_at(plan, plan->axis[a].first, of->result->line[line].variation);
	return number*of->places + of->place[line];
}

static enum hawser_status count_curves(struct drawing *of, struct hawser_report *report)
{
	const struct cli_sweep_result *result = of->result;

	of->place = calloc((size_t)result->lines, sizeof *of->place);
	if (!of->place)
		return hawser__no_memory(report, "sweep");
	of->places = 1;
	for (long i = 1; i < result->lines; i++) {
		of->place[i] = result->line[i].variation == result->line[i - 1].variation
			? of->place[i - 1] + 1 : 0;
		if (of->place[i] >= of->places)
			of->places = of->place[i] + 1;
	}
	of->curves *= of->places;
	return HAWSER_OK;
}

/* The first word of a line, such as the plane of a mode; "" if there is none. */
static const char *word_of(const struct cli_sweep_line *line)
{
	const char *text = line->cell;

	for (int c = 0; text && c < line->head->columns; c++) {
		if (*text == '\'')
			return text + 1;
		text += strlen(text) + 1;
	}
	return "";
}

static void curve_label(char label[LABEL], const struct drawing *of, long line)
{
	const struct cli_sweep_plan *plan = of->plan;
	const struct cli_sweep_line *row = &of->result->line[line];
	char text[LABEL] = "", name[2*LABEL];

	for (int k = 0; k < plan->keys; k++) {
		const struct cli_sweep_key *key = &plan->key[k];
		long at = cli_sweep_at(plan, k, row->variation);
		int axis = 0;

		while (k >= plan->axis[axis].first + plan->axis[axis].keys)
			axis++;
		if (axis == of->axis)
			continue;
		if (key->text)
			hawser__append(text, sizeof text, ", ", "%s = %s", key->key, key->text[at]);
		else
			hawser__append(text, sizeof text, ", ", "%s = %.6g%s%s", key->key, key->number[at],
			               *key->unit ? " " : "", key->unit);
	}
	if (of->places > 1)
		hawser__append(text, sizeof text, ", ", "%ld%s%s", of->place[line] + 1,
		               *word_of(row) ? ": " : "", word_of(row));
	cli_key_title(name, sizeof name, text);
	snprintf(label, LABEL, "%.119s", name);
}

/* The place of a line's value on the abscissa. */
static long point_of(const struct drawing *of, long line)
{
	const struct cli_sweep_key *key = &of->plan->key[of->key];
	double value = key->number[cli_sweep_at(of->plan, of->key, of->result->line[line].variation)];
	const double *found = bsearch(&value, of->x, (size_t)of->points, sizeof *of->x, hawser__ascending);

	return found ? (long)(found - of->x) : 0;
}

/* Values [panels][curves][points], NAN where there is none, and names of the curves. */
static void fill(double *y, char (*label)[LABEL], const struct drawing *of, size_t curves)
{
	const struct cli_sweep_result *result = of->result;
	size_t points = (size_t)of->points;

	for (size_t i = 0; i < points*curves*(size_t)of->panels; i++)
		y[i] = NAN;
	for (long i = 0; i < result->lines; i++) {
		size_t curve = (size_t)curve_of(of, i), point = (size_t)point_of(of, i);

		if (curve >= curves)
			continue;
		for (int p = 0; p < of->panels; p++)
			y[((size_t)p*curves + curve)*points + point] =
				cli_sweep_number(&result->line[i], of->column[p]);
		/* a row without result has no words: a later one may name the curve */
		if (of->curves > 1 && result->line[i].cell && !*label[curve])
			curve_label(label[curve], of, i);
	}
}

struct hawser__axis cli_sweep_key_axis(const struct cli_sweep_key *key, double largest)
{
	const char *unit = *key->unit ? key->unit : cli_key_unit(key->key), *quantity, *symbol;
	char title[256];

	if (!cli_axis_quantity(&quantity, &symbol, key->key))
		cli_key_title(title, sizeof title, key->key);
	else
		snprintf(title, sizeof title, "%s%s%s", quantity, *symbol ? " " : "", symbol);
	return hawser__axis_of(title, strcmp(unit, "1") == 0 ? "" : unit, largest);
}

/* The ends of the abscissa; a range of its own for one value. */
static struct hawser__panel_axis across(const struct drawing *of, const struct hawser__axis *axis)
{
	double low = of->x[0], high = of->x[of->points - 1], part = fmax(0.05*fabs(low), 1e-9);
	int wide = high > low;

	return (struct hawser__panel_axis){axis, wide ? low : low - part, wide ? high : high + part,
		.tics = 8, .logarithmic = is_logarithmic(of)};
}

/* A panel for each quantity, one below the other, a colour for each curve. */
static enum hawser_status draw_panels(const char *path, const struct drawing *of, const double *y,
                                      char (*label)[LABEL], int curves, struct hawser_report *report)
{
	const struct hawser__axis axis = cli_sweep_key_axis(&of->plan->key[of->key], of->x[of->points - 1]);
	struct hawser__panel_axis x = across(of, &axis);
	double tall = of->panels == 1 ? 7.0 : 4.6, foot = *label[0] ? HAWSER__LEGEND_CM : 1.7; /* cm */
	double height = foot + of->panels*tall + 0.3;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, height, report);

	for (int p = 0; p < of->panels && !status; p++) {
		const struct hawser__axis quantity =
			cli_sweep_column_axis(of->result->column[of->column[p]], of->largest[p]);
		double bottom = foot + (of->panels - 1 - p)*tall;

		x.bare = p + 1 < of->panels;
		hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.135, 0.965, bottom/height,
			(bottom + tall - (of->panels == 1 ? 0.0 : 0.35))/height, .x = x,
			.y = {&quantity, .tics = of->panels == 1 ? 7 : 4, .room = 0.06}});
		for (int c = 0; c < curves; c++) {
			for (long i = 0; i < of->points; i++)
				if (isfinite(y[(p*(long)curves + c)*of->points + i]))
					hawser__figure_put(&figure, of->x[i], y[(p*(long)curves + c)*of->points + i]);
			hawser__figure_draw(&figure, label[c], "with linespoints lt %d lw 1.3%s pt 7 ps %s",
			                    c % 6 + 1,
			                    c < 6 ? "" : " dt (8,5)", of->points > 40 ? "0.25" : "0.5");
		}
	}
	return status ? status : hawser__figure_finish(&figure, report);
}

static enum hawser_status draw(const char *path, struct drawing *of, struct hawser_report *report)
{
	int curves = of->curves < CURVES ? (int)of->curves : CURVES;
	char (*label)[LABEL] = calloc(CURVES, sizeof *label);
	double *y = malloc((size_t)of->points*(size_t)curves*(size_t)of->panels*sizeof *y);
	enum hawser_status status = label && y ? HAWSER_OK : hawser__no_memory(report, "sweep");

	if (!status) {
		fill(y, label, of, (size_t)curves);
		status = draw_panels(path, of, y, label, curves, report);
	}
	free(label);
	free(y);
	return status;
}

enum hawser_status cli_sweep_draw_check(const struct cli_sweep_plan *plan,
                                        struct hawser_report *report)
{
	struct drawing drawing = {.plan = plan};
	enum hawser_status status = choose_abscissa(&drawing, report);

	free(drawing.x);
	if (status || drawing.curves <= CURVES || cli_sweep_is_map(plan))
		return status;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--plot: %ld curves are more than the %d "
	                    "that can be told apart, and a map has two keys with values at equal "
	                    "distances: vary less, or leave it out", drawing.curves, CURVES);
}

/* A picture that cannot be as it should is no reason to lose the table. */
static void warn(const struct drawing *of)
{
	char text[CLI_WARNING_SIZE];

	if (of->panels == 0) {
		cli_warn("there is no picture: no column of the result has numbers that vary");
	} else if (of->curves > CURVES) {
		snprintf(text, sizeof text, "the picture has the first %d of %ld curves, since more cannot be "
		         "told apart: choose rows by --last, --max or --min", CURVES, of->curves);
		cli_warn(text);
	}
}

enum hawser_status cli_sweep_draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_sweep_result *result = of;
	struct drawing drawing = {.result = result, .plan = &result->sweep->plan};
	enum hawser_status status = choose_abscissa(&drawing, report);
	int map = drawing.curves > CURVES;

	choose_columns(&drawing);
	if (!status && !map)
		status = count_curves(&drawing, report);
	if (!status && (!map || drawing.panels == 0))
		warn(&drawing);
	if (!status && drawing.panels > 0)
		status = map ? cli_sweep_map(path, result, drawing.column[0], drawing.largest[0], report)
		             : draw(path, &drawing, report);
	free(drawing.x);
	free(drawing.place);
	return status;
}

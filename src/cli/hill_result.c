/* cli/hill_result.c - see hill_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/condensed.h"
#include "cli/hill_result.h"
#include "core/report.h"

/* Of delta: a width below is less than its digits tell. */
#define NARROWEST 2e-15

static const char *unit(const struct cli_hill_result *result, const char *name)
{
	return result->model && result->model->rom.scaled ? name : "";
}

static void head(struct hawser__table *table, const struct cli_hill_result *result,
                 const char *method)
{
	if (result->model) {
		cli_echo_table(table, result->common, "hill",
		               result->model->has_scene ? &result->model->scene : NULL, method);
		return;
	}
	hawser__table_comment(table, "hawser %s hill", hawser_version());
	hawser__table_comment(table,
	                      "Mathieu's equation x'' + 2 c x' + (delta + 2 epsilon cos 2t) x = 0, "
	                      "c = %.9g",
	                      result->damping);
	hawser__table_comment(table, "method: %s", method);
}

static void head_json(struct hawser__json *json, const struct cli_hill_result *result)
{
	if (result->model) {
		cli_echo_json(json, result->common, "hill",
		              result->model->has_scene ? &result->model->scene : NULL);
		return;
	}
	hawser__json_begin(json);
	hawser__json_text(json, json->root, "version", hawser_version());
	hawser__json_text(json, json->root, "command", "hill");
	hawser__json_number(json, json->root, "damping", result->damping);
}

/* --- boundaries --- */

/* Whether boundaries are those of Mathieu's equation without damping, which have characteristic
 * values. */
static int characteristic(const struct cli_hill_result *result)
{
	return !result->model && result->damping == 0.0;
}

/* Distance of a point from the characteristic value of its boundary. a_r is the upper boundary of
 * tongue r, b_r the lower one; where epsilon is negative those of odd order change places. */
static double off(const struct hawser_hill_boundary *boundary, const double *at)
{
	int r = boundary->order, swapped = r%2 && at[1] < 0.0;
	int odd = r > 0 && (boundary->upper ? swapped : !swapped);
	double distance;

	return hawser_mathieu_distance(&distance, at[0], r, odd, at[1], NULL) ? NAN : distance;
}

/* What the tongues of Mathieu's equation are, in comments. */
static void tongues(struct hawser__table *table, const struct cli_hill_result *result)
{
	const struct hawser_hill_chart *chart = &result->chart;
	double worst = 0.0;

	for (int i = 0; i < chart->tongues; i++) {
		const struct hawser_hill_tongue *tongue = &chart->tongue[i];

		if (isinf(tongue->opens))
			hawser__table_comment(table, "tongue %d: closed by the damping in this plane",
			                      tongue->order);
		else if (result->damping > 0.0)
			hawser__table_comment(table, "tongue %d: begins at epsilon %.9g; %.2e to %.2e wide",
			                      tongue->order, tongue->opens, tongue->width[0],
			                      tongue->width[1]);
		else
			hawser__table_comment(table, "tongue %d: %.2e to %.2e wide%s", tongue->order,
			                      tongue->width[0], tongue->width[1],
			                      tongue->width[1] < NARROWEST*tongue->order*tongue->order
			                      ? ", less than digits of delta can tell" : "");
	}
	hawser__table_comment(table, "truncation of the Hill matrices: %.1e of delta", chart->truncation);
	if (!characteristic(result))
		return;
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < chart->boundary[b].points; i++)
			worst = fmax(worst, fabs(off(&chart->boundary[b], chart->boundary[b].at + 2*i)));
	hawser__table_comment(table, "largest distance from a characteristic value: %.2e", worst);
}

static const char *column_unit(const struct cli_map_axis *axis)
{
	return *axis->unit && strcmp(axis->unit, "1") != 0 ? axis->unit : "";
}

void cli_hill_boundaries_table(struct hawser__table *table, const void *of)
{
	const struct cli_hill_result *result = of;
	const struct hawser_hill_chart *chart = &result->chart;

	head(table, result, result->model ? "boundaries of stability by continuation"
	                                  : "boundaries of stability by the Hill matrices");
	for (int b = 0; b < chart->boundaries; b++)
		if (chart->boundary[b].named)
			hawser__table_comment(table, "boundary %d: %s, tongue %d, %d points", b + 1,
			                      hawser_hill_kind_name(chart->boundary[b].kind),
			                      chart->boundary[b].order, chart->boundary[b].points);
		else
			hawser__table_comment(table, "boundary %d: %s, %d points", b + 1,
			                      hawser_hill_kind_name(chart->boundary[b].kind),
			                      chart->boundary[b].points);
	if (!result->model)
		tongues(table, result);
	else if (result->field->condensed)
		cli_condensed_comment(table, result->field->condensed);
	if (chart->interrupted)
		hawser__table_comment(table, "interrupted: boundaries are missing");
	hawser__table_comment(table, result->model ? "%ld points of the plane"
	                                           : "%ld eigenvalue problems", chart->evaluations);
	hawser__table_column(table, "boundary");
	hawser__table_column(table, "kind");
	for (int k = 0; k < 2; k++)
		hawser__table_column(table, "%s%s%s", result->axis[k].key,
		                     *column_unit(&result->axis[k]) ? "_" : "", column_unit(&result->axis[k]));
	if (characteristic(result))
		hawser__table_column(table, "off_characteristic");
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < chart->boundary[b].points; i++) {
			const double *at = chart->boundary[b].at + 2*i;

			hawser__table_number(table, b + 1);
			hawser__table_word(table, hawser_hill_kind_name(chart->boundary[b].kind));
			hawser__table_number(table, at[0]);
			hawser__table_number(table, at[1]);
			if (characteristic(result))
				hawser__table_number(table, off(&chart->boundary[b], at));
		}
}

void cli_hill_boundaries_json(struct hawser__json *json, const void *of)
{
	const struct cli_hill_result *result = of;
	const struct hawser_hill_chart *chart = &result->chart;
	json_t *list, *row, *points;

	head_json(json, result);
	row = hawser__json_object(json, json->root, "axes");
	hawser__json_text(json, row, "x", result->axis[0].key);
	hawser__json_text(json, row, "y", result->axis[1].key);
	list = hawser__json_array(json, json->root, "boundaries");
	for (int b = 0; b < chart->boundaries; b++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "kind", hawser_hill_kind_name(chart->boundary[b].kind));
		if (chart->boundary[b].named)
			hawser__json_integer(json, row, "tongue", chart->boundary[b].order);
		points = hawser__json_array(json, row, "points");
		for (int i = 0; i < chart->boundary[b].points; i++)
			hawser__json_numbers(json, points, NULL, chart->boundary[b].at + 2*i, 2, 1.0);
	}
	list = result->model ? NULL : hawser__json_array(json, json->root, "tongues");
	for (int i = 0; i < chart->tongues; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "tongue", chart->tongue[i].order);
		hawser__json_numbers(json, row, "width", chart->tongue[i].width, 2, 1.0);
		hawser__json_flag(json, row, "closed", isinf(chart->tongue[i].opens));
		if (isfinite(chart->tongue[i].opens))
			hawser__json_number(json, row, "opens", chart->tongue[i].opens);
	}
	if (result->model && result->field->condensed)
		cli_condensed_json(json, result->field->condensed);
	hawser__json_flag(json, json->root, "interrupted", chart->interrupted);
	hawser__json_integer(json, json->root, "evaluations", chart->evaluations);
	cli_stats_json(json, result->common);
}

enum { SAMPLES = 200, OVER = 4*CLI_HILL_ORDERS };

/* The least order of a boundary. */
static int first_order(const struct hawser_hill_chart *chart)
{
	int first = chart->boundaries ? chart->boundary[0].order : 0;

	for (int b = 1; b < chart->boundaries; b++)
		first = chart->boundary[b].order < first ? chart->boundary[b].order : first;
	return first;
}

/* Characteristic values (kind -1) and expansions (-2), [SAMPLES][2] each. */
static int compared(struct hawser__hill_line *line, double *at,
                    const struct cli_hill_result *result)
{
	int count = 0, first = first_order(&result->chart);

	for (int r = first; r < first + CLI_HILL_ORDERS; r++)
		for (int which = 0; which < 4; which++) {
			double *own = at + (size_t)count*SAMPLES*2, low = result->axis[1].from;
			int odd = which%2, expansion = which/2, k = 0;

			if ((odd && !r) || (expansion && r > 4))
				continue;
			for (int i = 0; i < SAMPLES; i++) {
				double e = low + (result->axis[1].to - low)*i/(SAMPLES - 1), value;

				if (expansion)
					value = hawser_mathieu_expansion(r, odd, e, 0);
				else if (hawser_mathieu_value(&value, r, odd, e, NULL))
					continue;
				own[2*k] = value;
				own[2*k++ + 1] = e;
			}
			line[count++] = (struct hawser__hill_line){expansion ? -2 : -1, k, own};
		}
	return count;
}

enum hawser_status cli_hill_draw(const char *path, const void *context,
                                 struct hawser_report *report)
{
	const struct cli_hill_result *result = context;
	const struct hawser_hill_chart *chart = &result->chart;
	struct hawser__hill_line *line = calloc((size_t)chart->boundaries + OVER, sizeof *line);
	double *at = malloc((size_t)OVER*SAMPLES*2*sizeof *at);
	double *box = NULL;
	char title[2][96];
	struct hawser__hill_picture picture = {.line = line, .per = {1.0, 1.0}};
	enum hawser_status status;

	if (!line || !at) {
		free(line);
		free(at);
		return hawser__no_memory(report, "hill");
	}
	for (int b = 0; b < chart->boundaries; b++)
		line[picture.lines++] = (struct hawser__hill_line){(int)chart->boundary[b].kind,
			chart->boundary[b].points, chart->boundary[b].at};
	if (!result->model)
		picture.lines += compared(line + picture.lines, at, result);
	for (int k = 0; k < 2; k++) {
		const char *key = result->axis[k].key;

		if (result->model)
			cli_axis_title(title[k], sizeof title[k], key, result->axis[k].unit,
			               &picture.per[k], result->axis[k].to);
		else
			snprintf(title[k], sizeof title[k], "{/:Italic %s}", k ? "ε" : "δ");
		picture.from[k] = result->axis[k].from;
		picture.to[k] = result->axis[k].to;
	}
	picture.x_title = title[0];
	picture.y_title = title[1];
	status = cli_hill_unstable(&box, &picture.boxes, result, report);
	picture.box = box;
	if (!status)
		status = hawser__plot_hill(path, &picture, report);
	free(box);
	free(line);
	free(at);
	return status;
}

/* --- multipliers --- */

static const char *verdict(const struct cli_hill_result *result)
{
	return result->outside > 0 ? "unstable" : result->undecided > 0 ? "undecided" : "stable";
}

void cli_hill_multipliers_table(struct hawser__table *table, const void *of)
{
	const struct cli_hill_result *result = of;
	double per_omega = cli_per_omega(result->model), period = 2.0*M_PI*per_omega/result->omega;
	double sum = 0.0;
	char more[80] = "";

	for (int i = 0; i < result->m; i++)
		sum += result->log_modulus[i];
	if (result->undecided > 0)
		snprintf(more, sizeof more, ", %d undecided (on it within the error)", result->undecided);
	head(table, result, result->orbit ? "Floquet multipliers about the periodic response"
	                                  : "Floquet multipliers about rest");
	hawser__table_comment(table,
	                      "Omega = %.12g%s: %s, %d of %d multipliers outside the unit circle%s",
	                      result->omega, unit(result, " rad/s"), verdict(result), result->outside,
	                      result->m, more);
	hawser__table_comment(table, "sum of the logarithms: %.15g; estimated error of one: %.1e", sum,
	                      result->error);
	hawser__table_column(table, "multiplier");
	hawser__table_column(table, "log_modulus");
	hawser__table_column(table, "argument_rad");
	hawser__table_column(table, "modulus");
	hawser__table_column(table, "exponent_re%s", unit(result, "_1_s"));
	hawser__table_column(table, "exponent_im%s", unit(result, "_rad_s"));
	for (int i = 0; i < result->m; i++) {
		hawser__table_number(table, i + 1);
		hawser__table_number(table, result->log_modulus[i]);
		hawser__table_number(table, result->argument[i]);
		hawser__table_number(table, exp(fmin(result->log_modulus[i], 700.0)));
		hawser__table_number(table, result->log_modulus[i]/period*per_omega);
		hawser__table_number(table, result->argument[i]/period*per_omega);
	}
}

void cli_hill_multipliers_json(struct hawser__json *json, const void *of)
{
	const struct cli_hill_result *result = of;
	json_t *list, *row;

	head_json(json, result);
	hawser__json_number(json, json->root, "Omega", result->omega);
	hawser__json_text(json, json->root, "about", result->orbit ? "orbit" : "rest");
	hawser__json_number(json, json->root, "error", result->error);
	list = hawser__json_array(json, json->root, "multipliers");
	for (int i = 0; i < result->m; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "log_modulus", result->log_modulus[i]);
		hawser__json_number(json, row, "argument", result->argument[i]);
	}
	cli_stats_json(json, result->common);
}

/* --- a forced response as Mathieu's equation --- */

void cli_hill_forced_table(struct hawser__table *table, const void *of)
{
	const struct cli_hill_result *result = of;
	const struct hawser_frf *frf = result->frf;
	int differ[2] = {0, 0};

	for (int i = 0; i < frf->points; i++)
		for (int k = 0; k < 2; k++)
			differ[k] += (frf->point[i].unstable > 0) != (result->mathieu[2*i + k] > 1e-8);
	head(table, result,
	     "true multipliers of the response beside those of its Mathieu equation (B 4.114)");
	hawser__table_comment(table,
	                      "mode %d: delta'' + c delta' + (omega^2 + 3/2 C a^2 (1 + cos 2 Omega t)) "
	                      "delta = 0, a the largest |u_%d| of the response", result->mode + 1,
	                      result->mode + 1);
	hawser__table_comment(table, "C (scaled): own %.9g, effective %.9g", result->own,
	                      result->effective);
	hawser__table_comment(table,
	                      "of %d points the verdict differs at %d with the mode's own C, at %d with "
	                      "the effective one", frf->points, differ[0], differ[1]);
	hawser__table_column(table, "Omega%s", unit(result, "_rad_s"));
	hawser__table_column(table, "a%s", unit(result, "_m"));
	hawser__table_column(table, "unstable");
	hawser__table_column(table, "log_modulus");
	hawser__table_column(table, "mathieu_own");
	hawser__table_column(table, "mathieu_effective");
	for (int i = 0; i < frf->points; i++) {
		hawser__table_number(table, frf->point[i].omega*cli_per_omega(result->model));
		hawser__table_number(table,
		                     frf->coordinate[(size_t)i*(size_t)frf->n + (size_t)result->mode]*
		                            cli_per_length(result->model));
		hawser__table_number(table, frf->point[i].unstable);
		hawser__table_number(table, frf->multiplier[(size_t)i*4*(size_t)frf->n]);
		hawser__table_number(table, result->mathieu[2*i]);
		hawser__table_number(table, result->mathieu[2*i + 1]);
	}
}

void cli_hill_forced_json(struct hawser__json *json, const void *of)
{
	const struct cli_hill_result *result = of;
	const struct hawser_frf *frf = result->frf;
	json_t *list, *row;

	head_json(json, result);
	hawser__json_integer(json, json->root, "mode", result->mode + 1);
	hawser__json_number(json, json->root, "own_cubic_scaled", result->own);
	hawser__json_number(json, json->root, "effective_cubic_scaled", result->effective);
	list = hawser__json_array(json, json->root, "points");
	for (int i = 0; i < frf->points; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "Omega", frf->point[i].omega*cli_per_omega(result->model));
		hawser__json_integer(json, row, "unstable", frf->point[i].unstable);
		hawser__json_number(json, row, "log_modulus", frf->multiplier[(size_t)i*4*(size_t)frf->n]);
		hawser__json_number(json, row, "mathieu_own", result->mathieu[2*i]);
		hawser__json_number(json, row, "mathieu_effective", result->mathieu[2*i + 1]);
	}
	cli_stats_json(json, result->common);
}

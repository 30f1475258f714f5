/* cli/statics_curves.c - hawser statics --models and --compatibility: the static models beside each
 * other, and one cable over its horizontal tensions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

enum { most_models = 16 };

/* Where a range isn't given: from delta = 4, very slack, to epsilon = 0.02, or delta = 1e-3. */
static const double slackest = 4.0, tautest_strain = 0.02, tautest_delta = 1e-3;

static enum hawser_status range(double *from, double *to, const struct hawser_span *span,
                                struct hawser_report *report)
{
	double weight = span->rho*span->g*span->d;

	if (*from == 0.0)
		*from = weight/slackest;
	if (*to == 0.0)
		*to = isinf(span->EA) ? weight/tautest_delta : tautest_strain*span->EA;
	if (*from < *to)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
	                    "tensions from %.10g N to %.10g N are no range: give --from and --to, the "
	                    "smaller one first", *from, *to);
}

static enum hawser_status sweep(struct cli_curves *curves, const struct hawser_span *span,
                                double from, double to, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int i, k;

	for (k = 0; k < curves->models && !status; k++)
		for (i = 0; i < curves->points && !status; i++)
			status = curves->model[k].solve(
			    curves->curve + k*curves->points + i, span, HAWSER_GIVEN_H,
			    from*pow(to/from, (double)i/(curves->points - 1)), HAWSER_BRANCH_TAUT, report);
	return status;
}

enum hawser_status cli_curves_fill(struct cli_curves *curves, const struct hawser_scene *scene,
                                   int models, int points, double from, double to,
                                   struct hawser_report *report)
{
	const struct hawser_span span = {scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                                 scene->span.h};
	enum hawser_status status = range(&from, &to, &span, report);
	int rows, k;

	if (status)
		return status;
	curves->model = hawser_statics_models(&rows);
	curves->models = models < rows ? models : rows;
	curves->points = points;
	curves->here = calloc((size_t)rows, sizeof *curves->here);
	curves->status = calloc((size_t)rows, sizeof *curves->status);
	curves->report = calloc((size_t)rows, sizeof *curves->report);
	curves->curve = calloc((size_t)rows*(size_t)points, sizeof *curves->curve);
	if (!curves->here || !curves->status || !curves->report || !curves->curve)
		return hawser__no_memory(report, "statics");
	for (k = 0; k < curves->models; k++)
		curves->status[k] = curves->model[k].solve(&curves->here[k], &span, scene->tension.given,
		                                           scene->tension.value, scene->tension.branch,
		                                           &curves->report[k]);
	if (curves->status[0]) { /* the catenary's answer is the scene's */
		*report = curves->report[0];
		return curves->status[0];
	}
	return sweep(curves, &span, from, to, report);
}

void cli_curves_clear(struct cli_curves *curves)
{
	free(curves->here);
	free(curves->status);
	free(curves->report);
	free(curves->curve);
	memset(curves, 0, sizeof *curves);
}

/* --- --compatibility --- */

static const struct {
	const char *name, *column;
	size_t offset;
} compatible[] = {
	{"H", "H_N", offsetof(struct hawser_statics, H)},
	{"delta", "delta", offsetof(struct hawser_statics, delta)},
	{"epsilon", "epsilon", offsetof(struct hawser_statics, epsilon)},
	{"eta", "eta", offsetof(struct hawser_statics, eta)},
	{"l", "l", offsetof(struct hawser_statics, l)},
	{"T0", "T0_N", offsetof(struct hawser_statics, T0)},
	{"T1", "T1_N", offsetof(struct hawser_statics, T1)},
	{"length0", "length0_m", offsetof(struct hawser_statics, length0)},
	{"sag", "sag_m", offsetof(struct hawser_statics, sag)},
};
enum { compatibles = sizeof compatible/sizeof *compatible };

static double field(const struct hawser_statics *statics, size_t offset)
{
	double value;

	memcpy(&value, (const char *)statics + offset, sizeof value);
	return value;
}

void cli_compatibility_rows(struct hawser__table *table, const struct cli_curves *curves)
{
	int i, j;

	for (j = 0; j < compatibles; j++)
		hawser__table_column(table, "%s", compatible[j].column);
	for (i = 0; i < curves->points; i++)
		for (j = 0; j < compatibles; j++)
			hawser__table_number(table, field(&curves->curve[i], compatible[j].offset));
}

void cli_compatibility_json(struct hawser__json *json, const struct cli_curves *curves)
{
	json_t *into = hawser__json_object(json, json->root, "compatibility");
	int i, j;

	for (j = 0; j < compatibles; j++) {
		json_t *list = hawser__json_array(json, into, compatible[j].name);

		for (i = 0; i < curves->points; i++)
			hawser__json_number(json, list, NULL,
			                    field(&curves->curve[i], compatible[j].offset));
	}
}

enum hawser_status cli_compatibility_draw(const char *path, const struct cli_curves *curves,
                                          struct hawser_report *report)
{
	if (curves->here->epsilon == 0.0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics",
		                    "the curves of an inextensible cable have epsilon = 0 everywhere, which "
		                    "has no place on a logarithmic axis: give a finite EA");
	return hawser__plot_compatibility(path, curves->here, curves->curve, curves->points, report);
}

/* --- --models --- */

static const struct {
	const char *name, *column;
	size_t offset, error; /* in struct hawser_statics, hawser_statics_error */
} compared[] = {
	{"H", "H_N", offsetof(struct hawser_statics, H), offsetof(struct hawser_statics_error, H)},
	{"T0", "T0_N", offsetof(struct hawser_statics, T0), offsetof(struct hawser_statics_error, T0)},
	{"T1", "T1_N", offsetof(struct hawser_statics, T1), offsetof(struct hawser_statics_error, T1)},
	{"length0", "length0_m", offsetof(struct hawser_statics, length0),
	 offsetof(struct hawser_statics_error, length0)},
	{"length", "length_m", offsetof(struct hawser_statics, length),
	 offsetof(struct hawser_statics_error, length)},
	{"sag", "sag_m", offsetof(struct hawser_statics, sag),
	 offsetof(struct hawser_statics_error, sag)},
};
enum { compareds = sizeof compared/sizeof *compared };

static double error_of(const struct hawser_statics_error *error, int j)
{
	double value;

	memcpy(&value, (const char *)error + compared[j].error, sizeof value);
	return value;
}

static void model_row(struct hawser__table *table, const struct cli_curves *curves, int k)
{
	struct hawser_statics_error error;
	int j;

	hawser__table_word(table, curves->model[k].name);
	if (curves->status[k]) {
		for (j = 0; j < 2*compareds + 1; j++)
			hawser__table_word(table, "");
		return;
	}
	hawser_statics_compare(&error, &curves->model[k], &curves->here[k], &curves->here[0]);
	for (j = 0; j < compareds; j++)
		hawser__table_number(table, field(&curves->here[k], compared[j].offset));
	for (j = 0; j < compareds; j++)
		hawser__table_number(table, error_of(&error, j));
	hawser__table_number(table, error.position);
}

void cli_models_rows(struct hawser__table *table, const struct cli_curves *curves)
{
	int k, j;

	for (k = 0; k < curves->models; k++) {
		hawser__table_comment(table, "model %s: %s; %s", curves->model[k].name,
		                      curves->model[k].summary, curves->model[k].source);
		if (curves->status[k])
			hawser__table_comment(table, "model %s: no solution: %s", curves->model[k].name,
			                      curves->report[k].message);
	}
	hawser__table_comment(table, "errors are relative, against the elastic catenary; "
	                             "error_position is the largest vertical distance");
	hawser__table_column(table, "model");
	for (j = 0; j < compareds; j++)
		hawser__table_column(table, "%s", compared[j].column);
	for (j = 0; j < compareds; j++)
		hawser__table_column(table, "error_%s", compared[j].name);
	hawser__table_column(table, "error_position_m");
	for (k = 0; k < curves->models; k++)
		model_row(table, curves, k);
}

void cli_models_json(struct hawser__json *json, const struct cli_curves *curves)
{
	json_t *list = hawser__json_array(json, json->root, "models");
	struct hawser_statics_error error;
	int k, j;

	for (k = 0; k < curves->models; k++) {
		json_t *row = hawser__json_object(json, list, NULL), *errors;

		hawser__json_text(json, row, "name", curves->model[k].name);
		hawser__json_flag(json, row, "solved", !curves->status[k]);
		if (curves->status[k]) {
			hawser__json_text(json, row, "why", curves->report[k].message);
			continue;
		}
		hawser_statics_compare(&error, &curves->model[k], &curves->here[k], &curves->here[0]);
		for (j = 0; j < compareds; j++)
			hawser__json_number(json, row, compared[j].name,
			                    field(&curves->here[k], compared[j].offset));
		errors = hawser__json_object(json, row, "error");
		for (j = 0; j < compareds; j++)
			hawser__json_number(json, errors, compared[j].name, error_of(&error, j));
		hawser__json_number(json, errors, "position", error.position);
	}
}

enum hawser_status cli_models_draw(const char *path, const struct cli_curves *curves,
                                   struct hawser_report *report)
{
	const char *name[most_models];
	struct hawser__deflections deflections = {curves->models, curves->points, name, curves->curve,
	                                          curves->here};
	int k;

	for (k = 0; k < curves->models && k < most_models; k++)
		name[k] = curves->model[k].name;
	deflections.models = k;
	return hawser__plot_deflections(path, &deflections, report);
}

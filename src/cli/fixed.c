/* cli/fixed.c - the error of a model whose number of modes is given: estimating it from the
 * response, and telling it, or why it is not known.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/cli.h"

static enum hawser_status not_known(struct cli_frf_result *result, const char *why)
{
	snprintf(result->unknown, sizeof result->unknown, "%s", why);
	return HAWSER_OK;
}

enum hawser_status cli_fixed_estimate(struct cli_frf_result *result, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	if (model->automatic)
		return HAWSER_OK;
	result->stated = 1;
	result->fixed.estimated = NAN;
	if (!model->has_scene)
		return not_known(result, "a model file does not say what it leaves out of its scene: give "
		                         "the scene");
	if (cli_interrupted())
		return not_known(result, "the response was interrupted");
	status = hawser_accuracy_fixed(&result->fixed, &model->rom, result->frf, model->modes.n,
	                               &model->statics, &model->scene, result->from, result->to, &why);
	if (!status)
		return HAWSER_OK;
	result->fixed.estimated = NAN;
	if (status != HAWSER_ERR_MEMORY)
		return not_known(result, why.message);
	if (report)
		*report = why;
	return status;
}

void cli_fixed_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct hawser_accuracy_fixed *fixed = &result->fixed;

	if (!result->stated)
		return;
	if (!isfinite(fixed->estimated)) {
		hawser__table_comment(table, "error of the model: not estimated: %s", result->unknown);
		return;
	}
	hawser__table_comment(table, "error of the model: %s%.2g of folds and peaks, to first order "
	                      "(modes left out: %.1e, of %d looked at; their effect on the kept: %.1e; "
	                      "others: %.1e; beyond modes: %.1e)",
	                      fixed->estimated < 1.0 ? "" : "more than ", fixed->estimated, fixed->rest,
	                      fixed->looked_at, fixed->followed, fixed->beyond, fixed->truncation);
	if (fixed->at_risk > 0)
		hawser__table_comment(table, "the motion can make mode w%d unstable, which the model "
		                      "leaves out", fixed->at_risk);
}

void cli_fixed_json(struct hawser__json *json, const struct cli_frf_result *result)
{
	const struct hawser_accuracy_fixed *fixed = &result->fixed;
	json_t *object;

	if (!result->stated)
		return;
	object = hawser__json_object(json, json->root, "model_error");
	if (!isfinite(fixed->estimated)) {
		hawser__json_null(json, object, "estimated");
		hawser__json_text(json, object, "reason", result->unknown);
		return;
	}
	hawser__json_number(json, object, "estimated", fixed->estimated);
	hawser__json_number(json, object, "left_out", fmin(fixed->rest, 1e300));
	hawser__json_number(json, object, "followed", fixed->followed);
	hawser__json_number(json, object, "others", fmin(fixed->beyond, 1e300));
	hawser__json_number(json, object, "beyond_modes", fixed->truncation);
	hawser__json_number(json, object, "located", fixed->located);
	hawser__json_integer(json, object, "looked_at", fixed->looked_at);
	if (fixed->at_risk > 0)
		hawser__json_integer(json, object, "at_risk", fixed->at_risk);
	if (!result->common->reproducible)
		hawser__json_number(json, object, "seconds", fixed->seconds);
}

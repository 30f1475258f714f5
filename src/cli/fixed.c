/* cli/fixed.c - the error of a model with a given number of modes: its estimate from the response,
 * or the reason why it is unknown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/view.h"

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

	if (result->frf->branch > 1 ? !model->has_scene : model->automatic)
		return HAWSER_OK;
	result->stated = 1;
	result->fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (model->automatic)
		return not_known(result, "the accuracy of model.modes: auto is that of the first branch");
	if (!model->has_scene)
		return not_known(result, "a model file does not say what it leaves out of its scene: give "
		                         "the scene");
	if (result->frf->period > 1)
		return not_known(result, "that of motions of several periods is not");
	if (cli_interrupted())
		return not_known(result, "the response was interrupted");
	if (cli_known_lacks(result->unknown, sizeof result->unknown, model,
	                    fmax(result->from, result->to)))
		return HAWSER_OK;
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
	char branch[24] = "";

	if (!result->stated)
		return;
	if (result->frf->branch > 1)
		snprintf(branch, sizeof branch, "branch %d: ", result->frf->branch);
	if (!isfinite(fixed->estimated)) {
		hawser__table_comment(table, "%serror of the model: not estimated: %s", branch,
		                      result->unknown);
		return;
	}
	hawser__table_comment(table, "%serror of the model: %s%.2g of folds and peaks, to first order "
	                      "(modes left out: %.1e, of %d looked at; their effect on the kept: %.1e; "
	                      "others: %.1e; beyond modes: %.1e)",
	                      branch, fixed->estimated < 1.0 ? "" : "more than ", fixed->estimated,
	                      fixed->rest, fixed->looked_at, fixed->followed, fixed->beyond,
	                      fixed->truncation);
	if (fixed->at_risk > 0)
		hawser__table_comment(table, "%sthe motion can make mode w%d unstable, which the model "
		                      "leaves out", branch, fixed->at_risk);
}

static int is_stated(const void *row, const void *parent)
{
	(void)parent;
	return ((const struct cli_frf_result *)row)->stated;
}

static int is_known(const void *row, const void *parent)
{
	return is_stated(row, parent) &&
	       isfinite(((const struct cli_frf_result *)row)->fixed.estimated);
}

static int is_unknown(const void *row, const void *parent)
{
	return is_stated(row, parent) && !is_known(row, parent);
}

static int has_times(const void *row, const void *parent)
{
	return is_known(row, parent) && !((const struct cli_frf_result *)row)->common->reproducible;
}

static int is_at_risk(const void *row, const void *parent)
{
	return is_known(row, parent) && ((const struct cli_frf_result *)row)->fixed.at_risk > 0;
}

static double left_out(const void *row)
{
	return fmin(((const struct cli_frf_result *)row)->fixed.rest, 1e300);
}

static double others(const void *row)
{
	return fmin(((const struct cli_frf_result *)row)->fixed.beyond, 1e300);
}

#define OF(member) HAWSER__AT(struct cli_frf_result, member)
const struct hawser__field cli_fixed_field[] = {
	{"model_error.estimated", NULL, "error of folds and peaks, relative, 1 at most; null: not known",
	 OF(fixed.estimated), .flags = HAWSER__NULL, .given = is_stated},
	{"model_error.reason", NULL, "why it is not known", OF(unknown), .given = is_unknown},
	{"model_error.left_out", NULL, "what modes that are not kept do beside following",
	 HAWSER__BY(left_out), .given = is_known},
	{"model_error.followed", NULL, "what they and the terms beyond the fourth order do to the kept",
	 OF(fixed.followed), .given = is_known},
	{"model_error.others", NULL, "modes not looked at, extrapolated", HAWSER__BY(others),
	 .given = is_known},
	{"model_error.beyond_modes", NULL, "part of `followed` that no mode makes up for",
	 OF(fixed.truncation), .given = is_known},
	{"model_error.located", NULL, "how well the peaks are located", OF(fixed.located),
	 .given = is_known},
	{"model_error.looked_at", NULL, "modes", OF(fixed.looked_at), .given = is_known},
	{"model_error.at_risk", NULL, "a mode left out that the motion can make unstable",
	 OF(fixed.at_risk), .given = is_at_risk},
	{"model_error.seconds", NULL, "wall time of the estimate (s)", OF(fixed.seconds),
	 .given = has_times},
	HAWSER__END,
};
#undef OF

/* cli/fixed.c - the error of a model with a given number of modes: its estimate from the response,
 * or the reason why it is unknown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/progress.h"
#include "cli/rom_ropeway.h"
#include "cli/view.h"

static enum hawser_status not_known(struct cli_frf_result *result, const char *why)
{
	snprintf(result->unknown, sizeof result->unknown, "%s", why);
	return HAWSER_OK;
}

/* Of a ropeway: the distance from the response of a model with half as many modes more, at least
 * MORE, which was chosen: in lines of two spans one of each in both planes. */
enum { MORE = 4 };

static enum hawser_status against_more(struct hawser_accuracy_fixed *fixed,
                                       const struct cli_frf_result *result,
                                       struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	struct hawser_frf_options choice = {.from = result->from, .to = result->to, .step_max = CLI_STEP,
	                                    .end_at_slack = 1, .samples = HAWSER_NONE};
	struct cli_watch watch = {{.quiet = result->common->quiet}, "frf: with more modes"};
	int modes = rom->n + (rom->n/2 > MORE ? rom->n/2 : MORE);
	struct hawser_rom more = {.n = 0};
	struct hawser_frf other = {.n = 0};
	double start = cli_seconds();
	enum hawser_status status;

	modes = modes < HAWSER_LINE_ROM_MODES ? modes : HAWSER_LINE_ROM_MODES;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = cli_rom_ropeway_again(&more, result->model->ropeway, modes, report);
	if (!status)
		status = hawser_frf_trace(&other, &more, &choice, report);
	if (!status)
		status = hawser_accuracy_distance(&fixed->estimated, result->frf, NULL, &other, NULL, 0.0,
		                                  report);
	cli_progress_end(&watch.progress);
	fixed->looked_at = modes;
	fixed->seconds = cli_seconds() - start;
	hawser_frf_clear(&other);
	hawser_rom_clear(&more);
	return status;
}

enum hawser_status cli_fixed_estimate(struct cli_frf_result *result, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	if (result->frf->branch > 1 ? !model->has_scene : model->automatic) /* of ropeways: the first */
		return HAWSER_OK;
	result->stated = 1;
	result->fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (model->automatic)
		return not_known(result, "the accuracy of model.modes: auto is that of the first branch");
	if (!model->has_scene && !model->ropeway)
		return not_known(result, "a model file does not say what it leaves out of its scene: give "
		                         "the scene");
	if (model->ropeway && model->rom.n == HAWSER_LINE_ROM_MODES)
		return not_known(result, "no model of a ropeway has more modes to compare with");
	if (result->frf->period > 1)
		return not_known(result, "that of motions of several periods is not");
	if (cli_interrupted())
		return not_known(result, "the response was interrupted");
	if (cli_known_lacks(result->unknown, sizeof result->unknown, model,
	                    fmax(result->from, result->to)))
		return HAWSER_OK;
	status = model->ropeway
	         ? against_more(&result->fixed, result, &why)
	         : hawser_accuracy_fixed(&result->fixed, &model->rom, result->frf, model->modes.n,
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
	if (result->model->ropeway) {
		hawser__table_comment(table, "error of the model: about %.2g of folds and peaks: so far is the "
		                      "response with %d modes from this one", fixed->estimated,
		                      fixed->looked_at);
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

/* Whether it was found mode by mode. */
static int is_weighed(const void *row, const void *parent)
{
	return is_known(row, parent) && !((const struct cli_frf_result *)row)->model->ropeway;
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
	 HAWSER__BY(left_out), .given = is_weighed},
	{"model_error.followed", NULL, "what they and the terms beyond the fourth order do to the kept",
	 OF(fixed.followed), .given = is_weighed},
	{"model_error.others", NULL, "modes not looked at, extrapolated", HAWSER__BY(others),
	 .given = is_weighed},
	{"model_error.beyond_modes", NULL, "part of `followed` that no mode makes up for",
	 OF(fixed.truncation), .given = is_weighed},
	{"model_error.located", NULL, "how well the peaks are located", OF(fixed.located),
	 .given = is_weighed},
	{"model_error.looked_at", NULL, "modes; of ropeways those of the other response",
	 OF(fixed.looked_at), .given = is_known},
	{"model_error.at_risk", NULL, "a mode left out that the motion can make unstable",
	 OF(fixed.at_risk), .given = is_at_risk},
	{"model_error.seconds", NULL, "wall time of the estimate (s)", OF(fixed.seconds),
	 .given = has_times},
	HAWSER__END,
};
#undef OF

/* cli/exact.c - a response with the exact energy in place of one of a reduced model that is not good
 * enough (model.energy: auto).
 *
 * A polynomial of degree 4 on a few modes is right for taut cables and small motions. Where a cable
 * swings and sags, no number of modes makes it right (doc/theory-rom.md). The estimate from the
 * motions of its own response tells (fixed.h); then full-order models of increasing bases follow,
 * until two agree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/exact.h"
#include "core/report.h"

/* Estimated error from which on the reduced model is not good enough. With its factor of safety, the
 * true error is below half of it in nearly all scenes (bench/estimates fixed). */
static const double enough = 0.02;
/* What is asked of the full-order models if the scene does not say it. */
static const double accuracy = 0.01;

int cli_exact_calls(const struct cli_model *model, const struct cli_model_error *error)
{
	return model->has_scene && !model->ropeway && !model->automatic &&
	       model->scene.model.energy == HAWSER_ENERGY_AUTO &&
	       model->scene.model.condense == HAWSER_CONDENSE_STATIC && error->stated &&
	       error->fixed.estimated > enough;
}

/* The model is now what the scene would be with these keys. */
static void take(struct cli_model *model, struct hawser_accuracy *better,
                 const struct cli_model_error *error)
{
	const struct hawser_accuracy_try *last = &better->attempt[better->tries - 1];

	model->exact = (struct cli_exact){.modes = model->modes.n, .functions = last->functions,
	                                  .before = error->fixed.estimated};
	hawser_rom_clear(&model->rom);
	model->rom = better->rom;
	better->rom = (struct hawser_rom){0};
	model->scene.model.energy = HAWSER_ENERGY_EXACT;
	model->scene.model.basis = last->functions;
}

/* The distance from the response of the last model but one. */
static void state(struct cli_model_error *error, const struct hawser_accuracy *better)
{
	int timed = error->timed;

	*error = (struct cli_model_error){.stated = 1, .compared = 1, .timed = timed,
	                                  .about = "folds and peaks"};
	error->fixed.estimated = better->estimated;
	error->fixed.looked_at = better->attempt[better->tries - 2].modes;
	error->fixed.seconds = better->seconds;
}

enum hawser_status cli_exact_trace(struct hawser_frf *frf, struct hawser_frf_options *options,
                                   struct cli_model *model, struct cli_model_error *error, int step,
                                   struct hawser_report *report)
{
	struct hawser_accuracy better = {.tries = 0};
	struct hawser_accuracy_options choice = {.frf = *options,
		.accuracy = hawser_scene_written(&model->scene, "model.accuracy") ? 0.0 : accuracy};
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	if (!step)
		choice.frf.step_max = 0.0; /* that of the search: longer, as each point costs more */
	status = hawser_accuracy_exact(&better, &model->statics, &model->scene, &choice,
	                               &why);

	if (!status && better.reached && better.tries > 1) {
		take(model, &better, error);
		state(error, &better);
		*options = better.traced;
		hawser_frf_clear(frf);
		*frf = better.frf;
		better.frf = (struct hawser_frf){0};
	} else if (status == HAWSER_ERR_MEMORY) {
		if (report)
			*report = why;
	} else {
		snprintf(model->exact.failed, sizeof model->exact.failed, "%s", status ? why.message
		         : better.slack ? "the cable goes slack in much of this response"
		         : "two bases do not agree");
		status = HAWSER_OK;
	}
	hawser_accuracy_clear(&better);
	return status;
}

void cli_exact_comment(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_exact *exact = &model->exact;

	if (exact->functions)
		hawser__table_comment(table, "exact energy on %d functions a component, %d coordinates: with %d "
		                      "modes, folds and peaks are off by %s%.2g by an estimate to first order "
		                      "(model.energy: quartic takes them as they are)", exact->functions,
		                      model->rom.n, exact->modes, exact->before < 1.0 ? "" : "more than ",
		                      exact->before);
	if (exact->failed[0])
		hawser__table_comment(table, "the exact energy was tried and gives no answer: %s",
		                      exact->failed);
}

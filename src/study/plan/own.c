/* study/plan/own.c - the row of a plan for the scene as it is: what hawser frf answers by default, and
 * whether it takes the exact energy in place of the scene's modes (accuracy/instead.c), by the error of
 * the modes that is foreseen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/accuracy/survey.h"

enum { FUNCTIONS = 12 }; /* of the smallest basis that most scenes need */
#define COMMAND 0.1 /* s: reading, statics, modes, model, its error and the peaks; median of 12 random
                     * scenes whose modes are good enough */

static const struct hawser_fidelity *named(const char *name)
{
	int i = 0;

	while (strcmp(hawser_fidelity(i)->name, name) != 0)
		i++;
	return hawser_fidelity(i);
}

static struct hawser_plan_row made(const char *fidelity, double number)
{
	return (struct hawser_plan_row){
		.choice = {.fidelity = named(fidelity), .number = number, .name = "hawser frf"},
		.points = NAN, .seconds = NAN, .least = NAN, .most = NAN, .omega_error = NAN, .worst = -1};
}

/* Whether full-order models answer in place of `row`, and what they cost. */
static void exceed(struct hawser_plan_row *row, struct hawser_survey *survey)
{
	const struct hawser_scene *scene = survey->scene;
	double limit = hawser_scene_written(scene, "model.accuracy") ? scene->model.accuracy : 0.0;
	struct hawser_frf_options frf = {.method = NULL};
	struct hawser_accuracy_options asked = hawser_accuracy_instead(&survey->fixed, limit > 0.0, &frf);
	struct hawser_plan_row full = made("full", FUNCTIONS);

	if (scene->model.energy != HAWSER_ENERGY_AUTO || !hawser_accuracy_poor(&survey->fixed, limit))
		return;
	full.n = 3*FUNCTIONS;
	hawser__estimate_exact_cost(&full, survey);
	survey->instead = full.seconds <= asked.bearable ? HAWSER__INSTEAD : HAWSER__TOO_LONG;
	if (survey->instead == HAWSER__TOO_LONG)
		return;
	full.omega_error = asked.accuracy > 0.0 ? asked.accuracy : scene->model.accuracy;
	snprintf(full.why, sizeof full.why, "what is asked of full-order models, which agree to it");
	*row = full;
}

/* If the effect of modes that are left out cannot be estimated, full-order models are computed for the
 * error. */
static void compare_unweighed(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	struct hawser_plan_row full = made("full", FUNCTIONS);

	if (survey->scene->model.energy != HAWSER_ENERGY_AUTO || survey->raw.drag || isnan(row->seconds))
		return;
	full.n = 3*FUNCTIONS;
	hawser__estimate_exact_cost(&full, survey);
	hawser__estimate_with(row, fmin(full.seconds, HAWSER_INSTEAD_FOR_ERROR*survey->slowness));
}

enum hawser_status hawser__estimate_own(struct hawser_plan_row *row, struct hawser_survey *survey,
                                        struct hawser_report *report)
{
	const struct hawser_scene *scene = survey->scene;
	const char *fidelity = scene->model.condense == HAWSER_CONDENSE_NONE ? "raw" : "condensed";
	double number = scene->model.modes;
	enum hawser_status status;

	if (scene->model.energy == HAWSER_ENERGY_EXACT) {
		fidelity = "full";
		number = scene->model.basis > 0 ? scene->model.basis : named(fidelity)->usual;
	} else if (scene->model.modes == HAWSER_MODES_AUTO) {
		fidelity = "auto";
		number = 0.0;
	}
	*row = made(fidelity, number);
	row->choice.fidelity->estimate(row, survey);
	if (isfinite(row->seconds))
		hawser__estimate_with(row, COMMAND);
	survey->fixed.estimated = NAN;
	if (strcmp(fidelity, "condensed") != 0)
		return HAWSER_OK;
	if (!survey->choice) {
		compare_unweighed(row, survey);
		return HAWSER_OK;
	}
	status = hawser__foresee(&survey->fixed, survey, NULL, scene->model.modes, report);
	if (!status)
		exceed(row, survey);
	return status;
}

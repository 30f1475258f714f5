/* study/plan/own.c - the row of a plan for the scene as it is: what hawser frf answers by default, and
 * whether it takes the exact energy in place of the scene's modes (accuracy/instead.c), by the error of
 * the modes that is foreseen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/accuracy/accuracy.h"
#include "study/accuracy/survey.h"

/* Work, s (hawser_orbit_work): reading, statics, modes, model, its error and the peaks. */
#define COMMAND 0.06
/* Work of bases that tell an error over that of the first draft, 1.1 to 2.0 (bench/defaults.py). */
#define COMPARED 1.5
/* The same of a search that ends once the first draft has shown that all takes too long, within its
 * first 10 to 100 %: the mean of their logarithms. */
#define GIVEN_UP 0.3

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

double hawser__draft_of(struct hawser_plan_row *full, const struct hawser_survey *survey, int most,
                        double accuracy)
{
	const struct hawser_plan *plan = survey->plan;
	const struct hawser_accuracy_bases of = {&plan->modes, survey->scene, fmax(plan->from, plan->to),
	                                         accuracy, most};
	int functions = (int)full->choice.number;
	struct hawser_rom rom = {.n = 0};

	full->n = hawser_accuracy_basis(&rom, &functions, &of, 0, NULL) ? 0 : rom.n;
	full->choice.number = functions;
	hawser_rom_clear(&rom);
	return hawser__draft_foreseen(survey, full->n);
}

/* Whether full-order models answer in place of `row`, and what they cost. */
static void exceed(struct hawser_plan_row *row, struct hawser_survey *survey)
{
	const struct hawser_scene *scene = survey->scene;
	double limit = hawser_scene_written(scene, "model.accuracy") ? scene->model.accuracy : 0.0;
	struct hawser_frf_options frf = {.method = NULL};
	struct hawser_accuracy_options asked = hawser_accuracy_instead(&survey->fixed, limit > 0.0, &frf);
	struct hawser_plan_row full = made("full", 0.0);
	double accuracy = asked.accuracy > 0.0 ? asked.accuracy : scene->model.accuracy, work, drafted;

	if (scene->model.energy != HAWSER_ENERGY_AUTO || !hawser_accuracy_poor(&survey->fixed, limit))
		return;
	drafted = hawser__draft_of(&full, survey, asked.most_functions, accuracy);
	work = HAWSER__SEARCHED*drafted;
	survey->instead = full.n == 0 ? HAWSER__NO_BASIS : work <= asked.bearable ? HAWSER__INSTEAD
	                  : asked.partial ? HAWSER__PARTLY : HAWSER__TOO_LONG;
	if (survey->instead == HAWSER__TOO_LONG || survey->instead == HAWSER__NO_BASIS) {
		hawser__estimate_work(row, survey, GIVEN_UP*drafted, 0.0);
		return;
	}
	full.seconds = row->seconds; /* of the modes, whose error tells */
	hawser__estimate_work(&full, survey, fmin(work, asked.bearable),
	                      hawser__accuracy_settle(&asked, accuracy).step_max);
	full.omega_error = accuracy;
	snprintf(full.why, sizeof full.why, "what is asked of full-order models, which agree to it");
	*row = full;
}

/* If the effect of modes that are left out cannot be estimated, full-order models are computed for the
 * error. */
static void compare_unweighed(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	struct hawser_frf_options frf = {.method = NULL};
	struct hawser_accuracy_options asked = hawser_accuracy_instead(NULL, 0, &frf);
	struct hawser_plan_row full = made("full", hawser__accuracy_fewest(&survey->plan->modes.statics));
	double drafted;

	if (survey->scene->model.energy != HAWSER_ENERGY_AUTO || survey->raw.drag || isnan(row->seconds))
		return;
	drafted = hawser__draft_of(&full, survey, asked.most_functions,
	                           HAWSER__BASIS_PART*asked.accuracy);
	hawser__estimate_work(row, survey, fmin(COMPARED*drafted, HAWSER_INSTEAD_FOR_ERROR), 0.0);
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
		hawser__estimate_work(row, survey, COMMAND, 0.0);
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

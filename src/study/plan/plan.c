/* study/plan/plan.c - a plan: compute the modes, build the two models on which estimates rest, and call
 * the estimate function of each fidelity.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "core/progress.h"
#include "rom/build/build.h"
#include "rom/terms/drag.h"
#include "rom/choose/drive.h"
#include "rom/choose/weigh.h"
#include "study/accuracy/survey.h"

/* Number of modes: those of the largest model, and enough to reach well above twice the range; both
 * chosen. */
enum { least_modes = 16, most_modes = 40 };
static const double reach = 2.4;

static enum hawser_status look(struct hawser_plan *plan, const struct hawser_statics *statics,
                               const struct hawser_scene *scene,
                               const struct hawser_fidelity_choice *choice, int count,
                               struct hawser_report *report)
{
	double high = reach*fmax(plan->from, plan->to);
	struct hawser_modes_options options = {.n = least_modes, .basis = scene->model.basis};
	enum hawser_status status;

	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	if (scene->model.modes != HAWSER_MODES_AUTO && options.n < scene->model.modes)
		options.n = scene->model.modes;
	for (int i = 0; i < count; i++)
		if (choice[i].fidelity->counts == HAWSER_NUMBER_MODES && options.n < choice[i].number)
			options.n = (int)choice[i].number;
	for (;;) {
		status = hawser_modes_solve(&plan->modes, statics, &options, report);
		if (status || options.n >= most_modes || plan->modes.mode[options.n - 1].omega >= high)
			return status;
		hawser_modes_clear(&plan->modes);
		options.n = options.n + 8 < most_modes ? options.n + 8 : most_modes;
	}
}

/* Which of the modes are kept, and why. If the load drives no mode, there is nothing to choose; with a
 * motion of supports, modes are weighed, but not chosen. */
static enum hawser_status choose(struct hawser_survey *survey, struct hawser_plan *plan,
                                 struct hawser_report *report)
{
	const struct hawser_scene *scene = survey->scene;
	struct hawser_choice *choice = survey->choice = calloc(1, sizeof *choice);
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	plan->mode = calloc((size_t)plan->modes.n, sizeof *plan->mode);
	if (!plan->mode || !choice)
		return hawser__no_memory(report, "plan");
	for (int j = 0; j < plan->modes.n; j++)
		plan->mode[j].kept = scene->model.modes != HAWSER_MODES_AUTO && j < scene->model.modes;
	plan->chosen = hawser__scene_driven(scene) && !hawser__support_moves(scene);
	status = plan->chosen
	         ? hawser_choose(choice, &plan->modes, scene, plan->from, plan->to,
	                         scene->model.accuracy, &why)
	         : hawser__scene_driven(scene)
	         ? hawser__choice_begin(choice, &plan->modes, scene, plan->from, plan->to,
	                                scene->model.accuracy, 0, &why)
	         : HAWSER_ERR_ARGUMENT;
	if (status) {
		free(choice);
		survey->choice = NULL;
		plan->chosen = 0;
		snprintf(survey->unweighed, sizeof survey->unweighed, "%.239s", why.message);
		if (report && status != HAWSER_ERR_ARGUMENT)
			*report = why;
		return status == HAWSER_ERR_ARGUMENT ? HAWSER_OK : status;
	}
	for (int j = 0; j < plan->modes.n && plan->chosen; j++) {
		plan->mode[j].worth = choice->mode[j].kept;
		plan->mode[j].reason = hawser_choice_reason(choice, j);
		plan->mode[j].measure = choice->mode[j].measure;
		if (scene->model.modes == HAWSER_MODES_AUTO)
			plan->mode[j].kept = choice->mode[j].kept;
	}
	return HAWSER_OK;
}

enum { JUDGED = 40, /* most coordinates whose ranges are sought: half a second; chosen */
       TOLD = 4 };  /* ranges in the text */

/* "2.5 m out-of-plane 1, 1.2 m in-plane 1 (antisymmetric)" */
static enum hawser_status judge(char *text, size_t size, struct hawser_rom *rom,
                                const struct hawser_statics *statics, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (rom->n <= JUDGED)
		status = hawser_law_range(rom, statics, NULL, report);
	for (int j = 0, told = 0; !status && j < rom->n && told < TOLD; j++) {
		const struct hawser_rom_range *range = &rom->range[j];

		if (range->end != HAWSER_RANGE_UNKNOWN)
			hawser__append(text, size, told++ ? ", " : "", "%.3g m%s %s", range->amplitude,
			               range->end == HAWSER_RANGE_AT_LEAST ? " or more" : "", rom->label[j]);
	}
	return status;
}

/* The effect of the inertia of condensed modes on the scene's own model, its ranges, and how its forces
 * are evaluated. */
static enum hawser_status weigh_own(struct hawser_survey *survey, const struct hawser_plan *plan,
                                        struct hawser_report *report)
{
	int *kept = malloc((size_t)plan->modes.n*sizeof *kept), count = 0;
	struct hawser_modes subset = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	enum hawser_status status;

	if (!kept)
		return hawser__no_memory(report, "plan");
	for (int j = 0; j < plan->modes.n; j++)
		if (plan->mode[j].kept)
			kept[count++] = j;
	status = count > 0 ? hawser_modes_select(&subset, &plan->modes, kept, count, report)
	                   : HAWSER_OK;
	if (!status && count > 0)
		status = hawser_rom_build(&rom, &subset, survey->scene, report);
	if (!status && count > 0)
		status = judge(survey->range, sizeof survey->range, &rom, &plan->modes.statics, report);
	if (!status && count > 0)
		hawser_rom_forces_text(&rom, survey->forces, sizeof survey->forces);
	survey->inertia = rom.inertia;
	hawser_rom_clear(&rom);
	hawser_modes_clear(&subset);
	free(kept);
	return status;
}

/* The coordinates of both models are the modes, so that dampers act on these alone. */
static enum hawser_status build(struct hawser_survey *survey, struct hawser_plan *plan,
                                struct hawser_report *report)
{
	struct hawser_scene scene = *survey->scene;
	enum hawser_status status;

	scene.model.condense = HAWSER_CONDENSE_NONE;
	scene.wind.present = 0; /* gallop.c */
	status = hawser__rom_of_modes(&survey->raw, &plan->modes, &scene, report);
	if (status)
		return status;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.model.inertia = HAWSER_INERTIA_NONE; /* the coordinates of this model are modes only */
	survey->condensed = survey->choice ? &survey->choice->all : &survey->own;
	status = survey->choice ? HAWSER_OK
	                        : hawser__rom_of_modes(&survey->own, &plan->modes, &scene, report);
	if (status)
		return status;
	plan->load = calloc((size_t)plan->modes.n, sizeof *plan->load);
	if (!plan->load)
		return hawser__no_memory(report, "plan");
	return survey->raw.harmonics ? hawser__drives(&survey->raw, plan->load, report) : HAWSER_OK;
}

/* Sizes in every case; estimates if there is a response. */
static enum hawser_status fill_rows(struct hawser_plan *plan, struct hawser_survey *survey,
                                    const struct hawser_fidelity_choice *choice, int count,
                                    struct hawser_report *report)
{
	plan->row = calloc((size_t)count + 1, sizeof *plan->row);
	if (!plan->row)
		return hawser__no_memory(report, "plan");
	for (int i = 0; i < count; i++) {
		struct hawser_plan_row *row = &plan->row[plan->rows++];

		*row = (struct hawser_plan_row){.choice = choice[i], .points = NAN, .seconds = NAN,
		                                .least = NAN, .most = NAN, .omega_error = NAN,
		                                .worst = -1};
		choice[i].fidelity->estimate(row, survey);
	}
	survey->fixed.estimated = NAN;
	return hawser__scene_driven(survey->scene)
	       ? hawser__estimate_own(&plan->row[plan->rows++], survey, report) : HAWSER_OK;
}

enum hawser_status hawser_plan_make(struct hawser_plan *plan, const struct hawser_statics *statics,
                                    const struct hawser_scene *scene,
                                    const struct hawser_fidelity_choice *choice, int count,
                                    double from, double to, struct hawser_report *report)
{
	struct hawser_survey survey = {.scene = scene, .plan = plan};
	double start = hawser__processor_seconds();
	enum hawser_status status;

	memset(plan, 0, sizeof *plan);
	if (scene->damping.drag > 0.0)
		return hawser__drag_refuse(NULL, "a plan", report);
	if (!(from > 0.0) || !(to > 0.0) || from == to || !isfinite(from) || !isfinite(to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "plan",
		                    "the range of Omega from %g to %g is none: give two frequencies "
		                    "greater than zero", from, to);
	plan->from = from;
	plan->to = to;
	survey.slowness = hawser__plan_slowness();
	status = look(plan, statics, scene, choice, count, report);
	if (!status)
		status = choose(&survey, plan, report);
	if (!status)
		status = build(&survey, plan, report);
	if (!status)
		status = weigh_own(&survey, plan, report);
	if (!status && hawser__scene_driven(scene))
		status = hawser__find_resonances(plan, &survey, report);
	if (!status && survey.choice)
		status = hawser__foresee_motions(&survey, report);
	if (!status)
		status = fill_rows(plan, &survey, choice, count, report);
	if (!status)
		status = hawser__decide(plan, &survey, report);
	hawser__foresee_clear(&survey);
	hawser_rom_clear(&survey.raw);
	hawser_rom_clear(&survey.own);
	plan->seconds = hawser__processor_seconds() - start;
	if (status)
		hawser_plan_clear(plan);
	return status;
}

void hawser_plan_clear(struct hawser_plan *plan)
{
	if (!plan)
		return;
	hawser_modes_clear(&plan->modes);
	free(plan->mode);
	free(plan->load);
	free(plan->resonance);
	free(plan->decision);
	free(plan->row);
	memset(plan, 0, sizeof *plan);
}

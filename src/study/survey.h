/* study/survey.h - what estimates are made from: a scene's first modes, their raw tensors, a condensed
 * model, and the time that may be taken for runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_SURVEY_H
#define HAWSER_STUDY_SURVEY_H

#include <hawser/plan.h>

#include "study/trial.h"

struct hawser_survey {
	const struct hawser_scene *scene;
	const struct hawser_plan *plan; /* modes, resonances, range */
	struct hawser_rom raw;          /* of all modes looked at */
	struct hawser_rom condensed;
	struct hawser_rom_inertia inertia; /* of what follows the scene's own kept modes */
	struct hawser__allowance *allowance; /* time for what is run; the only thing that rows change */
};

/* Whether there is a response to ask for: something excites the cable, again and again. */
static inline int hawser__scene_driven(const struct hawser_scene *scene)
{
	return (scene->load.present || scene->travel.fluctuation > 0.0) && !(scene->travel.braking > 0.0);
}

/* Size of a model of the modes at index [n]: coordinates, and the tensor entries that the mirror
 * symmetry of the plane leaves. NULL: the first n. */
void hawser__count_entries(struct hawser_plan_row *row, const struct hawser_survey *survey,
                           const int *index, int n);

/* Points and seconds of a row, of model and response: of one traced curve, of modes that are chosen,
 * and of an accuracy. */
void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_chosen_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_auto_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);

/* Effective cubic coefficients of the resonances, and where these are. */
enum hawser_status hawser__find_resonances(struct hawser_plan *plan,
                                           const struct hawser_survey *survey,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* The rows' estimates: sizes; and, where the scene has a load, cost and error. */
void hawser__estimate_raw(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_condensed(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_chosen(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_auto(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_full(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_scales(struct hawser_plan_row *row, const struct hawser_survey *survey);

/* What is modelled and what is not. */
enum hawser_status hawser__decide(struct hawser_plan *plan, const struct hawser_survey *survey,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* study/survey.h - what estimates are made from: a scene's first modes, their raw tensors, a condensed
 * model, and measured times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_SURVEY_H
#define HAWSER_STUDY_SURVEY_H

#include <hawser/plan.h>

struct hawser_survey {
	const struct hawser_scene *scene;
	const struct hawser_plan *plan; /* modes, resonances, range */
	struct hawser_rom raw;          /* of all modes looked at */
	struct hawser_rom condensed;
	struct hawser_rom_inertia inertia; /* of what follows the scene's own kept modes */
	double build_seconds;           /* of the larger of the two */
	double offset, slope;           /* seconds a point = offset + slope*work */
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

/* Operations of a stage of an orbit's integration with its derivative. */
double hawser__work(int n, double entries);

/* Measure what a point costs. */
enum hawser_status hawser__survey_time(struct hawser_survey *survey, struct hawser_plan *plan,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Points of a traced curve, and seconds of model and response. */
void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_full_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);

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

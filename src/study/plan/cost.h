/* study/plan/cost.h - functions of the estimates of times: see cost.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_COST_H
#define HAWSER_STUDY_COST_H

#include <hawser/accuracy.h>

#include "study/accuracy/survey.h"

enum { HAWSER__FIRST_POINTS = 12 }; /* points of a curve that are computed to measure the time per
                                     * point; chosen */
enum { HAWSER__WHY = sizeof((struct hawser_plan_row *)0)->foreseen };

/* The response of a row that was started and interrupted. */
struct hawser__begun {
	struct hawser_study_curve curve;
	struct hawser_rom rom;
	struct hawser_accuracy accuracy; /* of `auto`: the models so far; the trace of the last one was
	                                  * interrupted */
};

/* The formula for the number of points of a curve over the range of the plan. */
struct hawser__outlook hawser__plan_outlook(const struct hawser_survey *survey);

/* Sum the curves before the interruption, and the interrupted one, which is assumed to have as many
 * points as the previous one. */
void hawser__count_curves(struct hawser__trial_cost *cost, const struct hawser__trial *trial);

/* Estimates what follows the interrupted curve. `why` [HAWSER__WHY] becomes the reason of a bound,
 * unless the interrupted curve itself is the reason. */
typedef void hawser__further_function(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                                      struct hawser__begun *begun, char *why,
                                      const struct hawser_survey *survey);
hawser__further_function hawser__further_auto;

#endif

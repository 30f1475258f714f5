/* study/cost.h - parts of the estimates of times: see cost.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_COST_H
#define HAWSER_STUDY_COST_H

#include <hawser/accuracy.h>

#include "study/survey.h"

enum { HAWSER__FIRST_POINTS = 12 }; /* of a curve that is begun to see what a point takes */
enum { HAWSER__WHY = sizeof((struct hawser_plan_row *)0)->foreseen };

/* A row's response, which was begun and cut. */
struct hawser__begun {
	struct hawser_study_curve curve;
	struct hawser_rom rom;
	struct hawser_accuracy accuracy; /* of `auto`: the models so far, the last of them cut */
};

/* What is known of a curve over the plan's range without a trace. */
struct hawser__outlook hawser__plan_outlook(const struct hawser_survey *survey);

/* The curves before the cut, and the one that is cut, of as many points as the one before. */
void hawser__count_curves(struct hawser__cost *cost, const struct hawser__trial *trial);

/* What goes on after the cut. `why` [HAWSER__WHY] gets the reason of a bound where that is another than
 * the curve that was cut. */
typedef void hawser__further_function(struct hawser__cost *cost, struct hawser__trial *trial,
                                      struct hawser__begun *begun, char *why,
                                      const struct hawser_survey *survey);
hawser__further_function hawser__further_auto;

#endif

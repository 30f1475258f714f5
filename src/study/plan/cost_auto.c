/* study/plan/cost_auto.c - estimated time of the rest of a search for an accuracy (accuracy.c) that was
 * interrupted.
 *
 *    c1, c2   processor time of a point of the first and of the second model
 *    T        time of the first curve
 *
 * If the search is interrupted in its first curve, the rest of this curve is traced with a large
 * tolerance (trial.c). The motions of this trace weigh the modes like those of the accurate curve
 * and tell what follows. This may be nothing; or a second model, of which a few points are
 * computed, so that its curve takes T c2/c1. Weighing the modes and tracing the peaks again take a
 * further part of the time of each curve. If more models follow, or full-order models because the
 * truncation error is too large, neither their number nor their time is known. The time of the
 * known part is then stated as a lower bound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/accuracy/accuracy.h"
#include "study/plan/cost.h"
#include "study/accuracy/respond.h"

/* Time of weighing the modes and of tracing the peaks again, relative to that of the curve;
 * measured in the scenes of bench/plan-times. */
static const double weighing = 0.4, locating = 0.4;

/* Time of a point of the model that a->choice keeps, relative to that of the curve just traced; 1
 * if not known. */
static double ratio_of(struct hawser__trial *trial, const struct hawser_rom *rom,
                       const struct hawser_frf_options *options)
{
	double first = hawser__trial_point(trial), ratio = 1.0;
	struct hawser_frf frf = {.n = 0};
	struct hawser__trial_cost second;

	if (!hawser__trial_points(&second, &frf, trial, rom, options, HAWSER__FIRST_POINTS, NULL) &&
	    frf.points > 2 && first > 0.0)
		ratio = hawser__trial_point(trial)/first;
	hawser_frf_clear(&frf);
	return ratio;
}

/* The response with the larger motions, which give larger measures: the part before the
 * interruption, or the coarse trace. */
static const struct hawser_frf *larger(const struct hawser_frf *a, const struct hawser_frf *b)
{
	double most[2] = {0.0};

	for (int i = 0; i < a->points*a->n; i++)
		most[0] = fmax(most[0], a->coordinate[i]);
	for (int i = 0; i < b->points*b->n; i++)
		most[1] = fmax(most[1], b->coordinate[i]);
	return most[0] > most[1] ? a : b;
}

static void explain(struct hawser__trial_cost *cost, char *why, size_t size)
{
	cost->bound = 1;
	snprintf(why, size, "the motions call for more than two models, or for the full-order one: their "
	         "time is not known");
}

/* Interrupted in the first curve. */
static void first_curve(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                        struct hawser_accuracy *a, char *why,
                        const struct hawser_accuracy_options *settings,
                        const struct hawser_scene *scene, const struct hawser_survey *survey)
{
	struct hawser__outlook outlook = hawser__plan_outlook(survey);
	double before = trial->began - trial->start, curve;
	struct hawser_frf left = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	enum hawser__course course = HAWSER__SEVERAL;

	hawser__trial_finish(cost, &left, trial, &a->rom, &a->frf, &outlook);
	curve = cost->seconds - before;
	if (cost->complete && !cost->limited) {
		if (hawser__accuracy_foresee(&course, a, larger(&a->frf, &left), settings, NULL) ||
		    course == HAWSER__SEVERAL)
			explain(cost, why, HAWSER__WHY);
		cost->seconds += weighing*curve;
	} else if (!cost->complete) {
		cost->bound = 1; /* what follows is not known */
	}
	if (course == HAWSER__ANOTHER && !hawser_choice_build(&rom, &a->choice, scene, NULL))
		cost->seconds += curve*ratio_of(trial, &rom, trial->options)*(1.0 + locating + weighing);
	hawser_rom_clear(&rom);
	hawser_frf_clear(&left);
}

/* Interrupted in a later curve, whose model is a->rom: as many points as the previous curve. */
static void later_curve(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                        struct hawser_accuracy *a, char *why,
                        const struct hawser_accuracy_options *settings)
{
	int here = a->tries - 1, full = a->attempt[here].functions > 0;
	double so_far = hawser__processor_seconds() - trial->start;
	double curve = trial->last - trial->began;

	if (trial->curve > here) {
		hawser__count_curves(cost, trial);
		curve = cost->seconds - (trial->began - trial->start);
	} else {
		*cost = (struct hawser__trial_cost){.points = trial->points, .complete = 1, .omega = NAN};
		curve *= full ? 1.0 : ratio_of(trial, &a->rom, trial->options);
		cost->seconds = so_far + curve;
	}
	cost->seconds += (locating + weighing)*curve;
	a->tries = here; /* judged by the last complete curve */
	if (full || hawser__accuracy_course(a, settings) == HAWSER__SEVERAL)
		explain(cost, why, HAWSER__WHY);
}

void hawser__further_auto(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                          struct hawser__begun *begun, char *why,
                          const struct hawser_survey *survey)
{
	struct hawser_accuracy *a = &begun->accuracy;
	struct hawser_accuracy_options settings = {.most = 0};
	struct hawser_scene scene = hawser__auto_scene(survey->scene);
	struct hawser_frf_options options;

	if (a->tries < 1 || a->frf.points < 1)
		return;
	settings.accuracy = scene.model.accuracy = a->asked;
	settings.frf.from = trial->options->from;
	settings.frf.to = trial->options->to;
	options = hawser__accuracy_settle(&settings, a->asked);
	trial->options = &options;
	if (a->tries == 1)
		first_curve(cost, trial, a, why, &settings, &scene, survey);
	else
		later_curve(cost, trial, a, why, &settings);
}

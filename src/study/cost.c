/* study/cost.c - how large a model is, and what its response should take.
 *
 * Entries are counted: a term of the energy with an odd number of out-of-plane coordinates is
 * zero, as the cable is the same seen from either side of its plane. All others are kept.
 *
 * Time is measured, on a part of the response where the whole would take too long (trial.c). A response
 * that traces several curves is cut in one of them. The curves before are measured; the one that is cut
 * has as many points as the one before, or, if it is the first, is estimated as a single curve is. What
 * the further curves take follows: for `chosen` from a few points of the second model, for `auto` from
 * what they took beside the first one in the scenes of bench/plan-times.
 *
 * The formula for a number of points counts for what no trace reaches: the longest step allows 1/step
 * of them over the range, and 1 % of Omega at most; every resonance adds what going round its peak
 * takes, and about as many again for every e-fold by which its bend exceeds its width, as the turns
 * about folds get sharper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/accuracy.h"
#include "study/chosen.h"
#include "study/respond.h"
#include "study/survey.h"

static const double step = 0.005;      /* as hawser frf and hawser compare have it */
static const double each = 22.0;       /* points of a resonance */
static const double each_fold = 12.0;  /* more for every e-fold of bend over width */
static const double alike = 1.25;      /* two runs of one response on one machine */
/* Of `auto`, over the time of a curve: orbits that weigh the modes, and peaks that are traced again. */
static const double weighing = 0.4, locating = 0.4;
/* Modes beyond the candidates that matter so many times the accuracy before a response is known matter
 * after it; then there are `candidates`, and the work on them, n^4, is done so many times. */
static const double far_beyond = 1.5, candidates = 48.0, wider_models = 3.5;
enum { first_points = 12 };            /* of a curve that is begun to see what a point takes */

/* Is the i-th of the modes at `index` one out of the plane? */
static int out(const struct hawser_survey *survey, const int *index, int i)
{
	return survey->plan->modes.mode[index ? index[i] : i].plane == HAWSER_OUT_OF_PLANE;
}

void hawser__count_entries(struct hawser_plan_row *row, const struct hawser_survey *survey,
                           const int *index, int n)
{
	row->n = n;
	row->quads = row->cubics = 0;
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++) {
				int odd = out(survey, index, j) ^ out(survey, index, k) ^ out(survey, index, l);

				row->quads += !odd;
				for (int m = l; m < n; m++)
					row->cubics += odd == out(survey, index, m);
			}
}

/* --- the number of points, by formula --- */

static double points_between(const void *context, double from, double to)
{
	const struct hawser_survey *survey = context;
	const struct hawser_plan *plan = survey->plan;
	double low = fmin(from, to), high = fmax(from, to);
	double points = fmax((high - low)/(step*fabs(plan->to - plan->from)), log(high/low)/0.01);

	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double width = survey->raw.D[(size_t)at->mode*survey->raw.n + at->mode];
		double bend = fabs(at->peak_omega - at->omega);

		if (at->omega > low && at->omega < high)
			points += each + each_fold*fmax(0.0, log(bend/width));
	}
	return points;
}

/* --- what goes on after the cut --- */

typedef void further_function(struct hawser__cost *cost, struct hawser__trial *trial,
                              const struct hawser_study_curve *curve, const struct hawser_rom *rom,
                              const struct hawser_survey *survey);

static void further_curve(struct hawser__cost *cost, struct hawser__trial *trial,
                          const struct hawser_study_curve *curve, const struct hawser_rom *rom,
                          const struct hawser_survey *survey)
{
	hawser__trial_finish(cost, trial, rom, &curve->frf, points_between, survey);
}

/* The curves before the cut, and the one that is cut, of as many points as the one before. */
static void count_curves(struct hawser__cost *cost, const struct hawser__trial *trial)
{
	double points = fmax(trial->before, trial->points);

	*cost = (struct hawser__cost){
		.seconds = trial->began - trial->start + (trial->last - trial->began)*points/trial->points,
		.seen = trial->last - trial->start, .points = points, .complete = 1};
}

/* The second curve takes as many points as the first, of another model and to another tolerance. */
static void further_chosen(struct hawser__cost *cost, struct hawser__trial *trial,
                           const struct hawser_study_curve *curve, const struct hawser_rom *rom,
                           const struct hawser_survey *survey)
{
	const struct hawser_frf_options *options = trial->options;
	struct hawser__chosen begin;
	struct hawser_rom own = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	struct hawser__cost second;
	double point;

	(void)rom;
	if (trial->curve > 1) {
		count_curves(cost, trial);
		return;
	}
	if (!hawser__chosen_begin(&begin, &survey->plan->modes.statics, survey->scene, options,
	                          (int)curve->choice.number, NULL) &&
	    !hawser_choice_build(&own, &begin.choice, &begin.scene, NULL) &&
	    !hawser__trial_curve(cost, trial, &own, &begin.options, first_points, points_between, survey,
	                         NULL)) {
		point = hawser__trial_point(trial);
		hawser_rom_clear(&own);
		hawser_choice_first(&begin.choice, (int)curve->choice.number);
		if (!hawser_choice_build(&own, &begin.choice, &begin.scene, NULL) &&
		    !hawser__trial_points(&second, &frf, trial, &own, options, first_points, NULL))
			cost->seconds *= 1.0 + hawser__trial_point(trial)/point;
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&own);
	hawser__chosen_clear(&begin);
}

/* The first model's curve, and what follows: a second model of `more` modes, whose point is measured;
 * the orbits that weigh the modes, and the peaks that are traced again, take a part of each curve's
 * time. Where the modes beyond the candidates matter, more candidates are weighed, and more models
 * follow. */
static void add_models(struct hawser__cost *cost, struct hawser__trial *trial,
                       struct hawser_choice *begin, const struct hawser_scene *scene,
                       const struct hawser_frf_options *options, const struct hawser_survey *survey,
                       double choosing)
{
	int *index = calloc((size_t)begin->n, sizeof *index), kept, more;
	double first = 0.0, ratio = 1.0, wider = choosing*pow(candidates/begin->n, 4);
	double beyond = hawser_choice_beyond(begin);
	struct hawser_frf frf = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser__cost second;

	if (!index)
		return;
	kept = hawser_choice_kept(index, begin);
	hawser__accuracy_first(begin);
	more = hawser_choice_kept(index, begin);
	more += (kept - more)/2;
	if (!hawser_choice_build(&rom, begin, scene, NULL) &&
	    !hawser__trial_curve(cost, trial, &rom, options, first_points, points_between, survey, NULL))
		first = hawser__trial_point(trial);
	hawser_rom_clear(&rom);
	hawser_choice_first(begin, more);
	if (first > 0.0 && !hawser_choice_build(&rom, begin, scene, NULL) &&
	    !hawser__trial_points(&second, &frf, trial, &rom, options, first_points, NULL) &&
	    frf.points > 2)
		ratio = hawser__trial_point(trial)/first;
	if (!cost->limited)
		cost->seconds *= 1.0 + weighing + ratio*(1.0 + locating + weighing);
	cost->seconds += choosing;
	if (!cost->limited && beyond > far_beyond*scene->model.accuracy)
		cost->seconds += wider_models*wider;
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	free(index);
}

/* Further models follow the first. */
static void further_auto(struct hawser__cost *cost, struct hawser__trial *trial,
                         const struct hawser_study_curve *curve, const struct hawser_rom *rom,
                         const struct hawser_survey *survey)
{
	struct hawser_accuracy_options choice = hawser_accuracy_defaults();
	struct hawser_scene scene = hawser__auto_scene(survey->scene);
	struct hawser_frf_options options;
	struct hawser_choice begin;
	struct hawser_modes modes;
	double start = hawser__processor_seconds();

	(void)rom;
	scene.model.accuracy = choice.accuracy = hawser__auto_accuracy(&curve->choice, &scene);
	if (trial->curve > 1) {
		count_curves(cost, trial);
		cost->seconds += (locating + weighing)*(cost->seconds - (trial->began - trial->start));
		return;
	}
	choice.frf.from = trial->options->from;
	choice.frf.to = trial->options->to;
	options = hawser__accuracy_settle(&choice, choice.accuracy);
	if (!hawser_accuracy_choose(&begin, &modes, &survey->plan->modes.statics, &scene, options.from,
	                            options.to, choice.accuracy, NULL))
		add_models(cost, trial, &begin, &scene, &options, survey,
		           hawser__processor_seconds() - start);
	hawser_choice_clear(&begin);
	hawser_modes_clear(&modes);
}

/* --- a row --- */

static void foresee(struct hawser_plan_row *row, const struct hawser_study_curve *curve,
                    enum hawser_status status, const struct hawser_report *report)
{
	row->status = status;
	if (status)
		snprintf(row->foreseen, sizeof row->foreseen, "%.*s", (int)sizeof row->foreseen - 1,
		         report->message);
	else if (curve->unreached)
		snprintf(row->foreseen, sizeof row->foreseen, "the accuracy is not reached: folds and "
		         "peaks are known to %.2g", curve->estimated);
}

/* What the whole run took. */
static void take_run(struct hawser_plan_row *row, const struct hawser__trial *trial,
                     const struct hawser_study_curve *curve)
{
	row->seconds = hawser__processor_seconds() - trial->start;
	row->least = row->seconds/alike;
	row->most = row->seconds*alike;
	row->basis = HAWSER_BASIS_RUN;
	if (curve->frf.points > 0)
		row->points = curve->frf.points;
}

static void take_estimate(struct hawser_plan_row *row, const struct hawser__cost *cost)
{
	row->seconds = cost->seconds;
	row->points = cost->points;
	row->basis = cost->complete ? HAWSER_BASIS_ESTIMATE : HAWSER_BASIS_PART;
	row->least = cost->complete ? cost->seconds/2.0 : cost->seen;
	row->most = cost->complete ? cost->seconds*2.0 : INFINITY;
	if (cost->limited)
		snprintf(row->foreseen, sizeof row->foreseen, "the curve takes more than %.0f points, where "
		         "it is ended", cost->points);
	else if (cost->slack > 0)
		snprintf(row->foreseen, sizeof row->foreseen, "the model's tension falls below zero at "
		         "%d of %d points", cost->slack, cost->traced);
}

static void measure(struct hawser_plan_row *row, const struct hawser_survey *survey,
                    further_function *further)
{
	const struct hawser_fidelity *fidelity = row->choice.fidelity;
	const struct hawser_plan *plan = survey->plan;
	const struct hawser_statics *statics = &plan->modes.statics;
	struct hawser_frf_options options = hawser_frf_defaults();
	struct hawser_study_curve curve = {.choice = row->choice};
	struct hawser_report report = {.message = ""};
	struct hawser__cost cost = {.seconds = NAN};
	struct hawser_rom rom = {.n = 0};
	struct hawser__trial trial;
	enum hawser_status status = HAWSER_OK;

	options.from = plan->from;
	options.to = plan->to;
	options.step_max = step;
	options.progress = hawser__trial_watch;
	options.progress_context = &trial;
	hawser__trial_begin(&trial, survey->allowance, &options,
	                    points_between(survey, plan->from, plan->to));
	if (fidelity->build)
		status = fidelity->build(&rom, statics, survey->scene, row->choice.number, &report);
	if (!status)
		status = fidelity->respond(&curve, &rom, statics, survey->scene, &options, &report);
	if (!trial.stopped) {
		take_run(row, &trial, &curve);
		foresee(row, &curve, status, &report);
	} else if (further) {
		further(&cost, &trial, &curve, &rom, survey);
		take_estimate(row, &cost);
	}
	/* what a search ends with depends on whether it was run to its end: sizes stay those of the look */
	if (rom.n > 0 && fidelity->build) {
		row->n = rom.n;
		row->quads = rom.quads;
		row->cubics = rom.cubics;
	}
	hawser__trial_end(&trial, survey->allowance);
	hawser_rom_clear(&rom);
	hawser_study_clear(&curve);
}

void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	measure(row, survey, further_curve);
}

void hawser__estimate_chosen_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	measure(row, survey, further_chosen);
}

void hawser__estimate_auto_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	measure(row, survey, further_auto);
}

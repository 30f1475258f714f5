/* study/plan/cost.c - the size of a model, and the estimated cost of its response.
 *
 * Tensor entries are counted, not computed. The cable is symmetric to its plane, so that a term of
 * the energy with an odd number of out-of-plane coordinates is zero. All other entries count.
 *
 * Times are measured; if the whole response would take too long, a part of it is computed
 * (trial.c). A fidelity that traces several curves is interrupted in one of them. The earlier
 * curves have been measured. The interrupted curve is assumed to have as many points as the
 * previous one; if it is the first, it is estimated as a single curve. The time of further curves
 * is estimated from a few points of the second model for `chosen`, and from the ratio of their time
 * to that of the first curve, measured in the scenes of bench/plan-times, for `auto`.
 *
 * A formula for the number of points is used for the part that no trace covers. The longest step
 * (at most 1 % of Omega) requires a certain number of points over the range. Each resonance adds a
 * number of points around its peak. Its folds become sharper as it bends, which about doubles this
 * number for each factor e by which the bend exceeds the width.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/accuracy/chosen.h"
#include "study/plan/cost.h"
#include "study/accuracy/respond.h"
#include "study/accuracy/survey.h"

static const double step = 0.005;      /* longest step relative to the range, the value that hawser
                                        * frf and hawser compare use */
static const double each = 22.0;       /* points around the peak of a resonance, a fit to the scenes
                                        * of bench/plan-times */
static const double each_fold = 12.0;  /* further points per factor e of bend over width, from the
                                        * same scenes */
static const double alike = 1.25;      /* ratio of the times of two runs of one response on one
                                        * machine; chosen */
/* Largest bend, in units of the width of the resonance, for which the formula is used: folds begin
 * at sqrt(3)/2. */
static const double far_bent = 0.8;

/* 1: the i-th of the modes at `index` is out of the plane. */
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

static double least_between(const void *context, double from, double to)
{
	const struct hawser_survey *survey = context;
	double whole = fabs(survey->plan->to - survey->plan->from);

	return fabs(to - from)/(step*whole);
}

static double points_between(const void *context, double from, double to)
{
	const struct hawser_survey *survey = context;
	const struct hawser_plan *plan = survey->plan;
	double low = fmin(from, to), high = fmax(from, to);
	double points = fmax(least_between(context, from, to), log(high/low)/0.01);

	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double width = survey->raw.D[(size_t)at->mode*survey->raw.n + at->mode];
		double bend = fabs(at->peak_omega - at->omega);

		if (at->omega > low && at->omega < high)
			points += each + each_fold*fmax(0.0, log(bend/width));
	}
	return points;
}

/* 1: the formula holds for this resonance: it bends less than its width and is not in resonance
 * with another mode. */
static int smooth_between(const void *context, double from, double to)
{
	const struct hawser_survey *survey = context;
	const struct hawser_plan *plan = survey->plan;
	double low = fmin(from, to), high = fmax(from, to);

	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double width = survey->raw.D[(size_t)at->mode*survey->raw.n + at->mode];
		/* the cubic coefficient of raw models also counts, as in a tensor without condensation */
		double bend = fabs(at->peak_omega - at->omega)*fmax(1.0, fabs(at->unlocked/at->cubic));

		if (at->omega > low - bend && at->omega < high + bend &&
		    (at->partner >= 0 || bend > far_bent*width))
			return 0;
	}
	return 1;
}

struct hawser__outlook hawser__plan_outlook(const struct hawser_survey *survey)
{
	return (struct hawser__outlook){points_between, least_between, smooth_between, survey};
}

/* --- estimates for the rest of an interrupted response --- */

static void further_curve(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                          struct hawser__begun *begun, char *why,
                          const struct hawser_survey *survey)
{
	struct hawser__outlook outlook = hawser__plan_outlook(survey);
	struct hawser_frf left = {.n = 0};

	(void)why;
	hawser__trial_finish(cost, &left, trial, &begun->rom, &begun->curve.frf, &outlook);
	hawser_frf_clear(&left);
}

void hawser__count_curves(struct hawser__trial_cost *cost, const struct hawser__trial *trial)
{
	double points = fmax(trial->before, trial->points);

	*cost = (struct hawser__trial_cost){
		.seconds = trial->began - trial->start + (trial->last - trial->began)*points/trial->points,
		.seen = trial->last - trial->start, .points = points, .complete = 1, .omega = NAN};
}

/* The second curve of `chosen`, of another model and with another tolerance, is assumed to have as
 * many points as the first. */
static void further_chosen(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                           struct hawser__begun *begun, char *why,
                           const struct hawser_survey *survey)
{
	const struct hawser_frf_options *options = trial->options;
	struct hawser__outlook outlook = hawser__plan_outlook(survey);
	int number = (int)begun->curve.choice.number;
	struct hawser__chosen begin;
	struct hawser_rom own = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	struct hawser__trial_cost second;
	double point;

	(void)why;
	if (trial->curve > 1) {
		hawser__count_curves(cost, trial);
		return;
	}
	if (!hawser__chosen_begin(&begin, &survey->plan->modes.statics, survey->scene, options, number,
	                          NULL) &&
	    !hawser_choice_build(&own, &begin.choice, &begin.scene, NULL) &&
	    !hawser__trial_curve(cost, trial, &own, &begin.options, HAWSER__FIRST_POINTS, &outlook,
	                         NULL)) {
		point = hawser__trial_point(trial);
		hawser_rom_clear(&own);
		hawser_choice_first(&begin.choice, number);
		if (!hawser_choice_build(&own, &begin.choice, &begin.scene, NULL) &&
		    !hawser__trial_points(&second, &frf, trial, &own, options, HAWSER__FIRST_POINTS, NULL))
			cost->seconds *= 1.0 + hawser__trial_point(trial)/point;
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&own);
	hawser__chosen_clear(&begin);
}

/* --- one row of the plan --- */

static void foresee(struct hawser_plan_row *row, const struct hawser__begun *begun,
                    enum hawser_status status, const struct hawser_report *report)
{
	int unreached = begun->accuracy.tries > 0 && !begun->accuracy.reached;

	row->status = status;
	if (status)
		snprintf(row->foreseen, sizeof row->foreseen, "%.*s", (int)sizeof row->foreseen - 1,
		         report->message);
	else if (unreached)
		snprintf(row->foreseen, sizeof row->foreseen, "the accuracy is not reached: folds and "
		         "peaks are known to %.2g", begun->accuracy.estimated);
}

/* Take over the measured figures of a response that was computed to its end. */
static void take_run(struct hawser_plan_row *row, const struct hawser__trial *trial,
                     const struct hawser__begun *begun)
{
	int points = begun->accuracy.tries > 0 ? begun->accuracy.frf.points : begun->curve.frf.points;

	row->seconds = hawser__processor_seconds() - trial->start;
	row->least = row->seconds/alike;
	row->most = row->seconds*alike;
	row->basis = HAWSER_BASIS_RUN;
	if (points > 0)
		row->points = points;
}

static void take_estimate(struct hawser_plan_row *row, const struct hawser__trial_cost *cost,
                          const char *why)
{
	row->seconds = cost->seconds;
	row->points = cost->points;
	row->basis = cost->complete ? HAWSER_BASIS_ESTIMATE : HAWSER_BASIS_PART;
	row->bound = cost->bound;
	row->least = cost->bound ? cost->seconds : cost->seconds/2.0;
	row->most = cost->bound ? INFINITY : cost->seconds*2.0;
	if (cost->limited)
		snprintf(row->foreseen, sizeof row->foreseen, "the curve takes more than %.0f points, where "
		         "it is ended", cost->points);
	else if (cost->slack > 0)
		snprintf(row->foreseen, sizeof row->foreseen, "the model's tension falls below zero at "
		         "%d of %d points", cost->slack, cost->traced);
	else if (cost->bound)
		snprintf(row->foreseen, sizeof row->foreseen, "%s", why);
}

/* Start the response of the row; the trial measures its time. */
static enum hawser_status respond(struct hawser__begun *begun, struct hawser_plan_row *row,
                                  const struct hawser_survey *survey,
                                  const struct hawser_frf_options *options,
                                  struct hawser_report *report)
{
	const struct hawser_fidelity *fidelity = row->choice.fidelity;
	const struct hawser_statics *statics = &survey->plan->modes.statics;
	struct hawser_accuracy_options settings;
	enum hawser_status status = HAWSER_OK;

	begun->curve.choice = row->choice;
	if (fidelity->respond == hawser__study_auto)
		return hawser__study_search(&begun->accuracy, &settings, &row->choice, statics,
		                            survey->scene, options, report);
	if (fidelity->build)
		status = fidelity->build(&begun->rom, statics, survey->scene, row->choice.number, report);
	return status ? status : fidelity->respond(&begun->curve, &begun->rom, statics, survey->scene,
	                                           options, report);
}

/* The error of a condensed model as hawser frf states it, from the motions that were traced; of a part
 * of the response it is at least that of small motions, which row->omega_error has. */
static void judge(struct hawser_plan_row *row, const struct hawser__begun *begun, int whole,
                  const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;
	struct hawser_scene scene = *survey->scene; /* its `name` is owned by the caller */
	struct hawser_accuracy_fixed fixed;

	scene.model.condense = HAWSER_CONDENSE_STATIC;
	if (!row->choice.fidelity->build || !row->choice.fidelity->converges ||
	    isinf(row->omega_error) || begun->curve.frf.points < 2 ||
	    hawser_accuracy_fixed(&fixed, &begun->rom, &begun->curve.frf, (int)row->choice.number,
	                          &plan->modes.statics, &scene, plan->from, plan->to, NULL) ||
	    (!whole && !(fixed.estimated > row->omega_error)))
		return;
	row->omega_error = fixed.estimated;
	snprintf(row->why, sizeof row->why, "%sof folds and peaks, as hawser frf states it, from %s",
	         fixed.estimated < 1.0 ? "" : "more than 1 ",
	         whole ? "the whole response" : "a part of it: at least this");
}

static void measure(struct hawser_plan_row *row, const struct hawser_survey *survey,
                    hawser__further_function *further)
{
	const struct hawser_plan *plan = survey->plan;
	struct hawser_frf_options options = {.method = NULL};
	struct hawser__begun *begun = calloc(1, sizeof *begun);
	struct hawser_report report = {.message = ""};
	struct hawser__trial_cost cost = {.seconds = NAN, .omega = NAN};
	struct hawser__trial trial;
	enum hawser_status status;
	char why[HAWSER__WHY] = "how the curve goes on is not known: it has many events, is unstable or "
		"turns where its trace was cut, or meets a resonance that bends it far";

	row->foretold = row->omega_error;
	if (!begun)
		return; /* the row states that nothing is known */
	options.from = plan->from;
	options.to = plan->to;
	options.step_max = step;
	hawser_frf_settle(&options);
	options.progress = (struct hawser_progress){hawser__trial_watch, &trial};
	hawser__trial_begin(&trial, survey->allowance, &options,
	                    points_between(survey, plan->from, plan->to));
	status = respond(begun, row, survey, &options, &report);
	if (!trial.stopped) {
		take_run(row, &trial, begun);
		foresee(row, begun, status, &report);
	} else {
		further(&cost, &trial, begun, why, survey);
		take_estimate(row, &cost, why);
	}
	/* the final size of a search depends on where it ends, so the size known from the choice
	 * remains */
	if (begun->rom.n > 0 && row->choice.fidelity->build) {
		row->n = begun->rom.n;
		row->quads = begun->rom.quads;
		row->cubics = begun->rom.cubics;
	}
	hawser__trial_end(&trial, survey->allowance);
	if (!status || trial.stopped)
		judge(row, begun, !trial.stopped, survey);
	hawser_accuracy_clear(&begun->accuracy);
	hawser_rom_clear(&begun->rom);
	hawser_study_clear(&begun->curve);
	free(begun);
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
	measure(row, survey, hawser__further_auto);
}

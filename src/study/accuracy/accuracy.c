/* study/accuracy/accuracy.c - a response to a requested accuracy.
 *
 *    measure     estimated effect of the omission of a mode (choose.h)
 *    rest        sum of the measures of the omitted modes
 *    truncation  effect of the terms of the energy beyond fourth order, and of the inertia and damping
 *                of modes that are not candidates (choose.h)
 *    moved       distance of a response from that of the previous model (distance.c)
 *
 * The first model keeps the modes that estimated motions require, at most HAWSER__FIRST, since the
 * cost of a response grows fast with the number of modes. The motions of its response, at landmarks and
 * between them, give every mode a new measure, and the error of this response (fixed.c). While that is
 * too large, the most important modes are added, a new response is traced, and so on. The last model
 * is the result.
 *
 * If the truncation alone exceeds the accuracy, or if adding modes does not reach it, full-order
 * models follow (accuracy_full.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy/accuracy.h"
#include "study/accuracy/motions.h"

/* Parts are relative to the accuracy. Where no bench is named, a value was chosen. */
#define KEPT_MOST 40  /* default of the largest number of modes of a model */
#define ROOM 0.25     /* the same, relative to the accuracy less the truncation error */
#define BEYOND 0.35   /* largest effect of the modes above the candidates */
#define WIDER 1.5     /* factor on the number of candidates if their effect is larger */
#define UNRESOLVED 0.1 /* largest error of a candidate's frequency */
#define SLACK_PART 0.2 /* part of the points with negative tension that ends the search: a cable
                        * cannot carry such tensions, so that no such model is valid */
#define SLACK_POINTS 50 /* fewest points of which this part is judged */
#define POINTS_MOST 2500 /* most points of a response: a longer one has too many peaks to match */
#define CONDENSED_TRIES 7 /* most condensed models; full-order ones have the remaining tries */

/* --- candidates --- */

/* The measure of a mode of frequency w that responds at 2 Omega is about 0.13 (2 Omega/w)^3 in the
 * scenes of bench/accuracy. */
double hawser__accuracy_reach(double to, double accuracy)
{
	return 2.0*to*fmax(2.0, cbrt(0.3/accuracy));
}

static struct hawser_modes_options settings(const struct hawser_scene *scene, int n)
{
	struct hawser_modes_options options = {.n = n, .basis = scene->model.basis};

	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	return options;
}

/* The basis that the scene prescribes may be too small for the candidates. */
static enum hawser_status check_resolved(const struct hawser_modes *modes,
                                         const struct hawser_scene *scene, double accuracy,
                                         struct hawser_report *report)
{
	int worst = 0;

	for (int j = 1; j < modes->n; j++)
		if (!(modes->mode[j].residual <= modes->mode[worst].residual))
			worst = j;
	if (modes->mode[worst].residual <= UNRESOLVED*accuracy)
		return HAWSER_OK;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", worst + 1,
	                       modes->mode[worst].residual,
	                       "an accuracy of %g needs the lowest %d modes here, and a basis of %d "
	                       "functions leaves an error of %.1e in mode %d: %s", accuracy, modes->n,
	                       modes->basis, modes->mode[worst].residual, worst + 1,
	                       scene->model.basis > 0 ? "raise model.basis, or leave it out"
	                       : "lower the accuracy or narrow the range");
}

enum hawser_status hawser__accuracy_candidates(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_scene *scene, double from,
                                               double to, double accuracy, int fewest,
                                               struct hawser_report *report)
{
	double top = hawser__accuracy_reach(fmax(from, to), accuracy);
	struct hawser_modes_options options = settings(scene, fewest);
	enum hawser_status status = hawser_modes_solve(modes, statics, &options, report);

	if (status)
		return status;
	if (modes->mode[fewest - 1].omega < top && fewest < HAWSER__AMONG) {
		double wanted = ceil(fewest*top/modes->mode[fewest - 1].omega);

		options.n = (int)fmin(wanted, HAWSER__AMONG);
		hawser_modes_clear(modes);
		status = hawser_modes_solve(modes, statics, &options, report);
	}
	return status ? status : check_resolved(modes, scene, accuracy, report);
}

enum hawser_status hawser_accuracy_choose(struct hawser_choice *choice, struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_scene *scene, double from, double to,
                                          double accuracy, struct hawser_report *report)
{
	enum hawser_status status;

	*choice = (struct hawser_choice){0};
	status = hawser__accuracy_candidates(modes, statics, scene, from, to, accuracy, HAWSER__FEWEST,
	                                     report);
	return status ? status : hawser_choose(choice, modes, scene, from, to, HAWSER__NEXT*accuracy,
	                                       report);
}

enum hawser_status hawser_choice_build(struct hawser_rom *rom, const struct hawser_choice *choice,
                                       const struct hawser_scene *scene,
                                       struct hawser_report *report)
{
	int *kept = malloc((size_t)choice->n*sizeof *kept), count;
	struct hawser_modes subset;
	enum hawser_status status;

	*rom = (struct hawser_rom){0};
	if (!kept)
		return hawser__no_memory(report, "accuracy");
	count = hawser_choice_kept(kept, choice);
	status = hawser_modes_select(&subset, choice->modes, kept, count, report);
	if (status) {
		free(kept);
		return status;
	}
	status = hawser_rom_build(rom, &subset, scene, report);
	hawser_modes_clear(&subset);
	if (!status)
		status = hawser_rom_know(rom, &choice->all, kept, count, report);
	free(kept);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

/* --- one model after the other --- */

struct hawser_frf_options hawser__accuracy_settle(const struct hawser_accuracy_options *options,
                                                  double accuracy)
{
	struct hawser_frf_options frf = options->frf;

	if (frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-4*accuracy, 1e-9), 1e-7);
	if (frf.event_tolerance == 0.0)
		frf.event_tolerance = fmin(fmax(1e-3*accuracy, 1e-10), 1e-6);
	if (frf.step_max == 0.0)
		frf.step_max = 0.02;
	if (frf.max_points == 0 || frf.max_points > POINTS_MOST)
		frf.max_points = POINTS_MOST;
	return frf;
}

static void count_landmarks(struct hawser_accuracy_try *attempt, const struct hawser_frf *frf)
{
	for (int i = 0; i < frf->events; i++)
		attempt->folds += frf->event[i].kind == HAWSER_FOLD;
	attempt->points = frf->points;
}

int hawser__mostly_slack(const struct hawser_frf *frf)
{
	int slack = 0;

	for (int p = 0; frf->tension && p < frf->points; p++)
		slack += frf->tension[2*p] < 0.0;
	return slack > SLACK_PART*frf->points;
}

/* Interrupts a curve whose tension is negative from early on: it would take long and has no
 * meaning. */
static int watch(void *data, const struct hawser_progress_state *state)
{
	const struct hawser_frf_options *options = data;

	return (state->frf->points >= SLACK_POINTS && hawser__mostly_slack(state->frf)) ||
	       hawser__told_to_stop(&options->progress, state);
}

/* Compare the last response with the previous one; its landmarks and curve then replace those of
 * the previous one in *marks. */
static enum hawser_status compare(struct hawser_accuracy *a, struct hawser__marks *marks,
                                  const struct hawser_frf_options *options,
                                  struct hawser_report *report)
{
	struct hawser_accuracy_try *this = &a->attempt[a->tries];
	struct hawser__marks found;
	enum hawser_status status = hawser__marks_find(&found, &a->frf, &a->rom, options,
	                                               HAWSER__LOCATED*a->asked, report);

	if (status)
		return status;
	if (marks->curve.points > 0)
		status = hawser__marks_distance(&this->moved, marks, &found, report);
	hawser__marks_clear(marks);
	*marks = found;
	return status;
}

enum hawser_status hawser__accuracy_attempt(struct hawser_accuracy *a, struct hawser__marks *marks,
                                            const struct hawser_scene *scene, int functions,
                                            const struct hawser_frf_options *options,
                                            const struct hawser__orbits *known,
                                            struct hawser_report *report)
{
	const struct hawser__trace_watch watcher = {.known = known};
	struct hawser_accuracy_try *this = &a->attempt[a->tries];
	struct hawser_frf_options watched = a->traced = *options;
	double start = hawser__wall_seconds();
	enum hawser_status status = HAWSER_OK;

	*this = (struct hawser_accuracy_try){.functions = functions, .moved = NAN};
	hawser_frf_clear(&a->frf);
	if (!functions) {
		hawser_rom_clear(&a->rom);
		status = hawser_choice_build(&a->rom, &a->choice, scene, report);
	}
	a->full = functions > 0;
	watched.progress = (struct hawser_progress){watch, (void *)options};
	if (!status)
		status = hawser__frf_trace(&a->frf, &a->rom, &watched, &watcher, report);
	if (!status)
		status = compare(a, marks, options, report);
	a->slack = !status && hawser__mostly_slack(&a->frf);
	this->modes = a->rom.n - a->rom.inertia.shapes;
	count_landmarks(this, &a->frf);
	this->seconds = hawser__wall_seconds() - start;
	a->tries++;
	return status;
}

static int kept(const struct hawser_choice *choice)
{
	int count = 0;

	for (int j = 0; j < choice->n; j++)
		count += choice->mode[j].kept;
	return count;
}

/* Increase the number of candidates: the same modes are kept, and the same motions weigh them. */
static enum hawser_status widen(struct hawser_accuracy *a, const struct hawser__marks *marks,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser_modes_options options = settings(scene, (int)fmin(WIDER*a->modes.n, HAWSER__AMONG));
	struct hawser_modes before = a->modes;
	struct hawser_choice old = a->choice;
	enum hawser_status status = hawser_modes_solve(&a->modes, &before.statics, &options, report);

	a->choice = (struct hawser_choice){0};
	if (!status)
		status = hawser_choose(&a->choice, &a->modes, scene, old.from, old.to, a->asked, report);
	for (int j = 0; !status && j < a->choice.n; j++)
		a->choice.mode[j].kept = j < old.n && old.mode[j].kept;
	hawser_choice_clear(&old);
	hawser_modes_clear(&before);
	return status ? status : hawser__weigh_response(&a->choice, &a->rom, &a->frf, marks,
	                                                   HAWSER__BETWEEN, report);
}

void hawser__accuracy_claim(struct hawser_accuracy *a, double model,
                            const struct hawser__marks *marks)
{
	a->estimated = fmax(model + hawser__marks_located(marks), HAWSER__LEAST_CLAIM*a->asked);
}

/* New measures from the motions of the last response. If modes above the candidates matter, the
 * number of candidates is increased first. */
static enum hawser_status judge(struct hawser_accuracy *a, const struct hawser__marks *marks,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];
	enum hawser_status status = hawser__weigh_response(&a->choice, &a->rom, &a->frf, marks,
	                                                   HAWSER__BETWEEN, report);

	while (!status && hawser_choice_beyond(&a->choice) > BEYOND*a->asked && a->modes.n < HAWSER__AMONG)
		status = widen(a, marks, scene, report);
	this->rest = hawser_choice_rest(&a->choice) + hawser_choice_beyond(&a->choice);
	this->truncation = a->choice.truncation;
	this->energy = a->choice.energy;
	return status;
}

/* Add modes. Returns 0 if the truncation error alone is too large, or the limit is reached, or no mode
 * matters. */
static int raised(struct hawser_accuracy *a, const struct hawser_accuracy_options *options)
{
	const struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];
	int most = options->most > 0 ? options->most : KEPT_MOST;
	double room = a->asked - HAWSER__SAFETY_ORDER*this->truncation;

	if (kept(&a->choice) >= most)
		return 0;
	/* while important modes are missing, the motion is wrong, and so is its truncation error */
	if (!(room > 0.0))
		return this->rest > a->asked && hawser_choice_raise(&a->choice, HAWSER__NEXT*a->asked);
	return hawser_choice_raise(&a->choice, fmin(HAWSER__NEXT*a->asked, ROOM*room));
}

int hawser__accuracy_cut(const struct hawser_accuracy *a)
{
	return a->frf.end == HAWSER_END_INTERRUPTED || a->frf.end == HAWSER_END_MAX_POINTS ||
	       a->slack;
}

/* Of the modes that hawser_accuracy_choose keeps, keep only those of the first model. */
static void accuracy_first(struct hawser_choice *choice)
{
	if (kept(choice) > HAWSER__FIRST)
		hawser_choice_first(choice, HAWSER__FIRST);
}

static enum hawser_status condensed(struct hawser_accuracy *a, struct hawser__marks *marks,
                                    const struct hawser_scene *scene,
                                    const struct hawser_accuracy_options *options,
                                    struct hawser_report *report)
{
	struct hawser_frf_options frf = hawser__accuracy_settle(options, a->asked);
	enum hawser_status status = HAWSER_OK;

	accuracy_first(&a->choice);
	while (!status && a->tries < CONDENSED_TRIES) {
		status = hawser__accuracy_attempt(a, marks, scene, 0, &frf, NULL, report);
		if (status || hawser__accuracy_cut(a))
			break;
		status = judge(a, marks, scene, report);
		if (status)
			break;
		hawser__accuracy_claim(a, hawser__model_error(&a->choice), marks);
		if (a->estimated <= a->asked || !raised(a, options))
			break;
	}
	return status;
}

/* Whether full-order models should follow: not after an interruption or a curve that is too long,
 * since a larger model does not help. A negative tension is a reason for them, since the tension is
 * a small difference of large terms in a condensed model. There are none for an inextensible cable,
 * or if the caller limited the number of modes. */
static int calls_for_full(const struct hawser_accuracy *a,
                          const struct hawser_accuracy_options *options)
{
	return a->estimated > a->asked && (!hawser__accuracy_cut(a) || a->slack) &&
	       options->most == 0 && a->choice.exact.n > 0;
}

static enum hawser_status raise_modes(struct hawser_accuracy *a, const struct hawser_scene *scene,
                                const struct hawser_accuracy_options *options,
                                struct hawser_report *report)
{
	struct hawser__marks marks = {0};
	enum hawser_status status = HAWSER_OK;

	if (scene->model.energy != HAWSER_ENERGY_EXACT)
		status = condensed(a, &marks, scene, options, report);
	if (!status && calls_for_full(a, options))
		status = hawser__accuracy_full(a, &marks, scene, options, report);
	a->reached = a->estimated <= a->asked && !hawser__accuracy_cut(a);
	hawser__marks_clear(&marks);
	return status;
}

enum hawser_status hawser__accuracy_begin(struct hawser_accuracy *a, const struct hawser_scene *scene,
                                          const struct hawser_accuracy_options *options,
                                          struct hawser_report *report)
{
	*a = (struct hawser_accuracy){
		.asked = options->accuracy > 0.0 ? options->accuracy : scene->model.accuracy,
		.estimated = 1.0, .until = NAN};
	if (!(a->asked > 0.0 && a->asked < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "accuracy %g: it is a part, between 0 and 1 (0.01 is 1 %%)", a->asked);
	if (scene->model.condense != HAWSER_CONDENSE_STATIC)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "model.modes: auto chooses the modes to keep and condenses the others: "
		                    "it goes with model.condense: static, not none");
	return HAWSER_OK;
}

enum hawser_status hawser_accuracy_trace(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	double start = hawser__wall_seconds();
	enum hawser_status status = hawser__accuracy_begin(accuracy, scene, options, report);

	if (!status)
		status = hawser_accuracy_choose(&accuracy->choice, &accuracy->modes, statics, scene,
		                                options->frf.from, options->frf.to, accuracy->asked, report);
	if (!status)
		status = raise_modes(accuracy, scene, options, report);
	accuracy->seconds = hawser__wall_seconds() - start;
	return status;
}

void hawser_accuracy_clear(struct hawser_accuracy *accuracy)
{
	if (!accuracy)
		return;
	hawser_frf_clear(&accuracy->frf);
	hawser_rom_clear(&accuracy->rom);
	hawser_choice_clear(&accuracy->choice);
	hawser_modes_clear(&accuracy->modes);
	memset(accuracy, 0, sizeof *accuracy);
}

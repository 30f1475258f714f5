/* study/accuracy.c - a response to an accuracy asked for.
 *
 *   measure   what leaving out a mode is expected to cost (choose.h)
 *   moved     what taking more modes did to folds and peaks
 *   rest      the sum of the measures of the modes left out
 *   truncation  what terms of the energy beyond the fourth order do, and inertia and damping of modes
 *               that are not looked at (choose.h)
 *
 * The first model keeps what the guessed motions ask for. Its response is traced, its own motions at
 * landmarks and between weigh every mode anew, and what is worth a part of the accuracy is added; and
 * so on, until a model adds nothing of weight and the last step moved less than the accuracy. So the
 * sequence is short (two or three models), and each is made for what the one before did, not for a
 * list of frequencies. The last model is the result: what the step before it moved bounds what it
 * lacks, if measures fall in order.
 *
 * No mode makes up for the terms of the energy that a condensed model lacks. Where these alone come to
 * more than the accuracy, or modes do not reach it, full-order models of growing bases follow, until
 * one agrees with the one before. Most of their errors fall so fast that what the last basis moved is
 * far more than what it lacks; but where a harmonic of the response meets a high mode, which only a
 * large basis has at the right frequency, moves of one size follow each other (B Table 4.4, line 2:
 * 1.2e-4 from 12 functions to 14, 1.5e-4 from 14 to 16). So the estimate is a multiple of the move.
 *
 * To either is added how well the peaks are located on their curves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/report.h"
#include "hawser/accuracy.h"
#include "study/distance.h"
#include "study/motions.h"

#define FEWEST 12     /* modes looked at */
#define MANY 48
#define KEPT_MOST 40
#define NEXT 0.2      /* of the accuracy: measures left out of the next model */
#define ROOM 0.25      /* the same, of what the order of the energy leaves */
#define BEYOND 0.35   /* of the accuracy: what modes beyond those looked at may add */
#define WIDER 1.5
#define SLACK_PART 0.2
#define SLACK_POINTS 50
#define POINTS_MOST 2500 /* of a response; what takes more has no few folds and peaks to compare */
#define SHARP 0.2     /* of the accuracy: how well peaks are located */
#define LEAST 0.1     /* of the accuracy, for which tolerances are chosen: no less is claimed */
#define SAFETY 3.0    /* bench/accuracy.c calibrates these three */
#define SAFETY_ORDER 1.5
#define SAFETY_BASIS 3.0
#define FINEST 1e-9   /* tolerance of orbits */
#define MIDDLING 12   /* functions a component, from which on a failure may be the tolerance's */
#define CONDENSED_TRIES 7 /* and the full ones: HAWSER_ACCURACY_TRIES */

/* Functions a component of full-order models. */
static const int bases[] = {6, 8, 12, 14, 16, 20};
enum { BASES = sizeof bases/sizeof *bases };

struct hawser_accuracy_options hawser_accuracy_defaults(void)
{
	struct hawser_accuracy_options options = {.most = 0, .frf = hawser_frf_defaults()};

	options.frf.tolerance = options.frf.event_tolerance = options.frf.step_max = 0.0;
	options.frf.max_points = POINTS_MOST;
	return options;
}

static double now(void)
{
	struct timespec time;

	clock_gettime(CLOCK_MONOTONIC, &time);
	return (double)time.tv_sec + 1e-9*(double)time.tv_nsec;
}

/* --- candidates --- */

/* Frequency up to which modes are looked at. The measure of one that answers at 2 Omega falls as some
 * 0.13 (2 Omega/w)^3 in the scenes of bench/accuracy. */
static double reach(double to, double accuracy)
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

enum hawser_status hawser_accuracy_choose(struct hawser_choice *choice, struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_scene *scene, double from, double to,
                                          double accuracy, struct hawser_report *report)
{
	double top = reach(fmax(from, to), accuracy);
	struct hawser_modes_options options = settings(scene, FEWEST);
	enum hawser_status status = hawser_modes_solve(modes, statics, &options, report);

	*choice = (struct hawser_choice){0};
	if (status)
		return status;
	if (modes->mode[FEWEST - 1].omega < top) {
		double wanted = ceil(FEWEST*top/modes->mode[FEWEST - 1].omega);

		options.n = (int)fmin(wanted, MANY);
		hawser_modes_clear(modes);
		status = hawser_modes_solve(modes, statics, &options, report);
	}
	return status ? status : hawser_choose(choice, modes, scene, from, to, NEXT*accuracy, report);
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
	free(kept);
	if (status)
		return status;
	status = hawser_rom_build(rom, &subset, scene, report);
	hawser_modes_clear(&subset);
	return status;
}

/* --- one model after the other --- */

static struct hawser_frf_options settle(const struct hawser_accuracy_options *options,
                                        double accuracy)
{
	struct hawser_frf_options frf = options->frf;

	if (frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-4*accuracy, 1e-9), 1e-7);
	if (frf.event_tolerance == 0.0)
		frf.event_tolerance = fmin(fmax(1e-3*accuracy, 1e-10), 1e-6);
	if (frf.step_max == 0.0)
		frf.step_max = 0.02;
	if (frf.max_points > POINTS_MOST)
		frf.max_points = POINTS_MOST;
	return frf;
}

static void count_landmarks(struct hawser_accuracy_try *attempt, const struct hawser_frf *frf)
{
	for (int i = 0; i < frf->events; i++)
		attempt->folds += frf->event[i].kind == HAWSER_FOLD;
	attempt->points = frf->points;
}

/* Whether the last model's cable is slack at so many points that no model of this kind is right. */
static int mostly_slack(const struct hawser_frf *frf)
{
	int slack = 0;

	for (int p = 0; frf->tension && p < frf->points; p++)
		slack += frf->tension[2*p] < 0.0;
	return slack > SLACK_PART*frf->points;
}

/* Ends a curve that is slack from early on: intricate, slow, and of no use. */
static int watch(void *context, const struct hawser_frf *frf)
{
	const struct hawser_frf_options *options = context;

	return (frf->points >= SLACK_POINTS && mostly_slack(frf)) ||
	       (options->progress && options->progress(options->progress_context, frf));
}

/* The same, coarser: harmonic balance bounds the error of folds and peaks, not of the orbit's ends. */
static struct hawser_frf_options settle_full(const struct hawser_accuracy_options *options,
                                             double accuracy)
{
	struct hawser_frf_options frf = settle(options, accuracy);

	if (options->frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-3*accuracy, 1e-9), 1e-6);
	return frf;
}

/* Build and trace what is kept now, or with `functions` the full order; how far it is from the
 * response before, which *marks are of; they become those of this one. */
static enum hawser_status attempt(struct hawser_accuracy *a, struct hawser__marks *marks,
                                  const struct hawser_scene *scene, int functions,
                                  const struct hawser_frf_options *options,
                                  struct hawser_report *report)
{
	struct hawser_accuracy_try *this = &a->attempt[a->tries];
	struct hawser_frf_options watched = *options;
	struct hawser__marks before = *marks;
	double start = now();
	enum hawser_status status;

	*this = (struct hawser_accuracy_try){.functions = functions, .moved = NAN};
	*marks = (struct hawser__marks){0};
	hawser_frf_clear(&a->frf);
	hawser_rom_clear(&a->rom);
	a->full = functions > 0;
	watched.progress = watch;
	watched.progress_context = (void *)options;
	status = functions ? hawser_rom_build_full(&a->rom, &a->modes.statics, scene, functions, report)
	                   : hawser_choice_build(&a->rom, &a->choice, scene, report);
	if (!status)
		status = hawser_frf_trace(&a->frf, &a->rom, &watched, report);
	if (!status)
		status = hawser__marks_find(marks, &a->frf, &a->rom, options, SHARP*a->asked, report);
	if (!status && a->tries > 0)
		status = hawser__marks_distance(&this->moved, &before, marks, report);
	a->slack = !status && mostly_slack(&a->frf);
	this->modes = a->rom.n - a->rom.inertia.shapes;
	count_landmarks(this, &a->frf);
	this->seconds = now() - start;
	a->tries++;
	hawser__marks_clear(&before);
	return status;
}

static int kept(const struct hawser_choice *choice)
{
	int count = 0;

	for (int j = 0; j < choice->n; j++)
		count += choice->mode[j].kept;
	return count;
}

/* More modes are looked at, with the same ones kept, and weighed by the same motions. */
static enum hawser_status widen(struct hawser_accuracy *a, const struct hawser__marks *marks,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser_modes_options options = settings(scene, (int)fmin(WIDER*a->modes.n, MANY));
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
	return status ? status : hawser__weigh_response(&a->choice, &a->rom, &a->frf, marks, report);
}

/* The estimate: what the model is off by, and the curve. */
static void claim(struct hawser_accuracy *a, double model, const struct hawser__marks *marks)
{
	a->estimated = fmax(model + hawser__marks_located(marks), LEAST*a->asked);
}

/* What the last response says of the modes left out; with more of them, where those beyond matter. */
static enum hawser_status judge(struct hawser_accuracy *a, const struct hawser__marks *marks,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];
	enum hawser_status status = hawser__weigh_response(&a->choice, &a->rom, &a->frf, marks, report);

	while (!status && hawser_choice_beyond(&a->choice) > BEYOND*a->asked && a->modes.n < MANY)
		status = widen(a, marks, scene, report);
	this->rest = hawser_choice_rest(&a->choice) + hawser_choice_beyond(&a->choice);
	this->truncation = a->choice.truncation;
	this->energy = a->choice.energy;
	if (a->tries > 1)
		claim(a, fmax(this->moved, SAFETY*hawser_choice_rest(&a->choice) +
		                           hawser_choice_beyond(&a->choice)) +
		         SAFETY_ORDER*this->truncation, marks);
	return status;
}

/* Modes will not do: the energy's order is too low, or there are as many as allowed. */
static int raised(struct hawser_accuracy *a, const struct hawser_accuracy_options *options)
{
	const struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];
	int most = options->most > 0 ? options->most : KEPT_MOST;
	double room = a->asked - SAFETY_ORDER*this->truncation;

	if (kept(&a->choice) >= most)
		return 0;
	/* where modes of weight are missing the motion is wrong, and does not tell the order */
	if (!(room > 0.0))
		return this->rest > a->asked && hawser_choice_raise(&a->choice, NEXT*a->asked);
	return hawser_choice_raise(&a->choice, fmin(NEXT*a->asked, ROOM*room)) ||
	       (!(this->moved <= a->asked) && hawser_choice_add(&a->choice, 1));
}

/* A part of a curve is no ground for a larger model, and neither is a cable that pushes. */
static int cut(const struct hawser_accuracy *a)
{
	return a->frf.end == HAWSER_END_INTERRUPTED || a->frf.end == HAWSER_END_MAX_POINTS ||
	       a->slack;
}

static enum hawser_status condensed(struct hawser_accuracy *a, struct hawser__marks *marks,
                                    const struct hawser_scene *scene,
                                    const struct hawser_accuracy_options *options,
                                    struct hawser_report *report)
{
	struct hawser_frf_options frf = settle(options, a->asked);
	enum hawser_status status = HAWSER_OK;

	while (!status && a->tries < CONDENSED_TRIES) {
		status = attempt(a, marks, scene, 0, &frf, report);
		if (status || cut(a))
			break;
		status = judge(a, marks, scene, report);
		if (status || a->estimated <= a->asked || !raised(a, options))
			break;
	}
	return status;
}

/* Neither way led there: with the reason of the last. */
static enum hawser_status lost(const struct hawser_accuracy *a, struct hawser_report *report)
{
	struct hawser_report last;

	if (!report)
		return HAWSER_ERR_CONVERGENCE;
	last = *report;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", last.iteration,
	                       last.residual, "an accuracy of %g is not reached with condensed models, "
	                       "and the full-order one that was to replace them fails: %s", a->asked,
	                       last.message);
}

/* A basis that is too small for the motion, or a tolerance that is too coarse for it, ends a trace
 * early: no more than that. Sets the tolerance that comes next. */
static int retry(enum hawser_status status, int *i, struct hawser_frf_options *frf,
                 const struct hawser_accuracy_options *options)
{
	if (status != HAWSER_ERR_CONVERGENCE)
		return 0;
	if (options->frf.tolerance == 0.0 && frf->tolerance > FINEST && bases[*i] >= MIDDLING) {
		frf->tolerance = FINEST;
		(*i)--;
		return 1;
	}
	return *i + 1 < BASES;
}

static enum hawser_status full(struct hawser_accuracy *a, struct hawser__marks *marks,
                               const struct hawser_scene *scene,
                               const struct hawser_accuracy_options *options,
                               struct hawser_report *report)
{
	struct hawser_frf_options frf = settle_full(options, a->asked);
	enum hawser_status status = HAWSER_OK;
	int before = 0;

	for (int i = 0; !status && i < BASES; i++) {
		/* the first is there to be compared with: its points need no second method */
		frf.samples = before ? options->frf.samples : 0;
		status = attempt(a, marks, scene, bases[i], &frf, report);
		if (retry(status, &i, &frf, options)) {
			status = HAWSER_OK;
			before = 0;
			continue;
		}
		if (status || cut(a))
			break;
		if (before)
			claim(a, SAFETY_BASIS*a->attempt[a->tries - 1].moved, marks);
		if (before && a->estimated <= a->asked)
			break;
		before = 1;
	}
	return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
}

static enum hawser_status raise(struct hawser_accuracy *a, const struct hawser_scene *scene,
                                const struct hawser_accuracy_options *options,
                                struct hawser_report *report)
{
	struct hawser__marks marks = {0};
	enum hawser_status status = condensed(a, &marks, scene, options, report);

	/* an inextensible cable has no such model, and who bounds the number of modes wants none */
	if (!status && a->estimated > a->asked && !cut(a) &&
	    options->most == 0 && a->choice.exact.n > 0)
		status = full(a, &marks, scene, options, report);
	a->reached = a->estimated <= a->asked && !cut(a);
	hawser__marks_clear(&marks);
	return status;
}

enum hawser_status hawser_accuracy_trace(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	double start = now();
	enum hawser_status status;

	*accuracy = (struct hawser_accuracy){
		.asked = options->accuracy > 0.0 ? options->accuracy : scene->model.accuracy,
		.estimated = 1.0};
	if (!(accuracy->asked > 0.0 && accuracy->asked < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "accuracy %g: it is a part, between 0 and 1 (0.01 is 1 %%)",
		                    accuracy->asked);
	if (scene->model.condense != HAWSER_CONDENSE_STATIC)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "model.modes: auto chooses the modes to keep and condenses the others: "
		                    "it goes with model.condense: static, not none");
	status = hawser_accuracy_choose(&accuracy->choice, &accuracy->modes, statics, scene,
	                                options->frf.from, options->frf.to, accuracy->asked, report);
	if (!status)
		status = raise(accuracy, scene, options, report);
	accuracy->seconds = now() - start;
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

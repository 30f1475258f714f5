/* modes/complex/damped_trace.c - damped modes of a span, and over a key of its scene.
 *
 * The basis is enlarged until two sizes agree. Bases don't depend on the dampers, so that a sweep over
 * the size of a damper has them once. Points of a sweep are independent and shared among threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/share.h"
#include "modes/complex/damped.h"

enum { TRIES = 8 };
/* Largest estimated error of a result. */
static const double acceptable = 1e-4;

void hawser_damped_settle(struct hawser_damped_options *options)
{
	if (options->tolerance == 0.0)
		options->tolerance = 1e-8;
}

void hawser_damped_clear(struct hawser_damped *damped)
{
	if (!damped)
		return;
	free(damped->mode);
	*damped = (struct hawser_damped){.n = 0};
}

static enum hawser_status check(const struct hawser_statics *st,
                                const struct hawser_damped_options *options,
                                struct hawser_report *report)
{
	if (options->n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d damped modes asked: ask for at least one", options->n);
	if (!(options->tolerance > 0.0 && options->tolerance < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a tolerance of damped modes of %g: give a relative error in (0, 1), or 0 "
		                    "for 1e-8", options->tolerance);
	if (st->motion.nu != 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "damped modes are those of a cable at rest: set travel.speed=0");
	return HAWSER_OK;
}

/* Damped modes with larger and larger bases. The last pair is left in *pair, which the caller
 * clears; one with `functions` is used first. */
static enum hawser_status solve(struct hawser_damped *damped, struct hawser__damped_pair *pair,
                                const struct hawser_statics *st, const struct hawser_scene *scene,
                                const struct hawser_damped_options *options,
                                struct hawser_report *report)
{
	double worst = INFINITY, before = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < TRIES; i++) {
		struct hawser_damped next = {.n = 0};

		if (i > 0 || pair->functions == 0) {
			struct hawser__damped_pair larger;

			status = hawser__damped_pair(&larger, st, options->n, i, report);
			if (status && damped->n > 0 && worst <= acceptable) /* no room for more */
				return HAWSER_OK;
			if (status)
				return status;
			hawser__damped_pair_clear(pair);
			*pair = larger;
		}
		status = hawser__damped_of(&next, &worst, pair, st, scene, options->n, report);
		if (status || worst < before) {
			hawser_damped_clear(damped);
			*damped = next;
		} else {
			hawser_damped_clear(&next);
		}
		if (status || (damped->n == options->n && worst <= options->tolerance))
			return status;
		if (damped->n == options->n && worst > 0.5*before && before <= acceptable)
			return HAWSER_OK; /* round-off */
		before = fmin(worst, before);
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", TRIES, before,
	                       "the first %d damped modes have an estimated relative error of %.1e: ask "
	                       "for fewer modes, or check the dampers of attach", options->n, before);
}

enum hawser_status hawser_damped_solve(struct hawser_damped *damped,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_damped_options *options,
                                       struct hawser_report *report)
{
	struct hawser_damped_options settled = *options;
	struct hawser__damped_pair pair = {.functions = 0};
	enum hawser_status status;

	*damped = (struct hawser_damped){.n = 0};
	hawser_damped_settle(&settled);
	status = check(statics, &settled, report);
	if (!status)
		status = solve(damped, &pair, statics, scene, &settled, report);
	hawser__damped_pair_clear(&pair);
	if (status)
		hawser_damped_clear(damped);
	return status;
}

/* --- sweep --- */

struct sweep {
	struct hawser_damped_sweep *to;
	const struct hawser_scene *scene;
	const struct hawser_damped_sweep_options *options;
	struct hawser__damped_pair *pair;   /* [threads] of the last point */
	struct hawser_report *report;       /* [points] */
	enum hawser_status *status;         /* [points] */
	int same;                           /* 1: all points have the same bases */
};

static void point(void *context, long item, int worker)
{
	struct sweep *sweep = context;
	const struct hawser_damped_sweep_options *options = sweep->options;
	struct hawser__damped_pair *pair = &sweep->pair[worker];
	struct hawser_report *report = &sweep->report[item];
	struct hawser_scene scene = *sweep->scene; /* a copy that is not cleared */
	struct hawser_statics st;
	enum hawser_status status;

	status = hawser_scene_set(&scene, options->key, sweep->to->value[item], report);
	if (!status)
		status = hawser_statics_scene(&st, &scene, report);
	if (!status)
		status = check(&st, &options->modes, report);
	if (!status && !sweep->same)
		hawser__damped_pair_clear(pair);
	if (!sweep->same)
		pair->functions = 0;
	if (!status)
		status = solve(&sweep->to->state[item], pair, &st, &scene, &options->modes, report);
	sweep->status[item] = status;
}

/* The failure of the first point that failed. */
static enum hawser_status verdict(const struct sweep *sweep, struct hawser_report *report)
{
	for (int i = 0; i < sweep->to->points; i++)
		if (sweep->status[i] == HAWSER_ERR_MEMORY)
			return hawser__no_memory(report, "modes");
		else if (sweep->status[i])
			return hawser__fail(report, sweep->status[i], "modes", "at %s = %.10g: %s",
			                    sweep->options->key, sweep->to->value[i],
			                    sweep->report[i].message);
	return HAWSER_OK;
}

static enum hawser_status check_sweep(const struct hawser_scene *scene,
                                      const struct hawser_damped_sweep_options *options,
                                      struct hawser_report *report)
{
	double now;
	enum hawser_status status = hawser_scene_get(scene, &now, options->key, report);

	if (status)
		return status;
	if (options->points < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a sweep of %d points: give at least one", options->points);
	for (int i = 0; i < options->points; i++)
		if (!isfinite(options->value[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
			                    "a sweep of %s to %g: give finite numbers", options->key,
			                    options->value[i]);
	return HAWSER_OK;
}

static enum hawser_status trace(struct sweep *sweep, int threads, struct hawser_report *report)
{
	int points = sweep->options->points;
	enum hawser_status status = HAWSER_OK;

	sweep->to->value = calloc((size_t)points, sizeof *sweep->to->value);
	sweep->to->state = calloc((size_t)points, sizeof *sweep->to->state);
	sweep->report = calloc((size_t)points, sizeof *sweep->report);
	sweep->status = calloc((size_t)points, sizeof *sweep->status);
	sweep->pair = calloc((size_t)threads, sizeof *sweep->pair);
	if (!sweep->to->value || !sweep->to->state || !sweep->report || !sweep->status || !sweep->pair)
		status = hawser__no_memory(report, "modes");
	if (!status) {
		sweep->to->points = points;
		for (int i = 0; i < points; i++)
			sweep->to->value[i] = sweep->options->value[i];
		hawser__share(points, threads, point, sweep);
		status = verdict(sweep, report);
	}
	for (int i = 0; sweep->pair && i < threads; i++)
		hawser__damped_pair_clear(&sweep->pair[i]);
	free(sweep->pair);
	free(sweep->report);
	free(sweep->status);
	return status;
}

enum hawser_status hawser_damped_trace(struct hawser_damped_sweep *sweep,
                                       const struct hawser_scene *scene,
                                       const struct hawser_damped_sweep_options *options,
                                       struct hawser_report *report)
{
	struct hawser_damped_sweep_options settled = *options;
	struct sweep work = {.to = sweep, .scene = scene, .options = &settled};
	int threads = options->threads > 0 ? options->threads : hawser__processors();
	enum hawser_status status = check_sweep(scene, options, report);

	*sweep = (struct hawser_damped_sweep){.points = 0};
	hawser_damped_settle(&settled.modes);
	work.same = strncmp(options->key, "attach.", 7) == 0 &&
	            (strstr(options->key, ".damper[") || strstr(options->key, ".absorber_stiffness") ||
	             strstr(options->key, ".absorber_damping"));
	if (!status)
		status = trace(&work, threads, report);
	if (status)
		hawser_damped_sweep_clear(sweep);
	return status;
}

void hawser_damped_sweep_clear(struct hawser_damped_sweep *sweep)
{
	if (!sweep)
		return;
	for (int i = 0; sweep->state && i < sweep->points; i++)
		hawser_damped_clear(&sweep->state[i]);
	free(sweep->value);
	free(sweep->state);
	*sweep = (struct hawser_damped_sweep){.points = 0};
}

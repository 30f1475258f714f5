/* modes/complex/damped_trace.c - damped modes of a span, and over a key of its scene.
 *
 * The basis is enlarged until two sizes agree. Bases don't depend on the dampers, so that a sweep over
 * the size of a damper has them once. Points of a sweep are independent and shared among threads.
 *
 * In a wind, modes may grow. Their number is counted at each point. If it differs at two neighbours,
 * the k-th largest growth, a continuous function of the key whatever modes have it, changes its sign
 * between them for each k from the smaller number on, and its zero is an event.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/order.h"
#include "core/report.h"
#include "core/share.h"
#include "modes/cable.h"
#include "modes/complex/damped.h"

enum { TRIES = 8, LOCATE = 40 }; /* sizes of the basis; steps of an event */
/* The same for a map, and elements of a cable whose largest size takes some 0.1 s. */
enum { FEW = 2, SOON = 12, SLACKEST = 2 };
/* Largest estimated error of a result. */
static const double acceptable = 1e-4;
/* Growth over the frequency at an event, and the bracket of its value, relative. */
static const double zero = 1e-13, located = 1e-12;
/* Both for a map, whose boundaries are located to 1e-4. */
static const double rough = 1e-9;

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

static enum hawser_status check(const struct hawser_statics *st, const struct hawser_scene *scene,
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
	if (scene && scene->wind.present && scene->wind.wake.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "damped modes do not take the wakes of wind.wake, whose motion is not "
		                    "small: set wind.wake=");
	if (st->motion.nu != 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "damped modes are those of a cable at rest: set travel.speed=0");
	return HAWSER_OK;
}

/* Damped modes with larger and larger bases, from the size *size on, which becomes the last one, up to
 * `most` sizes; `planes`: see damped.h. The last pair is left in *pair, which the caller clears; one
 * with `functions` is used first. */
static enum hawser_status solve(struct hawser_damped *damped, struct hawser__damped_pair *pair,
                                int *size, int most, int planes, const struct hawser_statics *st,
                                const struct hawser_scene *scene,
                                const struct hawser_damped_options *options,
                                struct hawser_report *report)
{
	double worst = INFINITY, before = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (int i = *size, first = i; i < most; i++) {
		struct hawser_damped next = {.n = 0};

		*size = i;
		if (i > first || pair->functions == 0) {
			struct hawser__damped_pair larger;

			status = hawser__damped_pair(&larger, st, options->n, i, report);
			if (status && damped->n > 0 && worst <= acceptable) /* no room for more */
				return HAWSER_OK;
			if (status)
				return status;
			hawser__damped_pair_clear(pair);
			*pair = larger;
		}
		status = hawser__damped_of(&next, &worst, pair, st, scene, options->n, planes, report);
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
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", most, before,
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
	int size = 0;

	*damped = (struct hawser_damped){.n = 0};
	hawser_damped_settle(&settled);
	status = check(statics, scene, &settled, report);
	if (!status)
		status = solve(damped, &pair, &size, TRIES, 1, statics, scene, &settled, report);
	hawser__damped_pair_clear(&pair);
	if (status)
		hawser_damped_clear(damped);
	return status;
}

/* --- sweep --- */

struct sweep {
	struct hawser_damped_sweep *to;
	const struct hawser_scene *scene;          /* or */
	const struct hawser_damped_source *source;
	const struct hawser_damped_sweep_options *options;
	struct hawser__damped_pair *pair;   /* [threads] of the last point */
	struct hawser_report *report;       /* [points] */
	enum hawser_status *status;         /* [points] */
	int same;                           /* 1: all points have the same bases */
	int map;                            /* 1: for a map (hawser__damped_onset): fewer sizes of bases,
	                                     * wider limits, no planes */
	int *size; /* size of the bases of the last point, with which the next begins; NULL: with the
	            * first size */
};

static enum hawser_status solve_at(struct hawser_damped *state, const struct sweep *sweep, double value,
                                   struct hawser__damped_pair *pair, struct hawser_report *report)
{
	const struct hawser_damped_sweep_options *options = sweep->options;
	struct hawser_scene scene;
	struct hawser_statics st;
	enum hawser_status status;
	int size = 0;

	if (sweep->source)
		return sweep->source->solve(sweep->source->context, state, value, report);
	scene = *sweep->scene; /* a copy that is not cleared */
	status = hawser_scene_set(&scene, options->key, value, report);
	if (!status)
		status = hawser_statics_scene(&st, &scene, report);
	if (!status)
		status = check(&st, &scene, &options->modes, report);
	if (!status && !sweep->same)
		hawser__damped_pair_clear(pair);
	if (!sweep->same)
		pair->functions = 0;
	if (!status && sweep->map && hawser__cable_elements(&st) > SLACKEST)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "modes",
		                      "at %s = %.6g the cable hangs so deep that its damped modes take too "
		                      "long for a map: choose ranges with less sag, or take hawser modes "
		                      "--damped at this point",
		                      options->key, value);
	if (!status)
		status = solve(state, pair, sweep->size ? sweep->size : &size, sweep->map ? FEW : TRIES,
		               !sweep->map, &st, &scene, &options->modes, report);
	return status;
}

static void point(void *context, long item, int worker)
{
	struct sweep *sweep = context;

	sweep->status[item] = solve_at(&sweep->to->state[item], sweep, sweep->to->value[item],
	                               &sweep->pair[worker], &sweep->report[item]);
}

/* --- events --- */

/* Growth over the frequency that may be round-off. */
static const double still = 1e-12;

static double growth_of(const struct hawser_damped_mode *mode)
{
	return mode->re/mode->omega - still;
}

static int growing(const struct hawser_damped *state)
{
	int count = 0;

	for (int i = 0; i < state->n; i++)
		count += growth_of(&state->mode[i]) > 0.0;
	return count;
}

/* The mode of the k-th largest growth, from 0. */
static const struct hawser_damped_mode *ranked(const struct hawser_damped *state, int k)
{
	for (int i = 0; i < state->n; i++) {
		int above = 0;

		for (int j = 0; j < state->n; j++) {
			double more = growth_of(&state->mode[j]) - growth_of(&state->mode[i]);

			above += more > 0.0 || (more == 0.0 && j < i);
		}
		if (above == k)
			return &state->mode[i];
	}
	return state->mode;
}

/* The zero of the k-th largest growth between points i and i + 1. */
static enum hawser_status locate_event(struct hawser_damped_event *event, const struct sweep *sweep,
                                       int i, int k, struct hawser_report *report)
{
	const struct hawser_damped *state = sweep->to->state + i;
	const double *value = sweep->to->value + i;
	int down = value[1] < value[0];
	struct hawser__bracketed in = {.a = value[down], .b = value[!down],
		.fa = growth_of(ranked(&state[down], k)), .fb = growth_of(ranked(&state[!down], k))};
	struct hawser_damped now = {.n = 0};
	enum hawser_status status = HAWSER_OK;

	event->onset = growing(&state[1]) > growing(&state[0]);
	for (int try = 0; !status && try < LOCATE; try++) {
		double s = hawser__false_position(&in, try), growth;

		if (sweep->map && try == SOON) {
			status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "modes",
			                      "the growth of a mode jumps near %s = %.6g", sweep->options->key, s);
			break;
		}
		hawser_damped_clear(&now);
		status = solve_at(&now, sweep, s, sweep->pair, report);
		if (status)
			break;
		growth = growth_of(ranked(&now, k));
		event->value = s;
		if (fabs(growth) < (sweep->map ? rough : zero) ||
		    in.b - in.a < (sweep->map ? rough : located)*fabs(s))
			break;
		hawser__false_position_take(&in, s, growth);
	}
	if (!status) {
		const struct hawser_damped_mode *mode = ranked(&now, k);

		event->frequency = mode->omega/now.time_unit/(2.0*M_PI);
		event->plane = mode->plane;
		event->number = mode->number;
	}
	hawser_damped_clear(&now);
	return status;
}

/* The events between points i and i + 1, which share their room with those before. */
static enum hawser_status events_between(const struct sweep *sweep, int i, struct hawser_report *report)
{
	struct hawser_damped_sweep *to = sweep->to;
	int before = growing(&to->state[i]), after = growing(&to->state[i + 1]), first = to->events;
	enum hawser_status status = HAWSER_OK;

	for (int k = before < after ? before : after; !status && k < (before < after ? after : before);
	     k++) {
		struct hawser_damped_event *grown = realloc(to->event,
		                                            ((size_t)to->events + 1)*sizeof *grown);

		if (!grown)
			return hawser__no_memory(report, "modes");
		to->event = grown;
		status = locate_event(&grown[to->events++], sweep, i, k, report);
	}
	if (to->events > first)
		qsort(to->event + first, (size_t)(to->events - first), sizeof *to->event, hawser__ascending);
	return status;
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

static enum hawser_status check_sweep(const struct hawser_damped_sweep_options *options,
                                      struct hawser_report *report)
{
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
		for (int i = 0; !status && (sweep->source || sweep->scene->wind.present) && i + 1 < points; i++)
			status = events_between(sweep, i, report);
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
	double now;
	enum hawser_status status = hawser_scene_get(scene, &now, options->key, report);

	if (!status)
		status = check_sweep(options, report);
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

enum hawser_status hawser_damped_follow(struct hawser_damped_sweep *sweep,
                                        const struct hawser_damped_source *source,
                                        const struct hawser_damped_sweep_options *options,
                                        struct hawser_report *report)
{
	struct sweep work = {.to = sweep, .source = source, .options = options};
	enum hawser_status status = check_sweep(options, report);

	*sweep = (struct hawser_damped_sweep){.points = 0};
	if (!status)
		status = trace(&work, 1, report);
	if (status)
		hawser_damped_sweep_clear(sweep);
	return status;
}

enum hawser_status hawser__damped_onset(double *value, const struct hawser_scene *scene,
                                        const struct hawser_damped_sweep_options *options,
                                        struct hawser_report *report)
{
	struct hawser_damped state[2] = {{.n = 0}};
	struct hawser_damped_sweep to = {.points = options->points, .state = state};
	struct hawser__damped_pair pair = {.functions = 0};
	struct hawser_damped_event event = {.value = INFINITY};
	int size = -1;
	struct sweep work = {.to = &to, .scene = scene, .options = options, .pair = &pair, .map = 1,
	                     .size = &size};
	enum hawser_status status = HAWSER_OK;

	*value = INFINITY;
	for (int i = 0; i < options->points && !status && isinf(*value); i++) {
		to.value = (double[2]){i > 0 ? options->value[i - 1] : NAN, options->value[i]};
		hawser_damped_clear(&state[0]);
		state[0] = state[1];
		state[1] = (struct hawser_damped){.n = 0};
		status = solve_at(&state[1], &work, options->value[i], &pair, report);
		if (status || i == 0 || growing(&state[1]) <= growing(&state[0]))
			continue;
		/* the largest growth that is not yet positive is the first to be */
		status = locate_event(&event, &work, 0, growing(&state[0]), report);
		*value = event.value;
	}
	hawser_damped_clear(&state[0]);
	hawser_damped_clear(&state[1]);
	hawser__damped_pair_clear(&pair);
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
	free(sweep->event);
	*sweep = (struct hawser_damped_sweep){.points = 0};
}

/* response/folds_walk.c - pseudo-arclength continuation of a fold in (orbit, Omega, load).
 *
 * The metric is the orbit's (method.h) with the relative change of the load. A step is predicted on
 * the parabola through the last tangents, corrected by Newton's method with derivatives anew in every
 * iteration (they come from the factorisation that the iteration needs anyway), and its length follows
 * the turning of the tangent, the contraction and the distance of the prediction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/flow.h"
#include "response/folds_walk.h"

#define MAX_ITERATIONS 10
#define WORST_CONTRACTION 0.7
#define GOAL_CONTRACTION 0.05
#define GOAL_ANGLE 0.15
#define GOAL_DISTANCE 1e-2
#define WORST_ANGLE 0.5
#define WORST_DISTANCE 0.2
#define FIRST_STEP 0.02
#define LARGEST_STEP 0.3
#define SMALLEST_STEP 1e-9
#define SORTING_STEP 1e-6 /* below this, events in one step are told apart no further */

static int init_station(struct hawser__fold_station *station, int size)
{
	station->memory = calloc(4*(size_t)size, sizeof(double));
	if (!station->memory)
		return 1;
	station->z = station->memory;
	station->t = station->z + size;
	station->b = station->t + size;
	station->c = station->b + size;
	return 0;
}

enum hawser_status hawser__walk_open(struct hawser__fold_walk *walk, struct hawser__fold *fold,
                                     const struct hawser_folds_options *options,
                                     struct hawser_report *report)
{
	struct hawser__fold_station *all[] = {&walk->start, &walk->prev, &walk->here, &walk->next,
	                                      &walk->scratch, &walk->lo, &walk->hi};
	int failed = 0;

	*walk = (struct hawser__fold_walk){.fold = fold, .options = options, .report = report,
		.omega_lo = fmin(options->from, options->to),
		.omega_hi = fmax(options->from, options->to)};
	walk->window_lo = walk->omega_lo;
	walk->window_hi = walk->omega_hi;
	for (size_t i = 0; i < sizeof all/sizeof *all; i++)
		failed |= init_station(all[i], fold->size);
	walk->direction = calloc((size_t)fold->size, sizeof(double));
	walk->plane = calloc((size_t)fold->size, sizeof(double));
	walk->state = calloc(2*(size_t)fold->load.rom.n, sizeof(double));
	walk->amplitude = hawser__amplitude_new(&fold->load.rom);
	if (failed || !walk->direction || !walk->plane || !walk->state || !walk->amplitude)
		return hawser__no_memory(report, "folds");
	return HAWSER_OK;
}

void hawser__walk_clear(struct hawser__fold_walk *walk)
{
	free(walk->start.memory);
	free(walk->prev.memory);
	free(walk->here.memory);
	free(walk->next.memory);
	free(walk->scratch.memory);
	free(walk->lo.memory);
	free(walk->hi.memory);
	free(walk->direction);
	free(walk->plane);
	free(walk->state);
	hawser__amplitude_free(walk->amplitude);
}

void hawser__station_copy(struct hawser__fold_station *to, const struct hawser__fold_station *from,
                          int size)
{
	struct hawser__fold_station own = *to;

	*to = *from;
	to->memory = own.memory;
	to->z = own.z;
	to->t = own.t;
	to->b = own.b;
	to->c = own.c;
	memcpy(to->memory, from->memory, 4*(size_t)size*sizeof(double));
}

void hawser__fold_swap(struct hawser__fold_station *a, struct hawser__fold_station *b)
{
	struct hawser__fold_station keep = *a;

	*a = *b;
	*b = keep;
}

void hawser__walk_metric(struct hawser__fold_walk *walk, const double *z)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);

	orbit->ops->metric(orbit, z);
	walk->fold->L = fabs(z[walk->fold->size - 1]);
}

/* Newton's method with the present harmonics. */
static enum hawser_status newton(struct hawser__fold_walk *walk,
                                 struct hawser__fold_station *station, const double *row,
                                 int *failed)
{
	struct hawser__fold *fold = walk->fold;
	double tolerance = walk->options->tolerance, previous = 0.0, *dz = fold->step;
	int size = fold->size, done = 0;

	*failed = 1;
	station->contraction = 0.0;
	for (int i = 0; i <= MAX_ITERATIONS; i++) {
		double length, ratio;
		enum hawser_status status = hawser__fold_evaluate(fold, &station->residual,
		                                                  station->z, walk->report);

		if (status || !isfinite(station->residual))
			return status;
		if (done && station->residual <= tolerance) {
			*failed = 0;
			return HAWSER_OK;
		}
		if (hawser__fold_solve(fold, dz, row, 0, 0.0))
			return HAWSER_OK;
		length = sqrt(hawser__fold_dot(fold, dz, dz));
		ratio = previous > 0.0 ? length/previous : 0.0;
		station->iterations = i + 1;
		if (i == 0)
			station->first = length;
		if (i == 1)
			station->contraction = ratio;
		if (!isfinite(length) || length > 1.0 ||
		    (ratio > WORST_CONTRACTION && length > tolerance))
			return HAWSER_OK;
		for (int k = 0; k < size; k++)
			station->z[k] += dz[k];
		if (station->z[size - 2] <= 0.0 || station->z[size - 1] <= 0.0)
			return HAWSER_OK;
		done = length <= 0.1*tolerance || (i > 0 && ratio*length <= 0.1*tolerance);
		previous = length;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__walk_correct(struct hawser__fold_walk *walk,
                                        struct hawser__fold_station *station, const double *row,
                                        int *failed)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);

	for (;;) {
		int again;
		enum hawser_status status = newton(walk, station, row, failed);

		if (status || *failed)
			return status;
		status = orbit->ops->refine(orbit, &again, walk->options->tolerance,
		                            station->z[walk->fold->size - 2], walk->report);
		if (status || !again)
			return status;
	}
}

void hawser__walk_finish(struct hawser__fold_walk *walk, struct hawser__fold_station *station,
                         const double *side)
{
	struct hawser__fold *fold = walk->fold;
	double *t = station->t, length;

	if (hawser__fold_solve(fold, t, side, 1, 1.0))
		memcpy(t, side, (size_t)fold->size*sizeof(double));
	length = sqrt(hawser__fold_dot(fold, t, t));
	for (int i = 0; i < fold->size; i++)
		t[i] /= length;
	station->test[HAWSER_FOLD_CUSP] = fold->second;
	station->test[HAWSER_FOLD_STATIONARY] = fold->F_omega;
	station->F_load = fold->F_load;
	station->mesh = fold->balance.base.mesh/fold->balance.base.X;
	hawser__fold_update(fold);
	memcpy(station->b, fold->b, (size_t)fold->size*sizeof(double));
	memcpy(station->c, fold->c, (size_t)fold->size*sizeof(double));
}

void hawser__walk_orient(struct hawser__fold_walk *walk,
                         const struct hawser__fold_station *station)
{
	memcpy(walk->fold->b, station->b, (size_t)walk->fold->size*sizeof(double));
	memcpy(walk->fold->c, station->c, (size_t)walk->fold->size*sizeof(double));
}

/* row = the direction of the load or of Omega alone. */
static void along(double *row, int size, int place)
{
	memset(row, 0, (size_t)size*sizeof *row);
	row[place] = 1.0;
}

static double angle_between(const struct hawser__fold_walk *walk)
{
	const struct hawser__fold *fold = walk->fold;
	double ab = hawser__fold_dot(fold, walk->here.t, walk->next.t);
	double aa = hawser__fold_dot(fold, walk->here.t, walk->here.t);
	double bb = hawser__fold_dot(fold, walk->next.t, walk->next.t);

	return acos(fmax(-1.0, fmin(1.0, ab/sqrt(aa*bb))));
}

static double largest_step(const struct hawser__fold_walk *walk)
{
	double range = walk->omega_hi - walk->omega_lo;
	double rate = fabs(walk->here.t[walk->fold->size - 2]);

	return fmin(LARGEST_STEP, walk->options->step_max*range/fmax(rate, 1e-300));
}

static void predict(struct hawser__fold_walk *walk)
{
	const struct hawser__fold_station *here = &walk->here, *prev = &walk->prev;
	double ds = walk->ds, bend = walk->known > 1 ? 0.5*ds*ds/(here->arc - prev->arc) : 0.0;

	for (int i = 0; i < walk->fold->size; i++)
		walk->next.z[i] = here->z[i] + ds*here->t[i] + bend*(here->t[i] - prev->t[i]);
}

static int interrupted(struct hawser__fold_walk *walk)
{
	const struct hawser_folds_options *options = walk->options;
	int size = walk->fold->size;

	if (options->progress &&
	    options->progress(options->progress_context, walk->stage, walk->list->points,
	                      walk->here.z[size - 2], walk->here.z[size - 1]))
		walk->stopped = 1;
	return walk->stopped;
}

/* Two kinds of events in one step are told apart by shorter ones. */
static int tangled(const struct hawser__fold_walk *walk)
{
	int changed = 0;

	for (int k = 0; k < HAWSER_FOLD_TESTS; k++)
		changed += (walk->here.test[k] < 0.0) != (walk->next.test[k] < 0.0);
	return changed > 1 && walk->ds > SORTING_STEP;
}

/* Make walk->next the next station; 1 in *failed when no step, however small, finds it. */
static enum hawser_status advance(struct hawser__fold_walk *walk, int *failed)
{
	for (;; walk->ds *= 0.5) {
		double angle, factor;
		int lost;
		enum hawser_status status;

		*failed = walk->ds < SMALLEST_STEP;
		if (*failed || interrupted(walk))
			return HAWSER_OK;
		predict(walk);
		if (walk->next.z[walk->fold->size - 1] <= 0.0)
			continue;
		hawser__walk_orient(walk, &walk->here);
		status = hawser__walk_correct(walk, &walk->next, walk->here.t, &lost);
		if (status)
			return status;
		if (lost)
			continue;
		hawser__walk_finish(walk, &walk->next, walk->here.t);
		walk->next.arc = walk->here.arc + walk->ds;
		angle = angle_between(walk);
		if (angle > WORST_ANGLE || walk->next.first > WORST_DISTANCE*walk->ds || tangled(walk))
			continue;
		factor = fmin(GOAL_ANGLE/fmax(angle, 1e-12),
		              sqrt(GOAL_CONTRACTION/fmax(walk->next.contraction, 1e-12)));
		factor = fmin(factor, cbrt(GOAL_DISTANCE/fmax(walk->next.first, 1e-12)));
		walk->ds = fmin(walk->ds*fmax(0.4, fmin(1.8, factor)), largest_step(walk));
		return HAWSER_OK;
	}
}

static void say_where(struct hawser__fold_walk *walk)
{
	int size = walk->fold->size;

	walk->list->end = HAWSER_FOLDS_FAILED;
	snprintf(walk->list->message, sizeof walk->list->message,
	         "the corrector failed near Omega %.9g%s, load factor %.9g (residual %.2g)",
	         HAWSER_SHOWN(walk->fold->load.full, walk->here.z[size - 2]),
	         walk->here.z[size - 1], walk->next.residual);
}

/* Record next and what lies before it. Where a special point cannot be located, next is probably on
 * another curve that comes near: the step is taken back, and halved as long as that can be. */
static enum hawser_status accept(struct hawser__fold_walk *walk, int *again)
{
	struct hawser__fold_list *list = walk->list;
	double taken = walk->next.arc - walk->here.arc;
	int points = list->points, events = list->events, missed;
	enum hawser_status status = hawser__list_point(list, walk, &walk->next);

	*again = 0;
	if (status || (status = hawser__fold_events(walk, &missed)) || !missed ||
	    taken < 1e3*SMALLEST_STEP)
		return status;
	list->points = points;
	list->events = events;
	list->message[0] = '\0';
	walk->ds = 0.5*taken;
	*again = 1;
	return HAWSER_OK;
}

static enum hawser_status follow(struct hawser__fold_walk *walk)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	struct hawser__fold_list *list = walk->list;
	enum hawser_status status;

	for (;;) {
		int failed, ended = 0, again;

		if (list->points >= walk->options->max_points) {
			list->end = HAWSER_FOLDS_MAX_POINTS;
			return HAWSER_OK;
		}
		hawser__walk_metric(walk, walk->here.z);
		if ((status = advance(walk, &failed)))
			return status;
		if (walk->stopped) {
			list->end = HAWSER_FOLDS_INTERRUPTED;
			return HAWSER_OK;
		}
		if (!failed && (status = hawser__walk_end(walk, &ended, &failed)))
			return status;
		if (failed) {
			say_where(walk);
			return HAWSER_OK;
		}
		if ((status = accept(walk, &again)))
			return status;
		if (again)
			continue;
		if (ended)
			return HAWSER_OK;
		hawser__fold_swap(&walk->prev, &walk->here);
		hawser__fold_swap(&walk->here, &walk->next);
		walk->known++;
		if ((status = orbit->ops->relax(orbit, walk->options->tolerance, walk->report)))
			return status;
	}
}

enum hawser_status hawser__walk_follow(struct hawser__fold_walk *walk,
                                       struct hawser__fold_list *list, int direction)
{
	struct hawser__fold *fold = walk->fold;
	int size = fold->size, failed;
	enum hawser_status status;

	walk->list = list;
	walk->known = 1;
	walk->ceiling = INFINITY;
	walk->ds = FIRST_STEP;
	hawser__station_copy(&walk->here, &walk->start, size);
	hawser__walk_metric(walk, walk->here.z);
	/* the harmonics and the samples are those of the start again */
	hawser__walk_orient(walk, &walk->here);
	along(walk->direction, size, size - 1);
	status = hawser__walk_correct(walk, &walk->here, walk->direction, &failed);
	if (status)
		return status;
	if (failed) {
		say_where(walk);
		return HAWSER_OK;
	}
	along(walk->direction, size, size - 1);
	walk->direction[size - 1] = direction;
	hawser__walk_finish(walk, &walk->here, walk->direction);
	if ((status = hawser__list_point(list, walk, &walk->here)))
		return status;
	return follow(walk);
}

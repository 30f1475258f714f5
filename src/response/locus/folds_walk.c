/* response/locus/folds_walk.c - continuation of a fold in (orbit, Omega, load): the operations of
 * continuation/curve.h.
 *
 * The metric is that of the orbit (method.h) with the relative change of the load. A step is
 * predicted on the polynomial through the last points and tangents and corrected by Newton's method,
 * with new derivatives in every iteration: they need only the factorisation of the iteration. A step
 * that ends on another curve is told as in locus_walk.c, by the sign of the determinant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/newton.h"
#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "response/time/flow.h"
#include "response/locus/folds_walk.h"

#define WORST_ANGLE 0.5    /* rad, largest angle between successive tangents; chosen */
#define WORST_DISTANCE 0.2 /* distance of the prediction from the curve, in steps; chosen */
#define FIRST_STEP 0.02   /* first step, short since only one tangent is known; chosen */
#define LARGEST_STEP 0.3 /* longest step, relative to the size of the orbit; chosen */
#define MOST_GROWTH 2.0 /* of a step over the last one, for a prediction from both; above the largest
                         * of hawser__folds_steps */
#define SIMPLE 1e-4 /* steps at which another orientation is that of a curve through a branch point of
                     * the equations, not of a neighbouring curve; chosen */
#define DOUBTED 1e-4 /* when a shorter step is rejected, the last point is corrected again; chosen */
#define SURE_STEP 1e-6 /* a shorter step is accepted in any case; chosen */
#define SORTING_STEP 1e-6 /* in a shorter step, events are not separated further; chosen */

static void init_station(struct hawser__fold_station *station, struct hawser__hold *hold, int size)
{
	station->memory = hawser__hold(hold, 4*(size_t)size, sizeof(double));
	if (!station->memory)
		return;
	station->z = station->memory;
	station->t = station->z + size;
	station->b = station->t + size;
	station->c = station->b + size;
}

enum hawser_status hawser__walk_open(struct hawser__fold_walk *walk, struct hawser__fold *fold,
                                     const struct hawser_folds_options *options,
                                     struct hawser_report *report)
{
	struct hawser__fold_station *all[] = {&walk->start, &walk->before, &walk->prev, &walk->here,
	                                      &walk->next, &walk->scratch, &walk->lo, &walk->hi};

	*walk = (struct hawser__fold_walk){.span = {.began = hawser__wall_seconds()}, .fold = fold,
		.options = options, .report = report,
		.omega_lo = fmin(options->from, options->to),
		.omega_hi = fmax(options->from, options->to)};
	walk->window_lo = walk->omega_lo;
	walk->window_hi = walk->omega_hi;
	for (size_t i = 0; i < sizeof all/sizeof *all; i++)
		init_station(all[i], &walk->hold, fold->size);
	walk->direction = hawser__hold(&walk->hold, (size_t)fold->size, sizeof(double));
	walk->plane = hawser__hold(&walk->hold, (size_t)fold->size, sizeof(double));
	walk->state = hawser__hold(&walk->hold, 2*(size_t)fold->load.rom.n, sizeof(double));
	walk->amplitude = hawser__amplitude_new(&fold->load.rom);
	if (walk->hold.short_of_memory || !walk->amplitude)
		return hawser__no_memory(report, "folds");
	return HAWSER_OK;
}

void hawser__walk_clear(struct hawser__fold_walk *walk)
{
	hawser__hold_clear(&walk->hold);
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

static enum hawser_status evaluate(void *owner, double *residual, double *z)
{
	struct hawser__fold_walk *walk = owner;

	return hawser__fold_evaluate(walk->fold, residual, z, walk->report);
}

static enum hawser_status check_defect(void *owner, double *residual, const double *z)
{
	*residual = hawser__fold_defect(((struct hawser__fold_walk *)owner)->fold, z, 0);
	return HAWSER_OK;
}

static int solve(void *owner, double *dz, const double *z, const double *row)
{
	(void)z;
	return hawser__fold_solve(((struct hawser__fold_walk *)owner)->fold, dz, row, 0, 0.0);
}

/* Frequency and load stay positive. */
static int moved(void *owner, const double *z, double length)
{
	int size = ((struct hawser__fold_walk *)owner)->fold->size;

	(void)length;
	return z[size - 2] <= 0.0 || z[size - 1] <= 0.0;
}

enum hawser_status hawser__walk_correct(struct hawser__fold_walk *walk,
                                        struct hawser__fold_station *station, const double *row,
                                        int *failed)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);
	const struct hawser__newton newton = {walk, &metric, walk->options->tolerance, evaluate,
	                                      check_defect, solve, moved};

	for (;;) {
		int again;
		enum hawser_status status = hawser__newton_correct(&newton, station->z, walk->fold->step, row,
		                                                   &station->correction, failed);

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
	const struct hawser__metric metric = hawser__fold_metric(fold);
	double *t = station->t, length;

	if (hawser__fold_solve(fold, t, side, 1, 1.0))
		memcpy(t, side, (size_t)fold->size*sizeof(double));
	length = hawser__metric_length(&metric, t);
	for (int i = 0; i < fold->size; i++)
		t[i] /= length;
	station->test[HAWSER_FOLD_CUSP] = fold->second;
	station->test[HAWSER_FOLD_STATIONARY] = fold->F_omega;
	station->orientation = fold->orientation;
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

/* row = the direction of the load or of Omega. */
static void along(double *row, int size, int place)
{
	memset(row, 0, (size_t)size*sizeof *row);
	row[place] = 1.0;
}

/* --- the operations of a step --- */

double hawser__walk_left(const struct hawser__fold_walk *walk)
{
	const struct hawser__orbit *orbit = &walk->fold->balance.base;

	return walk->options->most_work > 0.0
	       ? walk->options->most_work - walk->work - hawser_orbit_work(&orbit->cost, orbit->rom)
	       : INFINITY;
}

int hawser__walk_refused(struct hawser__fold_walk *walk)
{
	int refused = hawser__walk_left(walk) <= 0.0;

	walk->costly |= refused;
	return refused;
}

static enum hawser_status prepare(void *owner, int *ended)
{
	struct hawser__fold_walk *walk = owner;
	int costly = hawser__walk_refused(walk);

	*ended = costly || walk->list->points >= walk->options->max_points;
	if (*ended)
		walk->list->end = costly ? HAWSER_FOLDS_WORK : HAWSER_FOLDS_MAX_POINTS;
	hawser__walk_metric(walk, walk->here.z);
	return HAWSER_OK;
}

static int interrupted(void *owner, int tries)
{
	struct hawser__fold_walk *walk = owner;
	const struct hawser_progress *progress = &walk->options->progress;
	struct hawser_progress_state state;
	int size = walk->fold->size;

	(void)tries;
	if (!hawser__is_watched(progress))
		return walk->stopped;
	state = hawser__progress_state(walk->stage, "points", walk->list->points, walk->span.began);
	state.omega = walk->here.z[size - 2]/hawser__fold_orbit(walk->fold)->rom->time;
	state.load = walk->here.z[size - 1];
	hawser__span_foretell(&walk->span, &state);
	if (hawser__told_to_stop(progress, &state))
		walk->stopped = 1;
	return walk->stopped;
}

static int predict(void *owner, double ds)
{
	struct hawser__fold_walk *walk = owner;
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);
	const struct hawser__fold_station *at[3] = {&walk->before, &walk->prev, &walk->here};
	struct hawser__node node[3];
	int nodes = 1;

	/* where the curve leaves the range a step was cut */
	for (double least = ds/MOST_GROWTH; nodes < walk->known && nodes < 3 &&
	     at[3 - nodes]->arc - at[2 - nodes]->arc >= least; least /= MOST_GROWTH)
		nodes++;
	for (int k = 0; k < nodes; k++)
		node[k] = hawser__fold_node(at[3 - nodes + k]);
	hawser__curve_ahead(walk->next.z, node, nodes, ds, &metric);
	return walk->next.z[walk->fold->size - 1] <= 0.0;
}

static enum hawser_status correct(void *owner, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct hawser__fold_walk *walk = owner;
	enum hawser_status status;

	(void)ds;
	hawser__walk_orient(walk, &walk->here);
	status = hawser__walk_correct(walk, &walk->next, walk->here.t, failed);
	*correction = walk->next.correction;
	return status;
}

static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct hawser__fold_walk *walk = owner;
	struct hawser__metric metric;

	hawser__walk_finish(walk, &walk->next, walk->here.t);
	walk->next.arc = walk->here.arc + ds;
	metric = hawser__fold_metric(walk->fold);
	*angle = hawser__metric_angle(&metric, walk->here.t, walk->next.t);
	return HAWSER_OK;
}

/* The last point again, with the pairs of harmonic and coordinate that the next one takes: between two
 * curves that nearly meet these change the tangent, and no step is short enough then. */
static enum hawser_status settle(struct hawser__fold_walk *walk)
{
	struct hawser__fold_station *next = &walk->next, *here = &walk->here;
	size_t bytes = (size_t)walk->fold->size*sizeof(double);
	enum hawser_status status;
	int failed;

	walk->settled = walk->known;
	memcpy(next->z, here->z, bytes);
	hawser__walk_orient(walk, here);
	status = hawser__walk_correct(walk, next, here->t, &failed);
	if (status || failed)
		return status;
	hawser__walk_finish(walk, next, here->t);
	next->arc = here->arc;
	if ((next->test[HAWSER_FOLD_CUSP] < 0.0) == (here->test[HAWSER_FOLD_CUSP] < 0.0) &&
	    (next->test[HAWSER_FOLD_STATIONARY] < 0.0) == (here->test[HAWSER_FOLD_STATIONARY] < 0.0))
		hawser__fold_swap(here, next);
	return HAWSER_OK;
}

/* If a step has two kinds of events, it is shortened. */
static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	struct hawser__fold_walk *walk = owner;
	int changed = 0, elsewhere = walk->next.orientation != walk->here.orientation;

	for (int k = 0; k < HAWSER_FOLD_TESTS; k++)
		changed += (walk->here.test[k] < 0.0) != (walk->next.test[k] < 0.0);
	*verdict = (elsewhere && ds > SIMPLE) || angle > WORST_ANGLE ||
	           walk->next.correction.first > WORST_DISTANCE*ds ||
	           (changed > 1 && ds > SORTING_STEP) ? HAWSER__SHORTEN : HAWSER__KEEP;
	if (*verdict == HAWSER__SHORTEN && ds < DOUBTED && walk->settled != walk->known)
		return settle(walk);
	return HAWSER_OK;
}

static double longest(void *owner)
{
	const struct hawser__fold_walk *walk = owner;
	double range = walk->omega_hi - walk->omega_lo;
	double rate = fabs(walk->here.t[walk->fold->size - 2]);

	return fmin(LARGEST_STEP, walk->options->step_max*range/fmax(rate, 1e-300));
}

static void add_place(struct hawser__fold_walk *walk)
{
	int size = walk->fold->size;

	walk->list->end = HAWSER_FOLDS_FAILED;
	snprintf(walk->list->message, sizeof walk->list->message,
	         "the corrector failed near Omega %.9g%s, load factor %.9g (residual %.2g)",
	         HAWSER_SHOWN(walk->fold->load.full, walk->here.z[size - 2]),
	         walk->here.z[size - 1], walk->next.correction.residual);
}

/* Store next and the events before it. If an event cannot be located, next probably lies on another
 * curve nearby: the step is repeated with half the length, down to SURE_STEP. *cut: 1, and nothing is
 * stored, if next has become an event within the range, which the step would leave out. */
static enum hawser_status accept(struct hawser__fold_walk *walk, int *again, int *cut, double *ds)
{
	struct hawser__fold_list *list = walk->list;
	double taken = walk->next.arc - walk->here.arc;
	int points = list->points, events = list->events, missed;
	enum hawser_status status = hawser__list_point(list, walk, &walk->next);

	*again = *cut = 0;
	if (status || (status = hawser__fold_events(walk, &missed, cut)))
		return status;
	*again = !*cut && missed && taken >= SURE_STEP;
	if (!*cut && !*again)
		return HAWSER_OK;
	list->points = points;
	list->events = events;
	list->message[0] = '\0';
	*ds = *again ? 0.5*taken : *ds;
	return HAWSER_OK;
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct hawser__fold_walk *walk = owner;
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	int ended, failed, again, cut;

	(void)taken;
	*arrival = HAWSER__AT_END;
	do {
		enum hawser_status status = hawser__walk_end(walk, &ended, &failed);

		if (!status && failed)
			add_place(walk);
		if (status || failed || (status = accept(walk, &again, &cut, ds)))
			return status;
	} while (cut);
	*arrival = again ? HAWSER__AGAIN : ended ? HAWSER__AT_END : HAWSER__GO_ON;
	if (*arrival != HAWSER__GO_ON)
		return HAWSER_OK;
	hawser__fold_swap(&walk->before, &walk->prev);
	hawser__fold_swap(&walk->prev, &walk->here);
	hawser__fold_swap(&walk->here, &walk->next);
	walk->known++;
	return orbit->ops->relax(orbit, walk->options->tolerance, walk->report);
}

static const struct hawser__curve_ops fold_ops = {
	.prepare = prepare, .interrupted = interrupted, .predict = predict, .correct = correct,
	.finish = finish, .judge = judge, .longest = longest, .arrive = arrive
};

static enum hawser_status follow(struct hawser__fold_walk *walk)
{
	enum hawser__outcome outcome;
	enum hawser_status status;

	walk->curve = (struct hawser__curve){.ops = &fold_ops, .settings = &hawser__folds_steps,
		.owner = walk, .ds = FIRST_STEP};
	status = hawser__curve_follow(&walk->curve, &outcome);
	if (!status && outcome == HAWSER__INTERRUPTED)
		walk->list->end = HAWSER_FOLDS_INTERRUPTED;
	if (!status && outcome == HAWSER__LOST)
		add_place(walk);
	return status;
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
	hawser__station_copy(&walk->here, &walk->start, size);
	hawser__walk_metric(walk, walk->here.z);
	/* restore the numbers of harmonics and samples of the start */
	hawser__walk_orient(walk, &walk->here);
	along(walk->direction, size, size - 1);
	status = hawser__walk_correct(walk, &walk->here, walk->direction, &failed);
	if (status)
		return status;
	if (failed) {
		add_place(walk);
		return HAWSER_OK;
	}
	along(walk->direction, size, size - 1);
	walk->direction[size - 1] = direction;
	hawser__walk_finish(walk, &walk->here, walk->direction);
	if ((status = hawser__list_point(list, walk, &walk->here)))
		return status;
	return follow(walk);
}

/* --- orbits that are stored --- */

void hawser__store_add(struct hawser__fold_store *store, const double *y)
{
	size_t size = (size_t)store->size;

	if (hawser__more(&store->y, store->count, size*sizeof *store->y)) {
		store->failed = 1;
		return;
	}
	memcpy(store->y + (size_t)store->count++*size, y, size*sizeof *y);
}

const double *hawser__store_find(const struct hawser__fold_store *store, double omega)
{
	for (int i = 0; i < store->count; i++) {
		const double *y = store->y + (size_t)i*(size_t)store->size;

		if (y[store->size - 1] == omega)
			return y;
	}
	return NULL;
}

void hawser__store_clear(struct hawser__fold_store *store)
{
	free(store->y);
	*store = (struct hawser__fold_store){.size = store->size};
}

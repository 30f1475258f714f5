/* response/locus/locus_walk.c - continuation of a locus: the operations of continuation/curve.h.
 *
 * The metric is that of the orbit relative to its size and of the parameters relative to their ranges.
 * A step is predicted on the polynomial through the last points and tangents, and corrected by Newton's
 * method with the derivatives of each iteration. Where two curves nearly meet, a step may end on the
 * other one. The determinant of the system with the tangent as its last row then has the other sign,
 * and the step is repeated, shorter (Allgower and Georg, chapter 8).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/newton.h"
#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "response/locus/locus_walk.h"

#define MOST_ITERATIONS 4      /* of a step that is kept; chosen: two or three are usual */
#define WORST_ANGLE 0.5       /* rad, between successive tangents; chosen */
#define WORST_DISTANCE 0.2    /* of the prediction from the curve, in steps; chosen */
#define FIRST_STEP 0.005      /* chosen */
#define SIMPLE 1e-4           /* steps at which another orientation is that of a curve through a branch
                               * point of the equations, not of a neighbouring curve; chosen */
#define LARGEST_STEP 0.2      /* chosen */
#define MORE 1.2              /* factor of the number of harmonics where there are too few */

static int init_station(struct hawser__locus_station *station, int room, int n)
{
	station->z = calloc(2*(size_t)room + 3*(size_t)n, sizeof(double));
	station->b = calloc(2*(size_t)room, sizeof(double complex));
	if (!station->z || !station->b)
		return 1;
	station->t = station->z + room;
	station->coordinate = station->t + room;
	station->state = station->coordinate + n;
	station->c = station->b + room;
	return 0;
}

enum hawser_status hawser__locus_walk_open(struct hawser__locus_walk *walk, struct hawser__locus *locus,
                                           const struct hawser_locus_options *options,
                                           struct hawser_report *report)
{
	struct hawser__locus_station *all[] = {&walk->start, &walk->before, &walk->prev, &walk->here,
	                                       &walk->next, &walk->scratch};
	int failed = 0, room = hawser__locus_size(locus, locus->most) + locus->n;

	*walk = (struct hawser__locus_walk){.locus = locus, .options = options, .report = report,
		.room = room, .span = walk->span};
	for (size_t i = 0; i < sizeof all/sizeof *all; i++)
		failed |= init_station(all[i], room, locus->n);
	walk->weight = calloc(4*(size_t)room, sizeof(double));
	walk->kept = calloc(2*(size_t)room, sizeof(double complex));
	if (failed || !walk->weight || !walk->kept)
		return hawser__no_memory(report, "locus");
	walk->row = walk->weight + room;
	walk->dz = walk->row + room;
	walk->spare = walk->dz + room;
	return HAWSER_OK;
}

void hawser__locus_walk_close(struct hawser__locus_walk *walk)
{
	struct hawser__locus_station *all[] = {&walk->start, &walk->before, &walk->prev, &walk->here,
	                                       &walk->next, &walk->scratch};

	for (size_t i = 0; i < sizeof all/sizeof *all; i++) {
		free(all[i]->z);
		free(all[i]->b);
	}
	free(walk->weight);
	free(walk->kept);
}

void hawser__locus_station_copy(const struct hawser__locus_walk *walk,
                                struct hawser__locus_station *to,
                                const struct hawser__locus_station *from)
{
	struct hawser__locus_station own = *to;

	*to = *from;
	to->z = own.z;
	to->t = own.t;
	to->b = own.b;
	to->c = own.c;
	to->coordinate = own.coordinate;
	to->state = own.state;
	memcpy(to->z, from->z, (2*(size_t)walk->room + 3*(size_t)walk->locus->n)*sizeof(double));
	memcpy(to->b, from->b, 2*(size_t)walk->room*sizeof(double complex));
}

static struct hawser__metric metric_at(struct hawser__locus_walk *walk, const double *z)
{
	hawser__locus_weights(walk->weight, walk->locus, z);
	return (struct hawser__metric){walk->locus->size, walk->weight};
}

/* Change the number of harmonics, and keep the borders. */
static enum hawser_status locus_grow(struct hawser__locus_walk *walk, int order)
{
	struct hawser__locus *locus = walk->locus;
	int n = locus->n, blocks = locus->blocks, shift;
	double complex *b = walk->kept, *c = walk->kept + walk->room;
	enum hawser_status status;

	memcpy(b, locus->b, (size_t)locus->wide*sizeof *b);
	memcpy(c, locus->c, (size_t)locus->wide*sizeof *c);
	shift = order - locus->order;
	if ((status = hawser__locus_arrange(locus, order)))
		return status;
	memcpy(locus->b + (size_t)shift*n, b, (size_t)blocks*n*sizeof *b);
	memcpy(locus->c + (size_t)shift*n, c, (size_t)blocks*n*sizeof *c);
	return HAWSER_OK;
}

static enum hawser_status evaluate(void *owner, double *residual, double *z)
{
	return hawser__locus_evaluate(((struct hawser__locus_walk *)owner)->locus, residual, z);
}

static int solve(void *owner, double *dz, const double *z, const double *row)
{
	return hawser__locus_solve(((struct hawser__locus_walk *)owner)->locus, dz, z, row, 0, 0.0);
}

static int moved(void *owner, const double *z, double length)
{
	(void)z;
	((struct hawser__locus_walk *)owner)->locus->closeness = length;
	return 0;
}

enum hawser_status hawser__locus_correct(struct hawser__locus_walk *walk,
                                         struct hawser__locus_station *station, const double *row,
                                         int *failed)
{
	struct hawser__locus *locus = walk->locus;

	if (locus->kind != HAWSER_TORUS)
		station->z[LOCUS_KAPPA] = locus->kappa;
	for (;;) {
		int order = (int)ceil(MORE*locus->order) + 1;
		struct hawser__metric metric = metric_at(walk, station->z);
		const struct hawser__newton newton = {walk, &metric, walk->options->tolerance, evaluate,
		                                      NULL, solve, moved};
		enum hawser_status status = hawser__newton_correct(&newton, station->z, walk->dz, row,
		                                                   &station->correction, failed);

		station->order = locus->order;
		if (status || *failed || locus->mesh <= walk->options->tolerance)
			return status;
		order = order > locus->most ? locus->most : order;
		*failed = 1;
		if (order <= locus->order)
			return HAWSER_OK;
		if ((status = locus_grow(walk, order)))
			return status;
	}
}

enum hawser_status hawser__locus_finish(struct hawser__locus_walk *walk,
                                        struct hawser__locus_station *station, const double *side)
{
	struct hawser__locus *locus = walk->locus;
	struct hawser__metric metric = metric_at(walk, station->z);
	double *t = station->t, length;
	double complex *b = walk->kept, *c = walk->kept + walk->room;
	size_t bytes = (size_t)locus->wide*sizeof *b;

	for (int k = 0; k < locus->size; k++)
		walk->row[k] = walk->weight[k]*side[k];
	hawser__locus_tangent(locus, t, station->z, walk->row, side);
	length = hawser__metric_length(&metric, t);
	for (int k = 0; k < locus->size; k++)
		t[k] /= length;
	station->order = locus->order;
	station->orientation = locus->orientation;
	memcpy(b, locus->b, bytes);
	memcpy(c, locus->c, bytes);
	hawser__locus_update(locus);
	memset(station->b, 0, 2*(size_t)walk->room*sizeof *station->b);
	memcpy(station->b, locus->b, bytes);
	memcpy(station->c, locus->c, bytes);
	memcpy(locus->b, b, bytes);
	memcpy(locus->c, c, bytes);
	hawser__locus_describe(walk, station);
	return hawser__locus_test(walk, station);
}

/* --- the operations of a step --- */

int hawser__locus_refused(struct hawser__locus_walk *walk)
{
	const struct hawser_orbit_cost cost = {.dense = walk->locus->dense};
	double most = walk->options->most_work;
	int refused = most > 0.0 &&
	              walk->locus->spent + hawser_orbit_work(&cost, walk->locus->rom) >= most;

	walk->costly |= refused;
	return refused;
}

static enum hawser_status prepare(void *owner, int *ended)
{
	struct hawser__locus_walk *walk = owner;
	int costly = hawser__locus_refused(walk);

	*ended = costly || walk->list->points >= walk->options->max_points;
	if (*ended)
		walk->list->end = costly ? HAWSER_LOCUS_WORK : HAWSER_LOCUS_MAX_POINTS;
	return HAWSER_OK;
}

static int interrupted(void *owner, int tries)
{
	struct hawser__locus_walk *walk = owner;
	const struct hawser_progress *progress = &walk->options->progress;
	struct hawser_progress_state state;

	(void)tries;
	if (!hawser__is_watched(progress))
		return walk->stopped;
	state = hawser__progress_state("locus", "points", walk->list->points, walk->span.began);
	hawser__span_foretell(&walk->span, &state);
	state.omega = walk->here.z[LOCUS_OMEGA]/walk->locus->time;
	if (hawser__told_to_stop(progress, &state))
		walk->stopped = 1;
	return walk->stopped;
}

static int predict(void *owner, double ds)
{
	struct hawser__locus_walk *walk = owner;
	struct hawser__metric metric = metric_at(walk, walk->here.z);
	const struct hawser__node node[3] = {{walk->before.z, walk->before.t},
	                                     {walk->prev.z, walk->prev.t}, {walk->here.z, walk->here.t}};
	int known = walk->known < 3 ? walk->known : 3;

	hawser__curve_ahead(walk->next.z, node + 3 - known, known, ds, &metric);
	return !walk->locus->plane && !(walk->next.z[LOCUS_OMEGA] > 0.0);
}

static enum hawser_status correct(void *owner, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct hawser__locus_walk *walk = owner;
	struct hawser__metric metric = metric_at(walk, walk->here.z);
	enum hawser_status status;

	(void)ds;
	for (int k = 0; k < metric.size; k++)
		walk->spare[k] = walk->weight[k]*walk->here.t[k];
	memset(walk->spare + metric.size, 0, (size_t)(walk->room - metric.size)*sizeof(double));
	status = hawser__locus_correct(walk, &walk->next, walk->spare, failed);
	*correction = walk->next.correction;
	return status;
}

static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct hawser__locus_walk *walk = owner;
	struct hawser__metric metric;
	enum hawser_status status;

	walk->next.arc = walk->here.arc + ds;
	status = hawser__locus_finish(walk, &walk->next, walk->here.t);
	metric = metric_at(walk, walk->next.z);
	*angle = hawser__metric_angle(&metric, walk->here.t, walk->next.t);
	if (!status && walk->locus->kind != HAWSER_RESONANCE)
		*angle = fmax(*angle, fmax(hawser__locus_turn(walk, walk->here.c, walk->next.c),
		                           hawser__locus_turn(walk, walk->here.b, walk->next.b)));
	return status;
}

static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	const struct hawser__locus_walk *walk = owner;

	const struct hawser__correction *did = &walk->next.correction;
	int elsewhere = walk->next.orientation != walk->here.orientation && ds > SIMPLE;

	*verdict = elsewhere || angle > WORST_ANGLE || did->first > WORST_DISTANCE*ds ||
	           did->iterations > MOST_ITERATIONS ? HAWSER__SHORTEN : HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *owner)
{
	const struct hawser__locus_walk *walk = owner;
	const double *t = walk->here.t, *extent = walk->locus->extent;
	double rate = fmax(fabs(t[LOCUS_OMEGA])/extent[0], fabs(t[LOCUS_PARAMETER])/extent[1]);

	return fmin(LARGEST_STEP, walk->options->step_max/fmax(rate, 1e-300));
}

static enum hawser_status record(struct hawser__locus_walk *walk,
                                 const struct hawser__locus_station *station)
{
	struct hawser__locus_list *list = walk->list;
	size_t n = (size_t)walk->locus->n;

	if (hawser__more(&list->point, list->points, sizeof *list->point) ||
	    hawser__more(&list->coordinate, list->points, n*sizeof *list->coordinate) ||
	    hawser__more(&list->state, list->points, 2*n*sizeof *list->state))
		return hawser__no_memory(walk->report, "locus");
	list->point[list->points] = station->point;
	memcpy(list->coordinate + (size_t)list->points*n, station->coordinate, n*sizeof(double));
	memcpy(list->state + (size_t)list->points*2*n, station->state, 2*n*sizeof(double));
	list->points++;
	return HAWSER_OK;
}

static void add_place(struct hawser__locus_walk *walk)
{
	walk->list->end = HAWSER_LOCUS_FAILED;
	snprintf(walk->list->message, sizeof walk->list->message,
	         "the corrector failed near Omega %.9g%s, parameter %.9g (residual %.2g, %d harmonics)",
	         walk->here.z[LOCUS_OMEGA]/walk->locus->time, walk->locus->rom->scaled ? " rad/s" : "",
	         walk->here.z[LOCUS_PARAMETER], walk->next.correction.residual, walk->locus->order);
}

/* If the step passes an end of a range, next becomes the point there. */
static enum hawser_status to_bound(struct hawser__locus_walk *walk, int *ended)
{
	const struct hawser_locus_options *o = walk->options;
	double low[2] = {fmin(o->from, o->to), fmin(o->parameter_from, o->parameter_to)};
	double high[2] = {fmax(o->from, o->to), fmax(o->parameter_from, o->parameter_to)};
	struct hawser__node a = {walk->here.z, walk->here.t}, b = {walk->next.z, walk->next.t};

	for (int k = 0; k < 2 && !*ended; k++) {
		double bound = walk->next.z[k] < low[k] ? low[k] : high[k], part;
		struct hawser__metric metric = metric_at(walk, walk->here.z);
		int failed;
		enum hawser_status status;

		if (walk->next.z[k] >= low[k] && walk->next.z[k] <= high[k])
			continue;
		*ended = 1;
		walk->list->end = k ? HAWSER_LOCUS_PARAMETER : HAWSER_LOCUS_OMEGA;
		hawser__locus_station_copy(walk, &walk->scratch, &walk->next);
		memset(walk->scratch.z, 0, (size_t)walk->room*sizeof(double));
		part = hawser__curve_meets(walk->scratch.z, walk->dz, &a, &b, k, bound, &metric);
		memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
		walk->spare[k] = 1.0;
		status = hawser__locus_correct(walk, &walk->scratch, walk->spare, &failed);
		if (status || failed)
			return status; /* the point beyond is kept */
		walk->scratch.z[k] = bound;
		walk->scratch.arc = walk->here.arc + part*(walk->next.arc - walk->here.arc);
		walk->locus->closeness = INFINITY; /* M has the row of the bound, not of the tangent */
		if ((status = hawser__locus_finish(walk, &walk->scratch, walk->here.t)))
			return status;
		hawser__locus_station_copy(walk, &walk->next, &walk->scratch);
		k = -1; /* the other range */
		if (walk->next.z[0] >= low[0] && walk->next.z[0] <= high[0] &&
		    walk->next.z[1] >= low[1] && walk->next.z[1] <= high[1])
			break;
		*ended = 0;
	}
	return HAWSER_OK;
}

static int closed(struct hawser__locus_walk *walk, double taken)
{
	struct hawser__metric metric = metric_at(walk, walk->here.z);
	struct hawser__node a = {walk->here.z, walk->here.t}, b = {walk->next.z, walk->next.t};
	double share;

	return walk->list->points > 4 &&
	       hawser__curve_passes(&share, walk->start.z, &a, &b, taken, 0.02, walk->dz, walk->spare,
	                            &metric);
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct hawser__locus_walk *walk = owner;
	struct hawser__locus *locus = walk->locus;
	struct hawser__locus_station keep;
	double end = walk->next.z[LOCUS_KAPPA] <= 0.0 ? 0.0 : 0.5;
	int ended = 0, passes = 0;
	enum hawser_status status;

	(void)ds;
	*arrival = HAWSER__AT_END;
	if (hawser__locus_is_beyond(walk)) {
		if ((status = hawser__locus_pass(walk, end, &passes)))
			return status;
		if (!passes) {
			walk->list->end = HAWSER_LOCUS_RESONANCE;
			return hawser__locus_resonance(walk, end);
		}
	}
	if ((status = to_bound(walk, &ended)))
		return status;
	if (!ended && closed(walk, taken)) {
		ended = 1;
		walk->list->end = HAWSER_LOCUS_CLOSED;
	}
	if (!walk->options->skip_events && (status = hawser__locus_find_events(walk)))
		return status;
	if (passes && hawser__locus_is_beyond(walk))
		hawser__locus_mirror(walk, end);
	if ((status = record(walk, &walk->next)) || ended)
		return status;
	*arrival = HAWSER__GO_ON;
	memcpy(locus->b, walk->next.b, (size_t)locus->wide*sizeof *locus->b);
	memcpy(locus->c, walk->next.c, (size_t)locus->wide*sizeof *locus->c);
	keep = walk->before;
	walk->before = walk->prev;
	walk->prev = walk->here;
	walk->here = walk->next;
	walk->next = keep;
	memset(walk->next.z, 0, 2*(size_t)walk->room*sizeof(double));
	walk->known++;
	return HAWSER_OK;
}

static const struct hawser__curve_ops locus_ops = {
	.prepare = prepare, .interrupted = interrupted, .predict = predict, .correct = correct,
	.finish = finish, .judge = judge, .longest = longest, .arrive = arrive
};

enum hawser_status hawser__locus_follow(struct hawser__locus_walk *walk,
                                        struct hawser__locus_list *list, int direction)
{
	struct hawser__locus *locus = walk->locus;
	enum hawser__outcome outcome;
	double residual;
	enum hawser_status status;

	walk->list = list;
	walk->known = 1;
	hawser__locus_station_copy(walk, &walk->here, &walk->start);
	if (locus->order != walk->start.order &&
	    (status = hawser__locus_arrange(locus, walk->start.order)))
		return status;
	memcpy(locus->b, walk->start.b, (size_t)locus->wide*sizeof *locus->b);
	memcpy(locus->c, walk->start.c, (size_t)locus->wide*sizeof *locus->c);
	memset(walk->next.z, 0, 2*(size_t)walk->room*sizeof(double));
	if ((status = hawser__locus_evaluate(locus, &residual, walk->here.z)))
		return status;
	hawser__locus_update(locus);
	if ((status = hawser__locus_evaluate(locus, &residual, walk->here.z)))
		return status;
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	memcpy(walk->spare, walk->start.t, (size_t)locus->size*sizeof(double));
	for (int k = 0; direction < 0 && k < locus->size; k++)
		walk->spare[k] = -walk->spare[k];
	memcpy(walk->dz, walk->spare, (size_t)locus->size*sizeof(double));
	if ((status = hawser__locus_finish(walk, &walk->here, walk->spare)) ||
	    (status = record(walk, &walk->here)))
		return status;
	walk->curve = (struct hawser__curve){.ops = &locus_ops, .settings = &hawser__folds_steps,
		.owner = walk, .ds = FIRST_STEP};
	status = hawser__curve_follow(&walk->curve, &outcome);
	if (!status && outcome == HAWSER__INTERRUPTED)
		list->end = HAWSER_LOCUS_INTERRUPTED;
	if (!status && outcome == HAWSER__LOST)
		add_place(walk);
	return status;
}

/* response/backbone/backbone.c - see hawser/backbone.h: the operations of continuation/curve.h, with a
 * predictor along the tangent.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/backbone.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "core/settle.h"
#include "response/branch/amplitude.h"
#include "response/backbone/backbone.h"
#include "response/backbone/modulation.h"
#include "response/floquet/half.h"
#include "rom/terms/terms.h"

static const char where[] = "backbone";

#define FIRST_STEP 0.1    /* first step relative to the longest; chosen */
#define PLANE 0.02        /* share of the smaller coordinate in quadrature, at least; chosen */
#define LAST_STEP 50.0    /* orbit->reach with an extrapolated Jacobian, in tolerances, such that the
                           * corrector ends after a step below the tolerance: OFF_BRANCH of newton.c */
#define WORST_ANGLE 0.45  /* largest angle between successive tangents, rad; chosen */

void hawser_backbone_settle(struct hawser_backbone_options *options)
{
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle(&options->step_max, 0.1);
	hawser__settle_count(&options->max_points, 2000);
	hawser__settle_count(&options->periods, 1);
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_backbone_options *options,
                                struct hawser_report *report)
{
	enum hawser_status status = hawser__modal(rom, where, report);

	if (status)
		return status;
	if (options->mode < 0 || options->mode >= rom->n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "mode %d: the model has 1 to %d",
		                    options->mode + 1, rom->n);
	if (options->quadrature < 0 || options->quadrature > rom->n ||
	    options->quadrature == options->mode + 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "mode %d in quadrature with mode %d: the model has 1 to %d, and two are "
		                    "needed", options->quadrature, options->mode + 1, rom->n);
	if (!(rom->K[(size_t)options->mode*((size_t)rom->n + 1)] > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "mode %d has no positive stiffness: nothing oscillates in it",
		                    options->mode + 1);
	if (!(options->size > 0.0 && isfinite(options->size)) || options->max_points < 2 ||
	    !(options->tolerance >= 1e-13 && options->tolerance <= 1e-2) || !(options->step_max > 0.0) ||
	    !(options->lo >= 0.0) || (options->hi != 0.0 && !(options->hi > options->lo)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "size %g (positive), tolerance %g (1e-13 to 1e-2), largest step %g "
		                    "(positive), %d points at most (2 or more), range %g to %g: one is out "
		                    "of range", options->size, options->tolerance, options->step_max,
		                    options->max_points, options->lo, options->hi);
	return HAWSER_OK;
}

/* --- results --- */

static enum hawser_status grow(struct hawser_backbone *backbone, struct hawser_report *report)
{
	size_t capacity = backbone->capacity ? 2*(size_t)backbone->capacity : 64;
	size_t n = (size_t)backbone->n, probes = (size_t)backbone->probes;

	if (hawser__resize(&backbone->point, capacity, sizeof *backbone->point) ||
	    hawser__resize(&backbone->coordinate, capacity*n, sizeof(double)) ||
	    hawser__resize(&backbone->probe, capacity*probes*3, sizeof(double)) ||
	    hawser__resize(&backbone->start, capacity*n, sizeof(double)))
		return hawser__no_memory(report, where);
	backbone->capacity = (int)capacity;
	return HAWSER_OK;
}

static enum hawser_status record(struct hawser__free_walk *walk,
                                 const struct hawser__correction *correction,
                                 struct hawser_report *report)
{
	struct hawser_backbone *backbone = walk->backbone;
	struct hawser__half *half = &walk->half;
	int n = backbone->n, p = backbone->points;
	enum hawser_status status = p == backbone->capacity ? grow(backbone, report) : HAWSER_OK;
	struct hawser_backbone_point *point;
	double begin, end;

	if (status)
		return status;
	point = &backbone->point[p];
	end = hawser_rom_energy(&half->model, half->x, half->x + n);
	hawser__half_state(half, half->x, walk->y);
	begin = hawser_rom_energy(&half->model, half->x, half->x + n);
	*point = (struct hawser_backbone_point){.omega = walk->y[n], .energy = begin,
		.residual = correction->residual, .mesh = half->base.mesh/half->base.X,
		.energy_gap = fabs(end - begin)/fmax(fabs(begin), 1e-300)};
	memcpy(backbone->start + (size_t)p*n, walk->y, (size_t)n*sizeof(double));
	if (hawser__amplitude_find(walk->amplitude, backbone->coordinate + (size_t)p*n,
	                           backbone->probe + (size_t)p*3*backbone->probes, half->base.samples,
	                           half->base.rows, 0.0))
		return hawser__no_memory(report, where);
	status = hawser__half_unstable(half, &point->unstable, walk->t, correction->residual, report);
	backbone->points += !status;
	return status;
}

/* --- the curve --- */

/* Correct y in the plane of `row`, with the number of steps that the tolerance requires. Returns 1
 * if it fails. */
enum hawser_status hawser__free_correct(struct hawser__free_walk *walk, double *y, const double *row,
                                        struct hawser__correction *correction, int *failed,
                                        struct hawser_report *report)
{
	struct hawser__orbit *orbit = &walk->half.base;
	enum hawser_status status = HAWSER_OK;

	orbit->reach = walk->half.guessing ? LAST_STEP*walk->options->tolerance : 0.0;
	for (;;) {
		*failed = hawser__orbit_correct(orbit, y, correction, row, walk->options->tolerance);
		if (*failed || orbit->mesh <= walk->options->tolerance*orbit->X)
			return HAWSER_OK;
		if ((status = hawser__half_refine(&walk->half, report)))
			return status;
	}
}

/* The first point: of a motion in quadrature the ratio of the two coordinates is not known. */
static enum hawser_status begin(struct hawser__free_walk *walk, struct hawser_report *report)
{
	static const double turn[] = {0.785, 0.5, 1.07, 0.25, 1.32}; /* of the first motion, rad */
	struct hawser__orbit *orbit = &walk->half.base;
	struct hawser__correction correction;
	int n = orbit->n, j = walk->options->mode, other = walk->options->quadrature - 1, failed = 1;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && failed && i < (other >= 0 ? 5 : 1); i++) {
		memcpy(walk->y, walk->at, ((size_t)n + 1)*sizeof(double));
		if (other >= 0) {
			walk->y[j] = walk->first*cos(turn[i]);
			walk->y[other] = walk->first*sin(turn[i]);
		}
		orbit->ops->metric(orbit, walk->y);
		memcpy(walk->row, walk->y, (size_t)n*sizeof(double));
		walk->row[n] = 0.0;
		if (walk->options->start)
			memcpy(walk->row, walk->options->direction, ((size_t)n + 1)*sizeof(double));
		status = hawser__free_correct(walk, walk->y, walk->row, &correction, &failed, report);
		if (other >= 0 && fmin(fabs(walk->y[j]), fabs(walk->y[other])) < PLANE*walk->first)
			failed = 1;
	}
	if (!status && failed)
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, correction.iterations,
		                         correction.residual,
		                         "no free motion of amplitude %.3g was found near mode %d%s: another "
		                         "mode is in resonance with it, or that is no small motion",
		                         walk->first, j + 1, other >= 0 ? " in quadrature" : "");
	if (status)
		return status;
	hawser__orbit_tangent(orbit, walk->t);
	hawser__free_events(walk, walk->event);
	return record(walk, &correction, report);
}

/* The fraction of the curve that is done, from its amplitude, or the root of its energy, relative to
 * the last one. At first steps multiply it, later they add to it: the mean of both. */
static double part_of(const struct hawser__free_walk *walk)
{
	const struct hawser_backbone *backbone = walk->backbone;
	const struct hawser_backbone_point *first = backbone->point, *last = first + backbone->points - 1;
	double start, size;

	if (walk->options->energy > 0.0) {
		start = sqrt(first->energy/walk->options->energy);
		size = sqrt(last->energy/walk->options->energy);
	} else {
		start = backbone->coordinate[walk->options->mode]/walk->options->size;
		size = backbone->coordinate[(size_t)(backbone->points - 1)*backbone->n + walk->options->mode]/
		       walk->options->size;
	}
	return start > 0.0 && start < 1.0 && size > start
	       ? fmin(0.5*(1.0 - log(size)/log(start) + size), 1.0) : NAN;
}

static int told_to_stop(const struct hawser__free_walk *walk)
{
	const struct hawser_backbone *backbone = walk->backbone;
	struct hawser_progress_state state;

	if (!hawser__is_watched(&walk->options->progress))
		return 0;
	state = hawser__progress_state("backbone", "points", backbone->points, walk->began);
	state.omega = backbone->point[backbone->points - 1].omega/walk->rom->time;
	state.fraction = part_of(walk);
	return hawser__told_to_stop(&walk->options->progress, &state);
}

/* Whether the curve has ended, and how. */
static int ended(const struct hawser__free_walk *walk)
{
	struct hawser_backbone *backbone = walk->backbone;
	int last = backbone->points - 1, j = walk->options->mode;
	double omega = backbone->point[last].omega;
	double size = backbone->coordinate[(size_t)last*backbone->n + j];

	if (walk->met)
		backbone->end = HAWSER_BACKBONE_MEETS;
	else if (walk->options->energy > 0.0 && backbone->point[last].energy >= walk->options->energy)
		backbone->end = HAWSER_BACKBONE_ENERGY;
	else if (!(walk->options->energy > 0.0) && size >= walk->options->size)
		backbone->end = HAWSER_BACKBONE_SIZE;
	else if (omega < walk->lo || omega > walk->hi)
		backbone->end = HAWSER_BACKBONE_RANGE;
	else if (walk->half.base.X < 0.5*walk->first)
		backbone->end = HAWSER_BACKBONE_REST;
	else if (backbone->points >= walk->options->max_points)
		backbone->end = HAWSER_BACKBONE_MAX_POINTS;
	else if (told_to_stop(walk))
		backbone->end = HAWSER_BACKBONE_STOPPED;
	else
		return 0;
	return 1;
}

/* --- the operations of a step --- */

static enum hawser_status prepare(void *owner, int *finished)
{
	struct hawser__free_walk *walk = owner;

	*finished = ended(walk);
	walk->half.base.ops->metric(&walk->half.base, walk->y);
	return HAWSER_OK;
}

static int predict(void *owner, double ds)
{
	struct hawser__free_walk *walk = owner;

	for (int i = 0; i < walk->half.base.size; i++)
		walk->next[i] = walk->y[i] + ds*walk->t[i];
	return 0;
}

static enum hawser_status correct_next(void *owner, double ds, struct hawser__correction *correction,
                                       int *failed)
{
	struct hawser__free_walk *walk = owner;
	enum hawser_status status;

	(void)ds;
	walk->half.guessing = 1;
	status = hawser__free_correct(walk, walk->next, walk->t, correction, failed, walk->report);
	walk->half.guessing = 0;
	return status;
}

static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct hawser__free_walk *walk = owner;
	const struct hawser__metric metric = hawser__orbit_metric(&walk->half.base);

	(void)ds;
	hawser__orbit_tangent(&walk->half.base, walk->next_t);
	hawser__free_events(walk, walk->next_event);
	*angle = hawser__metric_angle(&metric, walk->t, walk->next_t);
	return HAWSER_OK;
}

static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	(void)owner;
	(void)ds;
	*verdict = angle > WORST_ANGLE ? HAWSER__SHORTEN : HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *owner)
{
	return ((const struct hawser__free_walk *)owner)->options->step_max;
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct hawser__free_walk *walk = owner;
	size_t bytes = (size_t)walk->half.base.size*sizeof(double);

	(void)taken;
	(void)ds;
	*arrival = HAWSER__GO_ON;
	if (walk->options->branches) {
		int failed, moved;
		enum hawser_status status = hawser__free_branches(walk, &moved);

		if (!status && moved) /* the integration along `next` again, which record needs */
			status = hawser__free_correct(walk, walk->next, walk->t, &walk->curve.correction, &failed,
			                              walk->report);
		if (status)
			return status;
	}
	memcpy(walk->y, walk->next, bytes);
	memcpy(walk->t, walk->next_t, bytes);
	return record(walk, &walk->curve.correction, walk->report);
}

static const struct hawser__curve_ops backbone_ops = {
	.prepare = prepare, .predict = predict, .correct = correct_next, .finish = finish,
	.judge = judge, .longest = longest, .arrive = arrive
};

static enum hawser_status follow(struct hawser__free_walk *walk)
{
	enum hawser__outcome outcome;
	enum hawser_status status = hawser__curve_follow(&walk->curve, &outcome);

	return status || outcome != HAWSER__LOST ? status :
	       hawser__fail(walk->report, HAWSER_ERR_CONVERGENCE, where,
	                    "the curve is lost at Omega %.9g%s: no step is small enough",
	                    HAWSER_SHOWN(walk->rom, walk->y[walk->half.base.size - 1]));
}

static enum hawser_status open_walk(struct hawser__free_walk *walk, struct hawser_report *report)
{
	size_t size = (size_t)walk->rom->n + 1;
	enum hawser_status status = hawser__half_init(&walk->half, walk->rom, report);

	if (status)
		return status;
	walk->amplitude = hawser__amplitude_new(walk->rom);
	walk->y = calloc(8*size, sizeof(double));
	if (!walk->amplitude || !walk->y)
		return hawser__no_memory(report, where);
	walk->t = walk->y + size;
	walk->next = walk->t + size;
	walk->next_t = walk->next + size;
	walk->row = walk->next_t + size;
	walk->at = walk->row + size;
	walk->at_t = walk->at + size;
	walk->other = walk->at_t + size;
	walk->half.periods = walk->options->periods;
	return hawser__free_signs(walk, report);
}

enum hawser_status hawser_backbone_trace(struct hawser_backbone *backbone, const struct hawser_rom *rom,
                                         const struct hawser_backbone_options *options,
                                         struct hawser_report *report)
{
	struct hawser_backbone_options settled = *options;
	struct hawser__free_walk walk = {.began = hawser__wall_seconds(), .rom = rom, .options = &settled,
		.backbone = backbone,
		.curve = {.ops = &backbone_ops, .settings = &hawser__backbone_steps},
		.lo = options->lo, .hi = options->hi, .report = report};
	enum hawser_status status;

	hawser_backbone_settle(&settled);
	options = &settled;
	status = hawser__more_refuse(rom, "a backbone", report);
	if (!status && rom->first)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "backbone",
		                      "a model of first_order has no free undamped motions");
	if (status) {
		*backbone = (struct hawser_backbone){.points = 0};
		return status;
	}
	walk.curve.owner = &walk;
	walk.curve.ds = FIRST_STEP*settled.step_max;
	*backbone = (struct hawser_backbone){.n = rom->n, .probes = rom->shapes.points,
		.end = HAWSER_BACKBONE_STOPPED, .sign = calloc((size_t)rom->n, sizeof(int))};
	if (!backbone->sign)
		return hawser__no_memory(report, where);
	if ((status = check(rom, options, report)))
		return status;
	if (walk.hi == 0.0) {
		double w = sqrt(rom->K[(size_t)options->mode*((size_t)rom->n + 1)]);

		walk.lo = 0.5*w;
		walk.hi = 1.5*w;
	}
	status = open_walk(&walk, report);
	if (!status)
		status = begin(&walk, report);
	if (!status)
		status = follow(&walk);
	hawser__half_release(&walk.half);
	hawser__signs_free(&walk.signs);
	free(walk.member);
	free(walk.event);
	hawser__amplitude_free(walk.amplitude);
	free(walk.y);
	return status;
}

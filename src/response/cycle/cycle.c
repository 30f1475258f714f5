/* response/cycle/cycle.c - limit cycles of autonomous models over a parameter, as a method of
 * method.h.
 *
 *    inner   a method for orbits at a given Omega: its y is the first part of a cycle's: X, Omega
 *    y       unknowns: X, Omega, the parameter p
 *    phase   row: the cycle is not shifted along the motion from the last one, <X_old', X - X_old> = 0
 *            in the metric: the integral condition of Doedel, which needs no coordinate that moves.
 *            With <X', dX> = 0 what a prediction shifts would stay, and grow in the next ones
 *    A       the inner bordered matrix, with the row `phase`, and for the column of Omega one of
 *            the direction a in the plane of (Omega, p)
 *    b       direction in that plane at right angles to a; g the column of it
 *
 *          [ A    g ] [ (dX, da) ]     [ -r   ]
 *          [ c'   . ] [    db    ]  =  [ last ]
 *
 * by block elimination, with two solutions with A. The curve's tangent, of which the border c is
 * made, has no part along a. A is therefore regular at a fold of cycles, where Omega or p alone
 * would leave it singular.
 *
 * Reference: Doedel, Keller and Kernevez, Int. J. Bifurcation and Chaos 1 (1991) 745.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"

#define ELIMINATED 1e-11 /* relative residual of the block elimination, whose errors are a step's */

struct cycle {
	struct hawser__orbit base;
	struct hawser__orbit *inner;
	int count;                    /* equations and unknowns of X */
	double *defect, *column;      /* inner, not owned */
	int parts;                    /* how many of them there are */
	double *given;                /* [size] y of the last defects */
	double *by_omega, *by_p;      /* [count] */
	double *kept, *phase, *part, *answer; /* [size] */
	double *old;                  /* [size] y of the last metric, a point of the curve */
	int loose;                    /* 1: that is only a guess, and phase the present motion */
	double *border;               /* [size] c */
	double *turn;                 /* [n][n] */
	double a[2], b[2];            /* changes of Omega and p */
	double turn_p;                /* component of the parameter of the last unit tangent */
	double below;                 /* last row of the eliminated system */
	struct hawser__hold hold;
};

/* What the core reads of an orbit. */
static void mirror(struct cycle *cycle)
{
	struct hawser__orbit *orbit = &cycle->base;
	const struct hawser__orbit *inner = cycle->inner;
	long solves = orbit->cost.solves, judged = orbit->cost.judged;

	orbit->mesh = inner->mesh;
	orbit->drained = inner->drained;
	orbit->samples = inner->samples;
	orbit->rows = inner->rows;
	orbit->resolution = inner->resolution;
	orbit->round_off = inner->round_off;
	orbit->cost = inner->cost;
	orbit->cost.solves = solves;
	orbit->cost.judged = judged;
}

static int place(struct cycle *cycle, double p)
{
	int failed = hawser__orbit_place(&cycle->base, p);

	cycle->inner->rom = cycle->base.rom;
	return failed;
}

static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct cycle *cycle = (struct cycle *)orbit;
	struct hawser__orbit *inner = cycle->inner;
	int last = orbit->size - 1;

	inner->ops->metric(inner, y);
	memcpy(cycle->old, y, (size_t)orbit->size*sizeof *y);
	inner->ops->shift(inner, cycle->phase, y);
	cycle->phase[last - 1] = 0.0;
	cycle->loose = 0;
	memcpy(orbit->weight, inner->weight, (size_t)last*sizeof(double));
	orbit->X = inner->X;
	orbit->W = HAWSER_OMEGA_WIDTH*hawser__orbit_extent(orbit, y);
	orbit->weight[last] = 1.0/(orbit->W*orbit->W);
}

/* by_p, from the models on both sides of the present one, or on one. */
static void by_parameter(struct cycle *cycle, const double *y)
{
	struct hawser__orbit *orbit = &cycle->base, *inner = cycle->inner;
	double span = 0.0, wide, middle = hawser__orbit_middle(orbit, &wide, y);

	memset(cycle->by_p, 0, (size_t)cycle->count*sizeof(double));
	for (int side = -1; orbit->family && side <= 1; side += 2) {
		int away = !place(cycle, middle + side*wide);

		if (!away && place(cycle, y[orbit->size - 1]))
			return;
		span += away ? wide : 0.0;
		(void)inner->ops->defects(inner, y, 0);
		cycle->parts = inner->ops->parts(inner, &cycle->defect, &cycle->column);
		for (int i = 0; i < cycle->parts && i < cycle->count; i++)
			cycle->by_p[i] += side*cycle->defect[i];
	}
	for (int i = 0; span > 0.0 && i < cycle->count; i++)
		cycle->by_p[i] /= span;
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct cycle *cycle = (struct cycle *)orbit;
	struct hawser__orbit *inner = cycle->inner;
	double residual;

	if (!(y[orbit->size - 2] > 0.0))
		return NAN;
	if (derive)
		by_parameter(cycle, y);
	if (place(cycle, y[orbit->size - 1]))
		return NAN;
	memcpy(cycle->given, y, (size_t)orbit->size*sizeof *y);
	residual = inner->ops->defects(inner, y, derive);
	cycle->parts = inner->ops->parts(inner, &cycle->defect, &cycle->column);
	if (cycle->parts > cycle->count)
		cycle->parts = cycle->count;
	if (derive)
		memcpy(cycle->by_omega, cycle->column, (size_t)cycle->parts*sizeof(double));
	mirror(cycle);
	return residual;
}

void hawser__cycle_loose(struct hawser__orbit *orbit)
{
	if (orbit->own == HAWSER__CYCLES)
		((struct cycle *)orbit)->loose = 1;
}

/* --- the bordered system --- */

/* a and b from the tangent's part in the plane of (Omega, p), relative to their widths. */
static void choose_directions(struct cycle *cycle, const double *row)
{
	struct hawser__orbit *orbit = &cycle->base;
	int last = orbit->size - 1;
	double V = cycle->inner->W, W = orbit->W, u = row[last - 1]/V, v = row[last]/W;
	double length = hypot(u, v);

	u = length > 0.0 ? u/length : 0.0;
	v = length > 0.0 ? v/length : 1.0;
	cycle->a[0] = v; /* in units of the frequency's width, as the inner matrix has them */
	cycle->a[1] = -u*W/V;
	cycle->b[0] = u;
	cycle->b[1] = v*W/V;
}

/* The change of y that X and da of `part`, and db, make. */
static void compose(const struct cycle *cycle, double *dy, const double *part, double db)
{
	int last = cycle->base.size - 1;
	double da = part[last - 1];

	memmove(dy, part, (size_t)(last - 1)*sizeof *dy);
	dy[last - 1] = cycle->a[0]*da + cycle->b[0]*db;
	dy[last] = cycle->a[1]*da + cycle->b[1]*db;
}

static double across(const struct cycle *cycle, const double *dy)
{
	double sum = 0.0;

	for (int i = 0; i < cycle->base.size; i++)
		sum += cycle->border[i]*dy[i];
	return sum;
}

static int factor(struct hawser__orbit *orbit, const double *row)
{
	struct cycle *cycle = (struct cycle *)orbit;
	struct hawser__orbit *inner = cycle->inner;
	int size = orbit->size;

	choose_directions(cycle, row);
	for (int i = 0; i < size; i++)
		cycle->border[i] = orbit->weight[i]*row[i];
	if (cycle->loose) {
		inner->ops->shift(inner, cycle->phase, cycle->given);
		cycle->phase[size - 2] = 0.0;
	}
	for (int i = 0; i < cycle->parts; i++)
		cycle->column[i] = cycle->a[0]*cycle->by_omega[i] + cycle->a[1]*cycle->by_p[i];
	if (inner->ops->factor(inner, cycle->phase))
		return 1;
	memcpy(cycle->kept, cycle->defect, (size_t)cycle->parts*sizeof(double));
	for (int i = 0; i < cycle->parts; i++)
		cycle->defect[i] = cycle->b[0]*cycle->by_omega[i] + cycle->b[1]*cycle->by_p[i];
	inner->held = 0;
	inner->goal = ELIMINATED;
	inner->ops->solve(inner, cycle->part, 0, 0.0); /* - A^-1 g */
	inner->held = !cycle->loose;
	memcpy(cycle->defect, cycle->kept, (size_t)cycle->parts*sizeof(double));
	compose(cycle, cycle->answer, cycle->part, 1.0);
	cycle->below = across(cycle, cycle->answer);
	orbit->det_sign = cycle->below < 0.0 ? -inner->det_sign : inner->det_sign;
	orbit->det_log = inner->det_log + log(fabs(cycle->below));
	if (inner->counted)
		orbit->det_sign = 1.0;
	return cycle->below == 0.0 || !isfinite(cycle->below);
}

/* Of X in the metric. */
static double product(const struct cycle *cycle, const double *a, const double *b)
{
	double sum = 0.0;

	for (int i = 0; i < cycle->base.size - 2; i++)
		sum += cycle->base.weight[i]*a[i]*b[i];
	return sum;
}

/* How far the cycle is along its motion from the last one. */
static double ahead(const struct cycle *cycle)
{
	return cycle->loose ? 0.0 : product(cycle, cycle->phase, cycle->given) -
	                            product(cycle, cycle->phase, cycle->old);
}

static void solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct cycle *cycle = (struct cycle *)orbit;
	struct hawser__orbit *inner = cycle->inner;
	double db;

	if (homogeneous)
		memset(cycle->kept, 0, (size_t)orbit->size*sizeof(double));
	else
		inner->ops->solve(inner, cycle->kept, 0, -ahead(cycle));
	compose(cycle, dy, cycle->kept, 0.0);
	db = (last - across(cycle, dy))/cycle->below;
	for (int i = 0; i < orbit->size; i++)
		dy[i] += db*cycle->answer[i];
	if (!homogeneous)
		return;
	inner->ops->shift(inner, cycle->kept, cycle->given); /* a tangent that does not shift the cycle */
	db = product(cycle, cycle->kept, dy)/product(cycle, cycle->kept, cycle->kept);
	for (int i = 0; i < orbit->size - 2; i++)
		dy[i] -= db*cycle->kept[i];
	cycle->turn_p = dy[orbit->size - 1]/sqrt(hawser__orbit_dot(orbit, dy, dy));
}

static double error(struct hawser__orbit *orbit, double residual)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;
	double error = inner->ops->error(inner, residual);

	orbit->round_off = inner->round_off;
	return error;
}

static enum hawser_status multipliers(struct hawser__orbit *orbit, struct hawser_report *report)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;
	enum hawser_status status = inner->ops->multipliers(inner, report);
	size_t m = (size_t)orbit->m;

	memcpy(orbit->log_modulus, inner->log_modulus, m*sizeof(double));
	memcpy(orbit->argument, inner->argument, m*sizeof(double));
	memcpy(orbit->kind, inner->kind, m*sizeof(double));
	orbit->idle = inner->idle;
	orbit->trivial = inner->trivial;
	orbit->product_error = inner->product_error;
	orbit->product_round_off = inner->product_round_off;
	if (inner->counted && !status)
		hawser__orbit_determinant(orbit, ((struct cycle *)orbit)->turn_p);
	orbit->multiplier_error = inner->multiplier_error;
	mirror((struct cycle *)orbit);
	return status;
}

/* --- the discretisation is the inner one's --- */

static enum hawser_status refine(struct hawser__orbit *orbit, int *again, double tolerance,
                                 double omega, struct hawser_report *report)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;

	return inner->ops->refine(inner, again, tolerance, omega, report);
}

static enum hawser_status relax(struct hawser__orbit *orbit, double tolerance,
                                struct hawser_report *report)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;

	return inner->ops->relax(inner, tolerance, report);
}

static enum hawser_status enrich(struct hawser__orbit *orbit, int most, struct hawser_report *report)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;

	return inner->ops->enrich(inner, most, report);
}

static enum hawser_status sharpen(struct hawser__orbit *orbit, int on, struct hawser_report *report)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;

	return inner->ops->sharpen(inner, on, report);
}

static void add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega)
{
	struct hawser__orbit *inner = ((struct cycle *)orbit)->inner;

	inner->ops->add_wave(inner, y, pq, k, omega);
}

static enum hawser_status from_state(struct hawser__orbit *orbit, double *y, const double *x,
                                     double omega, struct hawser_report *report)
{
	struct cycle *cycle = (struct cycle *)orbit;

	cycle->inner->rom = orbit->rom;
	return cycle->inner->ops->from_state(cycle->inner, y, x, omega, report);
}

static void state(const struct hawser__orbit *orbit, double *x, const double *y)
{
	const struct hawser__orbit *inner = ((const struct cycle *)orbit)->inner;

	inner->ops->state(inner, x, y);
}

static void clear(struct hawser__orbit *orbit)
{
	struct cycle *cycle = (struct cycle *)orbit;

	cycle->inner->ops->clear(cycle->inner);
	hawser__hold_clear(&cycle->hold);
	hawser__orbit_free(orbit);
	free(cycle);
}

static const struct hawser__orbit_ops ops = {
	.metric = metric, .defects = defects, .factor = factor, .solve = solve, .error = error,
	.multipliers = multipliers, .refine = refine, .relax = relax, .enrich = enrich, .sharpen = sharpen,
	.add_wave = add_wave, .from_state = from_state, .state = state, .clear = clear
};

enum hawser_status hawser__cycle_open(struct hawser__orbit **orbit, struct hawser__orbit *inner,
                                      struct hawser_report *report)
{
	struct cycle *cycle = calloc(1, sizeof *cycle);
	size_t size = (size_t)inner->size + 1;
	int turns = 0;
	enum hawser_status status;

	*orbit = NULL;
	if (!cycle) {
		inner->ops->clear(inner);
		return hawser__no_memory(report, "frf");
	}
	cycle->inner = inner;
	cycle->count = inner->size - 1;
	cycle->base.ops = &ops;
	cycle->base.own = HAWSER__CYCLES;
	inner->freely = cycle->base.freely = 1;
	status = hawser__orbit_init(&cycle->base, inner->rom, (int)size, report);
	cycle->given = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->by_omega = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->by_p = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->kept = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->phase = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->part = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->answer = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->border = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->old = hawser__hold(&cycle->hold, size, sizeof(double));
	cycle->turn = hawser__hold(&cycle->hold, (size_t)inner->n*(size_t)inner->n, sizeof(double));
	if (!status && cycle->hold.short_of_memory)
		status = hawser__no_memory(report, "frf");
	if (!status)
		status = hawser__cycle_turn(cycle->turn, &turns, inner->rom, report);
	inner->turn = turns ? cycle->turn : NULL;
	inner->anchor = cycle->old;
	if (status)
		clear(&cycle->base);
	else
		*orbit = &cycle->base;
	return status;
}

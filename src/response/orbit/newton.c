/* response/orbit/newton.c - corrector, metric and tangent, the same for all methods.
 *
 * Newton's method in the plane of the border. As long as they contract well, chord steps with the
 * last factorised Jacobian are used, since a Jacobian costs several times as much as the defects.
 * If the method can extrapolate the Jacobian from earlier orbits, a good prediction is corrected
 * with the extrapolated one, and only the corrected orbit gets its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/time/flow.h"
#include "response/orbit/method.h"

/* The corrector fails after this many steps, or at a larger contraction; chosen. The caller then
 * halves the arclength step, which costs less than slow iterations. */
#define MAX_ITERATIONS 12
#define WORST_CONTRACTION 0.5
/* Chord steps are used below this contraction; above it, the Jacobian is computed again; chosen. */
#define GOOD_CONTRACTION 0.1

/* An extrapolated Jacobian is used for predictions within NEAR of the orbit, for at most MAX_CHORDS
 * steps, while each lowers the defects by WORST_RATE. The orbit gets its own Jacobian when the next
 * defects are expected below SURELY of the tolerance. */
#define NEAR 5e-3
#define WORST_RATE 0.1
#define MAX_CHORDS 4
#define SURELY 0.03

/* Near a branch point, defects are small even far from the branch: inside a small closed curve, all
 * orbits may have defects below the tolerance. An orbit is therefore accepted only if one more step
 * would move it by at most this fraction of its distance from the previous orbit; chosen. */
#define OFF_BRANCH 0.02
/* Derivatives by a parameter are differences about a point, orbit->middle, which stays while the
 * parameter is within this relative distance of it: that changes them by less than the error of the
 * differences. */
#define SAME_MODELS 5e-8
/* Relative residual to which the step that confirms an orbit is solved: of its length, the first digit
 * is used. */
#define LENGTH_RESIDUAL 0.03
/* Steps are solved until the defects that remain are STEP_PART of the tolerance, to a relative residual
 * between the two below; chosen. With a larger part the second step corrects mostly what the first
 * solution left, its length says little of the contraction, and the arclength steps become shorter. */
#define STEP_PART 0.01
#define STEP_RESIDUAL 1e-5
#define STEP_LOOSEST 1e-3

enum hawser_status hawser__orbit_init(struct hawser__orbit *orbit, const struct hawser_rom *rom,
                                      int size, struct hawser_report *report)
{
	orbit->rom = rom;
	orbit->n = rom->n;
	orbit->m = 2*rom->n;
	orbit->size = size;
	orbit->X = orbit->W = 1.0;
	orbit->rate = WORST_RATE;
	orbit->weight = calloc((size_t)size, sizeof(double));
	orbit->step = calloc((size_t)size, sizeof(double));
	orbit->spare = calloc((size_t)size, sizeof(double));
	orbit->log_modulus = calloc((size_t)orbit->m, sizeof(double));
	orbit->argument = calloc((size_t)orbit->m, sizeof(double));
	orbit->kind = calloc((size_t)orbit->m, sizeof(double));
	if (!orbit->weight || !orbit->step || !orbit->spare || !orbit->log_modulus ||
	    !orbit->argument || !orbit->kind)
		return hawser__no_memory(report, "orbit");
	return HAWSER_OK;
}

int hawser__orbit_place(struct hawser__orbit *orbit, double p)
{
	const struct hawser_rom *rom = orbit->rom;
	int failed = orbit->family && orbit->family->model(orbit->family->context, &rom, p, NULL);

	if (!failed) /* else the last model stays */
		orbit->rom = rom;
	orbit->placed = failed ? NAN : p;
	return failed;
}

void hawser__orbit_idle(struct hawser__orbit *orbit, int from)
{
	orbit->idle = orbit->m - from;
	for (int i = from; i < orbit->m; i++) {
		orbit->log_modulus[i] = -HAWSER__MOST_GROWTH;
		orbit->argument[i] = 0.0;
	}
}

void hawser__orbit_determinant(struct hawser__orbit *orbit, double turn)
{
	turn *= orbit->det_sign; /* the continuation may have reversed the tangent */

	orbit->det_sign = turn < 0.0 ? -1.0 : 1.0;
	orbit->det_log = -log(fabs(turn));
	for (int i = 0; i < orbit->m; i++) {
		double modulus = exp(orbit->log_modulus[i]), angle = orbit->argument[i];

		if (angle != 0.0 && fabs(angle) < M_PI) { /* |1 - mu|^2, once for both */
			orbit->det_log += log(1.0 - 2.0*modulus*cos(angle) + modulus*modulus);
			i++;
		} else if (angle == 0.0) {
			orbit->det_log += log(fabs(expm1(orbit->log_modulus[i])));
			if (orbit->log_modulus[i] > 0.0)
				orbit->det_sign = -orbit->det_sign;
		} else {
			orbit->det_log += log1p(modulus);
		}
	}
}

double hawser__orbit_middle(struct hawser__orbit *orbit, double *wide, const double *y)
{
	double p = y[orbit->size - 1];

	if (!(fabs(p - orbit->middle) <= SAME_MODELS*hawser__orbit_extent(orbit, y)))
		orbit->middle = p;
	*wide = HAWSER__NUDGE*fmax(fabs(orbit->middle), orbit->floor);
	return orbit->middle;
}

double hawser__orbit_frequency(const struct hawser__orbit *orbit, double p)
{
	const struct hawser_rom_family *family = orbit->family;
	const struct hawser_rom *rom = orbit->rom;

	if (p != orbit->placed && family->model(family->context, &rom, p, NULL))
		return NAN;
	return family->omega*rom->time;
}

struct hawser__where hawser__orbit_where(const struct hawser__orbit *orbit, double at)
{
	struct hawser__where where;

	if (orbit->family)
		snprintf(where.text, sizeof where.text, "the parameter %.9g", at);
	else
		snprintf(where.text, sizeof where.text, "Omega %.9g%s", HAWSER_SHOWN(orbit->rom, at));
	return where;
}

void hawser__orbit_free(struct hawser__orbit *orbit)
{
	free(orbit->weight);
	free(orbit->step);
	free(orbit->spare);
	free(orbit->log_modulus);
	free(orbit->argument);
	free(orbit->kind);
	free(orbit->memory);
}

/* Of the harmonics' D only those that are constant have a mean. */
double hawser__orbit_liouville(const struct hawser__orbit *orbit, double omega)
{
	const struct hawser_rom *rom = orbit->rom;
	double trace = 0.0, sum = 0.0;

	if (orbit->own == HAWSER__RESTS)
		return orbit->drained; /* the sum of the eigenvalues less the trace of their matrix */
	for (int j = 0; j < rom->n; j++)
		trace += rom->D[j*rom->n + j];
	for (int p = 0; p < rom->harmonics; p++)
		for (int j = 0; rom->harmonic[p].D && rom->harmonic[p].k == 0 && j < rom->n; j++)
			trace += pow(omega, rom->harmonic[p].omega_power)*rom->harmonic[p].D[j*rom->n + j];
	if (orbit->freely && rom->first) /* without the relaxation's */
		trace -= rom->n*(rom->D[0] - rom->first->K[0]);
	for (int i = 0; i < orbit->m - orbit->idle; i++)
		sum += orbit->log_modulus[i];
	return fabs(sum + trace*2.0*M_PI/omega + orbit->drained);
}

/* The step of the corrector from the current defects, dy [size], to the relative residual `goal`, where
 * the method solves by iteration (0: its own); returns its length in the metric. */
static double step_from(struct hawser__orbit *orbit, double *dy, double goal)
{
	orbit->goal = goal;
	orbit->ops->solve(orbit, dy, 0, 0.0);
	orbit->goal = 0.0;
	orbit->cost.solves++;
	return sqrt(hawser__orbit_dot(orbit, dy, dy));
}

/* One step; returns its length. */
static double correct_once(struct hawser__orbit *orbit, double *y, double goal)
{
	double *dy = orbit->step, length = step_from(orbit, dy, goal);

	for (int i = 0; i < orbit->size; i++)
		y[i] += dy[i];
	return length;
}

/* The Jacobian at y and its factorisation. Returns 0, or 1 if it is not available. */
static int renew(struct hawser__orbit *orbit, struct hawser__correction *correction, const double *y,
                 const double *row)
{
	correction->residual = orbit->ops->defects(orbit, y, 1);
	return !isfinite(correction->residual) || orbit->ops->factor(orbit, row);
}

/* Steps with the extrapolated Jacobian. Returns 1 if the Jacobian at y is required next (y is reset
 * to the prediction if that was too far from the orbit), 0 if it was computed with the last
 * defects. */
static int chords(struct hawser__orbit *orbit, double *y, struct hawser__correction *correction,
                  double tolerance)
{
	double rate = fmin(orbit->rate, WORST_RATE);

	for (int i = 1; i <= MAX_CHORDS && rate <= WORST_RATE; i++) {
		double length = correct_once(orbit, y, 0.0), before = correction->residual;
		int sure = rate*before <= SURELY*tolerance;

		if (i == 1 && !(length <= NEAR)) {
			for (int k = 0; k < orbit->size; k++)
				y[k] -= orbit->step[k];
			return 1;
		}
		correction->iterations = i;
		if (i == 1)
			correction->first = length;
		correction->residual = orbit->ops->defects(orbit, y, sure);
		rate = correction->residual/before;
		if (i == 1 && !(sure && rate <= orbit->rate))
			orbit->rate = rate;
		if (sure)
			return 0;
	}
	return 1;
}

/* Correct a good prediction with the extrapolated Jacobian. Returns 1 if that was sufficient. In
 * either case the Jacobian is that at y afterwards, unless *failed. */
static int approach(struct hawser__orbit *orbit, double *y, struct hawser__correction *correction,
                    int *failed, const double *row, double tolerance)
{
	const struct hawser__orbit_ops *ops = orbit->ops;

	*failed = 0;
	if (!ops->guess || !ops->guess(orbit, y, row)) {
		*failed = renew(orbit, correction, y, row);
		return !*failed && orbit->known && correction->residual <= tolerance;
	}
	correction->residual = ops->defects(orbit, y, 0);
	if (!isfinite(correction->residual) || ops->factor(orbit, row) ||
	    chords(orbit, y, correction, tolerance))
		*failed = renew(orbit, correction, y, row);
	else
		*failed = !isfinite(correction->residual) || ops->factor(orbit, row);
	return !*failed && correction->iterations > 0 && correction->residual <= 0.1*tolerance;
}

/* Relative residual to which the next step is solved. */
static double residual_needed(const struct hawser__correction *correction, double tolerance)
{
	return fmin(fmax(STEP_PART*tolerance/correction->residual, STEP_RESIDUAL), STEP_LOOSEST);
}

/* Newton's method from y with its Jacobian. */
static int iterate(struct hawser__orbit *orbit, double *y, struct hawser__correction *correction,
                   const double *row, double tolerance)
{
	const struct hawser__orbit_ops *ops = orbit->ops;
	double previous = 0.0;

	for (int i = correction->iterations + 1; i <= MAX_ITERATIONS; i++) {
		double length = correct_once(orbit, y, residual_needed(correction, tolerance));
		double contraction = previous > 0.0 ? length/previous : 0.0;
		/* after the first step no contraction is known, and the residual decides: near a branch
		 * point a second step would be round-off and look like divergence */
		int done = previous == 0.0 || length <= 0.1*tolerance ||
		           contraction*length <= 0.1*tolerance;
		int derive = done || contraction > GOOD_CONTRACTION;

		correction->iterations = i;
		if (i == 1)
			correction->first = length;
		if (i == 2)
			correction->contraction = contraction;
		if (!isfinite(length) || hawser__orbit_omega(orbit, y) <= 0.0 ||
		    (contraction > fmax(WORST_CONTRACTION, orbit->patience) && length > tolerance))
			return 1;
		/* The Jacobian of the chord steps is that of the prediction. The accepted point gets
		 * its own, for its tangent and multipliers. */
		correction->residual = ops->defects(orbit, y, derive);
		if (!isfinite(correction->residual) || (derive && ops->factor(orbit, row)))
			return 1;
		if (done && correction->residual <= tolerance)
			return 0;
		previous = length;
	}
	return 1;
}

/* Correct an orbit with small defects further, until the steps are small too, or the defects are
 * round-off, which no step reduces. */
static int settle(struct hawser__orbit *orbit, double *y, struct hawser__correction *correction,
                  const double *row, double tolerance)
{
	double near = fmax(OFF_BRANCH*orbit->reach, 0.1*tolerance), *dy = orbit->step;

	for (double before = INFINITY;;) {
		double length = step_from(orbit, dy, LENGTH_RESIDUAL);

		if (length <= near || length > 0.5*before)
			return 0;
		for (int i = 0; i < orbit->size; i++)
			y[i] += dy[i];
		correction->iterations++;
		correction->residual = orbit->ops->defects(orbit, y, 1);
		if (!(correction->residual <= tolerance) || orbit->ops->factor(orbit, row))
			return 1;
		before = length;
	}
}

int hawser__orbit_correct(struct hawser__orbit *orbit, double *y,
                          struct hawser__correction *correction, const double *row,
                          double tolerance)
{
	int failed;

	if (orbit->tick)
		orbit->tick(orbit->owner);
	*correction = (struct hawser__correction){0};
	if (!approach(orbit, y, correction, &failed, row, tolerance) && !failed)
		failed = iterate(orbit, y, correction, row, tolerance);
	if (!failed && orbit->reach > 0.0)
		failed = settle(orbit, y, correction, row, tolerance);
	if (!failed && orbit->ops->keep)
		orbit->ops->keep(orbit, y);
	return failed;
}

void hawser__orbit_tangent(struct hawser__orbit *orbit, double *t)
{
	double length;

	orbit->ops->solve(orbit, t, 1, 1.0);
	orbit->cost.solves++;
	length = sqrt(hawser__orbit_dot(orbit, t, t));
	for (int i = 0; i < orbit->size; i++)
		t[i] /= length;
}

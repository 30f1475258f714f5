/* response/branch/station.c - see station.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/station.h"

/* Round-off of the logarithm of a product of multipliers. */
#define NEUTRAL 1e-12
/* Component along Omega of a unit tangent, relative to the width of Omega, below which the tangent is
 * solved again to the usual residual: its sign tells folds; chosen. */
#define SURE_TURN 0.01
/* Relative residual of a tangent from an estimate; chosen. A branch that begins at an event may end at
 * a branch point of the curve it began at (closure.c), where Omega turns, and may pass it unnoticed
 * with such tangents: not there. */
#define PREDICTION 1e-5
/* Logarithm of a multiplier that is not computed. */
#define INSIDE (-1.0)

enum hawser_status hawser__station_init(struct hawser__station *station,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report)
{
	size_t size = (size_t)orbit->size, m = (size_t)orbit->m;

	memset(station, 0, sizeof *station);
	station->memory = calloc(2*size + 5*m, sizeof *station->memory);
	if (!station->memory)
		return hawser__no_memory(report, "frf");
	station->y = station->memory;
	station->t = station->y + size;
	station->log_modulus = station->t + size;
	station->argument = station->log_modulus + m;
	station->bound = station->argument + m;
	station->kind = station->bound + m;
	station->turning = station->kind + m;
	return HAWSER_OK;
}

void hawser__station_clear(struct hawser__station *station)
{
	free(station->memory);
	memset(station, 0, sizeof *station);
}

void hawser__station_swap(struct hawser__station *a, struct hawser__station *b)
{
	struct hawser__station keep = *a;

	*a = *b;
	*b = keep;
}

static void multiply(struct hawser__test *test, double factor)
{
	test->log += log(fabs(factor));
	if (factor < 0.0)
		test->sign = -test->sign;
}

static int is_pair(const struct hawser__station *station, int i)
{
	return station->argument[i] != 0.0 && fabs(station->argument[i]) < M_PI;
}

/* Error of the logarithm of multiplier i for a sure test; 0 for the other. */
static double bound_of(const struct hawser__station *station, int i, int sure)
{
	return sure ? station->bound[i] : 0.0;
}

/* 1 - |mu| of a negative multiplier. */
static double one_less_modulus(double log_modulus, double bound)
{
	double value = -expm1(log_modulus);

	return fabs(log_modulus) < bound ? fabs(value) + NEUTRAL : value;
}

static struct hawser__test period_doubling_test(const struct hawser__station *station, int m, int sure)
{
	struct hawser__test test = {1.0, 0.0};

	for (int i = 0; i < m; i++) {
		double modulus = exp(station->log_modulus[i]), angle = station->argument[i];

		if (is_pair(station, i)) { /* |1 + mu|^2, once for both multipliers of the pair */
			multiply(&test, 1.0 + 2.0*modulus*cos(angle) + modulus*modulus);
			i++;
		} else {
			multiply(&test, angle == 0.0 ? 1.0 + modulus
			                             : one_less_modulus(station->log_modulus[i],
			                                                bound_of(station, i, sure)));
		}
	}
	return test;
}

/* mu_i mu_j - 1 from the logarithm of the product, which has an error of up to `bound`. */
static double product_less_one(double sum, double bound)
{
	double value = expm1(sum);

	return fabs(sum) < fmax(bound, NEUTRAL) ? -fmax(fabs(value), NEUTRAL) : value;
}

/* |mu_i mu_j - 1|^2, at least that of a neutral pair with its error. */
static double square_less_one(double sum, double angle)
{
	double half = sin(angle/2.0), value = expm1(sum)*expm1(sum) + 4.0*exp(sum)*half*half;

	return fmax(value, NEUTRAL*NEUTRAL);
}

/* The factors of multipliers i and j that are not a conjugate pair. */
static void multiply_across(struct hawser__test *test, struct hawser__tally *tally,
                            const struct hawser__station *station, int i, int j, int sure)
{
	double sum = station->log_modulus[i] + station->log_modulus[j];
	double a = station->argument[i], b = station->argument[j];

	if (is_pair(station, i) || is_pair(station, j))
		multiply(test, square_less_one(sum, a + b));
	if (is_pair(station, i) && is_pair(station, j))
		multiply(test, square_less_one(sum, a - b));
	if (!is_pair(station, i) && !is_pair(station, j)) {
		double value = a == b ? product_less_one(sum, bound_of(station, i, sure) +
		                                              bound_of(station, j, sure))
		                      : -1.0 - exp(sum);

		multiply(test, value);
		tally->reals += value > 0.0;
	}
}

static struct hawser__test torus_test(struct hawser__tally *tally,
                                      const struct hawser__station *station, int m, int sure)
{
	struct hawser__test test = {1.0, 0.0};

	*tally = (struct hawser__tally){0, 0};
	for (int i = 0; i < m; i += is_pair(station, i) ? 2 : 1) {
		int pair = is_pair(station, i);

		if (pair) {
			double value = product_less_one(2.0*station->log_modulus[i],
			                                2.0*bound_of(station, i, sure));

			multiply(&test, value);
			tally->pairs += value > 0.0;
		}
		for (int j = i + (pair ? 2 : 1); j < m; j += is_pair(station, j) ? 2 : 1)
			multiply_across(&test, tally, station, i, j, sure);
	}
	return test;
}

/* Whether the pair whose product is nearest to 1 is complex; two real ones make a neutral saddle. */
static int complex_nearest(const struct hawser__station *station, int m)
{
	double best_pair = INFINITY, best_real = INFINITY;

	for (int i = 0; i < m; i++) {
		if (is_pair(station, i))
			best_pair = fmin(best_pair, fabs(2.0*station->log_modulus[i]));
		for (int j = i + 1; !is_pair(station, i) && j < m; j++)
			if (station->argument[i] == station->argument[j])
				best_real = fmin(best_real, fabs(station->log_modulus[i] +
				                                 station->log_modulus[j]));
	}
	return best_pair < best_real;
}

static void set_tests(struct hawser__station *station, const struct hawser__orbit *orbit)
{
	int m = orbit->m;

	station->test[HAWSER_PERIOD_DOUBLING] = period_doubling_test(station, m, 0);
	station->test[HAWSER_TORUS] = torus_test(&station->tally, station, m, 0);
	station->complex_nearest = complex_nearest(station, m);
	station->test[HAWSER_BRANCH_POINT] = (struct hawser__test){orbit->det_sign,
	                                                           orbit->det_log};
	memcpy(station->sure, station->test, sizeof station->sure);
	station->sure_tally = station->tally;
	if (station->circle.undecided == 0)
		return;
	station->sure[HAWSER_PERIOD_DOUBLING] = period_doubling_test(station, m, 1);
	station->sure[HAWSER_TORUS] = torus_test(&station->sure_tally, station, m, 1);
}

void hawser__station_turn(struct hawser__station *station, struct hawser__orbit *orbit,
                          const double *side, const double *estimate)
{
	double turn;

	if (estimate) { /* which may be station->t */
		memcpy(orbit->spare, estimate, (size_t)orbit->size*sizeof *estimate);
		orbit->estimate = orbit->spare;
		orbit->goal = PREDICTION;
	}
	hawser__orbit_tangent(orbit, station->t);
	orbit->goal = 0.0;
	if (estimate && fabs(station->t[orbit->size - 1]) < SURE_TURN*orbit->W)
		hawser__orbit_tangent(orbit, station->t);
	orbit->estimate = NULL;
	if (hawser__orbit_dot(orbit, station->t, side) < 0.0) {
		for (int i = 0; i < orbit->size; i++)
			station->t[i] = -station->t[i];
		orbit->det_sign = -orbit->det_sign;
	}
	turn = station->t[orbit->size - 1]/orbit->W;
	station->test[HAWSER_FOLD] = (struct hawser__test){turn < 0.0 ? -1.0 : 1.0,
	                                                   log(fabs(turn))};
	station->sure[HAWSER_FOLD] = station->test[HAWSER_FOLD];
}

/* In place of multipliers that are not wanted: all of them far inside the unit circle. */
static enum hawser_status count_as_stable(struct hawser__orbit *orbit)
{
	for (int i = 0; i < orbit->m; i++) {
		orbit->log_modulus[i] = INSIDE;
		orbit->argument[i] = 0.0;
		orbit->kind[i] = 0.0;
	}
	orbit->product_error = orbit->product_round_off = orbit->multiplier_error = 0.0;
	orbit->det_sign = 1.0;
	orbit->det_log = 0.0;
	return HAWSER_OK;
}

/* Whether it is of a curve of which nothing is stated, as another one tells how good it is. An
 * estimate of the error would take a quarter of its time. */
static int station_draft(const struct hawser__orbit *orbit)
{
	return orbit->unjudged > 1 && orbit->rom->exact;
}

enum hawser_status hawser__station_test(struct hawser__station *station,
                                        struct hawser__orbit *orbit, struct hawser_report *report)
{
	int m = orbit->m;
	enum hawser_status status = orbit->unjudged ? count_as_stable(orbit)
	                                            : orbit->ops->multipliers(orbit, report);

	if (status)
		return status;
	orbit->cost.judged += !orbit->unjudged;
	memcpy(station->log_modulus, orbit->log_modulus, (size_t)m*sizeof(double));
	memcpy(station->argument, orbit->argument, (size_t)m*sizeof(double));
	memcpy(station->kind, orbit->kind, (size_t)m*sizeof(double));
	memset(station->turning, 0, (size_t)m*sizeof(double));
	station->circle = hawser__circle_count(station->bound, station->log_modulus, station->argument, m,
	                                       orbit->product_error, orbit->multiplier_error);
	station->trivial = orbit->trivial;
	station->outside = 0;
	for (int i = 0; i < m; i++)
		station->outside += station->log_modulus[i] > 0.0;
	station->liouville = orbit->unjudged ? 0.0
	                     : hawser__orbit_liouville(orbit, hawser__orbit_omega(orbit, station->y));
	station->product_error = orbit->product_error;
	station->product_round_off = orbit->product_round_off;
	station->multiplier_error = orbit->multiplier_error;
	set_tests(station, orbit);
	return HAWSER_OK;
}

enum hawser_status hawser__station_judge(struct hawser__station *station,
                                         struct hawser__orbit *orbit, struct hawser_report *report)
{
	enum hawser_status status = hawser__station_test(station, orbit, report);

	if (status)
		return status;
	station->mesh = orbit->mesh/orbit->X;
	/* infinite at a branch point; then the size of the orbit is used */
	station->error = fmin(1.0, station_draft(orbit)
	                           ? station->mesh + station->correction.residual
	                           : orbit->ops->error(orbit, station->correction.residual));
	station->round_off = orbit->round_off;
	return HAWSER_OK;
}

enum hawser_status hawser__station_finish(struct hawser__station *station,
                                          struct hawser__orbit *orbit, const double *side,
                                          struct hawser_report *report)
{
	hawser__station_turn(station, orbit, side, NULL);
	return hawser__station_judge(station, orbit, report);
}

int hawser__station_torus(const struct hawser__station *a, const struct hawser__station *b,
                          const struct hawser__station *at, int sure)
{
	struct hawser__tally before = sure ? a->sure_tally : a->tally;
	struct hawser__tally after = sure ? b->sure_tally : b->tally;

	if ((before.pairs != after.pairs) != (before.reals != after.reals))
		return before.pairs != after.pairs;
	return at->complex_nearest;
}

int hawser__station_crossed(const struct hawser__station *a, const struct hawser__station *b,
                            enum hawser_event_kind kind, int sure)
{
	if (kind == HAWSER_TORUS && !hawser__station_torus(a, b, a, sure) &&
	    !hawser__station_torus(a, b, b, sure))
		return 0;
	return sure ? a->sure[kind].sign*b->sure[kind].sign < 0.0
	            : a->test[kind].sign*b->test[kind].sign < 0.0;
}

void hawser__station_between(double *y, double *direction, const struct hawser__station *a,
                             const struct hawser__station *b, double s,
                             const struct hawser__orbit *orbit)
{
	const struct hawser__node from = hawser__station_node(a), to = hawser__station_node(b);
	const struct hawser__metric metric = hawser__orbit_metric(orbit);

	hawser__curve_between(y, direction, &from, &to, s, &metric);
}

int hawser__station_inside(struct hawser__station *station, struct hawser__orbit *orbit,
                           const struct hawser__station *a, const struct hawser__station *b, double s,
                           double tolerance)
{
	struct hawser__correction *correction = &station->correction;

	hawser__station_between(station->y, station->t, a, b, s, orbit);
	if (!hawser__orbit_correct(orbit, station->y, correction, station->t, tolerance))
		return 0;
	hawser__station_between(station->y, station->t, a, b, s, orbit);
	correction->residual = orbit->ops->defects(orbit, station->y, 1);
	return !(correction->residual <= tolerance) || orbit->ops->factor(orbit, station->t);
}

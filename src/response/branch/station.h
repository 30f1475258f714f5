/* response/branch/station.h - a corrected point of the branch with its tangent, multipliers and test
 * functions, whose zeros are the events.
 *
 * Test functions along the branch (Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed.,
 * 10.2):
 *
 *    fold             Omega component of the unit tangent
 *    period doubling  product of (1 + mu_i)
 *    torus            product of (mu_i mu_j - 1) over i < j, smooth where a complex pair becomes two
 *                     real multipliers. It vanishes at a neutral saddle too.
 *    branch point     determinant of the Jacobian bordered by the tangent: changes sign at a simple
 *                     branch point and does not vanish at a fold
 *
 * Values are stored as sign and logarithm, since a product of hundreds of pairs would underflow.
 *
 * The sign of a factor that differs from zero by less than its error is arbitrary; the torus test
 * of an undamped model has such factors only. In the array `sure`, multipliers, and products of
 * two, whose distance from the unit circle is less than their error (circle.h) count as inside. An
 * event then lies where a multiplier is certainly outside on one side and not on the other. Between
 * stations without undecided multipliers, the test functions themselves are used.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_STATION_H
#define HAWSER_RESPONSE_STATION_H

#include <hawser/frf.h>

#include "response/torus/circle.h"
#include "response/orbit/method.h"

#define HAWSER_TESTS 4 /* indexed by enum hawser_event_kind */

/* Number of positive factors mu_i mu_j - 1 of conjugate pairs, and of pairs of real multipliers.
 * The first changes at a torus point, the second at a neutral saddle. */
struct hawser__tally {
	int pairs, reals;
};

struct hawser__test {
	double sign, log; /* sign * exp(log) */
};

struct hawser__station {
	double *y, *t;    /* [size] unknowns and unit tangent */
	double arc;
	struct hawser__test test[HAWSER_TESTS], sure[HAWSER_TESTS];
	struct hawser__circle circle;
	int outside;         /* number of multipliers outside, by the sign of their logarithm only */
	int complex_nearest; /* 1: of all pairs, the one with product nearest to 1 is complex */
	struct hawser__tally tally, sure_tally; /* of the torus test, and of the sure one */
	double trivial;   /* of a cycle, see method.h */
	double liouville, mesh, error; /* certificate, see frf.h */
	/* of the multipliers and of the orbit, see method.h */
	double product_error, product_round_off, multiplier_error, round_off;
	struct hawser__correction correction;
	double *log_modulus, *argument, *bound, *kind; /* [m]; error of a logarithm; see method.h */
	double *turning;  /* [m] change of the argument of a pair with the arclength; 0: not known */
	double *memory;
};

enum hawser_status hawser__station_init(struct hawser__station *station,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report);
void hawser__station_clear(struct hawser__station *station);
void hawser__station_swap(struct hawser__station *a, struct hawser__station *b);

/* After a successful correction of station->y: compute the tangent with a positive component along
 * `side` [size], and the test function of folds, but no multipliers. With an estimate [size] of the
 * tangent, of any length, it is computed roughly, for predictions and for its sign; else NULL. */
void hawser__station_turn(struct hawser__station *station, struct hawser__orbit *orbit,
                          const double *side, const double *estimate);

/* After that: multipliers, test functions, stability; and the certificate as well. */
enum hawser_status hawser__station_test(struct hawser__station *station,
                                        struct hawser__orbit *orbit, struct hawser_report *report);
enum hawser_status hawser__station_judge(struct hawser__station *station,
                                         struct hawser__orbit *orbit, struct hawser_report *report);

/* The tangent and all of that. */
enum hawser_status hawser__station_finish(struct hawser__station *station,
                                          struct hawser__orbit *orbit, const double *side,
                                          struct hawser_report *report);

/* Whether the sure tests apply to the events between a and b. */
static inline int hawser__station_unsure(const struct hawser__station *a,
                                         const struct hawser__station *b)
{
	return a->circle.undecided > 0 || b->circle.undecided > 0;
}

/* Number of multipliers outside that belongs to the sure tests, or to the others. */
static inline struct hawser__circle hawser__station_circle(const struct hawser__station *station,
                                                           int sure)
{
	return sure ? station->circle : (struct hawser__circle){station->outside, 0, 0};
}

/* Whether the factor that changes the sign of a torus test between a and b belongs to a conjugate
 * pair; if the tallies do not show it, whether the pair nearest to neutral at `at` is complex. */
int hawser__station_torus(const struct hawser__station *a, const struct hawser__station *b,
                          const struct hawser__station *at, int sure);

/* Whether test k, of the sure ones or of the others, changes sign from a to b; the change at a
 * neutral saddle does not count as a torus point. */
int hawser__station_crossed(const struct hawser__station *a, const struct hawser__station *b,
                            enum hawser_event_kind kind, int sure);

static inline struct hawser__node hawser__station_node(const struct hawser__station *station)
{
	return (struct hawser__node){station->y, station->t};
}

/* Point y [size] and direction [size] at the fraction s between a and b, on the cubic through both
 * (continuation/metric.h), in the metric of the orbit. */
void hawser__station_between(double *y, double *direction, const struct hawser__station *a,
                             const struct hawser__station *b, double s,
                             const struct hawser__orbit *orbit);

/* Compute station->y, the point of the branch at the fraction s between a and b; station->t becomes
 * the row of its correction. If the corrector fails, but the point of the cubic has defects below
 * `tolerance`, that point is used: near a branch point, a correction is round-off divided by a
 * small pivot. Returns 0, or 1 if there is no such point. */
int hawser__station_inside(struct hawser__station *station, struct hawser__orbit *orbit,
                           const struct hawser__station *a, const struct hawser__station *b, double s,
                           double tolerance);

#endif

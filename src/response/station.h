/* response/station.h - a corrected point of the branch with everything that belongs to it, and the
 * test functions whose zeros are its events.
 *
 * Test functions along the branch (Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed.,
 * 10.2):
 *
 *   fold             Omega component of the unit tangent
 *   period doubling  product of (1 + mu_i)
 *   torus            product of (mu_i mu_j - 1) over i < j, smooth where a complex pair becomes two
 *                    real multipliers. It vanishes at a neutral saddle too.
 *   branch point     determinant of the Jacobian bordered by the tangent: changes sign at a simple
 *                    branch point and does not vanish at a fold
 *
 * Values are kept as sign and logarithm: a product over hundreds of pairs would underflow.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_STATION_H
#define HAWSER_RESPONSE_STATION_H

#include <hawser/frf.h>

#include "response/method.h"

#define HAWSER_TESTS 4 /* indexed by enum hawser_event_kind */

struct hawser__test {
	double sign, log; /* sign * exp(log) */
};

struct hawser__station {
	double *y, *t;    /* [size] unknowns and unit tangent */
	double arc;
	struct hawser__test test[HAWSER_TESTS];
	int unstable;
	int complex_nearest; /* of all pairs, the one with product nearest to 1 is complex */
	double liouville, mesh, error; /* certificate, see frf.h */
	/* of the multipliers and of the orbit, see method.h */
	double product_error, product_round_off, multiplier_error, round_off;
	struct hawser__correction correction;
	double *log_modulus, *argument; /* [m] */
	double *memory;
};

enum hawser_status hawser__station_init(struct hawser__station *station,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report);
void hawser__station_clear(struct hawser__station *station);
void hawser__station_swap(struct hawser__station *a, struct hawser__station *b);

/* After a successful correction of station->y: tangent on the side of `side` [size], and the fold's
 * test; no multipliers. */
void hawser__station_turn(struct hawser__station *station, struct hawser__orbit *orbit,
                          const double *side);

/* After a successful correction of station->y: tangent on the side of `side` [size], multipliers,
 * test functions, stability, certificate. */
enum hawser_status hawser__station_finish(struct hawser__station *station,
                                          struct hawser__orbit *orbit, const double *side,
                                          struct hawser_report *report);

/* Whether test k has changed sign from a to b; a neutral saddle's change is not counted as a
 * torus. */
int hawser__station_crossed(const struct hawser__station *a, const struct hawser__station *b,
                            enum hawser_event_kind kind);

static inline struct hawser__node hawser__station_node(const struct hawser__station *station)
{
	return (struct hawser__node){station->y, station->t};
}

/* Point y [size] and direction [size] at fraction s of the way from a to b, on the cubic through both
 * (continuation/metric.h), in the orbit's metric. */
void hawser__station_between(double *y, double *direction, const struct hawser__station *a,
                             const struct hawser__station *b, double s,
                             const struct hawser__orbit *orbit);

/* Make station->y the point of the branch at fraction s of the way from a to b, station->t the row of
 * its correction. Where the corrector fails and the cubic's own point has defects below `tolerance`
 * already, that point is taken: next to a branch point a correction is round-off over a small pivot.
 * Returns 0, or 1 when there is no such point. */
int hawser__station_inside(struct hawser__station *station, struct hawser__orbit *orbit,
                           const struct hawser__station *a, const struct hawser__station *b, double s,
                           double tolerance);

#endif

/* response/branch/bracket.h - the zero of a test function between two stations of a branch.
 *
 *   s    0 to 1 along the cubic through both stations
 *   f    test function, or logarithm of the watched modulus, over its larger end value
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BRACKET_H
#define HAWSER_RESPONSE_BRACKET_H

#include "continuation/false_position.h"
#include "response/branch/station.h"

#define HAWSER__MOST_FAILURES 12 /* failures of the corrector in one search; chosen */
/* False position with a bisection every eighth time needs 4 to 12 trials; with 60 the bracket is
 * halved seven times at least. */
#define HAWSER__MOST_TRIALS (60 + HAWSER__MOST_FAILURES)

struct hawser__bracket_trial {
	double s, f, omega;
	double product_error, product_round_off, multiplier_error; /* as in a station */
	double *log_modulus, *argument; /* [m]; not set for a fold */
};

struct hawser__bracket {
	struct hawser__orbit *orbit;
	struct hawser__station *at; /* the last trial; after the search, the result */
	const struct hawser__station *a, *b;
	enum hawser_event_kind kind;
	int sure;              /* 1: by the sure test function (station.h) */
	int watched;           /* rank of the multiplier whose modulus locates the event; -1: none */
	double tolerance;      /* of the corrector */
	double scale;          /* logarithm by which test values are scaled, or the larger logarithm of
	                        * the watched modulus */
	struct hawser__bracketed in;
	double before;         /* Omega of the last trial */
	double uncertain;      /* relative uncertainty of Omega if the result is interpolated */
	int several;           /* 1: the search ended, since the bracket has more events than one */
	int failures, trials;
	struct hawser__bracket_trial trial[HAWSER__MOST_TRIALS]; /* [trials] */
	double *multipliers;   /* memory of the multipliers of the trials */
};

/* Prepare a search for events of `kind` between a and b, by the sure test function or the other;
 * scratch is a station owned by the caller. */
enum hawser_status hawser__bracket_init(struct hawser__bracket *bracket, struct hawser__orbit *orbit,
                                        struct hawser__station *scratch,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        enum hawser_event_kind kind, int sure,
                                        struct hawser_report *report);
/* Whether the sign of the test function does not identify the event between a and b, one of which has
 * undecided multipliers. For a period doubling it does, with and without damping, unless an undecided
 * multiplier near -1 has changed its sign. */
int hawser__bracket_needs_sure(const struct hawser__station *a, const struct hawser__station *b,
                               enum hawser_event_kind kind);
void hawser__bracket_clear(struct hawser__bracket *bracket);

/* The scaled test function of a station; where a multiplier is watched, the logarithm of its modulus
 * with the sign of the test function. */
double hawser__bracket_value(const struct hawser__bracket *bracket,
                             const struct hawser__station *station);

/* Find *s and *f of the zero with the relative tolerance `tolerance` in Omega; bracket->at becomes
 * its orbit. |*f| is not small at a pole or a discontinuity. The search also ends, without a zero,
 * where bracket->several is set. HAWSER_ERR_CONVERGENCE if the
 * corrector fails on both sides. */
enum hawser_status hawser__bracket_zero(struct hawser__bracket *bracket, double *s, double *f,
                                        double tolerance, struct hawser_report *report);

#endif

/* response/bracket.h - the zero of a test function between two stations of a branch.
 *
 *   s    0 to 1 along the cubic through both stations
 *   f    test function over its larger end value
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BRACKET_H
#define HAWSER_RESPONSE_BRACKET_H

#include "response/station.h"

#define HAWSER__MOST_FAILURES 12 /* of the corrector in one search */
/* Regula falsi with a bisection every sixth time needs 10 to 20; 60 halve the bracket ten times. */
#define HAWSER__MOST_TRIALS (60 + HAWSER__MOST_FAILURES)

struct hawser__trial {
	double s, f, omega;
	double error, round_off;        /* of its orbit, as of a station */
	double product_error, product_round_off, multiplier_error; /* as of a station */
	double *log_modulus, *argument; /* [m]; not set for a fold */
};

struct hawser__bracket {
	struct hawser__orbit *orbit;
	struct hawser__station *at; /* the last trial; the answer when the search ends */
	const struct hawser__station *a, *b;
	enum hawser_event_kind kind;
	int sure;              /* by the sure test (station.h) */
	double tolerance;      /* of the corrector */
	double scale;          /* logarithm by which test values are scaled */
	double sa, sb, fa, fb; /* the bracket */
	double before;         /* Omega of the last trial */
	double uncertain;      /* relative, of Omega, where the answer is an interpolated one */
	int failures, trials;
	struct hawser__trial trial[HAWSER__MOST_TRIALS]; /* [trials] */
	double *multipliers;   /* their memory */
};

/* For events of `kind`, by the sure test or the other, between a and b; scratch is a station of the
 * caller's. */
enum hawser_status hawser__bracket_init(struct hawser__bracket *bracket, struct hawser__orbit *orbit,
                                        struct hawser__station *scratch,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        enum hawser_event_kind kind, int sure,
                                        struct hawser_report *report);
void hawser__bracket_clear(struct hawser__bracket *bracket);

/* The scaled test function of a station. */
double hawser__bracket_value(const struct hawser__bracket *bracket,
                             const struct hawser__station *station);

/* Find *s and *f of the zero to `tolerance`, relative, in Omega; bracket->at holds its orbit. |*f| is
 * not small at a pole or a jump. HAWSER_ERR_CONVERGENCE where the corrector fails on both sides. */
enum hawser_status hawser__bracket_zero(struct hawser__bracket *bracket, double *s, double *f,
                                        double tolerance, struct hawser_report *report);

#endif

/* response/branch/bracket.c - see bracket.h.
 *
 * Every trial point is corrected onto the branch and gets its own multipliers, so that the result
 * contains no interpolation. The exception is a branch point, where the Jacobian of the corrector
 * is singular: too near to it, the corrector fails. Trials on both sides then bracket the branch
 * point, and the result is the zero of the line through them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/bracket.h"
#include "response/branch/locate.h"

/* If |f| of the nearest trial is below this, a failure of the corrector is attributed to a branch
 * point; chosen. */
#define NEARBY 0.02
#define CROSSED 0.01 /* smallest ratio of the logarithms of a modulus at both ends by which an event is
                      * located; chosen */
#define CLEAR 1e-7 /* smallest size of these logarithms: above the errors of multipliers */
#define SMALL 1e-4 /* largest |f| at a zero, and */
#define OF_END 0.1 /* the same over the smaller |f| of the two ends of the bracket: where an end is near
                    * the event, |f| is small everywhere; both chosen */
#define LEAST_VALUE 1e-10 /* |f| of an end that is at the event, above which OF_END counts; chosen */
#define SECANT 10.0 /* safety factor on a change of Omega that is estimated by a secant; chosen */
#define SEPARABLE 1e-4 /* arclength: a search in a longer bracket ends where it shows further events,
                        * and the bracket is halved (account.c) */
#define ASIDE 0.02 /* distance of the next trial from a failure of the corrector, relative to the
                    * bracket; chosen */

static const struct hawser__test *test_of(const struct hawser__bracket *bracket,
                                          const struct hawser__station *station)
{
	return bracket->sure ? &station->sure[bracket->kind] : &station->test[bracket->kind];
}

int hawser__bracket_needs_sure(const struct hawser__station *a, const struct hawser__station *b,
                               enum hawser_event_kind kind)
{
	return kind == HAWSER_TORUS ||
	       (kind == HAWSER_PERIOD_DOUBLING && a->test[kind].sign*b->test[kind].sign > 0.0);
}

/* Rank by modulus of the multiplier that crosses the unit circle between a and b, if the number of
 * those outside changes as by one event; otherwise -1. The modulus of a given rank is a continuous
 * function of the place on the branch, while the test function, a product over all multipliers,
 * may vary much faster. Without damping, the modulus is 1 on one side of the event, and only the test
 * function changes its sign. */
static int crossing(const struct hawser__bracket *bracket)
{
	int before = hawser__station_circle(bracket->a, bracket->sure).unstable;
	int after = hawser__station_circle(bracket->b, bracket->sure).unstable;
	int rank = before < after ? before : after;
	double a, b;

	if (bracket->kind == HAWSER_FOLD ||
	    abs(after - before) != hawser__event_width(bracket->kind))
		return -1;
	a = bracket->a->log_modulus[rank];
	b = bracket->b->log_modulus[rank];
	return a*b < 0.0 && fmin(fabs(a), fabs(b)) > fmax(CLEAR, CROSSED*fmax(fabs(a), fabs(b)))
	       ? rank : -1;
}

enum hawser_status hawser__bracket_init(struct hawser__bracket *bracket, struct hawser__orbit *orbit,
                                        struct hawser__station *scratch,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        enum hawser_event_kind kind, int sure,
                                        struct hawser_report *report)
{
	size_t m = (size_t)orbit->m;

	*bracket = (struct hawser__bracket){.orbit = orbit, .at = scratch, .a = a, .b = b, .kind = kind,
		.in = {.b = 1.0}};
	bracket->sure = sure && hawser__bracket_needs_sure(a, b, kind);
	bracket->watched = crossing(bracket);
	bracket->scale = bracket->watched < 0
	                 ? fmax(test_of(bracket, a)->log, test_of(bracket, b)->log)
	                 : fmax(fabs(a->log_modulus[bracket->watched]),
	                        fabs(b->log_modulus[bracket->watched]));
	bracket->multipliers = malloc(2*m*HAWSER__MOST_TRIALS*sizeof(double));
	if (!bracket->multipliers)
		return hawser__no_memory(report, "frf");
	for (int i = 0; i < HAWSER__MOST_TRIALS; i++) {
		bracket->trial[i].log_modulus = bracket->multipliers + 2*m*(size_t)i;
		bracket->trial[i].argument = bracket->trial[i].log_modulus + m;
	}
	return HAWSER_OK;
}

void hawser__bracket_clear(struct hawser__bracket *bracket)
{
	free(bracket->multipliers);
	bracket->multipliers = NULL;
}

double hawser__bracket_value(const struct hawser__bracket *bracket,
                             const struct hawser__station *station)
{
	const struct hawser__test *test = test_of(bracket, station);

	if (bracket->watched >= 0)
		return test->sign*fabs(station->log_modulus[bracket->watched])/bracket->scale;
	return test->sign*exp(fmin(test->log - bracket->scale, 700.0));
}

static void record(struct hawser__bracket *bracket, const struct hawser__station *station, double s,
                   double f)
{
	int m = bracket->orbit->m, last = bracket->orbit->size - 1;
	struct hawser__bracket_trial *row = &bracket->trial[bracket->trials++];

	row->s = s;
	row->f = f;
	row->omega = station->y[last];
	row->product_error = station->product_error;
	row->product_round_off = station->product_round_off;
	row->multiplier_error = station->multiplier_error;
	if (bracket->kind == HAWSER_FOLD)
		return;
	memcpy(row->log_modulus, station->log_modulus, (size_t)m*sizeof(double));
	memcpy(row->argument, station->argument, (size_t)m*sizeof(double));
}

/* The corrected point at s, and the scaled value of its test function. */
static enum hawser_status trial(double *value, int *failed, struct hawser__bracket *bracket, double s,
                                struct hawser_report *report)
{
	struct hawser__station *at = bracket->at;
	enum hawser_status status = HAWSER_OK;

	*failed = hawser__station_inside(at, bracket->orbit, bracket->a, bracket->b, s,
	                                 bracket->tolerance);
	if (*failed)
		return HAWSER_OK;
	hawser__station_turn(at, bracket->orbit, bracket->a->t,
	                     bracket->kind == HAWSER_TORUS || bracket->kind == HAWSER_PERIOD_DOUBLING
	                     ? at->t : NULL);
	if (bracket->kind != HAWSER_FOLD) /* which needs no multipliers */
		status = hawser__station_test(at, bracket->orbit, report);
	if (!status) {
		*value = hawser__bracket_value(bracket, at);
		record(bracket, at, s, *value);
	}
	return status;
}

static const struct hawser__bracket_trial *nearest_trial(const struct hawser__bracket *bracket,
                                                         double s)
{
	const struct hawser__bracket_trial *best = NULL;

	for (int i = 0; i < bracket->trials; i++)
		if (!best || fabs(bracket->trial[i].s - s) < fabs(best->s - s))
			best = &bracket->trial[i];
	return best;
}

/* The orbit at s by the cubic, with Omega shifted as the corrector shifted it at the nearest
 * trial. */
static double omega_at(const struct hawser__bracket *bracket, double s)
{
	const struct hawser__bracket_trial *near = nearest_trial(bracket, s);
	double *y = bracket->at->y, *direction = bracket->at->t, moved = 0.0;
	int last = bracket->orbit->size - 1;

	if (near) {
		hawser__station_between(y, direction, bracket->a, bracket->b, near->s, bracket->orbit);
		moved = near->omega - y[last];
	}
	hawser__station_between(y, direction, bracket->a, bracket->b, s, bracket->orbit);
	y[last] += moved;
	return y[last];
}

/* On one side of its zero, a sure test function is round-off, of which only the sign is used. */
static double next_place(const struct hawser__bracket *bracket, int i)
{
	const struct hawser__bracketed *in = &bracket->in;

	return bracket->sure && bracket->watched < 0 ? 0.5*(in->a + in->b)
	                                             : hawser__false_position(in, i);
}

/* The next trial after the corrector failed at s: beside it, towards the farther end of the
 * bracket. */
static double place_aside(const struct hawser__bracket *bracket, double s, double share)
{
	const struct hawser__bracketed *in = &bracket->in;
	double far = s - in->a > in->b - s ? in->a : in->b;

	return s + share*(far - s);
}

/* After the corrector failed at s: if Omega at the zero is known accurately enough, *done is set;
 * otherwise one more trial beside s narrows the bracket. */
static enum hawser_status pass_failure(struct hawser__bracket *bracket, int *done, double s,
                                       double *share, double tolerance,
                                       struct hawser_report *report)
{
	const struct hawser__bracket_trial *near = nearest_trial(bracket, s);
	double omega = omega_at(bracket, s), f;
	int failed;
	enum hawser_status status;

	bracket->failures++;
	bracket->uncertain = fabs(omega - bracket->before)/fmax(fabs(omega), bracket->orbit->floor);
	bracket->before = omega;
	*done = near && fabs(near->f) < NEARBY && (bracket->uncertain <= tolerance ||
	                                           bracket->failures == HAWSER__MOST_FAILURES);
	if (*done)
		return HAWSER_OK;
	if (bracket->failures == HAWSER__MOST_FAILURES)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf",
		                       bracket->at->correction.iterations,
		                       bracket->at->correction.residual,
		                       "the corrector failed near %s while locating an event",
		                       hawser__orbit_where(bracket->orbit, omega).text);
	if ((status = trial(&f, &failed, bracket, place_aside(bracket, s, *share), report)))
		return status;
	*share = failed ? fmin(4.0**share, 0.5) : 0.25**share;
	if (!failed)
		hawser__false_position_take(&bracket->in, bracket->trial[bracket->trials - 1].s, f);
	return HAWSER_OK;
}

/* Whether the number of multipliers outside the unit circle at the last trial is that of neither end:
 * then there are further events in the bracket, and the watched modulus need not be that of the
 * multiplier that crosses the circle where the test function changes its sign. */
static int has_more(const struct hawser__bracket *bracket)
{
	int count = hawser__station_circle(bracket->at, bracket->sure).unstable;

	return bracket->watched >= 0 && bracket->b->arc - bracket->a->arc > SEPARABLE &&
	       count != hawser__station_circle(bracket->a, bracket->sure).unstable &&
	       count != hawser__station_circle(bracket->b, bracket->sure).unstable;
}

/* Whether Omega of the last trial is within `near` of that at the zero, by the secant through the
 * last two trials; it would be the next trial's change of Omega. */
static int reached(const struct hawser__bracket *bracket, double near, double small)
{
	const struct hawser__bracket_trial *last = &bracket->trial[bracket->trials - 1], *other = last - 1;

	return bracket->trials > 1 && fabs(last->f) < small && fabs(last->f) < fabs(other->f) &&
	       SECANT*fabs((last->omega - other->omega)*last->f) <= near*fabs(last->f - other->f);
}

enum hawser_status hawser__bracket_zero(struct hawser__bracket *bracket, double *s, double *f,
                                        double tolerance, struct hawser_report *report)
{
	double share = ASIDE, omega, near, small;
	int last = bracket->orbit->size - 1, failed, done;

	bracket->in.fa = hawser__bracket_value(bracket, bracket->a);
	bracket->in.fb = hawser__bracket_value(bracket, bracket->b);
	small = fmin(SMALL, fmax(LEAST_VALUE, OF_END*fmin(fabs(bracket->in.fa), fabs(bracket->in.fb))));
	bracket->before = INFINITY;
	*f = bracket->in.fa;
	for (int i = 0; i < HAWSER__MOST_TRIALS - HAWSER__MOST_FAILURES; i++) {
		enum hawser_status status;

		*s = next_place(bracket, i);
		if ((status = trial(f, &failed, bracket, *s, report)))
			return status;
		if (failed) {
			if ((status = pass_failure(bracket, &done, *s, &share, tolerance, report)))
				return status;
			*f = 0.0;
			if (done)
				return HAWSER_OK;
			continue;
		}
		omega = bracket->at->y[last];
		near = 0.1*tolerance*hawser__orbit_extent(bracket->orbit, bracket->at->y);
		bracket->uncertain = 0.0;
		bracket->several = has_more(bracket);
		if (*f == 0.0 || bracket->several || bracket->in.b - bracket->in.a < 1e-14 ||
		    (fabs(omega - bracket->before) <= near && fabs(*f) < small) ||
		    reached(bracket, near, small))
			return HAWSER_OK;
		bracket->before = omega;
		hawser__false_position_take(&bracket->in, *s, *f);
	}
	return HAWSER_OK;
}

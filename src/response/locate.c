/* response/locate.c - see locate.h.
 *
 * The error of Omega at an event is the error of the multiplier that passes the unit circle, over how
 * fast this multiplier changes with Omega there. Both come from the trials of the search: the
 * multiplier is followed from the event to the trials beside it by its place in the complex plane, and
 * the error of the orbits is that of the best determined one. At a branch point the orbit itself is
 * not determined, but what is not determined there is a motion along the other branch, which moves
 * the point by its square only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "core/report.h"
#include "response/bracket.h"
#include "response/locate.h"
#include "response/monodromy.h"

#define ENOUGH 1e-5 /* of a multiplier's logarithm, for a slope */
#define ZERO 1e-3   /* |f| at a zero; at a pole or a jump f does not become small */
/* Of the orbit's distance from the branch, by which Omega, relative, may be off at an event: an orbit
 * that is off by its own size moves Omega by W, a twentieth of it (method.h). */
#define SHARE 0.05
/* By how much more than its orbit a multiplier is off (bench/estimates events). */
#define ANSWER 10.0

int hawser__event_width(enum hawser_event_kind kind)
{
	return kind == HAWSER_TORUS ? 2 : kind == HAWSER_UNEXPLAINED ? 0 : 1;
}

/* Index of the multiplier nearest to the unit circle of those that can make an event of this kind, or
 * -1. */
static int critical(const double *log_modulus, const double *argument, int m,
                    enum hawser_event_kind kind)
{
	int best = -1;

	for (int i = 0; i < m; i++) {
		int minus = fabs(argument[i]) >= M_PI, plus = argument[i] == 0.0;
		int fits = kind == HAWSER_TORUS ? !plus && !minus
		           : kind == HAWSER_PERIOD_DOUBLING ? minus : plus;

		if (fits && (best < 0 || fabs(log_modulus[i]) < fabs(log_modulus[best])))
			best = i;
	}
	return best;
}

/* Index of the multiplier of a trial that is nearest to one on the unit circle at `argument`. */
static int nearest(const struct hawser__trial *trial, double argument, int m)
{
	double least = INFINITY;
	int best = 0;

	for (int i = 0; i < m; i++) {
		double turn = fabs(fabs(trial->argument[i]) - fabs(argument));
		double away = hypot(trial->log_modulus[i], turn);

		if (away < least) {
			least = away;
			best = i;
		}
	}
	return best;
}

/* Relative change of Omega over that of the logarithm of the critical multiplier: the larger of what
 * the nearest trials on both sides of the event say; negative where no trial is far enough. */
static double slowness(const struct hawser__bracket *bracket, double s, double omega, double argument)
{
	double near[2] = {INFINITY, INFINITY}, slow[2] = {-1.0, -1.0};

	for (int i = 0; i < bracket->trials; i++) {
		const struct hawser__trial *trial = &bracket->trial[i];
		int side = trial->s > s;
		double change = fabs(trial->log_modulus[nearest(trial, argument, bracket->orbit->m)]);

		if (change < ENOUGH || fabs(trial->s - s) >= near[side])
			continue;
		near[side] = fabs(trial->s - s);
		slow[side] = fabs(trial->omega/omega - 1.0)/change;
	}
	return fmax(slow[0], slow[1]);
}

/* The same from the ends of the bracket. */
static double end_slowness(const struct hawser__bracket *bracket, double omega, double argument)
{
	const struct hawser__station *end[2] = {bracket->a, bracket->b};
	int last = bracket->orbit->size - 1;
	double slow = 0.0;

	for (int i = 0; i < 2; i++) {
		struct hawser__trial trial = {.log_modulus = end[i]->log_modulus,
			.argument = end[i]->argument};
		int k = nearest(&trial, argument, bracket->orbit->m);

		slow = fmax(slow, fabs(end[i]->y[last]/omega - 1.0)/
		                  fmax(fabs(end[i]->log_modulus[k]), ENOUGH));
	}
	return slow;
}

/* Of the best determined orbit of all trials and ends. */
static double orbit_error(const struct hawser__bracket *bracket)
{
	double least = fmin(bracket->a->error, bracket->b->error);

	for (int i = 0; i < bracket->trials; i++)
		least = fmin(least, bracket->trial[i].error);
	return least;
}

/* Of the logarithm of multiplier i of a trial, where the best determined orbit is off by `far`. The
 * multiplier is an eigenvalue of a matrix that has errors of its own; they move it by more, the nearer
 * another multiplier is. */
static double multiplier_error(const struct hawser__trial *trial, int i, int m, double far)
{
	return ANSWER*far + trial->multiplier_error +
	       hawser__factors_error_of(i, trial->log_modulus, trial->argument, m,
	                                trial->product_error);
}

/* Relative error of the Omega of an event at s. */
static double error_of(const struct hawser__bracket *bracket, double s, double tolerance)
{
	const struct hawser__station *at = bracket->at;
	struct hawser__orbit *orbit = bracket->orbit;
	const struct hawser__trial *last = &bracket->trial[bracket->trials - 1];
	int m = orbit->m, i;
	double omega = at->y[orbit->size - 1], far, slow, argument;

	if (bracket->kind == HAWSER_FOLD)
		return fmin(1.0, SHARE*orbit->ops->error(orbit, at->correction.residual) + tolerance);
	if (bracket->trials == 0)
		return 1.0;
	far = orbit_error(bracket);
	i = critical(last->log_modulus, last->argument, m, bracket->kind);
	argument = i < 0 ? bracket->kind == HAWSER_PERIOD_DOUBLING ? M_PI : 0.0 : last->argument[i];
	i = i < 0 ? nearest(last, argument, m) : i;
	slow = slowness(bracket, s, omega, argument);
	if (slow < 0.0)
		slow = end_slowness(bracket, omega, argument);
	return fmin(1.0, SHARE*far + tolerance + bracket->uncertain +
	                 multiplier_error(last, i, m, far)*slow);
}

enum hawser_status hawser__locate(struct hawser_frf_event *event, int *found,
                                  struct hawser__orbit *orbit,
                                  struct hawser__station *scratch,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  enum hawser_event_kind kind, double orbit_tolerance,
                                  double tolerance, struct hawser_report *report)
{
	struct hawser__bracket bracket;
	int last = orbit->size - 1;
	double s, f;
	enum hawser_status status = hawser__bracket_init(&bracket, orbit, scratch, a, b, kind, report);

	bracket.tolerance = orbit_tolerance;
	if (!status)
		status = hawser__bracket_zero(&bracket, &s, &f, tolerance, report);
	if (!status) {
		*found = fabs(f) < ZERO && (kind != HAWSER_TORUS || scratch->complex_nearest);
		*event = (struct hawser_frf_event){.kind = kind, .omega = scratch->y[last],
			.arc = a->arc + s*(b->arc - a->arc), .residual = fabs(f),
			.error = error_of(&bracket, s, tolerance)};
	}
	hawser__bracket_clear(&bracket);
	return status;
}

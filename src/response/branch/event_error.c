/* response/branch/event_error.c - see event_error.h.
 *
 *    g    test function, scaled as in bracket.h; g = 0 at the event
 *    s    position between the two stations, 0 to 1
 *
 * The event is located on a discretised branch. The point at the same s is computed again on a
 * discretisation whose error is at least ten times smaller. To first order the error of the event
 * has these parts:
 *
 *    error of g divided by the slope of g by s,          times dOmega/ds    (0 for a fold)
 *    error of Omega at the same s
 *    g at the end of the search over its slope,          times dOmega/ds    (half of it for a fold)
 *    round-off of the orbit and of the multipliers, which the comparison does not show
 *
 * The slopes are taken from the trials of the search. At a branch point the Jacobian of the orbit
 * is singular. Both points are therefore computed beside it, where g is a certain fraction of its
 * values at the ends.
 *
 * If the finer discretisation has no orbit there, the error is bounded by the possible errors of
 * the orbit and the multipliers: the error of the multiplier nearest to the unit circle, divided by
 * its derivative with respect to Omega. The same bound is used if undecided multipliers (station.h)
 * show only where one is certainly outside; it then refers to the multiplier that leaves the
 * circle, and includes the distance from the collision at which it leaves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "response/branch/event_error.h"
#include "response/floquet/monodromy.h"

/* Safety factor on the differences, which are first-order estimates; from bench/estimates events. */
#define SAFETY 3.0
/* Least |g| of a trial for a slope, relative to the larger value at the ends: below it round-off
 * prevails; chosen. */
#define SLOPE 1e-3
#define BESIDE 0.05 /* the same for the comparison beside a branch point, and relative to the
                     * bracket; chosen */
#define ENOUGH 1e-5  /* least change of a multiplier's logarithm for a slope; chosen, above the
                      * errors of multipliers */
/* Relative error of Omega at an event over the relative error of the orbit (the distance from the
 * branch): an orbit that is wrong by its own size shifts Omega by W, a twentieth of it (method.h). */
#define SHARE 0.05
/* Error of a multiplier over the error of its orbit, in the bound. */
#define ANSWER 10.0

/* --- the slope of the test function --- */

struct slope {
	double s;     /* derivative of s by g */
	double omega; /* relative derivative of Omega by g */
};

/* Change of Omega from `omega`, relative. */
static double part(const struct hawser__bracket *bracket, double at, double omega)
{
	return (at - omega)/fmax(fabs(omega), bracket->orbit->floor);
}

static void take(struct slope *slope, double ds, double df, double domega)
{
	slope->s = fmax(slope->s, fabs(ds/df));
	slope->omega = fmax(slope->omega, fabs(domega/df));
}

/* From the nearest trials on both sides, or the ends of the bracket; the larger of the two. */
static struct slope slope_at(const struct hawser__bracket *bracket, double s, double f, double omega)
{
	struct slope slope = {0.0, 0.0};
	int last = bracket->orbit->size - 1;

	for (int side = 0; side < 2; side++) {
		const struct hawser__station *end = side ? bracket->b : bracket->a;
		const struct hawser__bracket_trial *best = NULL;

		for (int i = 0; i < bracket->trials; i++) {
			const struct hawser__bracket_trial *trial = &bracket->trial[i];

			if ((trial->s > s) == side && trial->s != s && fabs(trial->f - f) >= SLOPE &&
			    (!best || fabs(trial->s - s) < fabs(best->s - s)))
				best = trial;
		}
		if (best)
			take(&slope, best->s - s, best->f - f, part(bracket, best->omega, omega));
		else
			take(&slope, side - s, hawser__bracket_value(bracket, end) - f,
			     part(bracket, end->y[last], omega));
	}
	return slope;
}

/* --- multipliers --- */

/* Index of the multiplier nearest to the unit circle among those that belong to an event of this
 * kind, or -1. */
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
static int nearest(const struct hawser__bracket_trial *trial, double argument, int m)
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

/* Relative change of Omega per change of the logarithm of the critical multiplier: the larger value
 * of the nearest trials on both sides of the event; negative if no trial is far enough away. */
static double slowness(const struct hawser__bracket *bracket, double s, double omega, double argument)
{
	double near[2] = {INFINITY, INFINITY}, slow[2] = {-1.0, -1.0};

	for (int i = 0; i < bracket->trials; i++) {
		const struct hawser__bracket_trial *trial = &bracket->trial[i];
		int side = trial->s > s;
		double change = fabs(trial->log_modulus[nearest(trial, argument, bracket->orbit->m)]);

		if (change < ENOUGH || fabs(trial->s - s) >= near[side])
			continue;
		near[side] = fabs(trial->s - s);
		slow[side] = fabs(part(bracket, trial->omega, omega))/change;
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
		struct hawser__bracket_trial trial = {.log_modulus = end[i]->log_modulus,
			.argument = end[i]->argument};
		int k = nearest(&trial, argument, bracket->orbit->m);

		slow = fmax(slow, fabs(part(bracket, end[i]->y[last], omega))/
		                  fmax(fabs(end[i]->log_modulus[k]), ENOUGH));
	}
	return slow;
}

/* Relative change of Omega by an error `far` of the logarithm of the critical multiplier and an
 * error `loss` of the matrix whose eigenvalue it is. The latter shifts it the more, the nearer
 * another multiplier is. */
/* Index of the multiplier that an event of this kind moves outside the unit circle, and *at, the
 * nearest trial that shows it; -1 if no trial does. */
static int leaving(const struct hawser__bracket_trial **at, const struct hawser__bracket *bracket,
                   double s)
{
	int m = bracket->orbit->m, best = -1;
	double near = INFINITY;

	for (int t = 0; t < bracket->trials; t++) {
		const struct hawser__bracket_trial *trial = &bracket->trial[t];
		int found = -1;

		for (int i = 0; i < m; i++) {
			double angle = fabs(trial->argument[i]);
			int minus = angle >= M_PI, fits = bracket->kind == HAWSER_PERIOD_DOUBLING
			                                  ? minus : angle != 0.0 && !minus;

			if (fits && trial->log_modulus[i] >= ENOUGH &&
			    (found < 0 || trial->log_modulus[i] < trial->log_modulus[found]))
				found = i;
		}
		if (found >= 0 && fabs(trial->s - s) < near) {
			near = fabs(trial->s - s);
			best = found;
			*at = trial;
		}
	}
	return best;
}

static double by_multiplier(const struct hawser__bracket *bracket, double s, double omega, double far,
                            double loss)
{
	const struct hawser__bracket_trial *last = &bracket->trial[bracket->trials - 1];
	const struct hawser__bracket_trial *at = NULL;
	int k, m = bracket->orbit->m, i = critical(last->log_modulus, last->argument, m, bracket->kind);
	double argument = i < 0 ? bracket->kind == HAWSER_PERIOD_DOUBLING ? M_PI : 0.0
	                        : last->argument[i];
	double slow;

	if (bracket->sure && (k = leaving(&at, bracket, s)) >= 0) {
		i = k;
		last = at;
		argument = at->argument[k];
	}
	slow = slowness(bracket, s, omega, argument);
	i = i < 0 ? nearest(last, argument, m) : i;
	if (slow < 0.0)
		slow = end_slowness(bracket, omega, argument);
	return slow*(far + hawser__factors_error_of(i, last->log_modulus, last->argument, m, loss));
}

/* --- multipliers that leave the unit circle by a root --- */

/* Largest logarithm of a modulus that an event of this kind makes. */
static double growth(const double *log_modulus, const double *argument, int m,
                     enum hawser_event_kind kind)
{
	double most = 0.0;

	for (int i = 0; i < m; i++) {
		double angle = fabs(argument[i]);
		int minus = angle >= M_PI, fits = kind == HAWSER_PERIOD_DOUBLING ? minus
		                                  : angle != 0.0 && !minus;

		if (fits)
			most = fmax(most, log_modulus[i]);
	}
	return most;
}

/* A point at which a multiplier is outside the circle: relative distance from the event, and growth. */
struct outside {
	double omega, growth;
};

/* The nearer one of two points at which the growth is twice e at least, else the one with the larger
 * growth. */
static void prefer(struct outside *best, double omega, double growth, double e)
{
	int known = best->growth >= 2.0*e && best->growth > 0.0, fits = growth >= 2.0*e;

	if (growth > 0.0 && (fits ? !known || omega < best->omega
	                          : !known && growth > best->growth))
		*best = (struct outside){omega, growth};
}

/* Multipliers that collide on the unit circle of an undamped model leave it with the square root of
 * the distance: the square of the growth is proportional to the distance from the collision. The
 * event of a sure test is where the growth exceeds its error e, so that its distance from the
 * collision is to that of another point as e^2 is to the square of the growth there, less e^2.
 * Returns this distance, relative, of Omega; 0 where no trial is outside. */
static double beyond_collision(const struct hawser__bracket *bracket, double omega)
{
	const struct hawser__station *end[2] = {bracket->a, bracket->b};
	const struct hawser__bracket_trial *last = &bracket->trial[bracket->trials - 1];
	double e = sqrt(last->product_error) + last->multiplier_error;
	struct outside best = {0.0, 0.0};
	int m = bracket->orbit->m;

	for (int i = 0; i < bracket->trials; i++) {
		const struct hawser__bracket_trial *at = &bracket->trial[i];

		prefer(&best, fabs(part(bracket, at->omega, omega)),
		       growth(at->log_modulus, at->argument, m, bracket->kind), e);
	}
	for (int i = 0; i < 2; i++)
		prefer(&best, fabs(part(bracket, end[i]->y[bracket->orbit->size - 1], omega)),
		       growth(end[i]->log_modulus, end[i]->argument, m, bracket->kind), e);
	return best.growth > 0.0 ? best.omega*e*e/fmax(best.growth*best.growth - e*e, 0.25*e*e) : 0.0;
}

/* --- the bound --- */

/* The error of the orbit that the search ended at, if it is that of the last trial, as in a station. */
static void set_error(const struct hawser__bracket *bracket)
{
	struct hawser__orbit *orbit = bracket->orbit;
	struct hawser__station *at = bracket->at;
	int own = bracket->kind != HAWSER_FOLD && bracket->failures == 0;

	at->error = own ? orbit->ops->error(orbit, at->correction.residual) : INFINITY;
	at->round_off = own ? orbit->round_off : INFINITY;
}

static double bound(const struct hawser__bracket *bracket, double s, double omega)
{
	struct hawser__orbit *orbit = bracket->orbit;
	const struct hawser__bracket_trial *last = &bracket->trial[bracket->trials - 1];
	double far, beyond = 0.0;

	if (bracket->kind == HAWSER_FOLD)
		return SHARE*orbit->ops->error(orbit, bracket->at->correction.residual);
	if (bracket->trials == 0)
		return 1.0;
	far = fmin(bracket->at->error, fmin(bracket->a->error, bracket->b->error));
	if (bracket->sure && bracket->kind != HAWSER_BRANCH_POINT)
		beyond = beyond_collision(bracket, omega);
	return SHARE*far + by_multiplier(bracket, s, omega, ANSWER*far + last->multiplier_error,
	                                 last->product_error) + beyond;
}

/* Relative error of Omega by round-off of the most accurate orbit. Near a branch point the orbit is
 * ill-conditioned, but only along the other branch, which changes Omega in second order. */
static double round_off_of(const struct hawser__bracket *bracket)
{
	if (bracket->kind == HAWSER_FOLD) /* the orbit for which bound() was called */
		return SHARE*bracket->orbit->round_off;
	return SHARE*fmin(bracket->at->round_off, fmin(bracket->a->round_off, bracket->b->round_off));
}

/* --- the comparison --- */

/* A point of the branch. */
struct place {
	double s, f, omega;
};

/* The point beside a branch point at which the two discretisations are compared: the nearest trial
 * at which the test function is large enough, or a point towards the farther end. */
static double beside(const struct hawser__bracket *bracket, double s)
{
	double best = s < 0.5 ? s + BESIDE : s - BESIDE, least = INFINITY;

	for (int i = 0; i < bracket->trials; i++) {
		const struct hawser__bracket_trial *trial = &bracket->trial[i];

		if (fabs(trial->f) >= BESIDE && fabs(trial->s - s) < least) {
			least = fabs(trial->s - s);
			best = trial->s;
		}
	}
	return best;
}

/* The point at s by station `at`, with one more Newton step than the corrector takes: otherwise
 * both discretisations would have the same residual, and the difference would not show it. *found
 * is 0 if there is none. */
static enum hawser_status point(struct place *place, int *found, struct hawser__bracket *bracket,
                                double s, struct hawser__station *at, struct hawser_report *report)
{
	struct hawser__orbit *orbit = bracket->orbit;
	enum hawser_status status = HAWSER_OK;

	*found = !hawser__station_inside(at, orbit, bracket->a, bracket->b, s, bracket->tolerance);
	if (!*found)
		return HAWSER_OK;
	orbit->ops->solve(orbit, orbit->step, 0, 0.0);
	for (int i = 0; i < orbit->size; i++)
		at->y[i] += orbit->step[i];
	at->correction.residual = orbit->ops->defects(orbit, at->y, 1);
	*found = isfinite(at->correction.residual) && !orbit->ops->factor(orbit, at->t);
	if (*found && bracket->kind == HAWSER_FOLD)
		hawser__station_turn(at, orbit, bracket->a->t, NULL);
	else if (*found)
		status = hawser__station_finish(at, orbit, bracket->a->t, report);
	if (status == HAWSER_ERR_CONVERGENCE) {
		*found = 0;
		return HAWSER_OK;
	}
	*place = (struct place){s, hawser__bracket_value(bracket, at), at->y[orbit->size - 1]};
	return status;
}

/* Differences of g and (relative) of Omega between the two discretisations; *found is 0 if the
 * finer one has no orbit. */
static enum hawser_status compare(struct place *difference, int *found,
                                  struct hawser__bracket *bracket, double s, double f,
                                  struct hawser__station *at, struct hawser_report *report)
{
	struct hawser__orbit *orbit = bracket->orbit;
	struct place here = {s, f, bracket->at->y[orbit->size - 1]}, finer = here;
	enum hawser_status status = HAWSER_OK, back;

	*found = 1;
	if (bracket->kind == HAWSER_BRANCH_POINT || bracket->failures > 0)
		status = point(&here, found, bracket, beside(bracket, s), at, report);
	if (status || !*found)
		return status;
	*found = 0;
	status = orbit->ops->sharpen(orbit, 1, report);
	if (status)
		return status == HAWSER_ERR_CONVERGENCE ? HAWSER_OK : status;
	status = point(&finer, found, bracket, here.s, at, report);
	*difference = (struct place){s, fabs(finer.f - here.f),
	                             fabs(part(bracket, finer.omega, here.omega))};
	back = orbit->ops->sharpen(orbit, 0, report);
	return status ? status : back;
}

/* First-order error estimate from the differences. */
static double estimate(const struct hawser__bracket *bracket, double s, double f, double omega,
                       double round_off, const struct place *difference)
{
	const struct hawser__station *at = bracket->at;
	const struct hawser__bracket_trial *last = &bracket->trial[bracket->trials - 1];
	struct slope slope = slope_at(bracket, s, f, omega);
	double left_out;

	if (bracket->kind == HAWSER_FOLD) {
		double arc = bracket->b->arc - bracket->a->arc;
		double rate = part(bracket, omega + at->t[bracket->orbit->size - 1], omega);

		return SAFETY*difference->omega + round_off + 0.5*fabs(rate*arc*f)*slope.s;
	}
	left_out = last->multiplier_error > 0.0 ? HAWSER__SHARPER : 0.0;
	return SAFETY*(difference->f*slope.omega + difference->omega) + fabs(f)*slope.omega +
	       round_off + by_multiplier(bracket, s, omega, left_out,
	                                 last->product_round_off);
}

enum hawser_status hawser__event_error(double *error, struct hawser__bracket *bracket, double s,
                                       double f, struct hawser_report *report)
{
	struct hawser__orbit *orbit = bracket->orbit;
	struct hawser__station finer;
	struct place difference = {0.0, 0.0, 0.0};
	double omega = bracket->at->y[orbit->size - 1], most, round_off;
	int found = 0;
	enum hawser_status status = hawser__station_init(&finer, orbit, report);

	set_error(bracket);
	most = bound(bracket, s, omega);
	round_off = round_off_of(bracket);
	if (!status && !bracket->sure)
		status = compare(&difference, &found, bracket, s, f, &finer, report);
	if (found)
		most = estimate(bracket, s, f, omega, round_off, &difference);
	if (!status)
		(void)orbit->ops->defects(orbit, bracket->at->y, 1);
	hawser__station_clear(&finer);
	*error = fmin(1.0, most + bracket->uncertain);
	return status;
}

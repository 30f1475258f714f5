/* response/locate.c - see locate.h.
 *
 * s in [0, 1] runs along the cubic through both stations; every trial point is corrected onto the
 * branch and gets multipliers of its own, so nothing is interpolated in the answer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "core/report.h"
#include "response/flow.h"
#include "response/locate.h"

#define MAX_TRIALS 60
#define ENOUGH 1e-5 /* of a multiplier's logarithm, for a slope */
/* Of the orbit's distance from the branch, by which Omega, relative, may be off at an event: an orbit
 * that is off by its own size moves Omega by W, a twentieth of it (method.h). */
#define SHARE 0.05
/* By how much more than its orbit a multiplier is off (bench/estimates events), and by how much
 * anyway. */
#define ANSWER 10.0
#define MULTIPLIER 1e-6

int hawser__event_width(enum hawser_event_kind kind)
{
	return kind == HAWSER_TORUS ? 2 : 1;
}

struct search {
	struct hawser__orbit *orbit;
	struct hawser__station *at;
	const struct hawser__station *a, *b;
	enum hawser_event_kind kind;
	double tolerance; /* of the corrector */
	double scale;     /* logarithm by which test values are scaled */
	double beside, modulus; /* Omega of a trial near the event, and its multiplier's logarithm */
};

static double scaled(const struct search *search, const struct hawser__station *station)
{
	const struct hawser__test *test = &station->test[search->kind];

	return test->sign*exp(fmin(test->log - search->scale, 700.0));
}

/* Corrected point at s, and the scaled value of its test. */
static enum hawser_status trial(double *value, struct search *search, double s,
                                struct hawser_report *report)
{
	struct hawser__station *at = search->at;
	enum hawser_status status;
	double *row = at->t;

	hawser__station_between(at->y, row, search->a, search->b, s, search->orbit);
	if (hawser__orbit_correct(search->orbit, at->y, &at->correction, row,
	                             search->tolerance))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf",
		                       at->correction.iterations, at->correction.residual,
		                       "the corrector failed near Omega %.9g%s while locating an event",
		                       HAWSER_SHOWN(search->orbit->rom,
		                                    search->a->y[search->orbit->size - 1]));
	/* a fold asks for no multipliers */
	if (search->kind == HAWSER_FOLD)
		hawser__station_turn(at, search->orbit, search->a->t);
	else if ((status = hawser__station_finish(at, search->orbit, search->a->t, report)))
		return status;
	*value = scaled(search, at);
	return HAWSER_OK;
}

/* Logarithm of the modulus of the multiplier that is nearest to the unit circle. */
static double nearest(const struct hawser__station *station, int m)
{
	double best = INFINITY;

	for (int i = 0; i < m; i++)
		if (fabs(station->log_modulus[i]) < fabs(best))
			best = station->log_modulus[i];
	return best;
}

/* Remember the trial nearest to the circle, of those that are far enough for a slope. */
static void keep_beside(struct search *search)
{
	double log_modulus = nearest(search->at, search->orbit->m);

	if (search->kind == HAWSER_FOLD || fabs(log_modulus) < ENOUGH ||
	    (search->beside > 0.0 && fabs(log_modulus) > fabs(search->modulus)))
		return;
	search->beside = search->at->y[search->orbit->size - 1];
	search->modulus = log_modulus;
}

/* The change of Omega, relative, over that of the multiplier which passes the unit circle. */
static double slowness(const struct search *search, double omega, double log_modulus)
{
	double here = search->at->y[search->orbit->size - 1];

	return fabs(omega/here - 1.0)/fmax(fabs(log_modulus), 1e-12);
}

/* Relative error of the Omega of an event. Where a multiplier passes the unit circle it is what the
 * multiplier is off by, over how fast it passes, between the bracket's ends or the event and a
 * trial near it, whichever is slower; it answers an orbit that is off by e by some times e. */
static double error_of(const struct search *search, double tolerance)
{
	struct hawser__orbit *orbit = search->orbit;
	const struct hawser__station *a = search->a, *b = search->b;
	int last = orbit->size - 1, m = orbit->m;
	double far = orbit->ops->error(orbit, search->at->correction.residual), slow;

	if (search->kind == HAWSER_FOLD || search->kind == HAWSER_BRANCH_POINT)
		return fmin(1.0, SHARE*far + tolerance);
	slow = slowness(search, search->at->y[last] + b->y[last] - a->y[last],
	                nearest(b, m) - nearest(a, m));
	if (search->beside > 0.0)
		slow = fmax(slow, slowness(search, search->beside, search->modulus));
	return fmin(1.0, SHARE*far + tolerance +
	                 (ANSWER*far + fmax(MULTIPLIER, orbit->multiplier_error))*slow);
}

enum hawser_status hawser__locate(struct hawser_frf_event *event, int *found,
                                  struct hawser__orbit *orbit,
                                  struct hawser__station *scratch,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  enum hawser_event_kind kind, double orbit_tolerance,
                                  double tolerance, struct hawser_report *report)
{
	struct search search = {orbit, scratch, a, b, kind, orbit_tolerance,
		fmax(a->test[kind].log, b->test[kind].log), 0.0, 0.0};
	int last = orbit->size - 1;
	double sa = 0.0, sb = 1.0, fa = scaled(&search, a), fb = scaled(&search, b), f = fa, s = 0.0;
	double omega_before = INFINITY;

	/* Regula falsi with the Anderson-Bjorck weight; bisection whenever it would crawl. */
	for (int i = 0; i < MAX_TRIALS; i++) {
		enum hawser_status status;

		s = i%6 == 5 ? 0.5*(sa + sb) : sb - fb*(sb - sa)/(fb - fa);
		if (!(s > sa && s < sb))
			s = 0.5*(sa + sb);
		if ((status = trial(&f, &search, s, report)))
			return status;
		keep_beside(&search);
		if (f == 0.0 || sb - sa < 1e-14 ||
		    (fabs(scratch->y[last] - omega_before) <= 0.1*tolerance*scratch->y[last] &&
		     fabs(f) < 1e-4))
			break;
		omega_before = scratch->y[last];
		if ((f < 0.0) == (fa < 0.0)) {
			double weight = 1.0 - f/fa;

			fb *= weight > 0.0 ? weight : 0.5;
			sa = s;
			fa = f;
		} else {
			double weight = 1.0 - f/fb;

			fa *= weight > 0.0 ? weight : 0.5;
			sb = s;
			fb = f;
		}
	}
	/* Values were scaled by the larger end: at a pole or a jump they do not become small. */
	*found = fabs(f) < 1e-3 && (kind != HAWSER_TORUS || scratch->complex_nearest);
	*event = (struct hawser_frf_event){
		.kind = kind,
		.omega = scratch->y[last],
		.arc = a->arc + s*(b->arc - a->arc),
		.residual = fabs(f),
		.error = error_of(&search, tolerance),
	};
	return HAWSER_OK;
}

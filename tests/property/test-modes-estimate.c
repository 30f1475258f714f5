/* tests/property/test-modes-estimate.c - the stated error against the true one, from shooting in
 * quadruple precision, over random spans: stiff and soft, shallow and deep, level and steep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/modes-shooting.h"
#include "tests/modes-span.h"
#include "tests/tap.h"

enum { SCENES = 30, MODES = 10, TRIED = 2, STEPS = 26 };

/* A small generator, the same on every machine: the 32-bit one of Numerical Recipes. */
static unsigned state = 2385u;

static double uniform(double from, double to)
{
	state = state*1664525u + 1013904223u;
	return from + (to - from)*(state >> 8)/16777216.0;
}

struct tally {
	int checked, under;
	double worst, ratio; /* largest true error, and smallest estimate/true */
};

static void weigh(struct tally *tally, const struct hawser_modes *m)
{
	for (int i = 0; i < TRIED; i++) {
		const struct hawser_mode *mode = m->mode + (int)uniform(0.0, m->n);
		double error;

		shoot_frequency(&m->statics, mode->plane, mode->omega, STEPS, &error);
		tally->checked++;
		tally->worst = fmax(tally->worst, error);
		tally->ratio = fmin(tally->ratio, mode->residual/error);
		if (error > mode->residual) {
			tally->under++;
			printf("# omega %.15g: error %.1e, estimate %.1e (epsilon %.3g, delta %.3g, "
			       "hs %.3g, basis %d)\n", mode->omega, error, mode->residual,
			       m->statics.epsilon, m->statics.delta, m->statics.hs, m->basis);
		}
	}
}

static struct hawser_statics random_span(double deepest)
{
	double epsilon = pow(10.0, uniform(-14.0, -1.0)), delta = pow(10.0, uniform(-6.0, deepest));
	double hs = uniform(0.0, 1.0) < 0.3 ? 0.0 : uniform(-2.0, 2.0);

	return scaled_span(epsilon, delta, hs*fabs(hs)*5.0);
}

CASE(property_modes_estimate)
{
	struct tally converged = {.ratio = HUGE_VAL}, coarse = {.ratio = HUGE_VAL};
	struct hawser_modes m;
	int failed = 0, within = 1, scenes = getenv("HAWSER_LONG") ? 5*SCENES : SCENES;

	for (int i = 0; i < scenes; i++) {
		struct hawser_statics st = random_span(log10(20.0));
		struct hawser_modes_options options = {.n = MODES};

		if (hawser_modes_solve(&m, &st, &options, NULL)) {
			failed++;
			continue;
		}
		for (int k = 0; k < MODES; k++)
			within &= m.mode[k].residual <= 1e-10;
		weigh(&converged, &m);
		hawser_modes_clear(&m);
		options.basis = (int)uniform(12.0, 40.0);
		st = random_span(log10(20.0));
		if (hawser_modes_solve(&m, &st, &options, NULL)) {
			failed++;
			continue;
		}
		weigh(&coarse, &m);
		hawser_modes_clear(&m);
	}
	ok(failed == 0, "%d random spans solved", 2*scenes);
	ok(within, "every estimate meets the default tolerance");
	ok(converged.worst < 1e-12, "true error at the default tolerance: %.1e", converged.worst);
	ok(converged.under == 0, "%d of %d converged frequencies are worse than stated, "
	   "least estimate/error %.2g", converged.under, converged.checked, converged.ratio);
	ok(coarse.worst > 1e-9, "coarse bases have something to estimate: %.1e", coarse.worst);
	ok(coarse.under == 0, "%d of %d coarse frequencies are worse than stated, least "
	   "estimate/error %.2g", coarse.under, coarse.checked, coarse.ratio);
	return done_testing();
}

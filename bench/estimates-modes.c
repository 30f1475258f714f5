/* bench/estimates-modes.c - hawser modes and irvine against shooting (estimates.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "bench/estimates.h"
#include "tests/modes-shooting.h"

enum { STEPS = 26, TRIED = 2 };
/* Relative error above which the root next to a frequency may belong to another mode. */
static const double crudest = 0.02;

static int statics_of(struct hawser_statics *st, struct chance *chance)
{
	double H;
	struct hawser_span span = estimate_span(chance, &H);

	return hawser_statics_solve(st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL) != 0;
}

int estimate_modes(struct tally *tally, struct chance *chance)
{
	int methods = 0, row;
	struct hawser_modes_options options = {.n = chance_int(chance, 1, 12)};
	struct hawser_statics st;
	struct hawser_modes m;
	double how = chance_unit(chance);

	while (hawser_modes_method(methods))
		methods++;
	row = chance_int(chance, 0, methods - 1);
	if (how > 0.6) { /* the default in three scenes of five; otherwise a given basis or another
	                  * method */
		options.basis = chance_int(chance, 12, 40);
		options.method = how > 0.85 ? hawser_modes_method(row)->name : NULL;
	}
	if (statics_of(&st, chance) || hawser_modes_solve(&m, &st, &options, NULL))
		return 1;
	for (int i = 0; i < TRIED; i++) {
		const struct hawser_mode *mode = m.mode + chance_int(chance, 0, m.n - 1);
		double error;

		if (mode->residual > crudest)
			continue;
		shoot_frequency(&st, mode->plane, mode->omega, STEPS, &error);
		tally_note(tally, error, mode->residual,
		           "%s, basis %d, mode %d: epsilon %.2g, delta %.2g, hs %.3g", m.method, m.basis,
		           mode->place, st.epsilon, st.delta, st.hs);
	}
	hawser_modes_clear(&m);
	return 0;
}

/* Two numbers of a short sweep. */
int estimate_irvine(struct tally *tally, struct chance *chance)
{
	struct hawser_irvine_options options = {.points = 3, .n = chance_int(chance, 1, 6)};
	struct hawser_irvine sweep;
	double H;
	struct hawser_span span = estimate_span(chance, &H);

	options.from = H;
	options.to = H*chance_between(chance, 0.8, 0.95);
	if (hawser_irvine_trace(&sweep, &span, &options, NULL))
		return 1;
	for (int i = 0; i < TRIED; i++) {
		int at = chance_int(chance, 0, sweep.stations - 1);
		int b = chance_int(chance, 0, sweep.branches - 1), cell = at*sweep.branches + b;
		const struct hawser_statics *st = &sweep.station[at].statics;
		double unit = st->span.d*sqrt(st->span.rho/st->H), error;

		shoot_frequency(st, sweep.branch[b].plane, sweep.omega[cell]*unit, STEPS, &error);
		tally_note(tally, error, sweep.residual[cell],
		           "branch %d: epsilon %.2g, delta %.2g, hs %.3g", b, st->epsilon, st->delta,
		           st->hs);
	}
	hawser_irvine_clear(&sweep);
	return 0;
}

/* bench/estimates-campbell.c - modes of a travelling cable by hawser campbell and modes, against
 * shooting in extended precision (estimates.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"
#include "tests/gyroscopic-shooting.h"

enum { STEPS = 70, TRIED = 2 };
/* Relative error above which the root next to a frequency may belong to another mode. */
static const double crudest = 0.02;

int estimate_campbell(struct tally *tally, struct chance *chance)
{
	int methods = 0, row;
	struct hawser_modes_options options = {.n = chance_int(chance, 1, 12)};
	struct hawser_motion motion = {.hold = HAWSER_HOLD_TENSION};
	double H, limit, how = chance_unit(chance);
	struct hawser_span span = estimate_span(chance, &H);
	struct hawser_statics st;
	struct hawser_modes m;

	while (hawser_complex_modes_method(methods))
		methods++;
	row = chance_int(chance, 0, methods - 1);
	if (how > 0.7) {
		options.basis = chance_int(chance, 12, 40);
		options.method = how > 0.85 ? hawser_complex_modes_method(row)->name : NULL;
	}
	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL) ||
	    hawser_statics_limit(&limit, &span, HAWSER_GIVEN_T0, st.T0, HAWSER_BRANCH_TAUT, motion.hold,
	                         NULL))
		return 1;
	motion.speed = limit*(chance_unit(chance) < 0.5 ? chance_between(chance, 0.0, 0.999)
	                                                : 1.0 - chance_log(chance, 1e-3, 1.0));
	if (hawser_statics_travel(&st, &span, HAWSER_GIVEN_T0, st.T0, HAWSER_BRANCH_TAUT, &motion, NULL)
	    || hawser_complex_modes_solve(&m, &st, &options, NULL))
		return 1;
	for (int i = 0; i < TRIED; i++) {
		const struct hawser_mode *mode = m.mode + chance_int(chance, 0, m.n - 1);
		double settled;
		double complex right;

		if (mode->residual > crudest)
			continue;
		right = turn_frequency(&st, mode->plane, mode->omega, STEPS, &settled);
		tally_note(tally, cabs(right - mode->omega - I*mode->re)/cabs(right), mode->residual,
		           "%s, basis %d, mode %d: epsilon %.2g, delta %.2g, hs %.3g, speed %.6g of limit",
		           m.method, m.basis, mode->place, st.epsilon, st.delta, st.hs, motion.speed/limit);
	}
	hawser_modes_clear(&m);
	return 0;
}

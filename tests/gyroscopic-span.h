/* tests/gyroscopic-span.h - a travelling span and its modes, for tests.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_GYROSCOPIC_SPAN_H
#define HAWSER_TESTS_GYROSCOPIC_SPAN_H

#include <hawser/gyroscopic.h>
#include <stdio.h>

/* B Table 5.3 (and 5.2): EA, rho, g, d, h; T0. */
static const struct hawser_span table_5_3 = {100e6, 5.0, 9.81, 100.0, 5.0};
static const double T0 = 85e3;

static inline int travel(struct hawser_statics *st, struct hawser_span span, double tension,
                         double speed,
                  enum hawser_hold hold)
{
	struct hawser_motion motion = {.speed = speed, .hold = hold};
	struct hawser_report report;

	if (!hawser_statics_travel(st, &span, HAWSER_GIVEN_T0, tension, HAWSER_BRANCH_TAUT, &motion,
	                           &report))
		return 1;
	printf("# %s\n", report.message);
	return 0;
}

static inline int solve(struct hawser_modes *modes, const struct hawser_statics *st, int n,
                        int basis,
                 const char *method)
{
	struct hawser_modes_options options = {.n = n, .basis = basis, .method = method};
	struct hawser_report report;

	if (!hawser_complex_modes_solve(modes, st, &options, &report))
		return 1;
	printf("# %s\n", report.message);
	return 0;
}

#endif

/* Published and independently computed figures of travelling beams.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/beam.h>

#include "tests/beam-near.h"

static int open(struct hawser_beam_integrals *is, int row, int size)
{
	struct hawser_report report = {0};

	return ok(hawser_beam_method(row)->fill(is, HAWSER_ENDS_SIMPLE, size, &report) == HAWSER_OK,
	          "%s of %d", hawser_beam_method(row)->name, size);
}

/* Dehadrai 2018, chapter 9; each value is also computed here with 30 sines. */
static void dehadrai(void)
{
	static const struct {
		double mu, rho, S, c, v_crit, v_bif, within;
		const char *source;
	} row[] = {
		{1.0, 0.0, 0.0, 0.0, 3.2969, 3.2969, 5e-5, "figure 9.1, level; Wickert and Mote 1990"},
		{1.0, 10.0, 0.0, 0.0, 2.3871, 2.3871, 5e-5, "figure 9.1, upright"},
		{10.0, 0.0, 0.0, 0.0, 10.4819, 10.4819, 5e-5, "section 9.4, level"},
		{10.0, 10.0, 0.0, 0.0, 10.2322, 10.2322, 5e-5, "section 9.4, upright"},
		{1.0, 10.0, 20.0, 0.0, 0.0, 2.358, 5e-4, "figure 9.4: every speed is unstable"},
		{1.0, 10.0, 20.0, 5.0, 2.376, 0.0, 5e-4, "figure 9.5, c = 5 (printed 2.375)"},
		{1.0, 10.0, 20.0, 10.0, 2.434, 0.0, 5e-4, "figure 9.5, c = 10 (printed 2.435)"},
	};
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};

	if (!open(&is, 0, 28))
		return;
	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_beam beam = {.theta = 1.0, .tension = row[i].mu*row[i].mu, .weight = row[i].rho,
			.drag = row[i].c, .rotary = row[i].S > 0.0 ? 1.0/(row[i].S*row[i].S) : 0.0};
		struct hawser_beam_limits limits;
		enum hawser_status status = hawser_beam_limits(&limits, &is, &beam, 5, &report);

		if (!ok(status == HAWSER_OK, "%s: %s", row[i].source, report.message))
			continue;
		near_to(limits.v_crit, row[i].v_crit, row[i].within, "v_crit, %s", row[i].source);
		near_to(limits.v_first, row[i].v_crit, row[i].within, "of the first mode");
		if (row[i].v_bif > 0.0)
			near_to(limits.v_bif, row[i].v_bif, row[i].within, "v_bif");
		else
			ok(limits.v_bif < limits.v_crit, "v_bif %.6g is below v_crit, as D says", limits.v_bif);
	}
	hawser_beam_integrals_clear(&is);
}

/* mu = 20, undamped: divergent from sqrt(400 + pi^2) to sqrt(400 + 4 pi^2), then stable until two
 * frequencies coincide. By two discretisations. */
static void second_stable_region(void)
{
	static const double expected[] = {20.2452365855, 20.9637405442, 21.2787890698};
	static const enum hawser_beam_event_kind kind[] = {HAWSER_BEAM_DIVERGENCE, HAWSER_BEAM_CALM,
	                                                   HAWSER_BEAM_FLUTTER};
	const struct hawser_beam beam = {.theta = 1.0, .tension = 400.0};
	const struct hawser_beam_sweep_options options = {.from = 19.0, .to = 21.9, .points = 20,
	                                                  .branches = 4};
	struct hawser_report report = {0};

	for (int row = 0; row < 2; row++) {
		struct hawser_beam_integrals is;
		struct hawser_beam_sweep sweep;
		enum hawser_status status;

		if (!open(&is, row, row ? 44 : 28))
			continue;
		status = hawser_beam_sweep(&sweep, &is, &beam, &options, &report);
		if (ok(status == HAWSER_OK && sweep.events == 3, "%s: three changes %s",
		       hawser_beam_method(row)->name, report.message))
			for (int i = 0; i < 3; i++)
				ok(sweep.event[i].kind == kind[i] &&
				   fabs(sweep.event[i].speed - expected[i]) < (row ? 2e-4 : 2e-10),
				   "%s at %.12g", hawser_beam_event_name(sweep.event[i].kind),
				   sweep.event[i].speed);
		hawser_beam_sweep_clear(&sweep);
		hawser_beam_integrals_clear(&is);
	}
}

/* D 9.5: growth 0.068 just above the safe speed, in both directions of travel. */
static void growth(void)
{
	static const double speed[] = {3.297, 2.38723}, weight[] = {0.0, 10.0};
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};

	if (!open(&is, 0, 28))
		return;
	for (int i = 0; i < 2; i++) {
		struct hawser_beam beam = {.theta = 1.0, .tension = 1.0, .weight = weight[i],
		        .speed = speed[i]};
		struct hawser_beam_eigenvalue value[2];
		int found = 0;
		enum hawser_status status = hawser_beam_eigenvalues(value, NULL, &found, &is, &beam, 2,
		                                                    &report);

		ok(status == HAWSER_OK && found == 2, "v %g %s", speed[i], report.message);
		near_to(fabs(value[0].re), 0.068, 7e-4, "rho %g: grows at 0.068 (D figures 9.10, 9.11)",
		         weight[i]);
	}
	hawser_beam_integrals_clear(&is);
}

CASE(reference_beam)
{
	dehadrai();
	second_stable_region();
	growth();
	return done_testing();
}

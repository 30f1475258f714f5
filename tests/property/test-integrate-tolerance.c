/* The errors follow the tolerance, the methods agree, and the output times do not change a run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/integrate-models.h"

#define OMEGA 3.2
#define UNTIL 40.0
#define EVERY 0.3125

static double distance(const struct hawser_trajectory *a, const struct hawser_trajectory *b)
{
	double worst = 0.0, size = 0.0;

	for (int i = 0; i < a->rows*2*a->n; i++) {
		worst = fmax(worst, fabs(a->state[i] - b->state[i]));
		size = fmax(size, fabs(b->state[i]));
	}
	return a->rows == b->rows ? worst/size : HUGE_VAL;
}

/* The error at rtol 1e-4, 1e-6, ... 1e-12 against a run at 3e-14 decreases by at least a factor of
 * 10 for each factor of 100, and is at most a stated multiple of the tolerance. */
static void check_convergence(const struct hawser_rom *rom, const char *method, double multiple)
{
	struct hawser_trajectory exact = model_run(rom, "gauss", OMEGA, UNTIL, EVERY, 3e-14, NULL);
	double last = HUGE_VAL;

	for (int digits = 4; digits <= 12; digits += 2) {
		double rtol = pow(10.0, -digits);
		struct hawser_trajectory run = model_run(rom, method, OMEGA, UNTIL, EVERY, rtol, NULL);
		double error = distance(&run, &exact);

		ok(error < 0.1*last && error < multiple*rtol,
		   "%s at 1e-%d: error %.1e, below %.0f times rtol and a tenth of %.1e, in %ld steps",
		   method, digits, error, multiple, last, run.steps);
		last = error;
		hawser_trajectory_clear(&run);
	}
	hawser_trajectory_clear(&exact);
}

/* With 8 nodes the error inside a step is of order h^9: a factor of 10^6 in rtol is a factor of
 * 10^(6/9) = 4.6 in the number of steps. */
static void check_order(void)
{
	const double initial[10] = {0.002, 0.001, 0.0015, -0.001, 0.0005};
	struct hawser_rom rom = model_cable(0.0, 0.0);
	struct hawser_trajectory loose = model_run(&rom, "gauss", 0.0, UNTIL, EVERY, 1e-7, initial);
	struct hawser_trajectory tight = model_run(&rom, "gauss", 0.0, UNTIL, EVERY, 1e-13, initial);
	double ratio = (double)tight.steps/loose.steps;

	ok(ratio > 3.5 && ratio < 6.0, "gauss: steps grow as rtol^(-1/9): %.2f against 4.64", ratio);
	hawser_trajectory_clear(&loose);
	hawser_trajectory_clear(&tight);
	hawser_rom_clear(&rom);
}

static void check_agreement(const struct hawser_rom *rom)
{
	struct hawser_trajectory run[METHODS];

	for (int m = 0; m < METHODS; m++)
		run[m] = model_run(rom, all_methods[m], OMEGA, UNTIL, EVERY, 1e-12, NULL);
	for (int m = 1; m < METHODS; m++)
		ok(distance(&run[0], &run[m]) < (m == METHODS - 1 ? 1e-6 : 1e-8),
		   "gauss and %s agree within %.1e", all_methods[m], distance(&run[0], &run[m]));
	for (int m = 0; m < METHODS; m++)
		hawser_trajectory_clear(&run[m]);
}

/* The integrator chooses its steps without regard to the output times: common rows agree to the
 * last bit, and the rows between are as accurate, by a run with a ten times smaller tolerance. */
static void check_output(const struct hawser_rom *rom)
{
	for (int m = 0; m < METHODS; m++) {
		struct hawser_trajectory coarse = model_run(rom, all_methods[m], OMEGA, UNTIL, EVERY,
		                                            1e-8, NULL);
		struct hawser_trajectory fine = model_run(rom, all_methods[m], OMEGA, UNTIL,
		                                          EVERY/16.0, 1e-8, NULL);
		struct hawser_trajectory exact = model_run(rom, "gauss", OMEGA, UNTIL, EVERY/16.0,
		                                           1e-13, NULL);
		double at_coarse = 0.0, between = 0.0;
		int differing = 0;

		for (int i = 0; i < coarse.rows; i++)
			differing += memcmp(coarse.state + i*10, fine.state + i*160,
			                    10*sizeof *coarse.state) != 0;
		for (int i = 0; i < fine.rows*10; i++) {
			double error = fabs(fine.state[i] - exact.state[i]);

			if (i/10 % 16 == 0)
				at_coarse = fmax(at_coarse, error);
			else
				between = fmax(between, error);
		}
		ok(!differing, "%s: %d rows are the same at sixteen times the output",
		   all_methods[m], coarse.rows);
		ok(between < 3.0*at_coarse, "%s: error %.1e between them, %.1e at them",
		   all_methods[m], between, at_coarse);
		hawser_trajectory_clear(&coarse);
		hawser_trajectory_clear(&fine);
		hawser_trajectory_clear(&exact);
	}
}

CASE(property_integrate_tolerance)
{
	struct hawser_rom rom = model_cable(0.05, 0.0012);

	check_convergence(&rom, "gauss", 30.0);
	check_convergence(&rom, "radau", 300.0);
	check_convergence(&rom, "adams", 500.0);
	check_convergence(&rom, "bdf", 5000.0);
	check_order();
	check_agreement(&rom);
	check_output(&rom);
	hawser_rom_clear(&rom);
	return done_testing();
}

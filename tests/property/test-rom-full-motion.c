/* Motion of the full-order model: without damping and load the energy is conserved, and the free
 * motion converges with the number of functions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/integrate.h>

#include "tests/tap.h"

/* Initial velocities in the three lowest modes, so that the tension increases smoothly, for two
 * periods of the first mode. Results: displacement xyz [3] at mid-span, m, and the largest relative
 * change of the energy. */
static int swing(double *xyz, double *drift, const struct hawser_statics *st, int functions,
                 const char *method)
{
	struct hawser_trajectory run = {0};
	struct hawser_report report = {0};
	struct hawser_rom rom;
	double initial[200] = {0.0}, period;
	struct hawser_integrate_options options = {.method = method, .initial = initial};
	int done;

	if (hawser_rom_build_full(&rom, st, NULL, functions, &report))
		return 0;
	period = 2.0*M_PI/sqrt(rom.K[0]);
	initial[rom.n] = 2.0e-3*sqrt(rom.K[0]);
	initial[rom.n + 1] = 0.3*initial[rom.n];
	initial[rom.n + 2] = 0.1*initial[rom.n];
	options.until = 2.0*period;
	options.every = 0.05*period;
	done = !hawser_integrate(&run, &rom, &options, &report);
	*drift = 0.0;
	for (int i = 0; i < run.rows; i++)
		*drift = fmax(*drift, fabs(run.energy[i]/run.energy[0] - 1.0));
	if (done)
		hawser_rom_displacement(&rom, xyz, 1, run.state + (size_t)(run.rows - 1)*2*(size_t)rom.n);
	for (int i = 0; i < 3; i++)
		xyz[i] *= rom.length;
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return done;
}

CASE(property_rom_full_motion)
{
	static const int functions[3] = {8, 12, 16};
	struct hawser_span span = {1e8, 5.56, 9.81, 300.0, 15.0}; /* B Table 4.4, line 2 */
	struct hawser_statics st;
	int done;
	double at[3][3], drift, error[2] = {0.0}, bdf[3];

	if (!ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_TAUT, NULL),
	        "span"))
		return done_testing();
	for (int i = 0; i < 3; i++) {
		ok(swing(at[i], &drift, &st, functions[i], "gauss"), "%d functions", functions[i]);
		ok(drift < 1e-12, "%d functions: energy is conserved, %.1e", functions[i], drift);
	}
	for (int i = 0; i < 2; i++)
		for (int c = 0; c < 3; c++)
			error[i] = fmax(error[i], fabs(at[i][c] - at[2][c]));
	ok(error[0] > 10.0*error[1] && error[1] < 2e-5 && error[0] > 0.0,
	   "mid-span after two periods, against 16 functions: %.1e m with 8, %.1e m with 12", error[0],
	   error[1]);
	done = swing(bdf, &drift, &st, 8, "bdf");
	ok(done && fabs(bdf[1] - at[0][1]) < 1e-6 &&
	   fabs(bdf[2] - at[0][2]) < 1e-6, "another integrator: %.1e, %.1e m", bdf[1] - at[0][1],
	   bdf[2] - at[0][2]);
	return done_testing();
}

/* The cascade of period doublings of u'' + 0.4 u' + u - u^2 =
	0.25 cos(Omega t): the distances of successive
 * doublings have ratios that tend to Feigenbaum's 4.6692. Motions of b periods are those of a model of
 * b periods (rom.h), and begin where an integration in time ends. To 32 periods with HAWSER_LONG,
	else to 8.
 * M. J. Feigenbaum, J. Stat. Phys. 19 (1978) 25: 4.669201.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

static int make(struct hawser_rom *rom, int b)
{
	*rom = (struct hawser_rom){.n = 1, .quads = 1, .harmonics = 1, .periods = b, .length = 1.0, .time =
	                           1.0,
		.force = 1.0, .K = calloc(1, sizeof(double)), .D = calloc(1, sizeof(double)),
		.Q = calloc(1, sizeof *rom->Q), .harmonic = calloc(1, sizeof *rom->harmonic)};
	if (!rom->K || !rom->D || !rom->Q || !rom->harmonic)
		return 0;
	rom->harmonic[0] = (struct hawser_harmonic){.k = b, .f = calloc(1, sizeof(double))};
	if (!rom->harmonic[0].f)
		return 0;
	rom->K[0] = 1.0;
	rom->D[0] = 0.4;
	rom->Q[0].value = -1.0;
	rom->harmonic[0].f[0] = 0.25;
	return !hawser_rom_compile(rom, NULL);
}

/* The motion to which the state x [2] leads at omega. */
static int settle(double *x, const struct hawser_rom *rom, double omega, int b)
{
	double until = (400 + 100*b)*2.0*M_PI/omega;
	struct hawser_trajectory run;
	int fine = !hawser_integrate(&run, rom, &(struct hawser_integrate_options){.omega = omega,
	                             .until = until, .every = until, .rtol = 1e-9, .initial = x}, NULL);

	if (fine)
		memcpy(x, run.state + 2*(size_t)(run.rows - 1), 2*sizeof *x);
	hawser_trajectory_clear(&run);
	return ok(fine, "a motion of %d periods", b);
}

/* The first period doubling on the way from `from` to `to`, or 0. */
static double doubling(const struct hawser_rom *rom, const double *start, double from, double to)
{
	struct hawser_report report = {.message = ""};
	struct hawser_frf frf;
	double found = 0.0;

	ok(!hawser_frf_trace(&frf, rom, &(struct hawser_frf_options){.from = from, .to = to, .start = start,
	                     .step_max = 0.1, .method = "shooting", .samples = HAWSER_NONE}, &report),
	   "followed %s", report.message);
	for (int e = 0; e < frf.events && found == 0.0; e++)
		if (frf.event[e].kind == HAWSER_PERIOD_DOUBLING)
			found = frf.event[e].omega;
	hawser_frf_clear(&frf);
	return found;
}

CASE(reference_feigenbaum)
{
	double x[2] = {0.0}, at[8] = {0.0}, gap = 0.05, ratio = 0.0;
	int last = getenv("HAWSER_LONG") ? 6 : 4;

	for (int k = 0; k <= last; k++) {
		double from = k ? at[k - 1] - 0.5*gap : 1.2;
		struct hawser_rom rom;

		if (!ok(make(&rom, 1 << k), "a model") || (k && !settle(x, &rom, from, 1 << k)))
			return done_testing();
		at[k] = doubling(&rom, k ? x : NULL, from, k ? from - 1.2*gap : 0.82);
		hawser_rom_clear(&rom);
		if (!ok(at[k] > 0.0, "period doubling at %.12g", at[k]))
			return done_testing();
		if (k > 1)
			ratio = (at[k - 2] - at[k - 1])/(at[k - 1] - at[k]);
		gap = k ? (at[k - 1] - at[k])/4.669 : gap;
	}
	if (last == 6)
		close_to(ratio, 4.669201, 4e-4, "Feigenbaum's ratio");
	else
		close_to(ratio, 4.669201, 6e-3, "Feigenbaum's ratio");
	return done_testing();
}

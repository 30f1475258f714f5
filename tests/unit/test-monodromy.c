/* Multipliers of a linear equation with periodic coefficients: fast coordinates condensed or
 * integrated, an overdamped coordinate, an oscillating damping matrix.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "response/monodromy.h"
#include "rom/model.h"
#include "tests/tap.h"

/* Two coordinates and a stiff third one: with steps that resolve all of them, and with the third
 * one condensed. */
static void check_condensed(void)
{
	double log_modulus[2][6], argument[2][6], omega = 2.17, T[5*9] = {0.0};
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;
	const double follow[2] = {INFINITY, 20.0}, w = 57.0;
	int steps[2];

	if (hawser__rom_init(&rom, 3, NULL) || hawser__monodromy_init(&monodromy, 3, NULL))
		return;
	for (int j = 0; j < 3; j++)
		rom.D[4*j] = 0.04;
	for (int i = 0; i < 2; i++) {
		double *mean = T, *cosine = T + 9, *sine = T + 2*9;

		mean[0] = 2.0*1.21;
		mean[4] = 2.0*4.3;
		mean[8] = 2.0*w*w;
		mean[1] = mean[3] = 0.2;
		cosine[0] = 0.3;
		cosine[4] = -0.4;
		cosine[1] = cosine[3] = 0.25;
		sine[4] = 0.2;
		mean[2] = mean[6] = 8.0;
		cosine[5] = cosine[7] = 60.0;
		sine[8] = 200.0;
		monodromy.steps = 2;
		monodromy.follow = follow[i];
		if (!ok(!hawser__monodromy_multipliers(&monodromy, log_modulus[i], argument[i], &rom,
		                                       T, 2, omega, NULL), "%s",
		        i ? "condensed" : "followed"))
			return;
		steps[i] = monodromy.steps;
	}
	ok(steps[1] < steps[0]/3, "%d steps, condensed %d", steps[0], steps[1]);
	for (int i = 0; i < 2; i++) {
		double sum = 0.0;

		for (int j = 0; j < 6; j++)
			sum += log_modulus[i][j];
		ok(fabs(sum + 0.12*2.0*M_PI/omega) < (i ? 1e-7 : 1e-11), "Liouville's sum: %.1e",
		   sum + 0.12*2.0*M_PI/omega);
	}
	ok(log_modulus[0][0] > 0.01, "unstable: %g", log_modulus[0][0]);
	for (int j = 0; j < 6; j++)
		ok(fabs(log_modulus[0][j] - log_modulus[1][j]) < 1e-5, "modulus %d: %g, condensed "
		   "%+.1e", j, log_modulus[0][j], log_modulus[1][j] - log_modulus[0][j]);
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

/* u'' + (24 + 10 sin t) u' + 10 cos t u = 0 has the exponents 0 and -24: u' + (24 + 10 sin t) u is
 * constant. */
static void check_overdamped(void)
{
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;
	double log_modulus[2], argument[2], T[3] = {0.0, 10.0, 0.0};

	if (hawser__rom_init(&rom, 1, NULL) || hawser__monodromy_init(&monodromy, 1, NULL))
		return;
	rom.D[0] = 24.0;
	rom.harmonics = 1;
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic[0] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN,
		.D = calloc(1, sizeof(double))};
	rom.harmonic[0].D[0] = 10.0;
	ok(!hawser__monodromy_multipliers(&monodromy, log_modulus, argument, &rom, T, 1, 1.0, NULL),
	   "multipliers in %d steps", monodromy.steps);
	ok(fabs(log_modulus[0]) < 1e-9 && argument[0] == 0.0, "exponent 0: %.1e", log_modulus[0]);
	ok(fabs(log_modulus[1]/(2.0*M_PI) + 24.0) < 1e-9, "exponent -24: %.12g",
	   log_modulus[1]/(2.0*M_PI));
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

int main(void)
{
	check_condensed();
	check_overdamped();
	return done_testing();
}

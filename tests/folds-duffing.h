/* tests/folds-duffing.h - the Duffing oscillator for tests of folds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_FOLDS_DUFFING_H
#define HAWSER_TESTS_FOLDS_DUFFING_H

#include <stdlib.h>

#include "rom/build/model.h"

/* u'' + d u' + u + c u^3 = f cos(Omega t) */
static inline int duffing(struct hawser_rom *rom, double d, double c, double f)
{
	if (hawser__rom_init(rom, 1, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->D[0] = d;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, c};
	rom->cubics = c != 0.0;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc(1, sizeof(double))};
	rom->harmonic[0].f[0] = f;
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

#endif

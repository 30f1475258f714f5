/* tests/rom-entries.h - coefficients of models. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_ROM_ENTRIES_H
#define HAWSER_TESTS_ROM_ENTRIES_H

#include <math.h>

#include <hawser/rom.h>

static inline double quad_of(const struct hawser_rom *rom, int j, int k, int l)
{
	for (int i = 0; i < rom->quads; i++)
		if (rom->Q[i].j == j && rom->Q[i].k == k && rom->Q[i].l == l)
			return rom->Q[i].value;
	return 0.0;
}

static inline double cubic_of(const struct hawser_rom *rom, int j, int k, int l, int m)
{
	for (int i = 0; i < rom->cubics; i++)
		if (rom->C[i].j == j && rom->C[i].k == k && rom->C[i].l == l && rom->C[i].m == m)
			return rom->C[i].value;
	return 0.0;
}

/* The cubic coefficient of a mode with what the other modes, that answer statically, add to it. */
static inline double condensed_cubic(const struct hawser_rom *rom, int mode)
{
	double C = cubic_of(rom, mode, mode, mode, mode);

	for (int j = 0; j < rom->n; j++)
		if (j != mode)
			C -= 2.0*pow(quad_of(rom, j, mode, mode), 2)/rom->K[j*(rom->n + 1)];
	return C;
}

#endif

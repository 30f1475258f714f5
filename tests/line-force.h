/* Forces of a model of a rope over sheaves at a moment, its load and known motions included.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LINE_FORCE_H
#define HAWSER_TESTS_LINE_FORCE_H

#include <math.h>

#include <hawser/line_rom.h>

#include "rom/terms/vary.h"

/* Force of the model at u, less the load, and its stiffness. */
static inline void force_of(double *R, double *T, const struct hawser_rom *rom, const double *u,
                            double tau)
{
	int n = rom->n;

	hawser_rom_tangent(rom, R, T, u);
	hawser__rom_vary_at(rom, R, T, u, tau);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *one = &rom->harmonic[h];
		double wave = one->phase == HAWSER_COS ? cos(one->k*tau) : sin(one->k*tau);

		for (int j = 0; j < n; j++) {
			for (int k = 0; one->K && k < n; k++) {
				R[j] += wave*one->K[j*n + k]*u[k];
				T[j*n + k] += wave*one->K[j*n + k];
			}
			R[j] -= one->f ? wave*one->f[j] : 0.0;
		}
	}
}

#endif

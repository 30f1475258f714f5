/* tests/balance-model.h - a model with every kind of term, and an orbit that does not satisfy it:
 * for tests of harmonic balance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_BALANCE_MODEL_H
#define HAWSER_TESTS_BALANCE_MODEL_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/balance.h"
#include "rom/build/model.h"

static inline void add_harmonic(struct hawser_rom *rom, struct hawser_harmonic harmonic,
                                const double *f, const double *D, const double *K)
{
	size_t n = (size_t)rom->n;

	if (f)
		memcpy(harmonic.f = calloc(n, sizeof *f), f, n*sizeof *f);
	if (D)
		memcpy(harmonic.D = calloc(n*n, sizeof *D), D, n*n*sizeof *D);
	if (K)
		memcpy(harmonic.K = calloc(n*n, sizeof *K), K, n*n*sizeof *K);
	rom->harmonic = realloc(rom->harmonic, ((size_t)rom->harmonics + 1)*sizeof harmonic);
	rom->harmonic[rom->harmonics++] = harmonic;
}

/* A model with all terms: no symmetry, gyroscopic damping, loads and parametric terms of several
 * harmonics, phases and powers of Omega. */
static inline int make_general(struct hawser_rom *rom)
{
	if (hawser__rom_init(rom, 2, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->K[1] = 0.13;
	rom->K[3] = 4.1;
	rom->D[0] = 0.05;
	rom->D[1] = 0.2;
	rom->D[2] = -0.17;
	rom->D[3] = 0.11;
	rom->quads = 2;
	rom->Q = calloc(2, sizeof *rom->Q);
	rom->Q[0] = (struct hawser_quad){0, 0, 1, 1.0};
	rom->Q[1] = (struct hawser_quad){1, 0, 0, 0.4};
	rom->cubics = 2;
	rom->C = calloc(2, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, 0.7};
	rom->C[1] = (struct hawser_cubic){1, 0, 0, 1, 0.3};
	add_harmonic(rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS, .omega_power = 1},
	             (double[]){0.3, -0.2}, (double[]){0.01, 0.03, -0.02, 0.04},
	             (double[]){0.05, 0.02, 0.01, -0.06});
	add_harmonic(rom, (struct hawser_harmonic){.k = 2, .phase = HAWSER_SIN, .omega_power = 2},
	             (double[]){-0.11, 0.07}, (double[]){0.02, -0.01, 0.03, 0.05},
	             (double[]){0.03, -0.04, 0.02, 0.02});
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* Activate all pairs up to `order`. */
static inline int activate(struct hawser__balance *balance, int order)
{
	memset(balance->active, 0, ((size_t)balance->top + 1)*balance->base.n);
	memset(balance->active, 1, ((size_t)order + 1)*balance->base.n);
	return hawser__balance_arrange(balance, NULL) != HAWSER_OK;
}

/* Coefficients that decrease up to harmonic `order`, and Omega. */
static inline double *some_orbit(const struct hawser__balance *balance, int order, double omega)
{
	double *y = calloc((size_t)balance->base.size, sizeof *y);

	for (int i = 0; i < (2*order + 1)*balance->base.n; i++)
		y[i] = 0.8*cos(2.385*i + 0.3)*exp(-0.2*i);
	y[balance->base.size - 1] = omega;
	return y;
}

#endif

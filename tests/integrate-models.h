/* tests/integrate-models.h - reduced models built by hand for the tests of time integration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_INTEGRATE_MODELS_H
#define HAWSER_TESTS_INTEGRATE_MODELS_H

#include <stdint.h>
#include <stdlib.h>

#include <hawser/integrate.h>

#include "tests/tap.h"

#define MODEL_ROOM 2000

static const char *const all_methods[] = {"gauss", "radau", "adams", "bdf"};
#define METHODS ((int)(sizeof all_methods/sizeof *all_methods))

/* An empty model of n coordinates with room for entries. */
static inline struct hawser_rom model_new(int n)
{
	struct hawser_rom rom = {.n = n, .length = 1.0, .time = 1.0, .force = 1.0};

	rom.D = calloc((size_t)n*n, sizeof *rom.D);
	rom.K = calloc((size_t)n*n, sizeof *rom.K);
	rom.Q = calloc(MODEL_ROOM, sizeof *rom.Q);
	rom.C = calloc(MODEL_ROOM, sizeof *rom.C);
	if (!rom.D || !rom.K || !rom.Q || !rom.C)
		abort();
	return rom;
}

static inline void model_quad(struct hawser_rom *rom, int j, int k, int l, double value)
{
	rom->Q[rom->quads++] = (struct hawser_quad){j, k, l, value};
}

static inline void model_cubic(struct hawser_rom *rom, int j, int k, int l, int m, double value)
{
	rom->C[rom->cubics++] = (struct hawser_cubic){j, k, l, m, value};
}

/* One harmonic with the load f [n]. */
static inline void model_force(struct hawser_rom *rom, enum hawser_phase phase, int omega_power,
                               const double *f)
{
	size_t size = (size_t)rom->n*sizeof *f;

	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonics = 1;
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .phase = phase, .omega_power = omega_power};
	rom->harmonic[0].f = malloc(size);
	if (!rom->harmonic[0].f)
		abort();
	memcpy(rom->harmonic[0].f, f, size);
}

static inline void model_compile(struct hawser_rom *rom)
{
	struct hawser_report report = {0};

	if (hawser_rom_compile(rom, &report)) {
		printf("Bail out! %s\n", report.message);
		exit(1);
	}
}

/* u'' + d u' + k u + c u^3 = f cos(Omega t); f = 0: no load. */
static inline struct hawser_rom model_oscillator(double d, double k, double c, double f)
{
	struct hawser_rom rom = model_new(1);

	rom.D[0] = d;
	rom.K[0] = k;
	if (c != 0.0)
		model_cubic(&rom, 0, 0, 0, 0, c);
	if (f != 0.0)
		model_force(&rom, HAWSER_COS, 0, &f);
	model_compile(&rom);
	return rom;
}

/* Five modes of a parabolic cable of ratio EA/H 5000 and weight ratio 0.18: two planes, V = sum k^2
 * u^2/2 + e^2/(2 epsilon) with the elongation e = a.u + sum k^2 u^2/2. The scaled size of a chairlift
 * span. */
static inline struct hawser_rom model_cable(double damping, double load)
{
	const double wave[5] = {M_PI, M_PI, 2.0*M_PI, 2.0*M_PI, 3.0*M_PI}, epsilon = 2e-4;
	const double a[5] = {0.0, 0.18*2.0*sqrt(2.0)/M_PI, 0.0, 0.0, 0.0};
	const double f[5] = {load, load, 0.25*load, 0.17*load, 0.33*load};
	struct hawser_rom rom = model_new(5);

	for (int j = 0; j < 5; j++)
		for (int k = 0; k < 5; k++) {
			double kj2 = wave[j]*wave[j], kk2 = wave[k]*wave[k];

			rom.K[j*5 + k] = (j == k ? kj2 : 0.0) + a[j]*a[k]/epsilon;
			rom.D[j*5 + k] = j == k ? damping : 0.0;
			model_quad(&rom, j, k, k, a[j]*kk2/(2.0*epsilon));
			model_quad(&rom, j, j, k, a[k]*kj2/epsilon);
			model_cubic(&rom, j, j, k, k, kj2*kk2/(2.0*epsilon));
		}
	if (load != 0.0)
		model_force(&rom, HAWSER_COS, 0, f);
	model_compile(&rom);
	return rom;
}

/* The undamped pair in resonance 2:1, V = u0^2/2 + 2 u1^2 + u0^2 u1/2 + (u0^2 + u1^2)^2/4. */
static inline struct hawser_rom model_pair(void)
{
	struct hawser_rom rom = model_new(2);

	rom.K[0] = 1.0;
	rom.K[3] = 4.0;
	model_quad(&rom, 0, 0, 1, 1.0);
	model_quad(&rom, 1, 0, 0, 0.5);
	for (int j = 0; j < 2; j++)
		for (int k = 0; k < 2; k++)
			model_cubic(&rom, j, j, k, k, 1.0);
	model_compile(&rom);
	return rom;
}

/* Uniform in (-1, 1), the same numbers on every machine. */
static inline double model_random(uint64_t *seed)
{
	*seed = *seed*6364136223846793005u + 1442695040888963407u;
	return (double)(int64_t)*seed/9223372036854775808.0;
}

/* Five coordinates with a random potential that grows in every direction: frequencies 1 to 2.6 and,
 * for two random vectors r, (r.u)^3/9 + (r.u)^4/4. */
static inline struct hawser_rom model_potential(void)
{
	struct hawser_rom rom = model_new(5);
	uint64_t seed = 2385;
	double r[5];

	for (int i = 0; i < 5*5*5*5*2; i++) {
		int j = i % 5, k = i/5 % 5, l = i/25 % 5, m = i/125 % 5;

		for (int p = 0; i % 625 == 0 && p < 5; p++)
			r[p] = model_random(&seed);
		rom.K[j*6] = (1.0 + 0.4*j)*(1.0 + 0.4*j);
		if (m == 0)
			model_quad(&rom, j, k, l, r[j]*r[k]*r[l]/3.0);
		model_cubic(&rom, j, k, l, m, r[j]*r[k]*r[l]*r[m]);
	}
	model_compile(&rom);
	return rom;
}

/* Integrate to the end, or fail the test: for tests that need only the result. */
static inline struct hawser_trajectory model_run(const struct hawser_rom *rom, const char *method,
                                                 double omega, double until, double every,
                                                 double rtol, const double *initial)
{
	struct hawser_integrate_options options = {
		.omega = omega, .until = until, .every = every, .rtol = rtol, .atol = rtol*1e-3,
		.method = method, .initial = initial,
	};
	struct hawser_trajectory run;
	struct hawser_report report = {0};

	if (hawser_integrate(&run, rom, &options, &report)) {
		printf("Bail out! %s: %s\n", method ? method : "auto", report.message);
		exit(1);
	}
	return run;
}

#endif

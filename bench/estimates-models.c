/* bench/estimates-models.c - random reduced models (estimates.h): of a cable with one to five
 * modes, or of one to three oscillators coupled by a random potential.
 *
 * The loads are chosen so that the amplitudes at resonance change the stiffness by a random part,
 * from 1e-4 to 0.3; for strong loads from 0.05 to 0.5 with little damping, so that there are folds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "bench/estimates.h"
#include "rom/build/model.h"

enum { MOST = 3, DIRECTIONS = 3 };

/* |C| of coordinate j alone, with the equivalent effect of Q. */
static double hardening(const struct hawser_rom *rom, int j)
{
	double sum = 0.0;

	for (int e = 0; e < rom->cubics; e++)
		if (rom->C[e].j == j && rom->C[e].k == j && rom->C[e].m == j)
			sum += fabs(rom->C[e].value);
	for (int e = 0; e < rom->quads; e++)
		if (rom->Q[e].j == j && rom->Q[e].k == j && rom->Q[e].l == j)
			sum += rom->Q[e].value*rom->Q[e].value/rom->K[j*rom->n + j];
	return sum;
}

/* Damping ratios and load; `f` has the load's shape. */
static int excite(struct hawser_rom *rom, struct chance *chance, int strong)
{
	double ratio = chance_log(chance, 3e-3, strong ? 0.03 : 0.1);
	double part = chance_log(chance, strong ? 0.05 : 1e-4, strong ? 0.5 : 0.3);
	double factor = INFINITY, *f = rom->harmonic[0].f;
	int n = rom->n;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			rom->D[j*n + k] = j == k ? 2.0*ratio*sqrt(rom->K[j*n + j]) : 0.0;
	for (int j = 0; j < n; j++) {
		double a = sqrt(part*rom->K[j*n + j]/hardening(rom, j));

		if (isfinite(a) && fabs(f[j]) > 0.0)
			factor = fmin(factor, a*2.0*ratio*rom->K[j*n + j]/fabs(f[j]));
	}
	for (int j = 0; j < n; j++)
		f[j] *= factor;
	return !isfinite(factor) || hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* --- oscillators --- */

/* (c/4)(a.u)^4: every monomial u_k u_l u_m of each equation. */
static void quartic(struct hawser_rom *rom, const double *a, double c)
{
	int n = rom->n;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++)
				for (int m = l; m < n; m++) {
					double times = k == m ? 1.0 : k == l || l == m ? 3.0 : 6.0;

					rom->C[rom->cubics++] = (struct hawser_cubic){
						j, k, l, m, c*a[j]*times*a[k]*a[l]*a[m]};
				}
}

static void third(struct hawser_rom *rom, const double *a, double c)
{
	int n = rom->n;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++)
				rom->Q[rom->quads++] = (struct hawser_quad){
					j, k, l, c*a[j]*(k == l ? 1.0 : 2.0)*a[k]*a[l]};
}

static int oscillators(struct hawser_rom *rom, struct chance *chance, int strong)
{
	int n = chance_int(chance, 1, MOST);
	double soft = chance_unit(chance) < 0.5 ? 0.0 : chance_between(chance, 0.1, 1.0);

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->C = calloc((size_t)DIRECTIONS*30, sizeof *rom->C);
	rom->Q = calloc((size_t)DIRECTIONS*18, sizeof *rom->Q);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	if (!rom->C || !rom->Q || !rom->harmonic)
		return 1;
	rom->harmonics = 1;
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc((size_t)n, sizeof(double))};
	if (!rom->harmonic[0].f)
		return 1;
	for (int j = 0; j < n; j++) {
		double omega = j ? chance_between(chance, 0.5, 4.0) : 1.0;

		if (j && chance_unit(chance) < 0.3)
			omega = chance_int(chance, 1, 3)*chance_between(chance, 0.97, 1.03);
		rom->K[j*n + j] = omega*omega;
		rom->harmonic[0].f[j] = chance_between(chance, -1.0, 1.0);
	}
	for (int i = 0; i < n; i++) {
		double a[MOST], b[MOST];

		for (int j = 0; j < n; j++) {
			a[j] = j == i ? 1.0 : chance_between(chance, -0.7, 0.7);
			b[j] = chance_between(chance, -1.0, 1.0);
		}
		quartic(rom, a, 1.0);
		third(rom, b, soft);
	}
	return excite(rom, chance, strong);
}

/* --- a cable --- */

static int cable(struct hawser_rom *rom, struct chance *chance, int strong)
{
	struct hawser_scene scene = {.g = 9.81, .cable = {.EA = 1.0, .rho = 1.0}, .span = {100.0, 0.0}};
	struct hawser_modes_options options = {.n = chance_int(chance, 1, 5)};
	double delta = chance_log(chance, 1e-3, 2.0), H = 9.81*100.0/delta;
	struct hawser_span span = {H/chance_log(chance, 1e-5, 1e-2), 1.0, 9.81, 100.0,
	                           100.0*(chance_unit(chance) < 0.4 ? 0.0
	                                                            : chance_between(chance, -1.0, 1.0))};
	struct hawser_statics st;
	struct hawser_modes modes;
	int failed;

	scene.load.present = 1;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.extent[1] = chance_between(chance, 0.3, 1.0);
	scene.model.inertia = chance_unit(chance) < 0.5 ? HAWSER_INERTIA_NONE : HAWSER_INERTIA_AUTO;
	scene.load.per_length[1] = 1.0;
	scene.load.per_length[2] = chance_between(chance, -1.0, 1.0);
	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL) ||
	    hawser_modes_solve(&modes, &st, &options, NULL))
		return 1;
	failed = hawser_rom_build(rom, &modes, &scene, NULL) != HAWSER_OK;
	hawser_modes_clear(&modes);
	return failed || rom->harmonics < 1 || !rom->harmonic[0].f || excite(rom, chance, strong);
}

int estimate_model(struct hawser_rom *rom, struct chance *chance, int strong)
{
	int failed;

	*rom = (struct hawser_rom){0};
	failed = chance_unit(chance) < 0.5 ? cable(rom, chance, strong)
	                                   : oscillators(rom, chance, strong);
	if (failed)
		hawser_rom_clear(rom);
	return failed;
}

/* The force on the kept modes while the load displaces what follows them: the reduced model against the
 * exact energy on a large basis, in which everything that is not kept is in equilibrium with the load.
 * With coordinates and load divided by 2, the terms of degree 4 that a reduced model lacks are divided
 * by 16.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/rom.h>
#include "rom/terms/vary.h"
#include "tests/tap.h"

enum { KEPT = 4, FUNCTIONS = 24, N = 3*FUNCTIONS };

static struct hawser_report report;

static struct hawser_scene scene_of(double h, double wave, const double load[3], double factor)
{
	struct hawser_scene scene = {.cable = {.EA = 120e6, .rho = 11.0}, .span = {300.0, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = hypot(300.0, h)*1.004;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.model.inertia = HAWSER_INERTIA_NONE;
	scene.loads = 1;
	scene.piece[0] = (struct hawser_load_piece){.frame = HAWSER_FRAME_LOCAL, .to = 1.0, .harmonic = 1,
		.wave = wave};
	for (int c = 0; c < 3; c++)
		scene.piece[0].per_length[c] = factor*load[c];
	return scene;
}

/* value [n] += the varying part of the force of a model at u, less the load. */
static void add_varying(double *value, const struct hawser_rom *rom, const double *u, double tau)
{
	hawser__rom_vary_at(rom, value, NULL, u, tau);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		double wave = harmonic->phase == HAWSER_COS ? cos(harmonic->k*tau) : sin(harmonic->k*tau);

		for (int j = 0; j < rom->n; j++) {
			for (int k = 0; harmonic->K && k < rom->n; k++)
				value[j] += wave*harmonic->K[j*rom->n + k]*u[k];
			value[j] -= harmonic->f ? wave*harmonic->f[j] : 0.0;
		}
	}
}

/* The same force in the full-order model, all other coordinates in equilibrium. */
static int exact_force(double *value, const struct hawser_rom *full, const double *u, double tau)
{
	double y[N] = {0.0}, R[N], T[N*N], matrix[N*N], step[N], moved = INFINITY;
	int free_n = full->n - KEPT, pivot[N];

	memcpy(y, u, KEPT*sizeof *y);
	for (int i = 0; i < 30 && moved > 1e-13; i++) {
		hawser_rom_tangent(full, R, T, y);
		add_varying(R, full, y, tau);
		for (int j = 0; j < free_n; j++) {
			step[j] = R[KEPT + j];
			for (int k = 0; k < free_n; k++)
				matrix[j*free_n + k] = T[(KEPT + k)*full->n + KEPT + j];
		}
		if (LAPACKE_dgesv(LAPACK_COL_MAJOR, free_n, 1, matrix, free_n, pivot, step, free_n))
			return 0;
		moved = 0.0;
		for (int j = 0; j < free_n; j++) {
			y[KEPT + j] -= step[j];
			moved = fmax(moved, fabs(step[j]));
		}
	}
	hawser_rom_restoring(full, R, y);
	add_varying(R, full, y, tau);
	memcpy(value, R, KEPT*sizeof *value);
	return moved <= 1e-13;
}

/* Largest difference of the forces at a few states and phases. */
static double difference(const struct hawser_scene *scene, const double *state, double factor)
{
	struct hawser_statics st;
	struct hawser_modes_options options = {.n = KEPT};
	struct hawser_modes few = {.n = 0};
	struct hawser_rom rom = {.n = 0}, full = {.n = 0};
	double off = INFINITY;

	if (ok(!hawser_statics_scene(&st, scene, &report) &&
	       !hawser_modes_solve(&few, &st, &options, &report) &&
	       !hawser_rom_build(&rom, &few, scene, &report) &&
	       !hawser_rom_build_full(&full, &st, scene, FUNCTIONS, &report), "models %s",
	        report.message)) {
		off = 0.0;
		for (int p = 0; p < 3; p++) {
			double u[KEPT], own[KEPT], exact[KEPT], tau = 0.4 + 1.9*p, mirrored[KEPT];

			for (int j = 0; j < KEPT; j++) {
				int at = j*rom.shapes.points*3 + (few.mode[j].plane == HAWSER_OUT_OF_PLANE ? 2 : 1);
				double sign = rom.shapes.shape[at]*full.shapes.shape[at] < 0.0 ? -1.0 : 1.0;

				u[j] = factor*state[j]*cos(1.0 + 2.0*p*j);
				mirrored[j] = sign*u[j];
			}
			hawser_rom_restoring(&rom, own, u);
			add_varying(own, &rom, u, tau);
			if (!exact_force(exact, &full, mirrored, tau))
				off = INFINITY;
			for (int j = 0; j < KEPT; j++)
				off = fmax(off, fabs(own[j] - exact[j]*mirrored[j]/u[j]));
		}
	}
	hawser_rom_clear(&rom);
	hawser_rom_clear(&full);
	hawser_modes_clear(&few);
	return off;
}

static void check(double h, double wave, const double load[3])
{
	const double state[KEPT] = {2e-3, 1.5e-3, 1e-3, 8e-4};
	double off[2];

	for (int i = 0; i < 2; i++) {
		double factor = i ? 0.5 : 1.0;
		struct hawser_scene scene = scene_of(h, wave, load, factor);

		off[i] = difference(&scene, state, factor);
	}
	ok(off[1] < off[0]/12.0, "h %g, wave %g m: off by %.2e, and %.2e at half: order %.1f", h, wave,
	   off[0], off[1], log2(off[0]/off[1]));
}

/* A wave of N half waves needs about 1.6 N functions; a basis holds all of a load that is even. */
static void check_lacks(void)
{
	static const int functions[] = {8, 12, 16, 20, 24};
	struct hawser_scene scene = scene_of(0.0, 60.0, (const double[3]){0.0, 60.0, 0.0}, 1.0);
	struct hawser_scene even = scene_of(0.0, 0.0, (const double[3]){0.0, 60.0, 0.0}, 1.0);
	struct hawser_statics st;
	double lacks[5] = {0.0}, none = NAN;
	int good = !hawser_statics_scene(&st, &scene, &report);

	for (int i = 0; i < 5; i++)
		good &= !hawser_rom_full_lacks(&lacks[i], &st, &scene, functions[i], &report);
	ok(good && lacks[0] > 0.5 && lacks[1] > 0.3 && lacks[2] < 0.1 && lacks[3] < 1e-3 && lacks[4] == 0.0,
	   "a wave of 10 half waves, 8 to 24 functions lack %.1e %.1e %.1e %.1e %.1e", lacks[0], lacks[1],
	   lacks[2], lacks[3], lacks[4]);
	ok(!hawser_rom_full_lacks(&none, &st, &even, 8, &report) && none < 1e-6,
	   "of an even load 8 functions lack %.1e", none);
	even.loads = 0;
	ok(!hawser_rom_full_lacks(&none, &st, &even, 8, &report) && none == 0.0, "of none, nothing");
}

CASE(property_rom_loaded)
{
	check_lacks();
	check(0.0, 100.0, (const double[3]){0.0, 60.0, 0.0});
	check(40.0, 150.0, (const double[3]){0.0, 40.0, 30.0});
	check(40.0, 0.0, (const double[3]){0.0, 0.0, 50.0});
	done_testing();
	return 0;
}

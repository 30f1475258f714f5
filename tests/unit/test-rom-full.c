/* The full-order model: load, damping, units and probes are those of the expanded model on the same
 * modes; one plane alone is a model of its own; unsupported operations fail with their status.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/rom.h>

#include "tests/tap.h"

static struct hawser_scene chairlift(void)
{
	return (struct hawser_scene){
		.cable = {.EA = 4e8, .rho = 6.0}, .span = {.d = 250.0, .h = 10.0}, .g = 9.81,
		.tension = {.given = HAWSER_GIVEN_T0, .value = 8e4},
		.damping = {.kind = HAWSER_DAMPING_RAYLEIGH, .mass = 0.0133, .stiffness = 2.385e-4},
		.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL, .per_length = {0.3, -0.7, 0.9},
		         .extent = {0.1, 0.85}},
	};
}

/* Numbers that both models have are equal. */
static int alike(const struct hawser_rom *a, const struct hawser_rom *b)
{
	size_t n = (size_t)a->n, fields = n*(size_t)a->shapes.points*3*sizeof(double);
	int same = a->n == b->n && a->length == b->length && a->time == b->time &&
	           a->force == b->force && a->scaled == b->scaled && a->harmonics == b->harmonics &&
	           a->shapes.points == b->shapes.points && a->shapes.EA == b->shapes.EA;

	same = same && !memcmp(a->D, b->D, n*n*sizeof *a->D) && !memcmp(a->K, b->K, n*n*sizeof *a->K) &&
	       !memcmp(a->harmonic->f, b->harmonic->f, n*sizeof *a->harmonic->f) &&
	       !memcmp(a->shapes.shape, b->shapes.shape, fields) &&
	       !memcmp(a->shapes.slope, b->shapes.slope, fields);
	for (size_t j = 0; same && j < n; j++)
		same = strcmp(a->label[j], b->label[j]) == 0;
	return same;
}

static void check_alike(void)
{
	struct hawser_scene scene = chairlift();
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom exact, quartic, full;

	scene.model.condense = HAWSER_CONDENSE_NONE;
	if (!ok(!hawser_statics_scene(&st, &scene, NULL) &&
	        !hawser_modes_basis(&modes, &st, 4, 4, NULL) &&
	        !hawser_rom_build_exact(&exact, &modes, &scene, NULL) &&
	        !hawser_rom_build(&quartic, &modes, &scene, NULL) &&
	        !hawser_rom_build_full(&full, &st, &scene, 4, NULL), "three models"))
		return;
	ok(alike(&exact, &quartic), "all but the tensors is that of the expanded model");
	ok(alike(&exact, &full) && full.exact && !full.quads && !full.cubics,
	   "the full-order model is the exact one on the whole basis");
	hawser_rom_clear(&exact);
	hawser_rom_clear(&quartic);
	hawser_rom_clear(&full);
	hawser_modes_clear(&modes);
}

/* Forces of the model of one plane against those of the whole model with the other plane at rest. */
static void check_plane(int in, int out, const char *name)
{
	struct hawser_scene scene = chairlift();
	struct hawser_statics st;
	struct hawser_modes modes, whole;
	struct hawser_rom all, one;
	double u[60] = {0.0}, f[60], v[60], g[60], worst = 0.0, scale = 0.0, still[60] = {0.0};
	int next = 0;

	if (!ok(!hawser_statics_scene(&st, &scene, NULL) &&
	        !hawser_modes_basis(&modes, &st, in, out, NULL) &&
	        !hawser_modes_basis(&whole, &st, 7, 7, NULL) &&
	        !hawser_rom_build_exact(&one, &modes, NULL, NULL) &&
	        !hawser_rom_build_exact(&all, &whole, NULL, NULL), "%s", name))
		return;
	for (int j = 0; j < all.n; j++)
		if ((strncmp(all.label[j], "in", 2) == 0) == (in > 0))
			u[j] = v[next++] = 1e-3*sin(1.7*j + 0.3);
	hawser_rom_restoring(&all, f, u);
	hawser_rom_restoring(&one, g, v);
	ok(next == one.n, "%s: %d coordinates", name, one.n);
	next = 0;
	for (int j = 0; j < all.n; j++)
		if ((strncmp(all.label[j], "in", 2) == 0) == (in > 0)) {
			worst = fmax(worst, fabs(f[j] - g[next]));
			scale = fmax(scale, fabs(g[next++]));
		}
	ok(worst < 1e-12*scale, "%s: the same forces, %.1e", name, worst/scale);
	close_to(hawser_rom_energy(&one, v, still), hawser_rom_energy(&all, u, still), 1e-13,
	         "the same energy");
	hawser_rom_clear(&all);
	hawser_rom_clear(&one);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&whole);
}

static void check_refusals(void)
{
	struct hawser_scene scene = chairlift();
	struct hawser_auto_options options = {.ntst = 0};
	struct hawser_report report = {0};
	struct hawser_statics st, rigid;
	struct hawser_modes modes;
	struct hawser_rom rom;
	char *text = NULL;

	if (hawser_statics_scene(&st, &scene, NULL))
		return;
	ok(hawser_rom_build_full(&rom, &st, &scene, -1, &report) == HAWSER_ERR_ARGUMENT && !rom.K,
	   "%s", report.message);
	ok(hawser_rom_build_full(&rom, &st, &scene, 34, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "33"), "%s", report.message);
	rigid = st;
	rigid.epsilon = 0.0;
	ok(hawser_rom_build_full(&rom, &rigid, &scene, 5, &report) == HAWSER_ERR_NO_SOLUTION, "%s",
	   report.message);
	if (!ok(!hawser_modes_basis(&modes, &st, 50, 8, NULL), "108 modes"))
		return;
	ok(hawser_rom_build_exact(&rom, &modes, NULL, &report) == HAWSER_ERR_ARGUMENT && !rom.K, "%s",
	   report.message);
	hawser_modes_clear(&modes);
	if (!ok(!hawser_modes_basis(&modes, &st, 3, 3, NULL), "9 modes"))
		return;
	modes.slope[17] = NAN;
	ok(hawser_rom_build_exact(&rom, &modes, NULL, &report) == HAWSER_ERR_NAN && !rom.K, "%s",
	   report.message);
	modes.statics.epsilon = 0.0;
	ok(hawser_rom_build_exact(&rom, &modes, NULL, &report) == HAWSER_ERR_NO_SOLUTION, "%s",
	   report.message);
	hawser_modes_clear(&modes);
	if (!ok(!hawser_rom_build_full(&rom, &st, &scene, 3, &report), "a model"))
		return;
	options.from = 1.0;
	options.to = 2.0;
	ok(hawser_rom_text(&rom, &text, &report) == HAWSER_ERR_ARGUMENT && !text, "%s", report.message);
	ok(hawser_rom_save(&rom, "full.json", &report) == HAWSER_ERR_ARGUMENT &&
	   access("full.json", F_OK) != 0, "and no file: %s", report.message);
	ok(hawser_rom_export_auto(&rom, "full", &options, &report) == HAWSER_ERR_ARGUMENT &&
	   access("full.f90", F_OK) != 0, "%s", report.message);
	ok(!hawser_rom_compile(&rom, &report) && rom.exact, "compiling again keeps the energy");
	hawser_rom_clear(&rom);
	ok(!rom.exact && !rom.kernel, "cleared");
	hawser_rom_clear(&rom);
}

static void check_default(void)
{
	struct hawser_scene scene = chairlift();
	struct hawser_statics st;
	struct hawser_rom rom;

	ok(!hawser_statics_scene(&st, &scene, NULL) &&
	   !hawser_rom_build_full(&rom, &st, &scene, 0, NULL) && rom.n == 48, "48 coordinates by default");
	hawser_rom_clear(&rom);
}

CASE(unit_rom_full)
{
	check_alike();
	check_plane(7, 0, "in the plane");
	check_plane(0, 7, "out of the plane");
	check_refusals();
	check_default();
	return done_testing();
}

/* The inertia of condensed modes by other routes: sums over the modes of a whole basis; the
 * condensed model without this inertia, which must have the same statics; a scene that does not
 * need it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/rom.h>
#include <hawser/scene.h>

#include "tests/modes-span.h"
#include "tests/modes-third.h"
#include "tests/rom-entries.h"
#include "tests/tap.h"

#define KEPT 5

/* The span of deep-sag.yaml: sag of a fifth of the distance between the ends, hardly any stretch. */
static const double deep[3] = {6.435e-5, 1.5244, 0.025};

static struct hawser_scene scene_of(double load, double alpha)
{
	return (struct hawser_scene){
		.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL, .extent = {0.0, 1.0},
		         .per_length = {0.0, load, load}},
		.damping = {.kind = HAWSER_DAMPING_ALPHA, .alpha = alpha},
		.model = {.modes = KEPT},
	};
}

/* The load at which the resonance of the first mode has the scaled amplitude `wanted`. */
static double load_for(const struct hawser_modes *modes, double alpha, double wanted)
{
	struct hawser_scene scene = scene_of(1.0, alpha);
	struct hawser_rom rom;
	double load = 0.0;

	scene.model.inertia = HAWSER_INERTIA_NONE;
	if (!hawser_rom_build(&rom, modes, &scene, NULL))
		load = wanted*rom.D[0]*modes->mode[0].omega/fabs(rom.harmonic->f[0]);
	hawser_rom_clear(&rom);
	return load;
}

/* C_jjjj including the static effect of the shapes. */
static double static_cubic(const struct hawser_rom *rom, int j)
{
	double sum = cubic_of(rom, j, j, j, j);

	for (int s = rom->n - rom->inertia.shapes; s < rom->n; s++)
		sum -= 2.0*pow(quad_of(rom, s, j, j), 2)/rom->K[s*rom->n + s];
	return sum;
}

/* |w_jj/2|^2, the displacement by the shapes for mode j. */
static double moved(const struct hawser_rom *rom, int j)
{
	double sum = 0.0;

	for (int s = rom->n - rom->inertia.shapes; s < rom->n; s++)
		sum += pow(quad_of(rom, s, j, j)/rom->K[s*rom->n + s], 2);
	return sum;
}

/* The same for every mode of a basis above the 32 lowest. */
static double moved_by_all(const struct hawser_statics *st, int j)
{
	struct hawser_modes all;
	double sum = 0.0;

	if (hawser_modes_basis(&all, st, 30, 30, NULL))
		return NAN;
	for (int s = 32; s < all.n; s++)
		sum += pow(0.5*third(&all, j, j, s)/pow(all.mode[s].omega, 2), 2);
	hawser_modes_clear(&all);
	return sum;
}

static int terms_of_fourth_order(const struct hawser_rom *rom)
{
	int modes = rom->n - rom->inertia.shapes, fine = 1;

	for (int i = 0; i < rom->quads; i++)
		fine &= (rom->Q[i].j >= modes) + (rom->Q[i].k >= modes) + (rom->Q[i].l >= modes) <= 1;
	for (int i = 0; i < rom->cubics; i++)
		fine &= rom->C[i].j < modes && rom->C[i].m < modes;
	return fine;
}

static void check_file(const struct hawser_rom *rom)
{
	char path[] = "/tmp/hawser-inertia-XXXXXX";
	int file = mkstemp(path);
	struct hawser_rom again;
	double u[16];

	for (int j = 0; j < rom->n; j++)
		u[j] = 0.003*(j%2 ? 1.0 : -2.0);
	if (!ok(file >= 0 && !hawser_rom_save(rom, path, NULL) &&
	        !hawser_rom_open(&again, path, NULL), "to a file and back"))
		return;
	ok(again.inertia.shapes == rom->inertia.shapes, "with %d shapes", rom->inertia.shapes);
	close_to(hawser_rom_tension(&again, 1, u), hawser_rom_tension(rom, 1, u), 1e-14,
	         "and the tension");
	hawser_rom_clear(&again);
	close(file);
	unlink(path);
}

/* To second order, and not proportional to EA: the length is preserved. */
static void check_tension(const struct hawser_rom *rom)
{
	double u[16] = {0.0}, part[2], at_rest = hawser_rom_tension(rom, 1, u);

	for (int i = 0; i < 2; i++) {
		u[0] = 0.02*(i + 1);
		part[i] = hawser_rom_tension(rom, 1, u) - at_rest;
		u[0] = -u[0];
		part[i] += hawser_rom_tension(rom, 1, u) - at_rest;
	}
	close_to(part[1], 4.0*part[0], 1e-9, "tension of second order");
	ok(fabs(part[0]) < 0.2*rom->force, "%.3g N of the %.3g N at rest", part[0], at_rest);
}

static void check_deep(void)
{
	struct hawser_statics st = span_of(deep[0], deep[1], deep[2]);
	struct hawser_modes_options options = {.n = KEPT, .tolerance = 1e-10};
	struct hawser_rom with, without;
	struct hawser_scene scene;
	struct hawser_modes modes;
	double amplitude = 0.0106, part;

	if (!ok(!hawser_modes_solve(&modes, &st, &options, NULL), "modes of a deep sag"))
		return;
	scene = scene_of(load_for(&modes, 0.06, amplitude), 0.06);
	if (!ok(!hawser_rom_build(&with, &modes, &scene, NULL), "model"))
		return;
	ok(with.inertia.shapes > 0 && with.n == KEPT + with.inertia.shapes, "shapes: %d",
	   with.inertia.shapes);
	scene.model.inertia = HAWSER_INERTIA_NONE;
	if (!ok(!hawser_rom_build(&without, &modes, &scene, NULL) && without.n == KEPT,
	        "none asked for"))
		return;
	ok(with.inertia.left < 1e-4 && with.inertia.left < with.inertia.shift,
	   "they leave %.1e of %.1e", with.inertia.left, with.inertia.shift);
	for (int j = 0; j < KEPT; j += 2)
		close_to(static_cubic(&with, j), static_cubic(&without, j), 1e-9, "the statics stay");
	part = moved_by_all(&st, 0);
	ok(fabs(moved(&with, 0) - part)*amplitude*amplitude < 1e-4 && part > 9.0,
	   "|w_11/2|^2 %.4f, by a sum over modes %.4f", moved(&with, 0), part);
	ok(terms_of_fourth_order(&with), "terms to the fourth order, a shape counted as two");
	ok(hawser_rom_asymmetry(&with) < 1e-13, "a potential: %.1e", hawser_rom_asymmetry(&with));
	check_file(&with);
	check_tension(&with);
	hawser_rom_clear(&with);
	hawser_rom_clear(&without);
	hawser_modes_clear(&modes);
}

/* A taut span: the condensed modes hardly move, and the model does not change. */
static void check_taut(void)
{
	struct hawser_statics st = span_of(2e-4, 0.1, 0.0);
	struct hawser_modes_options options = {.n = KEPT, .tolerance = 1e-10};
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;

	if (!ok(!hawser_modes_solve(&modes, &st, &options, NULL), "modes of a taut span"))
		return;
	scene = scene_of(load_for(&modes, 0.06, 0.005), 0.06);
	if (!ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "model"))
		return;
	ok(rom.n == KEPT && rom.inertia.left < 1e-4, "no shapes, %.1e left", rom.inertia.left);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

CASE(property_rom_inertia)
{
	check_deep();
	check_taut();
	return done_testing();
}

/* Models of cables that hang in space: the expanded energy against the exact one, tangents against
 * difference quotients, and many states at once against one after another.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>
#include <hawser/scene.h>

#include "rom/energy/kernel.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { MODES = 9 };

static const char scene_text[] =
	"cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 200 m, h: 62 m}\ntension: {length0: 213 m}\n"
	"attach: [{at: 0.31, mass: 48}, {at: 0.7, mass: 130}]\nmodel: {modes: 9}\n"
	"load: {static: {per_length: [4, 3, 12]}, frame: global, per_length: [0.3, 0.5, 1.1]}\n";

static double value_at(int i)
{
	return (i%2 ? -1.0 : 1.0)*(0.3 + 0.7*fmod(0.618*(i + 1), 1.0));
}

static void states(double *u, int n, double size)
{
	for (int i = 0; i < n; i++)
		u[i] = size*value_at(i);
}

static double distance(const double *a, const double *b, int n)
{
	double sum = 0.0;

	for (int i = 0; i < n; i++)
		sum += (a[i] - b[i])*(a[i] - b[i]);
	return sqrt(sum);
}

/* Without condensation both models have the same coordinates: the forces differ by the fifth order of
 * the energy, so that they approach each other sixteen times by half the displacement. */
static void expanded(const struct hawser_rom *raw, const struct hawser_rom *exact)
{
	double before = 0.0;

	for (int k = 0; k < 4; k++) {
		double u[MODES], f[MODES], g[MODES], off;

		states(u, MODES, 5e-5/(1 << k));
		hawser_rom_restoring(raw, f, u);
		hawser_rom_restoring(exact, g, u);
		off = distance(f, g, MODES);
		ok(k == 0 || (before/off > 15.0 && before/off < 20.0),
		   "forces of the expanded energy to %.1e of the exact ones, %.1f times less", off, before/off);
		before = off;
	}
}

/* Forces against differences of the energy, tangents against those of forces, and many states at once
 * against one after another. */
static void derivatives(const char *what, const struct hawser_rom *rom)
{
	enum { COUNT = 5 };
	int n = rom->n;
	size_t size = (size_t)n*(size_t)n;
	double u[COUNT*MODES], f[COUNT*MODES], g[MODES], low[MODES], zero[MODES] = {0.0};
	double *T = calloc((COUNT + 1)*size, sizeof *T), *one = T + COUNT*size, h = 1e-7;
	double *work = calloc(hawser__rom_tangents_work(rom, COUNT), sizeof *work);
	double off[4] = {0.0}, top[2] = {0.0};

	for (int i = 0; i < COUNT; i++)
		states(u + i*n, n, 2e-4*(i + 1));
	hawser__rom_tangents(rom, f, T, u, COUNT, work);
	for (int i = 0; i < COUNT; i++) {
		hawser_rom_tangent(rom, g, one, u + i*n);
		off[0] = fmax(off[0], distance(g, f + i*n, n));
		for (size_t k = 0; k < size; k++) {
			off[1] = fmax(off[1], fabs(T[i*size + k] - one[k]));
			top[1] = fmax(top[1], fabs(one[k]));
		}
		top[0] = fmax(top[0], distance(g, zero, n));
	}
	hawser_rom_tangent(rom, f, one, u);
	for (int k = 0; k < n; k++) {
		double kept = u[k], more, less;

		u[k] = kept + h;
		hawser_rom_restoring(rom, g, u);
		more = hawser_rom_energy(rom, u, zero);
		u[k] = kept - h;
		hawser_rom_restoring(rom, low, u);
		less = hawser_rom_energy(rom, u, zero);
		u[k] = kept;
		off[2] = fmax(off[2], fabs((more - less)/(2.0*h) - f[k]));
		for (int j = 0; j < n; j++)
			off[3] = fmax(off[3], fabs((g[j] - low[j])/(2.0*h) - one[j*n + k]));
	}
	ok(off[0] < 1e-12*top[0] && off[1] < 1e-12*top[1], "%s: many states as one: %.1e, %.1e", what,
	   off[0]/top[0], off[1]/top[1]);
	ok(off[2] < 1e-6*top[0], "%s: forces to %.1e of differences of the energy", what, off[2]/top[0]);
	ok(off[3] < 1e-6*top[1], "%s: tangent to %.1e of differences of forces", what, off[3]/top[1]);
	free(T);
	free(work);
}

CASE(property_rom_space)
{
	struct hawser_report report = {.message = ""};
	struct hawser_modes_options options = {.n = MODES};
	struct hawser_scene scene;
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom raw, exact;
	int done = !read_text(&scene, scene_text, NULL, &report) &&
	           !hawser_statics_scene(&st, &scene, &report) &&
	           !hawser_modes_solve(&modes, &st, &options, &report);

	if (ok(done, "modes %s", report.message)) {
		scene.model.condense = HAWSER_CONDENSE_NONE;
		if (ok(!hawser_rom_build(&raw, &modes, &scene, &report) &&
		       !hawser_rom_build_exact(&exact, &modes, &scene, &report), "models %s", report.message)) {
			expanded(&raw, &exact);
			derivatives("expanded", &raw);
			derivatives("exact", &exact);
		}
		hawser_rom_clear(&raw);
		hawser_rom_clear(&exact);
		hawser_modes_clear(&modes);
	}
	hawser_scene_clear(&scene);
	return done_testing();
}

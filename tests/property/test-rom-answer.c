/* The response of condensed modes to the forces of a model: displacement and tension against the
 * sum over many modes, also for a model file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/rom.h>
#include "tests/tap.h"
#include "tests/velocity.h"

enum { KEPT = 5, FUNCTIONS = 33 }; /* functions per component of the basis */

static struct hawser_scene scene_of(double h, double T0, double EA, enum hawser_frame frame,
                                    const double load[3], double from, double to)
{
	struct hawser_scene scene = {.cable = {.EA = EA, .rho = 2.385}, .span = {97.3, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = T0;
	scene.load.present = 1;
	scene.load.frame = frame;
	memcpy(scene.load.per_length, load, sizeof scene.load.per_length);
	scene.load.extent[0] = from;
	scene.load.extent[1] = to;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.model.inertia = HAWSER_INERTIA_NONE;
	return scene;
}

/* Global displacement at shape point p by the modes from KEPT on, each with the response
 * f_s/(omega_s^2 - W^2). */
static void sum_modes(double xyz[3], const struct hawser_rom *all, int p, double W, double wave)
{
	double ex = all->shapes.tangent[2*p], ey = all->shapes.tangent[2*p + 1], local[3] = {0.0};

	for (int s = KEPT; s < all->n; s++)
		for (int i = 0; i < 3; i++)
			local[i] += wave*all->harmonic[0].f[s]/(all->K[s*all->n + s] - W*W)*
			            all->shapes.shape[((size_t)s*all->shapes.points + p)*3 + i];
	xyz[0] = local[0]*ex - local[1]*ey;
	xyz[1] = local[0]*ey + local[1]*ex;
	xyz[2] = local[2];
}

/* Largest distance at frequency W, relative to the largest component of the response; to first
 * order. */
static double distance(const struct hawser_rom *full, const struct hawser_rom *all, double W)
{
	const double rest[KEPT] = {0.0};
	struct hawser_rom first_order = *full;
	const struct hawser_rom *rom = &first_order;
	struct hawser_rom_moment moment = {.tau = 0.4, .omega = W};
	double most = 0.0, off = 0.0;

	first_order.ends = NULL;
	for (int p = 0; p < rom->shapes.points; p++) {
		double got[3], want[3];

		hawser_rom_displacement_at(rom, got, p, rest, &moment);
		sum_modes(want, all, p, W, cos(0.4));
		for (int i = 0; i < 3; i++) {
			most = fmax(most, fabs(want[i]));
			off = fmax(off, fabs(got[i] - want[i]));
		}
	}
	return off/most;
}

static void check_file(const struct hawser_rom *rom)
{
	const double u[KEPT] = {0.01, -0.02, 0.015, 0.004, -0.006};
	struct hawser_rom_moment moment = {.tau = 1.1, .omega = 1.7};
	char name[] = "/tmp/hawser-answer-XXXXXX";
	int file = mkstemp(name);
	struct hawser_rom back;
	double a[3], b[3];

	if (!ok(file >= 0 && !hawser_rom_save(rom, name, NULL) && !hawser_rom_open(&back, name, NULL),
	        "to a file and back"))
		return;
	hawser_rom_displacement_at(rom, a, 2, u, &moment);
	hawser_rom_displacement_at(&back, b, 2, u, &moment);
	ok(!memcmp(a, b, sizeof a) && hawser_rom_tension_at(rom, 1, u, &moment) ==
	   hawser_rom_tension_at(&back, 1, u, &moment), "which keeps the answer to the last bit");
	hawser_rom_clear(&back);
	close(file);
	remove(name);
}

/* If the load ends inside the cable, bases of 12, 24 and 33 functions have errors of 7.7e-2, 2.7e-2
 * and 1.0e-2, proportional to 1/N^2: the truncation error of the sum. */
static void check(double h, double T0, double EA, enum hawser_frame frame, const double load[3],
                  double from, double to)
{
	double least = from > 0.0 || to < 1.0 ? 1.2e-2 : 2e-10;
	struct hawser_scene scene = scene_of(h, T0, EA, frame, load, from, to);
	struct hawser_report report = {.message = ""};
	struct hawser_modes_options options = {.n = KEPT};
	struct hawser_modes few = {.n = 0}, many = {.n = 0};
	struct hawser_rom rom = {.n = 0}, all = {.n = 0};
	struct hawser_statics st;
	double off[3], first;

	if (!ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_modes_solve(&few, &st, &options, &report) &&
	        !hawser_rom_build(&rom, &few, &scene, &report), "h %g, T0 %g%s", h, T0, report.message))
		return;
	if (!ok(!hawser_modes_basis(&many, &st, FUNCTIONS, FUNCTIONS, &report) &&
	        !hawser_rom_build_linear(&all, &many, &scene, &report), "the modes of a basis%s",
	        report.message))
		return;
	first = sqrt(all.K[KEPT*(all.n + 1)]);
	for (int k = 0; k < 3; k++)
		off[k] = distance(&rom, &all, first*(k == 0 ? 0.0 : k == 1 ? 0.2 : 0.4));
	ok(off[0] < least, "static answer against %d modes: %.1e", all.n, off[0]);
	ok(off[1] < 4e-3 + least && off[2] < 4e-2,
	   "at 0.2 and 0.4 of the first frequency left out: %.1e, %.1e", off[1], off[2]);
	check_velocity(&rom, rom.shapes.points, 2.1, (double[KEPT]){0.01, -0.02, 0.015, 0.004, -0.006},
	               (double[KEPT]){0.3, 0.1, -0.2, 0.25, 0.15}, 1e-8);
	check_file(&rom);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&all);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

CASE(property_rom_answer)
{
	check(0.0, 9.1e3, 4e6, HAWSER_FRAME_LOCAL, (const double[3]){0.0, 0.8, 0.5}, 0.0, 1.0);
	check(31.0, 9.1e3, 4e6, HAWSER_FRAME_GLOBAL, (const double[3]){0.0, 0.8, 0.5}, 0.0, 1.0);
	check(11.0, 2.2e3, 1e6, HAWSER_FRAME_GLOBAL, (const double[3]){0.2, 0.7, 0.5}, 0.0, 1.0);
	check(11.0, 4e3, 1e6, HAWSER_FRAME_LOCAL, (const double[3]){0.0, 0.7, 0.5}, 0.23, 0.61);
	done_testing();
	return 0;
}

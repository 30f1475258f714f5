/* Reduced models of a cable with absorbers: eigenvalues against those of damped modes for every kind of
 * damping, expanded against exact forces with a cubic spring, its energy by the strokes, condensation
 * against elimination of the modes of a basis, static load, moved ends, names of strokes, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/choose.h>
#include <hawser/damped.h>
#include <hawser/rom.h>

#include "rom/terms/ends.h"
#include "tests/rom-eigenvalue.h"
#include "tests/rom-entries.h"
#include "tests/tap.h"

static struct hawser_report report;

static const struct hawser_span inclined = {4e7, 6.0, 9.81, 250.0, -61.7};
static const double tension = 4e4;
static const struct hawser_attachment several[3] = {
	{.at = 0.13, .mass = 100.0, .spring = {0.0, 2e3, 0.0}, .absorber_mass = 140.0,
	 .absorber_stiffness = 300.0, .absorber_damping = 60.0, .absorber_direction = {0.3, -1.0, 0.0}},
	{.at = 0.41, .absorber_mass = 60.0, .absorber_stiffness = 70.0, .absorber_damping = 20.0,
	 .absorber_direction = {0.0, 0.0, 1.0}},
	{.at = 0.62, .mass = 200.0, .damper = {0.0, 300.0, 0.0}, .absorber_mass = 50.0,
	 .absorber_stiffness = 200.0, .absorber_direction = {0.0, 2.0, 0.0}},
};

static int solve(struct hawser_modes *modes, const struct hawser_attachment *attach, int count, int n)
{
	const struct hawser_modes_options options = {.n = n};
	struct hawser_statics st;

	if (!hawser_statics_loaded(&st, &inclined, HAWSER_GIVEN_H, tension, HAWSER_BRANCH_TAUT, attach,
	                           count, &report) &&
	    !hawser_modes_solve(modes, &st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* The models of modes and of a basis have the eigenvalues of the linear problem (damped.h), in which
 * the scene's damping acts on the cable with its absorbers held. */
static void linear(struct hawser_scene scene, const char *what, double tolerance)
{
	const struct hawser_damped_options options = {.n = 6};
	struct hawser_damped exact;
	struct hawser_modes modes;
	struct hawser_rom rom, full;
	double worst = 0.0, of_full = 0.0, least = INFINITY;

	scene.model.modes = 20;
	if (!solve(&modes, several, 3, 20))
		return;
	if (!ok(!hawser_damped_solve(&exact, &modes.statics, &scene, &options, &report) &&
	        !hawser_rom_build_linear(&rom, &modes, &scene, &report) &&
	        !hawser_rom_build_full(&full, &modes.statics, &scene, 18, &report), "%s: %s", what,
	        report.message))
		return;
	for (int i = 0; i < exact.n; i++) {
		double complex root = exact.mode[i].re + I*exact.mode[i].omega;

		worst = fmax(worst, cabs(eigenvalue(&rom, root) - root)/cabs(root));
		of_full = fmax(of_full, cabs(eigenvalue(&full, root) - root)/cabs(root));
		least = fmin(least, exact.mode[i].ratio);
	}
	ok(worst < tolerance && of_full < 1e-6 && least > 1e-4, "%s: six eigenvalues of 20 modes with "
	   "shapes to %.1e, of a basis to %.1e; least ratio %.2g", what, worst, of_full, least);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&full);
	hawser_damped_clear(&exact);
	hawser_modes_clear(&modes);
}

/* --- the cubic spring --- */

/* Restoring forces of the expansion and of the exact energy differ by the fourth order, and the energy
 * is by k3 s^4/4 larger than without the spring. */
static void cubic(void)
{
	const struct hawser_scene scene = {.model = {.modes = 7, .condense = HAWSER_CONDENSE_NONE}};
	struct hawser_attachment attach[3] = {several[0], several[1], several[2]};
	struct hawser_modes modes;
	struct hawser_rom quartic, exact, without;
	double difference[2] = {0.0}, u[10] = {0.0}, v[10] = {0.0}, f[10], g[10];
	double s = 0.0, more, worst = 0.0;
	int n;

	attach[2].absorber_cubic = 2e5;
	attach[0].absorber_damping = attach[1].absorber_damping = attach[2].damper[1] = 0.0;
	if (!solve(&modes, attach, 3, 7))
		return;
	if (!ok(!hawser_rom_build(&quartic, &modes, &scene, &report) &&
	        !hawser_rom_build_exact(&exact, &modes, NULL, &report), "built: %s", report.message))
		return;
	modes.statics.attached[2].absorber_cubic = 0.0;
	if (!ok(!hawser_rom_build_exact(&without, &modes, NULL, &report), "without: %s", report.message))
		return;
	n = exact.n;
	ok(quartic.n == 8 && strstr(quartic.label[7], "shape"), "the static shape of its force is a "
	   "coordinate: %s", quartic.label[quartic.n - 1]);
	for (int i = 0; i < 2; i++) {
		for (int j = 0; j < n; j++) {
			u[j] = 2e-5*(i + 1)*(1.0 - 0.3*j);
			s += i ? u[j]*modes.stroke[3*j + 2] : 0.0;
		}
		hawser_rom_restoring(&quartic, f, u);
		hawser_rom_restoring(&exact, g, u);
		for (int j = 0; j < n; j++)
			difference[i] = fmax(difference[i], fabs(f[j] - g[j]));
	}
	ok(fabs(log2(difference[1]/difference[0]) - 4.0) < 0.2, "expanded and exact forces differ in order "
	   "%.3f", log2(difference[1]/difference[0]));
	/* J: k3 (s d)^4/4 */
	more = hawser_rom_energy(&exact, u, v) - hawser_rom_energy(&without, u, v);
	more *= exact.force*exact.length;
	close_to(more, 0.25*2e5*pow(s*inclined.d, 4.0), 1e-6, "the energy of the cubic spring");
	close_to(hawser_rom_energy(&exact, u, v), hawser_rom_energy(&quartic, u, v), 1e-3, "energies");
	hawser_rom_restoring(&exact, f, u);
	for (int j = 0; j < n; j++) {
		double h = 3e-8, up, down;

		u[j] += h;
		up = hawser_rom_energy(&exact, u, v);
		u[j] -= 2.0*h;
		down = hawser_rom_energy(&exact, u, v);
		u[j] += h;
		worst = fmax(worst, fabs((up - down)/(2.0*h) - f[j])/fabs(f[0]));
	}
	ok(worst < 1e-5, "forces are derivatives of the energy: %.1e", worst);
	hawser_rom_clear(&quartic);
	hawser_rom_clear(&exact);
	hawser_rom_clear(&without);
	hawser_modes_clear(&modes);
}

/* --- condensation --- */

/* The cubic term of a mode with the others condensed, by elimination of the other modes of a basis,
 * C - sum of Q_0^0s Q_s^00 over their stiffness, absorbers among them. */
static void condensation(int number, int basis)
{
	const struct hawser_scene raw = {.model = {.modes = 1, .condense = HAWSER_CONDENSE_NONE}};
	const struct hawser_scene condensed = {.model = {.modes = 1, .inertia = HAWSER_INERTIA_NONE}};
	struct hawser_attachment attach[3] = {several[0], several[1], several[2]};
	struct hawser_modes first, modes, all;
	struct hawser_rom one, many;

	attach[0].absorber_damping = attach[1].absorber_damping = attach[2].damper[1] = 0.0;
	if (!solve(&first, attach, 3, number + 1))
		return;
	if (!ok(!hawser_modes_select(&modes, &first, &number, 1, &report) &&
	        !hawser_modes_basis(&all, &modes.statics, basis, basis, &report) &&
	        !hawser_rom_build(&one, &modes, &condensed, &report) &&
	        !hawser_rom_build(&many, &all, &raw, &report), "built: %s", report.message))
		return;
	close_to(cubic_of(&one, 0, 0, 0, 0), condensed_cubic(&many, number), 1e-6,
	         "the condensed cubic term of a mode with strokes");
	hawser_rom_clear(&one);
	hawser_rom_clear(&many);
	hawser_modes_clear(&all);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&first);
}

/* At rest under a constant load an absorber has no stroke: the part of the kept modes is taken back by
 * that of the others, in first order. */
static void static_load(void)
{
	struct hawser_scene scene = {.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL,
	                                      .per_length = {0.0, 0.2, 0.0}, .extent = {0.0, 1.0}},
	                             .model = {.modes = 5, .inertia = HAWSER_INERTIA_NONE}};
	struct hawser_attachment attach[3] = {several[0], several[1], several[2]};
	struct hawser_modes modes;
	struct hawser_rom rom;
	double u[8], xyz[3], kept[3];
	const struct hawser_rom_moment moment = {.tau = 0.0, .omega = 1e-6};

	attach[0].absorber_damping = attach[1].absorber_damping = attach[2].damper[1] = 0.0;
	if (!solve(&modes, attach, 3, 5))
		return;
	if (!ok(!hawser_rom_build(&rom, &modes, &scene, &report), "built: %s", report.message))
		return;
	ok(rom.shapes.points == 6 && !strcmp(rom.shapes.name[3], "stroke_1") &&
	   !strcmp(rom.shapes.name[5], "stroke_3"), "strokes are points of the model: %s",
	   rom.shapes.name[3]);
	for (int j = 0; j < rom.n; j++)
		u[j] = 1e-6*rom.harmonic[0].f[j]/rom.K[j*(rom.n + 1)];
	for (int h = 0; h < rom.harmonics; h++)
		for (int i = 0; rom.harmonic[h].answer && i < 2*4*rom.shapes.points; i++)
			rom.harmonic[h].answer[i] *= 1e-6;
	hawser_rom_displacement(&rom, kept, 3, u);
	hawser_rom_displacement_at(&rom, xyz, 3, u, &moment);
	ok(fabs(kept[1]) > 1e-14 && hypot(xyz[0], xyz[1]) < 1e-5*fabs(kept[1]), "a static load moves no "
	   "absorber: %.1e of the modes, %.1e of all", kept[1], hypot(xyz[0], xyz[1]));
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

static void refusals(void)
{
	struct hawser_scene scene = {.model = {.modes = HAWSER_MODES_AUTO}};
	struct hawser_attachment at = several[2];
	struct hawser_modes modes;
	struct hawser_choice choice;
	struct hawser_rom rom;

	at.damper[1] = 0.0;
	if (!solve(&modes, &at, 1, 4))
		return;
	ok(hawser_rom_build(&rom, &modes, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "auto does not know absorbers"), "%s", report.message);
	scene.model.modes = 4;
	scene.load.present = 1;
	scene.load.per_length[1] = 1.0;
	ok(hawser_choose(&choice, &modes, &scene, 0.5, 1.5, 0.01, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "not weighed with absorbers"), "%s", report.message);
	hawser_modes_clear(&modes);
}

/* A massless absorber does not stretch its spring, so that under products of the coordinates with the
 * motion of an end its stroke is that of the kept modes, T_jks/omega_s^2, in the static response. */
static void moved(void)
{
	static const struct hawser_scene scene = {
		.support = {{.present = 0}, {.present = 1, .motion = {0.0, 0.04, 0.0}, .harmonic = 1}},
		.model = {.modes = 8, .condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_modes modes;
	struct hawser_rom rom;
	const double *K = NULL;
	double worst = 0.0, size = 0.0;
	int p = 0;

	if (!solve(&modes, several, 3, 8) ||
	    !ok(!hawser_rom_build(&rom, &modes, &scene, &report), "moved end: %s", report.message))
		return;
	while (p < rom.shapes.points && strcmp(rom.shapes.name[p], "stroke_3"))
		p++;
	for (int h = 0; h < rom.harmonics; h++)
		if (rom.harmonic[h].load_power == 1 && rom.harmonic[h].K)
			K = rom.harmonic[h].K;
	ok(K && p < rom.shapes.points, "an end moves, and a stroke is known");
	for (int k = 0; K && p < rom.shapes.points && k < rom.ends->modes; k++) {
		double left = rom.ends->second_shape[3*(k*rom.shapes.points + p) + 1];
		double signal = 0.04/rom.length;

		size = fmax(size, fabs(left));
		for (int s = 0; s < rom.n; s++)
			left -= K[k*rom.n + s]/(signal*rom.K[s*(rom.n + 1)])*
			        rom.shapes.shape[3*(s*rom.shapes.points + p) + 1];
		worst = fmax(worst, fabs(left));
	}
	ok(worst < 1e-9*size, "strokes by products with a moved end: %.1e of %.1e", worst, size);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

CASE(property_rom_absorber)
{
	linear((struct hawser_scene){.damping = {.kind = HAWSER_DAMPING_NONE}}, "only dampers", 1e-5);
	linear((struct hawser_scene){.damping = {.kind = HAWSER_DAMPING_ALPHA, .alpha = 0.4}}, "alpha",
	       1e-5);
	linear((struct hawser_scene){.damping = {.kind = HAWSER_DAMPING_RAYLEIGH, .mass = 0.03,
	                                         .stiffness = 0.004}}, "Rayleigh", 1e-5);
	linear((struct hawser_scene){.damping = {.kind = HAWSER_DAMPING_RATIO, .ratio = 0.02, .ratios = 3,
	                                         .ratio_next = {0.007, 0.013}}}, "ratios", 1e-5);
	cubic();
	condensation(0, 20);
	condensation(4, 30);
	if (getenv("HAWSER_LONG"))
		condensation(2, 30);
	static_load();
	moved();
	refusals();
	return done_testing();
}

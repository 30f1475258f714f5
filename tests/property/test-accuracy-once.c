/* The error that is stated of one motion (hawser_accuracy_once) against the difference from a model of
 * many more modes, whose motion is computed by itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/accuracy.h>

#include "hawser/integrate.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { MANY = 14, STEPS = 64 };

static struct hawser_report report;

/* A taut span and a conductor, with loads across their planes, and a sagging cable in its plane. */
static const char *const scenes[] = {
	"cable: {EA: 40 MN, rho: 1.5}\nspan: {d: 100 m, h: 10 m}\ntension: {H: 22 kN}\n"
	"damping: {ratio: 1 %}\nload: {frame: global, per_length: [0, 0, 0.4]}\n"
	"model: {condense: static}\n",
	"cable: {EA: 31.2 MN, rho: 1.628}\nspan: {d: 420 m, h: 18 m}\ntension: {H: 27.5 kN}\n"
	"damping: {ratio: 0.4 %}\nload: {frame: global, per_length: [0, 0, 0.02]}\n"
	"model: {condense: static}\n",
	"cable: {EA: 12 MN, rho: 1}\nspan: {d: 60 m, h: 0 m}\ntension: {H: 3.6 kN}\n"
	"damping: {ratio: 2 %}\nload: {frame: global, per_length: [0, 0.2, 0]}\n"
	"model: {condense: static}\n",
};

struct solved {
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;
	struct hawser_rom rom;
};

static int solve(struct solved *it, const char *text, int n)
{
	struct hawser_modes_options options = {.n = n};

	memset(it, 0, sizeof *it);
	return !read_text(&it->scene, text, NULL, &report) &&
	       !hawser_statics_scene(&it->statics, &it->scene, &report) &&
	       !hawser_modes_solve(&it->modes, &it->statics, &options, &report) &&
	       !hawser_rom_build(&it->rom, &it->modes, &it->scene, &report);
}

static void clear(struct solved *it)
{
	hawser_rom_clear(&it->rom);
	hawser_modes_clear(&it->modes);
	hawser_scene_clear(&it->scene);
}

/* Half the range of a component at a shape point in the last period, the largest of all. */
static double size(const struct solved *it, double omega, double periods, struct hawser_trajectory *run)
{
	struct hawser_integrate_options options = {.omega = omega, .until = periods*2.0*M_PI/omega,
	                                           .every = 2.0*M_PI/omega/STEPS, .rtol = 1e-8};
	const struct hawser_rom *rom = &it->rom;
	double most = 0.0;

	if (hawser_integrate(run, rom, &options, &report))
		return NAN;
	for (int k = 0; k < 3*rom->shapes.points; k++) {
		double low = INFINITY, high = -INFINITY;

		for (int row = run->rows - STEPS; row < run->rows; row++) {
			struct hawser_rom_moment moment = {.tau = omega*run->time[row], .omega = omega};
			double v[3];

			hawser_rom_displacement_at(rom, v, k/3, run->state + 2*(size_t)row*(size_t)rom->n, &moment);
			low = fmin(low, v[k%3]);
			high = fmax(high, v[k%3]);
		}
		most = fmax(most, (high - low)/2.0);
	}
	return most;
}

static void check(const char *text, int few, double ratio, const char *name)
{
	struct hawser_trajectory run[2] = {{0}, {0}};
	struct hawser_accuracy_fixed stated;
	struct hawser_accuracy_motion motion;
	struct solved it[2];
	double periods = 40.0, off;

	if (!ok(solve(&it[0], text, few) && solve(&it[1], text, MANY), "%s: models", name))
		goto end;
	motion.omega = ratio*it[0].modes.mode[0].omega;
	off = fabs(size(&it[0], motion.omega, periods, &run[0])/
	           size(&it[1], motion.omega, periods, &run[1]) - 1.0);
	motion.time = run[0].time[run[0].rows - 1];
	motion.state = run[0].state + 2*(size_t)(run[0].rows - 1)*(size_t)it[0].rom.n;
	ok(!hawser_accuracy_once(&stated, &it[0].rom, &motion, few, &it[0].statics, &it[0].scene, &report),
	   "%s: an estimate", name);
	ok(off <= stated.estimated, "%s: stated %.1e, off by %.1e", name, stated.estimated, off);
end:
	hawser_trajectory_clear(&run[0]);
	hawser_trajectory_clear(&run[1]);
	clear(&it[0]);
	clear(&it[1]);
}

CASE(property_accuracy_once)
{
	check(scenes[0], 3, 0.7, "taut, out of the plane");
	check(scenes[1], 5, 0.8, "conductor");
	check(scenes[2], 2, 1.2, "in the plane");
	check(scenes[2], 4, 1.2, "in the plane, more modes");
	return done_testing();
}

/* Forces, tangents and energies from functions (rom/energy/quartic.h) against those from tensors; both
 * share the modes and their grid only. Random scenes, level, inclined and deep, at rest and
 * travelling, with condensed modes, second-order shapes, or neither. Then the choice between the two.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>
#include "rom/energy/kernel.h"
#include "rom/energy/quartic.h"
#include "rom/terms/vary.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define WITHIN 1e-13 /* of the largest component; tensors themselves are accurate to about 1e-14 */

enum { STATES = 7 }; /* not a multiple of the number of lanes */

static uint64_t seed = 88172645463325252u;

static double uniform(double low, double high)
{
	seed ^= seed << 13;
	seed ^= seed >> 7;
	seed ^= seed << 17;
	return low + (high - low)*(double)(seed >> 11)/9007199254740992.0;
}

struct example {
	const char *name;
	double h, EA[2], sag[2]; /* m, MN, m */
	double speed;            /* m/s; 0: at rest */
	const char *condense;
	int n;
};

static const struct example examples[] = {
	{"level, raw", 0.0, {40.0, 500.0}, {2.0, 8.0}, 0.0, "none", 9},
	{"inclined, raw", 61.0, {40.0, 500.0}, {2.0, 8.0}, 0.0, "none", 12},
	{"level, condensed", 0.0, {40.0, 500.0}, {2.0, 8.0}, 0.0, "static", 7},
	{"inclined, condensed", 61.0, {40.0, 500.0}, {2.0, 8.0}, 0.0, "static", 16},
	{"deep, raw", 7.0, {40.0, 80.0}, {25.0, 60.0}, 0.0, "none", 11},
	{"deep, condensed", 7.0, {40.0, 80.0}, {25.0, 60.0}, 0.0, "static", 13},
	{"stiff, condensed", 23.0, {2e4, 4e4}, {3.0, 9.0}, 0.0, "static", 8},
	{"travelling, raw", 13.0, {40.0, 500.0}, {2.0, 8.0}, 4.85, "none", 8},
	{"travelling, condensed", 13.0, {40.0, 500.0}, {2.0, 8.0}, 4.85, "static", 9},
};

static enum hawser_status scene_of(struct hawser_scene *scene, const struct example *e,
                                   struct hawser_report *report)
{
	char text[1024], travel[64] = "";

	if (e->speed > 0.0)
		snprintf(travel, sizeof travel, "travel: {speed: %g m/s, hold: tension}\n", e->speed);
	snprintf(text, sizeof text,
	         "cable: {EA: %.6g MN, rho: %.6g kg/m}\nspan: {d: 200 m, h: %g m}\n"
	         "tension: {sag: %.6g m}\ndamping: {alpha: 0.06 kg/m/s}\n"
	         "load: {frame: global, per_length: [0, 0.83 N/m, 0.77 N/m]}\n%s"
	         "model: {modes: %d, condense: %s}\n",
	         uniform(e->EA[0], e->EA[1]), uniform(1.3, 7.0), e->h, uniform(e->sag[0], e->sag[1]),
	         travel, e->n, e->condense);
	return read_text(scene, text, NULL, report);
}

static enum hawser_status model_of(struct hawser_rom *rom, const struct example *e,
                                   struct hawser_report *report)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = {.n = e->n};
	enum hawser_status status = scene_of(&scene, e, report);

	if (status)
		return status;
	status = hawser_statics_scene(&statics, &scene, report);
	if (!status)
		status = hawser_modes_solve(&modes, &statics, &options, report);
	if (!status)
		status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return status;
}

/* Largest difference of two arrays relative to the largest entry. */
static double apart(const double *x, const double *y, size_t count)
{
	double worst = 0.0, largest = 0.0;

	for (size_t i = 0; i < count; i++) {
		worst = fmax(worst, fabs(x[i] - y[i]));
		largest = fmax(largest, fabs(y[i]));
	}
	return worst/largest;
}

static void take(struct hawser_rom *rom, int by_function)
{
	for (int task = 0; task < HAWSER__TASKS; task++)
		rom->kernel->by_function[task] = by_function;
}

/* force [STATES][n], tangent [STATES][n][n], and energy [STATES], one by one. */
static void one_by_one(const struct hawser_rom *rom, double *force, double *tangent, double *energy,
                       const double *u)
{
	size_t n = (size_t)rom->n;
	double rest[HAWSER_ROM_MAX] = {0.0};

	for (size_t i = 0; i < STATES; i++) {
		hawser_rom_tangent(rom, force + i*n, tangent + i*n*n, u + i*n);
		hawser_rom_restoring(rom, force + i*n, u + i*n);
		energy[i] = hawser_rom_energy(rom, u + i*n, rest);
	}
}

/* States of amplitude `size`: the first out of the plane, the second in it, the third symmetric about
 * mid-span and in the plane, the fourth besides antisymmetric out of it, if the cable is its own mirror
 * image. */
static void set_states(double *u, const struct hawser_rom *rom, double size)
{
	const struct hawser__quartic *q = rom->kernel->quartic;

	for (int i = 0; i < STATES*rom->n; i++)
		u[i] = uniform(-size, size);
	for (int j = 0; j < rom->n; j++)
		u[(j < q->in ? 0 : rom->n) + q->index[j]] = 0.0;
	for (int j = 0; j < rom->n; j++) {
		if (q->kind[j] != 0)
			u[2*rom->n + q->index[j]] = 0.0;
		if (q->kind[j] != 0 && q->kind[j] != 3)
			u[3*rom->n + q->index[j]] = 0.0;
	}
}

static int same_blocks(const struct hawser_rom *rom, const double *force, const double *tangent,
                       const double *u)
{
	size_t n = (size_t)rom->n, size = STATES*n*(n + 1);
	double *work = malloc((hawser__rom_tangents_work(rom, STATES) + 1)*sizeof *work);
	double *lanes_work = malloc(HAWSER_LANES_WORK(n)*sizeof *work);
	double *f = malloc(3*size*sizeof *f), *T = f + STATES*n, *lanes = f + size;
	double *slope = lanes + 2*n*HAWSER_LANES, *want = lanes + size, *want_T = want + STATES*n;
	double worst = 0.0;
	int same = 1;

	if (!work || !f || !lanes_work)
		return 0;
	/* those of a period have the terms that vary with the phase too */
	memcpy(want, force, STATES*n*sizeof *want);
	memcpy(want_T, tangent, STATES*n*n*sizeof *want);
	hawser__rom_vary_all(rom, want, want_T, u, STATES);
	hawser__rom_tangents(rom, f, NULL, u, STATES, work);
	worst = apart(f, want, STATES*n);
	hawser__rom_tangents(rom, f, T, u, STATES, work);
	worst = fmax(worst, fmax(apart(f, want, STATES*n), apart(T, want_T, STATES*n*n)));
	for (size_t i = 0; i < n*HAWSER_LANES; i++)
		lanes[i] = u[i%HAWSER_LANES*n + i/HAWSER_LANES];
	hawser__rom_lanes(rom, lanes + n*HAWSER_LANES, slope, lanes, HAWSER_LANES, lanes_work);
	for (size_t i = 0; i < n*HAWSER_LANES; i++)
		same = same && lanes[n*HAWSER_LANES + i] ==
		               force[i%HAWSER_LANES*n + i/HAWSER_LANES];
	for (size_t i = 0; i < n*n*HAWSER_LANES; i++)
		same = same && slope[i] == tangent[i%HAWSER_LANES*n*n + i/HAWSER_LANES];
	free(work);
	free(lanes_work);
	free(f);
	return worst == 0.0 && same;
}

/* Whether what is exactly 0 among y [count] is exactly 0 among x. */
static int same_zeros(const double *x, const double *y, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (y[i] == 0.0 && x[i] != 0.0)
			return 0;
	return 1;
}

/* At amplitudes at which linear, quadratic and cubic forces dominate. */
static void compare(struct hawser_rom *rom, const char *name, double size)
{
	size_t n = (size_t)rom->n, each = STATES*(n + n*n + 1);
	double *u = malloc((STATES*n + 2*each)*sizeof *u), *f = u + STATES*n, *T = f + STATES*n;
	double *E = T + STATES*n*n, worst[3] = {0.0};

	if (!ok(u != NULL, "memory"))
		return;
	set_states(u, rom, size);
	take(rom, 0);
	one_by_one(rom, f, T, E, u);
	take(rom, 1);
	one_by_one(rom, f + each, T + each, E + each, u);
	for (size_t i = 0; i < STATES; i++) {
		worst[0] = fmax(worst[0], apart(f + each + i*n, f + i*n, n));
		worst[1] = fmax(worst[1], apart(T + each + i*n*n, T + i*n*n, n*n));
		worst[2] = fmax(worst[2], fabs(E[each + i]/E[i] - 1.0));
	}
	ok(worst[0] < WITHIN && worst[1] < WITHIN && worst[2] < WITHIN,
	   "%s, n = %d, amplitude %g: forces agree to %.1e, tangents to %.1e, energies to %.1e", name,
	   rom->n, size, worst[0], worst[1], worst[2]);
	ok(same_zeros(f + each, f, STATES*n) && same_zeros(T + each, T, STATES*n*n),
	   "%s: what is 0 by symmetry is exactly 0", name);
	ok(same_blocks(rom, f + each, T + each, u), "%s: several states at once are the same", name);
	free(u);
}

static void check_examples(void)
{
	int shapes = 0;

	for (size_t i = 0; i < sizeof examples/sizeof *examples; i++) {
		const struct example *e = &examples[i];
		struct hawser_report report = {.message = ""};
		struct hawser_rom rom = {.n = 0};

		if (ok(!model_of(&rom, e, &report) && rom.kernel->quartic, "%s: model %s", e->name,
		       report.message)) {
			shapes += rom.inertia.shapes;
			compare(&rom, e->name, 1e-7);
			compare(&rom, e->name, 2.3e-3);
			compare(&rom, e->name, 0.71);
		}
		hawser_rom_clear(&rom);
	}
	ok(shapes > 1, "%d second-order shapes among the coordinates", shapes);
}

/* Few modes are evaluated by tensors, many by functions, and then no tensors are compiled; a model
 * that is compiled again has tensors only. */
static void check_choice(void)
{
	static const struct example few = {"few", 10.0, {400.0, 400.0}, {5.0, 5.0}, 0.0, "static", 3};
	static const struct example many = {"many", 10.0, {400.0, 400.0}, {5.0, 5.0}, 0.0, "none", 45};
	struct hawser_rom rom = {.n = 0};
	double u[45], f[45], g[45], T[45*45], S[45*45];
	const int *by = NULL;
	char text[240];

	if (ok(!model_of(&rom, &few, NULL), "three modes")) {
		by = rom.kernel->by_function;
		ok(!by[HAWSER__FORCE] && !by[HAWSER__TANGENT] && !by[HAWSER__FORCES] &&
		   !by[HAWSER__TANGENTS], "are evaluated by tensors");
		hawser_rom_forces_text(&rom, text, sizeof text);
		ok(strncmp(text, "from tensors", 12) == 0, "the text: %s", text);
	}
	hawser_rom_clear(&rom);
	if (ok(!model_of(&rom, &many, NULL), "45 modes")) {
		by = rom.kernel->by_function;
		ok(by[HAWSER__FORCE] && by[HAWSER__TANGENT] && by[HAWSER__FORCES] &&
		   by[HAWSER__TANGENTS] && rom.kernel->rows == 0, "are evaluated by functions");
		hawser_rom_forces_text(&rom, text, sizeof text);
		ok(strncmp(text, "from strains", 12) == 0 && !strstr(text, "else"), "the text: %s", text);
		for (int j = 0; j < 45; j++)
			u[j] = uniform(-2e-3, 2e-3);
		hawser_rom_tangent(&rom, f, T, u);
		ok(!hawser_rom_compile(&rom, NULL) && !rom.kernel->quartic && rom.kernel->rows > 0,
		   "by tensors once they are compiled again");
		hawser_rom_tangent(&rom, g, S, u);
		ok(apart(f, g, 45) < WITHIN && apart(T, S, 45*45) < WITHIN, "with the same forces");
	}
	hawser_rom_clear(&rom);
}

CASE(property_rom_functions)
{
	check_examples();
	check_choice();
	return done_testing();
}

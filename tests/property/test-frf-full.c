/* The full-order response against time integration: at five points of stable branches, the orbit by
 * harmonic balance of B Table 4.4 line 2 with the exact strain energy must return to its initial
 * state after a period of time integration, with the same amplitude. The two methods share only the
 * force of the model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

#define SCENE "notebooks-data/scenes/b-table-4.4-line-2.yaml"
#define TIMES 256 /* output times per period */

static int functions(void)
{
	return getenv("HAWSER_LONG") ? 10 : 4;
}

/* The model, and its first frequency. */
static int build(struct hawser_rom *rom)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_report report = {0};
	int fine;

	fine = !hawser_scene_open(&scene, source_file(SCENE), NULL, 0, &report) &&
	       !hawser_statics_scene(&statics, &scene, &report) &&
	       !hawser_rom_build_full(rom, &statics, &scene, functions(), &report);
	hawser_scene_clear(&scene);
	ok(fine, "full-order model of %d coordinates %s", fine ? rom->n : 0, report.message);
	return fine;
}

/* Largest mid-span displacement |y| in a period, from equidistant samples and the parabola through
 * the three largest. */
static double largest(const struct hawser_trajectory *run, const struct hawser_rom *rom, int mid)
{
	double y[TIMES + 1], best = 0.0;

	for (int i = 0; i < run->rows && i <= TIMES; i++) {
		double xyz[3];

		hawser_rom_displacement(rom, xyz, mid, run->state + (size_t)i*2*rom->n);
		y[i] = fabs(xyz[1]);
	}
	for (int i = 0; i < TIMES; i++) {
		double a = y[(i + TIMES - 1)%TIMES], b = y[i], c = y[(i + 1)%TIMES];
		double bend = a - 2.0*b + c;

		if (b >= a && b >= c && bend < 0.0)
			best = fmax(best, b - (c - a)*(c - a)/(8.0*bend));
	}
	return best;
}

static void compare(const struct hawser_frf *frf, const struct hawser_rom *rom, int p)
{
	struct hawser_integrate_options options = {.omega = frf->point[p].omega, .rtol = 1e-11};
	const double *state = frf->state + (size_t)p*2*rom->n;
	double period = 2.0*M_PI/options.omega, gap = 0.0, size = 0.0, swing;
	struct hawser_trajectory run;
	struct hawser_report report = {0};
	int mid = 1;

	options.initial = state;
	options.until = period;
	options.every = period/TIMES;
	if (!ok(!hawser_integrate(&run, rom, &options, &report), "integrated %s", report.message))
		return;
	for (int j = 0; j < rom->n; j++) {
		double d = run.state[(size_t)(run.rows - 1)*2*rom->n + j] - state[j];

		gap += d*d;
		size += frf->coordinate[(size_t)p*rom->n + j]*frf->coordinate[(size_t)p*rom->n + j];
	}
	gap = sqrt(gap/size);
	ok(run.rows == TIMES + 1 && gap < 1e-6,
	   "Omega %.6f w1: back after a period to %.1e of its size", frf->point[p].omega/sqrt(rom->K[0]),
	   gap);
	swing = frf->probe[((size_t)p*frf->probes + mid)*3 + 1];
	ok(fabs(largest(&run, rom, mid)/swing - 1.0) < 1e-6,
	   "mid-span %.8f of the span, integrated %.8f", swing, largest(&run, rom, mid));
	hawser_trajectory_clear(&run);
}

/* --- a sag of 0.3: high harmonics of stiff coordinates --- */

static struct hawser_scene deep(void)
{
	struct hawser_scene scene = {.cable = {.EA = 12e6, .rho = 1.2}, .span = {50.0, 3.0}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_SAG;
	scene.tension.value = 15.0;
	scene.damping.kind = HAWSER_DAMPING_RATIO;
	scene.damping.ratio = 0.01;
	scene.load.present = 1;
	scene.load.extent[1] = 1.0;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.per_length[1] = 0.1;
	scene.load.per_length[2] = 0.12;
	return scene;
}

/* The amplitude of z at mid-span at the end of a short range about 2.55 rad/s. */
static double end_of(const struct hawser_rom *rom, double tolerance)
{
	struct hawser_frf_options options = {.method = "balance", .tolerance = tolerance,
		.step_max = 1.0, .from = 2.55*rom->time, .to = 2.552*rom->time};
	struct hawser_report report = {0};
	double z = NAN;
	struct hawser_frf frf;

	options.samples = HAWSER_NONE;
	if (ok(!hawser_frf_trace(&frf, rom, &options, &report), "tolerance %g %s", tolerance,
	       report.message))
		z = frf.probe[((size_t)(frf.points - 1)*(size_t)frf.probes + 1)*3 + 2];
	hawser_frf_clear(&frf);
	return z;
}

/* With the tolerance 1e-6 the first orbit is not determined by the harmonics that it is begun with; the
 * trace adds some instead of giving up. */
static void check_deep(void)
{
	struct hawser_scene scene = deep();
	struct hawser_statics statics;
	struct hawser_report report = {0};
	struct hawser_rom rom;

	if (!ok(!hawser_statics_scene(&statics, &scene, &report) &&
	        !hawser_rom_build_full(&rom, &statics, &scene, 10, &report), "the deep sag %s",
	        report.message))
		return;
	close_to(end_of(&rom, 1e-6), getenv("HAWSER_LONG") ? end_of(&rom, 1e-8) : 0.004431554232, 1e-6,
	         "mid-span as with the tolerance 1e-8");
	hawser_rom_clear(&rom);
}

CASE(property_frf_full)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {0};
	struct hawser_frf frf;
	struct hawser_rom rom;
	int stable, seen = 0;

	if (!build(&rom))
		return done_testing();
	options.method = "balance";
	options.from = (getenv("HAWSER_LONG") ? 0.85 : 0.93)*sqrt(rom.K[0]);
	options.to = (getenv("HAWSER_LONG") ? 1.2 : 1.08)*sqrt(rom.K[0]);
	options.step_max = getenv("HAWSER_LONG") ? 0.1 : 0.3;
	options.tolerance = 1e-8;
	options.samples = HAWSER_NONE; /* time integration is the check */
	stable = hawser_frf_trace(&frf, &rom, &options, &report) != HAWSER_OK;
	ok(!stable, "traced: %d points, %d events %s", frf.points, frf.events, report.message);
	ok(frf.events >= 2, "it folds");
	for (int p = stable = 0; p < frf.points; p++)
		stable += frf.point[p].unstable == 0;
	for (int p = 0; p < frf.points; p++) {
		if (frf.point[p].unstable)
			continue;
		if (seen++%(stable/5) == stable/10)
			compare(&frf, &rom, p);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	check_deep();
	return done_testing();
}

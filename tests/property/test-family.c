/* Motions followed in a parameter, against responses over the frequency of models that were made for
 * one value of the parameter: the events of the curve are events of the response, and the amplitudes
 * at its end are those of the response.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/frf.h>
#include <hawser/scene_family.h>

#include "tests/tap.h"

#define ASIDE 0.25 /* range of the response around the frequency, relative */

static int open_model(struct hawser_rom *rom, const char *name)
{
	const char *path = source_file("tests/reference/%s.json", name);

	return ok(!hawser_rom_open(rom, path, NULL), "%s read", path);
}

/* Least relative distance from omega of an event of this kind in the response of the model. */
static double nearest(const struct hawser_rom *rom, double omega, enum hawser_event_kind kind)
{
	double best = INFINITY;

	for (int back = 0; back < 2; back++) {
		struct hawser_frf_options options = {.from = (back ? 1.0 + ASIDE : 1.0 - ASIDE)*omega,
			.to = (back ? 1.0 - ASIDE : 1.0 + ASIDE)*omega, .method = "shooting"};
		struct hawser_frf frf;

		if (!ok(!hawser_frf_trace(&frf, rom, &options, NULL), "a response"))
			return NAN;
		for (int e = 0; e < frf.events; e++)
			if (frf.event[e].kind == kind)
				best = fmin(best, fabs(frf.event[e].omega/omega - 1.0));
		hawser_frf_clear(&frf);
	}
	return best;
}

static void follow_factor(const char *name, enum hawser_factor factor, double omega, double from,
                          double to, int events)
{
	struct hawser_frf_options options = {.from = from, .to = to};
	struct hawser_report report = {.message = ""};
	struct hawser_rom_family family;
	const struct hawser_rom *there;
	struct hawser_rom rom;
	struct hawser_frf frf;
	double worst = 0.0;

	if (!open_model(&rom, name))
		return;
	ok(!hawser_factor_open(&family, &rom, factor, omega, &report), "a family %s", report.message);
	options.family = &family;
	ok(!hawser_frf_trace(&frf, &rom, &options, &report), "%s over factor.%s at %g %s", name,
	   hawser_factor_name(factor), omega, report.message);
	for (int e = 0; e < frf.events; e++) {
		const struct hawser_frf_event *event = &frf.event[e];

		if (!ok(!family.model(family.context, &there, event->parameter, NULL), "a model"))
			break;
		worst = fmax(worst, nearest(there, omega, event->kind));
	}
	ok(frf.events == events && worst < 1e-8, "%d events, at these frequencies too: %.1e", frf.events,
	   worst);
	ok(frf.end == HAWSER_END_RANGE && frf.sample_gap < 1e-7 && frf.sample_disagreements == 0,
	   "to the end; by shooting the same: %.1e", frf.sample_gap);
	hawser_frf_clear(&frf);
	hawser_factor_close(&family);
	hawser_rom_clear(&rom);
}

static int read_scene(struct hawser_scene *scene, const char *key, double value)
{
	static const char *const set[] = {"model.modes=4", "model.condense=static", "model.inertia=none",
	                                  "span.h=0"};
	char text[80];
	const char *path = source_file("notebooks-data/scenes/b-table-4.2.yaml");
	const char *sets[5];
	FILE *stream;
	int failed;

	memcpy(sets, set, sizeof set);
	snprintf(text, sizeof text, "%s=%.17g", key, value);
	sets[4] = text;
	if (!(stream = fopen(path, "r")))
		return ok(0, "%s", path);
	failed = hawser_scene_read(scene, stream, path, sets, 5, NULL) != HAWSER_OK;
	fclose(stream);
	return ok(!failed, "%s with %s", path, text);
}

/* The model of the scene by the usual way. */
static int make(struct hawser_rom *rom, const struct hawser_scene *scene)
{
	struct hawser_modes_options options = {.n = scene->model.modes};
	struct hawser_statics statics;
	struct hawser_modes modes;
	int failed = hawser_statics_scene(&statics, scene, NULL) ||
	             hawser_modes_solve(&modes, &statics, &options, NULL);

	failed = failed || hawser_rom_build(rom, &modes, scene, NULL);
	hawser_modes_clear(&modes);
	return ok(!failed, "its model");
}

/* Amplitudes (m) of the response of a scene at omega rad/s, in `probe` [3 probes]. */
static int respond(double *probe, const char *key, double value, double omega, int probes)
{
	struct hawser_frf_options options = {.samples = HAWSER_NONE};
	struct hawser_scene scene;
	struct hawser_rom rom;
	struct hawser_frf frf;
	int fine;

	if (!read_scene(&scene, key, value) || !make(&rom, &scene))
		return 0;
	options.from = omega*rom.time;
	options.to = 1.001*options.from;
	fine = ok(!hawser_frf_trace(&frf, &rom, &options, NULL) && frf.probes == probes, "its response");
	for (int k = 0; fine && k < 3*probes; k++)
		probe[k] = frf.probe[k]*rom.length;
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_scene_clear(&scene);
	return fine;
}

/* The amplitudes at the end of the range; frequency in rad/s. */
static void follow_scene(const char *key, double from, double to, double omega)
{
	struct hawser_frf_options options = {.from = from, .to = to, .samples = 2, .tolerance = 1e-8,
		.step_max = 0.1};
	struct hawser_report report = {.message = ""};
	struct hawser_rom_family family;
	struct hawser_scene scene;
	struct hawser_rom rom;
	struct hawser_frf frf;
	double probe[30], worst = 0.0, most = 0.0;

	if (!read_scene(&scene, key, from) || !make(&rom, &scene))
		return;
	ok(!hawser_scene_family_open(&family, &scene, key, from, to, from, omega, &report), "a family %s",
	   report.message);
	options.family = &family;
	if (!ok(!hawser_frf_trace(&frf, &rom, &options, &report), "over %s %s", key, report.message) ||
	    !ok(frf.end == HAWSER_END_RANGE && frf.probes <= 10, "to the end, %d points", frf.points) ||
	    !respond(probe, key, to, omega, frf.probes))
		goto done;
	for (int k = 0; k < 3*frf.probes; k++) {
		double here = frf.probe[((size_t)frf.points - 1)*3*frf.probes + k]*rom.length;

		worst = fmax(worst, fabs(here - probe[k]));
		most = fmax(most, probe[k]);
	}
	ok(worst < 1e-6*most, "%s = %g: the same amplitudes: %.1e of %.3g m", key, to, worst/most, most);
	ok(fabs(frf.point[frf.points - 1].omega/rom.time/omega - 1.0) < 1e-12, "at the same frequency");
	ok(frf.sample_gap < 1e-6 && frf.sample_disagreements == 0, "by shooting the same: %.1e",
	   frf.sample_gap);
done:
	hawser_frf_clear(&frf);
	hawser_scene_family_close(&family);
	hawser_rom_clear(&rom);
	hawser_scene_clear(&scene);
}

/* Accelerations of the model at `value`, at a state of size 1e-3. */
static int accelerate(double *to, const struct hawser_rom_family *family, double value)
{
	const struct hawser_rom *rom;
	double u[16], v[16];

	if (!ok(!family->model(family->context, &rom, value, NULL) && rom->n <= 16, "a model"))
		return 0;
	for (int j = 0; j < rom->n; j++) {
		u[j] = 1e-3*cos(2.385*j + 0.3);
		v[j] = 1e-3*sin(1.37*j - 0.2);
	}
	hawser_rom_acceleration(rom, to, u, v, 0.7, 1.2);
	return rom->n;
}

/* The models of many values are interpolated: they are those that are made. */
static void interpolate(const char *key, double from, double to)
{
	enum { VALUES = 5, MORE = 30 };
	struct hawser_rom_family family;
	struct hawser_scene scene;
	double made[VALUES][16], now[16], worst = 0.0, most = 0.0;

	if (!read_scene(&scene, key, from))
		return;
	ok(!hawser_scene_family_open(&family, &scene, key, from, to, from, 1.2, NULL), "a family");
	for (int round = 0; round < 2; round++) {
		for (int i = 0; i < VALUES; i++) {
			double *a = round ? now : made[i];
			int n = accelerate(a, &family, from + (to - from)*(0.03 + 0.21*i));

			for (int j = 0; j < n; j++) {
				worst = fmax(worst, fabs(a[j] - made[i][j]));
				most = fmax(most, fabs(a[j]));
			}
		}
		for (int i = 0; i < MORE; i++)
			(void)accelerate(now, &family, from + (to - from)*i/MORE);
	}
	ok(worst > 0.0 && worst < 1e-9*most, "%s: interpolated models are those that are made: %.1e", key,
	   worst/most);
	hawser_scene_family_close(&family);
	hawser_scene_clear(&scene);
}

CASE(property_family)
{
	interpolate("tension.T0", 150e3, 160e3);
	follow_factor("duffing-nlvib-01", HAWSER_FACTOR_LOAD, 1.2, 0.05, 4.0, 2);
	follow_factor("pair-2to1", HAWSER_FACTOR_LOAD, 1.01, 0.05, 1.5, 3);
	follow_factor("pair-2to1", HAWSER_FACTOR_DAMPING, 0.99, 3.0, 0.5, 1);
	/* through the crossover of the level span, where the first two modes in the plane cross; and with
	 * another unit of length */
	follow_scene("tension.T0", 150e3, getenv("HAWSER_LONG") ? 110e3 : 130e3, 2.2);
	follow_scene("span.d", 250.0, getenv("HAWSER_LONG") ? 230.0 : 240.0, 1.2);
	follow_scene("damping.alpha", 0.2, getenv("HAWSER_LONG") ? 0.05 : 0.13, 1.2);
	return done_testing();
}

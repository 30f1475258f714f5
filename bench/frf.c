/* bench/frf.c - cost of a tolerance: the chairlift response (B Table 4.2, five modes, 0.6 to 3.3
 * times the first frequency) at decreasing tolerances, with the error of its events and the time.
 *
 * Verifies first: for every tolerance the events must be those of the smallest one, in the same
 * order. Errors are relative, in Omega, against the run at 1e-12.
 *
 *   frf SCENE
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include <hawser/hawser.h>

#include "bench/clock.h"

static enum hawser_status model(struct hawser_rom *rom, const char *path,
                                struct hawser_report *report)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = {.tolerance = 1e-11};
	enum hawser_status status = hawser_scene_open(&scene, path, NULL, 0, report);

	if (status)
		return status;
	options.n = scene.model.modes;
	if (!(status = hawser_statics_scene(&statics, &scene, report)) &&
	    !(status = hawser_modes_solve(&modes, &statics, &options, report)))
		status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return status;
}

/* Largest relative difference of the events' Omega; infinite when the lists differ. */
static double event_error(const struct hawser_frf *frf, const struct hawser_frf *reference)
{
	double worst = 0.0;

	if (frf->events != reference->events)
		return INFINITY;
	for (int i = 0; i < frf->events; i++) {
		if (frf->event[i].kind != reference->event[i].kind)
			return INFINITY;
		worst = fmax(worst, fabs(frf->event[i].omega/reference->event[i].omega - 1.0));
	}
	return worst;
}

static double largest_stated(const struct hawser_frf *frf)
{
	double worst = 0.0;

	for (int i = 0; i < frf->points; i++)
		worst = fmax(worst, frf->point[i].liouville);
	return worst;
}

static int run(const struct hawser_rom *rom, struct hawser_frf_options options, double tolerance,
               const struct hawser_frf *reference)
{
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	double wall = clock_secs(), cpu = cpu_secs(), error;

	options.tolerance = tolerance;
	if (hawser_frf_trace(&frf, rom, &options, &report)) {
		printf("%9.0e  %s\n", tolerance, report.message);
		hawser_frf_clear(&frf);
		return 1;
	}
	wall = clock_secs() - wall;
	cpu = cpu_secs() - cpu;
	error = event_error(&frf, reference);
	printf("%9.0e %7d %7d %12.1e %12.1e %9.3f %9.3f %9.1f\n", tolerance, frf.points, frf.events,
	       error, largest_stated(&frf), wall, cpu, 1e6*cpu/frf.points);
	hawser_frf_clear(&frf);
	return !isfinite(error);
}

int main(int argc, char **argv)
{
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf reference;
	struct hawser_report report = {.message = ""};
	struct hawser_frf_options options = {.method = NULL};
	int failed = 0;

	if (argc != 2 || model(&rom, argv[1], &report)) {
		fprintf(stderr, "frf: %s\n", argc != 2 ? "give a scene" : report.message);
		return 1;
	}
	options.from = 0.6*sqrt(rom.K[0]);
	options.to = 3.3*sqrt(rom.K[0]);
	options.tolerance = 1e-12;
	if (hawser_frf_trace(&reference, &rom, &options, &report)) {
		fprintf(stderr, "frf: %s\n", report.message);
		return 1;
	}
	puts("tolerance  points  events  event error Liouville gap  wall (s)   cpu (s)  us/point");
	for (double tolerance = 1e-6; tolerance > 0.5e-11; tolerance /= 10.0)
		failed |= run(&rom, options, tolerance, &reference);
	hawser_frf_clear(&reference);
	hawser_rom_clear(&rom);
	return failed;
}

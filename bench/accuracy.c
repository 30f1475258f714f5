/* bench/accuracy.c - do responses keep the accuracy that was asked for, and at what cost? Each scene is
 * followed with modes chosen for 1 % and for 0.05 %, and compared with a model that keeps many more
 * (all of the lowest ones): the distance of folds and peaks is what hawser_accuracy_distance says.
 *
 *     bench/accuracy [-j MODES] [-a ACCURACY,ACCURACY...] [SCENE from to]...
 *
 * from and to are multiples of the first frequency; without scenes, ten from notebooks-data/scenes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/hawser.h>

#include "bench/clock.h"

static const struct {
	const char *name;
	double from, to;
} scenes[] = {
	{"b-table-4.4-line-1", 0.8, 1.3}, {"b-table-4.4-line-2", 0.8, 1.3}, {"b-table-4.5", 0.8, 1.3},
	{"b-table-5.4", 0.8, 1.3}, {"bridge-stay", 0.8, 1.3}, {"guide-rope", 0.8, 1.3},
	{"level-two-to-one", 0.8, 1.3}, {"deep-sag-light", 0.8, 1.3}, {"b-table-4.2", 0.7, 0.9},
	{"inclined", 0.8, 1.3},
};

static struct hawser_report report;

static int fail(const char *name)
{
	printf("%-20s failed: %s\n", name, report.message);
	fflush(stdout);
	return 1;
}

/* The lowest `n` modes, followed finely. */
static int judge(struct hawser_frf *frf, struct hawser_rom *rom,
                 const struct hawser_statics *statics, const struct hawser_scene *scene, int n,
                 double from, double to)
{
	struct hawser_modes_options modes_options = {.n = n};
	struct hawser_frf_options options = hawser_frf_defaults();
	struct hawser_modes modes;

	options.from = from;
	options.to = to;
	options.tolerance = 1e-7;
	options.max_points = 6000;
	if (hawser_modes_solve(&modes, statics, &modes_options, &report))
		return 1;
	if (hawser_rom_build(rom, &modes, scene, &report)) {
		hawser_modes_clear(&modes);
		return 1;
	}
	hawser_modes_clear(&modes);
	return hawser_frf_trace(frf, rom, &options, &report) != HAWSER_OK;
}

static int one(const char *path, const char *name, double from, double to, int n,
               const double *accuracies, int count)
{
	static const char *const set[] = {"model.condense=static"};
	struct hawser_modes_options first = {.n = 1};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	double unit, start, seconds, used;

	if (hawser_scene_open(&scene, path, set, 1, &report) ||
	    hawser_statics_scene(&statics, &scene, &report) ||
	    hawser_modes_solve(&modes, &statics, &first, &report))
		return fail(name);
	unit = modes.mode[0].omega;
	hawser_modes_clear(&modes);
	start = cpu_secs();
	if (judge(&frf, &rom, &statics, &scene, n, from*unit, to*unit))
		return fail(name);
	seconds = cpu_secs() - start;
	for (int i = 0; i < count; i++) {
		struct hawser_accuracy accuracy;
		struct hawser_accuracy_options options = hawser_accuracy_defaults();
		double distance = NAN;
		enum hawser_status status;

		options.accuracy = accuracies[i];
		options.frf.from = from*unit;
		options.frf.to = to*unit;
		start = cpu_secs();
		status = hawser_accuracy_trace(&accuracy, &statics, &scene, &options, &report);
		used = cpu_secs() - start;
		if (status ||
		    hawser_accuracy_distance(&distance, &accuracy.frf, &accuracy.rom, &frf, &rom,
		                             0.1*accuracies[i], &report)) {
			fail(name);
		} else {
			printf("%-20s %7.2g %9.1e %9.1e %5s %5d %5d %5d %8.2f %8.2f\n", name,
			       accuracies[i], accuracy.estimated, distance,
			       accuracy.reached && distance <= accuracies[i] ? "yes" : "NO",
			       accuracy.rom.n, accuracy.tries, accuracy.frf.points, used, seconds);
		}
		fflush(stdout);
		hawser_accuracy_clear(&accuracy);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_scene_clear(&scene);
	return 0;
}

int main(int argc, char **argv)
{
	double accuracies[8] = {0.01, 0.0005};
	int n = 24, count = 2, i = 1;
	char path[512];

	for (; i + 1 < argc && argv[i][0] == '-'; i += 2) {
		if (argv[i][1] == 'j')
			n = atoi(argv[i + 1]);
		for (char *at = argv[i + 1]; argv[i][1] == 'a' && (at == argv[i + 1] || *at);) {
			if (at == argv[i + 1])
				count = 0;
			if (count == 8)
				break;
			accuracies[count++] = strtod(at, &at);
			at += *at == ',';
		}
	}
	printf("# distance: from a condensed model of %d modes; kept: whether reached and true\n", n);
	printf("%-20s %7s %9s %9s %5s %5s %5s %5s %8s %8s\n", "scene", "asked", "estimated",
	       "distance", "kept", "modes", "tries", "pts", "cpu_s", "judge_s");
	for (; i + 2 < argc; i += 3)
		one(argv[i], argv[i], atof(argv[i + 1]), atof(argv[i + 2]), n, accuracies, count);
	for (size_t k = 0; argc < 4 && k < sizeof scenes/sizeof *scenes; k++) {
		const char *source = getenv("SRCDIR");

		snprintf(path, sizeof path, "%s/notebooks-data/scenes/%s.yaml", source ? source : ".",
		         scenes[k].name);
		one(path, scenes[k].name, scenes[k].from, scenes[k].to, n, accuracies, count);
	}
	return 0;
}

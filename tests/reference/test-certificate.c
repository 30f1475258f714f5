/* Folds and peaks of nets' models, corrected in the mesh, against numbers of a prototype in another
 * language: harmonic balance of meshes with elements of degree 6 to 8, 7 and 9 harmonics, of which two
 * meshes agree to the digits given. With a damping ratio in place of the same damping by mass, a net of
 * one frequency has the same peak. A start that is far off is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/certificate.h>

#include "tests/tap.h"

static struct hawser_report report;

struct scene {
	const char *name;
	int slow;                 /* 1: waits for HAWSER_LONG */
	int n, kept[20], count;
	double from, to, fold[2]; /* rad/s; folds in the order of the curve, 0: none */
	const char *probe;
	int axis;
	double omega, size;       /* of its peak, rad/s and m; size 0: not given */
	double digits;            /* of the peak, relative */
};

static const struct scene scenes[] = {
	{"span", 0, 12, {0}, 0, 1.2, 1.16, {1.1692142, 1.19055385}, "c_mid", 2, 1.170087, 3.0704, 1e-5},
	{"stays", 0, 28, {0, 1, 2, 3, 4, 5, 6, 7, 9, 11, 19, 27}, 12, 1.285, 1.27,
	 {1.27295836, 1.28026692}, "c1_mid", 1, 1.274452, 2.1845, 1e-5},
	{"spans", 1, 18, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14, 16, 17}, 15, 1.265, 1.255,
	 {1.2581538, 1.26156595}, "c2_mid", 1, 1.259836, 2.7274, 1e-5},
	{"cells", 1, 9, {0}, 0, 35.2, 34.9, {34.9673864, 35.0377448}, "n32", 1, 0.0, 0.0, 0.0},
	{"strings", 0, 8, {0}, 0, 6.7, 7.0, {0.0, 0.0}, "b1_mid", 1, 6.8284655, 0.0, 1e-6},
	{"float", 0, 9, {0}, 0, 1.43, 1.45, {0.0, 0.0}, "M", 0, 1.441805, 0.238870, 1e-5},
	{"carriers", 1, 14, {0}, 0, 1.40, 1.42, {0.0, 0.0}, "c1_mid", 1, 1.411803, 0.30068, 1e-3},
	{"moved", 1, 8, {0}, 0, 2.67, 2.61, {2.62697, 2.6552826}, "c_mid", 1, 2.62975, 1.933, 1e-3},
};

/* A net, its model and the response of this. */
struct made {
	struct hawser_net net;
	struct hawser_net_rom_options options;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_landmark *peak;
	int peaks;
};

static int make(struct made *made, const struct scene *scene, const char *set)
{
	struct hawser_frf_options choice = {.method = "balance", .unjudged = 1, .step_max = 0.05,
		.samples = HAWSER_NONE, .tolerance = 1e-8, .event_tolerance = 1e-8};
	const char *path = source_file("tests/reference/net-rom-%s.yaml", scene->name);

	*made = (struct made){.options = {.n = scene->n, .kept = scene->count ? scene->kept : NULL,
	                                  .count = scene->count}};
	if (!ok(!hawser_net_open(&made->net, path, &set, set != NULL, &report), "%s: %s", scene->name,
	        report.message) ||
	    !ok(!hawser_net_rom_build(&made->rom, &made->modes, &made->net, &made->options, &report),
	        "  model %s", report.message))
		return 0;
	choice.from = scene->from*made->rom.time;
	choice.to = scene->to*made->rom.time;
	return ok(!hawser_frf_trace(&made->frf, &made->rom, &choice, &report) &&
	          !hawser_peaks(&made->peak, &made->peaks, &made->frf, &made->rom, &choice, 1e-3, &report),
	          "  response %s", report.message);
}

static void clear(struct made *made)
{
	free(made->peak);
	hawser_frf_clear(&made->frf);
	hawser_rom_clear(&made->rom);
	hawser_modes_clear(&made->modes);
	hawser_net_clear(&made->net);
}

/* The peak of a component alone. */
static struct hawser_landmark *peak_of(const struct made *made, const char *probe, int axis)
{
	for (int i = 0; i < made->peaks; i++)
		if (made->peak[i].kind == HAWSER_LANDMARK_PEAK && made->peak[i].axis == axis &&
		    strcmp(made->rom.shapes.name[made->peak[i].probe], probe) == 0)
			return &made->peak[i];
	return NULL;
}

static void compare(const struct made *made, const struct scene *scene)
{
	const struct hawser_landmark *peak = peak_of(made, scene->probe, scene->axis);
	struct hawser_certificate c;
	int folds = 0;

	if (!ok(peak != NULL, "  peak of the model") ||
	    !ok(!hawser_net_certify(&c, &made->net, &made->options, &made->rom, &made->frf, peak, 1, 0.0,
	                            &report), "  certificate %s", report.message))
		return;
	ok(c.refused == 0 && c.omitted == 0 && c.lengths > 0.0 && c.distance > 0.0, "  all are found");
	for (int k = 0; k < c.count; k++) {
		const struct hawser_certified *item = &c.item[k];

		ok(item->distance <= c.distance && item->tension > 0.0, "  distance and tension");
		if (item->kind == HAWSER_LANDMARK_FOLD && folds < 2) {
			close_to(item->exact_omega/made->rom.time, scene->fold[folds++],
			         scene->digits > 1e-4 ? 1e-5 : 1e-6, "  fold");
		} else if (item->kind == HAWSER_LANDMARK_PEAK && scene->omega > 0.0) {
			close_to(item->exact_omega/made->rom.time, scene->omega, fmax(scene->digits, 1e-6),
			         "  Omega of the peak");
			if (scene->size > 0.0)
				close_to(item->exact_size*made->rom.length, scene->size, 2.0*scene->digits,
				         "  the peak");
		}
	}
	ok(folds == (scene->fold[0] > 0.0 ? 2 : 0), "  folds");
}

/* One mode in a linear response: its ratio is a damping by mass of 2*ratio*omega. */
static void damped(void)
{
	const struct scene scene = {.name = "strings", .n = 8, .from = 6.7, .to = 7.0};
	static const char *const set[] = {"damping={ratio: 0.0088}", "damping={rayleigh: {mass: 0.12}}"};
	double omega[2] = {0.0}, size[2] = {0.0};

	for (int i = 0; i < 2; i++) {
		struct hawser_certificate c = {.count = 0};
		struct made made;

		if (make(&made, &scene, set[i]) &&
		    !hawser_net_certify(&c, &made.net, &made.options, &made.rom, &made.frf,
		                        peak_of(&made, "b1_mid", 1), 1, 0.0, &report) && c.count == 1) {
			ok(c.refused == 0 && c.distance < 1e-3, "  distance %g", c.distance);
			omega[i] = c.item[0].exact_omega;
			size[i] = c.item[0].exact_size;
		}
		clear(&made);
	}
	close_to(omega[0], omega[1], 1e-3, "  ratio and mass");
	close_to(size[0], size[1], 2e-2, "  amplitudes");
}

CASE(reference_certificate)
{
	for (size_t i = 0; i < sizeof scenes/sizeof *scenes; i++) {
		struct made made;

		if (scenes[i].slow && !getenv("HAWSER_LONG"))
			continue;
		if (make(&made, &scenes[i], NULL))
			compare(&made, &scenes[i]);
		clear(&made);
	}
	damped();
	return done_testing();
}

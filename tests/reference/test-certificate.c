/* Folds and peaks of nets' models, corrected in the mesh, against numbers of a prototype in another
 * language: harmonic balance of meshes with elements of degree 6 to 8, 7 and 9 harmonics, of which two
 * meshes agree to the digits given.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include <hawser/certificate.h>

#include "tests/tap.h"

static struct hawser_report report;

struct scene {
	const char *name;
	int n, kept[20], count;
	double from, to, fold[2];    /* rad/s; folds of the mesh in the order of the curve */
	const char *probe;
	int axis;
	double omega, size, distance; /* its peak; 0: none */
};

static const struct scene scenes[] = {
	{"span", 12, .from = 1.2, .to = 1.15, .fold = {1.1692142, 1.19055385}, .probe = "c_mid", .axis = 2, .omega = 1.170087, .size = 3.0704},
	{"stays", 28, {0, 1, 2, 3, 4, 5, 6, 7, 9, 11, 19, 27}, 12, 1.285, 1.27, {1.27295836, 1.28026692}, "c1_mid", 1, 1.274452, 2.1845},
	{"spans", 18, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14, 16, 17}, 15, 1.265, 1.255, {1.2581538, 1.26156595}, "c2_mid", 1, 1.259836, 2.7274},
	{"cells", 9, .from = 35.2, .to = 34.9, .fold = {34.9673864, 35.0377448}, .probe = "n12", .axis = 1, .omega = 34.989637, .size = .0886118},
	{"strings", 8, .from = 6.7, .to = 7.0, .probe = "b1_mid", .axis = 1, .omega = 6.8284655, .size = 0.6288215},
	{"float", 9, .from = 1.40, .to = 1.46, .probe = "M", .axis = 0, .omega = 1.441805, .size = 0.238870},
	{"moved", 8, .from = 2.67, .to = 2.61, .fold = {2.62697, 2.6552826}, .probe="c_quarter", .axis = 1},
};

CASE(reference_certificate)
{
	for (size_t i = 0; i < sizeof scenes/sizeof *scenes; i++) {
		const struct scene *scene = &scenes[i];
		const struct hawser_net_rom_options options = {.n = scene->n,
			.kept = scene->count ? scene->kept : NULL, .count = scene->count};
		const char *source = getenv("SRCDIR");
		struct hawser_modes modes;
		struct hawser_net net;
		struct hawser_rom rom;
		struct hawser_frf frf;
		struct hawser_landmark *peak;
		struct hawser_certificate c;
		char path[512];
		int peaks;
		const struct hawser_frf_options choice = {.method = "balance", .unjudged = 1,
			.step_max = 0.02, .samples = HAWSER_NONE, .tolerance = 1e-8, .event_tolerance = 1e-8};
		struct hawser_frf_options own = choice;

		if (getenv("ONLY") && strcmp(getenv("ONLY"), scene->name))
			continue;
		snprintf(path, sizeof path, "%s/tests/reference/net-rom-%s.yaml", source ? source : ".",
		         scene->name);
		if (!ok(!hawser_net_open(&net, path, NULL, 0, &report), "%s: %s", scene->name, report.message))
			continue;
		if (!ok(!hawser_net_rom_build(&rom, &modes, &net, &options, &report), "its model %s", report.message)) continue;
		own.from = scene->from*rom.time;
		own.to = scene->to*rom.time;
		if (!ok(!hawser_frf_trace(&frf, &rom, &own, &report), "response %s", report.message)) continue;
		if (hawser_peaks(&peak, &peaks, &frf, &rom, &own, 1e-3, &report)) continue;
		if (!ok(!hawser_net_certify(&c, &net, &options, &rom, &frf, peak, peaks, 0.0, &report), "cert %s", report.message)) continue;
		printf("# points %d count %d refused %d omitted %d distance %.3g harmonics %.2g order %d unknowns %d extrapolated %d foreseen %.2f s %.2f\n", frf.points, c.count, c.refused, c.omitted, c.distance, c.harmonics, c.order, c.unknowns, c.extrapolated, c.foreseen, c.seconds);
		for (int k = 0; k < c.count; k++)
			printf("# kind %d %s axis %d omega %.9g exact %.9g size %.7g exact %.7g dist %.3g T %.6g cable %d\n", c.item[k].kind, c.item[k].probe < 0 ? "" : rom.shapes.name[c.item[k].probe], c.item[k].axis, c.item[k].omega/rom.time, c.item[k].exact_omega/rom.time, c.item[k].size*rom.length, c.item[k].exact_size*rom.length, c.item[k].distance, c.item[k].tension, c.item[k].cable);
		printf("#   truth folds %.9g %.9g peak %.8g %.7g\n", scene->fold[0], scene->fold[1], scene->omega, scene->size);
		free(peak);
		hawser_frf_clear(&frf);
		hawser_rom_clear(&rom);
		hawser_net_clear(&net);
		hawser_modes_clear(&modes);
	}
	return done_testing();
}

/* Reduced models of nets against numbers of a prototype in another language, with elements of degree
 * 6 to 8 and its own harmonic balance (7 to 9 harmonics), with which the response of its models by
 * this program agrees to 1e-7: two stays in a row on a hanger, a line of three spans with two
 * hangers, a mesh of 4 x 4 cells with a pair of equal frequencies, two strings with a tie, a float on
 * three moorings, and a span as a net of one cable, under a load and with an end that moves. They are
 * models without the field of the load (`bare`), whose frequencies are those of the energy to fourth
 * order and of static condensation alone. A mass on a massless cable is a pendulum, which one shape
 * for the inertia of what follows makes soften.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/net_rom.h>

#include "tests/tap.h"

static struct hawser_report report;

/* Folds of the response from `from` to `to`, rad/s. */
struct expected {
	double from, to, fold[2];
};

struct scene {
	const char *name;
	int n, kept[20], count;
	int slow; /* 1: responses wait for HAWSER_LONG */
	int modes;
	double omega[3];
	struct expected response[2];
};

static const struct scene scenes[] = {
	{"span", 12, .slow = 1, .response = {{1.2, 1.16, {1.16943906, 1.19061530}},
	                                     {1.38, 1.39, {1.38775884, 1.38592982}}}},
	{"stays", 28, {0, 1, 2, 3, 4, 5, 6, 7, 9, 11, 19, 27}, 12, 0, 3,
	 {1.19033808, 1.30804617, 1.32408924}, {{1.285, 1.27, {1.27339339, 1.28034698}}}},
	{"spans", 18, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14, 16, 17}, 15, 1, 3,
	 {1.12149880, 1.26043165, 1.29948691}, {{1.265, 1.255, {1.25870463, 1.26173527}}}},
	{"cells", 9, .slow = 1, .modes = 3, .omega = {22.3280752, 34.3237289, 34.3237289},
	 .response = {{35.2, 34.9, {34.9685871, 35.0411168}}}},
	{"strings", 8, .modes = 3, .omega = {6.77650944}},
	{"float", 9, .modes = 3, .omega = {1.41495387, 1.44794372, 1.44794372}},
	{"moved", 8, .response = {{2.67, 2.62, {2.62866619, 2.65614306}}}},
};

static int build(struct hawser_rom *rom, const struct scene *scene)
{
	const struct hawser_net_rom_options options = {.n = scene->n, .bare = 1,
		.kept = scene->count ? scene->kept : NULL, .count = scene->count};
	struct hawser_modes modes;
	struct hawser_net net;
	const char *path = source_file("tests/reference/net-rom-%s.yaml", scene->name);
	int good;

	if (!ok(!hawser_net_open(&net, path, NULL, 0, &report), "%s: %s", scene->name, report.message))
		return 0;
	good = ok(!hawser_net_rom_build(rom, &modes, &net, &options, &report), "its model %s",
	          report.message);
	hawser_net_clear(&net);
	hawser_modes_clear(&modes);
	return good;
}

static void folds(const struct hawser_rom *rom, const struct expected *expected)
{
	const struct hawser_frf_options options = {.method = "balance", .from = expected->from*rom->time,
		.to = expected->to*rom->time, .unjudged = 1, .step_max = 0.3, .samples = HAWSER_NONE,
		.tolerance = 1e-8, .event_tolerance = 1e-8};
	struct hawser_frf frf;
	int found = 0;

	if (!ok(!hawser_frf_trace(&frf, rom, &options, &report), "response %s", report.message))
		return;
	for (int i = 0; i < frf.events && found < 2; i++)
		if (frf.event[i].kind == HAWSER_FOLD)
			close_to(frf.event[i].omega/rom->time, expected->fold[found++], 1e-6, "  fold");
	ok(found == 2, "  two folds");
	hawser_frf_clear(&frf);
}

/* A cable that damps its stretch: of the mode along it the damping over the stiffness. */
static void stretched(const struct hawser_net *net)
{
	const struct hawser_net_rom_options options = {.n = 3};
	struct hawser_modes modes;
	struct hawser_rom rom;

	net->cable->axial = 2.385e-3;
	if (!ok(!hawser_net_rom_build(&rom, &modes, net, &options, &report), "damped %s", report.message))
		return;
	close_to((rom.D[2*(rom.n + 1)] - net->mass_rate*rom.time)*rom.time/rom.K[2*(rom.n + 1)], 2.385e-3,
	         1e-9, "  its damping");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

/* Frequency of the largest amplitude over that of the mode. */
static void swing(void)
{
	const struct hawser_net_rom_options options = {.n = 2};
	static char name[] = "swing";
	struct hawser_net_node node[2] = {{.name = "P", .placed = 1, .held = {1, 1, 1}, .support = 1},
	                                  {.name = "M", .mass = 100.0}};
	struct hawser_net_cable cable = {.name = "c", .to = 1, .EA = 3e7, .value = 2.0, .elements = 1};
	struct hawser_net_load load = {.node = 1, .cable = -1, .value = {3.92387169}, .harmonic = 1,
	                               .multiple = 1};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .load = &load,
	                         .nodes = 2, .cables = 1, .loads = 1, .mass_rate = 0.044293745};
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options choice = {.method = "balance", .unjudged = 1, .step_max = 0.02,
	                                    .samples = HAWSER_NONE};
	double omega, *probe, a, b;
	int best = 1;

	if (!ok(!hawser_net_rom_build(&rom, &modes, &net, &options, &report), "swing %s", report.message))
		return;
	ok(rom.inertia.shapes == 1 && rom.n == 3, "  one shape beside two modes");
	omega = sqrt(rom.K[0]);
	choice.from = 0.99*omega;
	choice.to = 1.005*omega;
	if (ok(!hawser_frf_trace(&frf, &rom, &choice, &report), "  response %s", report.message)) {
		for (int i = 1; i + 1 < frf.points; i++)
			best = frf.probe[3*i] > frf.probe[3*best] ? i : best;
		probe = frf.probe + 3*best;
		a = (probe[3] - probe[0])/(frf.point[best + 1].omega - frf.point[best].omega);
		b = (probe[0] - probe[-3])/(frf.point[best].omega - frf.point[best - 1].omega);
		close_to((frf.point[best].omega + frf.point[best - 1].omega)/2.0/omega +
		         b*(frf.point[best + 1].omega - frf.point[best - 1].omega)/2.0/omega/(b - a),
		         0.9975209, 1e-5, "  resonance");
		hawser_frf_clear(&frf);
	}
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	stretched(&net);
}

CASE(reference_net_rom)
{
	swing();
	for (size_t i = 0; i < sizeof scenes/sizeof *scenes; i++) {
		const struct scene *scene = &scenes[i];
		struct hawser_rom rom;

		if (!build(&rom, scene))
			continue;
		for (int j = 0; j < scene->modes && scene->omega[j] > 0.0; j++)
			close_to(sqrt(rom.K[j*(rom.n + 1)])/rom.time, scene->omega[j], 1e-6, "  omega");
		for (int k = 0; k < 2 && (!scene->slow || getenv("HAWSER_LONG")); k++)
			if (scene->response[k].from > 0.0)
				folds(&rom, &scene->response[k]);
		hawser_rom_clear(&rom);
	}
	return done_testing();
}

/* The reference of bench/estimates for responses (bench/estimates-reference.c): it is refined until
 * the verdict about a stated error no longer depends on it.
 *
 * With HAWSER_LONG: near the sixth mode of a sagging span the full-order model of 12 functions has
 * a larger error than a condensed model of exact modes; and the scenes of bench/estimates accuracy
 * whose stated error was considered too small for this reason.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { KEPT = 20, RESONANT = 5, SMALL = 12 };

static const char taut[] =
	"cable: {EA: 400 kN, rho: 1.2}\n"
	"span: {d: 100 m, h: -20 m}\n"
	"tension: {sag: 2 m}\n"
	"damping: {ratio: 2 %}\n"
	"load: {frame: global, per_length: [0, 0.03, 0]}\n";
static const char sagging[] =
	"cable: {EA: 20 MN, rho: 1.2}\n"
	"span: {d: 100 m, h: -20 m}\n"
	"tension: {sag: 24 m}\n"
	"damping: {ratio: 0.5 %}\n"
	"load: {frame: global, per_length: [0.002, 0.003, 0.001]}\n";

static const int judged[] = {56, 88, 137, 154, 161, 233, 563, 570, 573, 607, 656};

static struct hawser_report report;
static struct hawser_scene scene;
static struct hawser_statics statics;

/* --- a response of the lowest modes --- */

static struct hawser_modes modes;
static struct hawser_rom rom;
static struct hawser_frf frf;
static struct estimate_response response = {&frf, &rom, &statics, &scene, 0.0, 0.0};

static void clear(void)
{
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* n modes, within `part` of the frequency of mode j. Returns 1 if there is a response. */
static int respond(const char *text, int n, int j, double part)
{
	struct hawser_frf_options options = {.method = "balance", .tolerance = 1e-7,
		.samples = HAWSER_NONE};
	struct hawser_modes_options lowest = {.n = n};
	enum hawser_status status = read_text(&scene, text, NULL, &report);

	if (!status)
		status = hawser_statics_scene(&statics, &scene, &report);
	if (!status)
		status = hawser_modes_solve(&modes, &statics, &lowest, &report);
	if (!status)
		status = hawser_rom_build(&rom, &modes, &scene, &report);
	if (!status) {
		response.from = options.from = (1.0 - part)*modes.mode[j].omega;
		response.to = options.to = (1.0 + part)*modes.mode[j].omega;
		status = hawser_frf_trace(&frf, &rom, &options, &report);
	}
	return ok(!status, "%d modes: %d points %s", n, frf.points, report.message);
}

/* --- its true error --- */

static void check_coarse(void)
{
	struct estimate_truth truth;

	if (respond(taut, 1, 0, 0.05)) {
		int failed = estimate_truth(&truth, &response, 0, 1e-9);

		ok(!failed && truth.functions == SMALL + 4 && truth.move <= 0.1*truth.distance,
		   "%.2e off, and the reference of %d functions moved by %.1e", truth.distance,
		   truth.functions, truth.move);
		failed = estimate_truth(&truth, &response, 30, 1e-9);
		ok(failed, "nothing is as large as a model of 30 functions asks for");
	}
	clear();
}

/* `small` is the distance from the model of 12 functions. */
static void check_fine(double small)
{
	struct estimate_truth truth;
	int failed = estimate_truth(&truth, &response, 0, 0.25*small);

	ok(!failed && truth.functions > SMALL + 4, "a quarter of it stated: %d functions are asked for",
	   truth.functions);
	ok(truth.distance < 0.1*small, "and the distance is %.2e", truth.distance);
	ok(truth.distance + truth.move < 0.125*small || truth.move <= 0.1*truth.distance,
	   "known well enough, since the reference moved by %.1e", truth.move);
	failed = estimate_truth(&truth, &response, 0, 8.0*small);
	ok(!failed && truth.functions == SMALL + 4 && truth.distance < small,
	   "eight times stated: %d functions suffice, %.2e", truth.functions, truth.distance);
	failed = estimate_truth(&truth, &response, SMALL, 8.0*small);
	ok(!failed && truth.functions == SMALL + 8, "for a model of 12 functions: %d", truth.functions);
}

static void check_resonance(void)
{
	struct hawser_frf_options options = {.method = "balance", .tolerance = 1e-7,
		.samples = HAWSER_NONE};
	struct hawser_rom small = {.n = 0};
	struct hawser_frf its = {.n = 0};
	double distance = NAN;
	enum hawser_status status;

	if (respond(sagging, KEPT, RESONANT, 0.002)) {
		options.from = response.from;
		options.to = response.to;
		status = hawser_rom_build_full(&small, &statics, &scene, SMALL, &report);
		if (!status)
			status = hawser_frf_trace(&its, &small, &options, &report);
		if (!status)
			status = hawser_accuracy_distance(&distance, &frf, &rom, &its, &small, 1e-3, &report);
		if (ok(!status, "12 functions: the distance is %.2e %s", distance, report.message))
			check_fine(distance);
	}
	hawser_frf_clear(&its);
	hawser_rom_clear(&small);
	clear();
}

/* --- scenes of the bench --- */

static void check_judged(void)
{
	for (size_t i = 0; i < sizeof judged/sizeof *judged; i++)
		for (int e = 0; e < estimates_count; e++) {
			struct tally tally = {.here = -1.0, .divide = 1.0, .show = 1.0};

			if (strcmp(estimates[e].name, "accuracy"))
				continue;
			estimate_run(&tally, &estimates[e], judged[i], 1, 1);
			ok(!tally.failed && !tally.refused && tally.exceeded == 0, "scene %d holds",
			   judged[i]);
			tally_clear(&tally);
		}
}

CASE(unit_estimate_truth)
{
	check_coarse();
	if (getenv("HAWSER_LONG")) {
		check_resonance();
		check_judged();
	}
	return done_testing();
}

/* The stated error of a response with a given number of modes, near a 1:2 resonance of two modes: B
 * Table 4.4, line 2, over 0.8 to 1.6 w1. The second out-of-plane peak lies between two folds that
 * are 0.1 % of Omega apart, so that a small effect of the omitted modes on the kept ones displaces
 * it far.
 *
 * True errors: hawser_accuracy_distance from the full-order model with 12 functions per component,
 * whose folds and peaks agree with those of 14 functions to 2e-4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/accuracy.h>

#include "tests/tap.h"

static void check(int n, double error)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_accuracy_fixed fixed = {.estimated = NAN};
	struct hawser_modes_options lowest = {.n = n};
	struct hawser_report report = {.message = ""};
	static const char *const set[] = {"model.condense=static"};
	struct hawser_modes modes = {.n = 0};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_frf frf = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	const char *path = source_file("notebooks-data/scenes/b-table-4.4-line-2.yaml");

	if (!ok(!hawser_scene_open(&scene, path, set, 1, &report) &&
	        !hawser_statics_scene(&statics, &scene, &report) &&
	        !hawser_modes_solve(&modes, &statics, &lowest, &report), "the scene %s", report.message))
		return;
	options.from = 0.8*modes.mode[0].omega;
	options.to = 1.6*modes.mode[0].omega;
	options.samples = HAWSER_NONE;
	if (ok(!hawser_rom_build(&rom, &modes, &scene, &report) &&
	       !hawser_frf_trace(&frf, &rom, &options, &report) &&
	       !hawser_accuracy_fixed(&fixed, &rom, &frf, n, &statics, &scene, options.from, options.to,
	                              &report), "%d modes %s", n, report.message)) {
		ok(fixed.estimated >= error && fixed.estimated < 10.0*error,
		   "%d modes: stated %.2e, true %.2e", n, fixed.estimated, error);
		ok(fabs(fixed.followed/error - 1.0) < 0.3,
		   "and what follows the kept modes makes most of it: %.2e", fixed.followed);
		ok(fixed.truncation < 0.5*error, "which the modes looked at have (beyond them: %.2e)",
		   fixed.truncation);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

CASE(property_fixed)
{
	check(7, 2.45e-2);
	check(9, 2.45e-2);
	return done_testing();
}

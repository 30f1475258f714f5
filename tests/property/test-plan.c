/* The estimates of a plan: the number of points, the order of the times, and failures that are
 * foreseen. bench/plan-times compares the times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/accuracy.h>
#include <hawser/plan.h>

#include "tests/tap.h"

static struct hawser_scene scene;
static struct hawser_statics statics;
static double w1;

static int open_scene(const char *name)
{
	struct hawser_modes_options one = {.n = 1};
	struct hawser_modes modes = {.n = 0};
	struct hawser_report report = {.message = ""};
	const char *path = source_file("notebooks-data/scenes/%s.yaml", name);
	int opened;

	opened = !hawser_scene_open(&scene, path, NULL, 0, &report) &&
	         !hawser_statics_scene(&statics, &scene, &report) &&
	         !hawser_modes_solve(&modes, &statics, &one, &report);
	w1 = opened ? modes.mode[0].omega : NAN;
	hawser_modes_clear(&modes);
	return ok(opened, "%s %s", name, report.message);
}

/* The points of the curve of N modes by the formula against those of the curve itself, and the error
 * that is foreseen against the one that is stated of the curve. */
static void check_points(const char *name, int n, double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_modes_options lowest = {.n = n};
	struct hawser_fidelity_choice choice;
	struct hawser_modes modes = {.n = 0};
	struct hawser_plan plan = {.rows = 0};
	struct hawser_accuracy_fixed fixed;
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	char list[20];
	int count;

	if (!open_scene(name))
		return;
	options.from = from*w1;
	options.to = to*w1;
	options.step_max = 0.005;
	hawser_frf_settle(&options);
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	snprintf(list, sizeof list, "condensed %d", n);
	if (ok(!hawser_modes_solve(&modes, &statics, &lowest, NULL) &&
	       !hawser_rom_build(&rom, &modes, &scene, NULL) &&
	       !hawser_frf_trace(&frf, &rom, &options, NULL) &&
	       !hawser_fidelities_read(&choice, &count, list, 1, NULL) &&
	       !hawser_plan_make(&plan, &statics, &scene, &choice, 1, options.from, options.to, NULL),
	       "a curve and its plan")) {
		ok(fmax(plan.row[0].points/frf.points, frf.points/plan.row[0].points) < 2.0,
		   "%s: %.0f points foretold, %d with %d events", name, plan.row[0].points, frf.points,
		   frf.events);
		if (ok(!hawser_accuracy_fixed(&fixed, &rom, &frf, n, &statics, &scene, options.from, options.to,
		                              NULL), "its error"))
			ok(fmax(plan.row[0].omega_error/fixed.estimated,
			        fixed.estimated/plan.row[0].omega_error) < 4.0,
			   "an error of %.2g foreseen, %.2g stated", plan.row[0].omega_error, fixed.estimated);
	}
	hawser_plan_clear(&plan);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

static int make(struct hawser_plan *plan, const char *list, double from, double to)
{
	struct hawser_fidelity_choice choice[4];
	struct hawser_report report = {.message = ""};
	int count;

	return ok(!hawser_fidelities_read(choice, &count, list, 4, &report) &&
	          !hawser_plan_make(plan, &statics, &scene, choice, count, from*w1, to*w1,
	                            &report), "a plan %s", report.message);
}

/* Sizes that differ by a factor of ten: the order of the estimates is right on a busy machine too. */
static void check_order(void)
{
	struct hawser_plan plan = {.rows = 0};

	if (!open_scene("b-table-4.4-line-2"))
		return;
	if (make(&plan, "multiple-scales 3, raw 2, condensed 12", 0.9, 1.1)) {
		const struct hawser_plan_row *row = plan.row;

		ok(row[1].seconds < row[2].seconds, "raw 2 takes %.2g s, condensed 12 %.2g s",
		   row[1].seconds, row[2].seconds);
		for (int i = 0; i < plan.rows; i++)
			ok(row[i].estimated && row[i].least < row[i].seconds && row[i].seconds < row[i].most &&
			   row[i].status == HAWSER_OK, "%s: %.2g between %.2g and %.2g", row[i].choice.name,
			   row[i].seconds, row[i].least, row[i].most);
	}
	hawser_plan_clear(&plan);
	hawser_scene_clear(&scene);
}

/* A failure at the beginning of a run is reported by the plan. */
static void check_foreseen(void)
{
	struct hawser_plan plan = {.rows = 0};

	if (!open_scene("b-table-4.4-line-2"))
		return;
	/* the lowest mode moves out of the plane of the load */
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.per_length[2] = 0.0;
	if (make(&plan, "raw 1, raw 2", 0.9, 1.1)) {
		ok(plan.row[0].status == HAWSER_ERR_ARGUMENT && strstr(plan.row[0].foreseen, "no forcing"),
		   "foreseen: %s", plan.row[0].foreseen);
		ok(plan.row[1].status == HAWSER_OK && !*plan.row[1].foreseen, "and of two modes nothing is");
		hawser_plan_clear(&plan);
	}
	hawser_scene_clear(&scene);
}

/* The exact energy in place of modes: a smaller basis and less time where the range is narrower. */
static void check_instead(void)
{
	struct hawser_plan plan[2] = {{.rows = 0}, {.rows = 0}};

	if (!open_scene("conductor"))
		return;
	if (make(&plan[0], "raw 2", 0.87, 1.19) && make(&plan[1], "raw 2", 0.6, 3.3)) {
		const struct hawser_plan_row *narrow = &plan[0].row[1], *wide = &plan[1].row[1];

		for (int i = 0; i < 2; i++)
			ok(plan[i].rows == 2 && !strcmp(plan[i].row[1].choice.fidelity->name, "full") &&
			   plan[i].row[1].n == 3*(int)plan[i].row[1].choice.number, "full %g, %d coordinates",
			   plan[i].row[1].choice.number, plan[i].row[1].n);
		ok(narrow->n < wide->n && narrow->points < wide->points, "%d and %d of them, %.0f and %.0f "
		   "points", narrow->n, wide->n, narrow->points, wide->points);
		ok(2.0*narrow->seconds < wide->seconds, "%.2g s about one resonance, %.2g s over four of them",
		   narrow->seconds, wide->seconds);
	}
	hawser_plan_clear(&plan[0]);
	hawser_plan_clear(&plan[1]);
	hawser_scene_clear(&scene);
}

CASE(property_plan)
{
	check_points("b-table-4.4-line-2", 3, 0.8, 1.15);
	check_points("b-table-5.4-at-rest", 3, 0.95, 1.15);
	check_points("inclined", 3, 0.9, 1.1);
	check_order();
	check_foreseen();
	check_instead();
	return done_testing();
}

/* The estimate of the time of a response by a plan: the number of points is predicted from the
 * beginning of the curve and a coarse trace, the estimates have the order of the times, and
 * failures are reported. bench/plan-times compares the times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/plan.h>

#include "study/accuracy/accuracy.h"
#include "study/plan/trial.h"
#include "tests/tap.h"

static struct hawser_scene scene;
static struct hawser_statics statics;
static double w1;

static int open_scene(const char *name)
{
	struct hawser_modes_options one = {.n = 1};
	struct hawser_modes modes = {.n = 0};
	struct hawser_report report = {.message = ""};
	const char *srcdir = getenv("SRCDIR");
	char path[512];
	int opened;

	snprintf(path, sizeof path, "%s/notebooks-data/scenes/%s.yaml", srcdir ? srcdir : ".", name);
	opened = !hawser_scene_open(&scene, path, NULL, 0, &report) &&
	         !hawser_statics_scene(&statics, &scene, &report) &&
	         !hawser_modes_solve(&modes, &statics, &one, &report);
	w1 = opened ? modes.mode[0].omega : NAN;
	hawser_modes_clear(&modes);
	return ok(opened, "%s %s", name, report.message);
}

static double even(const void *context, double from, double to)
{
	return *(const double *)context*fabs(to - from);
}

static double half(const void *context, double from, double to)
{
	return 0.5*even(context, from, to);
}

static int always(const void *context, double from, double to)
{
	return context && from != to;
}

static int never(const void *context, double from, double to)
{
	return !always(context, from, to);
}

/* The curve of N modes: the estimate from its first points and a coarse trace, against the curve
 * itself. */
static void check_points(const char *name, int n, double from, double to)
{
	struct hawser__allowance plenty = {.left = 1e9, .rows = 1}, none = {.rows = 1};
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_modes_options lowest = {.n = n};
	struct hawser_modes modes = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	struct hawser__trial trial;
	struct hawser__trial_cost cost = {.points = 0.0};
	double density, took = 0.0, whole;
	struct hawser__outlook known = {even, half, always, &density}, open = {even, half, never, &density};
	enum hawser_status status;

	if (!open_scene(name))
		return;
	options.from = from*w1;
	options.to = to*w1;
	options.step_max = 0.005;
	hawser_frf_settle(&options);
	density = 200.0/(options.to - options.from);
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	if (ok(!hawser_modes_solve(&modes, &statics, &lowest, NULL) &&
	       !hawser_rom_build(&rom, &modes, &scene, NULL) &&
	       (took = hawser__processor_seconds()) > 0.0 &&
	       !hawser_frf_trace(&frf, &rom, &options, NULL), "the curve")) {
		took = hawser__processor_seconds() - took;
		hawser__trial_begin(&trial, &plenty, &options, 200.0);
		status = hawser__trial_curve(&cost, &trial, &rom, &options, 12, &known, NULL);
		ok(!status && cost.complete && cost.seconds > 0.0 && cost.seen == cost.seconds &&
		   fmax(cost.points/frf.points, frf.points/cost.points) < 1.5,
		   "%.0f points foretold, %d with %d events; %.2g s, %.2g seen%s", cost.points, frf.points,
		   frf.events, cost.seconds, cost.seen, cost.complete ? "" : ", not complete");
		hawser__trial_begin(&trial, &none, &options, 200.0);
		status = hawser__trial_curve(&cost, &trial, &rom, &options, 12, &known, NULL);
		ok(!status && !cost.complete && cost.seen < cost.seconds && cost.points > 100.0,
		   "without time for it: %.0f points, and it is no full account", cost.points);
		whole = cost.points;
		ok(!cost.bound, "an estimate where nothing lies ahead");
		hawser__trial_begin(&trial, &none, &options, 200.0);
		status = hawser__trial_curve(&cost, &trial, &rom, &options, 12, &open, NULL);
		ok(!status && cost.bound && cost.points < whole && cost.points <= frf.points,
		   "else a bound: %.2g s of %.2g s, %.0f of %d points",
		   cost.seconds, took, cost.points, frf.points);
	}
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
	          !hawser_plan_make(plan, &statics, &scene, choice, count, from*w1, to*w1, NULL,
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
			ok(row[i].basis != HAWSER_BASIS_NONE && row[i].least <= row[i].seconds &&
			   row[i].seconds <= row[i].most && row[i].status == HAWSER_OK,
			   "%s by %s: %.2g between %.2g and %.2g", row[i].choice.name,
			   hawser_plan_basis_name(row[i].basis), row[i].seconds, row[i].least, row[i].most);
		ok(plan.seconds > 0.0 && plan.seconds < 60.0, "the plan took %.2g s", plan.seconds);
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

/* Many folds and unstable orbits beyond the part that is computed: no estimate is given. */
static void check_bound(void)
{
	struct hawser_plan_options little = {.seconds = 0.01, .extra = HAWSER_NONE};
	struct hawser_fidelity_choice choice[2];
	struct hawser_plan plan = {.rows = 0};
	int count;

	if (!open_scene("chairlift"))
		return;
	if (ok(!hawser_fidelities_read(choice, &count, "condensed 5, multiple-scales 5", 2, NULL) &&
	       !hawser_plan_make(&plan, &statics, &scene, choice, count, 0.6*w1, 3.3*w1, &little, NULL),
	       "a plan with little time")) {
		const struct hawser_plan_row *row = plan.row;

		ok(row[0].bound && isinf(row[0].most) && row[0].least == row[0].seconds && *row[0].foreseen,
		   "condensed 5: at least %.2g s: %s", row[0].seconds, row[0].foreseen);
		ok(!row[1].bound && isfinite(row[1].most), "multiple scales: %.2g s", row[1].seconds);
	}
	hawser_plan_clear(&plan);
	hawser_scene_clear(&scene);
}

/* Searches that need more than two models, or the full order, are recognised. */
static void check_course(void)
{
	struct hawser_accuracy_options options = {.most = 0};
	struct hawser_accuracy a = {.asked = 0.01, .tries = 1};

	a.attempt[0] = (struct hawser_accuracy_try){.truncation = 0.0123};
	ok(hawser__accuracy_course(&a, &options) == HAWSER__SEVERAL, "the energy's order is too low");
	a.attempt[0] = (struct hawser_accuracy_try){.rest = 0.0123};
	ok(hawser__accuracy_course(&a, &options) == HAWSER__SEVERAL, "modes of weight are missing");
	a.attempt[0] = (struct hawser_accuracy_try){.functions = 12};
	ok(hawser__accuracy_course(&a, &options) == HAWSER__SEVERAL, "a full-order model");
	a.attempt[0] = (struct hawser_accuracy_try){.rest = 1e-5, .truncation = 1e-5};
	ok(hawser__accuracy_course(&a, &options) == HAWSER__LAST, "nothing more, and no mode to leave out");
}

CASE(property_plan)
{
	check_bound();
	check_course();
	check_points("b-table-4.4-line-2", 3, 0.8, 1.15);
	check_points("b-table-5.4-at-rest", 3, 0.95, 1.15);
	check_points("inclined", 3, 0.9, 1.1);
	check_order();
	check_foreseen();
	ok(!strcmp(hawser_plan_basis_name(HAWSER_BASIS_PART), "part") &&
	   !strcmp(hawser_plan_basis_name((enum hawser_plan_basis)99), ""), "names of bases");
	return done_testing();
}

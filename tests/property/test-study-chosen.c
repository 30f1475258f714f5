/* A model of the N most important modes against the full-order model, and against the N lowest
 * modes; the modes that a choice of N keeps; its estimate by a plan.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/choose.h>
#include <hawser/plan.h>

#include "tests/tap.h"

static struct hawser_scene scene;
static struct hawser_statics statics;
static struct hawser_modes modes;

static int open_scene(const char *name, const char *const *set, size_t sets)
{
	struct hawser_report report = {.message = ""};
	struct hawser_modes_options options = {.n = 24};
	const char *path = source_file("notebooks-data/scenes/%s.yaml", name);

	return ok(!hawser_scene_open(&scene, path, set, sets, &report) &&
	          !hawser_statics_scene(&statics, &scene, &report) &&
	          !hawser_modes_solve(&modes, &statics, &options, &report), "%s %s", name,
	          report.message);
}

static void close_scene(void)
{
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

static int run(struct hawser_study_curve *curve, const char *name, double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_fidelity_choice choice;
	struct hawser_report report = {.message = ""};
	int count, done;

	options.from = from*modes.mode[0].omega;
	options.to = to*modes.mode[0].omega;
	options.tolerance = 1e-8;
	options.samples = HAWSER_NONE;
	options.step_max = getenv("HAWSER_LONG") ? 0.0 : 0.1;
	done = !hawser_fidelities_read(&choice, &count, name, 1, &report) &&
	       !hawser_study_run(curve, &statics, &scene, &choice, &options, &report);
	return ok(done, "%s: %d coordinates, %d points, %d landmarks %s", name, curve->n,
	          curve->frf.points, curve->landmarks, report.message);
}

/* Largest errors of a fidelity: in Omega of folds and peaks, and in size of peaks. */
static int errors(double *omega, double *size, const char *name,
                  const struct hawser_study_curve *reference, double from, double to)
{
	struct hawser_study_curve curve = {.n = 0};
	struct hawser_study_error error = {.partner = NULL};
	int done = run(&curve, name, from, to) &&
	           ok(!hawser_study_compare(&error, &curve, reference, NULL, NULL), "compared");

	if (done) {
		*omega = fmax(fabs(error.fold.omega), fabs(error.peak.omega));
		*size = fabs(error.peak.size);
		ok(error.fold.missing + error.fold.extra == 0 && error.fold.matched > 0,
		   "%s: %d folds, %.1e off in Omega, peaks %.1e in size", name, error.fold.matched,
		   *omega, *size);
	}
	hawser_study_error_clear(&error);
	hawser_study_clear(&curve);
	return done;
}

/* Six functions per component agree with twelve to 5e-5 in Omega and 3e-3 in size. */
static void check_against_lowest(void)
{
	const double from = getenv("HAWSER_LONG") ? 0.92 : 0.94, to = getenv("HAWSER_LONG") ? 1.1 : 1.06;
	struct hawser_study_curve reference = {.n = 0};
	double chosen[2], lowest[2], few[2];

	if (open_scene("b-table-4.5", NULL, 0) && run(&reference, "full 6", from, to) &&
	    errors(&chosen[0], &chosen[1], "chosen 9", &reference, from, to) &&
	    errors(&few[0], &few[1], "chosen 6", &reference, from, to) &&
	    errors(&lowest[0], &lowest[1], "condensed 9", &reference, from, to)) {
		ok(chosen[0] < 3e-4 && chosen[1] < 0.01, "nine chosen ones: %.1e, %.1e", chosen[0],
		   chosen[1]);
		ok(few[0] < 1e-3, "six chosen ones: %.1e, %.1e", few[0], few[1]);
		ok(lowest[0] > 10.0*chosen[0] && lowest[1] > 5.0*chosen[1] && lowest[0] > 5.0*few[0],
		   "nine lowest ones: %.1e, %.1e", lowest[0], lowest[1]);
	}
	hawser_study_clear(&reference);
	close_scene();
}

/* A choice of N has the first N modes of the order of importance; a smaller choice is a subset of a
 * larger one. */
static void check_first(void)
{
	struct hawser_report report = {.message = ""};
	struct hawser_choice choice;
	int kept[24], count, wrong = 0;
	double w;

	if (!open_scene("b-table-4.5", NULL, 0))
		return;
	w = modes.mode[0].omega;
	if (ok(!hawser_choose(&choice, &modes, &scene, 0.85*w, 1.2*w, 0.01, &report), "a choice %s",
	       report.message)) {
		for (int n = 20; n >= 1; n -= 3) {
			count = hawser_choice_first(&choice, n);
			wrong += count != n || hawser_choice_kept(kept, &choice) != n;
			for (int i = 0; i < choice.n; i++)
				wrong += choice.mode[choice.order[i]].kept != (i < n);
			for (int i = 1; i < choice.n; i++)
				wrong += choice.mode[choice.order[i]].measure >
				         choice.mode[choice.order[i - 1]].measure;
		}
		ok(!wrong, "20, 17, ... 2 modes: the first of the order");
		hawser_choice_clear(&choice);
	}
	close_scene();
}

/* A load in the plane moves no out-of-plane mode: fewer modes than requested, and the model has
 * these only. */
static void check_unexcited(void)
{
	static const char *const set[] = {"load.per_length=[0, 0.01, 0]"};
	struct hawser_report report = {.message = ""};
	struct hawser_study_curve curve = {.n = 0};
	struct hawser_choice choice;
	int across = 0, count = 0;
	double w;

	if (!open_scene("level-two-to-one", set, 1))
		return;
	w = modes.mode[0].omega;
	if (ok(!hawser_choose(&choice, &modes, &scene, 0.3*w, 0.5*w, 0.01, &report), "a choice %s",
	       report.message)) {
		count = hawser_choice_first(&choice, 24);
		for (int j = 0; j < choice.n; j++)
			across += choice.mode[j].kept && modes.mode[j].plane == HAWSER_OUT_OF_PLANE;
		ok(count > 3 && count <= 12 && across == 0, "%d of 24 modes, %d of them across", count,
		   across);
		hawser_choice_clear(&choice);
	}
	/* the first response may show that further modes are weakly excited */
	if (run(&curve, "chosen 24", 0.3, 0.5))
		ok(curve.n >= count && curve.n <= 12, "a model of %d coordinates", curve.n);
	hawser_study_clear(&curve);
	close_scene();
}

static void check_plan(void)
{
	struct hawser_fidelity_choice choice[4];
	struct hawser_plan plan;
	struct hawser_report report = {.message = ""};
	int count;
	double w;

	if (!open_scene("b-table-4.5", NULL, 0))
		return;
	w = modes.mode[0].omega;
	if (ok(!hawser_fidelities_read(choice, &count, "chosen, chosen 3-5", 4, &report) && count == 4 &&
	       choice[0].number == 9, "a list of %d %s", count, report.message) &&
	    ok(!hawser_plan_make(&plan, &statics, &scene, choice, count, 0.85*w, 1.2*w,
	                          &report),
	       "a plan %s", report.message)) {
		ok(plan.row[0].n == 9 && plan.row[1].n == 3 && plan.row[3].n == 5 &&
		   plan.row[0].seconds > 0.0 && plan.row[0].cubics > plan.row[3].cubics, "sizes");
		ok(plan.row[0].omega_error < plan.row[3].omega_error &&
		   plan.row[3].omega_error < plan.row[1].omega_error, "%.1e, %.1e, %.1e expected of 9, 5 "
		   "and 3 modes", plan.row[0].omega_error, plan.row[3].omega_error,
		   plan.row[1].omega_error);
		hawser_plan_clear(&plan);
	}
	close_scene();
}

CASE(property_study_chosen)
{
	check_first();
	check_unexcited();
	check_plan();
	check_against_lowest();
	return done_testing();
}

/* Fidelities and plans of scenes: planned sizes against the models built; a response against
 * itself; refined peaks against responses with short steps; estimated errors against measured ones.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/plan.h>

#include "tests/tap.h"

static struct hawser_scene scene;
static struct hawser_statics statics;
static double w1; /* scaled */

static int open_scene(const char *name)
{
	struct hawser_report report = {.message = ""};
	struct hawser_modes_options options = {.n = 1};
	struct hawser_modes modes = {.n = 0};
	const char *path = source_file("notebooks-data/scenes/%s.yaml", name);
	int opened;

	opened = ok(!hawser_scene_open(&scene, path, NULL, 0, &report) &&
	            !hawser_statics_scene(&statics, &scene, &report) &&
	            !hawser_modes_solve(&modes, &statics, &options, &report), "%s %s", name,
	            report.message);
	if (opened)
		w1 = modes.mode[0].omega;
	hawser_modes_clear(&modes);
	return opened;
}

/* --- sizes --- */

/* Times are not tested here. */
static void check_size(const struct hawser_plan_row *row)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;

	if (!ok(!row->choice.fidelity->build(&rom, &statics, &scene, row->choice.number, &report),
	        "%s builds %s", row->choice.name, report.message))
		return;
	ok(row->n == rom.n && row->quads == rom.quads && row->cubics == rom.cubics,
	   "%s: %d, %ld, %ld planned, %d, %d, %d built", row->choice.name, row->n, row->quads,
	   row->cubics, rom.n, rom.quads, rom.cubics);
	hawser_rom_clear(&rom);
}

static void check_sizes(const char *name)
{
	struct hawser_fidelity_choice choice[16];
	struct hawser_plan plan;
	struct hawser_report report = {.message = ""};
	int count;

	if (!open_scene(name) ||
	    !ok(!hawser_fidelities_read(choice, &count, "multiple-scales 7,raw 1-4,raw:11,  condensed 6 "
	                                ",full 5", 16, &report) && count == 8, "a list of %d %s",
	        count, report.message))
		return;
	ok(!strcmp(choice[5].name, "raw 11") && choice[5].number == 11, "with a name: %s",
	   choice[5].name);
	if (ok(!hawser_plan_make(&plan, &statics, &scene, choice, count, 0.6*w1, 1.4*w1, &report),
	       "a plan %s", report.message)) {
		for (int i = 0; i < plan.rows; i++)
			check_size(&plan.row[i]);
		hawser_plan_clear(&plan);
	}
	hawser_scene_clear(&scene);
}

/* --- responses --- */

static int run(struct hawser_study_curve *curve, const char *name, double from, double to,
               double step)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_fidelity_choice choice;
	struct hawser_report report = {.message = ""};
	int count;

	options.from = from*w1;
	options.to = to*w1;
	options.step_max = step;
	return ok(!hawser_fidelities_read(&choice, &count, name, 1, &report) &&
	          !hawser_study_run(curve, &statics, &scene, &choice, &options, &report),
	          "%s: %d points, %d landmarks %s", name, curve->frf.points, curve->landmarks,
	          report.message);
}

/* The same response in short steps has the same folds and peaks, within their stated
 * uncertainties. */
static void check_sharp(void)
{
	struct hawser_study_curve curve = {.n = 0}, fine = {.n = 0};
	struct hawser_study_error error = {.partner = NULL};
	double worst = 0.0, stated = 0.0, beyond = 0.0, from = getenv("HAWSER_LONG") ? 0.7 : 0.9;

	if (run(&curve, "condensed 4", from, 1.25, 0.02) &&
	    run(&fine, "condensed 4", from, 1.25, from > 0.8 ? 0.004 : 0.002) &&
	    ok(!hawser_study_compare(&error, &curve, &fine, NULL, NULL), "compared")) {
		ok(error.fold.matched > 0 && error.peak.matched > 4 &&
		   error.fold.missing + error.fold.extra + error.peak.missing + error.peak.extra == 0,
		   "the same %d folds and %d peaks", error.fold.matched, error.peak.matched);
		for (int i = 0; i < curve.landmarks; i++) {
			const struct hawser_landmark *own = &curve.landmark[i];
			const struct hawser_landmark *other = &fine.landmark[error.partner[i]];

			if (own->kind != HAWSER_LANDMARK_PEAK || error.partner[i] < 0)
				continue;
			worst = fmax(worst, fabs(own->omega/other->omega - 1.0));
			stated = fmax(stated, own->omega_error + other->omega_error);
			beyond = fmax(beyond, fabs(own->omega/other->omega - 1.0)/
			                      (own->omega_error + other->omega_error));
			beyond = fmax(beyond, fabs(own->size/other->size - 1.0)/
			                      (own->size_error + other->size_error));
		}
		/* most of the uncertainty is that of the orbits, with a tolerance of 1e-6 */
		ok(worst < 3e-6 && stated < 3e-5, "peaks agree to %.1e, stated %.1e", worst, stated);
		ok(beyond < 1.0, "and each to what is stated of it: %.2g", beyond);
		ok(fabs(error.fold.omega) < 1e-8, "folds agree to %.1e", error.fold.omega);
		ok(error.distance < 1e-3 && error.distance >= worst, "distance of the curves %.1e",
		   error.distance);
		ok(curve.tension > statics.T0 && fabs(error.tension) < 0.01, "tension %g N, %.1e off",
		   curve.tension, error.tension);
	}
	hawser_study_error_clear(&error);
	hawser_study_clear(&fine);
	hawser_study_clear(&curve);
}

/* A copy with all frequencies multiplied by `factor` is as far away as the folds are: |factor - 1|. */
static void check_distance(struct hawser_study_curve *curve)
{
	const double factor = 1.0037;
	struct hawser_study_curve shifted = *curve;
	struct hawser_study_error error = {.partner = NULL};
	size_t points = (size_t)curve->frf.points, marks = (size_t)curve->landmarks;

	shifted.frf.point = malloc((points + 1)*sizeof *shifted.frf.point);
	shifted.frf.event = malloc(((size_t)curve->frf.events + 1)*sizeof *shifted.frf.event);
	shifted.landmark = malloc((marks + 1)*sizeof *shifted.landmark);
	if (ok(shifted.frf.point && shifted.frf.event && shifted.landmark, "memory")) {
		memcpy(shifted.frf.point, curve->frf.point, points*sizeof *shifted.frf.point);
		memcpy(shifted.frf.event, curve->frf.event,
		       (size_t)curve->frf.events*sizeof *shifted.frf.event);
		memcpy(shifted.landmark, curve->landmark, marks*sizeof *shifted.landmark);
		for (size_t i = 0; i < points; i++)
			shifted.frf.point[i].omega *= factor;
		for (int i = 0; i < curve->frf.events; i++)
			shifted.frf.event[i].omega *= factor;
		for (size_t i = 0; i < marks; i++)
			shifted.landmark[i].omega *= factor;
		if (ok(!hawser_study_compare(&error, &shifted, curve, NULL, NULL), "compared"))
			ok(error.fold.matched > 0 && fabs(error.distance - (factor - 1.0)) < 1e-12,
			   "shifted by 0.37 %%: distance %.6g", error.distance);
	}
	hawser_study_error_clear(&error);
	free(shifted.frf.point);
	free(shifted.frf.event);
	free(shifted.landmark);
}

/* The distance of a response from itself is 0; a response over another range has no common folds
 * and peaks. */
static void check_itself(void)
{
	struct hawser_study_curve curve = {.n = 0}, other = {.n = 0};
	struct hawser_study_error error = {.partner = NULL};

	if (run(&curve, "raw 3", 0.8, 1.25, 0.02) && run(&other, "raw 3", 2.5, 2.8, 0.02)) {
		ok(!hawser_study_compare(&error, &curve, &curve, NULL, NULL) &&
		   error.fold.omega == 0.0 && error.peak.size == 0.0 && error.peak.extra == 0 &&
		   error.fold.missing == 0 && error.tension == 0.0 && error.distance == 0.0, "itself");
		hawser_study_error_clear(&error);
		check_distance(&curve);
		ok(!hawser_study_compare(&error, &other, &curve, NULL, NULL) &&
		   error.fold.matched + error.peak.matched == 0 && isnan(error.fold.omega) &&
		   error.fold.missing > 0, "nothing in common: %d folds missing", error.fold.missing);
	}
	hawser_study_error_clear(&error);
	hawser_study_clear(&other);
	hawser_study_clear(&curve);
}

/* --- estimates --- */

static const struct hawser_plan_row *row_of(const struct hawser_plan *plan, const char *name)
{
	for (int i = 0; i < plan->rows; i++)
		if (!strcmp(plan->row[i].choice.name, name))
			return &plan->row[i];
	return NULL;
}

/* The estimated error of a raw model has the size of the measured one, and the order of the
 * fidelities by estimated errors is that by measured ones. */
static void check_estimates(const char *name, double from, double to, int rows, double factor)
{
	static const char *const list[] = {"raw 5", "condensed 5", "raw 9", "condensed 9"};
	struct hawser_fidelity_choice choice[5];
	struct hawser_plan plan = {.rows = 0};
	struct hawser_study_curve reference = {.n = 0};
	struct hawser_report report = {.message = ""};
	double measured[4];
	int count;

	if (!open_scene(name) || !ok(!hawser_fidelities_read(choice, &count,
	                             "raw 5, raw 9, condensed 5, condensed 9", 5, &report) &&
	                             !hawser_plan_make(&plan, &statics, &scene, choice, count, from*w1,
	                             to*w1, &report), "a plan %s", report.message))
		return;
	if (!run(&reference, getenv("HAWSER_LONG") ? "condensed 11" : "condensed 8", from, to, 0.02))
		goto done;
	for (int i = 0; i < rows; i++) {
		struct hawser_study_curve curve = {.n = 0};
		struct hawser_study_error error = {.partner = NULL};
		const struct hawser_plan_row *row = row_of(&plan, list[i]);

		measured[i] = NAN;
		if (run(&curve, list[i], from, to, 0.02) &&
		    !hawser_study_compare(&error, &curve, &reference, NULL, NULL))
			measured[i] = fabs(error.largest.omega);
		printf("# %s %s: estimated %.2e, measured %.2e; %.0f points estimated, %d; %.2g s, %.2g\n",
		       name, list[i], row->omega_error, measured[i], row->points, curve.frf.points,
		       row->seconds, curve.build_seconds + curve.respond_seconds);
		/* a raw model may have any number of additional folds */
		if (!strncmp(list[i], "condensed", 9))
			ok(row->points < 3.0*curve.frf.points && row->points > curve.frf.points/3.0,
			   "points within a factor of 3");
		hawser_study_error_clear(&error);
		hawser_study_clear(&curve);
	}
	for (int i = 0; i < rows; i += 2) {
		double estimate = row_of(&plan, list[i])->omega_error;

		ok(estimate < factor*measured[i] && estimate > measured[i]/factor,
		   "%s: an estimate of %.2e for an error of %.2e", list[i], estimate, measured[i]);
		ok((row_of(&plan, list[i + 1])->omega_error < estimate) == (measured[i + 1] < measured[i]),
		   "and condensation is worth it as estimated: %.2e for %.2e",
		   row_of(&plan, list[i + 1])->omega_error, measured[i + 1]);
	}
done:
	hawser_study_clear(&reference);
	hawser_plan_clear(&plan);
	hawser_scene_clear(&scene);
}

/* --- refusals --- */

static void check_refusals(void)
{
	struct hawser_fidelity_choice choice[4];
	struct hawser_plan plan;
	struct hawser_study_curve curve;
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	int count;

	ok(hawser_fidelities_read(choice, &count, "raw 3-9", 4, &report) == HAWSER_ERR_ARGUMENT,
	   "too many: %s", report.message);
	ok(hawser_fidelities_read(choice, &count, "raw 3,,", 4, &report) == HAWSER_ERR_ARGUMENT,
	   "an empty entry: %s", report.message);
	ok(hawser_fidelities_read(choice, &count, "raw x", 4, &report) == HAWSER_ERR_ARGUMENT,
	   "no number: %s", report.message);
	if (!ok(!hawser_fidelities_read(choice, &count, "multiple-scales", 4, &report), "one"))
		return;
	ok(hawser_plan_make(&plan, &statics, &scene, choice, 1, 2.0, 2.0, &report) ==
	   HAWSER_ERR_ARGUMENT && plan.rows == 0, "no range: %s", report.message);
	ok(hawser_plan_make(&plan, &statics, &scene, choice, 1, 2.0, NAN, &report) ==
	   HAWSER_ERR_ARGUMENT, "no number: %s", report.message);
	options.from = 0.8*w1;
	options.to = 1.2*w1;
	scene.damping.kind = HAWSER_DAMPING_NONE;
	ok(hawser_study_run(&curve, &statics, &scene, choice, &options, &report) ==
	   HAWSER_ERR_NO_SOLUTION && curve.status == HAWSER_ERR_NO_SOLUTION, "no damping: %s",
	   report.message);
	hawser_study_clear(&curve);
	scene.load.present = 0;
	ok(!hawser_plan_make(&plan, &statics, &scene, choice, 1, 2.0, 5.0, &report) &&
	   plan.resonances == 0 && isnan(plan.row[0].omega_error) && plan.decisions > 5,
	   "a scene without a load has a plan, and no estimates");
	hawser_plan_clear(&plan);
	hawser_plan_clear(&plan);
	hawser_plan_clear(NULL);
	hawser_study_clear(NULL);
	hawser_study_error_clear(NULL);
}

CASE(property_study)
{
	int more = getenv("HAWSER_LONG") != NULL;

	check_sizes("b-table-4.2");
	check_sizes("inclined");
	if (open_scene("b-table-4.4-line-2")) {
		check_sharp();
		check_itself();
		check_refusals();
		hawser_scene_clear(&scene);
	}
	check_estimates("b-table-4.4-line-2", more ? 0.7 : 0.88, more ? 1.25 : 1.1, more ? 4 : 2, 4.0);
	/* its raw 9 has hundreds of additional folds */
	check_estimates("b-table-5.4-at-rest", 0.9, more ? 1.25 : 1.2, 2, 4.0);
	return done_testing();
}

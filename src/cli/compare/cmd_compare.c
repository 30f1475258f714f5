/* cli/compare/cmd_compare.c - hawser compare: a scene at several fidelities against the most accurate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/compare/compare_result.h"
#include "cli/frame/progress.h"
#include "cli/motion/integrate_span.h"
#include "core/report.h"

enum { planned_most = 40 }; /* modes or functions: largest number for which the plan estimates
                             * without being asked */

struct settings {
	struct cli_common common;
	const char *from, *to, *fidelities, *reference;
	double tolerance, step, limit;
	int points, landmarks;
};
static const struct settings defaults = {
	.step = CLI_STEP, .limit = 10.0};
static const char usual[] = "multiple-scales, raw 5, raw 9, condensed 5, condensed 9, condensed 12, "
                            "condensed 16";

static const struct cli_option options[] = {
	CLI_RANGE_OPTIONS("frequency at which the curves start (0.6w1)",
	                  "other end of the range (3.3w1)"),
	CLI_TEXT_OPTION(fidelities, "LIST", "what to compare, separated by commas"),
	CLI_TEXT_OPTION(reference, "FIDELITY",
	                "fidelity to compare with (the most accurate of LIST)"),
	{"landmarks", 0, "", "print a row for each fold and peak, not for each fidelity",
	 CLI_FLAG(landmarks)},
	CLI_HEADING("Steps and limits"),
	CLI_TOLERANCE_OPTION("residual and integration error, relative to the orbit (1e-9)"),
	CLI_STEP_OPTION,
	CLI_POINTS_OPTION("end a curve after this many points (20000)"),
	{"limit", 0, "SECONDS", "processor time that a curve may take; the reference more (10)",
	 CLI_POSITIVE(limit)},
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_FORM_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Follows the response of the scene's model at every fidelity of LIST, matches folds and peaks",
	"along the curves, and tabulates their errors against the most accurate one, and the times taken.",
	"LIST: multiple-scales N, raw N, condensed N, chosen N, full N (modes or functions), auto A (%);",
	"raw 5-9 stands for raw 5, raw 6 and so on. Of nets and ropeways, the first two are compared; of",
	"nets with the mesh.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	"hawser compare modes compares methods for modes (hawser compare modes --help).",
	NULL,
};

/* 1 if the fidelity is a required accuracy and not a model. It states its own error estimate. */
static int promises(const struct hawser_fidelity_choice *choice)
{
	return choice->fidelity->counts == HAWSER_NUMBER_PERCENT;
}

/* --- one fidelity after another --- */

struct watch {
	struct cli_watch shown;
	char label[80];
	const struct hawser_frf *curve; /* the limit applies to this curve, not to those computed for
	                                 * the refinement of peaks */
	int automatic; /* which traces many */
	double limit, started; /* processor time, s: of this curve, and at its beginning */
};

/* Largest processor time, s. The reference is the most expensive curve, and there is no result
 * without it. It may therefore take as long as all curves together. */
static double limit_of(const struct cli_compare_result *result, int i)
{
	return i == result->reference ? result->limit*result->count : result->limit;
}

static int watch_trace(void *data, const struct hawser_progress_state *state)
{
	struct watch *watch = data;

	return cli_watch(&watch->shown, state) ||
	       ((state->frf == watch->curve || watch->automatic) &&
	        cli_processor_seconds() - watch->started > watch->limit);
}

/* A failure becomes part of the result; only a failure of the reference ends the command. */
static enum hawser_status try_one(struct cli_compare_result *result, int i,
                                  const struct hawser_frf_options *settings,
                                  struct hawser_report *report)
{
	struct hawser_fidelity_choice choice = result->curve[i].choice;
	enum hawser_status status;

	status = result->model->made ? cli_compare_made(result, i, settings, report)
	         : hawser_study_run(&result->curve[i], &result->model->statics, &result->model->scene,
	                            &choice, settings, report);
	result->done[i] = !cli_interrupted();
	if (status == HAWSER_ERR_MEMORY || i == result->reference)
		return status;
	return HAWSER_OK;
}

/* The frequency farthest from the beginning of the range that the curve reached. */
static double reached(const struct hawser_study_curve *curve, double from, double to)
{
	double most = from;

	for (int i = 0; i < curve->frf.points; i++)
		if ((curve->frf.point[i].omega - most)*(to - from) > 0.0)
			most = curve->frf.point[i].omega;
	return most;
}

/* Fail if the reference is incomplete: errors with respect to a part of a curve would mislead. */
static enum hawser_status check_reference(const struct cli_compare_result *result,
                                          struct hawser_report *report)
{
	const struct hawser_study_curve *curve = &result->curve[result->reference];
	const char *outcome = cli_compare_outcome(result, result->reference);
	double unit = cli_per_omega(result->model);

	if (strcmp(outcome, "unreached") == 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "compare",
		                    "the reference, %s, came to an error of %.2g only, by its own "
		                    "estimate: name another --reference, or narrow the range",
		                    curve->choice.name, curve->estimated);
	if (strcmp(outcome, "cut") != 0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "compare",
	                    "the reference, %s, was cut (%s) after %d points; of the range from %.6g to "
	                    "%.6g rad/s it got to %.6g: end the range before that (--to), raise %s, or "
	                    "name another --reference", curve->choice.name, cli_compare_ended(curve),
	                    curve->frf.points, result->from*unit, result->to*unit,
	                    reached(curve, result->from, result->to)*unit,
	                    curve->frf.end == HAWSER_END_MAX_POINTS ? "--max-points" : "--limit");
}

/* The reference is computed first, so that the curves computed before an interruption can be
 * compared. */
static enum hawser_status run_all(struct cli_compare_result *result,
                                  const struct settings *settings, struct hawser_report *report)
{
	struct watch watch = {.shown = {.progress = {.quiet = settings->common.quiet},
	                                .label = watch.label}};
	struct hawser_frf_options trace = {.method = NULL};
	enum hawser_status status = HAWSER_OK;

	trace.from = result->from;
	trace.to = result->to;
	trace.step_max = settings->step;
	if (settings->tolerance > 0.0)
		trace.tolerance = settings->tolerance;
	if (settings->points > 0)
		trace.max_points = settings->points;
	hawser_frf_settle(&trace);
	result->tolerance = trace.tolerance;
	trace.progress = (struct hawser_progress){watch_trace, &watch};
	for (int k = 0; k < result->count && !status && !cli_interrupted(); k++) {
		int i = k == 0 ? result->reference : k <= result->reference ? k - 1 : k;

		if (result->done[i]) /* with the mesh */
			continue;
		snprintf(watch.label, sizeof watch.label, "%s (%d of %d)", result->curve[i].choice.name,
		         k + 1, result->count);
		watch.curve = &result->curve[i].frf;
		watch.automatic = promises(&result->curve[i].choice) || cli_compare_is_mesh(result, i);
		watch.limit = limit_of(result, i);
		watch.started = cli_processor_seconds();
		status = try_one(result, i, &trace, report);
		if (!status && k == 0)
			status = check_reference(result, report);
	}
	cli_progress_end(&watch.shown.progress);
	return status;
}

static enum hawser_status compare_all(struct cli_compare_result *result,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < result->count && !status; i++)
		if (cli_compare_has(result, i) && cli_compare_has(result, result->reference)) {
			status = hawser_study_compare(&result->error[i], &result->curve[i],
			                              &result->curve[result->reference], NULL, report);
			if (!status && cli_compare_is_mesh(result, result->reference))
				cli_compare_made_count(result, i);
		}
	return status;
}

/* --- what was asked for --- */

static int same(const struct hawser_fidelity_choice *a, const struct hawser_fidelity_choice *b)
{
	return a->fidelity == b->fidelity && a->number == b->number;
}

/* For the same fidelity: 1 if a has more modes or functions, or a smaller percentage, than b. */
static int finer(const struct hawser_fidelity_choice *a, const struct hawser_fidelity_choice *b)
{
	return a->fidelity->counts == HAWSER_NUMBER_PERCENT ? a->number < b->number
	       : a->number > b->number;
}

/* The most accurate fidelity: the last row of the table (rows are ordered from cheap to accurate)
 * with the finest number. Either among the required accuracies or among the others; -1 if there are
 * none. */
static int last_row(const struct cli_compare_result *result, int promising)
{
	int best = -1;

	for (int i = 0; i < result->count; i++) {
		const struct hawser_fidelity_choice *own = &result->curve[i].choice, *other;

		if (promises(own) != promising)
			continue;
		other = best < 0 ? NULL : &result->curve[best].choice;
		if (!other || own->fidelity > other->fidelity ||
		    (own->fidelity == other->fidelity && finer(own, other)))
			best = i;
	}
	return best;
}

/* A required accuracy is preferred to a model that does not converge, and to a convergent model
 * whose error, as estimated by the plan, is larger. */
static int most_accurate(const struct cli_compare_result *result, const double *error)
{
	int model = last_row(result, 0), promise = last_row(result, 1);
	const struct hawser_fidelity *row;

	if (model < 0 || promise < 0)
		return model < 0 ? promise : model;
	row = result->curve[promise].choice.fidelity;
	if (result->curve[model].choice.fidelity > row)
		return model;
	return !result->curve[model].choice.fidelity->converges || error[model] > error[promise]
	       ? promise : model;
}

/* Fidelities that are named twice are computed once. */
static void set_choices(struct cli_compare_result *result,
                        const struct hawser_fidelity_choice *choice, int count)
{
	for (int i = 0; i < count; i++) {
		int known = 0;

		for (int k = 0; k < result->count; k++)
			known |= same(&result->curve[k].choice, &choice[i]);
		if (!known)
			result->curve[result->count++].choice = choice[i];
	}
}

/* *n: modes of the model from which others are made. */
static enum hawser_status choose(struct cli_compare_result *result, int *n,
                                 const struct settings *settings, struct hawser_report *report)
{
	struct hawser_fidelity_choice choice[CLI_FIDELITIES];
	enum hawser_kind kind = cli_kind(&settings->common);
	int count, extra = 0, made = kind == HAWSER_KIND_NET || kind == HAWSER_KIND_ROPEWAY;
	const char *list = settings->fidelities ? settings->fidelities : made ? CLI_COMPARE_MADE : usual;
	enum hawser_status status = hawser_fidelities_read(choice, &count, list, CLI_FIDELITIES - 2,
	                                                   report);

	*n = 0;
	if (!status && settings->reference)
		status = hawser_fidelities_read(choice + count, &extra, settings->reference, 1, report);
	if (status)
		return status;
	set_choices(result, choice, count + extra);
	result->reference = -1;
	for (int i = 0; extra && i < result->count; i++)
		if (same(&result->curve[i].choice, &choice[count]))
			result->reference = i;
	if (made)
		status = cli_compare_made_choose(result, n, kind == HAWSER_KIND_NET, report);
	if (!status && result->count < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                    "there is nothing to compare %s with: name another fidelity",
		                    choice[0].name);
	return status;
}

/* Estimates by the plan, for fidelities small enough to be estimated quickly; and the reference, if
 * the user named none. If the plan fails, there are no estimates, and the reference is chosen
 * without them. */
static void plan(struct cli_compare_result *result)
{
	struct hawser_fidelity_choice choice[CLI_FIDELITIES];
	double error[CLI_FIDELITIES];
	int at[CLI_FIDELITIES] = {0}, count = 0;
	struct hawser_plan made = {0};

	for (int i = 0; i < result->count; i++) {
		result->estimate[i] = error[i] = NAN;
		if (result->curve[i].choice.number > planned_most)
			continue;
		at[count] = i;
		choice[count++] = result->curve[i].choice;
	}
	if (count > 0 && !result->model->made &&
	    !hawser_plan_make(&made, &result->model->statics, &result->model->scene,
	                                   choice, count, result->from, result->to, NULL))
		for (int k = 0; k < made.rows; k++) {
			result->estimate[at[k]] = made.row[k].seconds;
			error[at[k]] = made.row[k].omega_error;
		}
	hawser_plan_clear(&made);
	if (result->reference < 0)
		result->reference = most_accurate(result, error);
}

/* Before the work. */
static void announce(const struct cli_compare_result *result)
{
	double sum = 0.0;
	char planned[40] = "";

	for (int i = 0; i < result->count; i++)
		if (isfinite(result->estimate[i]))
			sum += fmin(result->estimate[i], limit_of(result, i));
	if (sum > 0.0)
		snprintf(planned, sizeof planned, " some %.2g s by the plan;", sum);
	cli_progress_note(result->common->quiet, "%d fidelities, reference %s:%s at most %.6g s of "
	                  "processor time a curve, %.6g s the reference (--limit)", result->count,
	                  result->curve[result->reference].choice.name, planned, result->limit,
	                  limit_of(result, result->reference));
}

static enum hawser_status range(struct cli_compare_result *result, const struct settings *settings,
                                struct hawser_report *report)
{
	const struct cli_model *model = result->model;

	if (model->made ? model->rom.harmonics == 0
	    : !cli_driven(&model->scene) && !(model->scene.travel.fluctuation > 0.0))
		return hawser__fail(report, HAWSER_ERR_SCENE, "compare",
		                    "%s: there is no load, so there is no response to compare: add a "
		                    "section load", settings->common.input);
	if (model->scene.damping.drag > 0.0)
		return hawser__fail(report, HAWSER_ERR_SCENE, "compare",
		                    "%s: damping.drag is quadratic, and the fidelities compared have linear "
		                    "damping: set damping.drag=0", settings->common.input);
	return cli_range(&result->from, &result->to, settings->from, settings->to, "compare", model,
	                 report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_compare_result *result = calloc(1, sizeof *result);
	struct cli_model model = {0};
	enum hawser_status status;
	int n;

	if (!result)
		return hawser__no_memory(report, "compare");
	result->common = &settings->common;
	result->model = &model;
	result->landmarks = settings->landmarks;
	result->limit = settings->limit;
	status = choose(result, &n, settings, report);
	if (!status)
		status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = cli_model_load(&model, &settings->common, n, report);
	if (!status)
		status = range(result, settings, report);
	if (status)
		goto done;
	plan(result);
	announce(result);
	status = run_all(result, settings, report);
	if (!status)
		status = compare_all(result, report);
	if (!status)
		status = cli_show(&settings->common, &cli_compare_showing, result, report);
done:
	for (int i = 0; i < result->count; i++) {
		hawser_study_error_clear(&result->error[i]);
		hawser_study_clear(&result->curve[i]);
	}
	cli_model_clear(&model);
	free(result);
	return status;
}

const struct cli_command cli_compare = {
	"compare", "SCENE", "Fidelities of a scene: errors of folds and peaks against time", notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_compare_listing,
	.takes = CLI_FORCED | CLI_CABLE | CLI_TRAVELLING | CLI_NET | CLI_ROPEWAY,
};

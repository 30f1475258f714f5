/* cli/cmd_compare.c - hawser compare: a scene at several fidelities against the most accurate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/compare_result.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *fidelities, *reference;
	double tolerance, step, limit;
	int points, landmarks;
};
static const struct settings defaults = {
	.from = "0.6w1", .to = "3.3w1", .step = CLI_STEP, .limit = 60.0,
	.fidelities = "multiple-scales, raw 5, raw 9, condensed 5, condensed 9, condensed 12, "
	              "condensed 16",
};

static const struct cli_option options[] = {
	{"from", 0, "FREQUENCY", "where the curves start (0.6w1)", cli_store_text,
	 offsetof(struct settings, from)},
	{"to", 0, "FREQUENCY", "other end of the range (3.3w1)", cli_store_text,
	 offsetof(struct settings, to)},
	{"fidelities", 0, "LIST", "what to compare, separated by commas", cli_store_text,
	 offsetof(struct settings, fidelities)},
	{"reference", 0, "FIDELITY", "what to compare with (the most accurate of LIST)",
	 cli_store_text, offsetof(struct settings, reference)},
	{"landmarks", 0, "", "a row for each fold and peak, not each fidelity", cli_store_flag,
	 offsetof(struct settings, landmarks)},
	{"tolerance", 0, "NUMBER", "residual and integration error, relative to the orbit (1e-9)",
	 cli_store_positive, offsetof(struct settings, tolerance)},
	{"step", 0, "NUMBER", "longest step, as a part of the range (0.005)", cli_store_positive,
	 offsetof(struct settings, step)},
	{"max-points", 0, "N", "end a curve after this many points (20000)", cli_store_count,
	 offsetof(struct settings, points)},
	{"limit", 0, "SECONDS", "end a curve that takes longer (60)", cli_store_positive,
	 offsetof(struct settings, limit)},
	{NULL, 0, NULL, NULL, NULL, 0},
};

static const char *const notes[] = {
	"Follows the response of the scene's model at every fidelity of LIST, matches folds and peaks",
	"along the curves, and tabulates errors against the most accurate beside the time they took.",
	"LIST: multiple-scales N, raw N, condensed N, chosen N (modes), auto A (%), full N; raw 5-9.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	"hawser compare modes compares methods for modes (hawser compare modes --help).",
	NULL,
};

/* --- one fidelity after another --- */

struct watch {
	struct cli_progress progress;
	const struct cli_compare_result *result;
	const char *name;
	int done;
	const struct hawser_frf *curve; /* what the limit holds for: not what peaks are sharpened by */
	double limit, started; /* s */
};

static int watch_trace(void *context, const struct hawser_frf *frf)
{
	struct watch *watch = context;

	cli_progress_show(&watch->progress, "%s (%d of %d): %d points, %d events, Omega %.6g",
	                  watch->name, watch->done + 1, watch->result->count, frf->points,
	                  frf->events,
	                  frf->point[frf->points - 1].omega*cli_per_omega(watch->result->model));
	return cli_interrupted() ||
	       (frf == watch->curve && cli_seconds() - watch->started > watch->limit);
}

/* What fails is told in the result; only a reference that fails ends the work. */
static enum hawser_status try_one(struct cli_compare_result *result, int i,
                                  const struct hawser_frf_options *settings,
                                  struct hawser_report *report)
{
	struct hawser_fidelity_choice choice = result->curve[i].choice;
	enum hawser_status status;

	status = hawser_study_run(&result->curve[i], &result->model->statics, &result->model->scene,
	                          &choice, settings, report);
	result->done[i] = !cli_interrupted();
	if (status == HAWSER_ERR_MEMORY || i == result->reference)
		return status;
	return HAWSER_OK;
}

/* The reference first: what is interrupted later can still be compared. */
static enum hawser_status run_all(struct cli_compare_result *result,
                                  const struct settings *settings, struct hawser_report *report)
{
	struct watch watch = {.progress = {settings->common.quiet, 0, 0.0}, .result = result,
	                      .limit = settings->limit};
	struct hawser_frf_options trace = hawser_frf_defaults();
	enum hawser_status status = HAWSER_OK;

	trace.from = result->from;
	trace.to = result->to;
	trace.step_max = settings->step;
	if (settings->tolerance > 0.0)
		trace.tolerance = settings->tolerance;
	if (settings->points > 0)
		trace.max_points = settings->points;
	result->tolerance = trace.tolerance;
	trace.progress = watch_trace;
	trace.progress_context = &watch;
	for (int k = 0; k < result->count && !status && !cli_interrupted(); k++) {
		int i = k == 0 ? result->reference : k <= result->reference ? k - 1 : k;

		watch.name = result->curve[i].choice.name;
		watch.done = k;
		watch.curve = &result->curve[i].frf;
		watch.started = cli_seconds();
		status = try_one(result, i, &trace, report);
	}
	cli_progress_end(&watch.progress);
	return status;
}

static enum hawser_status compare_all(struct cli_compare_result *result,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < result->count && !status; i++)
		if (cli_compare_has(result, i) && cli_compare_has(result, result->reference))
			status = hawser_study_compare(&result->error[i], &result->curve[i],
			                              &result->curve[result->reference], NULL, report);
	return status;
}

/* --- what was asked for --- */

static int same(const struct hawser_fidelity_choice *a, const struct hawser_fidelity_choice *b)
{
	return a->fidelity == b->fidelity && a->number == b->number;
}

/* Of one fidelity: more modes or functions, or fewer percent. */
static int finer(const struct hawser_fidelity_choice *a, const struct hawser_fidelity_choice *b)
{
	return a->fidelity->counts == HAWSER_NUMBER_PERCENT ? a->number < b->number
	       : a->number > b->number;
}

/* The last row of the table, with the finest number: rows go from cheap to accurate. */
static int most_accurate(const struct hawser_fidelity_choice *choice, int count)
{
	int best = 0;

	for (int i = 1; i < count; i++)
		if (choice[i].fidelity > choice[best].fidelity ||
		    (choice[i].fidelity == choice[best].fidelity &&
		     finer(&choice[i], &choice[best])))
			best = i;
	return best;
}

/* What is named twice is run once. */
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

static enum hawser_status choose(struct cli_compare_result *result,
                                 const struct settings *settings, struct hawser_report *report)
{
	struct hawser_fidelity_choice choice[CLI_FIDELITIES];
	int count, reference = -1, extra = 0;
	enum hawser_status status = hawser_fidelities_read(choice, &count, settings->fidelities,
	                                                   CLI_FIDELITIES - 1, report);

	if (!status && settings->reference)
		status = hawser_fidelities_read(choice + count, &extra, settings->reference, 1, report);
	if (status)
		return status;
	reference = extra ? count : most_accurate(choice, count);
	set_choices(result, choice, count + extra);
	if (result->count < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                    "there is nothing to compare %s with: name another fidelity",
		                    choice[reference].name);
	for (int i = 0; i < result->count; i++)
		if (same(&result->curve[i].choice, &choice[reference]))
			result->reference = i;
	return HAWSER_OK;
}

static enum hawser_status range(struct cli_compare_result *result, const struct settings *settings,
                                struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	enum hawser_status status = HAWSER_OK;

	if (!model->has_scene)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                    "%s is a reduced-model file: fidelities are models of a scene, give "
		                    "that", settings->common.input);
	if (!model->scene.load.present)
		return hawser__fail(report, HAWSER_ERR_SCENE, "compare",
		                    "%s: there is no load, so there is no response to compare: add a "
		                    "section load", settings->common.input);
	status = cli_frequency(&result->from, settings->from, "from", model, report);
	if (!status)
		status = cli_frequency(&result->to, settings->to, "to", model, report);
	if (!status && result->from == result->to)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                      "--from %s and --to %s are the same frequency", settings->from,
		                      settings->to);
	return status;
}

static enum hawser_status check(struct cli_compare_result *result, const struct settings *settings,
                                struct hawser_report *report)
{
	enum hawser_status status = choose(result, settings, report);

	if (!status && settings->step > 1.0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                      "--step %g: it is a part of the range, at most 1", settings->step);
	return status ? status : cli_outputs_check(&settings->common, report);
}

static enum hawser_status write_result(const struct cli_compare_result *result,
                                       struct hawser_report *report)
{
	const struct cli_drawing drawing = {cli_compare_draw, result};
	struct hawser__table table = {0};
	struct hawser__json json = {0};
	enum hawser_status status;

	cli_compare_table(&table, result);
	if (result->common->json)
		cli_compare_json(&json, result);
	status = cli_deliver(result->common, &table, &json, &drawing, report);
	hawser__json_clear(&json);
	hawser__table_clear(&table);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_compare_result *result = calloc(1, sizeof *result);
	struct cli_model model = {0};
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "compare");
	result->common = &settings->common;
	result->model = &model;
	result->landmarks = settings->landmarks;
	status = check(result, settings, report);
	if (!status)
		status = cli_model_load(&model, &settings->common, 0, report);
	if (!status)
		status = range(result, settings, report);
	if (status)
		goto done;
	cli_catch_interrupts();
	status = run_all(result, settings, report);
	if (!status)
		status = compare_all(result, report);
	if (!status)
		status = write_result(result, report);
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
	"compare", "SCENE", "Fidelities compared: errors of folds and peaks against time", notes,
	options, &defaults, sizeof(struct settings), 1, run,
};

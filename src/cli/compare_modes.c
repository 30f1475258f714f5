/* cli/compare_modes.c - hawser compare modes: every method at rising resolution against a reference.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/progress.h"
#include "core/report.h"

/* The reference has modes to spare: the last ones of a method may be others than its last ones. */
enum { spare = 6, most_methods = 16, most_runs = 400 };

struct settings {
	struct cli_common common;
	const char *method;
	int n, from, to;
	double limit;
};
static const struct settings defaults = {.to = 4000, .limit = 0.3};

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", cli_store_integer,
	 offsetof(struct settings, n)},
	{"method", 0, "NAME", "compare this method only (all)", cli_store_text,
	 offsetof(struct settings, method)},
	{"from", 0, "N", "lowest resolution (the number of modes)", cli_store_integer,
	 offsetof(struct settings, from)},
	{"to", 0, "N", "highest resolution (4000)",
	 cli_store_integer, offsetof(struct settings, to)},
	{"limit", 0, "SECONDS", "end a series where one solve takes longer (0.3)",
	 cli_store_positive, offsetof(struct settings, limit)},
	{NULL, 0, NULL, NULL, NULL, 0},
};

/* One method at one resolution. */
struct run {
	struct hawser__cost cost;
	struct hawser_modes_error *error; /* [n] */
	int modes;
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes reference;
	double uncertainty; /* of the reference's frequencies, relative */
	struct run run[most_runs];
	int runs, methods;
	const char *method[most_methods];
	char ended[most_methods][1500]; /* why no higher resolution was tried */
	struct cli_progress progress;
};

/* --- one run --- */

struct job {
	const struct hawser_statics *statics;
	struct hawser_modes_options options;
	struct hawser_report report;
	struct hawser_report again; /* of the runs that are timed */
	struct hawser_modes modes;
};

static int work(void *context)
{
	struct job *job = context;
	struct hawser_modes modes;

	if (hawser_steady_modes_solve(&modes, job->statics, &job->options, &job->again))
		return 0;
	hawser_modes_clear(&modes);
	return 1;
}

/* Worst of the modes; and the worst error that the method itself states. */
static void worst(struct run *run, const struct hawser_modes *modes)
{
	int k;

	for (k = 0; k < run->modes; k++) {
		run->cost.frequency = fmax(run->cost.frequency, run->error[k].frequency);
		run->cost.shape = fmax(run->cost.shape, run->error[k].shape);
		run->cost.stated = fmax(run->cost.stated, modes->mode[k].residual);
	}
}

/* Verify, then time. The status is the method's; it has no say where the result can't be compared. */
static enum hawser_status try_one(struct result *result, struct job *job,
                                  struct hawser_report *report)
{
	struct run *run = &result->run[result->runs];
	enum hawser_status status = hawser_steady_modes_solve(&job->modes, job->statics,
	                                                      &job->options, report);

	if (status)
		return status;
	memset(run, 0, sizeof *run);
	run->modes = job->modes.n;
	run->error = calloc((size_t)run->modes, sizeof *run->error);
	status = run->error ? hawser_modes_compare(run->error, &job->modes, &result->reference, report)
	                    : hawser__no_memory(report, "compare");
	if (status) {
		free(run->error);
		goto done;
	}
	worst(run, &job->modes);
	run->cost.method = job->modes.method;
	run->cost.basis = job->modes.basis;
	run->cost.automatic = job->options.basis == 0;
	run->cost.seconds = cli_gauge_time(work, job);
	run->cost.bytes = cli_gauge_memory(work, job);
	if (job->again.status) {
		if (report)
			*report = job->again;
		status = job->again.status;
		free(run->error);
		goto done;
	}
	result->runs++;
done:
	hawser_modes_clear(&job->modes);
	return status;
}

/* --- all of them --- */

/* Errors in which there is nothing left to gain but luck with round-off. */
static const double frequency_floor = 2e-14, shape_floor = 1e-13;

/* Two runs in a row that gained nothing: round-off, or a method that has no resolution to raise. */
static int gained(const struct result *result, int first)
{
	const struct run *now = &result->run[result->runs - 1];

	if (result->runs - first < 3)
		return 1;
	for (int back = 1; back <= 2; back++) {
		const struct hawser__cost *before = &now[-back].cost, *after = &now[1 - back].cost;

		if ((before->frequency > frequency_floor && after->frequency < 0.95*before->frequency) ||
		    (before->shape > shape_floor && after->shape < 0.95*before->shape))
			return 1;
	}
	return 0;
}

/* Resolutions by steps of the square root of two. A resolution too small for so many modes is passed
 * over; any other refusal ends the climb, and is told. */
static enum hawser_status climb(struct result *result, struct job *job, char *ended, size_t size,
                                struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	int first = result->runs, basis;
	double started = settings->from ? settings->from : job->options.n;
	struct hawser_report own = {0};

	snprintf(ended, size, "before it began: the least resolution, %.0f, is above the greatest, %d",
	         started, settings->to);
	for (double rung = started; rung <= settings->to; rung *= M_SQRT2) {
		basis = (int)(rung + 0.5);
		cli_progress_show(&result->progress, "%s: resolution %d", job->options.method, basis);
		job->options.basis = basis;
		if (result->runs == most_runs - 1 || try_one(result, job, &own)) {
			if (own.status == HAWSER_ERR_MEMORY)
				return hawser__no_memory(report, "compare");
			snprintf(ended, size, "at %d: %s", basis, own.message);
			if (result->runs == first && own.status == HAWSER_ERR_ARGUMENT)
				continue;
			return HAWSER_OK;
		}
		snprintf(ended, size, "at %d, the greatest asked for", basis);
		if (!gained(result, first)) {
			snprintf(ended, size, "at %d, where more gains nothing", basis);
			return HAWSER_OK;
		}
		if (result->run[result->runs - 1].cost.seconds > settings->limit) {
			snprintf(ended, size, "at %d, where one solve takes %.2g s", basis,
			         result->run[result->runs - 1].cost.seconds);
			return HAWSER_OK;
		}
	}
	return HAWSER_OK;
}

static enum hawser_status every_method(struct result *result, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int count;
	const struct hawser_modes_method *row = hawser_steady_modes_methods(&result->statics, &count);

	for (int i = 0; !status && i < count && result->methods < most_methods; i++) {
		const char *name = row[i].name;
		struct job job = {.statics = &result->statics, .options = {.any_error = 1}};
		char *ended = result->ended[result->methods];

		if (result->settings->method && strcmp(result->settings->method, name) != 0)
			continue;
		result->method[result->methods++] = name;
		job.options.method = name;
		job.options.n = result->scene.model.modes;
		status = climb(result, &job, ended, sizeof result->ended[0], report);
		if (status)
			break;
		/* as a user gets it who gives no resolution */
		job.options.basis = 0;
		cli_progress_show(&result->progress, "%s: as it chooses", name);
		if (try_one(result, &job, &job.report)) {
			size_t length = strlen(ended);

			if (job.report.status == HAWSER_ERR_MEMORY)
				status = hawser__no_memory(report, "compare");
			snprintf(ended + length, sizeof result->ended[0] - length,
			         "; left to itself: %s", job.report.message);
		}
	}
	cli_progress_end(&result->progress);
	if (status || result->methods > 0)
		return status;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
	                    "--method %s: there is no such method (hawser modes --list-methods)",
	                    result->settings->method);
}

/* The converged method, then once more with half as many functions again: what the two differ by
 * is what the reference is worth. */
static enum hawser_status refer(struct result *result, struct hawser_report *report)
{
	struct hawser_modes_options choice = {.n = result->scene.model.modes + spare,
	                                      .tolerance = 1e-12, .method = "spectral"};
	struct hawser_modes rough;
	enum hawser_status status;
	int k;

	status = hawser_steady_modes_solve(&rough, &result->statics, &choice, report);
	if (status)
		return status;
	choice.basis = rough.basis;
	choice.basis += choice.basis/2 + 8;
	status = hawser_steady_modes_solve(&result->reference, &result->statics, &choice, report);
	for (k = 0; k < choice.n && !status; k++)
		result->uncertainty = fmax(result->uncertainty,
		                           fabs(rough.mode[k].omega/result->reference.mode[k].omega
		                                - 1.0));
	hawser_modes_clear(&rough);
	return status;
}

/* --- output --- */

static double rad_s(const struct hawser_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

static void comments(struct hawser__table *table, const struct result *result)
{
	int i, k;

	hawser__table_comment(table, "reference: %s, %d functions a component; its frequencies agree "
	                             "with those of a third less of them to %.1e",
	                      result->reference.method, result->reference.basis,
	                      result->uncertainty);
	for (k = 0; k < result->scene.model.modes; k++)
		hawser__table_comment(table, "reference mode %d: omega = %.15g rad/s, %s", k + 1,
		                      rad_s(&result->reference, k),
		                      hawser_plane_name(result->reference.mode[k].plane));
	for (i = 0; i < result->methods; i++)
		hawser__table_comment(table, "%s ended %s", result->method[i], result->ended[i]);
	hawser__table_comment(table, "errors are the largest of %d modes, then of each; time is the best "
	                             "of several; memory is the heap's high-water mark",
	                      result->scene.model.modes);
}

static void fill_table(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	static const char *const column[] = {"method", "resolution", "chosen", "frequency_error",
	                                     "shape_error", "stated_error", "time_s", "memory_bytes"};
	int n = result->scene.model.modes, reproducible = result->settings->common.reproducible, i, k;

	cli_echo_table(table, &result->settings->common, "compare modes", &result->scene,
	               result->settings->method ? result->settings->method : "all");
	comments(table, result);
	for (i = 0; i < 8; i++)
		hawser__table_column(table, "%s", column[i]);
	for (k = 0; k < 2*n; k++)
		hawser__table_column(table, "%s_error_%d", k < n ? "frequency" : "shape", k % n + 1);
	for (i = 0; i < result->runs; i++) {
		const struct run *run = &result->run[i];

		hawser__table_word(table, run->cost.method);
		hawser__table_number(table, run->cost.basis);
		hawser__table_word(table, run->cost.automatic ? "method" : "user");
		hawser__table_number(table, run->cost.frequency);
		hawser__table_number(table, run->cost.shape);
		hawser__table_number(table, run->cost.stated);
		if (reproducible)
			hawser__table_word(table, "");
		else
			hawser__table_number(table, run->cost.seconds);
		if (run->cost.bytes > 0.0 && !reproducible)
			hawser__table_number(table, run->cost.bytes);
		else
			hawser__table_word(table, "");
		for (k = 0; k < n; k++)
			hawser__table_number(table, run->error[k].frequency);
		for (k = 0; k < n; k++)
			hawser__table_number(table, run->error[k].shape);
	}
}

static void reference_json(struct hawser__json *json, const struct result *result)
{
	const struct hawser_modes *reference = &result->reference;
	json_t *into = hawser__json_object(json, json->root, "reference"), *list;
	int k;

	hawser__json_text(json, into, "method", reference->method);
	hawser__json_integer(json, into, "resolution", reference->basis);
	hawser__json_number(json, into, "uncertainty", result->uncertainty);
	list = hawser__json_array(json, into, "omega");
	for (k = 0; k < result->scene.model.modes; k++)
		hawser__json_number(json, list, NULL, rad_s(reference, k));
}

static void run_json(struct hawser__json *json, json_t *list, const struct run *run,
                     int reproducible)
{
	json_t *row = hawser__json_object(json, list, NULL), *modes, *mode;
	int k;

	hawser__json_text(json, row, "method", run->cost.method);
	hawser__json_integer(json, row, "resolution", run->cost.basis);
	hawser__json_flag(json, row, "chosen_by_method", run->cost.automatic);
	hawser__json_number(json, row, "frequency_error", run->cost.frequency);
	hawser__json_number(json, row, "shape_error", run->cost.shape);
	hawser__json_number(json, row, "stated_error", run->cost.stated);
	if (reproducible)
		hawser__json_null(json, row, "time_secs");
	else
		hawser__json_number(json, row, "time_secs", run->cost.seconds);
	if (run->cost.bytes > 0.0 && !reproducible)
		hawser__json_number(json, row, "memory_bytes", run->cost.bytes);
	else
		hawser__json_null(json, row, "memory_bytes");
	modes = hawser__json_array(json, row, "modes");
	for (k = 0; k < run->modes; k++) {
		mode = hawser__json_object(json, modes, NULL);
		hawser__json_integer(json, mode, "index", k + 1);
		hawser__json_integer(json, mode, "reference", run->error[k].partner + 1);
		hawser__json_number(json, mode, "frequency_error", run->error[k].frequency);
		hawser__json_number(json, mode, "shape_error", run->error[k].shape);
	}
}

static void fill_json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	json_t *list, *row;
	int i;

	cli_echo_json(json, &result->settings->common, "compare modes", &result->scene);
	reference_json(json, result);
	list = hawser__json_array(json, json->root, "methods");
	for (i = 0; i < result->methods; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "name", result->method[i]);
		hawser__json_text(json, row, "ended", result->ended[i]);
	}
	list = hawser__json_array(json, json->root, "runs");
	for (i = 0; i < result->runs; i++)
		run_json(json, list, &result->run[i], result->settings->common.reproducible);
	cli_stats_json(json, &result->settings->common);
}

static enum hawser_status draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct result *result = context;
	struct hawser__cost cost[most_runs];
	int i;

	for (i = 0; i < result->runs; i++)
		cost[i] = result->run[i].cost;
	return hawser__plot_compare(path, cost, result->runs, report);
}

/* --- the command --- */

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	enum hawser_status status = cli_scene_load(&result->scene, &settings->common, settings->n,
	                                           report);

	if (!status) /* a number, where the scene leaves it open */
		result->scene.model.modes = cli_modes_options(&result->scene).n;
	if (!status)
		status = hawser_statics_scene(&result->statics, &result->scene, report);
	if (!status)
		status = refer(result, report);
	if (!status)
		status = every_method(result, report);
	if (!status && result->runs == 0)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "compare",
		                      "no method gave a result; %s ended %s", result->method[0],
		                      result->ended[0]);
	return status;
}

static const struct cli_showing showing = {fill_table, fill_json, draw};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "compare");
	result->settings = settings;
	result->progress.quiet = settings->common.quiet;
	status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = solve(result, report);
	if (!status)
		status = cli_show(&settings->common, &showing, result, report);
	for (int i = 0; i < result->runs; i++)
		free(result->run[i].error);
	hawser_modes_clear(&result->reference);
	hawser_scene_clear(&result->scene);
	free(result);
	return status;
}

const struct cli_command cli_compare_modes = {
	"compare modes", "SCENE", "Methods for modes: error against time and memory", NULL, options,
	&defaults, sizeof(struct settings), 1, run, NULL,
};

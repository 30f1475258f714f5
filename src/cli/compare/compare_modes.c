/* cli/compare/compare_modes.c - hawser compare modes: every method at increasing resolution against a
 * reference.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"

/* Additional modes of the reference, since the highest modes of a method may not be its highest
 * ones. */
enum { spare = 6, most_methods = 16, most_runs = 400 };

struct settings {
	struct cli_common common;
	const char *method;
	int n, from, to;
	double limit;
};
static const struct settings defaults = {.to = 4000, .limit = 0.3};

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", CLI_INTEGER(n)},
	{"method", 0, "NAME", "compare this method only (all)", CLI_TEXT(method)},
	{"from", 0, "N", "lowest resolution (the number of modes)", CLI_INTEGER(from)},
	{"to", 0, "N", "highest resolution (4000)", CLI_INTEGER(to)},
	{"limit", 0, "SECONDS", "end a series where one solve takes longer (0.3)", CLI_POSITIVE(limit)},
	CLI_NO_OPTION,
};

/* One method at one resolution. */
struct run {
	struct hawser__cost cost;
	struct hawser_modes_error *error; /* [n] */
	int modes, reproducible; /* reproducible results: times are not given */
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes reference;
	double uncertainty; /* error of the reference's frequencies, relative */
	struct run run[most_runs];
	int runs, methods;
	const char *method[most_methods];
	char ended[most_methods][1500]; /* reason why no higher resolution was computed */
	struct cli_progress progress;
};

/* --- one run --- */

struct job {
	const struct hawser_statics *statics;
	struct hawser_modes_options options;
	struct hawser_report report;
	struct hawser_report again; /* of the timed runs */
	struct hawser_modes modes;
};

/* Seconds of wall time of one solution, the best of several. */
static double time_of(struct job *job)
{
	enum { most_repeats = 50 };
	const double enough_secs = 0.1;
	double best = HUGE_VAL, total = 0.0;

	for (int i = 0; i < most_repeats && total < enough_secs; i++) {
		double start = cli_seconds(), took;
		struct hawser_modes modes;

		if (hawser_steady_modes_solve(&modes, job->statics, &job->options, &job->again))
			break;
		hawser_modes_clear(&modes);
		took = cli_seconds() - start;
		best = fmin(best, took);
		total += took;
	}
	return best;
}

/* The largest errors of all modes, and the largest error estimate of the method. */
static void worst(struct run *run, const struct hawser_modes *modes)
{
	int k;

	for (k = 0; k < run->modes; k++) {
		run->cost.frequency = fmax(run->cost.frequency, run->error[k].frequency);
		run->cost.shape = fmax(run->cost.shape, run->error[k].shape);
		run->cost.stated = fmax(run->cost.stated, modes->mode[k].residual);
	}
}

/* Compute the errors first, then measure the time. Returns the status of the method; nothing
 * is measured if the result cannot be compared. */
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
	run->reproducible = result->settings->common.reproducible;
	run->error = calloc((size_t)run->modes + 1, sizeof *run->error);
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
	run->cost.seconds = time_of(job);
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

/* Below these errors a further decrease is round-off. */
static const double frequency_floor = 2e-14, shape_floor = 1e-13;

/* 0 if two successive runs did not reduce the errors: they are round-off, or the method has no
 * resolution to increase. */
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

/* Increase the resolution by factors of sqrt(2). A resolution too small for the number of modes is
 * omitted; any other failure ends the series, and its message is kept. */
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
	const struct hawser_modes_method *row;

	for (int i = 0; !status && result->methods < most_methods &&
	                (row = hawser_steady_modes_method(&result->statics, i)); i++) {
		const char *name = row->name;
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
		/* the resolution that the method chooses by itself */
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

/* The reference is the converged method with half as many functions again. The difference between
 * the two is its error. */
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

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
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
	                             "of several", result->scene.model.modes);
}

static const char *chosen_by(int automatic)
{
	return automatic ? "method" : "user";
}

/* Not given with --reproducible. */
HAWSER__OF(seconds, double, struct run, of->reproducible ? NAN : of->cost.seconds)

HAWSER__OF(modes_of, int, struct result, of->scene.model.modes)

static int errors_of(const void *context)
{
	return 2*modes_of(context);
}

static void error_name(char *text, size_t size, const void *context, int k)
{
	int n = modes_of(context);

	snprintf(text, size, "%s_error_%d", k < n ? "frequency" : "shape", k % n + 1);
}

static double error_at(const void *context, const void *parent, size_t i, int k)
{
	const struct run *run = &((const struct result *)parent)->run[i];
	int n = modes_of(context);

	return k < n ? run->error[k].frequency : run->error[k - n].shape;
}

static double omega_at(const void *context, const void *parent, size_t index, int k)
{
	(void)parent, (void)index;
	return rad_s(&((const struct result *)context)->reference, k);
}
static const struct hawser__vector
	error_vector = {.shown = "frequency_error_J", .count = errors_of, .name = error_name,
	                .number = error_at},
	omega_vector = {.count = modes_of, .number = omega_at};

#define OF(member) HAWSER__AT(struct hawser_modes_error, member)
static const struct hawser__field mode_field[] = {
	{"index", NULL, "number of the mode", .kind = HAWSER__INDEX},
	{"reference", NULL, "mode of the reference with which it is compared", OF(partner),
	 .flags = HAWSER__FROM_1},
	{"frequency_error", NULL, "relative", OF(frequency)},
	{"shape_error", NULL, "of its shape, relative", OF(shape)},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct run, member)
static const struct hawser__field run_field[] = {
	{"method", "method", "for modes", OF(cost.method)},
	{"resolution", "resolution", "functions or points per component", OF(cost.basis)},
	{"chosen_by_method", NULL, "whether the method chose the resolution",
	 HAWSER__FLAG_AT(struct run, cost.automatic)},
	{NULL, "chosen", "who chose the resolution: method or user",
	 HAWSER__LABEL_AT(struct run, cost.automatic, chosen_by)},
	{"frequency_error", "frequency_error", "largest error of a frequency, relative",
	 OF(cost.frequency)},
	{"shape_error", "shape_error", "largest error of a shape, relative", OF(cost.shape)},
	{"stated_error", "stated_error", "largest error that the method states", OF(cost.stated)},
	{"time_secs", "time_s", "s, of one solution, the best of several", HAWSER__BY(seconds),
	 .flags = HAWSER__NULL},
	{NULL, "", "error of mode J; shape_error_J: of its shape", HAWSER__VECTOR_OF(error_vector)},
	{"modes", NULL, "of each mode", HAWSER__STORED(struct run, error, modes, mode_field)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list run_list =
	HAWSER__ROWS_WITHIN(struct result, run, runs, run_field);

struct method {
	const char *name, *ended;
};

static const void *method_row(void *to, const void *parent, size_t i)
{
	const struct result *result = parent;

	*(struct method *)to = (struct method){result->method[i], result->ended[i]};
	return to;
}

static const struct hawser__field method_field[] = {
	{"name", NULL, "of the method", HAWSER__AT(struct method, name)},
	{"ended", NULL, "at which resolution, and why", HAWSER__AT(struct method, ended)},
	HAWSER__END,
};
static const struct hawser__list method_list =
	HAWSER__MADE_ROWS(struct method, method_field, struct result, methods, method_row);
static const struct hawser__field result_field[] = {
	{"reference.method", NULL, "of the reference", HAWSER__AT(struct result, reference.method)},
	{"reference.resolution", NULL, "its functions per component",
	 HAWSER__AT(struct result, reference.basis)},
	{"reference.uncertainty", NULL, "largest change of a frequency from a third less functions",
	 HAWSER__AT(struct result, uncertainty)},
	{"reference.omega", NULL, "its frequencies", HAWSER__VECTOR_OF(omega_vector),
	 .unit = HAWSER__RADIAN_S},
	{"methods", NULL, "compared", HAWSER__OBJECTS_OF(method_list)},
	{"runs", NULL, "each method at each resolution", HAWSER__OBJECTS_OF(run_list)},
	HAWSER__END,
};
const struct cli_listing cli_compare_modes_listing[] = {
	{"Columns of the table:", run_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return (struct cli_head){
		&result->settings->common, "compare modes",
		result->settings->method ? result->settings->method : "all", &result->scene,
		{.scale = hawser__si, .context = result}, NULL, NULL, NULL};
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

	if (!status) /* a number, if the scene does not give one */
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

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &run_list, .fields = result_field, .draw = draw};

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
	"compare modes", "SCENE", "Methods for modes: error against time", NULL, options,
	&defaults, sizeof(struct settings), 1, run, cli_compare_modes_listing,
	.takes = CLI_CABLE | CLI_TRAVELLING,
};

/* cli/compare/compare_motion.c - hawser compare motion: a mesh of cable elements and reduced
 * models in time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/progress.h"
#include "cli/motion/integrate_span.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/curves/plot_motions.h"

enum { PROBES = HAWSER_SPAN_PROBES, MOST = 12, LIST = 120 };

struct settings {
	struct cli_common common;
	const char *omega, *until, *every, *after, *step, *fidelities;
	int elements;
};
static const struct settings defaults = {.until = "20T", .every = "0.02T"};

static const struct cli_option options[] = {
	{"Omega", 0, "FREQUENCY", "forcing frequency; required", CLI_TEXT(omega)},
	{"until", 0, "TIME", "end of the runs (20T)", CLI_TEXT(until)},
	{"every", 0, "TIME", "interval between rows (0.02T)", CLI_TEXT(every)},
	{"after", 0, "TIME", "compare from this time on (0)", CLI_TEXT(after)},
	CLI_TEXT_OPTION(fidelities, "LIST", "reduced models: condensed N, raw N, full N"),
	{"elements", 0, "N", "elements of the mesh (120)", CLI_INTEGER(elements)},
	{"step", 0, "TIME", "steps of the mesh, or auto (a 1000th of a period)", CLI_TEXT(step)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"The scene as a mesh of cable elements that carry tension only, and its reduced models: the same",
	"load from rest, over the same time. The table has the relative root mean square of the difference",
	"from the mesh at a quarter, half and three quarters of the cable. The first row is the mesh: the",
	"estimated error of its own displacements, without which the differences mean little.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	"TIME: a number (s), \"3 min\", or periods of the forcing, 50T.",
	"LIST: without it the scene's number of modes, condensed and raw, and the full-order model.",
	NULL,
};

struct result {
	const struct settings *settings;
	struct cli_span_run of;
	struct hawser_fidelity_choice choice[MOST];
	int choices;
	struct hawser_motions motions;
};

/* --- fields --- */

/* A row: the mesh or a model. */
struct row {
	const char *name, *failed;
	int n;
	double seconds, least, least_at, slack_at, slack_S;
};

static int axes(const void *context)
{
	(void)context;
	return 3*PROBES;
}

static void axis_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%c_%s", "xyz"[k % 3], hawser_net_span_probe(k/3));
}

static void largest_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "max_%c_%s", "xyz"[k % 3], hawser_net_span_probe(k/3));
}

static const struct hawser_motions_run *run_of(const void *parent, size_t index)
{
	return &((const struct result *)parent)->motions.run[index];
}

static double difference_at(const void *context, const void *parent, size_t index, int k)
{
	const struct hawser_motions_run *run = run_of(parent, index);

	(void)context;
	return run->status ? NAN : run->difference[k/3][k % 3];
}

static double largest_at(const void *context, const void *parent, size_t index, int k)
{
	const struct hawser_motions_run *run = run_of(parent, index);

	(void)context;
	return run->status ? NAN : run->largest[k/3][k % 3];
}
static const struct hawser__vector
	difference_vector = {.shown = "y_mid", .count = axes, .name = axis_name,
	                     .number = difference_at, .object = 1},
	largest_vector = {.shown = "max_y_mid", .count = axes, .name = largest_name,
	                  .number = largest_at},
	size_vector = {.count = axes, .name = axis_name, .number = largest_at, .object = 1};

#define OF(member) HAWSER__AT(struct row, member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
static const struct hawser__field row_field[] = {
	{"name", "model", "the mesh and its elements, or a reduced model and its modes", OF(name)},
	{"coordinates", "n", "unknowns of the mesh, coordinates of the model", OF(n)},
	{"difference", "", "root mean square of the difference from the mesh over that of the mesh's "
	 "displacement, at a probe; of the mesh: of its estimated error; null: the mesh does not move",
	 HAWSER__VECTOR_OF(difference_vector), .flags = HAWSER__NULL},
	{NULL, "", "largest displacement", HAWSER__VECTOR_OF(largest_vector), .unit = HAWSER__METRE,
	 .flags = HAWSER__NULL},
	{"largest", NULL, "largest displacements, in m", HAWSER__VECTOR_OF(size_vector),
	 .flags = HAWSER__NULL},
	{"tension.min", "T_min", "least tension, also between the rows",
	 MAYBE(least), .unit = HAWSER__NEWTON},
	{"tension.min_at", NULL, "its time", MAYBE(least_at), .unit = HAWSER__SECOND},
	{"slack_at", "slack_at", "when the mesh first has an element without tension, or the tension of "
	 "a model falls below 0", MAYBE(slack_at), .unit = HAWSER__SECOND},
	{"slack_S", NULL, "where the mesh first has one, from end A", MAYBE(slack_S),
	 .unit = HAWSER__METRE},
	{"processor_secs", "processor_s", "processor time, with the making of the model", MAYBE(seconds)},
	{"failed", NULL, "why a model has no motion", OF(failed), .flags = HAWSER__OMIT},
	HAWSER__END,
};
#undef MAYBE
#undef OF

HAWSER__OF(rows, size_t, struct result, (size_t)of->motions.runs)

static const void *row_at(void *to, const void *parent, size_t index)
{
	const struct result *result = parent;
	const struct hawser_motions_run *run = run_of(parent, index);
	int failed = run->status != HAWSER_OK;

	*(struct row *)to = (struct row){
		.name = run->name, .n = failed && run->n == 0 ? HAWSER__NO_INTEGER : run->n,
		.failed = failed ? run->report.message : NULL, .least = run->least,
		.least_at = run->least_at, .slack_at = run->slack_at, .slack_S = run->slack_S,
		.seconds = result->settings->common.reproducible ? NAN : run->seconds};
	return to;
}
static const struct hawser__list row_list = {
	.field = row_field, .size = HAWSER__MADE_SIZE(struct row), .count = rows, .row = row_at};

/* JSON: displacements of all runs, by run, probe and axis. */
HAWSER__OF(signals, int, struct result, 3*PROBES*of->motions.runs)

static double signal_at(const void *context, const void *parent, size_t row, int k)
{
	const struct hawser_motions_run *run = run_of(parent, (size_t)(k/(3*PROBES)));
	int at = k % (3*PROBES);

	(void)context;
	return run->status ? NAN : run->x[row*PROBES + (size_t)(at/3)][at % 3];
}

static void signal_name(char *text, size_t size, const void *context, int k)
{
	const struct hawser_motions_run *run = run_of(context, (size_t)(k/(3*PROBES)));
	char name[64];

	axis_name(name, sizeof name, NULL, k % (3*PROBES));
	snprintf(text, size, "%s%c%s", run->name, HAWSER__NESTED, name);
}
static const struct hawser__vector signal_vector = {
	.count = signals, .name = signal_name, .number = signal_at, .object = 1};
static const struct hawser__field time_field[] = {
	{"times", NULL, "of the rows", HAWSER__ALONG(struct result, motions.motion.time),
	 .unit = HAWSER__SECOND},
	HAWSER__END,
};
static const struct hawser__field signal_field[] = {
	{"MODEL", NULL, "lists x_quarter, y_quarter and so on, in m",
	 HAWSER__VECTOR_OF(signal_vector), .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__list
	time_list = {.field = time_field, .count_at = offsetof(struct result, motions.rows)},
	signal_list = {.field = signal_field, .count_at = offsetof(struct result, motions.rows)};

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field result_field[] = {
	{"Omega", NULL, "forcing frequency", OF(of.Omega), .unit = HAWSER__RADIAN_S},
	{"after", NULL, "begin of what is compared", OF(of.after), .unit = HAWSER__SECOND},
	{"mesh.elements", NULL, "of the cable", OF(motions.elements)},
	{"mesh.step", NULL, "of time; 0: by the local error", OF(motions.step), .unit = HAWSER__SECOND},
	{"mesh.other", NULL, "elements of the second run, by which the error is estimated; its steps are "
	 "twice as long", OF(motions.other)},
	{"mesh.closure", NULL, "largest error of the energy ledger, over its largest term",
	 OF(motions.motion.closure)},
	{"runs", NULL, "the mesh, then the models", HAWSER__OBJECTS_OF(row_list)},
	{"", NULL, "", HAWSER__ARRAYS_OF(time_list), .flags = HAWSER__STREAM},
	{"displacements", NULL, "of the mesh and the models", HAWSER__ARRAYS_OF(signal_list),
	 .flags = HAWSER__STREAM},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_compare_motion_listing[] = {
	{"Columns of the table:", row_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* --- output --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return (struct cli_head){&result->settings->common, "compare motion",
		"mesh of cable elements against reduced models", &result->of.model.scene,
		{.scale = hawser__si, .context = result}, NULL, NULL, NULL};
}

/* Whether models say of slack what the mesh does. */
static void slack_comment(struct hawser__table *table, const struct result *result)
{
	const struct hawser_motions *motions = &result->motions;
	const struct hawser_motions_run *mesh = &motions->run[0];

	if (isnan(mesh->slack_at))
		hawser__table_comment(table, "the mesh keeps its tension: least %.6g N, at t = %.6g s",
		                      mesh->least, mesh->least_at);
	else
		hawser__table_comment(table, "the mesh is slack from t = %.6g s, first at S = %.6g m; %ld "
		                      "changes of elements between slack and taut", mesh->slack_at,
		                      mesh->slack_S, motions->motion.switches);
	for (int i = 1; i < motions->runs; i++) {
		const struct hawser_motions_run *run = &motions->run[i];

		if (run->status)
			hawser__table_comment(table, "%s failed: %s", run->name, run->report.message);
		if (!isnan(run->slack_at))
			hawser__table_comment(table, "%s: tension below 0 from t = %.6g s, least %.6g N", run->name,
			                      run->slack_at, run->least);
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_motions *motions = &result->motions;
	char step[64] = "by the local error";

	if (motions->step > 0.0)
		snprintf(step, sizeof step, "%.4g s", motions->step);
	hawser__table_comment(table, "Omega = %.12g rad/s, rows every %.6g s from %.6g s to %.6g s",
	                      result->of.Omega, result->of.every, result->of.after, result->of.until);
	hawser__table_comment(table, "mesh: %d elements, steps of %s; energy ledger closed to %.1e",
	                      motions->elements, step, motions->motion.closure);
	if (motions->other)
		hawser__table_comment(table, "the row of the mesh has its estimated errors, by a run with %d "
		                      "elements and steps twice as long; the other rows differences from it: "
		                      "root mean squares over those of the mesh's displacements",
		                      motions->other);
	slack_comment(table, result);
	if (*result->of.warning)
		hawser__table_comment(table, "warning: %s", result->of.warning);
	if (motions->interrupted)
		hawser__table_comment(table, "interrupted");
}

/* y at mid-span and, if the cable leaves its plane, z; below each the differences. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;
	const struct hawser_motions *motions = &result->motions;
	size_t all = (size_t)motions->rows*(size_t)motions->runs;
	double *gap = calloc(2*all + 1, sizeof *gap);
	struct hawser__motions shown = {.rows = motions->rows, .time = motions->motion.time,
		.axis = hawser__axis_of("Time {/:Italic t}", "s", 0.0)};
	enum hawser_status status;

	if (!gap)
		return hawser__no_memory(report, "picture");
	for (int k = 1; k < 3; k++) {
		struct hawser__motion_panel *of_x = &shown.panel[shown.panels], *of_gap = of_x + 1;

		if (!(motions->run[0].largest[1][k] > 1e-6*motions->run[0].largest[1][3 - k]))
			continue;
		*of_x = (struct hawser__motion_panel){.stride = 3*PROBES,
			.axis = hawser__axis_of(k == 1 ? "{/:Italic y}, mid-span"
			                               : "{/:Italic z}, mid-span", "m", 0.0)};
		*of_gap = (struct hawser__motion_panel){.stride = 1,
			.axis = hawser__axis_of(k == 1 ? "{/:Italic y} – mesh"
			                               : "{/:Italic z} – mesh", "m", 0.0)};
		for (int r = 0; r < motions->runs && r < HAWSER__MOTION_CURVES; r++) {
			const struct hawser_motions_run *run = &motions->run[r];
			double *to = gap + (size_t)(k - 1)*all + (size_t)r*(size_t)motions->rows;

			if (run->status)
				continue;
			for (int i = 0; i < motions->rows; i++)
				to[i] = r ? run->x[i*PROBES + 1][k] - motions->run[0].x[i*PROBES + 1][k]
					: motions->off ? motions->off[i*PROBES + 1][k] : 0.0;
			of_x->curve[of_x->curves++] = (struct hawser__motion_curve){run->name, r, &run->x[1][k]};
			of_gap->curve[of_gap->curves++] = (struct hawser__motion_curve){
				r ? run->name : "estimated error of the mesh", r ? r : -1, to};
		}
		shown.panels += 2;
	}
	status = hawser__plot_motions(path, &shown, report);
	free(gap);
	return status;
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &row_list, .fields = result_field, .draw = draw};

/* --- the command --- */

static enum hawser_status choose(struct result *result, struct hawser_report *report)
{
	const char *list = result->settings->fidelities;
	int n = cli_modes_options(&result->of.model.scene).n;
	char usual[LIST];

	snprintf(usual, sizeof usual, "condensed %d, raw %d, full 12", n, n);
	return hawser_fidelities_read(result->choice, &result->choices, list ? list : usual, MOST, report);
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	const struct cli_span_texts texts = {settings->omega, settings->until, settings->every,
	                                     settings->after, settings->step};
	struct cli_watch watch = {{.quiet = settings->common.quiet}, "compare motion"};
	struct hawser_motions_options choice = {.elements = settings->elements, .choice = result->choice,
	                                         .progress = {cli_watch, &watch}};
	enum hawser_status status = cli_span_run(&result->of, &settings->common, &texts, "compare motion",
	                                         report);

	if (!status && !(result->of.Omega > 0.0))
		status = hawser__fail(report, HAWSER_ERR_SCENE, "compare motion",
		                      "%s: there is no load, so there is no motion to compare: add a section "
		                      "load", settings->common.input);
	if (!status)
		status = choose(result, report);
	if (status)
		return status;
	choice.choices = result->choices;
	choice.Omega = result->of.Omega;
	choice.until = result->of.until;
	choice.every = result->of.every;
	choice.after = result->of.after;
	choice.step = result->of.step;
	status = hawser_motions_compare(&result->motions, &result->of.model.scene,
	                                &result->of.model.statics, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "compare motion");
	result->settings = settings;
	status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = solve(result, report);
	if (!status && *result->of.warning)
		cli_warn(result->of.warning);
	if (!status)
		status = cli_show(&settings->common, &showing, result, report);
	hawser_motions_clear(&result->motions);
	cli_model_clear(&result->of.model);
	free(result);
	return status;
}

const struct cli_command cli_compare_motion = {
	"compare motion", "SCENE", "A mesh of cable elements against reduced models, in time", notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_compare_motion_listing,
	.takes = CLI_CABLE | CLI_TRAVELLING,
};

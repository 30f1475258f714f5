/* cli/compare/compare_statics.c - hawser compare statics: methods of the statics of nets on
 * random cables, or on the nets of scenes. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/compare/compare_statics.h"
#include "cli/model/label.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/drawing/figure.h"

struct settings {
	struct cli_common common;
	const char *method;
	double tolerance, noise;
	int nets, seed, steps, profile, each;
};
static const struct settings defaults = {.tolerance = 1e-7};

static const struct cli_option options[] = {
	{"nets", 0, "N", "number of random cables (1600)", CLI_INTEGER(nets)},
	{"seed", 0, "N", "of the random cables (0)", CLI_STORED(cli_store_every, seed)},
	{"method", 0, "NAME", "this method only (all)", CLI_TEXT(method)},
	CLI_TOLERANCE_OPTION("of all methods: unbalanced force over the loads (1e-7)"),
	{"noise", 0, "NUMBER", "of starts at straight cables, over their chords (1e-4)",
	 CLI_POSITIVE(noise)},
	{"steps", 0, "N", "most steps of relaxation (20000; with scenes 1000000)", CLI_INTEGER(steps)},
	{"profile", 0, "", "table of the performance profiles", CLI_FLAG(profile)},
	{"each", 0, "", "table of each method on each net", CLI_FLAG(each)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Without SCENE: random cables between two supports, stiff and soft, deep, shallow and taut. With",
	"SCENE: their nets, whose cables have length0. The table has a row for each method: nets solved,",
	"with compressed elements, not solved; iterations and times. A net counts as solved if the method",
	"says so and a certificate, which uses nothing of the methods, agrees. The picture has the",
	"performance profiles: the part of the nets solved within a multiple of the least time of all.",
	"Methods: automatic, interior-point, cone, mixed, mixed/chord, forces, two-sided,",
	"two-sided/density, regularised, regularised/density, descent, relaxation (man hawser-statics);",
	"/chord and /density: from straight cables with noise, or from force densities, in place of the",
	"method's own start.",
	NULL,
};

/* --- output --- */

static struct cli_head head(const void *of)
{
	const struct cli_compare_statics *result = of;

	return cli_si_head(result->common, "compare statics",
	                   result->of.ways == 1 ? result->of.score[0].way->name : "all", result, 0);
}

static struct cli_head head_each(const void *of)
{
	struct cli_head with = head(of);

	with.view.options = CLI_COMPARE_STATICS_EACH;
	return with;
}

static const struct hawser_net_outcome *outcome_of(const struct cli_compare_statics *result,
                                                   const char *name, int net)
{
	for (int w = 0; w < result->of.ways; w++)
		if (!strcmp(result->of.score[w].way->name, name))
			return &result->of.outcome[w*result->of.nets + net];
	return NULL;
}

/* From scene to answer, and how much longer relaxation takes. */
static void scene_comment(struct hawser__table *table, const struct cli_compare_statics *result,
                          int i)
{
	const struct hawser_net_outcome *own = outcome_of(result, "automatic", i);
	const struct hawser_net_outcome *slow = outcome_of(result, "relaxation", i);

	if (!own || own->end != HAWSER_NET_SOLVED || result->common->reproducible)
		return;
	hawser__table_remark(table, "%s: read in %.3g ms, solved in %.3g ms (automatic): %.3g ms from "
	                     "scene to answer", result->net[i].name, 1e3*result->reading[i],
	                     1e3*own->seconds, 1e3*(result->reading[i] + own->seconds));
	if (slow)
		hawser__table_remark(table, "%s: relaxation %s %.4g ms, %.3g times as long as automatic",
		                     result->net[i].name, slow->end == HAWSER_NET_SOLVED ? "takes"
		                                                                         : "gives up after",
		                     1e3*slow->seconds, slow->seconds/own->seconds);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_compare_statics *result = of;

	if (result->nets == 0)
		hawser__table_comment(table, "%d random cables between two supports, seed %u", result->of.nets,
		                      result->of.seed);
	hawser__table_comment(table, "methods stop where no unbalanced force exceeds %g of the loads",
	                      result->tolerance);
	for (int i = 0; i < result->of.nets && i < result->nets; i++)
		scene_comment(table, result, i);
	hawser__table_comment(table, "solved: the method says so, and the certificate agrees: forces are "
	                      "balanced to %g of all loads, and the energy is so close to the least one "
	                      "that they may be turned by %g rad in the mean", HAWSER_NET_RIGHT,
	                      HAWSER_NET_RIGHT);
	for (int w = 0; w < result->of.ways; w++)
		if (result->of.score[w].wrong > 0)
			hawser__table_comment(table, "%s: %d results are wrong",
			                      result->of.score[w].way->name, result->of.score[w].wrong);
	if (result->of.interrupted)
		hawser__table_comment(table, "interrupted");
}

/* Number of the method among all, by order in the table; its starts have one colour. */
static int colour_of(const char *method)
{
	const char *last = "";
	int colour = -1;

	for (int i = 0; hawser_net_way(i); i++) {
		colour += strcmp(hawser_net_way(i)->method, last) != 0;
		last = hawser_net_way(i)->method;
		if (!strcmp(last, method))
			break;
	}
	return colour;
}

/* How many nets method w solves: those with a finite number. */
static int solved(const struct cli_compare_statics *result, int w, int by)
{
	const double *value = result->sorted[by] + (size_t)w*(size_t)result->of.nets;
	int count = 0;

	while (count < result->of.nets && isfinite(value[count]))
		count++;
	return count;
}

/* Corners of a stair, from 1 to the end of the axis; so many that files stay small, and dashes
 * visible. */
static void put_stair(struct hawser__figure *figure, const struct cli_compare_statics *result, int w,
                      int by, double end)
{
	const double *value = result->sorted[by] + (size_t)w*(size_t)result->of.nets;
	int count = solved(result, w, by), step = 1 + count/150;

	if (count == 0 || value[0] > 1.0)
		hawser__figure_put(figure, 1.0, 0.0);
	for (int i = 0; i < count; i++)
		if (i == count - 1 || (value[i + 1] > value[i] && (i % step == 0 || value[i] <= 1.0)))
			hawser__figure_put(figure, value[i], 100.0*(i + 1)/result->of.nets);
	hawser__figure_put(figure, end, 100.0*count/result->of.nets);
}

/* The end of the axis: the next power of ten above all values. */
static double end_of(const struct cli_compare_statics *result, int by)
{
	double most = 1.0;

	for (int w = 0; w < result->of.ways; w++) {
		int count = solved(result, w, by);

		if (count > 0)
			most = fmax(most,
			            result->sorted[by][(size_t)w*(size_t)result->of.nets + (size_t)count - 1]);
	}
	return pow(10.0, fmax(ceil(log10(most) + 0.01), 1.0));
}

/* Performance profiles: the part of nets that each method solves within a multiple of the least
 * time, and within a number of iterations. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	static const char *const colours[] = {"black", "#0072B2", "#8C564B", "#009E73", "#56B4E9",
	                                      "#D55E00", "#E69F00", "#CC79A7", "#7F7F7F"};
	static const struct hawser__axis y = {"Nets solved (%)", "", 1.0};
	static const struct hawser__axis x[] = {{"Processor time, over that of the fastest", "", 1.0},
	                                        {"Number of iterations", "", 1.0}};
	const struct cli_compare_statics *result = of;
	int timed = !result->common->reproducible;
	double height = HAWSER__LEGEND_CM + 7.6 + 0.4;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, height, report);

	if (status)
		return status;
	for (int by = timed ? 0 : 1; by < 2; by++) {
		double end = end_of(result, by);

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){
			by && timed ? 0.6 : 0.14, by ? 0.97 : 0.53, HAWSER__LEGEND_CM/height, 1.0 - 0.4/height,
			.x = {&x[by], 1.0, end, .logarithmic = 1, .tics = 6},
			.y = {&y, 0.0, 103.0, .tics = 6, .untitled = by && timed}});
		for (int w = 0; w < result->of.ways; w++) {
			const struct hawser_net_way *way = result->of.score[w].way;
			int colour = colour_of(way->method);
			char label[80];

			put_stair(&figure, result, w, by, end);
			snprintf(label, sizeof label, "%s: %.1f %%", way->name,
			         result->of.nets > 0 ? 100.0*solved(result, w, 1)/result->of.nets : 0.0);
			hawser__figure_draw(&figure, NULL, "with steps lw %g lc rgb '%s'%s", colour ? 1.6 : 3.0,
			                    colours[colour % 9], way->start != HAWSER_NET_START_OWN
			                    ? " dt (6,4)" : "");
			hawser__figure_again(&figure, label, "using (NaN):1 with lines lw %g lc rgb '%s'%s",
			                     colour ? 1.6 : 3.0, colours[colour % 9],
			                     way->start != HAWSER_NET_START_OWN ? " dt (6,4)" : "");
		}
	}
	return hawser__figure_finish(&figure, report);
}

static const struct cli_showing
	methods = {.head = head, .comments = comments, .rows = &cli_compare_statics_methods,
	           .fields = cli_compare_statics_field, .draw = draw},
	profile = {.head = head, .comments = comments, .rows = &cli_compare_statics_profile,
	           .fields = cli_compare_statics_field, .draw = draw},
	each = {.head = head_each, .comments = comments, .rows = &cli_compare_statics_each,
	        .fields = cli_compare_statics_field, .draw = draw};

/* --- the command --- */

/* Read a scene; the time is the least of several. */
static enum hawser_status read_scene(struct cli_compare_statics *result, const char *path,
                                     struct hawser_report *report)
{
	enum { REPEATS = 5 };
	const struct cli_common *common = result->common;
	struct hawser_net *net = &result->net[result->nets];
	double *least = &result->reading[result->nets];
	struct hawser_document document;
	enum hawser_status status = hawser_document_open(&document, path, report);

	if (!status && document.kind != HAWSER_KIND_NET)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare statics", "%s is no scene of a "
		                      "net: that is one with kind: net (man hawser-scene, NETS)", path);
	*least = INFINITY;
	for (int i = 0; i < REPEATS && !status; i++) {
		double began = cli_processor_seconds();
		FILE *again = fmemopen(document.text, document.length, "r");
		struct hawser_document twin = {.name = NULL};

		hawser_net_clear(net);
		status = again ? hawser_document_read(&twin, again, document.name, report)
		               : hawser__no_memory(report, "compare statics");
		if (!status)
			status = hawser_net_of(net, &twin, common->set, (size_t)common->sets, report);
		hawser_document_clear(&twin);
		if (again)
			fclose(again);
		*least = fmin(*least, cli_processor_seconds() - began);
	}
	hawser_document_clear(&document);
	if (!status)
		status = hawser_net_refine(net, report);
	for (int c = 0; c < net->cables && !status; c++)
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			status = hawser__fail(report, HAWSER_ERR_SCENE, "compare statics", "%s: cable %s has no "
			                      "length0: methods are compared on nets whose lengths are known; "
			                      "hawser statics gives those that go with a tension, a force density "
			                      "or a sag", path, net->cable[c].name);
	result->nets++;
	return status;
}

static enum hawser_status read_all(struct cli_compare_statics *result, struct hawser_report *report)
{
	const struct cli_common *common = result->common;
	size_t count = (size_t)common->mores + 1;
	enum hawser_status status = HAWSER_OK;

	if (!common->input)
		return HAWSER_OK;
	result->net = calloc(count, sizeof *result->net);
	result->reading = calloc(count, sizeof *result->reading);
	if (!result->net || !result->reading)
		return hawser__no_memory(report, "compare statics");
	for (size_t i = 0; i < count && !status; i++)
		status = read_scene(result, i ? common->more[i - 1] : common->input, report);
	return status;
}

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	if (settings->common.input && (settings->nets || settings->seed))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare statics", "--nets and --seed are of "
		                    "random cables, which are compared without SCENE");
	if (!settings->common.input && settings->common.sets > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare statics", "--set changes a scene, "
		                    "and there is no SCENE");
	if (settings->profile && settings->each)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare statics", "--profile and --each are "
		                    "different tables: choose one");
	return cli_outputs_check_scales(&settings->common, settings->common.input ? "" : "x", report);
}

static enum hawser_status solve(struct cli_compare_statics *result, const struct settings *settings,
                                struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = settings->common.quiet}, "compare statics"};
	struct hawser_net_comparison_options choice = {
		.net = result->net, .nets = result->nets ? result->nets : settings->nets,
		.seed = (unsigned)settings->seed, .way = settings->method,
		.tolerance = settings->tolerance, .noise = settings->noise,
		.steps = settings->steps,
		.progress = {cli_watch, &watch}};
	enum hawser_status status = hawser_net_compare(&result->of, &choice, report);
	size_t all;

	cli_progress_end(&watch.progress);
	if (status)
		return status;
	all = (size_t)result->of.ways*(size_t)result->of.nets;
	for (int by = 0; by < 2; by++) {
		result->sorted[by] = calloc(all + 1, sizeof *result->sorted[by]);
		if (!result->sorted[by])
			return hawser__no_memory(report, "compare statics");
		for (int w = 0; w < result->of.ways; w++)
			hawser_net_comparison_profile(result->sorted[by] + (size_t)w*(size_t)result->of.nets,
			                              &result->of, w, by);
	}
	return HAWSER_OK;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_compare_statics result = {.common = &settings->common,
	                                     .tolerance = settings->tolerance};
	enum hawser_status status = check(settings, report);

	if (!status)
		status = read_all(&result, report);
	if (!status)
		status = solve(&result, settings, report);
	if (!status)
		status = cli_show(&settings->common, settings->profile ? &profile : settings->each ? &each
		                  : &methods, &result, report);
	for (int i = 0; i < result.nets; i++)
		hawser_net_clear(&result.net[i]);
	free(result.net);
	free(result.reading);
	free(result.sorted[0]);
	free(result.sorted[1]);
	hawser_net_comparison_clear(&result.of);
	return status;
}

const struct cli_command cli_compare_statics = {
	"compare statics", "[SCENE...]", "Methods for the statics of nets: success, iterations, times",
	notes, options, &defaults, sizeof(struct settings), 0, run, cli_compare_statics_listing,
	.takes = CLI_NET,
};

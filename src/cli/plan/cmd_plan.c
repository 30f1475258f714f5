/* cli/plan/cmd_plan.c - hawser plan: contents, cost and error of the models of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/beam/beam_result.h"
#include "cli/frame/kinds.h"
#include "cli/plan/plan_result.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *fidelities;
	double limit;
	struct cli_plan_net net; /* of nets only */
};
static const struct settings defaults = {
	.fidelities = "multiple-scales, raw 5, raw 9, raw 16, condensed 5, condensed 9, condensed 12, "
	              "condensed 16, chosen 9, auto, full",
};

static const struct cli_option options[] = {
	{"from", 0, "FREQUENCY", "one end of the range of the response (0.6w1)",
	 CLI_TEXT_FOR(from, CLI_SPAN | CLI_MODEL)},
	{"to", 0, "FREQUENCY", "the other end (3.3w1)", CLI_TEXT_FOR(to, CLI_SPAN | CLI_MODEL)},
	{"fidelities", 0, "LIST", "what to estimate, separated by commas",
	 CLI_TEXT_FOR(fidelities, CLI_SPAN)},
	CLI_HEADING("Nets"),
	{"limit", 0, "SECONDS", "nets: processor time for measuring (0.2 and a tenth of the estimate)",
	 CLI_POSITIVE_FOR(limit, CLI_SPAN | CLI_NET)},
	{"until", 0, "TIME", "nets: end of the motion (ten periods of the slowest load)",
	 CLI_TEXT_FOR(net.until, CLI_NET)},
	{"step", 0, "TIME", "nets: longest step, or auto (the scene's, or auto)",
	 CLI_TEXT_FOR(net.step, CLI_NET)},
	{"method", 0, "NAME", "nets: scheme of time integration (the scene's, or energy)",
	 CLI_TEXT_FOR(net.scheme, CLI_NET)},
	{"rtol", 0, "NUMBER", "nets: local error over the longest cable (1e-7)",
	 CLI_POSITIVE_FOR(net.rtol, CLI_NET)},
	{"modes", 'n', "N", "nets: number of modes (6)", CLI_INTEGER_FOR(net.modes, CLI_NET)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Says what a model of the scene contains, what it leaves out and why; every setting, and whether",
	"it was given or is a default; and for each fidelity of LIST the size of its model, its processor",
	"time on this machine and its error, estimated by formulas: nothing is run, except for nets.",
	"LIST: multiple-scales N, raw N, condensed N, chosen N, full N (modes or functions), auto A (%);",
	"raw 5-9 stands for raw 5, raw 6 and so on. man hawser-compare explains them.",
	NULL,
};

static enum hawser_status choose(struct cli_plan_result *result, const struct settings *settings,
                                 struct hawser_report *report)
{
	if (settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "plan",
		                    "plan has no picture; hawser compare --plot draws errors against time");
	return hawser_fidelities_read(result->choice, &result->choices, settings->fidelities,
	                              CLI_PLAN_ROWS, report);
}

/* Primary resonances are those of loads of the frequency Omega. */
static void warn_harmonics(const struct hawser_scene *scene)
{
	char text[CLI_WARNING_SIZE];

	for (int i = 0; i < scene->loads; i++) {
		if (scene->piece[i].harmonic == 1)
			continue;
		snprintf(text, sizeof text, "loads.%d.harmonic is %d: the plan foresees resonances of loads of "
		         "the frequency Omega only, not where %d Omega meets a mode; hawser frf follows them",
		         i, scene->piece[i].harmonic, scene->piece[i].harmonic);
		cli_warn(text);
		return;
	}
}

static enum hawser_status make(struct cli_plan_result *result, const struct settings *settings,
                               struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	enum hawser_status status;
	double from, to;

	status = cli_range(&from, &to, settings->from, settings->to, "plan", model, report);
	if (!status)
		status = hawser_plan_make(&result->plan, &model->statics, &model->scene, result->choice,
		                          result->choices, from, to, report);
	if (!status)
		warn_harmonics(&model->scene);
	if (settings->common.reproducible)
		cli_plan_forget_times(&result->plan);
	return status;
}

/* Print a text if no file is requested. */
static enum hawser_status write_result(const struct cli_plan_result *result,
                                       struct hawser_report *report)
{
	if (result->common->json || result->common->tsv)
		return cli_show(result->common, &cli_plan_showing, result, report);
	cli_plan_print(stdout, result);
	return HAWSER_OK;
}

/* For a beam there is no choice of models: only its scaled form is printed. */
static enum hawser_status plan_beam(int *done, const struct cli_common *common,
                                    struct hawser_report *report)
{
	struct hawser_scene scene;
	struct hawser_beam beam;
	enum hawser_status status;

	*done = 0;
	if (common->json || common->tsv)
		return HAWSER_OK;
	status = cli_read_scene(&scene, common, NULL);
	if (status)
		return HAWSER_OK; /* the error is found again and reported below */
	if (scene.beam.form) {
		*done = 1;
		cli_warn_doubts(&scene);
		status = hawser_beam_scene(&beam, &scene, report);
		if (!status)
			cli_beam_print_scales(stdout, &scene, &beam);
	} else {
		status = HAWSER_OK;
	}
	hawser_scene_clear(&scene);
	return status;
}

enum hawser_status cli_plan_of_net(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_plan_net net = settings->net;
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	net.limit = settings->limit;
	return status ? status : cli_plan_net(&settings->common, &net, report);
}

enum hawser_status cli_plan_of_model(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;

	return cli_plan_model(&settings->common, settings->from, settings->to, report);
}

enum hawser_status cli_plan_of_span(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_model model = {0};
	struct cli_plan_result result = {.common = &settings->common, .model = &model};
	int done = 0;
	enum hawser_status status = choose(&result, settings, report);

	if (!status)
		status = plan_beam(&done, &settings->common, report);
	if (status || done)
		return status;
	status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = cli_model_load(&model, &settings->common, 0, report);
	if (!status)
		status = make(&result, settings, report);
	if (!status)
		status = write_result(&result, report);
	hawser_plan_clear(&result.plan);
	cli_model_clear(&model);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;

	return cli_part(&cli_plan, &settings->common)->run(settings, report);
}

const struct cli_command cli_plan = {
	"plan", "SCENE", "What will be modelled, what not and why; cost and error, estimated", notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_plan_listing,
	.part = CLI_PART(plan),
};

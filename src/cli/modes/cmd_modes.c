/* cli/modes/cmd_modes.c - hawser modes: natural frequencies and mode shapes about the static profile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/frame/mesh_net.h"
#include "cli/modes/modes_result.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *method, *view, *over, *vtk, *model;
	int n, basis, points, shapes, list, damped, log, elements;
	struct cli_ropeway_choice ropeway;
};
enum { POINTS = 201, /* of a shape: half a percent of the span apart */
       DAMPED = 6 }; /* damped modes of a net, as many as its models have */
static const struct settings defaults = {.points = POINTS};

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", CLI_INTEGER(n)},
	{"method", 0, "NAME", "method (spectral)", CLI_TEXT_FOR(method, CLI_SPAN),
	 .excludes = "over, damped, model=fe"},
	{"over", 0, "KEY=VALUES", "damped modes, or modes over sheaves, over a key: A:B:N, A:B or [A, B]",
	 CLI_TEXT_FOR(over, CLI_SPAN | CLI_NET | CLI_ROPEWAY | CLI_OBSTACLES), .excludes = "model=fe"},
	{"log", 0, "", "these values at equal ratios",
	 CLI_FLAG_FOR(log, CLI_SPAN | CLI_NET | CLI_ROPEWAY | CLI_OBSTACLES), .needs = "over"},
	{"shapes", 0, "", "write the shapes and slopes to the table, and to JSON",
	 CLI_FLAG_FOR(shapes, CLI_SPAN | CLI_NET | CLI_ROPEWAY | CLI_OBSTACLES),
	 .excludes = "over, damped"},
	{"damped", 0, "", "damped modes: dampers and damping of the scene",
	 CLI_FLAG_FOR(damped, CLI_SPAN | CLI_NET), .excludes = "model=fe"},
	CLI_HEADING("Contents of results"),
	{"view", 0, "NAME", "contents of the picture: components, profile or waves (components)",
	 CLI_TEXT_FOR(view, CLI_SPAN), .words = "components|profile|waves"},
	{"points", 0, "N", "number of points of a shape (201)",
	 CLI_COUNT_FOR(points, CLI_SPAN | CLI_ROPEWAY | CLI_OBSTACLES), .needs = "shapes"},
	{"vtk", 0, "FILE", "nets: write all shapes to FILE.vtk, for programs such as ParaView",
	 CLI_TEXT_FOR(vtk, CLI_NET)},
	{"list-methods", 0, "", "list the methods and exit", CLI_FLAG(list)},
	CLI_HEADING("Discretisation"),
	{"model", 0, "NAME", "cable, or fe: a mesh of cable elements (cable)",
	 CLI_TEXT_FOR(model, CLI_SPAN), .words = "cable|fe"},
	{"elements", 0, "N", "elements of the mesh of --model fe (120)",
	 CLI_INTEGER_FOR(elements, CLI_SPAN), .needs = "model=fe"},
	{"basis", 0, "N", "functions per component (as many as the tolerance requires)",
	 CLI_INTEGER_FOR(basis, CLI_SPAN), .excludes = "over, damped, model=fe"},
	CLI_HEADING("Sheaves, obstacles and ropeways"),
	{"contact", 0, "HOW", "on sheaves and obstacles: slip, stick, roll or statics (contact.modes)",
	 CLI_TEXT_FOR(ropeway.contact, CLI_NET | CLI_ROPEWAY | CLI_OBSTACLES)},
	{"case", 0, "NAME", "ropeways: the load case (full)",
	 CLI_TEXT_FOR(ropeway.load_case, CLI_ROPEWAY)},
	{"sliding", 0, "HOW", "ropeways: running, rest or reverse (the scene's ropeway.sliding)",
	 CLI_TEXT_FOR(ropeway.sliding, CLI_ROPEWAY)},
	CLI_NO_OPTION,
};

static void print_methods(const struct hawser_modes_method *(*row)(int index))
{
	for (int i = 0; row(i); i++)
		printf("%s\n  %s\n  %s\n", row(i)->name, row(i)->summary, row(i)->source);
}

static void list_methods(void)
{
	print_methods(hawser_modes_method);
	puts("\nwhere the scene travels:");
	print_methods(hawser_complex_modes_method);
}

static int fe(const struct settings *settings)
{
	return settings->model && strcmp(settings->model, "fe") == 0;
}

static enum hawser_status solve(struct cli_modes_result *result, const struct settings *settings,
                                struct hawser_report *report)
{
	struct hawser_modes_options choice;
	struct hawser_statics statics;
	enum hawser_status status = cli_scene_load(&result->scene, &settings->common, settings->n,
	                                           report);

	if (!status)
		status = hawser_statics_scene(&statics, &result->scene, report);
	if (status)
		return status;
	choice = cli_modes_options(&result->scene);
	choice.method = settings->method;
	if (settings->basis > 0)
		choice.basis = settings->basis;
	if (statics.motion.nu == 0.0 && strcmp(result->view, "waves") == 0 && settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "--view waves shows the modes of a cable that travels, and this one does "
		                    "not: give it a travel.speed, or choose components or profile");
	status = fe(settings)
		? hawser_net_span_modes(&result->modes, &result->scene, &statics, choice.n,
		                        settings->elements, report)
		: hawser_steady_modes_solve(&result->modes, &statics, &choice, report);
	return status ? status : cli_modes_sample(result, report);
}

/* --damped and --over. */
static enum hawser_status run_damped(const struct settings *settings, int net,
                                     struct hawser_report *report)
{
	struct cli_damped_result result = {.common = &settings->common,
	                                   .range.logarithmic = settings->log};
	enum hawser_status status = HAWSER_OK;
	int n = settings->n > 0 ? settings->n : DAMPED;

	status = cli_outputs_check_scales(&settings->common, settings->log ? "x" : "", report);
	if (!status)
		status = net ? cli_mesh_open(&result.net, &settings->common, report)
		             : cli_scene_load(&result.scene, &settings->common, settings->n, report);
	if (!status)
		status = cli_damped_solve(&result, settings->over,
		                          net ? n : cli_modes_options(&result.scene).n, report);
	if (!status)
		status = cli_show(&settings->common, &cli_damped_showing, &result, report);
	cli_damped_free(&result);
	return status;
}

enum hawser_status cli_modes_of_span(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_modes_result result = {.common = &settings->common,
	                                  .points = settings->shapes ? settings->points : 0};
	enum hawser_status status;

	if (settings->damped || settings->over)
		return run_damped(settings, 0, report);
	result.view = settings->view ? settings->view : "components";
	status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = solve(&result, settings, report);
	if (!status)
		status = cli_show(&settings->common, &cli_modes_showing, &result, report);
	free(result.S);
	free(result.shape);
	hawser_modes_clear(&result.modes);
	hawser_scene_clear(&result.scene);
	return status;
}

enum hawser_status cli_modes_of_net(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	enum hawser_status status;

	if (settings->damped || settings->over)
		return run_damped(settings, 1, report);
	status = cli_outputs_check(&settings->common, report);
	return status ? status : cli_modes_net(&settings->common, settings->n, settings->shapes,
	                                       settings->vtk, settings->ropeway.contact, report);
}

/* --over of ropeways and of spans over obstacles. *done is 1 if it was given. */
static enum hawser_status run_track(int *done, const struct settings *settings, int obstacles,
                                    struct hawser_report *report)
{
	struct cli_track track = {.common = &settings->common, .command = "modes", .over = settings->over,
	                          .swept = CLI_SWEPT_KEY, .logarithmic = settings->log, .n = settings->n,
	                          .obstacles = obstacles, .choice = settings->ropeway};

	*done = settings->over != NULL;
	return settings->over ? cli_track_run(&track, report)
	                      : cli_outputs_check(&settings->common, report);
}

enum hawser_status cli_modes_of_ropeway(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	int done;
	enum hawser_status status = run_track(&done, settings, 0, report);

	return status || done ? status
		: cli_modes_ropeway(&settings->common, &settings->ropeway, settings->n,
		                    settings->shapes ? settings->points : 0, report);
}

enum hawser_status cli_modes_of_obstacles(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	int done;
	enum hawser_status status = run_track(&done, settings, 1, report);

	return status || done ? status
		: cli_modes_obstacles(&settings->common, settings->ropeway.contact, settings->n,
		                      settings->shapes ? settings->points : 0, report);
}

enum hawser_status cli_modes_of_model(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	return status ? status : cli_modes_model(&settings->common, settings->n, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;

	if (s->list) {
		list_methods();
		return HAWSER_OK;
	}
	if (!s->common.input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes needs a SCENE (hawser modes --help)");
	return cli_part(&cli_modes, &s->common)->run(s, report);
}

const struct cli_command cli_modes = {
	"modes", "SCENE", "Natural frequencies and mode shapes", NULL, options, &defaults,
	sizeof(struct settings), 0, run, cli_modes_listing,
	.part = CLI_PART(modes),
};

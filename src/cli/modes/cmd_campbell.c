/* cli/modes/cmd_campbell.c - hawser campbell: natural frequencies along a sweep of the travel speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/modes/modes_result.h"
#include "cli/frame/progress.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *unit, *method, *spacing;
	int points, n, harmonics;
	struct cli_ropeway_choice ropeway;
};
static const struct settings defaults = {.from = "0", .n = 10, .harmonics = 3};
enum { POINTS = 100 }; /* of spans, before refinement */

static const struct cli_option options[] = {
	{"from", 0, "SPEED", "first speed, in m/s or with a unit (0)", CLI_TEXT(from)},
	{"to", 0, "SPEED", "last speed (the end of the steady state)", CLI_TEXT(to)},
	{"points", 0, "N", "number of samples, before refinement (100)", CLI_COUNT(points)},
	{"modes", 'n', "N", "number of branches, the lowest at the first speed (10)", CLI_INTEGER(n)},
	{"method", 0, "NAME", "method for the modes (spectral)", CLI_TEXT_FOR(method, CLI_SPAN)},
	CLI_HEADING("Units and lines of excitation"),
	{"unit", 0, "UNIT", "of eigenvalues: rad/s or Hz (rad/s)", CLI_TEXT(unit),
	 .words = "rad/s|Hz"},
	{"spacing", 0, "LENGTH", "distance of carriers on the cable: draw the lines of their excitation",
	 CLI_TEXT(spacing)},
	{"harmonics", 0, "N", "number of these lines (3)", CLI_INTEGER(harmonics),
	 .needs = "spacing"},
	CLI_HEADING("Ropeways"),
	{"contact", 0, "HOW", "ropeways: slip or roll (the scene's contact.modes)",
	 CLI_TEXT_FOR(ropeway.contact, CLI_ROPEWAY)},
	{"case", 0, "NAME", "ropeways: the load case (full)", CLI_TEXT_FOR(ropeway.load_case, CLI_ROPEWAY)},
	CLI_NO_OPTION,
};

static enum hawser_status read_settings(struct hawser_campbell_options *choice,
                                        struct cli_campbell_result *result,
                                        const struct settings *settings,
                                        struct hawser_report *report)
{
	const char *method = settings->method ? settings->method : "spectral";
	enum hawser_status status = cli_choose_method("campbell", method, 1, report);

	result->hertz = settings->unit && strcmp(settings->unit, "Hz") == 0;
	if (!status)
		status = cli_quantity(&choice->from, settings->from, "m/s", CLI_NOT_NEGATIVE, "campbell",
		                      "from", report);
	if (!status)
		status = cli_quantity(&choice->to, settings->to, "m/s", CLI_ABOVE_ZERO, "campbell", "to",
		                      report);
	if (!status)
		status = cli_quantity(&result->spacing, settings->spacing, "m", CLI_ABOVE_ZERO, "campbell",
		                      "spacing", report);
	result->harmonics = settings->spacing ? settings->harmonics : 0;
	choice->points = settings->points ? settings->points : POINTS;
	choice->n = settings->n;
	choice->method = method;
	return status;
}

static enum hawser_status trace(struct cli_campbell_result *result,
                                struct hawser_campbell_options *choice,
                                struct hawser_report *report)
{
	enum hawser_status status = cli_scene_load(&result->scene, result->common, 0, report);
	struct cli_watch watch = {.progress = {.quiet = result->common->quiet}};
	struct hawser_modes_options modes;

	if (status)
		return status;
	choice->progress = (struct hawser_progress){cli_watch, &watch};
	modes = cli_modes_options(&result->scene);
	choice->basis = modes.basis;
	choice->tolerance = modes.tolerance;
	status = hawser_campbell_trace(&result->campbell, &result->scene, choice, report);
	choice->progress = (struct hawser_progress){NULL, NULL};
	cli_progress_end(&watch.progress);
	if (!status && result->harmonics > 0)
		status = hawser_campbell_resonances(&result->resonance, &result->resonances,
		                                    &result->campbell, result->spacing,
		                                    result->harmonics, report);
	return status;
}

static enum hawser_status run_span(const struct settings *settings, struct hawser_report *report)
{
	struct cli_campbell_result result = {.common = &settings->common};
	struct hawser_campbell_options choice = {0};
	enum hawser_status status = read_settings(&choice, &result, settings, report);

	if (!status)
		status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = trace(&result, &choice, report);
	if (!status)
		status = cli_show(&settings->common, &cli_campbell_showing, &result, report);
	cli_campbell_free(&result);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;
	struct cli_track track = {.common = &s->common, .command = "campbell", .swept = CLI_SWEPT_SPEED,
		.from = s->from, .to = s->to, .points = s->points, .n = s->n, .unit = s->unit,
		.spacing = s->spacing, .harmonics = s->harmonics, .choice = s->ropeway};

	return cli_kind(&s->common) == HAWSER_KIND_ROPEWAY ? cli_track_run(&track, report)
	                                                   : run_span(s, report);
}

const struct cli_command cli_campbell = {
	"campbell", "SCENE", "Natural frequencies along a sweep of the travel speed", NULL, options,
	&defaults, sizeof(struct settings), 1, run, cli_campbell_listing,
	.takes = CLI_TRAVELLING | CLI_ROPEWAY,
};

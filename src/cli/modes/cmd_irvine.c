/* cli/modes/cmd_irvine.c - hawser irvine: natural frequencies along a sweep of the tension, at
 * rest or at some speeds. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/modes/modes_result.h"
#include "cli/frame/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *sweep, *from, *to, *over, *unit, *method, *speeds;
	int points, n;
	struct cli_ropeway_choice ropeway;
};
static const struct settings defaults = {.n = 10};
enum { POINTS = 200 }; /* of spans, before refinement */

static const struct cli_option options[] = {
	{"sweep", 0, "QUANTITY", "swept quantity: H, T0, T1, length0 or sag (H)",
	 CLI_TEXT_FOR(sweep, CLI_SPAN)},
	{"from", 0, "VALUE", "first value, in N or m or with a unit (lambda = 0.1 pi)", CLI_TEXT(from)},
	{"to", 0, "VALUE", "last value (lambda = 10 pi)", CLI_TEXT(to)},
	{"points", 0, "N", "number of samples, before refinement (200)", CLI_COUNT(points)},
	{"modes", 'n', "N", "number of branches, the lowest at the first value (10)", CLI_INTEGER(n)},
	{"method", 0, "NAME", "method for the modes (spectral)", CLI_TEXT_FOR(method, CLI_SPAN)},
	CLI_HEADING("Contents of results"),
	{"over", 0, "AXIS", "horizontal axis of the picture: lambda or value (lambda)",
	 CLI_TEXT_FOR(over, CLI_SPAN), .words = "lambda|value"},
	{"unit", 0, "UNIT", "of frequencies: normalised, rad/s, Hz, or s for periods (normalised)",
	 CLI_TEXT(unit)},
	{"speeds", 0, "LIST", "a sweep and a panel for each of these travel speeds: \"0, 5 m/s\"",
	 CLI_TEXT_FOR(speeds, CLI_SPAN)},
	CLI_HEADING("Ropeways"),
	{"contact", 0, "HOW", "ropeways: slip, stick or roll (the scene's contact.modes)",
	 CLI_TEXT_FOR(ropeway.contact, CLI_ROPEWAY)},
	{"case", 0, "NAME", "ropeways: the load case (full)", CLI_TEXT_FOR(ropeway.load_case, CLI_ROPEWAY)},
	{"sliding", 0, "HOW", "ropeways: running, rest or reverse (the scene's ropeway.sliding)",
	 CLI_TEXT_FOR(ropeway.sliding, CLI_ROPEWAY)},
	CLI_NO_OPTION,
};

static enum hawser_status choose_sweep(enum hawser_given *sweep, const char *text,
                                       struct hawser_report *report)
{
	const char *words[HAWSER_GIVEN_SAG];
	enum hawser_status status;
	int i;

	for (i = 0; i < HAWSER_GIVEN_SAG; i++)
		words[i] = hawser_given_name((enum hawser_given)(i + 1));
	status = cli_choose(&i, "irvine", "sweep", text, words, HAWSER_GIVEN_SAG, report);
	*sweep = (enum hawser_given)(i + 1);
	return status;
}

static enum hawser_status read_settings(struct hawser_irvine_options *choice,
                                        struct cli_irvine_result *result,
                                        const struct settings *settings,
                                        struct hawser_report *report)
{
	int unit = 0;
	enum hawser_status status = choose_sweep(&choice->sweep, settings->sweep ? settings->sweep : "H",
	                                         report);

	result->over_value = settings->over && strcmp(settings->over, "value") == 0;
	if (!status && settings->unit)
		status = cli_choose(&unit, "irvine", "unit", settings->unit, cli_irvine_units,
		                    CLI_IRVINE_UNITS, report);
	if (!status)
		status = cli_quantity(&choice->from, settings->from, cli_irvine_si(choice->sweep),
		                      CLI_ABOVE_ZERO, "irvine", "from", report);
	if (!status)
		status = cli_quantity(&choice->to, settings->to, cli_irvine_si(choice->sweep),
		                      CLI_ABOVE_ZERO, "irvine", "to", report);
	result->unit = (enum cli_irvine_unit)unit;
	choice->points = settings->points ? settings->points : POINTS;
	choice->n = settings->n;
	choice->method = settings->method ? settings->method : "spectral";
	return status;
}

/* Speeds of a list into speed[CLI_IRVINE_SPEEDS]. */
static enum hawser_status read_speeds(double *speed, int *count, const char *list,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	char one[64];

	for (*count = 0; !status; list++) {
		size_t length;

		if (*count == CLI_IRVINE_SPEEDS)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
			                    "--speeds: more than %d speeds; leave some out",
			                    CLI_IRVINE_SPEEDS);
		list += strspn(list, " ");
		length = strcspn(list, ",");
		snprintf(one, sizeof one, "%.*s", (int)length, list);
		status = cli_quantity(speed + (*count)++, one, "m/s", CLI_NOT_NEGATIVE, "irvine", "speeds",
		                      report);
		list += length;
		if (!*list)
			break;
	}
	return status;
}

/* The requested speeds; by default that of the scene, 0 at rest. */
static enum hawser_status speeds_of(double *speed, struct cli_irvine_result *result,
                                    const char *list, struct hawser_report *report)
{
	const struct hawser_scene *scene = &result->scene;
	enum hawser_status status;

	speed[0] = scene->travel.present ? scene->travel.speed : 0.0;
	result->sweeps = 1;
	status = list ? read_speeds(speed, &result->sweeps, list, report) : HAWSER_OK;
	result->moving = list || (scene->travel.present &&
	                          (scene->travel.speed != 0.0 || scene->travel.fluctuation != 0.0));
	return status;
}

/* A cable that masses in a wind, or forces, turn out of one plane has no single H to sweep; springs of
 * supports along x, y, z are not those along the axes of a turned plane, in which the sweep is. */
static enum hawser_status refuse_space(const struct hawser_scene *scene,
                                       const struct hawser_equivalent *equal,
                                       struct hawser_report *report)
{
	struct hawser_held held[2];

	for (int i = 0; i < scene->attachments; i++) {
		const struct hawser_attachment *a = &scene->attach[i];
		const double *force = a->force;
		int turned = equal->turned && (force[0] != 0.0 || force[1] != 0.0 || force[2] != 0.0);

		if (turned || force[0] != 0.0 || force[2] != 0.0 || force[1] > a->mass*scene->g)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
			                    "attach[%d].force: a cable that a force turns out of one plane, or "
			                    "pulls along the span or upwards, has a horizontal tension that is "
			                    "not the same everywhere, so that there is no sweep of it; call "
			                    "hawser modes for single tensions (T0, T1 or length0), or give a "
			                    "force downwards, without load.static.per_length", i);
		if (equal->turned && a->mass > 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
			                    "attach[%d].mass with load.static.per_length: such a cable hangs in "
			                    "space and its horizontal tension is not the same everywhere, so "
			                    "that there is no sweep of it; set load.static.per_length=[0,0,0], or "
			                    "call hawser modes for single tensions", i);
	}
	if (equal->turned && hawser_statics_held(held, scene))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "support.A.stiffness and support.B.stiffness with load.static.per_length: "
		                    "springs join the planes of a cable that the load turns, of which there is "
		                    "no sweep; set load.static.per_length=[0,0,0], or call hawser modes for "
		                    "single tensions");
	return HAWSER_OK;
}

static enum hawser_status trace(struct cli_irvine_result *result,
                                struct hawser_irvine_options *choice,
                                const struct settings *settings, struct hawser_report *report)
{
	enum hawser_status status = cli_scene_load(&result->scene, result->common, 0, report);
	const struct hawser_scene *scene = &result->scene;
	struct hawser_equivalent equal = {.turned = 0};
	struct hawser_modes_options modes;
	double speed[CLI_IRVINE_SPEEDS] = {0.0};
	struct hawser_held held[2];
	int k;

	if (!status)
		status = hawser_statics_equivalent(&equal, scene, report);
	if (!status)
		status = refuse_space(scene, &equal, report);
	if (!status)
		status = speeds_of(speed, result, settings->speeds, report);
	if (!status)
		status = cli_choose_method("irvine", choice->method, result->moving, report);
	if (status)
		return status;
	modes = cli_modes_options(scene);
	choice->basis = modes.basis;
	choice->tolerance = modes.tolerance;
	choice->attach = scene->attach;
	choice->attachments = scene->attachments;
	choice->gravity = -equal.gravity[1];
	if (hawser_statics_scene(&result->own, scene, NULL))
		result->own.H = 0.0;
	choice->contained = result->own.H;
	choice->held = hawser_statics_held(held, scene) ? held : NULL;
	if (scene->cable.EI > 0.0)
		choice->bending = (struct hawser_bending){scene->cable.EI, {scene->ends[0], scene->ends[1]}};
	for (k = 0; k < result->sweeps && !status; k++) {
		choice->speed = speed[k];
		choice->fluctuation = scene->travel.fluctuation;
		status = hawser_irvine_trace(&result->sweep[k].irvine, &equal.span, choice, report);
	}
	choice->held = NULL; /* of this function */
	return status;
}

static enum hawser_status run_span(const struct settings *settings, struct hawser_report *report)
{
	struct cli_irvine_result result = {.common = &settings->common};
	struct hawser_irvine_options choice = {0};
	enum hawser_status status = read_settings(&choice, &result, settings, report);

	if (!status)
		status = cli_outputs_check_scales(&settings->common, !result.over_value ||
		                                  choice.sweep != HAWSER_GIVEN_LENGTH0 ? "x" : "", report);
	if (!status)
		status = trace(&result, &choice, settings, report);
	if (!status)
		status = cli_irvine_overlay(&result, report);
	if (!status)
		status = cli_show(&settings->common, &cli_irvine_showing, &result, report);
	cli_irvine_free(&result);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;
	struct cli_track track = {.common = &s->common, .command = "irvine", .swept = CLI_SWEPT_TENSION,
		.from = s->from, .to = s->to, .points = s->points, .n = s->n, .unit = s->unit,
		.choice = s->ropeway};

	return cli_kind(&s->common) == HAWSER_KIND_ROPEWAY ? cli_track_run(&track, report)
	                                                   : run_span(s, report);
}

const struct cli_command cli_irvine = {
	"irvine", "SCENE", "Natural frequencies along a sweep of the tension", NULL, options, &defaults,
	sizeof(struct settings), 1, run, cli_irvine_listing,
	.takes = CLI_CABLE | CLI_TRAVELLING | CLI_ROPEWAY,
};

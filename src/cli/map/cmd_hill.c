/* cli/map/cmd_hill.c - hawser hill: stability under parametric excitation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/map/hill_result.h"
#include "cli/model/exact.h"
#include "cli/frame/progress.h"
#include "cli/map/tongues.h"
#include "cli/frame/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *x, *y, *omega, *start;
	double step;
	int n, lines, samples, mathieu, orbit, rest;
};
static const struct settings defaults = {.lines = 9, .samples = 240, .step = 0.01};

static const struct cli_option options[] = {
	CLI_TEXT_OPTION(x, "KEY=FROM:TO", "horizontal axis: a key of the scene, or Omega"),
	CLI_TEXT_OPTION(y, "KEY=FROM:TO", "vertical axis"),
	{"Omega", 0, "FREQUENCY", "frequency of the excitation, if it is no axis", CLI_TEXT(omega)},
	CLI_MODES_OPTION,
	CLI_HEADING("About which motion"),
	{"orbit", 0, "", "multipliers about the periodic response, also where nothing moves the model",
	 CLI_FLAG(orbit), .excludes = "rest, mathieu"},
	{"rest", 0, "", "multipliers about rest, also where a load moves the model", CLI_FLAG(rest),
	 .excludes = "mathieu"},
	CLI_TEXT_OPTION(start, "FILE", "state from which that response is computed"),
	CLI_HEADING("Mathieu's equation"),
	{"mathieu", 0, "", "boundaries of Mathieu's equation; no SCENE", CLI_FLAG(mathieu)},
	CLI_HEADING("Search"),
	{"lines", 0, "N", "search lines along each axis (9)", CLI_INTEGER(lines),
	 .needs = "x, y, mathieu"},
	{"samples", 0, "N", "points on each search line (240)", CLI_COUNT(samples),
	 .needs = "x, y, mathieu"},
	{"step", 0, "NUMBER", "longest step of a boundary, as a part of the plane (0.01)",
	 CLI_POSITIVE(step), .needs = "x, y, mathieu"},
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_KEEP_OPTION,
	{"damping", 0, "C", "c of Mathieu's equation; ropeways: ratio of each mode (0)",
	 CLI_POSITIVE(common.lane.damping)},
	CLI_LANE_UNDAMPED_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"--x and --y: boundaries of stability over two parameters, followed as curves.",
	"--Omega alone: Floquet multipliers and exponents of the motion.",
	"Both are of the periodic response, or of rest where nothing moves the model, or with --rest.",
	"--mathieu: boundaries of x'' + 2 c x' + (delta + 2 epsilon cos 2t) x = 0 over delta and epsilon.",
	"KEY: a numeric key of the scene (man hawser-scene) or parameter of the model's file, Omega,",
	"factor.load or factor.damping.",
	NULL,
};

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	int plane = settings->x || settings->y || settings->mathieu;

	if (!settings->mathieu && !settings->common.input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "hill needs a SCENE|MODEL, or --mathieu (hawser hill --help)");
	if (settings->mathieu && settings->common.input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "--mathieu is an equation of its own: leave %s out",
		                    settings->common.input);
	if (settings->common.lane.damping > 0.0 && !settings->mathieu &&
	    cli_kind(&settings->common) != HAWSER_KIND_ROPEWAY)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "--damping is for --mathieu and ropeways: other scenes have a section "
		                    "damping");
	if (!plane && !settings->omega)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "give --Omega for multipliers, or --x and --y for boundaries");
	if (plane && settings->orbit)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "boundaries are those of the response that grows out of rest; others have "
		                    "folds and tori (hawser folds, hawser frf)");
	if (!plane && settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "--plot draws boundaries: give --x and --y");
	return cli_outputs_check(&settings->common, report);
}

/* --- boundaries --- */

/* What the chart lacks. */
static void warn(const struct hawser_hill_chart *chart)
{
	char text[CLI_WARNING_SIZE];
	int count = 0;

	for (int b = 0; b < chart->boundaries; b++)
		count += chart->boundary[b].limited;
	if (count > 0) {
		snprintf(text, sizeof text, "%d boundaries were not followed to their end, since they have the "
		         "largest number of points: a longer --step needs fewer", count);
		cli_warn(text);
	}
	if (chart->missed > 0) {
		snprintf(text, sizeof text, "at %ld points no response was found, and boundaries may be "
		         "missing there: %.300s", chart->missed, chart->why);
		cli_caution("no response in parts", text);
	}
	cli_tongues_warn(&chart->narrow);
}

/* The boundaries of the field; for Mathieu's equation (result->model is NULL) computed by tongues. */
static enum hawser_status trace(struct cli_hill_result *result,
                                const struct hawser_hill_field *field,
                                const struct settings *settings, struct hawser_report *report)
{
	struct hawser_hill_options choice = {.lines = 0};
	struct cli_watch watch = {.progress = {.quiet = settings->common.quiet}};
	enum hawser_status status;

	for (int k = 0; k < 2; k++) {
		choice.from[k] = result->axis[k].from;
		choice.to[k] = result->axis[k].to;
	}
	choice.lines = settings->lines;
	choice.samples = settings->samples;
	choice.step = settings->step;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	result->field = field;
	status = result->model
	         ? hawser_hill_trace(&result->chart, field, &choice, report)
	         : hawser_mathieu_trace(&result->chart, settings->common.lane.damping, &choice, report);
	cli_progress_end(&watch.progress);
	if (!status)
		warn(&result->chart);
	return status;
}

/* delta and epsilon are plain numbers. */
static enum hawser_status plain_axis(struct cli_map_axis *axis, const char *option,
                                     const char *name,
                                     const char *text, struct hawser_report *report)
{
	size_t length = strlen(name);
	char *end;

	axis->key = name;
	axis->unit = "";
	if (!text)
		return HAWSER_OK;
	if (strncmp(text, name, length) == 0 && text[length] == '=') {
		axis->from = strtod(text + length + 1, &end);
		axis->to = *end == ':' ? strtod(end + 1, &end) : NAN;
		if (!*end && isfinite(axis->to - axis->from) && axis->from < axis->to)
			return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
	                    "--%s %s: of Mathieu's equation write %s=FROM:TO, the smaller number "
	                    "first", option, text, name);
}

static enum hawser_status mathieu(struct cli_hill_result *result, const struct settings *settings,
                                  struct hawser_report *report)
{
	struct hawser_hill_field field = {.m = 0};
	enum hawser_status status;

	result->damping = settings->common.lane.damping;
	result->axis[0] = (struct cli_map_axis){.from = -1.0, .to = 10.0};
	result->axis[1] = (struct cli_map_axis){.from = 0.0, .to = 5.0};
	status = plain_axis(&result->axis[0], "x", "delta", settings->x, report);
	if (!status)
		status = plain_axis(&result->axis[1], "y", "epsilon", settings->y, report);
	if (!status)
		status = hawser_mathieu_open(&field, settings->common.lane.damping, report);
	if (!status)
		status = trace(result, &field, settings, report);
	if (!status)
		status = cli_show(result->common, &cli_hill_boundaries, result, report);
	hawser_mathieu_close(&field);
	return status;
}

static enum hawser_status boundaries(struct cli_hill_result *result, struct cli_model *model,
                                     const struct settings *settings, struct hawser_report *report)
{
	struct hawser_map_source source = {.scene = NULL, .rest = settings->rest};
	struct hawser_hill_field field = {.m = 0};
	enum hawser_status status = cli_map_axis(&result->axis[0], "x", settings->x, model, report);

	if (!status)
		status = cli_map_axis(&result->axis[1], "y", settings->y, model, report);
	if (!status && settings->omega)
		status = cli_map_frequency(&result->omega, settings->omega, "Omega", model, report);
	if (status)
		return status;
	source.scene = model->has_scene ? &model->scene : NULL;
	source.rom = model->has_scene ? NULL : &model->rom;
	source.file = model->has_scene ? NULL : &model->source;
	source.omega = result->omega;
	for (int k = 0; k < 2; k++) {
		source.key[k] = result->axis[k].key;
		source.from[k] = result->axis[k].from;
		source.to[k] = result->axis[k].to;
	}
	if (!settings->rest)
		status = cli_exact_plane(&(struct cli_plane){{source.key[0], source.key[1]},
		                         {source.from[0], source.from[1]}, {source.to[0], source.to[1]},
		                         source.omega, 0}, model, settings->n, result->common, report);
	if (!status)
		status = cli_judged_plane(&result->judged, &source, model, cli_judged_free(model, settings->n),
		                          report);
	if (!status)
		status = hawser_hill_cable_open(&field, &source, report);
	if (!status)
		status = trace(result, &field, settings, report);
	if (!status)
		status = cli_judged_chart(&result->judged, &source, &result->chart, report);
	if (!status) {
		cli_exact_range_warn(model);
		cli_judged_warn(&result->judged);
		status = cli_show(result->common, &cli_hill_boundaries, result, report);
	}
	hawser_hill_cable_close(&field);
	return status;
}

/* --- multipliers --- */

static enum hawser_status about_rest(struct cli_hill_result *result, double *log_modulus,
                                     double *argument, const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report)
{
	struct hawser_linear *linear = NULL;
	enum hawser_status status = hawser_linear_open(&linear, rom->n, report);

	if (!status) {
		hawser_linear_refine(linear, 2);
		status = hawser_linear_multipliers(linear, log_modulus, argument, &result->error, rom,
		                                   omega, report);
	}
	hawser_linear_free(linear);
	for (int i = 0; !status && i < 2*rom->n; i++) {
		result->outside += log_modulus[i] > result->error;
		result->undecided += fabs(log_modulus[i]) <= result->error;
	}
	return status;
}

static enum hawser_status about_orbit(struct cli_hill_result *result, double *log_modulus,
                                      double *argument, const struct cli_model *model, double omega,
                                      const char *state,
                                      struct hawser_report *report)
{
	struct hawser_frf_options choice = {.method = NULL};
	struct hawser_frf frf = {0};
	double *start = NULL;
	enum hawser_status status = state ? cli_state_open(&start, state, model, report) : HAWSER_OK;

	choice.from = omega;
	choice.to = 1.1*omega;
	choice.max_points = 1;
	choice.samples = HAWSER_NONE;
	choice.start = start;
	if (!status)
		status = hawser_frf_trace(&frf, &model->rom, &choice, report);
	for (int i = 0; !status && i < 2*model->rom.n; i++) {
		log_modulus[i] = frf.multiplier[2*i];
		argument[i] = frf.multiplier[2*i + 1];
	}
	if (!status) {
		result->error = frf.point[0].liouville;
		result->outside = frf.point[0].unstable;
		result->undecided = frf.point[0].undecided;
	}
	hawser_frf_clear(&frf);
	free(start);
	return status;
}

static enum hawser_status multipliers(struct cli_hill_result *result, struct cli_model *model,
                                      const struct settings *settings, struct hawser_report *report)
{
	int m, orbit = settings->orbit || settings->start ||
	               (!settings->rest && hawser_rom_loaded(&model->rom));
	double *numbers = NULL, omega;
	enum hawser_status status = cli_frequency(&omega, settings->omega, "Omega", model, report);

	if (!status)
		status = cli_judged_choose(&result->judged, model, orbit && !settings->start &&
		                           cli_judged_free(model, settings->n),
		                           omega*cli_per_omega(model), report);
	if (!status)
		cli_judged_warn(&result->judged);
	m = 2*model->rom.n;
	if (!status && !(numbers = malloc(2*(size_t)m*sizeof *numbers)))
		status = hawser__no_memory(report, "hill");
	if (!status && orbit)
		status = about_orbit(result, numbers, numbers + m, model, omega, settings->start, report);
	else if (!status)
		status = about_rest(result, numbers, numbers + m, &model->rom, omega, report);
	if (!status) {
		result->m = m;
		result->orbit = orbit;
		result->log_modulus = numbers;
		result->argument = numbers + m;
		result->omega = omega*cli_per_omega(model);
		status = cli_show(result->common, &cli_hill_multipliers, result, report);
	}
	free(numbers);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_model model = {0};
	struct cli_hill_result result = {.common = &settings->common};
	enum hawser_status status = check(settings, report);
	int plane = settings->x || settings->y;

	if (status || settings->mathieu) {
		status = status ? status : mathieu(&result, settings, report);
		goto done;
	}
	result.model = &model;
	status = plane ? cli_model_or_scene(&model, &settings->common, settings->n, report)
	         : cli_model_load(&model, &settings->common, settings->n, report);
	if (!status && model.has_scene && model.scene.beam.form)
		status = hawser__fail(report, HAWSER_ERR_SCENE, "hill",
		                      "%s is a scene of a beam: hawser beam tells its stability",
		                      settings->common.input);
	if (!status && plane)
		status = boundaries(&result, &model, settings, report);
	else if (!status)
		status = multipliers(&result, &model, settings, report);
done:
	hawser_hill_clear(&result.chart);
	for (int k = 0; k < 2; k++)
		free(result.axis[k].copy);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_hill = {
	"hill", "SCENE|MODEL",
	"Stability under parametric excitation: multipliers, boundaries", notes,
	        options,
	&defaults, sizeof(struct settings), 0, run, cli_hill_listing,
	.takes = CLI_MODELS,
};

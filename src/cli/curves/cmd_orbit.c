/* cli/curves/cmd_orbit.c - hawser orbit: the motion at a label of a frequency response.
 *
 * The state of the label is integrated over two periods of the motion, with tolerances that are far
 * below those of the response: that it closes is a certificate by another method.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/branches.h>
#include <hawser/normal_form.h>

#include "cli/motion/integrate_result.h"
#include "cli/model/key_sweep.h"
#include "cli/model/label.h"
#include "cli/model/made.h"
#include "cli/frame/progress.h"
#include "core/hold.h"
#include "core/report.h"
#include "output/drawing/animate.h"

enum { ROWS = 256,      /* of a period of the motion; chosen */
       HARMONICS = 16 };
#define RTOL 1e-12 /* of the integration; far below the tolerance of a response */
#define ATOL 1e-14 /* scaled; chosen */

struct settings {
	struct cli_common common;
	const char *label, *animate;
	int n, frames;
};
static const struct settings defaults = {.frames = HAWSER__ANIMATE_FRAMES};

static const struct cli_option options[] = {
	{"from-label", 0, "FILE#LABEL", "label of a JSON result of frf", CLI_TEXT(label)},
	CLI_MODES_OPTION,
	CLI_LIBRARY_OPTION,
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_HEADING("Pictures and files"),
	{"animate", 0, "FILE.gif", "nets, ropeways: write an animation of a period",
	 CLI_TEXT_FOR(animate, CLI_NET | CLI_ROPEWAY)},
	{"frames", 0, "N", "of the animation, at most (100)",
	 CLI_COUNT_FOR(frames, CLI_NET | CLI_ROPEWAY), .needs = "animate"},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Writes the periodic motion at a label of a frequency response over two of its periods:",
	"displacements, tension, Fourier coefficients, Floquet multipliers, and how well it closes.",
	"FILE#LABEL: a label of a JSON result of frf, which names its scene or model.",
	NULL,
};

/* The multipliers, of a response of one point; none where no curve begins, as at branch points. */
static enum hawser_status multipliers(struct hawser_frf *frf, const struct cli_label *label,
                                      const struct cli_model *model)
{
	const struct hawser_rom *rom = &model->rom;
	struct hawser_frf_options choice = {.method = "shooting", .from = 0.9*label->omega,
		.to = 1.1*label->omega, .begin = label->omega, .start = label->state, .max_points = 1,
		.skip_events = 1, .samples = HAWSER_NONE};
	enum hawser_status status;

	status = label->period > 1 ? hawser_branch_trace(frf, rom, label->period, &choice, NULL)
	                           : hawser_frf_trace(frf, rom, &choice, NULL);
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

/* The normal form, of a label of an event that has one. */
static enum hawser_status normal_form(struct cli_orbit *orbit, const struct cli_label *label,
                                      const struct cli_model *model)
{
	static const char *const verdict[] = {"subcritical", "quadratic", "supercritical"};
	const struct hawser_rom *rom = &model->rom;
	struct hawser_normal_form form;
	struct hawser_report why = {0};
	enum hawser_status status;
	int kind = HAWSER_FOLD;

	while (kind <= HAWSER_TORUS && strcmp(label->kind, hawser_event_name(kind)) != 0)
		kind++;
	if (kind > HAWSER_TORUS)
		return HAWSER_OK;
	status = hawser_normal_form(&form, rom, label->state, label->omega, label->period, kind, &why);
	if (status)
		memcpy(orbit->formless, why.message, sizeof orbit->formless - 1);
	if (status)
		return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
	orbit->form = form.c/pow(rom->length, kind == HAWSER_FOLD ? 1.0 : 2.0);
	orbit->form_error = orbit->form*form.error/form.c;
	orbit->verdict = verdict[form.decided + 1];
	return HAWSER_OK;
}

/* Over the first period; the state at its end is in row ROWS. */
static void look(struct cli_orbit *orbit, const struct cli_integrate_result *result)
{
	int n = result->model->rom.n;
	const double *x = result->run.state, *end = x + (size_t)ROWS*2*(size_t)n;
	double off = 0.0, size = 0.0;

	for (int i = 0; i < 2*n; i++) {
		double weight = i < n ? 1.0 : 1.0/result->omega;

		off += pow(weight*(end[i] - x[i]), 2.0);
		size += pow(weight*x[i], 2.0);
	}
	orbit->closure = sqrt(off)/fmax(sqrt(size), 1e-300);
	for (int k = 0; k < HARMONICS; k++) {
		orbit->k[k] = k;
		for (int j = 0; j < n; j++) {
			double c = 0.0, s = 0.0;

			for (int r = 0; r < ROWS; r++) {
				c += x[(size_t)r*2*(size_t)n + (size_t)j]*cos(2.0*M_PI*k*r/ROWS);
				s += x[(size_t)r*2*(size_t)n + (size_t)j]*sin(2.0*M_PI*k*r/ROWS);
			}
			orbit->amplitude[(size_t)k*(size_t)n + (size_t)j] = (k ? 2.0 : 1.0)*hypot(c, s)/ROWS;
		}
	}
}

/* The spectrum of the picture: the Fourier coefficients, without a window. */
static void lines(struct cli_integrate_result *result)
{
	result->bins = HARMONICS;
	for (int k = 0; k < HARMONICS; k++) {
		result->frequency[k] = k*cli_per_omega(result->model)/result->period;
		for (int i = 0; i < result->signals; i++) {
			const double *value = result->value + (size_t)i*(size_t)result->run.rows;
			double c = 0.0, s = 0.0;

			for (int r = 0; r < ROWS; r++) {
				c += value[r]*cos(2.0*M_PI*k*r/ROWS);
				s += value[r]*sin(2.0*M_PI*k*r/ROWS);
			}
			result->amplitude[i*HARMONICS + k] = (k ? 2.0 : 1.0)*hypot(c, s)/ROWS;
		}
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_integrate_result *result = of;
	const struct cli_orbit *orbit = result->orbit;

	cli_integrate_comments(table, of);
	if (hawser_rom_autonomous(&result->model->rom))
		hawser__table_comment(table, "label %d%s%s: a limit cycle", orbit->label,
		                      *orbit->kind ? ", " : "", orbit->kind);
	else
		hawser__table_comment(table, "label %d%s%s: a motion of %d period%s of the load",
		                      orbit->label, *orbit->kind ? ", " : "", orbit->kind, orbit->period,
		                      orbit->period > 1 ? "s" : "");
	hawser__table_comment(table, "closure after one period of the motion: %.1e of its size",
	                      orbit->closure);
	if (*orbit->verdict)
		hawser__table_comment(table, "normal form: %s, coefficient %.6g (error %.1e)%s", orbit->verdict,
		                      orbit->form, orbit->form_error,
		                      cli_unit(result->model, *orbit->verdict == 'q' ? " 1/m" : " 1/m^2"));
	else if (*orbit->formless)
		hawser__table_comment(table, "%s", orbit->formless);
	for (int i = 0; orbit->multiplier && i < 2*result->model->rom.n; i++)
		hawser__table_comment(table, "multiplier %d: modulus %.9g, argument %.9g", i + 1,
		                      exp(orbit->multiplier[2*i]), orbit->multiplier[2*i + 1]);
}

static enum hawser_status solve(struct cli_integrate_result *result, struct cli_orbit *orbit,
                                const struct cli_label *label, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = result->common->quiet}, "orbit"};
	struct hawser_integrate_options choice = {.omega = label->omega, .initial = label->state,
		.rtol = RTOL, .atol = ATOL, .progress = {cli_watch, &watch}};
	enum hawser_status status;

	result->period = 2.0*M_PI*label->period/label->omega;
	choice.until = 2.0*result->period;
	choice.every = result->period/ROWS;
	result->omega = label->omega;
	result->forcing = choice;
	result->every = choice.every;
	status = hawser_integrate(&result->run, &result->model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	if (!status && result->run.rows <= ROWS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                    "interrupted before the end of a period: nothing is written");
	if (!status)
		look(orbit, result);
	if (!status)
		status = cli_integrate_fill(result, report);
	if (!status && result->bins > HARMONICS)
		lines(result);
	return status;
}

/* A period at so many equal phases that a part of the rows has; of a label alone, only now is known of
 * what. */
static enum hawser_status animate(const struct cli_integrate_result *result,
                                  const struct settings *settings, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	size_t n = (size_t)model->rom.n;
	int stride = 1;
	double *u = hawser__numbers(ROWS, n);
	enum hawser_status status;

	while (ROWS/stride > settings->frames)
		stride *= 2;
	for (size_t i = 0; u && i < (size_t)(ROWS/stride); i++)
		memcpy(u + i*n, result->run.state + 2*i*(size_t)stride*n, n*sizeof *u);
	status = !u ? hawser__no_memory(report, "orbit")
	         : model->made->by->animate(settings->animate, model, &(struct hawser_net_rom_motion){
			.u = u, .rows = ROWS/stride, .periods = result->orbit->period,
			.duration = result->period/cli_per_omega(model)}, report);
	free(u);
	return status;
}

/* FILE#LABEL in place of the scene: the result, *from, names the scene or model, scene [size], and the
 * value of its --over, set [CLI_KEY_SWEEP_SET]. */
static enum hawser_status of_result(struct settings *settings, char *scene, size_t size, char *set,
                                    json_t **from, struct hawser_report *report)
{
	struct cli_common *common = &settings->common;
	int modes;
	enum hawser_status status;

	if (settings->label || common->library || !cli_label_split(scene, size, common->input))
		return HAWSER_OK;
	settings->label = common->input;
	status = cli_label_scene(scene, size, &modes, from, settings->label, report);
	common->input = scene;
	cli_made_as(common, settings->n, *from);
	if (common->sets < CLI_SETS && cli_label_value(set, CLI_KEY_SWEEP_SET, *from, settings->label))
		common->set[common->sets++] = set;
	if (settings->n == 0)
		settings->n = modes;
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	struct settings own = *(const struct settings *)context, *settings = &own;
	struct cli_model model = {0};
	struct cli_label label = {.state = NULL};
	struct hawser_frf frf = {0};
	struct cli_orbit orbit = {.harmonics = HARMONICS, .form = NAN, .form_error = NAN, .verdict = ""};
	struct cli_integrate_result result = {.common = &settings->common, .model = &model,
	                                      .orbit = &orbit};
	struct cli_showing showing = cli_integrate_showing;
	enum hawser_status status = cli_outputs_check(&settings->common, report);
	char scene[4096], set[CLI_KEY_SWEEP_SET];
	json_t *from = NULL;

	if (!status)
		status = hawser__animate_check(settings->animate, "orbit", report);
	if (!status)
		status = of_result(&own, scene, sizeof scene, set, &from, report);
	if (!status && !settings->label)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                      "which motion? write hawser orbit FILE#LABEL, with a label of a JSON "
		                      "result of hawser frf");
	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	if (!status)
		status = cli_label_exact(&model, settings->label, report);
	if (!status && settings->animate && !(model.made && model.made->by->animate))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                      "--animate is for nets and ropeways, and %s is none",
		                      cli_input_name(&settings->common));
	if (!status)
		status = cli_label_open(&label, "from-label", settings->label, NULL, &model,
		                        &settings->common, report);
	if (!status)
		status = cli_known(&model, label.omega, report);
	if (!status && (label.omega == 0.0 || strcmp(label.kind, "hopf") == 0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                      "%s is an equilibrium, which has no period: take a label of a limit "
		                      "cycle, on a branch (hawser frf --branches 1)", settings->label);
	orbit.k = calloc(HARMONICS, sizeof *orbit.k);
	orbit.amplitude = calloc(HARMONICS*((size_t)model.rom.n + 1), sizeof *orbit.amplitude);
	if (!status && (!orbit.k || !orbit.amplitude))
		status = hawser__no_memory(report, "orbit");
	if (!status)
		status = multipliers(&frf, &label, &model);
	if (!status)
		status = normal_form(&orbit, &label, &model);
	orbit.label = label.number;
	orbit.period = label.period;
	orbit.kind = label.kind;
	orbit.multiplier = frf.points > 0 ? frf.multiplier : NULL;
	if (!status)
		status = solve(&result, &orbit, &label, report);
	showing.comments = comments;
	if (!status) {
		cli_integrate_warn(&model, label.omega, &result);
		status = cli_show(&settings->common, &showing, &result, report);
	}
	if (!status && settings->animate)
		status = animate(&result, settings, report);
	free(orbit.k);
	free(orbit.amplitude);
	hawser_frf_clear(&frf);
	cli_integrate_free(&result);
	cli_label_clear(&label);
	cli_model_clear(&model);
	json_decref(from);
	return status;
}

const struct cli_command cli_orbit = {
	"orbit", "SCENE|MODEL|FILE#LABEL", "The periodic motion at a label of a frequency response", notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_integrate_listing,
	.takes = CLI_FORCED | CLI_MODELS,
};

/* cli/curves/cmd_frf.c - hawser frf: the certified frequency response.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/backbone/backbone.h"
#include "cli/model/exact.h"
#include "cli/curves/frf_beside.h"
#include "cli/curves/frf_cover.h"
#include "cli/curves/frf_over.h"
#include "cli/curves/frf_sweep.h"
#include "cli/curves/frf_tori.h"
#include "cli/curves/frf_waves.h"
#include "cli/model/label.h"
#include "cli/model/made.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"

#define LOCATED 0.01 /* tolerance of peaks, as a part of the accuracy that was asked for */
#define OBSERVED 2 /* unstable multipliers: nobody observes motions with more, and models differ most
                    * in them, so that the error estimate of modes: auto does not fall; chosen */
enum { LISTED = 10 }; /* peaks on a terminal: they fit on it; chosen */

struct settings {
	struct cli_common common;
	const char *from, *to, *at, *sweep, *start, *resume, *scale, *method, *slack, *beside;
	const char *over, *omega, *label, *switched, *certificate;
	double tolerance, step;
	int n, points, segments, unstable, sweep_points, multipliers, partial, backbone, energy, tori;
	int peaks, nonlinear;
	int branches, period, label_every;
};
static const struct settings defaults = {
	.scale = "auto", .slack = "end", .certificate = "auto",
	.sweep_points = 200, .label_every = 10,
};

static const struct cli_option options[] = {
	CLI_RANGE_OPTIONS("frequency at which the curve starts (0.6w1)",
	                  "other end of the range (3.3w1; ropeways: end of the modes)"),
	CLI_MODES_OPTION,
	CLI_TEXT_OPTION(method, "NAME", "shooting, balance, multiple-scales or auto (auto)"),
	{"branches", 0, "DEPTH", "follow branches that begin at bifurcations too, and theirs, so deep",
	 CLI_INTEGER(branches)},
	CLI_TOLERANCE_OPTION("residual and integration error, relative to the orbit (1e-9)"),
	CLI_HEADING("Where the curve begins"),
	CLI_TEXT_OPTION(start, "FILE", "state to start from (the linear response)"),
	CLI_TEXT_OPTION(at, "FREQUENCY", "frequency of the first orbit, inside the range"),
	{"continue", 0, "FILE", "continue the curve whose JSON result this file is", CLI_TEXT(resume),
	 .excludes = "start, at"},
	{"from-label", 0, "FILE#LABEL", "begin at this label of a JSON result of frf", CLI_TEXT(label),
	 .excludes = "start, at, continue"},
	{"label-every", 0, "N", "label every Nth point too; 0: events alone (10)",
	 CLI_STORED(cli_store_every, label_every)},
	CLI_HEADING("Other motions"),
	{"switch", 0, "LABEL", "follow the branch at this label; FILE#LABEL: only that, of a JSON result",
	 CLI_TEXT(switched)},
	{"period", 0, "N", "motions of N periods of the load (1)", CLI_INTEGER(period)},
	{"tori", 0, "", "follow quasi-periodic motions from torus points too", CLI_FLAG(tori)},
	{"over", 0, "KEY=FROM:TO", "follow the motion in a parameter instead, at the frequency --Omega",
	 CLI_TEXT(over),
	 .excludes = "from, to, at, sweep, backbone, beside"},
	{"Omega", 0, "FREQUENCY", "frequency of the load with --over; of a limit cycle, about",
	 CLI_TEXT(omega),
	 .needs = "over"},
	CLI_TEXT_WITH(sweep, "WHICH", "add a slow sweep, integrated in time: up, down or both",
	              .words = "up|down|both"),
	{"sweep-points", 0, "N", "number of frequencies of a sweep (200)", CLI_COUNT(sweep_points),
	 .needs = "sweep"},
	{"backbone", 0, "J", "add the backbone of mode J: its free undamped motions",
	 CLI_INTEGER(backbone)},
	{"energy", 0, "", "draw the backbone's frequency over its energy instead", CLI_FLAG(energy),
	 .needs = "backbone"},
	CLI_HEADING("Model, steps and ends"),
	CLI_LIBRARY_OPTION,
	{"nonlinear", 0, "", "nets in regular waves: the response of a model to them, not the linear one",
	 CLI_FLAG_FOR(nonlinear, CLI_NET)},
	{"certificate", 0, "WHICH", "nets, spans: correct folds and peaks in the mesh: auto (if it takes "
	 "some seconds; spans: see the manual), yes or no (auto)",
	 CLI_TEXT_FOR(certificate, CLI_NET | CLI_CABLE),
	 .words = "auto|yes|no"},
	CLI_STEP_OPTION,
	CLI_POINTS_OPTION("end after this many points (20000); of waves, so many (200)"),
	{"segments", 0, "N", "shooting segments (as many as needed)", CLI_INTEGER(segments)},
	CLI_TEXT_WITH(slack, "WHAT",
	              "where the cable goes slack: end the curve or follow the model's on (end)",
	              .words = "end|follow"),
	{"unstable", 0, "N", "end a branch where more than N multipliers are unstable (2; no limit "
	 "of a curve that begins or is followed otherwise)", CLI_INTEGER(unstable)},
	{"partial", 0, "", "write what was computed also if the run fails", CLI_FLAG(partial)},
	CLI_HEADING("Contents of results"),
	{"peaks", 0, "", "table of the peaks in place of the points", CLI_FLAG(peaks)},
	{"multipliers", 0, "", "write the Floquet multipliers to JSON too", CLI_FLAG(multipliers)},
	CLI_TEXT_WITH(beside, "FILE", "draw the response of this JSON result too, pale and behind",
	              .needs = "plot, gp", .excludes = "energy"),
	CLI_TEXT_WITH(scale, "WHICH", "amplitude axes of the picture: auto, linear or log (auto)",
	              .words = "auto|linear|log"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Follows the forced periodic response from one end of a range of forcing frequencies to the",
	"other, with stability, located bifurcations and an error certificate at every point.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	NULL,
};

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (settings->switched)
		status = cli_switch_check(settings->switched, settings->label ? "from-label"
		                          : settings->start ? "start" : settings->at ? "at"
		                          : settings->resume ? "continue" : settings->period ? "period" : NULL,
		                          report);
	if (!status && settings->tori)
		status = cli_tori_check(settings->method, report);
	if (!status)
		status = cli_state_check("start", settings->start, &settings->common, report);
	if (!status)
		status = cli_state_check("continue", settings->resume, &settings->common, report);
	if (!status)
		status = cli_state_check("beside", settings->beside, &settings->common, report);
	return status ? status : cli_outputs_check_scales(&settings->common, settings->energy ? "x"
	                                                  : strcmp(settings->scale, "log") == 0 ? "y" : "",
	                                                  report);
}

/* The first orbit, if the user gives one; last->state owns its state. */
static enum hawser_status choose_start(struct hawser_frf_options *choice, struct cli_last *last,
                                       const struct settings *settings,
                                       const struct cli_model *model, struct hawser_report *report)
{
	const char *path = settings->start ? settings->start : settings->over ? NULL : settings->resume;
	enum hawser_status status = HAWSER_OK;

	if (settings->at)
		status = cli_frequency(&choice->begin, settings->at, "at", model, report);
	if (status || !path)
		return status;
	if (model->automatic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--%s %s: a state has as many coordinates as the model, and "
		                    "model.modes: auto makes several; give a number of modes",
		                    settings->start ? "start" : "continue", path);
	if (settings->start)
		status = cli_state_open(&last->state, path, model, report);
	else
		status = cli_last_open(last, path, "frf", model, &settings->common, report);
	choice->start = last->state;
	if (status || settings->start)
		return status;
	if (last->end == HAWSER_END_RANGE || last->end == HAWSER_END_RETURNED ||
	    last->end == HAWSER_END_AT_REST || last->end == HAWSER_END_CLOSED ||
	    last->end == HAWSER_END_MEETS ||
	    (last->end == HAWSER_END_SLACK && choice->end_at_slack))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--continue %s: that curve is complete (%s): begin another one", path,
		                    hawser_frf_end_name(last->end));
	choice->begin = last->omega;
	choice->direction = last->direction;
	return HAWSER_OK;
}

/* Locate the peaks, with shorter steps where necessary; without further steps if the curve is
 * incomplete. */
static enum hawser_status locate_peaks(struct hawser_landmark **peak, struct cli_frf_result *result,
                                       struct cli_progress *progress,
                                       const struct hawser_frf_options *as, int cut,
                                       struct hawser_report *report)
{
	const struct hawser_frf *frf = result->frf;
	struct cli_watch watch = {*progress, "frf: locating peaks"};
	struct hawser_frf_options choice = *as;
	double wanted = result->model->automatic ? LOCATED*result->model->accuracy.asked
	                : cli_fixed_tolerance(&result->error, result->model->exact.functions);
	enum hawser_status status;

	cut = cut || frf->end == HAWSER_END_MAX_POINTS || cli_interrupted();
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_peaks(peak, &result->peaks, frf, &result->model->rom, &choice,
	                      cut ? 0.0 : wanted, report);
	*progress = watch.progress;
	result->peak = *peak;
	result->located = !status;
	return status;
}

/* The motion of another result with which the curve begins: FILE#LABEL, or with --over FILE, of
 * which the last point goes on. NULL: none. */
static const char *given_label(const struct settings *settings)
{
	return settings->label ? settings->label : settings->over && settings->resume ? settings->resume
	       : cli_switch_elsewhere(settings->switched) ? settings->switched : NULL;
}

/* The curve, from the label if there is one. */
static enum hawser_status trace_curve(struct hawser_frf *frf, struct hawser_frf_options *choice,
                                      const struct cli_frf_result *result,
                                      const struct settings *settings, const struct cli_label *label,
                                      struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	const char *from = cli_switch_elsewhere(settings->switched) ? NULL : given_label(settings);
	double *along = from ? calloc(2*(size_t)rom->n, sizeof *along) : NULL;
	enum hawser_status status = HAWSER_OK;

	if (from && !along)
		return hawser__no_memory(report, "frf");
	if (from)
		status = cli_label_begin(choice, along, label, result->over, result->model, from,
		                         report);
	if (!status && cli_switch_elsewhere(settings->switched))
		status = cli_switch_trace(frf, result, label, choice, settings->switched, report);
	else if (!status && label->period > 1)
		status = hawser_branch_trace(frf, rom, label->period, choice, report);
	else if (!status)
		status = hawser_frf_trace(frf, rom, choice, report);
	if (!status && from)
		status = cli_label_kept(label, frf, from, report);
	choice->along = NULL;
	free(along);
	return status;
}

/* Whether the user says more about the curve or the method than its range. */
static int is_special(const struct settings *settings)
{
	return settings->start || settings->resume || settings->label || settings->switched ||
	       settings->period > 1 || settings->over || settings->method || settings->segments;
}

/* Further branches; unasked, no motions that nobody observes, no search with a model that is far
 * off, and none without end. */
static enum hawser_status cover_rest(struct cli_cover *cover, const struct hawser_frf_options *as,
                                     const struct settings *settings, struct cli_frf_result *result,
                                     struct cli_progress *progress, struct hawser_report *report)
{
	struct hawser_frf_options choice = *as;

	if (!hawser_cover_needed(result->frf, as))
		return HAWSER_OK;
	result->unsearched = cli_exact_failed(result->model, &result->error);
	if (result->unsearched)
		return HAWSER_OK;
	if (settings->unstable == 0)
		choice.most_unstable = result->observed = OBSERVED;
	if (settings->points == 0)
		choice.most_work = result->allowed;
	return cli_cover_trace(cover, result, &choice, progress, locate_peaks, report);
}

static enum hawser_status trace(struct hawser_frf *frf, struct hawser_landmark **peak,
                                struct cli_cover *cover, const struct cli_label *label,
                                struct cli_model *model,
                                const struct settings *settings,
                                struct cli_frf_result *result, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = settings->common.quiet}, "frf"};
	int automatic = model->automatic;
	struct hawser_frf_options choice = {.method = NULL};
	struct cli_last last = {.state = NULL};
	struct hawser_report second = {0};
	enum hawser_status status;

	if (settings->method && strcmp(settings->method, "auto") != 0)
		choice.method = settings->method;
	choice.from = result->over ? result->over->from : result->from;
	choice.to = result->over ? result->over->to : result->to;
	choice.family = result->over ? &result->over->family : NULL;
	choice.segments = settings->segments;
	choice.end_at_slack = strcmp(settings->slack, "end") == 0;
	choice.most_unstable = settings->unstable;
	if (!settings->unstable && !is_special(settings))
		choice.most_unstable = result->observed = OBSERVED;
	if (settings->step > 0.0 || !automatic)
		choice.step_max = settings->step > 0.0 ? settings->step : CLI_STEP;
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->points > 0)
		choice.max_points = settings->points;
	else if (!automatic && !model->rom.exact)
		choice.most_work = result->allowed;
	status = choose_start(&choice, &last, settings, model, report);
	if (settings->start && result->over && result->over->omega == 0.0)
		choice.omega = result->over->guess > 0.0 ? result->over->guess/cli_per_omega(model)
		                                         : HAWSER_NONE;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	if (!status && automatic) {
		status = cli_choice_trace(frf, model, &choice, report);
		choice = model->accuracy.traced; /* for peaks and further branches */
	}
	if (!status && !automatic)
		status = is_special(settings) || model->made
		         ? trace_curve(frf, &choice, result, settings, label, report)
		         : cli_exact_trace(frf, &choice, model, result, settings->step > 0.0, report);
	if (!status && model->made && settings->n == 0 && !settings->common.lane.keep &&
	    !is_special(settings))
		status = cli_made_response(frf, model, result, &choice, report);
	if (frf->points > 0 && cli_label_plain(frf, model) && !result->over) {
		enum hawser_status located = locate_peaks(peak, result, &watch.progress, &choice,
		                                          status != HAWSER_OK, status ? &second : report);

		status = status ? status : located;
	}
	if (!status && cli_label_plain(frf, model) && !result->over && !cli_interrupted() &&
	    !cli_switch_elsewhere(settings->switched))
		status = cover_rest(cover, &choice, settings, result, &watch.progress, report);
	if (!status && !cli_interrupted())
		status = cli_cover_switch(cover, result, &choice, settings->branches, settings->switched,
		                          &watch.progress, locate_peaks, report);
	cli_progress_end(&watch.progress);
	cli_last_clear(&last);
	return status;
}

/* Whether the rows go to a terminal. */
static int reads_along(const struct cli_common *common)
{
	return isatty(STDOUT_FILENO) && !common->json && !common->tsv && !common->plot;
}

static enum hawser_status write_result(struct cli_frf_result *result, struct cli_model *model,
                                       const struct settings *settings,
                                       struct hawser_report *report)
{
	struct cli_showing showing = cli_frf_showing;

	if (!settings->peaks && reads_along(result->common)) {
		int all = cli_frf_displacements(result);

		result->highest = all < LISTED ? all : LISTED;
	}
	if (settings->peaks || result->highest > 0)
		showing = cli_frf_show_peaks(result);

	if (settings->energy)
		showing.draw = cli_backbone_draw;
	result->direction = cli_frf_direction(result->frf);
	cli_label_all(result);
	cli_frf_warn(model, result);
	return model->starved ? hawser__no_memory(report, "frf")
	                      : cli_show(result->common, &showing, result, report);
}

/* With --over, the curve has the label's frequency, and its modes at the label are the label's. */
static enum hawser_status open_label(struct cli_label *label, struct cli_over *over,
                                     const struct settings *settings, const struct cli_model *model,
                                     struct hawser_report *report)
{
	const char *text = settings->over;
	const char *option = settings->label ? "from-label" : settings->resume ? "continue" : "switch";
	char key[128] = "";
	enum hawser_status status;

	if (text)
		snprintf(key, sizeof key, "%.*s", (int)strcspn(text, "="), text);
	status = cli_label_open(label, option, given_label(settings), text ? key : NULL, model,
	                        &settings->common, report);
	if (status || !text)
		return status;
	if (!hawser_rom_autonomous(&model->rom))
		over->omega = label->omega*cli_per_omega(model);
	if (strcmp(key, label->over) == 0)
		over->at = label->anchor;
	else if (model->has_scene && cli_over_needs_scene(key))
		return hawser_scene_get(&model->scene, &over->at, key, report);
	return HAWSER_OK;
}

/* Whether the motion at which the response begins was given. */
static int goes_on(const struct settings *settings)
{
	return settings->label || settings->start || settings->switched || settings->resume;
}

static enum hawser_status curves(const struct settings *settings, struct hawser_report *report)
{
	struct hawser_frf frf = {0};
	struct hawser_landmark *peak = NULL;
	struct cli_cover cover = {.other = NULL};
	struct cli_model model = {0};
	struct hawser_report second = {0};
	struct cli_sweep list[2] = {{0}};
	struct hawser_tori *tori = NULL;
	struct cli_backbone free_motions = {.omega = NULL};
	struct cli_beside beside = {.root = NULL};
	struct cli_overlay overlay[CLI_OVERLAYS];
	struct cli_over over = {.at = NAN};
	struct cli_label label = {.period = 1};
	struct cli_certificate certificate = {.how = settings->certificate};
	struct cli_frf_result result = {.common = &settings->common, .model = &model, .frf = &frf,
	                                .sweep = list, .multipliers = settings->multipliers,
	                                .scale = settings->scale, .overlay = overlay,
	                                .certificate = &certificate, .allowed = CLI_BEARABLE,
	                                .label_every = settings->label_every, .chosen = goes_on(settings)};
	enum hawser_status status = check(settings, report), written = HAWSER_OK;

	if (!status)
		status = cli_over_load(&model, &settings->common, settings->n, settings->over, report);
	if (!status)
		status = cli_label_exact(&model, settings->label ? settings->label
		                      : cli_switch_elsewhere(settings->switched) ? settings->switched
		                      : settings->resume ? settings->resume : settings->start, report);
	if (!status && given_label(settings))
		status = open_label(&label, &over, settings, &model, report);
	if (!status)
		status = cli_switch_period(&label, settings->period, settings->label, &model, report);
	if (!status && settings->over) {
		status = cli_over_open(&over, settings->over, settings->omega, &model, report);
		result.over = &over;
	}
	if (!status && settings->over)
		status = cli_over_check(&over, goes_on(settings), report);
	if (!status && settings->over)
		result.from = result.to = over.omega/cli_per_omega(&model);
	else if (!status)
		status = cli_range(&result.from, &result.to, settings->from, settings->to, "frf", &model,
		                   report);
	if (!status)
		status = cli_basis_check(&model, fmax(result.from, result.to), report);
	if (!status)
		status = cli_known(&model, fmax(result.from, result.to), report);
	if (!status && settings->beside)
		status = cli_beside_open(&beside, settings->beside, &model, report);
	if (status)
		goto done;
	status = trace(&frf, &peak, &cover, &label, &model, settings, &result, report);
	if (!status)
		status = cli_fixed_conclude(&result, cover.other, report);
	if (!status && !cli_interrupted())
		status = cli_sweeps(list, &result.sweeps, settings->sweep, settings->sweep_points, &result,
		                    report);
	if (!status && settings->tori && !cli_interrupted())
		status = cli_tori_trace(&tori, &result, strcmp(settings->slack, "end") == 0, report);
	if (!status && settings->backbone && !cli_interrupted()) {
		status = cli_backbone_trace(&free_motions, &result, settings->backbone - 1, report);
		result.overlays = status ? 0 : cli_backbone_overlays(overlay, &free_motions);
	}
	if (beside.root && frf.points > 0 && (!status || settings->partial)) {
		int more = 0;

		written = cli_beside_overlays(overlay + result.overlays, &more, &beside, &result,
		                              status ? &second : report);
		result.overlays += more;
	}
	if (!written && (!status || (settings->partial && frf.points > 0)))
		written = write_result(&result, &model, settings, status ? &second : report);
	if (status && written)
		cli_report_also(report, &second);
	if (!status)
		status = written;
done:
	hawser_sweep_clear(&list[0].run);
	hawser_sweep_clear(&list[1].run);
	cli_backbone_clear(&free_motions);
	cli_beside_clear(&beside);
	hawser_frf_clear(&frf);
	free(peak);
	cli_tori_clear(tori, result.curves);
	cli_cover_clear(&cover);
	cli_over_clear(&over);
	cli_label_clear(&label);
	cli_model_clear(&model);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;

	return !settings->nonlinear && cli_waves_in(&settings->common)
		? cli_waves_response(&settings->common, settings->from, settings->to, settings->points, report)
		: curves(settings, report);
}

const struct cli_command cli_frf = {
	"frf", "SCENE|MODEL", "Certified frequency response: stable, unstable, events", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_frf_listing,
	.takes = CLI_FORCED | CLI_MODELS,
};

/* cli/model/fixed.c - the error of a model with a given number of modes: its estimate from the
 * response, or the reason why it is unknown. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/frame/progress.h"
#include "cli/model/rom_ropeway.h"
#include "cli/frame/view.h"

static enum hawser_status not_known(struct cli_model_error *error, const char *why)
{
	snprintf(error->unknown, sizeof error->unknown, "%s", why);
	return HAWSER_OK;
}

/* An error of the model above this is said on standard error. */
static const double much = 0.1;

/* Of a ropeway: SURE times the sum of the distance from the response with MANY modes, or half as
 * many more than the model has, and that of a response with three fifths of them from it, which
 * stands for its own error. A few modes more than the kept ones are no measure: most have no part in
 * the response, and the inertia of those that have it, which are far above, comes late. */
#define SURE 3.0 /* chosen: enough for 41 of 42 random ropeways against 40 modes */
enum { MANY = 24 };
#define AROUND 1.002 /* end of a response of which the first point is wanted, over it; chosen */
static const double near = 1e-6; /* tolerance of these responses; chosen, far below the errors */

static int many(int n)
{
	int more = n + n/2 > MANY ? n + n/2 : MANY;

	return more < HAWSER_LINE_ROM_MODES ? more : HAWSER_LINE_ROM_MODES;
}

/* once: 1 for the first point alone. */
static enum hawser_status trace(struct hawser_frf *frf, const struct hawser_rom *rom, double from,
                                double to, int once, struct hawser_progress progress,
                                struct hawser_report *report)
{
	struct hawser_frf_options choice = {.method = "balance", .from = from, .to = to,
		.tolerance = near, .step_max = CLI_STEP, .skip_events = 1, .unjudged = 1,
		.end_at_slack = 1, .max_points = once ? 2 : 0, .samples = HAWSER_NONE,
		.progress = progress};

	return hawser_frf_trace(frf, rom, &choice, report);
}

/* The largest difference of the amplitudes of probes of the first points of both, relative to the
 * largest amplitude. */
static double beside(const struct hawser_frf *a, const struct hawser_frf *b)
{
	double most = 0.0, off = 0.0;

	if (a->points < 1 || b->points < 1)
		return NAN;
	for (int k = 0; k < 3*a->probes; k++) {
		double one = a->probe[k]*a->length, other = b->probe[k]*b->length;

		most = fmax(most, fmax(one, other));
		off = fmax(off, fabs(one - other));
	}
	return off > 0.0 ? off/most : 0.0;
}

/* own: the response of the model itself, from..to; once: 1 for its first point alone. */
static enum hawser_status against_more(struct cli_model_error *error, const struct cli_model *model,
                                       const struct hawser_frf *own, double from, double to, int once,
                                       struct hawser_progress progress,
                                       struct hawser_report *report)
{
	struct hawser_accuracy_fixed *fixed = &error->fixed;
	const int modes = many(model->rom.n), with[2] = {modes, 3*modes/5};
	struct hawser_frf other[2] = {{.n = 0}, {.n = 0}};
	double start = cli_seconds(), off[2] = {NAN, NAN};
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < 2; k++) {
		struct hawser_rom rom = {.n = 0};

		status = cli_rom_ropeway_again(&rom, model->ropeway, with[k], report);
		if (!status)
			status = trace(&other[k], &rom, from, to, once, progress, report);
		hawser_rom_clear(&rom);
	}
	for (int k = 0; !status && k < 2; k++) {
		const struct hawser_frf *from_it = k ? &other[1] : own;

		if (once)
			off[k] = beside(from_it, &other[0]);
		else
			status = hawser_accuracy_distance(&off[k], from_it, NULL, &other[0], NULL, 0.0, report);
	}
	error->second = with[1];
	fixed->estimated = fmin(SURE*(off[0] + off[1]), 1.0);
	fixed->looked_at = modes;
	fixed->seconds = cli_seconds() - start;
	hawser_frf_clear(&other[0]);
	hawser_frf_clear(&other[1]);
	return status;
}

static enum hawser_status of_response(struct cli_model_error *error,
                                      const struct cli_frf_result *result,
                                      struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = result->common->quiet}, "frf: with more modes"};
	const struct hawser_progress progress = {cli_watch, &watch};
	enum hawser_status status = against_more(error, result->model, result->frf, result->from,
	                                         result->to, 0, progress, report);

	cli_progress_end(&watch.progress);
	return status;
}

/* Of the steady motion at the frequency omega: the first points of responses that begin there. */
static enum hawser_status of_steady(struct cli_model_error *error, const struct cli_model *model,
                                    double omega, int quiet, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = quiet}, "the motion with more modes"};
	const struct hawser_progress progress = {cli_watch, &watch};
	struct hawser_frf own = {.n = 0};
	enum hawser_status status = trace(&own, &model->rom, omega, omega*AROUND, 1, progress,
	                                  report);

	if (!status)
		status = against_more(error, model, &own, omega, omega*AROUND, 1, progress, report);
	cli_progress_end(&watch.progress);
	hawser_frf_clear(&own);
	return status;
}

/* What is known after an estimate of that status. */
static enum hawser_status conclude(struct cli_model_error *error, enum hawser_status status,
                                   const struct hawser_report *why, struct hawser_report *report)
{
	if (!status)
		return HAWSER_OK;
	error->fixed.estimated = NAN;
	if (status != HAWSER_ERR_MEMORY)
		return not_known(error, why->message);
	if (report)
		*report = *why;
	return status;
}

static const char none_larger[] = "no model of a ropeway has more modes to compare with";

static int has_most(const struct cli_model *model)
{
	return model->ropeway && model->rom.n == HAWSER_LINE_ROM_MODES;
}

enum hawser_status cli_fixed_estimate(struct cli_frf_result *result, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	struct cli_model_error *error = &result->error;
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	if (result->frf->branch > 1 ? !model->has_scene : model->automatic || error->stated)
		return HAWSER_OK; /* of ropeways: the first */
	*error = (struct cli_model_error){.stated = 1, .compared = model->ropeway != NULL,
	                                  .timed = !result->common->reproducible,
	                                  .about = "folds and peaks", .fixed = {.estimated = NAN}};
	if (model->automatic || model->exact.functions)
		return not_known(error, "the accuracy that is stated is that of the first branch");
	if (!model->has_scene && !model->ropeway)
		return not_known(error, "a model file does not say what it leaves out of its scene: give "
		                        "the scene");
	if (has_most(model))
		return not_known(error, none_larger);
	if (result->frf->period > 1)
		return not_known(error, "that of motions of several periods is not");
	if (cli_interrupted())
		return not_known(error, "the response was interrupted");
	if (cli_known_lacks(error->unknown, sizeof error->unknown, model,
	                    fmax(result->from, result->to)))
		return HAWSER_OK;
	status = model->ropeway
	         ? of_response(error, result, &why)
	         : hawser_accuracy_fixed(&error->fixed, &model->rom, result->frf, model->modes.n,
	                                 &model->statics, &model->scene, result->from, result->to, &why);
	return conclude(error, status, &why, report);
}

enum hawser_status cli_fixed_once(struct cli_model_error *error, const struct cli_model *model,
                                  const struct cli_common *common,
                                  const struct hawser_accuracy_motion *motion,
                                  struct hawser_report *report)
{
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	*error = (struct cli_model_error){.stated = 1, .compared = model->ropeway != NULL,
	                                  .timed = !common->reproducible,
	                                  .about = model->ropeway
	                                           ? "the steady motion's largest amplitude"
	                                           : "amplitudes and the frequency",
	                                  .fixed = {.estimated = NAN}};
	if (has_most(model))
		return not_known(error, none_larger);
	if (cli_known_lacks(error->unknown, sizeof error->unknown, model, motion->omega))
		return HAWSER_OK;
	status = model->ropeway
	         ? of_steady(error, model, motion->omega, common->quiet, &why)
	         : hawser_accuracy_once(&error->fixed, &model->rom, motion, model->modes.n,
	                                &model->statics, &model->scene, &why);
	return conclude(error, status, &why, report);
}

void cli_fixed_comments(struct hawser__table *table, const struct cli_model_error *error,
                        int number)
{
	const struct hawser_accuracy_fixed *fixed = &error->fixed;
	char branch[24] = "";

	if (!error->stated)
		return;
	if (number > 1)
		snprintf(branch, sizeof branch, "branch %d: ", number);
	if (!isfinite(fixed->estimated)) {
		hawser__table_comment(table, "%serror of the model: not estimated: %s", branch,
		                      error->unknown);
		return;
	}
	if (error->compared) {
		char second[32] = "";

		if (error->second > 0)
			snprintf(second, sizeof second, " and %d", error->second);
		hawser__table_comment(table, "error of the model: %s%.2g of %s, by comparison with models "
		                      "of %d%s coordinates", fixed->estimated < 1.0 ? "about " : "more than ",
		                      fixed->estimated, error->about, fixed->looked_at, second);
		return;
	}
	hawser__table_comment(table, "%serror of the model: %s%.2g of %s, to first order "
	                      "(modes left out: %.1e, of %d looked at; their effect on the kept: %.1e; "
	                      "others: %.1e; beyond modes: %.1e)",
	                      branch, fixed->estimated < 1.0 ? "" : "more than ", fixed->estimated,
	                      error->about, fixed->rest, fixed->looked_at, fixed->followed, fixed->beyond,
	                      fixed->truncation);
	if (fixed->at_risk > 0)
		hawser__table_comment(table, "%sthe motion can make mode w%d unstable, which the model "
		                      "leaves out", branch, fixed->at_risk);
}

static int is_much(const struct cli_model_error *error)
{
	return error->stated && error->fixed.estimated > much;
}

/* number: of the branch, as in cli_fixed_comments. */
static void warn(const struct cli_model_error *error, int number)
{
	char text[CLI_WARNING_SIZE], branch[24] = "";
	const char *more = error->fixed.estimated < 1.0 ? "" : "more than ";

	if (!is_much(error))
		return;
	if (number > 1)
		snprintf(branch, sizeof branch, "branch %d: ", number);
	if (error->compared)
		snprintf(text, sizeof text, "%s%s may be off by %s%.0f %%: so far is the model of another "
		         "size: a larger one (model.basis, or -n of a ropeway) may be closer", branch,
		         error->about, more, 100.0*error->fixed.estimated);
	else
		snprintf(text, sizeof text, "%s%s may be off by %s%.0f %% because of what the model leaves "
		         "out, by an estimate to first order: hawser plan compares models; more modes (-n), "
		         "model.modes: auto or model.energy: exact may be closer", branch, error->about, more,
		         100.0*error->fixed.estimated);
	cli_warn(text);
}

void cli_fixed_warn(const struct cli_model_error *error)
{
	warn(error, 1);
}

const struct cli_frf_result *cli_fixed_worst(const struct cli_frf_result *result)
{
	const struct cli_frf_result *worst = result;

	for (int k = 0; k < result->others; k++) {
		const struct cli_frf_result *other = &result->other[k];

		if (is_much(&other->error) &&
		    !(other->error.fixed.estimated <= worst->error.fixed.estimated && is_much(&worst->error)))
			worst = other;
	}
	return is_much(&worst->error) ? worst : NULL;
}

void cli_fixed_warn_worst(const struct cli_frf_result *result)
{
	const struct cli_frf_result *worst = cli_fixed_worst(result);

	if (worst)
		warn(&worst->error, worst->frf->branch);
}

double *cli_range_reach(double *reached, const struct cli_model *model, const double *u, int rows,
                        int stride)
{
	size_t n = (size_t)model->rom.n;

	if (model->rom.exact || !model->rom.range)
		return NULL;
	if (!reached)
		reached = calloc(n, sizeof *reached);
	for (int i = 0; reached && i < rows; i++)
		for (size_t j = 0; j < n; j++)
			reached[j] = fmax(reached[j], fabs(u[(size_t)i*(size_t)stride + j]));
	return reached;
}

void cli_range_warn(struct cli_model *model, double *reached)
{
	struct hawser_rom *rom = &model->rom;
	char text[CLI_WARNING_SIZE];
	int j = -1;

	/* who asks for modes at rest, to repeat a source, knows that the model is too stiff; what cannot
	 * be judged is not known, and nothing is said */
	if (reached && !cli_interrupted() &&
	    (!model->has_scene || (model->scene.model.condense == HAWSER_CONDENSE_STATIC &&
	                           !hawser_law_range(rom, &model->statics, reached, NULL))))
		j = hawser_law_exceeded(rom, reached);
	if (j < 0) {
		free(reached);
		return;
	}
	snprintf(text, sizeof text, "coordinate u_%d (%s) moves by up to %.3g m: the force that holds it "
	         "there at rest, all others relaxed, is that of the cable within %.0f %% up to %.3g m "
	         "only, and what moves further may be off: take model.energy: exact, or other modes "
	         "(hawser rom prints the range of each)", j + 1, rom->label ? rom->label[j] : "mode",
	         reached[j]*rom->range[j].largest, 100.0*HAWSER_LAW_LIMIT, rom->range[j].amplitude);
	free(reached);
	cli_warn(text);
}

/* A curve over a key of the scene has other models than that of the scene. */
void cli_range_warn_frf(struct cli_model *model, const struct cli_frf_result *result)
{
	double *reached;

	if (result->over && cli_over_needs_scene(result->over->axis.key))
		return;
	reached = cli_range_reach(NULL, model, result->frf->coordinate, result->frf->points, model->rom.n);
	for (int k = 0; k < result->others; k++)
		reached = cli_range_reach(reached, model, result->other[k].frf->coordinate,
		                          result->other[k].frf->points, model->rom.n);
	cli_range_warn(model, reached);
}

static int is_stated(const void *row, const void *parent)
{
	(void)parent;
	return ((const struct cli_model_error *)row)->stated;
}

static int is_known(const void *row, const void *parent)
{
	return is_stated(row, parent) &&
	       isfinite(((const struct cli_model_error *)row)->fixed.estimated);
}

/* Whether it was found mode by mode. */
static int is_weighed(const void *row, const void *parent)
{
	return is_known(row, parent) && !((const struct cli_model_error *)row)->compared;
}

static int is_unknown(const void *row, const void *parent)
{
	return is_stated(row, parent) && !is_known(row, parent);
}

static int has_times(const void *row, const void *parent)
{
	return is_known(row, parent) && ((const struct cli_model_error *)row)->timed;
}

static int is_at_risk(const void *row, const void *parent)
{
	return is_known(row, parent) && ((const struct cli_model_error *)row)->fixed.at_risk > 0;
}

static double left_out(const void *row)
{
	return fmin(((const struct cli_model_error *)row)->fixed.rest, 1e300);
}

static double others(const void *row)
{
	return fmin(((const struct cli_model_error *)row)->fixed.beyond, 1e300);
}

#define OF(member) HAWSER__AT(struct cli_model_error, member)
const struct hawser__field cli_fixed_field[] = {
	{"model_error.estimated", NULL,
	 "error of folds and peaks, or of one motion, relative, 1 at most; null: not known",
	 OF(fixed.estimated), .flags = HAWSER__NULL, .given = is_stated},
	{"model_error.reason", NULL, "why it is not known", OF(unknown), .given = is_unknown},
	{"model_error.left_out", NULL, "what modes that are not kept do beside following",
	 HAWSER__BY(left_out), .given = is_weighed},
	{"model_error.followed", NULL, "what they and the terms beyond the fourth order do to the kept",
	 OF(fixed.followed), .given = is_weighed},
	{"model_error.others", NULL, "modes not looked at, extrapolated", HAWSER__BY(others),
	 .given = is_weighed},
	{"model_error.beyond_modes", NULL, "part of `followed` that no mode makes up for",
	 OF(fixed.truncation), .given = is_weighed},
	{"model_error.located", NULL, "how well the peaks are located", OF(fixed.located),
	 .given = is_weighed},
	{"model_error.looked_at", NULL, "modes; of ropeways those of the other response",
	 OF(fixed.looked_at), .given = is_known},
	{"model_error.at_risk", NULL, "a mode left out that the motion can make unstable",
	 OF(fixed.at_risk), .given = is_at_risk},
	{"model_error.seconds", NULL, "wall time of the estimate (s)", OF(fixed.seconds),
	 .given = has_times},
	HAWSER__END,
};
#undef OF

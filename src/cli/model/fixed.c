/* cli/model/fixed.c - the error of a model with a given number of modes: its estimate from the
 * response, or the reason why it is unknown. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/model/made.h"
#include "cli/frame/view.h"
#include "core/append.h"

const char cli_fixed_advice[] = "hawser plan compares models; more modes (-n), model.modes: auto or "
                                "model.energy: exact may be closer";
const char cli_basis_advice[] = "a larger one (model.basis) may be closer";

struct cli_model_error cli_fixed_unknown(const struct cli_model *model, const char *about, int timed)
{
	return (struct cli_model_error){.stated = 1, .per_omega = cli_per_omega(model), .timed = timed,
		.about = about, .advice = model->made ? "more modes (-n) may be closer" : cli_fixed_advice,
		.fixed = {.estimated = NAN}};
}

static enum hawser_status not_known(struct cli_model_error *error, const char *why)
{
	snprintf(error->unknown, sizeof error->unknown, "%s", why);
	return HAWSER_OK;
}

/* An error of the model above this is said on standard error. */
static const double much = 0.1;

/* Relative tolerance of peaks: 1e-3 takes 5 % of the time of the chairlift; this part of a smaller
 * error of the model, with exact energy, where points are dear, half of it, but not less than 1e-4;
 * chosen. */
static const double peaks_most = 1e-3, peaks_least = 1e-4, peaks_part = 0.1, peaks_exact = 0.5;

#define AROUND 1.002 /* end of a response of which the first point is wanted, over it; chosen */
static const double near = 1e-6; /* tolerance of this response; chosen, far below the errors */

/* Of the steady motion at the frequency omega: the first points of a response that begins there. */
static enum hawser_status of_steady(struct cli_model_error *error, const struct cli_model *model,
                                    double omega, struct hawser_report *report)
{
	const struct hawser_frf_options choice = {.method = "balance", .from = omega, .to = omega*AROUND,
		.tolerance = near, .step_max = CLI_STEP, .skip_events = 1, .unjudged = 1,
		.end_at_slack = 1, .max_points = 2, .samples = HAWSER_NONE};
	struct hawser_frf own = {.n = 0};
	enum hawser_status status = hawser_frf_trace(&own, &model->rom, &choice, report);

	if (!status)
		status = cli_made_error(&error->fixed, model, &own, choice.from, choice.to, report);
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
	error->unweighed = status == HAWSER_ERR_ARGUMENT;
	if (status != HAWSER_ERR_MEMORY)
		return not_known(error, why->message);
	if (report)
		*report = *why;
	return status;
}

static const char none_larger[] = "no model of this kind has more modes to look at";

static int has_most(const struct cli_model *model)
{
	const struct cli_made *of = model->made;

	return of && of->modes.modes.mode[of->modes.modes.n - 1].place >= of->by->most;
}

static enum hawser_status estimate(struct cli_frf_result *result, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	struct cli_model_error *error = &result->error;
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	if (result->frf->branch > 1 ? !model->has_scene : model->automatic || error->stated)
		return HAWSER_OK; /* of models that are made: the first */
	/* a model of one's own leaves nothing out */
	if (!model->has_scene && !model->made && model->rom.shapes.points == 0)
		return HAWSER_OK;
	*error = cli_fixed_unknown(model, "folds and peaks", !result->common->reproducible);
	if (model->automatic || model->exact.functions)
		return not_known(error, "the accuracy that is stated is that of the first branch");
	if (!model->has_scene && !model->made)
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
	status = model->made
	         ? cli_made_error(&error->fixed, model, result->frf, result->from, result->to, &why)
	         : hawser_accuracy_fixed(&error->fixed, &model->rom, result->frf, model->modes.n,
	                                 &model->statics, &model->scene, result->from, result->to, &why);
	return conclude(error, status, &why, report);
}

enum hawser_status cli_fixed_estimate(struct cli_frf_result *result, struct hawser_report *report)
{
	enum hawser_status status = estimate(result, report);

	return status ? status : cli_certify(result, report);
}

/* With the peaks as they are located last. */
static void locate(struct cli_frf_result *result)
{
	struct cli_model_error *error = &result->error;

	if (result->located && error->stated && !error->corrected &&
	    !(error->compared && result->model->exact.functions) && isfinite(error->fixed.estimated))
		hawser_accuracy_locate(&error->fixed, result->peak, result->peaks);
}

enum hawser_status cli_fixed_conclude(struct cli_frf_result *result, struct cli_frf_result *other,
                                      struct hawser_report *report)
{
	enum hawser_status status = result->over ? HAWSER_OK : cli_fixed_estimate(result, report);

	locate(result);
	for (int k = 0; k < result->others && !status; k++) {
		status = result->over ? HAWSER_OK : cli_fixed_estimate(&other[k], report);
		locate(&other[k]);
	}
	return status;
}

double cli_fixed_tolerance(const struct cli_model_error *error, int exact)
{
	double known = error->fixed.estimated;

	if (!error->stated || !isfinite(known))
		return peaks_most;
	return fmax(fmin((exact ? peaks_exact : peaks_part)*known, peaks_most), peaks_least);
}

enum hawser_status cli_fixed_once(struct cli_model_error *error, const struct cli_model *model,
                                  const struct cli_common *common,
                                  const struct hawser_accuracy_motion *motion,
                                  struct hawser_report *report)
{
	struct hawser_report why = {.message = ""};
	enum hawser_status status;

	*error = cli_fixed_unknown(model, model->made ? "the steady motion's amplitudes"
	                                          : "amplitudes and the frequency", !common->reproducible);
	if (has_most(model))
		return not_known(error, none_larger);
	if (cli_known_lacks(error->unknown, sizeof error->unknown, model, motion->omega))
		return HAWSER_OK;
	status = model->made
	         ? of_steady(error, model, motion->omega, &why)
	         : hawser_accuracy_once(&error->fixed, &model->rom, motion, model->modes.n,
	                                &model->statics, &model->scene, &why);
	return conclude(error, status, &why, report);
}

/* "w16 = 5.6056 rad/s at 2 Omega (0.18), w9 ..." */
static const char *named(char *text, size_t size, const struct cli_model_error *error)
{
	*text = '\0';
	for (int i = 0; i < error->fixed.omissions; i++) {
		const struct hawser_accuracy_omission *one = &error->fixed.omission[i];
		char at[24] = "";

		if (one->harmonic > 0)
			snprintf(at, sizeof at, " at %.0d%sOmega", one->harmonic == 1 ? 0 : one->harmonic,
			         one->harmonic == 1 ? "" : " ");
		hawser__append(text, size, ", ", "w%d = %.5g rad/s%s (%.1e)", one->mode,
		               one->omega*error->per_omega, at, one->measure);
	}
	return text;
}

void cli_fixed_comments(struct hawser__table *table, const struct cli_model_error *error,
                        int number)
{
	const struct hawser_accuracy_fixed *fixed = &error->fixed;
	double first = error->corrected ? error->before : fixed->estimated;
	const char *of = error->about;
	char branch[24] = "", text[240], largest[80] = "";

	if (!error->stated)
		return;
	if (fixed->largest > 0.0) {
		snprintf(largest, sizeof largest, "%.2g of folds and the two largest peaks, ", fixed->largest);
		of = "smaller ones";
	}
	if (number > 1)
		snprintf(branch, sizeof branch, "branch %d: ", number);
	if (!isfinite(fixed->estimated)) {
		hawser__table_comment(table, "%serror of the model: not estimated: %s", branch,
		                      error->unknown);
		return;
	}
	if (error->corrected)
		hawser__table_comment(table, "%serror of the model: %s%s%.2g of %s, corrected in the mesh",
		                      branch, fixed->estimated < 1.0 ? "" : "more than ", largest,
		                      fixed->estimated, of);
	if (error->corrected && !isfinite(error->before))
		return;
	if (error->compared) {
		hawser__table_comment(table, "error of the model: %s%s%.2g of %s, by comparison with a model "
		                      "of %d coordinates", fixed->estimated < 1.0 ? "about " : "more than ",
		                      largest, fixed->estimated, of, fixed->looked_at);
		return;
	}
	hawser__table_comment(table, "%s%s: %s%.2g of %s, to first order "
	                      "(modes left out: %.1e, of %d looked at; their effect on the kept: %.1e; "
	                      "others: %.1e; beyond modes: %.1e)",
	                      branch,
	                      error->corrected ? "error by what it leaves out" : "error of the model",
	                      first < 1.0 ? "" : "more than ", first, error->about, fixed->rest,
	                      fixed->looked_at, fixed->followed, fixed->beyond, fixed->truncation);
	if (fixed->omissions > 0)
		hawser__table_comment(table, "%sleft out, with the largest parts in it: %s", branch,
		                      named(text, sizeof text, error));
	if (fixed->at_risk > 0)
		hawser__table_comment(table, "%sthe motion can make mode w%d unstable, which the model "
		                      "leaves out", branch, fixed->at_risk);
}

static int is_much(const struct cli_model_error *error)
{
	return error->stated && error->fixed.estimated > much;
}

/* ", most by w16, which -n 16 keeps" */
static const char *mostly(char *text, size_t size, const struct hawser_accuracy_fixed *fixed)
{
	*text = '\0';
	if (fixed->omissions > 0)
		snprintf(text, size, ", most by mode w%d, which -n %d keeps", fixed->omission[0].mode,
		         fixed->omission[0].mode);
	return text;
}

/* number: of the branch, as in cli_fixed_comments. */
static void warn(const struct cli_model_error *error, int number)
{
	char text[CLI_WARNING_SIZE], branch[24] = "";
	const char *more = error->fixed.estimated < 1.0 ? "" : "more than ";
	char most[64], brief[48];

	if (!is_much(error))
		return;
	if (number > 1)
		snprintf(branch, sizeof branch, "branch %d: ", number);
	if (error->corrected)
		snprintf(text, sizeof text, "%s are off by %s%.0f %%, corrected in the mesh: %s", error->about,
		         more, 100.0*error->fixed.estimated, error->advice);
	else if (error->compared)
		snprintf(text, sizeof text, "%s%s may be off by %s%.0f %%: so far is the model of another "
		         "size: %s", branch, error->about, more, 100.0*error->fixed.estimated, error->advice);
	else
		snprintf(text, sizeof text, "%s%s may be off by %s%.0f %% because of what the model leaves "
		         "out, by an estimate to first order%s: %s", branch, error->about, more,
		         100.0*error->fixed.estimated, mostly(most, sizeof most, &error->fixed), error->advice);
	snprintf(brief, sizeof brief, "may be off by %s%.0f %%", more, 100.0*error->fixed.estimated);
	cli_caution(brief, text);
}

void cli_fixed_warn(const struct cli_model_error *error)
{
	warn(error, 1);
}

static const struct cli_frf_result *fixed_worst(const struct cli_frf_result *result)
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
	const struct cli_frf_result *worst = fixed_worst(result);

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
	enum hawser_status status = HAWSER_OK;
	int j = -1;

	/* who asks for modes at rest, to repeat a source, knows that the model is too stiff; what cannot
	 * be judged is not known, and nothing is said */
	if (reached && !cli_interrupted() &&
	    (!model->has_scene || (model->scene.model.condense == HAWSER_CONDENSE_STATIC &&
	                           !(status = hawser_law_range(rom, &model->statics, reached, NULL)))))
		j = hawser_law_exceeded(rom, reached);
	model->starved = status == HAWSER_ERR_MEMORY;
	if (j < 0) {
		free(reached);
		return;
	}
	snprintf(text, sizeof text, "coordinate u_%d (%s) moves by up to %.3g m: its static force (with "
	         "all other coordinates at rest under it), inertia and damping are right within %.0f %% "
	         "only up to %.3g m, and results beyond that may be wrong: take model.energy: exact, or "
	         "other modes (hawser rom prints the range of each)", j + 1,
	         rom->label ? rom->label[j] : "mode",
	         reached[j]*rom->range[j].largest, 100.0*HAWSER_LAW_LIMIT, rom->range[j].amplitude);
	free(reached);
	cli_caution("moves further than the model is right", text);
}

/* A curve over a key of the scene has other models than that of the scene; and where the error of the
 * motions themselves is small, their sizes tell no more. */
void cli_range_warn_frf(struct cli_model *model, const struct cli_frf_result *result)
{
	double *reached;

	if ((result->over && cli_over_needs_scene(result->over->axis.key)) ||
	    (result->error.stated && !hawser_accuracy_poor(&result->error.fixed, 0.0)))
		return;
	reached = cli_range_reach(NULL, model, result->frf->coordinate, result->frf->points, model->rom.n);
	for (int k = 0; k < result->others; k++)
		reached = cli_range_reach(reached, model, result->other[k].frf->coordinate,
		                          result->other[k].frf->points, model->rom.n);
	cli_range_warn(model, reached);
}

HAWSER__GIVEN(is_stated, struct cli_model_error, of->stated)

HAWSER__GIVEN(is_known, struct cli_model_error,
	is_stated(row, parent) && isfinite(of->fixed.estimated))

/* Whether it was found mode by mode. */
HAWSER__GIVEN(is_weighed, struct cli_model_error,
	is_known(row, parent) && !of->compared && !(of->corrected && isnan(of->before)))

static int is_unknown(const void *row, const void *parent)
{
	return is_stated(row, parent) && !is_known(row, parent);
}

HAWSER__GIVEN(has_times, struct cli_model_error, is_known(row, parent) && of->timed)

HAWSER__GIVEN(is_corrected, struct cli_model_error, of->corrected)

HAWSER__GIVEN(is_at_risk, struct cli_model_error, is_known(row, parent) && of->fixed.at_risk > 0)

HAWSER__GIVEN(has_omissions, struct cli_model_error,
	is_weighed(row, parent) && of->fixed.omissions > 0)

HAWSER__GIVEN(has_smaller, struct cli_model_error, is_known(row, parent) && of->fixed.largest > 0.0)

static double stated(const void *row)
{
	const struct hawser_accuracy_fixed *fixed = &((const struct cli_model_error *)row)->fixed;

	return fixed->largest > 0.0 ? fixed->largest : fixed->estimated;
}

HAWSER__OF(left_out, double, struct cli_model_error, fmin(of->fixed.rest, 1e300))

HAWSER__OF(others, double, struct cli_model_error, fmin(of->fixed.beyond, 1e300))

#define OF(member) HAWSER__AT(struct cli_model_error, member)
const struct hawser__field cli_fixed_field[] = {
	{"model_error.estimated", NULL,
	 "error of folds and peaks (of the two largest, if `smaller` is there), or of one motion, "
	 "relative, 1 at most; null: not known", HAWSER__BY(stated), .flags = HAWSER__NULL,
	 .given = is_stated},
	{"model_error.smaller", NULL, "the same, smaller peaks included", OF(fixed.estimated),
	 .given = has_smaller},
	{"model_error.before", NULL, "the same to first order, where `estimated` is by correction in the "
	 "mesh (certified)", OF(before), .flags = HAWSER__NULL, .given = is_corrected},
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
	{"model_error.looked_at", NULL, "modes", OF(fixed.looked_at), .given = is_known},
	{"model_error.largest", NULL, "index of the mode left out with the largest part in it",
	 OF(fixed.omission[0].mode), .given = has_omissions},
	{"model_error.at_risk", NULL, "a mode left out that the motion can make unstable",
	 OF(fixed.at_risk), .given = is_at_risk},
	{"model_error.seconds", NULL, "wall time of the estimate (s)", OF(fixed.seconds),
	 .given = has_times},
	HAWSER__END,
};
#undef OF

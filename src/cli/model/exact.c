/* cli/model/exact.c - a response with the exact energy in place of one of a reduced model that is
 * not good enough (model.energy: auto).
 *
 * A polynomial of degree 4 on a few modes is right for taut cables and small motions. Where a cable
 * swings and sags, no number of modes makes it right (doc/theory-rom.md). The estimate of its
 * truncation error from the motions of its own response tells (fixed.h); then full-order models of
 * increasing bases follow, until two agree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"

/* The longest step of its curves, relative to the range (hawser__accuracy_settle). */
static const double longest = 0.02;

/* Work of a search with a model that may be off by more than 100 %; chosen. */
static const double glance = 5.0;

/* Work after which a curve of modes is judged first, and the factor from one judgement to the next,
 * which takes 0.1 to 0.3 s; fewest points then; chosen. */
static const double soon = 1.0, later = 3.0;
enum { fewest = 24 };

static int has_accuracy(const struct cli_model *model)
{
	return hawser_scene_written(&model->scene, "model.accuracy");
}

/* Whether the error over a range can be estimated: that of a span of condensed modes. */
static int is_judged(const struct cli_model *model)
{
	return model->has_scene && !model->made && !model->automatic && !model->rom.exact &&
	       model->scene.model.condense == HAWSER_CONDENSE_STATIC;
}

int cli_exact_calls(const struct cli_model *model, const struct cli_model_error *error)
{
	return is_judged(model) && model->scene.model.energy == HAWSER_ENERGY_AUTO &&
	       (!error || (error->stated && hawser_accuracy_poor(&error->fixed, has_accuracy(model)
	                                                          ? model->scene.model.accuracy : 0.0)));
}

/* The same, or whether it alone tells the error of the modes: not with drag or the exact force of a
 * wind, where an orbit of the exact energy takes longer than the answer is worth. */
static int is_wanted(const struct cli_model *model, const struct cli_model_error *error)
{
	return cli_exact_calls(model, error) ||
	       (error->unweighed && !model->rom.drag && cli_exact_calls(model, NULL));
}

int cli_exact_failed(const struct cli_model *model, const struct cli_model_error *error)
{
	return model->exact.failed[0] && !(error->fixed.estimated < 1.0);
}

double cli_exact_allowed(const struct cli_model *model)
{
	return model->rom.exact ? 0.0 : cli_exact_failed(model, &model->error) ? glance : CLI_BEARABLE;
}

void cli_exact_costly(const struct cli_model *model, int costly)
{
	char text[CLI_WARNING_SIZE];

	if (!costly)
		return;
	snprintf(text, sizeof text, "time: the search takes more than is done unasked, and ends there: %sa "
	         "narrower range takes less, --max-points N lifts the limit",
	         model->has_scene || model->made ? "a model of fewer modes (-n) or " : "");
	cli_caution("search ended at its limit of work", text);
}

/* The model is now what the scene would be with these keys. */
static void take(struct cli_model *model, struct hawser_accuracy *better,
                 const struct cli_model_error *error)
{
	model->exact = (struct cli_exact){.modes = model->modes.n, .functions = better->functions,
	                                  .coordinates = better->rom.n,
	                                  .before = error->stated && error->unweighed
	                                            ? better->attempt[0].moved
	                                            : error->stated ? error->fixed.estimated : NAN,
	                                  .beyond = error->stated ? error->fixed.truncation : NAN};
	hawser_rom_clear(&model->rom);
	model->rom = better->rom;
	better->rom = (struct hawser_rom){0};
	model->scene.model.energy = HAWSER_ENERGY_EXACT;
	model->scene.model.basis = better->functions;
}

/* The range that its response has, and why the rest is left out. */
static void shorten(struct cli_frf_result *result, struct cli_model *model,
                    const struct hawser_accuracy *better, double bearable)
{
	struct cli_exact *exact = &model->exact;

	if (isnan(better->until))
		return;
	result->to = better->until;
	exact->until = better->until*cli_per_omega(model);
	if (better->beyond[0])
		snprintf(exact->rest, sizeof exact->rest, "%s", better->beyond);
	else
		snprintf(exact->rest, sizeof exact->rest, "further takes more than some %.0f s: ask for "
		         "other parts of the range (--from, --to), or for all of it (--set "
		         "model.energy=exact --set model.basis=%d)", bearable, better->functions);
}

/* The distance from the curve of the basis that it was checked with. */
static void state(struct cli_model_error *error, const struct hawser_accuracy *better)
{
	int timed = error->timed;

	*error = (struct cli_model_error){.stated = 1, .compared = 1, .timed = timed,
	                                  .about = "folds and peaks", .advice = cli_basis_advice};
	error->fixed.estimated = better->estimated;
	error->fixed.largest = better->largest;
	error->fixed.looked_at = better->tries > 0 ? better->attempt[better->tries - 1].checked
	                         : better->checked;
	error->fixed.seconds = better->seconds;
}

/* Why there is none. */
static void explain(struct cli_model *model, const struct hawser_accuracy *better,
                    enum hawser_status status, const char *why)
{
	char *text = model->exact.failed;
	size_t size = sizeof model->exact.failed;

	if (better->costly)
		snprintf(text, size, "it would take some %.0f s: narrow the range, or ask for it "
		         "(--set model.energy=exact --set model.basis=%d)", better->foreseen,
		         better->functions);
	else
		snprintf(text, size, "%s", status ? why
		         : better->slack ? "the cable goes slack in much of this response"
		         : better->frf.end == HAWSER_END_MAX_POINTS
		         ? "it takes too many points: narrow the range, or ask for it by model.energy: exact"
		         : better->frf.end == HAWSER_END_INTERRUPTED ? "it was interrupted"
		         : better->functions == 0 ? "the range reaches modes that need a larger basis"
		         : "no two bases agree");
}

/* What a search tells. */
struct told {
	struct hawser_progress progress; /* the caller's */
	double began, bearable; /* s of processor time */
};

/* One that foresees more than can be borne, or half of it, may end before, unless its range may (then
 * the drafts tell): how long the command takes is not known then. */
static int tell(void *data, const struct hawser_progress_state *state)
{
	const struct told *told = data;
	struct hawser_progress_state shown = *state;

	if (cli_processor_seconds() - told->began > 0.5*told->bearable*shown.fraction)
		shown.left = INFINITY;
	return told->progress.function(told->progress.data, &shown);
}

/* Search for the model. result: NULL: for the model alone, whose range stays. points: of
 * `response`, that of the modes, or NULL; after: hawser_accuracy_options. Where their error is not
 * known, it may turn out to be small. */
static enum hawser_status search(struct hawser_accuracy *better, struct cli_model *model,
                                 struct cli_model_error *error, struct cli_frf_result *result,
                                 const struct hawser_frf_options *options,
                                 const struct hawser_frf *response, int points, double after,
                                 struct hawser_report *report)
{
	int unweighed = response && error->stated && error->unweighed;
	struct hawser_accuracy_options choice =
		hawser_accuracy_instead(error->stated ? &error->fixed : NULL, has_accuracy(model), options);
	struct hawser_report why = {.message = ""};
	struct told told;
	enum hawser_status status;

	choice.expected = points;
	choice.after = after;
	choice.partial = choice.partial && result;
	choice.rom = &model->rom;
	choice.response = unweighed ? response : NULL;
	if (unweighed)
		choice.bearable = HAWSER_INSTEAD_FOR_ERROR;
	else if (after > 0.0)
		choice.bearable = fmin(choice.bearable, CLI_BEARABLE);
	told = (struct told){options->progress, cli_processor_seconds(),
	                     choice.partial ? INFINITY : choice.bearable};
	choice.frf.progress = (struct hawser_progress){tell, &told};
	status = hawser_accuracy_exact(better, &model->statics, &model->scene, &choice, &why);
	if (status == HAWSER_ERR_MEMORY) {
		if (report)
			*report = why;
		return status;
	}
	if (!status && better->reached) {
		if (better->rom.n > 0)
			take(model, better, error);
		else if (better->functions > 0)
			explain(model, better, status, why.message);
		state(error, better);
		if (result)
			shorten(result, model, better, choice.bearable);
	} else if (!unweighed) {
		explain(model, better, status, why.message);
	}
	return HAWSER_OK;
}

/* Points that the curve would have with the longest steps of the exact energy: most of the steps of a
 * response of modes are those that the picture needs. */
static int points_wanted(const struct hawser_frf *frf, const struct hawser_frf_options *options)
{
	double range = fabs(options->to - options->from), points = 1.0;

	for (int i = 1; i < frf->points && options->step_max > 0.0; i++) {
		double turn = fabs(frf->point[i].omega - frf->point[i - 1].omega)/range;

		points += turn > 0.9*options->step_max ? fmin(turn/longest, 1.0) : 1.0;
	}
	if (frf->points > 1 && frf->end == HAWSER_END_INTERRUPTED) /* of a part of the range */
		points *= range/fmax(fabs(frf->point[frf->points - 1].omega - options->from), 0.1*range);
	return points > 1.0 ? (int)points : frf->points;
}

/* whole: 1: frf is the response of the modes. */
static enum hawser_status trace(struct hawser_frf *frf, struct hawser_frf_options *options,
                                struct cli_model *model, struct cli_frf_result *result, int step,
                                int whole, struct hawser_report *report)
{
	struct hawser_accuracy better = {.tries = 0};
	struct hawser_frf_options choice = *options;
	enum hawser_status status;

	if (!step)
		choice.step_max = 0.0; /* that of the search: longer, as each point costs more */
	if (step && frf->points > HAWSER_INSTEAD_POINTS) { /* it has no fewer */
		better.frf.end = HAWSER_END_MAX_POINTS;
		explain(model, &better, HAWSER_OK, "");
		return HAWSER_OK;
	}
	status = search(&better, model, &result->error, result, &choice,
	                whole ? frf : NULL, step ? frf->points : points_wanted(frf, options), 0.0,
	                report);
	if (!status && model->exact.functions) {
		*options = better.traced;
		hawser_frf_clear(frf);
		*frf = better.frf;
		better.frf = (struct hawser_frf){0};
	}
	hawser_accuracy_clear(&better);
	return status;
}

/* Where the modes of a curve are not good enough or fail (so_far: its status): replace it. */
static enum hawser_status judge_curve(struct hawser_frf *frf, struct hawser_frf_options *options,
                                      struct cli_model *model, struct cli_frf_result *result, int step,
                                      enum hawser_status so_far, struct hawser_report *report)
{
	enum hawser_status status;

	if (frf->end == HAWSER_END_MAX_POINTS || cli_interrupted() ||
	    (so_far && so_far != HAWSER_ERR_CONVERGENCE))
		return so_far;
	/* the points so far tell whether the energy is the reason of a failure */
	if (frf->points > 1 && (status = cli_fixed_estimate(result, so_far ? NULL : report)))
		return so_far ? so_far : status;
	if (so_far && frf->points < 2 ? !cli_exact_calls(model, NULL) : !is_wanted(model, &result->error))
		return so_far;
	status = trace(frf, options, model, result, step, !so_far, report);
	if (status || !model->exact.functions)
		return status ? status : so_far;
	return cli_basis_check(model, fmax(result->from, result->to), report);
}

/* A curve of modes whose motions so far are judged from time to time. */
struct early {
	struct hawser_progress progress; /* the caller's */
	const struct cli_model *model;
	double from, to, next; /* next: work of the next judgement */
	int sought; /* 1: the exact energy takes its place, where no number of modes makes it right */
	int called; /* 1: that is so, or the error is as large as any, and the curve has ended */
};

static int judge_early(void *data, const struct hawser_progress_state *state)
{
	struct early *early = data;
	const struct cli_model *model = early->model;
	struct hawser_progress_state shown = *state;
	struct hawser_accuracy_fixed fixed;

	if (state->frf && state->frf->points >= fewest &&
	    hawser_orbit_work(&state->frf->cost, &model->rom) > early->next) {
		early->next *= later;
		early->called = !hawser_accuracy_fixed(&fixed, &model->rom, state->frf, model->modes.n,
		                                       &model->statics, &model->scene, early->from,
		                                       early->to, NULL) &&
		                (early->sought ? hawser_accuracy_truncated(fixed.truncation)
		                               : fixed.estimated >= 1.0);
	}
	if (early->next == soon) /* what follows the curve is not known */
		shown.fraction = shown.left = NAN;
	return early->called || early->progress.function(early->progress.data, &shown);
}

enum hawser_status cli_exact_trace(struct hawser_frf *frf, struct hawser_frf_options *options,
                                   struct cli_model *model, struct cli_frf_result *result, int step,
                                   struct hawser_report *report)
{
	struct early early = {options->progress, model, result->from, result->to, soon, .sought = 1};
	struct hawser_frf_options choice = *options;
	char lacks[CLI_WARNING_SIZE];
	enum hawser_status status;

	if (cli_exact_calls(model, NULL) &&
	    !cli_known_lacks(lacks, sizeof lacks, model, fmax(result->from, result->to)))
		choice.progress = (struct hawser_progress){judge_early, &early};
	status = hawser_frf_trace(frf, &model->rom, &choice, report);
	status = judge_curve(frf, options, model, result, step, status, report);
	if (!status && early.called && !model->exact.functions && !cli_interrupted()) {
		hawser_frf_clear(frf); /* the curve of modes is then followed to its end */
		result->error = (struct cli_model_error){.stated = 0};
		status = hawser_frf_trace(frf, &model->rom, options, report);
	}
	return status;
}

/* The response of the modes over a range, and its error. */
static enum hawser_status judge(struct hawser_frf *frf, struct cli_model *model,
                                const struct hawser_frf_options *options,
                                struct hawser_report *report)
{
	struct hawser_report why = {.message = ""};
	struct cli_model_error *error = &model->error;
	enum hawser_status status = hawser_frf_trace(frf, &model->rom, options, &why);
	int followed = !status;

	if (frf->points > 1 && (!status || status == HAWSER_ERR_CONVERGENCE) && !cli_interrupted())
		status = hawser_accuracy_fixed(&error->fixed, &model->rom, frf, model->modes.n,
		                               &model->statics, &model->scene, options->from, options->to,
		                               &why);
	if (status == HAWSER_ERR_MEMORY && report)
		*report = why;
	if (status) {
		error->fixed.estimated = NAN;
		error->unweighed = followed && status == HAWSER_ERR_ARGUMENT;
		snprintf(error->unknown, sizeof error->unknown, "%s", why.message);
	}
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

enum hawser_status cli_exact_range(struct cli_model *model, double from, double to, double after,
                                   const struct cli_common *common, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = common->quiet}, "the model's error"};
	struct hawser_frf_options options = {.method = "balance", .from = from, .to = to,
		.step_max = longest, .skip_events = 1, .unjudged = 1, .end_at_slack = 1,
		.max_points = HAWSER_INSTEAD_POINTS, .samples = HAWSER_NONE};
	struct early early = {{cli_watch, &watch}, model, from, to, soon,
	                      .sought = after >= 0.0 && cli_exact_calls(model, NULL)};
	struct hawser_accuracy better = {.tries = 0};
	struct hawser_frf frf = {.n = 0};
	enum hawser_status status;

	model->error.to = fmax(from, to);
	if (!is_judged(model) || !hawser_rom_loaded(&model->rom) || from == to)
		return HAWSER_OK;
	model->error = (struct cli_model_error){.stated = 1, .to = model->error.to,
	                                        .timed = !common->reproducible,
	                                        .about = "folds and peaks", .advice = cli_fixed_advice,
	                                        .per_omega = cli_per_omega(model), .fixed.estimated = NAN};
	options.progress = (struct hawser_progress){judge_early, &early};
	status = judge(&frf, model, &options, report);
	if (!status && after >= 0.0 && is_wanted(model, &model->error) &&
	    (model->error.unweighed || isfinite(model->error.fixed.estimated))) {
		int points = points_wanted(&frf, &options);

		options.step_max = 0.0;
		options.progress = early.progress;
		status = search(&better, model, &model->error, NULL, &options, &frf, points, after, report);
		hawser_accuracy_clear(&better);
	}
	/* that of a part of the curve, which is not the model's error unless that is as large as any */
	if (!status && early.called && early.sought && !model->exact.functions && !cli_interrupted() &&
	    model->error.fixed.estimated < 1.0) {
		hawser_frf_clear(&frf);
		options.step_max = longest;
		options.progress = (struct hawser_progress){judge_early, &early};
		early.sought = early.called = 0;
		status = judge(&frf, model, &options, report);
	}
	hawser_frf_clear(&frf);
	cli_progress_end(&watch.progress);
	if (status || !model->exact.functions)
		return status;
	return cli_basis_check(model, fmax(from, to), report);
}

void cli_exact_range_comments(struct hawser__table *table, const struct cli_model *model)
{
	cli_exact_comment(table, model);
	cli_fixed_comments(table, &model->error, 0);
}

void cli_exact_range_warn(const struct cli_model *model)
{
	if (model->rom.n > 0)
		cli_known_warn(model, model->error.to);
	cli_fixed_warn(&model->error);
	cli_exact_warn(model);
}

const struct hawser__field cli_exact_field[] = {
	{"", NULL, "", HAWSER__PART_OF(struct cli_model, error, cli_fixed_field)},
	HAWSER__END,
};

static int unfinished(char *text, size_t size, const struct cli_model *model)
{
	if (model->exact.until > 0.0)
		snprintf(text, size, "range: the exact energy, which these motions call for, is followed up to "
		         "%.9g%s: %s", model->exact.until, cli_unit(model, " rad/s"), model->exact.rest);
	return model->exact.until > 0.0;
}

void cli_exact_comment(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_exact *exact = &model->exact;
	char text[CLI_WARNING_SIZE];

	if (unfinished(text, sizeof text, model))
		hawser__table_comment(table, "%s", text);
	if (exact->failed[0])
		hawser__table_comment(table, "the exact energy was called for, and not taken: %s",
		                      exact->failed);
	if (!exact->functions)
		return;
	hawser__table_comment(table, "exact energy on %d functions a component, %d coordinates, in place "
	                      "of the model's %d modes", exact->functions, exact->coordinates,
	                      exact->modes);
	if (isnan(exact->before))
		hawser__table_comment(table, "with an energy of degree 4 and these modes there is no answer");
	else if (!hawser_accuracy_truncated(exact->beyond))
		hawser__table_comment(table, "the modes that are left out make the motion of the others off by "
		                      "%s%.2g (model.energy: quartic takes it all the same)",
		                      exact->before < 1.0 ? "about " : "more than ", exact->before);
	else
		hawser__table_comment(table, "with an energy of degree 4 the motion is off by about %.2g with "
		                      "any number of modes (model.energy: quartic takes it all the same)",
		                      exact->beyond);
}

void cli_exact_warn(const struct cli_model *model)
{
	char text[CLI_WARNING_SIZE];

	if (unfinished(text, sizeof text, model))
		cli_caution("a part of the range", text);
	if (!model->exact.failed[0])
		return;
	snprintf(text, sizeof text, "the exact energy was called for, and not taken: %s",
	         model->exact.failed);
	cli_warn(text);
}

/* cli/curves/cmd_folds.c - hawser folds: the folds of the frequency response followed in
 * frequency and load. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/curves/folds_result.h"
#include "cli/model/label.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *method, *label;
	double load_from, load_to, tolerance;
	int n, points, no_isolas, starts, unstable;
};
static const struct settings defaults = {
	.method = "balance", .load_from = 0.01, .load_to = 2.0,
	.starts = -1, .unstable = 2,
};
/* Of cli_exact_range: of a footbridge 9, and 1 or more for each of the starts, which are therefore
 * left out of a search with the exact energy that nobody asked for. */
static const double work = 10.0, work_start = 1.0;

static const struct cli_option options[] = {
	CLI_RANGE_OPTIONS("end of the range at which responses begin (0.6w1)",
	                  "the other end of the range (3.3w1)"),
	{"load-from", 0, "FACTOR", "smallest load, as a factor of the model's own (0.01)",
	 CLI_POSITIVE(load_from)},
	{"load-to", 0, "FACTOR", "largest load, as a factor of the model's own (2)",
	 CLI_POSITIVE(load_to)},
	CLI_MODES_OPTION,
	CLI_TEXT_OPTION(method, "NAME",
	                "method for the responses: balance, shooting or auto (balance)"),
	{"unstable", 0, "N", "end responses at other loads where more than N multipliers are unstable (2)",
	 CLI_INTEGER(unstable)},
	{"from-label", 0, "FILE#LABEL", "only of the response through this label of a JSON result of frf",
	 CLI_TEXT(label), .excludes = "no-isolas, starts, unstable"},
	CLI_HEADING("Detached curves"),
	{"no-isolas", 0, "", "do not trace detached curves at the model's own load",
	 CLI_FLAG(no_isolas)},
	{"starts", 0, "N", "look for detached curves from N pseudo-random motions too; 0: none (96)",
	 CLI_STORED(cli_store_every, starts)},
	CLI_HEADING("Steps"),
	CLI_TOLERANCE_OPTION("residual and truncation error, relative to the orbit (1e-7; 1e-9 of files)"),
	CLI_POINTS_OPTION("end a curve or response after this many points (5000)"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Follows every fold of the frequency response in forcing frequency and load, and locates the",
	"cusps, at whose load jumps begin, and the loads at which isolas, closed response curves,",
	"appear or join others. Traces the detached curves at the model's own load.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	NULL,
};

static enum hawser_status trace(struct hawser_folds *folds, const struct settings *settings,
                                const struct cli_folds_result *result,
                                const struct hawser_frf_options *first,
                                struct hawser_report *report)
{
	struct cli_watch watch = {.progress = {.quiet = settings->common.quiet}};
	struct hawser_folds_options choice = {.method = NULL};
	int meaningless = cli_exact_failed(result->model, &result->model->error);
	enum hawser_status status;

	choice.from = result->from;
	choice.to = result->to;
	choice.load_from = settings->load_from;
	choice.load_to = settings->load_to;
	choice.method = settings->method;
	choice.tolerance = cli_tolerance(settings->tolerance, result->model);
	if (settings->points > 0)
		choice.max_points = settings->points;
	else
		choice.most_work = cli_exact_allowed(result->model);
	choice.first = first;
	choice.most_unstable = settings->unstable;
	choice.skip_isolas = settings->no_isolas;
	if (settings->starts >= 0 || result->model->exact.functions || meaningless)
		choice.starts = settings->starts > 0 ? settings->starts : HAWSER_NONE;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_folds_trace(folds, &result->model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

/* The motion of --from-label; along [2n] is used at a fold. */
static enum hawser_status open_label(struct cli_label *label, struct hawser_frf_options *first,
                                     double **along, const struct settings *settings,
                                     const struct cli_folds_result *result,
                                     struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	enum hawser_status status = cli_label_open(label, "from-label", settings->label, NULL, model,
	                                           &settings->common, report);

	if (!status && label->period > 1)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "folds",
		                      "--from-label %s: that motion has %d periods of the load: hawser locus "
		                      "--over factor.load follows the folds of its response", settings->label,
		                      label->period);
	*first = (struct hawser_frf_options){.from = result->from, .to = result->to};
	*along = status ? NULL : calloc(2*(size_t)model->rom.n, sizeof **along);
	if (!status && !*along)
		status = hawser__no_memory(report, "folds");
	return status ? status
	       : cli_label_begin(first, *along, label, NULL, model, settings->label, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct hawser_folds folds = {0};
	struct cli_model model = {0};
	struct cli_folds_result result = {.common = &settings->common, .model = &model,
	                                  .folds = &folds, .load_from = settings->load_from,
	                                  .load_to = settings->load_to, .label = settings->label};
	struct cli_label label = {.state = NULL};
	struct hawser_frf_options first;
	double *along = NULL;
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	if (!status)
		status = cli_label_exact(&model, settings->label, report);
	if (!status)
		status = cli_range(&result.from, &result.to, settings->from, settings->to, "folds", &model,
		                   report);
	if (!status)
		status = cli_basis_check(&model, fmax(result.from, result.to), report);
	if (!status)
		status = cli_exact_range(&model, result.from, result.to,
		                         work + work_start*fmax(settings->starts, 0.0), &settings->common,
		                         report);
	if (!status)
		cli_exact_range_warn(&model);
	if (!status)
		status = cli_choice_build(&model, result.from, result.to, report);
	if (!status && settings->label)
		status = open_label(&label, &first, &along, settings, &result, report);
	if (!status)
		status = trace(&folds, settings, &result, label.state ? &first : NULL, report);
	if (!status) {
		cli_exact_costly(&model, folds.costly);
		cli_range_warn(&model, cli_range_reach(NULL, &model, folds.coordinate, folds.points,
		                                       model.rom.n));
		status = cli_show(&settings->common, &cli_folds_showing, &result, report);
	}
	free(along);
	cli_label_clear(&label);
	hawser_folds_clear(&folds);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_folds = {
	"folds", "SCENE|MODEL", "Folds in frequency and load: where jumps begin, isolas", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_folds_listing,
	.takes = CLI_FORCED | CLI_MODELS,
};

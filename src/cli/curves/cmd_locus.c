/* cli/curves/cmd_locus.c - hawser locus: bifurcations followed in frequency and another parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/curves/frf_over.h"
#include "cli/curves/locus_result.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "cli/model/label.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *kind, *over, *and, *Omega, *at, *near, *label;
	double tolerance, step;
	int n, points, harmonic;
};
static const struct settings defaults = {.kind = "fold"};
static const double work = 5.0; /* of cli_exact_range; chosen */

static const struct cli_option options[] = {
	CLI_TEXT_OPTION(kind, "NAME",
	                "fold, period-doubling, torus, branch-point, resonance or hopf (fold)"),
	CLI_TEXT_OPTION(over, "KEY=FROM:TO", "the other parameter, and its range (factor.load=0.5:2)"),
	CLI_RANGE_OPTIONS("end of the range at which the response begins (0.6w1)",
	                  "the other end of the range (3.3w1)"),
	CLI_MODES_OPTION,
	CLI_LIBRARY_OPTION,
	CLI_HEADING("Parameters, and where curves begin"),
	CLI_TEXT_WITH(and, "KEY=FROM:TO", "a parameter instead of the frequency, and its range",
	              .excludes = "from, to, near"),
	CLI_TEXT_WITH(Omega, "FREQUENCY", "of the load, with --and", .needs = "and"),
	CLI_TEXT_OPTION(at, "VALUE", "of the parameter where the curves begin (the model's own)"),
	{"from-label", 0, "FILE#LABEL", "the response goes through this label of a JSON result of frf",
	 CLI_TEXT(label), .excludes = "and, at"},
	CLI_TEXT_OPTION(near, "FREQUENCY", "only the bifurcation next to it (all in the range)"),
	{"harmonic", 0, "K", "of load and motion, of --kind resonance (the load's lowest)",
	 CLI_COUNT(harmonic)},
	CLI_HEADING("Steps"),
	CLI_TOLERANCE_OPTION("residual and truncation error, relative to the orbit (1e-9)"),
	{"step", 0, "NUMBER", "longest step, as a part of both ranges (0.02)", CLI_POSITIVE(step)},
	CLI_POINTS_OPTION("end a curve after this many points (2000)"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Follows bifurcations of the frequency response in the forcing frequency and another parameter,",
	"as factor.load, factor.damping or a key of the scene, and names their special points. With",
	"--kind resonance the motions that lag the load by 90 degrees: the damped backbone. Without a",
	"load, bifurcations of equilibria and of limit cycles in the two parameters --over and --and.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	NULL,
};

static enum hawser_status kind_of(enum hawser_event_kind *kind, const char *name,
                                  struct hawser_report *report)
{
	for (int k = HAWSER_FOLD; k <= HAWSER_HOPF; k++)
		if ((k <= HAWSER_BRANCH_POINT || k >= HAWSER_RESONANCE) &&
		    strcmp(name, hawser_event_name((enum hawser_event_kind)k)) == 0) {
			*kind = (enum hawser_event_kind)k;
			return HAWSER_OK;
		}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
	                    "--kind %s: write fold, period-doubling, torus, branch-point, resonance or "
	                    "hopf", name);
}

/* The parameter where the curves begin: --at, else the model's own value, else the first end. */
static enum hawser_status start_of(double *at, const struct cli_over *over, const char *text,
                                   const struct cli_model *model, struct hawser_report *report)
{
	const char *key = over->axis.key;
	double low = over->axis.from, high = over->axis.to, own = 1.0;
	char *end;

	if (text) {
		*at = strtod(text, &end);
		if (end == text || *end)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
			                    "--at %s: write a number, in SI units", text);
		return HAWSER_OK;
	}
	if (cli_over_needs_scene(key) &&
	    (!model->has_scene || hawser_scene_get(&model->scene, &own, key, NULL)))
		own = NAN;
	for (int i = 0; over->file && i < model->source.parameters; i++)
		if (strcmp(model->source.parameter[i].name, key) == 0)
			own = model->source.parameter[i].value;
	*at = own >= low && own <= high ? own : over->from;
	return HAWSER_OK;
}

static enum hawser_status trace(struct hawser_locus *locus, const struct settings *settings,
                                const struct cli_locus_result *result, const struct cli_over *over,
                                const struct hawser_rom_plane *plane,
                                const struct hawser_frf_options *first, int periods,
                                struct cli_model *model, struct hawser_report *report)
{
	struct cli_watch watch = {.progress = {.quiet = settings->common.quiet}};
	struct hawser_locus_options choice = {.from = result->from, .to = result->to,
		.parameter_from = over->from, .parameter_to = over->to, .max_points = settings->points,
		.plane = plane, .harmonic = settings->harmonic, .first = first, .periods = periods};
	double near = 0.0;
	enum hawser_status status = kind_of(&choice.kind, settings->kind, report);

	if (!status)
		status = start_of(&choice.at, over, settings->at, model, report);
	if (!status && settings->near)
		status = cli_map_frequency(&near, settings->near, "near", model, report);
	if (status)
		return status;
	choice.near = near/cli_per_omega(model);
	if (settings->points == 0)
		choice.most_work = cli_exact_allowed(model);
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->step > 0.0)
		choice.step_max = settings->step;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_locus_trace(locus, &over->family, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

/* The motion of --from-label; along [2n] is used at a fold. */
static enum hawser_status open_label(struct cli_label *label, struct hawser_frf_options *first,
                                     double *along, const struct settings *settings,
                                     const struct cli_locus_result *result,
                                     struct hawser_report *report)
{
	enum hawser_status status = cli_label_open(label, "from-label", settings->label, NULL,
	                                           result->model, &settings->common, report);

	*first = (struct hawser_frf_options){.from = result->from, .to = result->to};
	return status ? status : cli_label_begin(first, along, label, NULL, result->model, settings->label,
	                                         report);
}

static int factor_of(const struct cli_over *over)
{
	for (int k = HAWSER_FACTOR_LOAD; k <= HAWSER_FACTOR_DAMPING; k++)
		if (!cli_over_needs_scene(over->axis.key) &&
		    strcmp(over->axis.key + strlen("factor."), hawser_factor_name((enum hawser_factor)k)) == 0)
			return k;
	return -1;
}

/* The models over --and (first) and --over (second), at --Omega. */
static enum hawser_status open_plane(struct hawser_rom_plane *plane, struct cli_over *first,
                                     const struct cli_over *second, const struct settings *settings,
                                     struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = cli_over_open(first, settings->and, settings->Omega, model, report);
	const char *const key[] = {first->axis.key, second->axis.key};
	const double from[] = {first->from, second->from}, to[] = {first->to, second->to};

	if (status)
		return status;
	if (strcmp(first->axis.key, second->axis.key) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    "--over and --and are both over %s: name two parameters",
		                    first->axis.key);
	if (factor_of(first) >= 0)
		return hawser_plane_open(plane, &second->family, (enum hawser_factor)factor_of(first), 0,
		                         report);
	if (factor_of(second) >= 0)
		return hawser_plane_open(plane, &first->family, (enum hawser_factor)factor_of(second), 1,
		                         report);
	if (first->file)
		return hawser_parameter_plane_open(plane, &model->source, key, first->omega, report);
	return hawser_scene_plane_open(plane, &model->scene, key, from, to, from, first->omega, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct hawser_locus locus = {0};
	struct cli_model model = {0};
	struct cli_over over = {.at = NAN}, other = {.at = NAN};
	struct cli_label label = {.state = NULL};
	struct hawser_frf_options first;
	double *along = NULL;
	struct hawser_rom_plane plane = {.context = NULL};
	struct cli_locus_result result = {.common = &settings->common, .model = &model, .locus = &locus};
	enum hawser_status status = cli_outputs_check(&settings->common, report);
	int own;

	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	own = !status && hawser_rom_autonomous(&model.rom);
	if (!status && settings->and && !settings->Omega && !own)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                      "--and needs --Omega FREQUENCY: give that");
	if (own && !settings->and)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                      "nothing excites the model: give its two parameters with --over "
		                      "KEY=FROM:TO and --and KEY=FROM:TO");
	if (!status && !own)
		status = cli_range(&result.from, &result.to, settings->from, settings->to, "locus", &model,
		                   report);
	if (!status && !own)
		status = cli_basis_check(&model, fmax(result.from, result.to), report);
	if (!status && !settings->and)
		status = cli_exact_range(&model, result.from, result.to, work, &settings->common, report);
	if (!status)
		cli_exact_range_warn(&model);
	if (!status && settings->label && !(along = calloc(2*(size_t)model.rom.n, sizeof *along)))
		status = hawser__no_memory(report, "locus");
	if (!status && settings->label)
		status = open_label(&label, &first, along, settings, &result, report);
	if (!status)
		status = cli_over_open(&over, settings->over ? settings->over : "factor.load=0.5:2",
		                       settings->Omega ? settings->Omega : "1", &model, report);
	if (!status) {
		result.key = over.axis.key;
		result.unit = over.axis.unit;
		result.parameter_from = over.from;
		result.parameter_to = over.to;
	}
	if (!status && settings->and)
		status = open_plane(&plane, &other, &over, settings, &model, report);
	if (!status && settings->and) {
		result.first = other.axis.key;
		result.first_unit = other.axis.unit;
		result.from = other.from;
		result.to = other.to;
		result.omega = other.omega;
	}
	if (!status)
		status = trace(&locus, settings, &result, &over, settings->and ? &plane : NULL,
		               settings->label ? &first : NULL, label.period, &model, report);
	if (!status) {
		cli_exact_costly(&model, locus.costly);
		cli_range_warn(&model, cli_range_reach(NULL, &model, locus.coordinate, locus.points,
		                                       model.rom.n));
		status = cli_show(&settings->common, &cli_locus_showing, &result, report);
	}
	free(along);
	cli_label_clear(&label);
	hawser_locus_clear(&locus);
	hawser_plane_close(&plane);
	cli_over_clear(&other);
	cli_over_clear(&over);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_locus = {
	"locus", "SCENE|MODEL", "Bifurcations in frequency and another parameter", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_locus_listing,
	.takes = CLI_FORCED | CLI_MODELS,
};

/* cli/backbone/cmd_nnm.c - hawser nnm: nonlinear normal modes over energy and frequency.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/model/axis.h"
#include "cli/backbone/backbone.h"
#include "cli/backbone/nnm_result.h"
#include "cli/frame/progress.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to;
	double energy, tolerance, step;
	int n, mode, quadrature, branches, periods, points;
};
static const struct settings defaults = {.mode = 1, .from = NULL};

static const struct cli_option options[] = {
	{"mode", 0, "J", "the mode at which the motions begin (1)", CLI_INTEGER(mode)},
	CLI_RANGE_OPTIONS("end of the range of frequencies (a quarter of the mode's)",
	                  "the other end (four times the mode's)"),
	{"energy-to", 0, "ENERGY", "largest energy in J (see the manual page)", CLI_POSITIVE(energy)},
	{"branches", 0, "DEPTH", "follow what begins at branch points, to this depth",
	 CLI_INTEGER(branches)},
	CLI_MODES_OPTION,
	CLI_HEADING("Further motions"),
	{"quadrature", 0, "K", "whirl: begin in mode K too, of the same frequency",
	 CLI_INTEGER(quadrature)},
	{"periods", 0, "K", "look for motions of up to K periods (1)", CLI_INTEGER(periods)},
	CLI_HEADING("Steps"),
	CLI_TOLERANCE_OPTION("defect and truncation error, relative to the orbit (1e-9)"),
	{"step", 0, "NUMBER", "longest step, relative to the motion (0.05)", CLI_POSITIVE(step)},
	CLI_POINTS_OPTION("end a curve after this many points (1000)"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Free periodic motions of the model without damping and load, from a linear mode to large",
	"energies, with the branches at internal resonances. Frequency over energy: --plot.",
	NULL,
};

static enum hawser_status trace(struct hawser_nnm *nnm, const struct settings *settings,
                                struct cli_model *model, struct hawser_report *report)
{
	struct cli_watch watch = {.progress = {.quiet = settings->common.quiet}};
	struct hawser__scale scale = cli_scale(model);
	struct hawser_nnm_options choice = {.mode = settings->mode - 1, .depth = settings->branches,
		.quadrature = settings->quadrature, .periods = settings->periods,
		.max_points = settings->points};
	enum hawser_status status = HAWSER_OK;

	if (settings->mode > model->rom.n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "nnm",
		                    "--mode %d: the model has modes 1 to %d", settings->mode, model->rom.n);
	if (settings->from || settings->to) {
		double w = model->rom.n > 0 ? sqrt(model->rom.K[(size_t)(settings->mode - 1)*
		                                                ((size_t)model->rom.n + 1)]) : 0.0;

		choice.lo = 0.25*w;
		choice.hi = 4.0*w;
		if (settings->from)
			status = cli_map_frequency(&choice.lo, settings->from, "from", model, report);
		if (!status && settings->to)
			status = cli_map_frequency(&choice.hi, settings->to, "to", model, report);
		if (status)
			return status;
		choice.lo /= settings->from ? cli_per_omega(model) : 1.0;
		choice.hi /= settings->to ? cli_per_omega(model) : 1.0;
		if (choice.lo > choice.hi) {
			double swap = choice.lo;

			choice.lo = choice.hi;
			choice.hi = swap;
		}
	}
	if (settings->energy > 0.0)
		choice.energy = settings->energy/hawser__in_unit(1.0, HAWSER__J, &scale);
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->step > 0.0)
		choice.step_max = settings->step;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_nnm_trace(nnm, &model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct hawser_nnm nnm = {0};
	struct cli_model model = {0};
	struct cli_nnm_result result = {.common = &settings->common, .model = &model, .nnm = &nnm,
		.mode = settings->mode - 1, .depth = settings->branches,
		.periods = settings->periods > 0 ? settings->periods : 1};
	enum hawser_status status = cli_outputs_check_scales(&settings->common, "x", report);
	double *reached = NULL;

	if (!status)
		status = cli_model_load_modal(&model, &settings->common, settings->n, report);
	if (!status)
		status = trace(&nnm, settings, &model, report);
	for (int k = 0; !status && k < nnm.curves; k++)
		reached = cli_range_reach(reached, &model, nnm.curve[k].motion.coordinate,
		                          nnm.curve[k].motion.points, model.rom.n);
	cli_range_warn(&model, reached);
	if (!status)
		status = cli_show(&settings->common, &cli_nnm_showing, &result, report);
	hawser_nnm_clear(&nnm);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_nnm = {
	"nnm", "SCENE|MODEL", "Nonlinear normal modes over energy", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_nnm_listing,
	.takes = CLI_MODELS,
};

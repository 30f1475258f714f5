/* cli/backbone/cmd_mms.c - hawser mms: resonances by the method of multiple scales.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/model/label.h"
#include "cli/backbone/backbone.h"
#include "cli/backbone/mms_result.h"
#include "cli/frame/progress.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from, *to, *resonant;
	double tolerance, step;
	int n, points, mode, superharmonic, subharmonic;
};
static const struct settings defaults = {.step = CLI_STEP};

static const struct cli_option options[] = {
	{"mode", 0, "J", "resonant mode (the one that the load drives the most)", CLI_INTEGER(mode)},
	CLI_TEXT_WITH(resonant, "LIST", "several resonant modes, as mode:order: 1:1,4:2 or 1:1/2,4:1",
	              .excludes = "mode, superharmonic, subharmonic"),
	CLI_RANGE_OPTIONS("one end of the range (chosen about the resonance)", "the other end"),
	CLI_MODES_OPTION,
	CLI_HEADING("Other resonances"),
	{"superharmonic", 0, "K", "the mode resonates at K (2 or 3) times the load's frequency",
	 CLI_COUNT(superharmonic), .most = 3, .excludes = "subharmonic"},
	{"subharmonic", 0, "K", "the mode resonates at 1/K (K: 2 or 3) of the load's frequency",
	 CLI_COUNT(subharmonic), .most = 3},
	CLI_HEADING("Steps"),
	CLI_TOLERANCE_OPTION("relative tolerance of equilibria (1e-9)"),
	CLI_STEP_OPTION,
	CLI_POINTS_OPTION("points of the closed form (400); most points of other curves (20000)"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"For one mode at primary resonance: response curve, peak, folds and backbone in closed form, with",
	"the second-order response of all modes (drift, second harmonic). For several modes and for super-",
	"and subharmonic resonance: the modulation equations of the model, and their equilibria.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	NULL,
};

static double natural_of(const struct hawser_rom *rom, int j)
{
	return sqrt(fmax(rom->K[(size_t)j*((size_t)rom->n + 1)], 0.0));
}

/* --- what was asked for --- */

static enum hawser_status range(struct cli_mms_result *result, const struct settings *settings,
                                double centre, double half, struct hawser_report *report)
{
	const struct cli_mms_range range = {centre, half, settings->from, settings->to};

	return cli_mms_range(&result->from, &result->to, &range, result->model, report);
}

static enum hawser_status load_model(struct cli_model *model, const struct settings *settings,
                                     struct hawser_report *report)
{
	enum hawser_status status = cli_model_load_modal(model, &settings->common, settings->n, report);
	double from = 0.0, to = 0.0;

	if (status || !model->automatic)
		return status;
	from = 0.8*model->natural[settings->mode > 0 && settings->mode <= model->naturals
	                          ? settings->mode - 1 : 0];
	to = 1.5*from;
	if (settings->from)
		status = cli_frequency(&from, settings->from, "from", model, report);
	if (!status && settings->to)
		status = cli_frequency(&to, settings->to, "to", model, report);
	return status ? status : cli_choice_build(model, from, to, report);
}

/* --- results --- */

/* The nearest mode, from 1, that lies within the reach of the peak: at one to one it may move too, as
 * where a stay whirls. 0: there is none. */
static int twin(const struct hawser_primary *primary, const struct hawser_rom *rom)
{
	const double near = 0.1; /* of its frequency: beyond, no resonance of one to one; chosen */
	double reach = fmin(fabs(primary->peak_omega - primary->omega) + primary->damping,
	                    near*primary->omega);
	int found = 0;

	for (int k = 0; k < rom->n; k++)
		if (k != primary->mode && fabs(natural_of(rom, k) - primary->omega) < reach) {
			found = k + 1;
			reach = fabs(natural_of(rom, k) - primary->omega);
		}
	return found;
}

/* A second mode that the closed form leaves out although it takes part. */
static void warn_of_rival(const struct hawser_primary *primary, const struct hawser_rom *rom)
{
	char text[320];
	double strength;
	int m = primary->mode + 1, j = hawser_primary_rival(&strength, primary, rom) + 1;
	double ratio = j ? natural_of(rom, j - 1)/primary->omega : 0.0;

	if (!j && !(j = twin(primary, rom)))
		return;
	if (ratio == 0.0)
		snprintf(text, sizeof text, "mode %d has %.5g times the frequency of mode %d, by which it may "
		         "move too (one to one), and the closed form and its column stable leave it out: "
		         "hawser frf with --branches 1 follows both", j,
		         natural_of(rom, j - 1)/primary->omega, m);
	else if (ratio > 1.0)
		snprintf(text, sizeof text, "mode %d, at %.4g times the frequency of mode %d, takes part by a "
		         "resonance of two to one, and the closed form leaves it out: hawser mms "
		         "--resonant %d:1,%d:2 has both, hawser frf the whole model", j, ratio, m, m, j);
	else
		snprintf(text, sizeof text, "mode %d, at %.4g times the frequency of mode %d, begins to move "
		         "at half the forcing frequency from %.3g of the peak on, and the closed form leaves "
		         "it out: hawser frf with --branches 1 follows both", j, ratio, m, 1.0/strength);
	cli_warn(text);
}

static enum hawser_status closed_form(struct cli_mms_result *result, struct cli_model *model,
                                      const struct settings *settings,
                                      struct hawser_report *report)
{
	struct hawser_primary primary = {0};
	struct hawser_primary_curve curve = {.amplitude = NULL};
	int mode;
	enum hawser_status status = cli_mms_mode(&mode, settings->mode, &result->model->rom, report);

	if (!status)
		status = hawser_primary_derive(&primary, &result->model->rom, mode, report);
	if (!status)
		status = range(result, settings, primary.omega,
		               2.0*fabs(primary.peak_omega - primary.omega) + 15.0*primary.damping, report);
	if (!status)
		status = hawser_primary_trace(&curve, &primary, result->from, result->to,
		                              settings->points ? settings->points : 400, report);
	if (!status && curve.frf.points < 2)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "mms",
		                      "the range has no point of the curve: widen it");
	result->primary = &primary;
	result->curve = &curve;
	result->modulation = &primary.modulation;
	if (!status)
		status = cli_exact_range(model, result->from, result->to, -1.0, result->common, report);
	if (!status) {
		cli_exact_range_warn(model);
		warn_of_rival(&primary, &model->rom);
		cli_range_warn(model, cli_range_reach(NULL, model, curve.frf.coordinate, curve.frf.points,
		                                      model->rom.n));
		status = cli_show(result->common, &cli_mms_showing, result, report);
	}
	result->primary = NULL;
	result->curve = NULL;
	result->modulation = NULL;
	hawser_primary_curve_clear(&curve);
	hawser_primary_clear(&primary);
	return status;
}

/* Convert frequencies of the motion to those of the load. */
static void of_the_load(struct hawser_frf *frf, int base)
{
	for (int i = 0; i < frf->points; i++)
		frf->point[i].omega *= base;
	for (int k = 0; k < frf->events; k++)
		frf->event[k].omega *= base;
}

static enum hawser_status follow(struct hawser_frf *frf, const struct cli_mms_result *result,
                                 const struct hawser_modulation *modulation,
                                 const struct settings *settings, struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	struct hawser_frf_options choice = {.method = NULL};
	double *start = NULL, x[2];
	enum hawser_status status = HAWSER_OK;

	choice.method = "multiple-scales";
	choice.resonance = &modulation->resonance;
	choice.from = result->from/result->base;
	choice.to = result->to/result->base;
	choice.step_max = settings->step;
	choice.progress.function = cli_watch_silently;
	choice.samples = HAWSER_NONE; /* hawser compare mms states the distances */
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->points > 0)
		choice.max_points = settings->points;
	if (result->base > 1 && modulation->resonance.count == 1) {
		start = calloc(2*(size_t)rom->n, sizeof *start);
		status = start ? hawser_subharmonic_start(modulation, x, &choice.begin, choice.from,
		                                          choice.to,
		                                          report) : hawser__no_memory(report, "mms");
		/* to first order: the method reads only the resonant part of a state */
		if (!status) {
			start[modulation->resonance.mode[0]] = 2.0*x[0];
			start[rom->n + modulation->resonance.mode[0]] = -2.0*choice.begin*x[1];
			if (choice.begin == choice.to) { /* inwards */
				choice.to = choice.from;
				choice.from = choice.begin;
			}
		}
		choice.start = start;
	}
	if (!status)
		status = hawser_frf_trace(frf, rom, &choice, report);
	of_the_load(frf, result->base);
	free(start);
	return status;
}

static enum hawser_status equilibria(struct cli_mms_result *result, struct cli_model *model,
                                     const struct settings *settings, struct hawser_report *report)
{
	struct hawser_rom *rom = &model->rom;
	struct hawser_resonance resonance = {.count = 1};
	struct hawser_modulation modulation = {.rom = NULL};
	struct hawser_frf frf = {0};
	struct cli_frf_result drawn = {.common = result->common, .model = result->model, .frf = &frf,
	                               .command = "mms", .scales = result, .scale = "auto"};
	enum hawser_status status = HAWSER_OK;

	if (settings->resonant)
		status = cli_mms_read(&resonance, &result->base, settings->resonant, rom, report);
	else
		status = cli_mms_mode(&resonance.mode[0], settings->mode, rom, report);
	if (!settings->resonant) {
		resonance.order[0] = settings->superharmonic ? settings->superharmonic : 1;
		resonance.omega0 = status ? 1.0 : natural_of(rom, resonance.mode[0])/resonance.order[0];
	}
	if (settings->subharmonic)
		result->base = settings->subharmonic;
	if (!status)
		status = hawser_subharmonic_base(rom, result->base, report);
	if (!status)
		status = hawser_modulation_derive(&modulation, rom, &resonance, report);
	if (!status)
		status = range(result, settings, result->base*resonance.omega0,
		               0.1*result->base*resonance.omega0, report);
	if (!status)
		status = follow(&frf, result, &modulation, settings, report);
	result->modulation = &modulation;
	drawn.from = result->from;
	drawn.to = result->to;
	drawn.direction = cli_frf_direction(&frf);
	drawn.label_every = 10;
	if (!status)
		cli_label_all(&drawn);
	if (!status) {
		cli_range_warn(model, cli_range_reach(NULL, model, frf.coordinate, frf.points, model->rom.n));
		status = cli_show(result->common, &cli_frf_showing, &drawn, report);
	}
	result->modulation = NULL;
	hawser_frf_clear(&frf);
	hawser_modulation_clear(&modulation);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_model model = {0};
	struct cli_mms_result result = {.common = &settings->common, .model = &model, .base = 1};
	enum hawser_status status = cli_outputs_check(&settings->common, report);

	if (!status)
		status = load_model(&model, settings, report);
	if (status)
		goto done;
	if (settings->resonant || settings->superharmonic || settings->subharmonic)
		status = equilibria(&result, &model, settings, report);
	else
		status = closed_form(&result, &model, settings, report);
done:
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_mms = {
	"mms", "SCENE|MODEL", "Resonances by multiple scales: closed forms, modulation equations",
	        notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_mms_listing,
	.takes = CLI_MODELS,
};

/* cli/curves/frf_over.c - see frf_over.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/model/made.h"
#include "core/report.h"

static const char *const factor[] = {"factor.load", "factor.damping"}; /* enum hawser_factor */
enum { FACTORS = sizeof factor/sizeof *factor };

int cli_over_needs_scene(const char *text)
{
	return strncmp(text, "factor.", 7) != 0;
}

static enum hawser_status open_family(struct cli_over *over, struct cli_model *model,
                                      struct hawser_report *report)
{
	const char *key = over->axis.key;

	for (int k = 0; k < FACTORS; k++)
		if (strcmp(key, factor[k]) == 0) {
			over->close = hawser_factor_close;
			return hawser_factor_open(&over->family, &model->rom, (enum hawser_factor)k,
			                          over->omega, report);
		}
	if (strncmp(key, "model.", 6) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over %s: settings of the model are no parameters of the cable: "
		                    "hawser compare compares models", key);
	if (!cli_over_needs_scene(key) || strcmp(key, "Omega") == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over %s: write factor.load, factor.damping or a key of the scene; "
		                    "Omega is followed without --over", key);
	if (model->made && model->made->by->family)
		return model->made->by->family(&over->family, &over->close, model->made, key,
		                               (double[2]){fmin(fmin(over->from, over->to), over->at),
		                                           fmax(fmax(over->from, over->to), over->at)},
		                               isnan(over->at) ? over->from : over->at, over->omega, report);
	if (model->made)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over %s: %s has the parameters factor.load and factor.damping only",
		                    key, model->made->by->called);
	if (!model->has_scene && model->source.parameters == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over %s: this reduced-model file has the parameters factor.load and "
		                    "factor.damping only: give the scene, or name parameters in the file", key);
	if (!model->has_scene) {
		over->file = 1;
		over->close = hawser_parameter_close;
		return hawser_parameter_open(&over->family, &model->source, key, over->omega, report);
	}
	over->close = hawser_scene_family_close;
	return hawser_scene_family_open(&over->family, &model->scene, key,
	                                fmin(fmin(over->from, over->to), over->at),
	                                fmax(fmax(over->from, over->to), over->at),
	                                isnan(over->at) ? over->from : over->at, over->omega, report);
}

static int any(const double *value, size_t count)
{
	for (size_t i = 0; value && i < count; i++)
		if (value[i] != 0.0)
			return 1;
	return 0;
}

/* Whether any load of the model has the frequency of the load or a multiple of it. */
static int is_driven(const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n;

	for (int i = 0; i < rom->harmonics; i++) {
		const struct hawser_harmonic *h = &rom->harmonic[i];

		if (h->k > 0 && (h->quads || h->terms || any(h->f, n) || any(h->D, n*n) || any(h->K, n*n) ||
		                 any(h->answer, 8*(size_t)rom->shapes.points)))
			return 1;
	}
	return rom->harmonics == 0;
}

/* Harmonics that are 0 over the whole range make no motion of their frequency: a model moves by itself
 * then, and its Hopf points would be sought among the multipliers of a period that is not its own. */
static enum hawser_status check_driven(const struct cli_over *over, struct hawser_report *report)
{
	const double end[2] = {over->from, over->to};

	for (int i = 0; i < 2; i++) {
		const struct hawser_rom *rom;

		if (over->family.model(over->family.context, &rom, end[i], NULL) || is_driven(rom) ||
		    hawser_rom_autonomous(rom))
			return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf", "--over %s: the load is 0 at both ends of "
	                    "the range, so that nothing has the frequency --Omega: leave the load and "
	                    "--Omega out, and equilibria are followed", over->axis.key);
}

enum hawser_status cli_over_open(struct cli_over *over, const char *text, const char *frequency,
                                 struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status;
	double label = over->omega;

	if (!frequency && !(over->omega > 0.0) && !hawser_rom_autonomous(&model->rom))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over %s follows the motion at one frequency: give it with --Omega",
		                    text);
	if (model->automatic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--over: model.modes: auto chooses for a range of frequencies: give a "
		                    "number of modes with -n");
	status = cli_map_axis(&over->axis, "over", text, model, report);
	if (!status && frequency)
		status = cli_map_frequency(hawser_rom_autonomous(&model->rom) ? &over->guess : &over->omega,
		                           frequency, "Omega", model, report);
	if (!status && label > 0.0 && fabs(over->omega - label) > 1e-9*label)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                      "--Omega %s: the motion of the label is at Omega = %.9g: leave --Omega "
		                      "out, or take a label there", frequency, label);
	if (status)
		return status;
	over->from = over->axis.backwards ? over->axis.to : over->axis.from;
	over->to = over->axis.backwards ? over->axis.from : over->axis.to;
	status = open_family(over, model, report);
	over->open = !status;
	return status || !(over->omega > 0.0) ? status : check_driven(over, report);
}

enum hawser_status cli_over_check(const struct cli_over *over, int goes_on,
                                  struct hawser_report *report)
{
	return over->guess == 0.0 || goes_on ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                      "--Omega: nothing excites the model, and rest has no frequency: leave it "
	                      "out; limit cycles begin with --branches 1, or with --start FILE");
}

void cli_over_clear(struct cli_over *over)
{
	if (over->open)
		over->close(&over->family);
	free(over->axis.copy);
	*over = (struct cli_over){.open = 0};
}

enum hawser_status cli_over_load(struct cli_model *model, const struct cli_common *from, int n,
                                 const char *over, struct hawser_report *report)
{
	struct cli_common common = *from;
	enum hawser_status status = cli_model_load(model, &common, n, report);

	if (status || !over || !cli_over_needs_scene(over) || model->made ||
	    model->rom.inertia.shapes == 0 || common.sets == CLI_SETS)
		return status;
	common.set[common.sets++] = "model.inertia=none";
	cli_model_clear(model);
	*model = (struct cli_model){.has_scene = 0};
	return cli_model_load(model, &common, n, report);
}

/* cli/model/model.c - the model of the scene or reduced-model file of the command line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/model/made.h"
#include "core/append.h"
#include "core/report.h"

/* Number of listed modes if the program chooses the modes. */
static const int listed = 12;

static enum hawser_status load_scene(struct hawser_scene *scene, const struct cli_common *common, int n,
                                     struct hawser_report *report)
{
	const char *set[CLI_SETS + 1];
	const struct hawser_document *document;
	char modes[32];
	int sets = common->sets;
	enum hawser_status status = cli_document(&document, common, report);

	memset(scene, 0, sizeof *scene);
	memcpy(set, common->set, (size_t)sets*sizeof *set);
	if (n > 0) {
		snprintf(modes, sizeof modes, "model.modes=%d", n);
		set[sets++] = modes;
	}
	if (!status)
		status = hawser_scene_of(scene, document, set, (size_t)sets, report);
	if (!status)
		cli_warn_doubts(scene);
	return status;
}

/* Only hawser beam and hawser map accept beams. */
static enum hawser_status refuse_beam(struct hawser_scene *scene, const struct cli_common *common,
                                      struct hawser_report *report)
{
	const char *name = cli_input_name(common);

	if (!scene->beam.form)
		return HAWSER_OK;
	hawser_scene_clear(scene);
	return hawser__fail(report, HAWSER_ERR_SCENE, "model",
	                    "%s is a scene of a beam: that is for hawser beam", name);
}

enum hawser_status cli_scene_load(struct hawser_scene *scene, const struct cli_common *common,
                                  int n, struct hawser_report *report)
{
	enum hawser_status status = load_scene(scene, common, n, report);

	return status ? status : refuse_beam(scene, common, report);
}

struct hawser_modes_options cli_modes_options(const struct hawser_scene *scene)
{
	struct hawser_modes_options options = {0};

	options.n = scene->model.modes == HAWSER_MODES_AUTO ? listed : scene->model.modes;
	options.basis = scene->model.basis;
	/* the method chooses the basis if the user gave none */
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	return options;
}

/* The full-order model. */
static enum hawser_status from_basis(struct cli_model *model, int n, struct hawser_report *report)
{
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "--modes %d: the exact energy (model.energy) is on all functions "
		                    "of a basis: say how many a component with model.basis", n);
	status = hawser_rom_build_full(&model->rom, &model->statics, &model->scene,
	                               model->scene.model.basis, report);
	return status ? status : cli_basis_check(model, 0.0, report);
}

/* How much of a model is made from a scene. */
enum extent { NOTHING, ENTRIES, WHOLE };

static enum hawser_status from_scene(struct cli_model *model, const struct cli_common *common, int n,
                                     enum extent extent, struct hawser_report *report)
{
	enum hawser_status status = load_scene(&model->scene, common, n, report);
	struct hawser_modes_options options;

	if (!status && extent != NOTHING)
		status = refuse_beam(&model->scene, common, report);
	model->has_scene = !status;
	if (extent == NOTHING) {
		if (!status && !model->scene.beam.form &&
		    !hawser_statics_scene(&model->statics, &model->scene, NULL))
			hawser_modes_settle(&model->scene, &model->statics);
		return status;
	}
	if (!status)
		status = hawser_statics_scene(&model->statics, &model->scene, report);
	if (!status) {
		hawser_modes_settle(&model->scene, &model->statics);
		cli_warn_wake(&model->scene, &model->statics);
	}
	if (!status && model->scene.model.modes == HAWSER_MODES_AUTO)
		return cli_choice_prepare(model, report);
	options = cli_modes_options(&model->scene);
	if (!status && model->scene.model.energy == HAWSER_ENERGY_EXACT)
		return from_basis(model, n, report);
	if (!status)
		status = hawser_modes_solve(&model->modes, &model->statics, &options, report);
	if (!status)
		status = extent == WHOLE || model->modes.n <= CLI_JUDGED
		         ? hawser_rom_build(&model->rom, &model->modes, &model->scene, report)
		         : hawser_rom_build_entries(&model->rom, &model->modes, &model->scene,
		                                    report);
	if (!status)
		status = cli_known(model, model->modes.mode[model->modes.n - 1].omega, report);
	return status;
}

/* The parameters of --set. */
static enum hawser_status set_parameters(struct hawser_rom_source *source,
                                         const struct cli_common *common, struct hawser_report *report)
{
	char name[32], names[160] = "", *end;

	for (int i = 0; i < source->parameters; i++)
		hawser__append(names, sizeof names, ", ", "%s", source->parameter[i].name);
	if (!*names)
		snprintf(names, sizeof names, "none");
	for (int i = 0; i < common->sets; i++) {
		const char *equals = strchr(common->set[i], '=');
		double value = strtod(equals + 1, &end);
		int known = 0;

		snprintf(name, sizeof name, "%.*s", (int)(equals - common->set[i]), common->set[i]);
		if (end == equals + 1 || *end || !isfinite(value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
			                    "--set %s: write NAME=NUMBER for a parameter of a model file",
			                    common->set[i]);
		hawser_rom_source_set(source, name, value, &known);
		if (!known)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
			                    "--set %s: %s has these parameters: %s", common->set[i],
			                    common->input, names);
	}
	return HAWSER_OK;
}

static enum hawser_status from_file(struct cli_model *model, const struct cli_common *common, int n,
                                    struct hawser_report *report)
{
	const struct hawser_document *document;
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "%s is a reduced-model file: --modes applies to scenes only",
		                    common->input);
	status = cli_document(&document, common, report);
	if (!status)
		status = hawser_rom_source_of(&model->source, document, report);
	if (!status)
		status = set_parameters(&model->source, common, report);
	if (!status)
		status = hawser_rom_source_model(&model->rom, &model->source, report);
	if (model->source.parameters == 0)
		hawser_rom_source_clear(&model->source);
	return status;
}

/* The model of a library. */
static enum hawser_status from_library(struct cli_model *model, const struct cli_common *common, int n,
                                       struct hawser_report *report)
{
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "%s is a library: --modes applies to scenes only", common->library);
	status = cli_library_open(&model->source, common->library, report);
	if (!status)
		status = set_parameters(&model->source, common, report);
	return status ? status : hawser_rom_source_model(&model->rom, &model->source, report);
}

static enum hawser_status load(struct cli_model *model, const struct cli_common *common, int n,
                               enum extent extent, struct hawser_report *report)
{
	const struct hawser_document *document;
	const struct cli_maker *maker;
	enum hawser_status status;

	memset(model, 0, sizeof *model);
	model->reproducible = common->reproducible;
	if (common->library) {
		status = from_library(model, common, n, report);
		if (!status)
			status = cli_natural(model, report);
		if (status)
			cli_model_clear(model);
		return status;
	}
	if ((status = cli_document(&document, common, report)))
		return status;
	maker = cli_kind_record(cli_kind_number(document->kind, CLI_EVERY))->maker;
	status = maker ? maker->load(model, common, n, report)
	         : document->kind == HAWSER_KIND_MODEL ? from_file(model, common, n, report)
	                                               : from_scene(model, common, n, extent, report);
	if (!status && !model->automatic && model->rom.n > 0)
		status = cli_natural(model, report);
	if (status)
		cli_model_clear(model);
	return status;
}

enum hawser_status cli_model_load(struct cli_model *model, const struct cli_common *common, int n,
                                  struct hawser_report *report)
{
	return load(model, common, n, WHOLE, report);
}

enum hawser_status cli_model_entries(struct cli_model *model, const struct cli_common *common, int n,
                                     struct hawser_report *report)
{
	return load(model, common, n, ENTRIES, report);
}

enum hawser_status cli_model_or_scene(struct cli_model *model, const struct cli_common *common,
                                      int n, struct hawser_report *report)
{
	return load(model, common, n, NOTHING, report);
}

void cli_model_clear(struct cli_model *model)
{
	if (!model)
		return;
	hawser_accuracy_clear(&model->accuracy);
	hawser_rom_clear(&model->rom);
	hawser_rom_source_clear(&model->source);
	hawser_modes_clear(&model->modes);
	hawser_scene_clear(&model->scene);
	cli_made_free(model->made);
	free(model->natural);
	memset(model, 0, sizeof *model);
}

double cli_per_length(const struct cli_model *model)
{
	return model->rom.scaled ? model->rom.length : 1.0;
}

double cli_per_omega(const struct cli_model *model)
{
	return model->rom.scaled ? 1.0/model->rom.time : 1.0;
}

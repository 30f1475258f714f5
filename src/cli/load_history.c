/* cli/load_history.c - integrate --load: a load per length that a table gives over time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "cli/load_history.h"
#include "cli/series.h"
#include "core/report.h"

enum { AXES = 3, COLUMNS = 1 + AXES };
static const char where[] = "integrate";

/* The model of the scene with this load instead of its own; NULL: without a load. */
static enum hawser_status build(struct hawser_rom *rom, const struct cli_model *model,
                                const double *load, struct hawser_report *report)
{
	struct hawser_scene scene = model->scene;

	/* shapes for the inertia of condensed modes are chosen by a harmonic load, which there is not */
	scene.model.inertia = HAWSER_INERTIA_NONE;
	scene.load.present = load != NULL;
	scene.loads = 0;
	if (load)
		memcpy(scene.load.per_length, load, sizeof scene.load.per_length);
	if (!model->scene.load.present) {
		scene.load.frame = HAWSER_FRAME_LOCAL;
		scene.load.extent[0] = 0.0;
		scene.load.extent[1] = 1.0;
	}
	return scene.model.energy == HAWSER_ENERGY_EXACT
	       ? hawser_rom_build_full(rom, &model->statics, &scene, scene.model.basis, report)
	       : hawser_rom_build(rom, &model->modes, &scene, report);
}

static enum hawser_status check(const struct cli_model *model, const char *path,
                                struct hawser_report *report)
{
	const struct hawser_scene *scene = &model->scene;
	const char *not_with = NULL;

	if (!model->has_scene)
		not_with = "a reduced-model file, which does not tell where a load acts: give a scene";
	else if (model->automatic)
		not_with = "modes: auto, which chooses for a frequency: give a number of modes (-n)";
	else if (scene->travel.present && (scene->travel.fluctuation > 0.0 || scene->travel.braking > 0.0))
		not_with = "a travel speed that changes";
	return not_with ? hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                               "--load %s does not go with %s", path, not_with)
	                : HAWSER_OK;
}

/* The models of unit loads of the columns that the table has, and their values in rows. */
static enum hawser_status collect(struct hawser_rom *unit, int *terms, double *value,
                                  double *const *column, int rows, const struct cli_model *model,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int c = 0; c < AXES && !status; c++) {
		double load[AXES] = {0.0};

		if (!column[1 + c])
			continue;
		load[c] = 1.0;
		status = build(&unit[*terms], model, load, report);
		if (status || unit[*terms].harmonics != 1) {
			if (!status)
				hawser_rom_clear(&unit[*terms]); /* it does no work on any mode */
			continue;
		}
		memcpy(value + (size_t)*terms*(size_t)rows, column[1 + c], (size_t)rows*sizeof *value);
		(*terms)++;
	}
	if (!status && *terms == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "the loads of the table do no work on any of the %d modes kept",
		                      model->rom.n);
	return status;
}

static enum hawser_status attach(struct cli_model *model, double *const *column, int rows,
                                 struct hawser_report *report)
{
	struct hawser_rom unit[AXES] = {{0}}, base;
	const struct hawser_rom *units[AXES] = {&unit[0], &unit[1], &unit[2]};
	double *value = malloc(AXES*(size_t)rows*sizeof *value);
	int terms = 0;
	enum hawser_status status = value ? build(&base, model, NULL, report)
	                                  : hawser__no_memory(report, where);

	if (!status) {
		hawser_rom_clear(&model->rom);
		model->rom = base;
		status = collect(unit, &terms, value, column, rows, model, report);
	}
	for (int i = 0; i < rows && !status; i++)
		column[0][i] /= model->rom.time;
	if (!status)
		status = hawser_rom_history_set(&model->rom, units, terms, column[0], value, rows, report);
	for (int c = 0; c < AXES; c++)
		hawser_rom_clear(&unit[c]);
	free(value);
	return status;
}

enum hawser_status cli_load_history(struct cli_model *model, const char *path,
                                    struct hawser_report *report)
{
	static const char *const names[2][COLUMNS] = {
		[HAWSER_FRAME_LOCAL] = {"t_s", "e_N_m", "n_N_m", "z_N_m"},
		[HAWSER_FRAME_GLOBAL] = {"t_s", "x_N_m", "y_N_m", "z_N_m"}};
	int global = model->scene.load.present && model->scene.load.frame == HAWSER_FRAME_GLOBAL;
	double *column[COLUMNS] = {NULL};
	int rows;
	enum hawser_status status = check(model, path, report);

	if (!status)
		status = cli_columns_read(column, &rows, path,
		                          names[global ? HAWSER_FRAME_GLOBAL : HAWSER_FRAME_LOCAL], COLUMNS,
		                          report);
	if (!status)
		status = attach(model, column, rows, report);
	for (int c = 0; c < COLUMNS; c++)
		free(column[c]);
	return status;
}

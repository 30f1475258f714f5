/* cli/model/load_history.c - integrate --load and --motion: a load per length and displacements
 * of the ends that tables give over time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/state.h"
#include "cli/measure/series.h"
#include "cli/model/made.h"
#include "core/report.h"

enum { AXES = 3, COLUMNS = 1 + AXES, ENDS = 2*AXES, DISPLACEMENTS = 1 + ENDS };
static const char where[] = "integrate";

/* The model of a scene, with shapes of its condensed modes at rest. */
static enum hawser_status build(struct hawser_rom *rom, const struct cli_model *model,
                                struct hawser_scene *scene, struct hawser_report *report)
{
	/* shapes for the inertia of condensed modes are chosen by a harmonic load, if there is one */
	scene->model.inertia = HAWSER_INERTIA_NONE;
	return scene->model.energy == HAWSER_ENERGY_EXACT
	       ? hawser_rom_build_full(rom, &model->statics, scene, scene->model.basis, report)
	       : hawser_rom_build(rom, &model->modes, scene, report);
}

/* The model of the scene with this load alone. */
static enum hawser_status build_unit(struct hawser_rom *rom, const struct cli_model *model,
                                     const double *load, struct hawser_report *report)
{
	struct hawser_scene scene = model->scene;

	scene.load.present = 1;
	scene.loads = 0;
	memcpy(scene.load.per_length, load, sizeof scene.load.per_length);
	if (!model->scene.load.present) {
		scene.load.frame = HAWSER_FRAME_LOCAL;
		scene.load.extent[0] = 0.0;
		scene.load.extent[1] = 1.0;
	}
	for (int e = 0; e < 2; e++) {
		memset(scene.support[e].given, 0, sizeof scene.support[e].given);
		memset(scene.support[e].motion, 0, sizeof scene.support[e].motion);
	}
	return build(rom, model, &scene, report);
}

/* What is in both tables' way. */
static enum hawser_status check_both(const struct cli_model *model, const char *option,
                                     const char *path, struct hawser_report *report)
{
	const struct hawser_scene *scene = &model->scene;
	const char *not_with = NULL;

	if (model->made)
		not_with = model->made->by->still;
	else if (!model->has_scene)
		not_with = "a reduced-model file, which does not tell where it acts: give a scene";
	else if (model->automatic)
		not_with = "modes: auto, which chooses for a frequency: give a number of modes (-n)";
	else if (scene->travel.present && (scene->travel.fluctuation > 0.0 || scene->travel.braking > 0.0))
		not_with = "a travel speed that changes";
	return not_with ? hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                               "--%s %s does not go with %s", option, path, not_with)
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
		status = build_unit(&unit[*terms], model, load, report);
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

/* Give the model the load. */
static enum hawser_status attach(struct cli_model *model, double *const *column, int rows,
                                 struct hawser_report *report)
{
	struct hawser_rom unit[AXES] = {{0}};
	const struct hawser_rom *units[AXES] = {&unit[0], &unit[1], &unit[2]};
	double *value = malloc(AXES*(size_t)rows*sizeof *value);
	int terms = 0;
	enum hawser_status status = value ? collect(unit, &terms, value, column, rows, model, report)
	                                  : hawser__no_memory(report, where);

	for (int i = 0; i < rows && !status; i++)
		column[0][i] /= model->rom.time;
	if (!status)
		status = hawser_rom_history_set(&model->rom, units, terms, column[0], value, rows, report);
	for (int c = 0; c < AXES; c++)
		hawser_rom_clear(&unit[c]);
	free(value);
	return status;
}

static enum hawser_status read_load(double **column, int *rows, const struct cli_model *model,
                                    const char *path, struct hawser_report *report)
{
	static const char *const names[2][COLUMNS] = {
		[HAWSER_FRAME_LOCAL] = {"t_s", "e_N_m", "n_N_m", "z_N_m"},
		[HAWSER_FRAME_GLOBAL] = {"t_s", "x_N_m", "y_N_m", "z_N_m"}};
	int global = model->scene.load.present && model->scene.load.frame == HAWSER_FRAME_GLOBAL;
	enum hawser_status status = check_both(model, "load", path, report);

	return status ? status
	       : cli_columns_read(column, rows, path,
	                          names[global ? HAWSER_FRAME_GLOBAL : HAWSER_FRAME_LOCAL], COLUMNS,
	                          report);
}

/* --- the motion of the ends --- */

static enum hawser_status check_motion(const struct cli_model *model, const char *path,
                                       struct hawser_report *report)
{
	const struct hawser_scene *scene = &model->scene;
	enum hawser_status status = check_both(model, "motion", path, report);

	if (status)
		return status;
	if (scene->travel.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "--motion %s does not go with travel: moving supports of a travelling "
		                    "cable are not modelled, remove travel", path);
	for (int end = 0; end < 2; end++)
		for (int axis = 0; axis < AXES; axis++)
			if (scene->support[end].present && scene->support[end].motion[axis] != 0.0)
				return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
				                    "--motion %s moves the ends, and so does support.%c.motion of the "
				                    "scene: put that motion into the table, or remove it with --set "
				                    "support.%c.motion=[0,0,0]", path, "AB"[end], "AB"[end]);
	return HAWSER_OK;
}

/* The ends of the scene that move along the columns that there are. */
static void move(struct hawser_scene *scene, double *const *column)
{
	for (int c = 0; c < ENDS; c++) {
		int end = c/AXES;

		if (!column[1 + c])
			continue;
		if (!scene->support[end].present)
			for (int axis = 0; axis < AXES; axis++)
				scene->support[end].stiffness[axis] = INFINITY;
		scene->support[end].present = 1;
		scene->support[end].given[c%AXES] = 1;
	}
}

static enum hawser_status set_motion(struct cli_model *model, double *const *column, int rows,
                                     struct hawser_report *report)
{
	struct hawser_rom_motion motion = {.rows = rows, .time = column[0]};

	for (int i = 0; i < rows; i++)
		column[0][i] /= model->rom.time;
	for (int c = 0; c < ENDS; c++) {
		motion.value[c] = column[1 + c];
		for (int i = 0; i < rows && column[1 + c]; i++)
			column[1 + c][i] /= model->rom.length;
	}
	return hawser_rom_motion_set(&model->rom, &motion, report);
}

int cli_motion_warning(char *text, size_t size, const struct cli_model *model, double t)
{
	double speed = hawser_rom_motion_speed(&model->rom, t);

	if (speed > 0.0)
		snprintf(text, size, "motion: at t = %.6g s the ends already move, with %.4g m/s; the cable is "
		         "taken to move along with them, in its quasi-static shape. For a cable that hangs "
		         "still, let the table begin earlier, at rest (times before 0 are allowed)",
		         t*model->rom.time, speed*model->rom.length/model->rom.time);
	return speed > 0.0;
}

enum hawser_status cli_load_history(struct cli_model *model, const char *load, const char *motion,
                                    struct hawser_report *report)
{
	static const char *const names[DISPLACEMENTS] = {"t_s", "A_x_m", "A_y_m", "A_z_m", "B_x_m", "B_y_m",
		"B_z_m"};
	double *column[COLUMNS] = {NULL}, *moved[DISPLACEMENTS] = {NULL};
	int rows = 0, moves = 0;
	struct hawser_scene scene;
	struct hawser_rom base;
	enum hawser_status status = load ? read_load(column, &rows, model, load, report) : HAWSER_OK;

	if (!status && motion)
		status = check_motion(model, motion, report);
	if (!status && motion)
		status = cli_columns_read(moved, &moves, motion, names, DISPLACEMENTS, report);
	if (!status) {
		scene = model->scene;
		if (load)
			scene.load.present = 0;
		move(&scene, moved);
		status = build(&base, model, &scene, report);
	}
	if (!status) {
		hawser_rom_clear(&model->rom);
		model->rom = base;
	}
	if (!status && motion)
		status = set_motion(model, moved, moves, report);
	if (!status && load)
		status = attach(model, column, rows, report);
	for (int c = 0; c < COLUMNS; c++)
		free(column[c]);
	for (int c = 0; c < DISPLACEMENTS; c++)
		free(moved[c]);
	return status;
}

/* cli/choice.c - models whose modes the program chooses (model.modes: auto): making them once the range
 * of frequencies is known, and telling what was chosen and why.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

/* Numbers that follow from the statics, before there is a model: what frequencies are read with. */
enum hawser_status cli_choice_prepare(struct cli_model *model, struct hawser_report *report)
{
	struct hawser_modes_options options = cli_modes_options(&model->scene);
	enum hawser_status status;

	model->automatic = 1;
	status = hawser_modes_solve(&model->modes, &model->statics, &options, report);
	if (status)
		return status;
	model->rom.length = model->statics.span.d;
	model->rom.time = model->modes.time_unit;
	model->rom.force = model->statics.H;
	model->rom.scaled = 1;
	/* so that questions about a forced model have their answer */
	model->rom.harmonics = 0;
	model->natural = calloc((size_t)model->modes.n, sizeof *model->natural);
	if (!model->natural)
		return hawser__no_memory(report, "model");
	for (int k = 0; k < model->modes.n; k++)
		model->natural[k] = model->modes.mode[k].omega;
	model->naturals = model->modes.n;
	return HAWSER_OK;
}

enum hawser_status cli_choice_build(struct cli_model *model, double from, double to,
                                    struct hawser_report *report)
{
	struct hawser_accuracy *accuracy = &model->accuracy;
	enum hawser_status status;

	if (!model->automatic)
		return HAWSER_OK;
	accuracy->asked = model->scene.model.accuracy;
	status = hawser_accuracy_choose(&accuracy->choice, &accuracy->modes, &model->statics,
	                                &model->scene, from, to, accuracy->asked, report);
	return status ? status : hawser_choice_build(&model->rom, &accuracy->choice, &model->scene,
	                                             report);
}

enum hawser_status cli_choice_trace(struct hawser_frf *frf, struct cli_model *model,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	struct hawser_accuracy *accuracy = &model->accuracy;
	struct hawser_accuracy_options choice = hawser_accuracy_defaults();
	enum hawser_status status;

	choice.frf = *options;
	status = hawser_accuracy_trace(accuracy, &model->statics, &model->scene, &choice, report);
	*frf = accuracy->frf;
	model->rom = accuracy->rom;
	accuracy->frf = (struct hawser_frf){0};
	accuracy->rom = (struct hawser_rom){0};
	if (!status && accuracy->slack)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", accuracy->tries, 0.0,
		                       "the cable goes slack in much of this response (model of %d "
		                       "coordinates), and no model that can push tells by how much it is "
		                       "wrong: lower the load or narrow the range, keep a number of modes "
		                       "of your own (model.modes), or take what there is with --partial",
		                       model->rom.n);
	if (!status && frf->end == HAWSER_END_MAX_POINTS)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", accuracy->tries, 0.0,
		                       "the response of the model with %d coordinates takes more than "
		                       "%d points, and no accuracy can be stated for a part of it: narrow "
		                       "the range, lower the load, keep a number of modes of your own "
		                       "(model.modes), or take what there is with --partial",
		                       model->rom.n, frf->points);
	if (!status && !accuracy->reached && frf->end != HAWSER_END_INTERRUPTED)
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", accuracy->tries,
		                         accuracy->estimated,
		                         "folds and peaks are known to %.2g only with the %d "
		                         "coordinates of the last of %d models, not to %.2g as asked: "
		                         "ask for less, narrow the "
		                         "range, or take what there is with --partial",
		                         accuracy->estimated, model->rom.n, accuracy->tries,
		                         accuracy->asked);
	return status;
}

/* --- telling --- */

/* "out-of-plane 3" */
static void name_of(char *text, size_t size, const struct hawser_mode *mode)
{
	snprintf(text, size, "%s %d", hawser_plane_name(mode->plane), mode->number);
}

static void mode_comment(struct hawser__table *table, const struct cli_model *model, int j,
                         int coordinate)
{
	const struct hawser_choice *choice = &model->accuracy.choice;
	const struct hawser_choice_mode *mode = &choice->mode[j];
	const struct hawser_modes *modes = choice->modes;
	char name[64], partner[64] = "", worth[80];

	name_of(name, sizeof name, &modes->mode[j]);
	if (mode->partner >= 0 && mode->kept) {
		memcpy(partner, " with ", 7);
		name_of(partner + 6, sizeof partner - 6, &modes->mode[mode->partner]);
	}
	if (mode->measure > 0.0)
		snprintf(worth, sizeof worth, " (%.1e)", mode->measure);
	else
		snprintf(worth, sizeof worth, ", at rest in this response: kept for its stability");
	hawser__table_comment(table, "u_%d: w%d = %.9g rad/s, %s: %s%s%s", coordinate,
	                      modes->mode[j].place, modes->mode[j].omega/modes->time_unit, name,
	                      hawser_reason_name(hawser_choice_reason(choice, j)), partner, worth);
}

void cli_choice_comments(struct hawser__table *table, const struct cli_model *model)
{
	const struct hawser_accuracy *accuracy = &model->accuracy;
	const struct hawser_choice *choice = &accuracy->choice;
	int coordinate = 0;

	if (!model->automatic)
		return;
	if (accuracy->tries > 0)
		hawser__table_comment(table, "accuracy: asked %.3g, estimated %.2g, of folds and peaks",
		                      accuracy->asked, accuracy->estimated);
	for (int k = 0; k < accuracy->tries; k++) {
		const struct hawser_accuracy_try *this = &accuracy->attempt[k];
		char moved[48] = "", lacks[96] = "";

		if (isfinite(this->moved))
			snprintf(moved, sizeof moved, ", moved by %.1e", this->moved);
		if (this->truncation > 0.0)
			snprintf(lacks, sizeof lacks, ", beyond modes: %.1e (order of the energy: %.1e)",
			         this->truncation, this->energy);
		hawser__table_comment(table, "tried: %d modes%s%s; left out: %.1e%s; %d folds, %d points",
		                      this->modes,
		                      this->functions ? " (full order)" : "", moved, this->rest, lacks,
		                      this->folds, this->points);
	}
	if (accuracy->full) {
		hawser__table_comment(table, "full order, %d coordinates: chosen modes do not reach the "
		                             "accuracy, at this motion", model->rom.n);
		return;
	}
	hawser__table_comment(table, "%d of %d modes kept, the others follow them statically%s",
	                      model->rom.n - model->rom.inertia.shapes, choice->n,
	                      choice->planar ? "; the load has nothing out of plane" : "");
	for (int j = 0; j < choice->n; j++)
		if (choice->mode[j].kept)
			mode_comment(table, model, j, ++coordinate);
}

static void mode_json(struct hawser__json *json, json_t *list, const struct hawser_choice *choice,
                      int j)
{
	const struct hawser_choice_mode *mode = &choice->mode[j];
	const struct hawser_mode *shape = &choice->modes->mode[j];
	json_t *row = hawser__json_object(json, list, NULL);

	hawser__json_integer(json, row, "index", shape->place);
	hawser__json_text(json, row, "plane", hawser_plane_name(shape->plane));
	hawser__json_integer(json, row, "number", shape->number);
	hawser__json_number(json, row, "omega", shape->omega/choice->modes->time_unit);
	hawser__json_flag(json, row, "kept", mode->kept);
	hawser__json_text(json, row, "reason", hawser_reason_name(hawser_choice_reason(choice, j)));
	hawser__json_number(json, row, "measure", fmin(mode->measure, 1e300));
	if (mode->kept && mode->partner >= 0)
		hawser__json_integer(json, row, "partner", choice->modes->mode[mode->partner].place);
}

void cli_choice_json(struct hawser__json *json, const struct cli_model *model,
                     const struct cli_common *common)
{
	const struct hawser_accuracy *accuracy = &model->accuracy;
	json_t *object, *list, *row;

	if (!model->automatic)
		return;
	object = hawser__json_object(json, json->root, "accuracy");
	hawser__json_number(json, object, "asked", accuracy->asked);
	if (accuracy->tries > 0) {
		hawser__json_number(json, object, "estimated", accuracy->estimated);
		hawser__json_flag(json, object, "reached", accuracy->reached);
	}
	hawser__json_integer(json, object, "kept", model->rom.n);
	hawser__json_flag(json, object, "full_order", accuracy->full);
	hawser__json_flag(json, object, "planar_load", accuracy->choice.planar);
	list = hawser__json_array(json, object, "modes");
	for (int j = 0; j < accuracy->choice.n; j++)
		mode_json(json, list, &accuracy->choice, j);
	list = hawser__json_array(json, object, "tried");
	for (int k = 0; k < accuracy->tries; k++) {
		const struct hawser_accuracy_try *this = &accuracy->attempt[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "modes", this->modes);
		hawser__json_flag(json, row, "full_order", this->functions > 0);
		if (isfinite(this->moved))
			hawser__json_number(json, row, "moved", this->moved);
		hawser__json_number(json, row, "rest", fmin(this->rest, 1e300));
		hawser__json_number(json, row, "truncation", this->truncation);
		hawser__json_number(json, row, "energy_order", this->energy);
		hawser__json_integer(json, row, "folds", this->folds);
		hawser__json_integer(json, row, "points", this->points);
		if (!common->reproducible)
			hawser__json_number(json, row, "seconds", this->seconds);
	}
}

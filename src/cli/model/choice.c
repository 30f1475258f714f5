/* cli/model/choice.c - models whose modes are chosen automatically (model.modes: auto): the
 * choice, once the range of frequencies is known, and the report of the chosen modes with the
 * reasons. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/made.h"
#include "cli/frame/view.h"
#include "core/report.h"

/* Units and natural frequencies follow from the statics and the modes, before there is a model.
 * They are needed to read frequencies. */
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
	/* no load yet: the model counts as not forced */
	model->rom.harmonics = 0;
	return cli_natural(model, report);
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
	struct hawser_accuracy_options choice = {.most = 0};
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

	if (model->made)
		model->made->by->comments(table, model);
	if (isfinite(cli_modes_end(model)))
		hawser__table_comment(table, "a range without --to ends at %.9g rad/s, where %s, or at 3.3w1",
		                      cli_modes_end(model)*cli_per_omega(model),
		                      model->made && model->made->breaking > 0.0
		                      ? "these modes end (-n keeps more) or waves break"
		                      : "these modes end (-n keeps more)");
	if (!model->automatic)
		return;
	if (accuracy->tries > 0)
		hawser__table_comment(table, "accuracy: asked %.3g, estimated %.2g, of folds and peaks",
		                      accuracy->asked, accuracy->estimated);
	for (int k = 0; k < accuracy->tries; k++) {
		const struct hawser_accuracy_try *this = &accuracy->attempt[k];
		char moved[48] = "", lacks[96] = "";

		if (isfinite(this->moved))
			snprintf(moved, sizeof moved, ", %s by %.1e",
			         this->checked && !this->functions ? "off from the exact energy" : "moved",
			         this->moved);
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

void cli_drag_comment(struct hawser__table *table, const struct cli_model *model, const char *how)
{
	if (!model->rom.drag)
		return;
	if (model->scene.wind.present) {
		hawser__table_comment(table, "exact force of the wind: %s", how);
		return;
	}
	hawser__table_comment(table, "quadratic drag of air at rest, %g kg/m^2: %s",
	                      model->scene.damping.drag, how);
	if (model->rom.inertia.shapes == 0 && model->rom.inertia.shift > 0.0)
		hawser__table_comment(table, "with drag alone the condensed modes have no inertia, by which "
		                             "resonance frequencies are off by %.1e at most",
		                      model->rom.inertia.shift);
}

/* --- fields --- */

HAWSER__GIVEN(is_automatic, struct cli_model, of->automatic)

HAWSER__GIVEN(is_tried, struct cli_model, of->accuracy.tries > 0)

static int has_times(const void *row, const void *parent)
{
	(void)row;
	return !((const struct cli_model *)parent)->reproducible;
}

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(reason_name, hawser_reason_name, enum hawser_reason)

struct candidate {
	int place, number, kept, partner;
	enum hawser_plane plane;
	enum hawser_reason reason;
	double omega, measure;
};

static const void *candidate_row(void *to, const void *parent, size_t j)
{
	const struct hawser_choice *choice = &((const struct cli_model *)parent)->accuracy.choice;
	const struct hawser_choice_mode *mode = &choice->mode[j];
	const struct hawser_mode *shape = &choice->modes->mode[j];

	*(struct candidate *)to = (struct candidate){
		.place = shape->place, .number = shape->number, .kept = mode->kept, .plane = shape->plane,
		.partner = mode->kept && mode->partner >= 0 ? choice->modes->mode[mode->partner].place
		                                            : HAWSER__NO_INTEGER,
		.reason = hawser_choice_reason(choice, (int)j),
		.omega = shape->omega/choice->modes->time_unit, .measure = fmin(mode->measure, 1e300)};
	return to;
}

#define OF(member) HAWSER__AT(struct candidate, member)
static const struct hawser__field candidate_field[] = {
	{"index", NULL, "by frequency, from 1", OF(place)},
	{"plane", NULL, "in-plane or out-of-plane",
	 HAWSER__LABEL_AT(struct candidate, plane, plane_name)},
	{"number", NULL, "by frequency in its plane", OF(number)},
	{"omega", NULL, "natural frequency", OF(omega), .unit = HAWSER__RADIAN_S},
	{"kept", NULL, "whether the model has it", HAWSER__FLAG_AT(struct candidate, kept)},
	{"reason", NULL, "why", HAWSER__LABEL_AT(struct candidate, reason, reason_name)},
	{"measure", NULL, "error of the response without it, relative", OF(measure)},
	{"partner", NULL, "mode with which a kept one resonates", OF(partner), .flags = HAWSER__OMIT},
	HAWSER__END,
};
#undef OF
static const struct hawser__list candidate_list = HAWSER__MADE_ROWS(
	struct candidate, candidate_field, struct cli_model, accuracy.choice.n, candidate_row);

HAWSER__OF(rest_of, double, struct hawser_accuracy_try, fmin(of->rest, 1e300))

#define OF(member) HAWSER__AT(struct hawser_accuracy_try, member)
static const struct hawser__field try_field[] = {
	{"modes", NULL, "modes kept", OF(modes)},
	{"full_order", NULL, "whether it is the full-order model",
	 HAWSER__FLAG_AT(struct hawser_accuracy_try, functions)},
	{"moved", NULL, "distance from the response before or the exact energy, relative", OF(moved),
	 .flags = HAWSER__OMIT | HAWSER__INFINITE},
	{"rest", NULL, "error by the modes left out", HAWSER__BY(rest_of)},
	{"truncation", NULL, "error that no mode makes up for", OF(truncation)},
	{"energy_order", NULL, "part of it by the order of the energy", OF(energy)},
	{"folds", NULL, "folds of the response", OF(folds)},
	{"points", NULL, "points of the response", OF(points)},
	{"seconds", NULL, "wall time (s)", OF(seconds), .given = has_times},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct cli_model, member)
static const struct hawser__field accuracy_field[] = {
	{"asked", NULL, "largest relative error asked for", OF(accuracy.asked)},
	{"estimated", NULL, "estimated error", OF(accuracy.estimated), .given = is_tried},
	{"reached", NULL, "whether that is at most the one asked for",
	 HAWSER__FLAG_AT(struct cli_model, accuracy.reached), .given = is_tried},
	{"kept", NULL, "coordinates of the model", OF(rom.n)},
	{"full_order", NULL, "whether it is the full-order model",
	 HAWSER__FLAG_AT(struct cli_model, accuracy.full)},
	{"planar_load", NULL, "whether the load has nothing out of plane",
	 HAWSER__FLAG_AT(struct cli_model, accuracy.choice.planar)},
	{"modes", NULL, "modes looked at", HAWSER__OBJECTS_OF(candidate_list)},
	{"tried", NULL, "models tried", HAWSER__STORED_WITHIN(struct cli_model, accuracy.attempt,
	                                                 accuracy.tries, try_field)},
	HAWSER__END,
};
#undef OF
const struct hawser__field cli_choice_field[] = {
	{"accuracy", NULL, "of chosen modes (model.modes: auto)", HAWSER__OBJECT_OF(accuracy_field),
	 .given = is_automatic},
	HAWSER__END,
};

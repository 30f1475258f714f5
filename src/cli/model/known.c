/* cli/model/known.c - condensed modes near and below the forcing frequency: adding them to the
 * model, and a warning if the model does not have them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "cli/model/made.h"

/* Modes up to this multiple of the forcing frequency are added. The response of the modes above,
 * which the model approximates by two terms, has a relative error below (1/4)^4. */
static const double above = 4.0;
/* For a mode at 1/part times the forcing frequency the two terms have an error of 0.08 of the
 * static response; for lower modes it grows without limit. */
static const double part = 0.5;
/* A range that nobody gave ends at this multiple of the highest mode of a ropeway or net, past its
 * peak: others follow within some percent, and a response beyond has their peaks as if they were
 * linear. Chosen. */
static const double last = 1.1;
/* It does not end below this multiple of the first mode, whose peak it is to show. Chosen. */
static const double least = 1.3;
/* Models of scenes are off by 1e-5 at best, by what they leave out; chosen. Looser ones let steps
 * jump: with 1e-5 the folds of the chairlift had six curves more. */
static const double enough = 1e-7;

/* The highest multiple of the forcing frequency at which a force drives modes that are not kept;
 * 0: none does. */
static int multiple(const struct hawser_rom *rom)
{
	int k = 0;

	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].answer && rom->harmonic[h].k > k)
			k = rom->harmonic[h].k;
	return k;
}

enum hawser_status cli_known(struct cli_model *model, double omega, struct hawser_report *report)
{
	double top = above*omega*multiple(&model->rom);

	if (!model->has_scene || model->automatic || model->rom.exact || model->rom.known.reach >= top)
		return HAWSER_OK;
	return hawser_rom_know_below(&model->rom, &model->modes, &model->scene, top, report);
}

/* Of a rope over sheaves: above `reach` known motions stand for the modes that are not known, so
 * that no series diverges there (modes/driven.c). */
static int stands_for_more(const struct hawser_rom_known *known)
{
	return known->modes > 0 && known->K[known->modes - 1] > known->reach*known->reach;
}

int cli_known_lacks(char *text, size_t size, const struct cli_model *model, double omega)
{
	const struct hawser_rom *rom = &model->rom;
	int k = multiple(rom);
	double reach = rom->known.reach, limit = part*reach;

	if (k == 0)
		return 0;
	if (stands_for_more(&rom->known)) {
		limit = reach;
		k = 1;
	}
	if (!(reach > 0.0) && model->naturals > 0) /* a file that does not state the highest mode */
		limit = reach = model->natural[model->naturals - 1];
	omega *= k;
	if (!(omega > limit))
		return 0;
	snprintf(text, size, "the frequency of the forces reaches %.6g rad/s, and the model knows no modes "
	         "above %.6g rad/s but as they follow the load statically: displacement and tension can "
	         "be wrong by any factor: %s", omega*cli_per_omega(model), reach*cli_per_omega(model),
	         model->has_scene ? "lower the frequency, or take model.energy: exact"
	         : model->made ? "lower the frequency, or keep more modes (-n)"
	         : "give the scene in place of its model");
	return 1;
}

double cli_tolerance(double given, const struct cli_model *model)
{
	return given > 0.0 ? given : model->has_scene || model->made ? enough : 0.0;
}

double cli_modes_end(const struct cli_model *model)
{
	const struct hawser_modes *modes = model->made ? &model->made->modes.modes : NULL;
	const struct hawser_rom *rom = &model->rom;
	double top = model->naturals > 0 ? model->natural[model->naturals - 1] : INFINITY;

	/* a span with dampers, of which no mode is known but those that are kept (cli_known) */
	if (model->has_scene && !model->automatic && !rom->exact && model->naturals > 0 &&
	    multiple(rom) > 0 && !(rom->known.reach > top))
		return fmax(top/multiple(rom), least*model->natural[0]);
	if (!modes || modes->n == 0 || model->naturals == 0)
		return INFINITY;
	top = last*modes->mode[modes->n - 1].omega;
	return model->made->breaking > 0.0 ? fmin(top, model->made->breaking/cli_per_omega(model)) : top;
}

double cli_passing(const struct cli_model *model)
{
	return model->made ? model->made->passing/cli_per_omega(model) : 0.0;
}

void cli_known_warn(const struct cli_model *model, double omega)
{
	char text[CLI_WARNING_SIZE];

	if (cli_known_lacks(text, sizeof text, model, omega))
		cli_caution("beyond the modes of the model", text);
}

/* cli/known.c - condensed modes near and below the forcing frequency: adding them to the model, and
 * a warning if the model does not have them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>

#include "cli/cli.h"
#include "core/report.h"

/* Modes up to this multiple of the forcing frequency are added. The response of the modes above,
 * which the model approximates by two terms, has a relative error below (1/4)^4. */
static const double above = 4.0;
/* For a mode at 1/part times the forcing frequency the two terms have an error of 0.08 of the
 * static response; for lower modes it grows without limit. */
static const double part = 0.5;

enum hawser_status cli_known(struct cli_model *model, double omega, struct hawser_report *report)
{
	if (!model->has_scene || model->automatic || model->rom.exact ||
	    model->rom.known.reach >= above*omega)
		return HAWSER_OK;
	return hawser_rom_know_below(&model->rom, &model->modes, &model->scene, above*omega, report);
}

static int answers(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].answer)
			return 1;
	return 0;
}

int cli_known_lacks(char *text, size_t size, const struct cli_model *model, double omega)
{
	const struct hawser_rom *rom = &model->rom;
	double reach = rom->known.reach, limit = part*reach;

	if (!answers(rom))
		return 0;
	if (!(reach > 0.0) && model->naturals > 0) /* a file that does not state the highest mode */
		limit = reach = model->natural[model->naturals - 1];
	if (!(omega > limit))
		return 0;
	snprintf(text, size, "the forcing frequency reaches %.6g rad/s, and the model knows no modes "
	         "above %.6g rad/s but as they follow the load statically: displacement and tension can "
	         "be wrong by any factor: %s", omega*cli_per_omega(model), reach*cli_per_omega(model),
	         model->has_scene ? "lower the frequency, or take model.energy: exact"
	         : "give the scene in place of its model");
	return 1;
}

void cli_known_warn(const struct cli_model *model, double omega)
{
	char text[CLI_WARNING_SIZE];

	if (cli_known_lacks(text, sizeof text, model, omega))
		cli_warn(text);
}

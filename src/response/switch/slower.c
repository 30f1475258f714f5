/* response/switch/slower.c - see slower.h.
 *
 * A model of a family is kept for its value as long as the family returns the same one: a structure
 * whose members are equal, pointers too, since for one value the family makes one model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/scales.h>

#include "core/report.h"
#include "response/switch/slower.h"
#include "response/orbit/load.h"
#include "rom/terms/terms.h"

enum { MODELS = 12 }; /* kept at the same time, more than a family keeps, and the first one */

struct hawser__slower_model {
	struct hawser__load load; /* .rom is the model */
	double *known;
	struct hawser_rom from;   /* which it refers to */
	double at;
};

static void close_model(struct hawser__slower_model *model)
{
	hawser__load_clear(&model->load);
	free(model->known);
	model->known = NULL;
}

static enum hawser_status open_model(struct hawser__slower_model *model, const struct hawser_rom *rom,
                                     int b, struct hawser_report *report)
{
	size_t modes = (size_t)rom->known.modes;
	enum hawser_status status = hawser__load_open(&model->load, rom, report);

	model->load.rom.periods = 0;
	model->known = malloc((modes*(size_t)rom->harmonics + 1)*sizeof *model->known);
	if (!status && !model->known)
		status = hawser__no_memory(report, "frf");
	for (int h = 0; h < rom->harmonics && !status; h++) {
		double *known = model->known + modes*(size_t)h;

		if (!rom->harmonic[h].known)
			continue;
		memcpy(known, rom->harmonic[h].known, modes*sizeof *known);
		model->load.rom.harmonic[h].known = known;
	}
	status = status ? status : hawser_subharmonic_base(&model->load.rom, b, report);
	if (status)
		return status;
	memcpy(&model->from, rom, sizeof *rom);
	return HAWSER_OK;
}

static enum hawser_status model_at(void *context, const struct hawser_rom **rom, double p,
                                   struct hawser_report *report)
{
	struct hawser__slower *slower = context;
	const struct hawser_rom *from;
	struct hawser__slower_model *model = NULL;
	enum hawser_status status = slower->of->model(slower->of->context, &from, p, report);

	if (status)
		return status;
	for (int i = 1; i < slower->count && !model; i++)
		model = slower->model[i].at == p ? &slower->model[i] : NULL;
	if (!model) {
		model = &slower->model[slower->next];
		slower->count += slower->count == slower->next;
		slower->next = slower->next%MODELS + 1;
	}
	/* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison,cert-*): are they the same bytes */
	if (model->at != p || memcmp(&model->from, from, sizeof *from) != 0) {
		close_model(model);
		model->at = p;
		status = open_model(model, from, slower->b, report);
	}
	*rom = &model->load.rom;
	return status;
}

enum hawser_status hawser__slower_open(struct hawser__slower *slower, const struct hawser_rom *rom,
                                       const struct hawser_rom_family *family, int b,
                                       struct hawser_report *report)
{
	*slower = (struct hawser__slower){.b = b, .of = family, .count = 1, .next = 1,
		.model = calloc(1 + (family ? MODELS : 0), sizeof *slower->model)};
	if (!slower->model)
		return hawser__no_memory(report, "frf");
	slower->rom = &slower->model->load.rom;
	if (family)
		slower->family = (struct hawser_rom_family){family->omega/(b*hawser__rom_periods(rom)),
			model_at, slower};
	return open_model(slower->model, rom, b, report);
}

void hawser__slower_close(struct hawser__slower *slower)
{
	for (int i = 0; slower->model && i < slower->count; i++)
		close_model(&slower->model[i]);
	free(slower->model);
	slower->model = NULL;
}

/* rom/build/model.c - allocation and release of models.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/dampers.h"
#include "rom/terms/history.h"
#include "rom/terms/drag.h"
#include "rom/terms/ends.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"
#include "rom/build/build.h"
#include "rom/build/model.h"
#include "rom/file/plug.h"

enum hawser_status hawser__rom_init(struct hawser_rom *rom, int n, struct hawser_report *report)
{
	return hawser__rom_init_most(rom, n, HAWSER_ROM_MAX, report);
}

enum hawser_status hawser__rom_init_most(struct hawser_rom *rom, int n, int most,
                                         struct hawser_report *report)
{
	memset(rom, 0, sizeof *rom);
	if (n < 1 || n > most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model of %d coordinates: it must have 1 to %d (model.modes, or -n)", n,
		                    most);
	rom->n = n;
	rom->length = rom->time = rom->force = 1.0;
	rom->D = calloc((size_t)n*n, sizeof *rom->D);
	rom->K = calloc((size_t)n*n, sizeof *rom->K);
	if (!rom->D || !rom->K) {
		hawser_rom_clear(rom);
		return hawser__no_memory(report, "rom");
	}
	return HAWSER_OK;
}

enum hawser_status hawser__rom_init_shapes(struct hawser_rom *rom, int points,
                                           struct hawser_report *report)
{
	struct hawser_rom_shapes *shapes = &rom->shapes;
	size_t count = (size_t)points, each = (size_t)rom->n*count*3;

	shapes->points = points;
	shapes->name = calloc(count, sizeof *shapes->name);
	shapes->s = calloc(count, sizeof *shapes->s);
	shapes->tangent = calloc(2*count, sizeof *shapes->tangent);
	shapes->stretch = calloc(count, sizeof *shapes->stretch);
	shapes->shape = calloc(each, sizeof *shapes->shape);
	shapes->slope = calloc(each, sizeof *shapes->slope);
	if (!shapes->name || !shapes->s || !shapes->tangent || !shapes->stretch || !shapes->shape ||
	    !shapes->slope)
		return hawser__no_memory(report, "rom");
	return HAWSER_OK;
}

enum hawser_status hawser__rom_init_second(struct hawser_rom *rom, struct hawser_report *report)
{
	struct hawser_rom_shapes *shapes = &rom->shapes;
	size_t each = (size_t)rom->n*(rom->n + 1)/2*shapes->points*3;

	shapes->second_shape = calloc(each, sizeof *shapes->second_shape);
	shapes->second_slope = calloc(each, sizeof *shapes->second_slope);
	if (rom->line.points > 0)
		rom->line.second_slope = calloc((size_t)rom->n*(rom->n + 1)/2*rom->line.points*3,
		                                sizeof *rom->line.second_slope);
	if (shapes->second_shape && shapes->second_slope &&
	    (rom->line.points == 0 || rom->line.second_slope))
		return HAWSER_OK;
	return hawser__no_memory(report, "rom");
}

struct hawser_harmonic *hawser__rom_harmonic(struct hawser_rom *rom, int k, enum hawser_phase phase)
{
	struct hawser_harmonic *h = realloc(rom->harmonic, ((size_t)rom->harmonics + 1)*sizeof *h);

	if (!h)
		return NULL;
	rom->harmonic = h;
	h += rom->harmonics++;
	*h = (struct hawser_harmonic){.k = k, .phase = phase};
	return h;
}

static void free_words(char **word, int count)
{
	for (int i = 0; word && i < count; i++)
		free(word[i]);
	free(word);
}

static void clear_shapes(struct hawser_rom_shapes *shapes)
{
	free_words(shapes->name, shapes->points);
	free(shapes->s);
	free(shapes->tangent);
	free(shapes->stretch);
	free(shapes->shape);
	free(shapes->slope);
	free(shapes->second_shape);
	free(shapes->second_slope);
}

enum hawser_status hawser__rom_init_line(struct hawser_rom *rom, int points,
                                         struct hawser_report *report)
{
	struct hawser_rom_line *line = &rom->line;
	size_t count = (size_t)points, n = (size_t)rom->n;

	line->points = points;
	line->s = calloc(count, sizeof *line->s);
	line->stretch = calloc(count, sizeof *line->stretch);
	line->slope = calloc(n*count*3, sizeof *line->slope);
	if (!line->s || !line->stretch || !line->slope)
		return hawser__no_memory(report, "rom");
	return HAWSER_OK;
}

static void clear_line(struct hawser_rom_line *line)
{
	free(line->s);
	free(line->stretch);
	free(line->slope);
	free(line->second_slope);
}

void hawser_rom_clear(struct hawser_rom *rom)
{
	if (!rom)
		return;
	hawser__rom_known_clear(rom);
	for (int h = 0; rom->harmonic && h < rom->harmonics; h++) {
		free(rom->harmonic[h].f);
		free(rom->harmonic[h].D);
		free(rom->harmonic[h].K);
		free(rom->harmonic[h].Q);
		free(rom->harmonic[h].term);
		free(rom->harmonic[h].answer);
		free(rom->harmonic[h].answer_line);
	}
	free(rom->harmonic);
	for (int i = 0; rom->ramp && i < HAWSER_RAMP_TERMS; i++)
		hawser__rom_term_clear(&rom->ramp->term[i]);
	free(rom->ramp);
	hawser__rom_history_clear(rom);
	hawser__ends_free(rom->ends);
	free(rom->D);
	free(rom->K);
	free(rom->Q);
	free(rom->term);
	free(rom->mass);
	free(rom->carried);
	hawser__plug_free(rom->plug);
	hawser_rom_clear(rom->first);
	free(rom->first);
	free(rom->C);
	free_words(rom->label, rom->n);
	clear_shapes(&rom->shapes);
	clear_line(&rom->line);
	free(rom->range);
	hawser__rom_contacts_clear(&rom->contacts);
	hawser__kernel_free(rom->kernel);
	hawser__exact_free(rom->exact);
	hawser__drag_free(rom->drag);
	memset(rom, 0, sizeof *rom);
}

enum hawser_status hawser__rom_real(const struct hawser_modes *modes, struct hawser_report *report)
{
	if (!modes->gyroscopic)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "the modes are complex: a model needs real modes, for a travelling cable "
	                    "those of the apparent cable (hawser_modes_solve)");
}

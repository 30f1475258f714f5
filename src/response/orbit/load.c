/* response/orbit/load.c - see load.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "response/orbit/load.h"
#include "rom/terms/ends.h"
#include "rom/energy/kernel.h"

/* Memory for an array of the harmonic, at *memory, or NULL if the harmonic has none. */
static double *take(double **memory, const double *full, size_t count)
{
	double *here = *memory;

	if (!full)
		return NULL;
	*memory += count;
	return here;
}

enum hawser_status hawser__load_open(struct hawser__load *load, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	size_t n = (size_t)rom->n, room = 0, quads = 0, terms = 0, probes = HAWSER__ANSWER(rom),
	       line = HAWSER__ANSWER_LINE(rom);
	struct hawser_quad *quad;
	struct hawser_term *term;
	double *at;

	*load = (struct hawser__load){.full = rom, .rom = *rom, .factor = 1.0};
	for (int h = 0; h < rom->harmonics; h++)
		room += (rom->harmonic[h].f ? n : 0) + (rom->harmonic[h].D ? n*n : 0) +
		        (rom->harmonic[h].K ? n*n : 0) + (rom->harmonic[h].answer ? probes : 0) +
		        (rom->harmonic[h].answer_line ? line : 0);
	for (int h = 0; h < rom->harmonics; h++) {
		quads += (size_t)rom->harmonic[h].quads;
		terms += (size_t)rom->harmonic[h].terms;
	}
	load->rom.harmonic = malloc(((size_t)rom->harmonics + 1)*sizeof *load->rom.harmonic);
	load->memory = at = malloc((room + 1)*sizeof *load->memory);
	load->quad = quad = malloc((quads + 1)*sizeof *load->quad);
	load->term = term = malloc((terms + 1)*sizeof *load->term);
	if (rom->ends)
		load->rom.ends = load->ends = malloc(sizeof *load->ends);
	if (!load->rom.harmonic || !load->memory || !load->quad || !load->term ||
	    (rom->ends && !load->ends))
		return hawser__no_memory(report, "load");
	if (rom->ends)
		*load->ends = *rom->ends;
	for (int h = 0; h < rom->harmonics; h++) {
		struct hawser_harmonic *harmonic = &load->rom.harmonic[h];

		*harmonic = rom->harmonic[h];
		harmonic->f = take(&at, harmonic->f, n);
		harmonic->D = take(&at, harmonic->D, n*n);
		harmonic->K = take(&at, harmonic->K, n*n);
		harmonic->Q = harmonic->quads > 0 ? quad : NULL;
		for (int i = 0; i < harmonic->quads; i++)
			*quad++ = rom->harmonic[h].Q[i];
		harmonic->term = harmonic->terms > 0 ? term : NULL;
		for (int i = 0; i < harmonic->terms; i++)
			*term++ = rom->harmonic[h].term[i];
		harmonic->answer = take(&at, harmonic->answer, probes);
		harmonic->answer_line = take(&at, harmonic->answer_line, line);
	}
	hawser__load_set(load, 1.0);
	return HAWSER_OK;
}

static void scale(double *to, const double *from, size_t count, double factor)
{
	for (size_t i = 0; to && i < count; i++)
		to[i] = factor*from[i];
}

double hawser__load_share(const struct hawser_harmonic *harmonic, double factor)
{
	double share = factor;

	for (int p = 1; p < harmonic->load_power; p++)
		share *= factor;
	return share;
}

double hawser__load_rate(const struct hawser_harmonic *harmonic, double factor)
{
	double rate = harmonic->load_power > 1 ? harmonic->load_power : 1.0;

	for (int p = 1; p < harmonic->load_power; p++)
		rate *= factor;
	return rate;
}

void hawser__load_set(struct hawser__load *load, double factor)
{
	size_t n = (size_t)load->full->n;

	load->factor = factor;
	if (load->ends)
		load->ends->factor = factor*load->full->ends->factor;
	for (int h = 0; h < load->full->harmonics; h++) {
		const struct hawser_harmonic *full = &load->full->harmonic[h];
		struct hawser_harmonic *mine = &load->rom.harmonic[h];

		double share = hawser__load_share(full, factor);

		/* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): both models have as many harmonics */
		scale(mine->f, full->f, n, share);
		scale(mine->D, full->D, n*n, share);
		scale(mine->K, full->K, n*n, share);
		for (int i = 0; i < full->quads; i++)
			/* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): room for all was made */
			mine->Q[i].value = share*full->Q[i].value;
		for (int i = 0; i < full->terms; i++)
			/* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): room for all was made */
			mine->term[i].value = share*full->term[i].value;
		scale(mine->answer, full->answer, HAWSER__ANSWER(load->full), share);
		scale(mine->answer_line, full->answer_line, HAWSER__ANSWER_LINE(load->full), share);
	}
}

void hawser__load_clear(struct hawser__load *load)
{
	free(load->rom.harmonic);
	free(load->memory);
	free(load->quad);
	free(load->term);
	free(load->ends);
	*load = (struct hawser__load){0};
}

/* rom/condense/known.c - the condensed modes whose frequencies and shapes are known.
 *
 *    f_s      force of a harmonic on condensed mode s
 *    W        k Omega, the frequency of that force
 *    H_s      1/(omega_s^2 - W^2 + i W D_s) - 1/omega_s^2 - W^2/omega_s^4
 *
 * The series z_0 + W^2 z_1 of answer_make.c is the sum of f_s/omega_s^2 + W^2 f_s/omega_s^4 over
 * all condensed modes. It converges for W < omega_s only, but a choice of modes by their measures
 * can omit modes below the forcing frequency. For a mode s the exact remainder of the series is f_s
 * H_s. This is added for the known modes, so that the series is used for the modes above them only
 * (the mode-acceleration method with dynamic correction: Cornwell, Craig and Johnson 1983).
 *
 * With q = (W^2 - i W D_s)/omega_s^2 there is no cancellation in
 *
 *    omega_s^2 H_s = -i W D_s/omega_s^2 + q^2/(1 - q).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/inertia.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"

static const double negligible = 1e-12; /* force on a mode, relative to the largest of the same
                                         * harmonic, that is zero but for round-off */

double complex hawser__rom_known_lacks(const struct hawser_rom_known *known, int s, double W)
{
	double K = known->K[s];
	double complex loss = I*W*known->D[s]/K, q = W*W/K - loss;

	return (q*q/(1.0 - q) - loss)/K;
}

void hawser__rom_known_clear(struct hawser_rom *rom)
{
	free(rom->known.K);
	free(rom->known.D);
	free(rom->known.shape);
	free(rom->known.line);
	for (int h = 0; rom->harmonic && h < rom->harmonics; h++) {
		free(rom->harmonic[h].known);
		rom->harmonic[h].known = NULL;
	}
	rom->known = (struct hawser_rom_known){.modes = 0};
}

enum hawser_status hawser__rom_known_make(struct hawser_rom *rom, int modes,
                                      struct hawser_report *report)
{
	struct hawser_rom_known *known = &rom->known;
	size_t count = (size_t)modes, points = (size_t)rom->shapes.points;

	known->modes = modes;
	known->K = calloc(count + 1, sizeof *known->K);
	known->D = calloc(count + 1, sizeof *known->D);
	known->shape = calloc(4*count*points + 1, sizeof *known->shape);
	if (rom->line.points > 0)
		known->line = calloc(count*(size_t)rom->line.points + 1, sizeof *known->line);
	if (!known->K || !known->D || !known->shape || (rom->line.points > 0 && !known->line))
		return hawser__no_memory(report, "rom");
	return HAWSER_OK;
}

/* --- from a model of all the modes --- */

int hawser__rom_answers_load(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].answer)
			return 1;
	return 0;
}

static int alike(const struct hawser_rom *rom, const struct hawser_rom *all)
{
	/* further terms of `rom` have no response of condensed modes */
	if (rom->harmonics < all->harmonics || rom->shapes.points != all->shapes.points ||
	    rom->line.points != all->line.points || all->inertia.shapes > 0)
		return 0;
	for (int h = 0; h < all->harmonics; h++) {
		const struct hawser_harmonic *a = &rom->harmonic[h], *b = &all->harmonic[h];

		if (a->k != b->k || a->phase != b->phase || a->omega_power != b->omega_power)
			return 0;
	}
	return 1;
}

static int excited(const struct hawser_rom *all, int s)
{
	for (int h = 0; h < all->harmonics; h++) {
		const double *f = all->harmonic[h].f;
		double most = 0.0;

		for (int j = 0; f && j < all->n; j++)
			most = fmax(most, fabs(f[j]));
		if (f && fabs(f[s]) > negligible*most)
			return 1;
	}
	return 0;
}

/* index[] of the modes of `all` that are to be known; returns their number. */
static int list(int *index, const struct hawser_rom *all, const int *kept, int count, int most)
{
	int number = 0;

	for (int s = 0; s < most; s++) {
		int is_kept = 0;

		for (int i = 0; i < count; i++)
			is_kept |= kept[i] == s;
		if (!is_kept && excited(all, s))
			index[number++] = s;
	}
	return number;
}

/* Known mode x is mode s of `all`. */
static void copy_mode(struct hawser_rom *rom, int x, const struct hawser_rom *all, int s)
{
	struct hawser_rom_known *known = &rom->known;
	size_t points = (size_t)rom->shapes.points, line = (size_t)rom->line.points;

	known->K[x] = all->K[s*(all->n + 1)];
	known->D[x] = all->D[s*(all->n + 1)];
	for (size_t p = 0; p < points; p++) {
		double *to = known->shape + 4*((size_t)x*points + p);

		memcpy(to, all->shapes.shape + 3*((size_t)s*points + p), 3*sizeof *to);
		to[3] = all->shapes.slope[3*((size_t)s*points + p)];
	}
	for (size_t p = 0; p < line; p++)
		known->line[(size_t)x*line + p] = all->line.slope[3*((size_t)s*line + p)];
}

static enum hawser_status copy_forces(struct hawser_rom *rom, const struct hawser_rom *all,
                                      const int *index, struct hawser_report *report)
{
	for (int h = 0; h < all->harmonics; h++) {
		const double *f = all->harmonic[h].f;

		if (!f || !rom->harmonic[h].answer || rom->known.modes == 0)
			continue;
		rom->harmonic[h].known = calloc((size_t)rom->known.modes, sizeof(double));
		if (!rom->harmonic[h].known)
			return hawser__no_memory(report, "rom");
		for (int x = 0; x < rom->known.modes; x++)
			rom->harmonic[h].known[x] = f[index[x]];
	}
	return HAWSER_OK;
}

enum hawser_status hawser_rom_know(struct hawser_rom *rom, const struct hawser_rom *all,
                                   const int *kept, int count, struct hawser_report *report)
{
	/* second-order shapes are orthogonal to this number of the lowest modes only */
	int most = rom->inertia.shapes > 0 && all->n > HAWSER__LOWEST ? HAWSER__LOWEST : all->n;
	int index[HAWSER_ROM_MOST], modes;
	enum hawser_status status;

	hawser__rom_known_clear(rom);
	if (!hawser__rom_answers_load(rom))
		return HAWSER_OK;
	if (!alike(rom, all))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "modes of a model with other forces or shape points say nothing of "
		                    "this one");
	modes = list(index, all, kept, count, most);
	status = hawser__rom_known_make(rom, modes, report);
	for (int x = 0; !status && x < modes; x++)
		copy_mode(rom, x, all, index[x]);
	rom->known.reach = sqrt(all->K[(most - 1)*(all->n + 1)]);
	return status ? status : copy_forces(rom, all, index, report);
}

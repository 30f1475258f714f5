/* rom/condense/answer_freeze.c - displacement and strain of the modes that are not kept at one
 * frequency, for many instants: see answer.h.
 *
 * A harmonic with the amplitude A at a point, of its series and of all known modes, is Re(A exp(i
 * k tau)) = Re A cos(k tau) - Im A sin(k tau). The harmonics of equal k are added, so that an
 * instant takes as many terms as there are multiples of the frequency, and not as many as known modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rom/condense/answer.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"

/* to[0] and to[1] [count]: cosine and sine += those of a harmonic; from: its series, `apart`
 * numbers from one term to the other; known: the shapes of known modes. */
static void add(double *const to[2], const struct hawser_rom *rom, const struct hawser_harmonic *h,
                double omega, const double *from, const double *known, size_t count)
{
	double W = h->k*omega;
	double complex size = pow(omega, h->omega_power)*(h->phase == HAWSER_SIN ? -I : 1.0);

	for (size_t i = 0; i < count; i++) {
		double complex A = size*(from[i] + W*W*from[count + i]);

		to[0][i] += creal(A);
		to[1][i] -= cimag(A);
	}
	for (int s = 0; h->known && known && s < rom->known.modes; s++) {
		double complex A = size*h->known[s];

		if (h->known[s] == 0.0)
			continue;
		A *= hawser__rom_known_lacks(&rom->known, s, W);
		for (size_t i = 0; i < count; i++) {
			to[0][i] += creal(A)*known[(size_t)s*count + i];
			to[1][i] -= cimag(A)*known[(size_t)s*count + i];
		}
	}
}

static int make_room(struct hawser__frozen *frozen, const struct hawser_rom *rom, int highest)
{
	size_t shape = HAWSER__ANSWER(rom), line = HAWSER__ANSWER_LINE(rom);
	size_t count = 2*((size_t)highest + 1), need = count*(shape + line) + 1;

	if (need > frozen->room) {
		free(frozen->memory);
		frozen->memory = malloc(need*sizeof *frozen->memory);
		frozen->room = frozen->memory ? need : 0;
	}
	if (highest >= frozen->highest || !frozen->harmonic) {
		free(frozen->harmonic);
		frozen->harmonic = malloc(count*sizeof *frozen->harmonic);
		frozen->highest = highest + 1;
	}
	if (!frozen->memory || !frozen->harmonic)
		return 1;
	memset(frozen->memory, 0, need*sizeof *frozen->memory);
	for (size_t i = 0; i < count; i++)
		frozen->harmonic[i] = (struct hawser_harmonic){.k = (int)(i/2),
			.phase = i%2 ? HAWSER_SIN : HAWSER_COS, .answer = frozen->memory + i*(shape + line),
			.answer_line = frozen->memory + i*(shape + line) + shape};
	return 0;
}

const struct hawser_rom *hawser__rom_freeze(struct hawser__frozen *frozen, const struct hawser_rom *rom,
                                            double omega)
{
	int highest = 0;

	if (rom->known.modes == 0 || !(omega > 0.0))
		return rom;
	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	if (make_room(frozen, rom, highest))
		return NULL;
	frozen->rom = *rom;
	frozen->rom.harmonics = 2*(highest + 1);
	frozen->rom.harmonic = frozen->harmonic;
	frozen->rom.known = (struct hawser_rom_known){.modes = 0};
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *from = &rom->harmonic[h];
		struct hawser_harmonic *to = frozen->harmonic + 2*(size_t)from->k;

		if (from->answer)
			add((double *[]){to[0].answer, to[1].answer}, rom, from, omega, from->answer,
			    rom->known.shape, HAWSER__ANSWER(rom)/2);
		if (from->answer_line)
			add((double *[]){to[0].answer_line, to[1].answer_line}, rom, from, omega,
			    from->answer_line, rom->known.line, HAWSER__ANSWER_LINE(rom)/2);
	}
	return &frozen->rom;
}

void hawser__rom_frozen_release(struct hawser__frozen *frozen)
{
	free(frozen->harmonic);
	free(frozen->memory);
	*frozen = (struct hawser__frozen){.room = 0};
}

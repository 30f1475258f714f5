/* rom/terms/rates.h - terms of second and third order in velocities alone, such as those of a wind. See
 * rates.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_RATES_H
#define HAWSER_ROM_RATES_H

#include "rom/terms/terms.h"

struct hawser__rates;
struct hawser_rom_kernel;

/* Divide the terms of the model: kernel->rates, NULL if it has too few of them or too many
 * coordinates, and kernel->other. Returns 0 if memory is short. */
int hawser__rates_make(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom);
/* Its values, of other values of the same terms. */
void hawser__rates_fill(struct hawser__rates *rates, const struct hawser_rom *rom);
void hawser__rates_free(struct hawser__rates *rates);

/* Add them at `count` states, whose v, force, by_v of `to` follow each other, of stride 1; or at
 * HAWSER_LANES states of that stride (count 1). */
void hawser__rates_add(const struct hawser__rates *rates, const struct hawser__more *to,
                       const double *v, int count);

#endif

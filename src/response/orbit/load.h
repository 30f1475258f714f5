/* response/orbit/load.h - a model whose load is multiplied by a factor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOAD_H
#define HAWSER_RESPONSE_LOAD_H

#include <hawser/rom.h>

/* `rom` is the model to use: it shares all members with the original except the harmonics and,
 * in part, the motion of the ends. */
struct hawser__load {
	const struct hawser_rom *full;
	struct hawser_rom rom;
	double *memory;
	struct hawser_quad *quad; /* the Q of the harmonics */
	struct hawser_term *term; /* their terms */
	struct hawser_rom_ends *ends; /* with the factor, or NULL */
	double factor;
};

enum hawser_status hawser__load_open(struct hawser__load *load, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__load_set(struct hawser__load *load, double factor);

/* The factor of a harmonic at a load factor, and its derivative by the load factor. */
double hawser__load_share(const struct hawser_harmonic *harmonic, double factor);
double hawser__load_rate(const struct hawser_harmonic *harmonic, double factor);

void hawser__load_clear(struct hawser__load *load);

#endif

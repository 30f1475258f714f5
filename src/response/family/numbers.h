/* response/family/numbers.h - all numbers of a model that depend on a parameter. See numbers.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_NUMBERS_H
#define HAWSER_RESPONSE_NUMBERS_H

#include <stddef.h>

#include <hawser/rom.h>

#define HAWSER__ROUND_OFF 2e-11 /* of the modes (EXACT in study/map/family.c), relative */
enum { HAWSER__PARTS = 400 };

/* `count` numbers, `stride` bytes apart. */
struct hawser__number_part {
	char *at;
	size_t count, stride;
};

struct hawser__number_parts {
	int count;
	struct hawser__number_part part[HAWSER__PARTS];
};

/* Where they are: K, D, the values of the entries of Q, C and terms, harmonics, units, shapes. A model
 * with more parts than there is room for has HAWSER__PARTS. */
void hawser__number_parts(struct hawser__number_parts *parts, struct hawser_rom *rom);
double *hawser__number(const struct hawser__number_part *part, size_t i);

/* Give all models the entries that one has, as far as they are more than round-off; 0: memory is
 * short. */
int hawser__same_entries(struct hawser_rom *const rom[], int roms);
/* The entries of `from` instead of some of them. */
void hawser__copy_entries(struct hawser_rom *to, struct hawser_rom *from);
/* Whether a model that got them has still as many. */
int hawser__has_entries(struct hawser_rom *rom, struct hawser_rom *from);

#endif

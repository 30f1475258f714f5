/* core/digits.h - numbers as text with 17 significant digits, faster than printf; see digits.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_DIGITS_H
#define HAWSER_CORE_DIGITS_H

#include <stddef.h>
#include <stdint.h>

enum {
	HAWSER__LEAST_POWER = -292, /* 10^(16 - 308), for the largest double */
	HAWSER__MOST_POWER = 340,   /* 10^(16 + 324), for the smallest */
	HAWSER__DIGITS_SIZE = 32    /* of the longest text, with the final 0 */
};

/* Powers of ten: 10^(i + HAWSER__LEAST_POWER) = mantissa*2^exponent, the mantissa rounded down. */
struct hawser__powers {
	struct hawser__power {
		uint64_t mantissa; /* its highest bit is 1 */
		int exponent;
	} power[HAWSER__MOST_POWER - HAWSER__LEAST_POWER + 1];
};
void hawser__powers_make(struct hawser__powers *powers);

/* text [HAWSER__DIGITS_SIZE]: the finite `value` as JSON with 17 significant digits, correctly rounded,
 * which strtod reads back to the same bits; trailing zeros are omitted. Always with "." or "e", in
 * every locale. Returns the length. */
size_t hawser__digits(char *text, double value, const struct hawser__powers *powers);

#endif

/* core/locale.h - numbers in texts and files have a decimal point, whatever the locale of the program
 * that uses the library.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_LOCALE_H
#define HAWSER_CORE_LOCALE_H

#include <locale.h>
#include <stddef.h>
#include <stdint.h>

/* The locale C for the calling thread, from begin to end. */
struct hawser__locale {
	locale_t own, c; /* c: 0 if there is no memory for it: the thread then keeps its own */
};

static inline void hawser__locale_begin(struct hawser__locale *locale)
{
	locale->c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
	locale->own = locale->c ? uselocale(locale->c) : (locale_t)0;
}

static inline void hawser__locale_end(const struct hawser__locale *locale)
{
	if (!locale->c)
		return;
	uselocale(locale->own);
	freelocale(locale->c);
}

/* --- digits.c: numbers as text with 17 significant digits, faster than printf --- */

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

/* core/locale.h - numbers in texts and files have a decimal point, whatever the locale of the program
 * that uses the library.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_LOCALE_H
#define HAWSER_CORE_LOCALE_H

#include <locale.h>

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

#endif

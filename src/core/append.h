/* core/append.h - texts that are put together from parts. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_APPEND_H
#define HAWSER_CORE_APPEND_H

#include <stddef.h>

#include <hawser/status.h>

/* Add to text [size]: `between`, where something stands there already, and what the format writes. What
 * has no room is left out. */
void hawser__append(char *text, size_t size, const char *between, const char *format, ...)
	HAWSER_PRINTF(4, 5);

/* --- spelling.c: edit distance of two names --- */

/* Damerau-Levenshtein distance (optimal string alignment): insertions, deletions, substitutions
 * and swaps of neighbours cost 2, a change of case alone 1. Only the first 63 characters count. */
int hawser__edit_distance(const char *a, const char *b);

/* Largest distance of a suggestion for a name of this length. */
int hawser__edit_limit(size_t length);

#endif

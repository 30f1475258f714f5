/* core/spelling.h - edit distance of two names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SPELLING_H
#define HAWSER_CORE_SPELLING_H

#include <stddef.h>

/* Damerau-Levenshtein distance (optimal string alignment): insertions, deletions, substitutions
 * and swaps of neighbours cost 2, a change of case alone 1. Only the first 63 characters count. */
int hawser__edit_distance(const char *a, const char *b);

/* Largest distance of a suggestion for a name of this length. */
int hawser__edit_limit(size_t length);

#endif

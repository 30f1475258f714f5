/* core/hold.h - arrays of a structure that are released together.
 *
 * A structure with many arrays has a `struct hawser__hold`, which knows them: they are asked for one by
 * one, whether there was memory for all of them is asked once, and they are released at once. Pointers
 * may be exchanged; none of the arrays may be given to free or realloc.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_HOLD_H
#define HAWSER_CORE_HOLD_H

#include <stddef.h>
#include <stdlib.h>

/* All zero: nothing is held. */
struct hawser__hold {
	struct hawser__held *last;
	int short_of_memory; /* 1: an array is missing */
};

/* An array of `count` elements of `size` bytes, all zero; NULL if memory is short. */
void *hawser__hold(struct hawser__hold *hold, size_t count, size_t size);
/* Release all; nothing is held then. */
void hawser__hold_clear(struct hawser__hold *hold);

/* A matrix [a][b] of zeros that is released by itself; also one without elements is an array. */
static inline double *hawser__numbers(size_t a, size_t b)
{
	/* NOLINTNEXTLINE(clang-analyzer-optin.portability.UnixAPI): sizes are limited */
	return calloc(a*b + 1, sizeof(double));
}

/* What is behind n numbers of an array, which may be NULL: to that C adds nothing. */
static inline double *hawser__behind(double *array, size_t n)
{
	return array + (array ? n : 0);
}

#endif

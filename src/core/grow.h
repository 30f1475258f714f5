/* core/grow.h - arrays that grow by one element at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_GROW_H
#define HAWSER_CORE_GROW_H

#include <stdlib.h>
#include <string.h>

/* Room for another element, of `size` bytes, behind the `count` that the array has; `array` is the
 * address of the pointer to it, NULL at first. The room doubles where the count is a power of 2, so
 * nothing but the count need be known. Not 0: memory is short, and the array is as it was. */
static inline int hawser__more(void *array, long count, size_t size)
{
	void *larger;

	if (count & (count - 1))
		return 0;
	memcpy(&larger, array, sizeof larger); /* a pointer to elements of any type */
	/* cppcheck-suppress memleakOnRealloc ; *array has it */
	larger = realloc(larger, (count ? 2*(size_t)count : 1)*size + 1);
	if (larger)
		memcpy(array, &larger, sizeof larger);
	return !larger;
}

/* Make room for `count` elements of `size` bytes; not 0: as above. */
static inline int hawser__resize(void *array, size_t count, size_t size)
{
	void *larger;

	memcpy(&larger, array, sizeof larger);
	/* cppcheck-suppress memleakOnRealloc ; *array has it */
	larger = realloc(larger, count*size + 1);
	if (larger)
		memcpy(array, &larger, sizeof larger);
	return !larger;
}

#endif

/* core/hold.c - see hold.h. Each array is an allocation of its own, behind a link to the one before it,
 * so that tools find accesses beyond its end. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>

#include "core/hold.h"

struct hawser__held {
	struct hawser__held *before;
	max_align_t array[]; /* aligned for any type */
};

void *hawser__hold(struct hawser__hold *hold, size_t count, size_t size)
{
	struct hawser__held *held = NULL;

	if (count < (SIZE_MAX - sizeof *held)/size)
		held = calloc(1, sizeof *held + count*size);
	if (!held) {
		hold->short_of_memory = 1;
		return NULL;
	}
	held->before = hold->last;
	hold->last = held;
	return held->array;
}

void hawser__hold_clear(struct hawser__hold *hold)
{
	while (hold->last) {
		struct hawser__held *held = hold->last;

		hold->last = held->before;
		free(held);
	}
	hold->short_of_memory = 0;
}

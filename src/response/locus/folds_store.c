/* response/locus/folds_store.c - see folds_store.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "response/locus/folds_store.h"

void hawser__store_add(struct hawser__fold_store *store, const double *y)
{
	size_t size = (size_t)store->size;

	if (store->count == store->capacity) {
		int capacity = store->capacity ? 2*store->capacity : 16;
		double *larger = realloc(store->y, (size_t)capacity*size*sizeof *larger);

		if (!larger) {
			store->failed = 1;
			return;
		}
		store->y = larger;
		store->capacity = capacity;
	}
	memcpy(store->y + (size_t)store->count++*size, y, size*sizeof *y);
}

const double *hawser__store_find(const struct hawser__fold_store *store, double omega)
{
	for (int i = 0; i < store->count; i++) {
		const double *y = store->y + (size_t)i*(size_t)store->size;

		if (y[store->size - 1] == omega)
			return y;
	}
	return NULL;
}

void hawser__store_clear(struct hawser__fold_store *store)
{
	free(store->y);
	*store = (struct hawser__fold_store){.size = store->size};
}

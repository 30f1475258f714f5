/* response/locus/folds_store.c - see folds_store.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "response/locus/folds_store.h"

void hawser__store_add(struct hawser__fold_store *store, const double *y)
{
	size_t size = (size_t)store->size;

	if (hawser__more(&store->y, store->count, size*sizeof *store->y)) {
		store->failed = 1;
		return;
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

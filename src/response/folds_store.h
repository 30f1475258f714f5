/* response/folds_store.h - orbits by harmonic balance, found again by their frequency.
 *
 * A state at one phase leads back to its orbit only where an integration over a period is accurate:
 * not in stiff models, nor on strongly unstable orbits. So the orbits of folds are kept whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_STORE_H
#define HAWSER_RESPONSE_FOLDS_STORE_H

#include <hawser/frf.h>

struct hawser__fold_store {
	int size;          /* of an orbit: Fourier coefficients and Omega, the last */
	int count, capacity;
	double *y;         /* [count][size] */
	int failed;        /* there was no memory for one */
};

void hawser__store_add(struct hawser__fold_store *store, const double *y);
/* The orbit of exactly this Omega, or NULL. */
const double *hawser__store_find(const struct hawser__fold_store *store, double omega);
void hawser__store_clear(struct hawser__fold_store *store);

#endif

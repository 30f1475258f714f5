/* response/locus/folds_store.h - orbits by harmonic balance, stored by their frequency.
 *
 * The state at one phase determines the orbit only if an integration over a period is accurate,
 * which it is not for stiff models and strongly unstable orbits. Therefore the complete orbits of
 * folds are stored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_STORE_H
#define HAWSER_RESPONSE_FOLDS_STORE_H

#include <hawser/frf.h>

struct hawser__fold_store {
	int size;          /* of an orbit: Fourier coefficients and Omega, the last */
	int count;
	double *y;         /* [count][size] */
	int failed;        /* 1: an orbit was not stored for lack of memory */
};

void hawser__store_add(struct hawser__fold_store *store, const double *y);
/* The orbit with exactly this Omega, or NULL. */
const double *hawser__store_find(const struct hawser__fold_store *store, double omega);
void hawser__store_clear(struct hawser__fold_store *store);

#endif

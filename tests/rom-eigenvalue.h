/* tests/rom-eigenvalue.h - an eigenvalue of a linear reduced model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_ROM_EIGENVALUE_H
#define HAWSER_TESTS_ROM_EIGENVALUE_H

#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include <lapacke.h>

#include <hawser/rom.h>

/* The eigenvalue of u'' + D u' + K u = 0 that is next to `near`. */
static inline double complex eigenvalue(const struct hawser_rom *rom, double complex near)
{
	int n = rom->n, N = 2*n;
	double *A = calloc((size_t)N*(size_t)N, sizeof *A), *w = calloc(2*(size_t)N, sizeof *w);
	double complex best = INFINITY;

	for (int j = 0; j < n; j++) {
		A[j*N + n + j] = 1.0;
		for (int k = 0; k < n; k++) {
			A[(n + j)*N + k] = -rom->K[j*n + k];
			A[(n + j)*N + n + k] = -rom->D[j*n + k];
		}
	}
	if (!LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', N, A, N, w, w + N, NULL, 1, NULL, 1))
		for (int i = 0; i < N; i++)
			if (cabs(w[i] + I*w[N + i] - near) < cabs(best - near))
				best = w[i] + I*w[N + i];
	free(A);
	free(w);
	return best;
}

#endif

/* response/orbit/rest.c - see rest.h.
 *
 *   m        coordinates that are no modes, the last of n
 *   W = k Omega, F   frequency and force [m] of a harmonic
 *
 * u = Re X exp(i (W t - phase)) solves u'' + D u' + K u = F cos(W t - phase) for
 *
 *   [K - W^2   -W D  ] [Re X]   [F]
 *   [W D       K - W^2] [Im X] = [0]
 *
 * with the blocks of these coordinates alone: all others are at rest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/rest.h"

/* X [2 m] of a harmonic, -1 where W is a natural frequency of these coordinates without damping. */
static int respond(double *X, double *matrix, lapack_int *pivot, const struct hawser_rom *rom,
                   const double *force, double W)
{
	int n = rom->n, m = rom->inertia.shapes, first = n - m;

	for (int j = 0; j < m; j++) {
		for (int k = 0; k < m; k++) {
			double K = rom->K[(first + j)*n + first + k], D = rom->D[(first + j)*n + first + k];

			K -= j == k ? W*W : 0.0;
			matrix[k*2*m + j] = matrix[(m + k)*2*m + m + j] = K;
			matrix[k*2*m + m + j] = W*D;
			matrix[(m + k)*2*m + j] = -W*D;
		}
		X[j] = force[first + j];
		X[m + j] = 0.0;
	}
	return LAPACKE_dgesv_work(LAPACK_COL_MAJOR, 2*m, 1, matrix, 2*m, pivot, X, 2*m) ? -1 : 0;
}

int hawser__rest(double *y, const struct hawser_rom *rom, double tau, double omega)
{
	size_t m = (size_t)rom->inertia.shapes, n = (size_t)rom->n;
	double *work = calloc(2*m + 4*m*m + 1, sizeof *work);
	lapack_int *pivot = calloc(2*m + 1, sizeof *pivot);

	memset(y, 0, 2*n*sizeof *y);
	for (int h = 0; m && work && pivot && h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		double W = harmonic->k*omega, share = pow(omega, harmonic->omega_power);
		double angle = harmonic->k*tau - (harmonic->phase == HAWSER_SIN ? 0.5*M_PI : 0.0);

		if (!harmonic->f || respond(work, work + 2*m, pivot, rom, harmonic->f, W))
			continue;
		for (size_t j = 0; j < m; j++) {
			double re = share*work[j], im = share*work[m + j];

			y[n - m + j] += re*cos(angle) - im*sin(angle);
			y[2*n - m + j] -= W*(re*sin(angle) + im*cos(angle));
		}
	}
	free(work);
	free(pivot);
	return !work || !pivot ? -1 : 0;
}

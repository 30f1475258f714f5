/* response/cycle/turn.c - rotations of the coordinates that leave a model as it is, such as those of a
 * round string about its axis.
 *
 *    a(u, v)   acceleration of the model
 *    G         antisymmetric: a_u G u + a_v G v - G a = 0 at all states
 *
 * That is linear in G. It is asked at as many states as there are unknowns; a G exists where the least
 * singular value is round-off. A cycle u is then one of a family exp(s G) u.
 *
 * Reference: Krupa, SIAM J. Math. Anal. 21 (1990) 1453.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/cycle/cycle.h"

enum { MOST = 16 };     /* coordinates of models that are asked */
#define NOTHING 1e-12   /* least singular value, relative to what its matrix is the sum of; chosen */

/* The columns of the states' rows for each entry G_jk = -G_kj, j < k: row [n][unknowns], zeros before.
 * *size: sum of the squares of what they are the sums of. */
static void fill(double *row, double *size, int unknowns, const struct hawser_rom *rom,
                 const double *u, const double *v, double *work)
{
	int n = rom->n, column = 0;
	double *a = work, *by_u = a + n, *by_v = by_u + n*n, *unused = by_v + n*n;

	hawser_rom_acceleration_jacobian(rom, a, by_u, by_v, unused, u, v, 0.0, 1.0);
	for (int j = 0; j < n; j++)
		for (int k = j + 1; k < n; k++, column++) {
			for (int i = 0; i < n; i++) {
				const double part[] = {by_u[i*n + j]*u[k], -by_u[i*n + k]*u[j], by_v[i*n + j]*v[k],
				                       -by_v[i*n + k]*v[j]};

				for (int q = 0; q < 4; q++) {
					row[i*unknowns + column] += part[q];
					*size += part[q]*part[q];
				}
			}
			row[j*unknowns + column] -= a[k];
			row[k*unknowns + column] += a[j];
		}
}

/* Numbers of size 1 that have nothing to do with the model. */
static double scattered(int i)
{
	return sin(12.9898*i + 0.2385*i*i);
}

enum hawser_status hawser__cycle_turn(double *turn, int *found, const struct hawser_rom *rom,
                                      struct hawser_report *report)
{
	int n = rom->n, unknowns = n*(n - 1)/2, states = unknowns/n + 2, rows = states*n, info, at = 0;
	double *matrix, *work, *value, *right, size = 0.0, unused;

	*found = 0;
	if (n < 2 || n > MOST)
		return HAWSER_OK;
	matrix = calloc((size_t)rows*unknowns + (size_t)unknowns*(unknowns + 1), sizeof *matrix);
	work = malloc(((size_t)2*n*n + 4*(size_t)n)*sizeof *work);
	if (!matrix || !work) {
		free(matrix);
		free(work);
		return hawser__no_memory(report, "frf");
	}
	value = matrix + (size_t)rows*unknowns;
	right = value + unknowns;
	for (int i = 0; i < states; i++) {
		double state[2*MOST];

		for (int j = 0; j < 2*n; j++)
			state[j] = scattered(at++);
		fill(matrix + (size_t)i*n*unknowns, &size, unknowns, rom, state, state + n, work);
	}
	info = LAPACKE_dgesvd(LAPACK_ROW_MAJOR, 'N', 'A', rows, unknowns, matrix, unknowns, value, &unused,
	                      1, right, unknowns, work);
	if (!info && value[unknowns - 1] <= NOTHING*sqrt(size)) {
		const double *entry = right + (size_t)(unknowns - 1)*unknowns;

		*found = 1;
		for (int j = 0; j < n; j++)
			for (int k = j; k < n; k++) {
				double g = k > j ? *entry++ : 0.0;

				turn[j*n + k] = g;
				turn[k*n + j] = -g;
			}
	}
	free(matrix);
	free(work);
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "frf") : HAWSER_OK;
}

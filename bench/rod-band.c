/* bench/rod-band - elimination in the band of a rod: processor time of factors and of a solution with
 * src/rod/band.c and with LAPACK's dgbtrf and dgbtrs on the same storage, after a comparison of both
 * solutions. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "bench/clock.h"
#include "rod/mesh.h"

enum { SIDE = HAWSER__BAND_SIDE, ROWS = HAWSER__BAND_ROWS, REPEATS = 5, ROUNDS = 200 };

static double number(void) /* -1 to 1 */
{
	static unsigned long seed = 7719;

	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

/* One matrix factored and one right side solved: by LAPACK, or by the rods' own elimination. */
static int eliminate(struct hawser__band *band, double *x, int lapack)
{
	if (lapack)
		return LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, band->n, band->n, SIDE, SIDE, band->a, ROWS,
		                           band->pivot) ||
		       LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', band->n, SIDE, SIDE, 1, band->a, ROWS,
		                           band->pivot, x, band->n);
	if (hawser__band_factor(band))
		return 1;
	hawser__band_solve(band, x);
	return 0;
}

/* s of processor time, the shortest of some repeats; x: the solution. */
static double timed(struct hawser__band *band, const double *matrix, const double *right, double *x,
                    int lapack)
{
	double least = INFINITY;

	for (int r = 0; r < REPEATS; r++) {
		double began = cpu_secs();

		for (int k = 0; k < ROUNDS; k++) {
			memcpy(band->a, matrix, (size_t)band->n*ROWS*sizeof *matrix);
			memcpy(x, right, (size_t)band->n*sizeof *x);
			if (eliminate(band, x, lapack))
				return NAN;
		}
		least = fmin(least, (cpu_secs() - began)/ROUNDS);
	}
	return least;
}

/* Returns 1 if the solutions differ, or there is no memory. */
static int compare(int elements)
{
	struct hawser_report report;
	struct hawser__band band = {0};
	int n = 6*(elements + 1), bad = hawser__band_open(&band, n, &report) != HAWSER_OK;
	double *matrix = calloc((size_t)n*ROWS, sizeof *matrix), *x = calloc(3*(size_t)n, sizeof *x);
	double seconds[2] = {0.0}, apart = 0.0, size = 0.0;

	bad = bad || !matrix || !x;
	if (!bad) {
		hawser__band_zero(&band);
		for (int i = 0; i < n; i++) {
			x[i] = number();
			for (int j = i > SIDE ? i - SIDE : 0; j <= i + SIDE && j < n; j++)
				*hawser__band_at(&band, i, j) = (i == j ? 10.0 : 1.0)*number();
		}
		memcpy(matrix, band.a, (size_t)n*ROWS*sizeof *matrix);
		for (int k = 0; k < 2; k++)
			seconds[k] = timed(&band, matrix, x, x + (size_t)(k + 1)*(size_t)n, k);
		for (int i = 0; i < n; i++) {
			apart = fmax(apart, fabs(x[n + i] - x[2*n + i]));
			size = fmax(size, fabs(x[2*n + i]));
		}
		bad = !(apart < 1e-9*size);
		printf("%d\t%d\t%.1f\t%.1f\t%.2f\t%.1e\n", elements, n, 1e6*seconds[0], 1e6*seconds[1],
		       seconds[1]/seconds[0], apart/size);
	}
	free(matrix);
	free(x);
	hawser__band_clear(&band);
	return bad;
}

int main(void)
{
	int bad = 0;

	printf("elements\tunknowns\town_us\tlapack_us\tratio\tdifference\n");
	for (int elements = 20; elements <= 500; elements *= 5)
		bad |= compare(elements);
	return bad;
}

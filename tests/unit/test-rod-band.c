/* Elimination in the band of a rod against LAPACK's dense one: random matrices of all sizes, whose
 * diagonals are small or 0, so that rows are exchanged; singular ones and NaN.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "rod/mesh.h"
#include "tests/tap.h"

enum { MOST = 70, SIDE = HAWSER__BAND_SIDE };
static unsigned long seed = 7719;
static double dense[MOST*MOST], right[MOST], x[MOST];

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

/* A matrix whose diagonal is that of other elements, times `diagonal`. */
static void fill(struct hawser__band *band, double diagonal)
{
	int n = band->n;

	memset(dense, 0, sizeof dense);
	hawser__band_zero(band);
	for (int i = 0; i < n; i++) {
		for (int j = i > SIDE ? i - SIDE : 0; j <= i + SIDE && j < n; j++) {
			dense[i*n + j] = (i == j ? diagonal : 1.0)*number();
			*hawser__band_at(band, i, j) = dense[i*n + j];
		}
		x[i] = right[i] = number();
	}
}

/* Largest difference to LAPACK's solution, over the largest number of that; -1: LAPACK has none. */
static double apart(struct hawser__band *band, double diagonal)
{
	lapack_int pivot[MOST], n = band->n;
	double most = 0.0, size = 0.0;

	fill(band, diagonal);
	if (hawser__band_factor(band))
		return INFINITY;
	hawser__band_solve(band, x);
	if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, dense, n, pivot, right, 1))
		return -1.0;
	for (int i = 0; i < n; i++) {
		most = fmax(most, fabs(x[i] - right[i]));
		size = fmax(size, fabs(right[i]));
	}
	return most/size;
}

/* With the rows in the same order, and sums in another, results differ by round-off times the
 * condition of the matrix, up to some 1e4 here. */
static void solutions(void)
{
	static const double diagonals[] = {1.0, 1e-9, 0.0};
	double worst = 0.0;

	for (int n = 2; n <= MOST; n++)
		for (int d = 0; d < 3; d++) {
			struct hawser_report report = {0};
			struct hawser__band band = {0};

			if (hawser__band_open(&band, n, &report))
				worst = INFINITY;
			else
				worst = fmax(worst, apart(&band, diagonals[d]));
			hawser__band_clear(&band);
		}
	ok(worst < 1e-9, "as LAPACK's dgesv: %.1e of the largest unknown", worst);
}

static void singular(void)
{
	struct hawser_report report = {0};
	struct hawser__band band = {0};
	int n = 40, opened = hawser__band_open(&band, n, &report) == HAWSER_OK;

	if (opened) {
		fill(&band, 1.0);
		for (int i = 20 - SIDE; i <= 20 + SIDE; i++)
			*hawser__band_at(&band, i, 20) = 0.0;
	}
	ok(opened && hawser__band_factor(&band) == 1, "a column of zeros is told");
	if (opened) {
		fill(&band, 1.0);
		*hawser__band_at(&band, 0, 0) = NAN;
	}
	ok(opened && hawser__band_factor(&band) == 1, "NaN in the first pivot is told");
	hawser__band_clear(&band);
}

CASE(unit_rod_band)
{
	solutions();
	singular();
	return done_testing();
}

/* rod/band.c - see band.h. LAPACK's band solver with row exchanges: away from equilibrium, and with
 * loads that follow the rod, the matrix is not symmetric.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "rod/band.h"

/* A pivot that is smaller than this part of its diagonal element is 0: round-off of a direction that
 * costs no energy, as the turn of a rod that hangs from a hinge. */
#define ROUND 1e-11
enum { SIDE = HAWSER__BAND_SIDE, ROWS = HAWSER__BAND_ROWS };

enum hawser_status hawser__band_open(struct hawser__band *band, int n, struct hawser_report *report)
{
	band->n = n;
	band->a = malloc((size_t)n*ROWS*sizeof *band->a);
	band->pivot = malloc((size_t)n*sizeof *band->pivot);
	return band->a && band->pivot ? HAWSER_OK : hawser__no_memory(report, "rod");
}

void hawser__band_clear(struct hawser__band *band)
{
	free(band->a);
	free(band->pivot);
	*band = (struct hawser__band){0};
}

void hawser__band_zero(struct hawser__band *band)
{
	memset(band->a, 0, (size_t)band->n*ROWS*sizeof *band->a);
}

double hawser__band_hold(struct hawser__band *band, int i)
{
	double *own = hawser__band_at(band, i, i), size = fabs(*own);

	if (!(size > 0.0))
		size = 1.0;
	for (int j = i > SIDE ? i - SIDE : 0; j <= i + SIDE && j < band->n; j++)
		*hawser__band_at(band, i, j) = 0.0;
	*own = size;
	return size;
}

int hawser__band_negative(struct hawser__band *band, const unsigned char *held, double *work)
{
	int negative = 0;

	/* work[i][k] is L(i, i - k), and D(i) for k = 0. */
	for (int i = 0; i < band->n; i++)
		for (int k = i < SIDE ? i : SIDE; k >= 0; k--) {
			const double *other = work + (long)(i - k)*(SIDE + 1);
			double *own = work + (long)i*(SIDE + 1), size, sum;

			sum = 0.5*(*hawser__band_at(band, i, i - k) + *hawser__band_at(band, i - k, i));
			if (held[i] || held[i - k])
				sum = k == 0;
			size = fabs(sum);
			for (int m = k + 1; m <= SIDE && m <= i; m++)
				sum -= own[m]*work[(long)(i - m)*(SIDE + 1)]*(k == 0 ? own[m] : other[m - k]);
			own[k] = k == 0 ? sum : sum/other[0];
			negative += k == 0 && sum < -ROUND*size;
		}
	return negative;
}

int hawser__band_factor(struct hawser__band *band)
{
	return LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, band->n, band->n, SIDE, SIDE, band->a, ROWS,
	                           band->pivot) != 0;
}

void hawser__band_solve(const struct hawser__band *band, double *x)
{
	(void)LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', band->n, SIDE, SIDE, 1, band->a, ROWS, band->pivot,
	                          x, band->n);
}

/* rod/band.c - see mesh.h. Elimination with row exchanges: away from equilibrium, and with loads that
 * follow the rod, the matrix is not symmetric. Algorithm and storage are those of LAPACK's dgbtf2
 * and dgbtrs, which take 1.6 to 2.7 times as long, since they call the BLAS for a dozen numbers at a
 * time (bench/rod-band).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/mesh.h"

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

/* to -= factor times from, of `count` numbers that do not overlap. Counts that are constant and even
 * are made of pairs by compilers at -O2. */
static inline void subtract(double *restrict to, const double *restrict from, double factor, int count)
{
	for (int i = 0; i < count; i++)
		to[i] -= factor*from[i];
}

/* Rows j and j + by, from column j on. */
static void exchange(struct hawser__band *band, int j, int by, int last)
{
	for (int k = j; k <= last; k++) {
		double *a = hawser__band_at(band, j, k), swap = *a;

		*a = a[by];
		a[by] = swap;
	}
}

int hawser__band_factor(struct hawser__band *band)
{
	int last = 0, n = band->n; /* last: column that the rows so far reach, as ju in dgbtf2 */

	for (int j = 0; j < n; j++) {
		double *own = hawser__band_at(band, j, j), most = fabs(own[0]);
		int pivot = 0;

		for (int i = 1; i <= SIDE; i++) /* what is beyond the last row is 0 */
			if (fabs(own[i]) > most) {
				most = fabs(own[i]);
				pivot = i;
			}
		if (!(most > 0.0))
			return 1;
		band->pivot[j] = j + pivot;
		if (last < j + SIDE + pivot)
			last = j + SIDE + pivot < n ? j + SIDE + pivot : n - 1;
		if (pivot)
			exchange(band, j, pivot, last);
		own[0] = 1.0/own[0];
		for (int i = 1; i <= SIDE; i++)
			own[i] *= own[0];
		for (int k = j + 1; k <= last; k++) {
			double *to = hawser__band_at(band, j, k);

			if (to[0] != 0.0)
				subtract(to + 1, own + 1, to[0], SIDE + 1);
		}
	}
	return 0;
}

void hawser__band_solve(const struct hawser__band *band, double *x)
{
	int n = band->n;

	for (int j = 0; j < n; j++) {
		const double *own = band->a + (long)j*ROWS + 2*SIDE;
		double part = x[band->pivot[j]];

		x[band->pivot[j]] = x[j];
		x[j] = part;
		if (j + SIDE + 1 < n)
			subtract(x + j + 1, own + 1, part, SIDE + 1);
		else
			subtract(x + j + 1, own + 1, part, n - 1 - j);
	}
	for (int j = n - 1; j >= 0; j--) {
		const double *own = band->a + (long)j*ROWS;

		x[j] *= own[2*SIDE];
		if (j >= 2*SIDE)
			subtract(x + j - 2*SIDE, own, x[j], 2*SIDE);
		else
			subtract(x, own + 2*SIDE - j, x[j], j);
	}
}

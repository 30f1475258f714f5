/* rod/band.h - the band matrix of a rod, its unknowns in the order of the nodes, and its factors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_BAND_H
#define HAWSER_ROD_BAND_H

#include <hawser/status.h>

enum { HAWSER__BAND_SIDE = 11 }; /* diagonals on either side: two nodes of six unknowns */
/* Of a column: 2*SIDE above the diagonal, with fill by pivots, SIDE below, and two that stay 0. */
enum { HAWSER__BAND_ROWS = 3*HAWSER__BAND_SIDE + 3 };

struct hawser__band {
	int n;
	double *a;   /* [n][HAWSER__BAND_ROWS] columns */
	int *pivot;  /* [n] */
};
enum hawser_status hawser__band_open(struct hawser__band *band, int n, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__band_clear(struct hawser__band *band);
void hawser__band_zero(struct hawser__band *band);

static inline double *hawser__band_at(struct hawser__band *band, int i, int j)
{
	return band->a + (long)j*HAWSER__BAND_ROWS + 2*HAWSER__BAND_SIDE + i - j;
}

/* The equation of unknown i becomes x_i = its right side, multiplied by the factor returned. */
double hawser__band_hold(struct hawser__band *band, int i);
/* The number of negative eigenvalues of the symmetric part, by the signs of the pivots of LDL', and
 * `work` [n][HAWSER__BAND_SIDE + 1]. What is held must be held in both its row and its column. */
int hawser__band_negative(struct hawser__band *band, const unsigned char *held /* [n] */, double *work);
/* x [n]: the right side, then the solution. Returns 0, or 1 if the matrix is singular. */
int hawser__band_factor(struct hawser__band *band);
void hawser__band_solve(const struct hawser__band *band, double *x);

#endif

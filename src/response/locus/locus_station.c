/* response/locus/locus_station.c - the numbers of a point of a locus; see locus_walk.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "response/locus/locus_walk.h"

void hawser__locus_describe(struct hawser__locus_walk *walk, struct hawser__locus_station *station)
{
	const struct hawser__locus *locus = walk->locus;
	int n = locus->n, R = locus->rows;

	hawser__locus_orbit(walk->locus, station->z);
	for (int j = 0; j < n; j++) {
		double most = 0.0;

		for (int r = 0; r < R; r++) {
			double a = fabs(locus->u[(size_t)r*n + j]);
			double b = fabs(locus->u[(size_t)((r + 1)%R)*n + j]);
			double c = fabs(locus->u[(size_t)((r + R - 1)%R)*n + j]), bend = 2.0*a - b - c;

			if (a >= b && a >= c)
				most = fmax(most, a + (bend > 0.0 ? 0.125*(b - c)*(b - c)/bend : 0.0));
		}
		station->coordinate[j] = most;
		station->state[j] = locus->u[j];
		station->state[n + j] = locus->omega*locus->du[j];
	}
	station->point = (struct hawser_locus_point){
		.omega = station->z[LOCUS_OMEGA], .parameter = station->z[LOCUS_PARAMETER],
		.angle = 2.0*M_PI*station->z[LOCUS_KAPPA], .arc = station->arc,
		.residual = station->correction.residual, .mesh = locus->mesh,
		.harmonics = locus->order, .iterations = station->correction.iterations,
		.unstable = station->point.unstable};
	if (locus->kind == HAWSER_RESONANCE)
		hawser__locus_phase(walk->locus, &station->point, station->z);
}

double hawser__locus_turn(const struct hawser__locus_walk *walk, const double complex *from,
                          const double complex *to)
{
	int shift = (walk->next.order - walk->here.order)*walk->locus->n;
	double product = 0.0, one = 0.0, other = 0.0;

	for (int k = 0; k < walk->locus->wide; k++) {
		double complex before = k >= shift ? from[k - shift] : 0.0;

		product += creal(conj(before)*to[k]);
		one += creal(conj(before)*before);
		other += creal(conj(to[k])*to[k]);
	}
	return acos(fmax(-1.0, fmin(1.0, product/sqrt(one*other))));
}

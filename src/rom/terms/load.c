/* rom/terms/load.c - the varying load of a scene as forces on modes; its pieces: statics/load.c.
 *
 * Each multiple k of the frequency has on mode j the forces
 *
 *    f_j cos   =   scale * integral of Phi_j . f cos(phase - kappa s) ds
 *    f_j sin   = - scale * integral of Phi_j . f sin(phase - kappa s) ds
 *
 * The integrals are exact at the ends a and b of a piece: the elements of the modes' grid are
 * divided there, and in a wave so that the phase changes by at most HAWSER__LOAD_STEP on each part,
 * on which the Gauss rule is exact to round-off. A force F at a point is a piece without length: its
 * work is F . Phi_j there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "rom/terms/load.h"

static double work_at(const struct hawser__piece *piece, const struct hawser__loads *loads, int h,
                      const struct hawser_modes *modes, int j, double s)
{
	double phi[3], f[3];

	hawser_modes_at(modes, phi, NULL, j, s);
	hawser__piece_at(f, piece, loads, h, &modes->statics, s);
	return phi[0]*f[0] + phi[1]*f[1] + phi[2]*f[2];
}

/* Integral over [from, to] inside element e, by the rule of the element, scaled, on as many parts as
 * a wave needs. */
static double panel(const struct hawser__piece *piece, const struct hawser__loads *loads, int h,
                    const struct hawser_modes *modes, int j, int e, double from, double to)
{
	const struct hawser_grid *grid = &modes->grid;
	int parts = 1 + (int)(fabs(piece->kappa)*(to - from)/HAWSER__LOAD_STEP);
	double width = (to - from)/parts, sum = 0.0;
	double shrink = width/(grid->edge[e + 1] - grid->edge[e]);

	for (int p = 0; p < parts; p++)
		for (int i = 0; i < grid->order; i++) {
			double s = from + p*width + 0.5*width*(1.0 + grid->node[i]);

			sum += shrink*grid->weight[e*grid->order + i]*work_at(piece, loads, h, modes, j, s);
		}
	return sum;
}

double hawser__loads_work(const struct hawser__loads *loads, int h, const struct hawser_modes *modes,
                          int j)
{
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0;

	for (int i = 0; i < loads->count; i++) {
		const struct hawser__piece *piece = &loads->piece[i];

		if (piece->harmonic[loads->sine[h]] != h)
			continue;
		if (piece->from == piece->to)
			sum += work_at(piece, loads, h, modes, j, piece->from);
		for (int e = 0; e < grid->elements; e++) {
			double from = fmax(grid->edge[e], piece->from);
			double to = fmin(grid->edge[e + 1], piece->to);

			if (from < to)
				sum += panel(piece, loads, h, modes, j, e, from, to);
		}
	}
	return loads->scale*sum;
}

double hawser__loads_most(const struct hawser__loads *loads, const struct hawser_modes *modes, int j)
{
	double most = 0.0;

	if (loads->harmonics == 1)
		return hawser__loads_work(loads, 0, modes, j);
	for (int h = 0; h < loads->harmonics; h++) {
		double square = 0.0;

		for (int i = 0; i < loads->harmonics; i++)
			if (loads->k[i] == loads->k[h])
				square += pow(hawser__loads_work(loads, i, modes, j), 2.0);
		most = fmax(most, sqrt(square));
	}
	return most;
}

/* rom/condense/displaced.c - effect of the coordinate of one mode on displacements of the cable.
 *
 * A displacement is x = sum u_j X_j + 1/2 sum u_j u_k X_jk, where X_jk is due to the condensed
 * modes, so that dx/du_s = X_s + sum over j of X_sj u_j.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rom/build/model.h"
#include "rom/choose/weigh.h"

static int points_of(const struct hawser_rom *all)
{
	return all->shapes.points < HAWSER__COUNTED/3 ? all->shapes.points : HAWSER__COUNTED/3;
}

/* dx/du_s, dy/du_s, dz/du_s at shape point p. */
static void slopes(double *xyz, const struct hawser_rom *all, int p, int s, const double *u)
{
	const struct hawser_rom_shapes *shapes = &all->shapes;
	double local[3];

	memcpy(local, shapes->shape + ((size_t)s*shapes->points + p)*3, sizeof local);
	for (int j = 0; shapes->second_shape && j < all->n; j++) {
		size_t low = j < s ? j : s, high = j < s ? s : j;
		const double *pair = shapes->second_shape +
		                     ((high*(high + 1)/2 + low)*shapes->points + p)*3;

		for (int i = 0; i < 3; i++)
			local[i] += pair[i]*u[j];
	}
	hawser__shapes_global(xyz, shapes, p, local);
}

void hawser__largest_displacements(double *most, const struct hawser_rom *all, const double *u,
                                   int rows)
{
	memset(most, 0, HAWSER__COUNTED*sizeof *most);
	for (int p = 0; p < points_of(all); p++)
		for (int t = 0; t < rows; t++) {
			double xyz[3];

			hawser_rom_displacement(all, xyz, p, u + (size_t)t*all->n);
			for (int i = 0; i < 3; i++)
				most[3*p + i] = fmax(most[3*p + i], fabs(xyz[i]));
		}
}

double hawser__displaced(const struct hawser_rom *all, int s, const double *u, const double *delta,
                         int rows, unsigned counted, const double *most)
{
	double worst = 0.0;

	for (int p = 0; p < points_of(all); p++)
		for (int t = 0; t < rows && counted >> 3*p & 7; t++) {
			double xyz[3];

			slopes(xyz, all, p, s, u + (size_t)t*all->n);
			for (int i = 0; i < 3; i++)
				if (counted >> (3*p + i) & 1 && most[3*p + i] > 0.0)
					worst = fmax(worst, fabs(xyz[i]*delta[t])/most[3*p + i]);
		}
	return worst;
}

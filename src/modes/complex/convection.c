/* modes/complex/convection.c - modal matrices of the travel speed.
 *
 * A particle at S has the velocity du/dt + v du/dS, so that the modes are coupled by the derivative
 * along S in the local frame, (a, b, c) of modes.h. With fixed ends the integral of (Phi_j .
 * Phi_k)' vanishes and G is skew. It is computed as half the difference of the two integrals, so
 * that it is exactly skew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>

#include <hawser/modes.h>
#include "core/vec3.h"

/* Integral of left . right over the grid, fields of [points][3]. */
static double integral(const struct hawser_grid *grid, const double *left, const double *right)
{
	double sum = 0.0;

	for (int i = 0; i < grid->points; i++)
		sum += grid->weight[i]*hawser__dot(left + 3*i, right + 3*i);
	return sum;
}

/* Integral of the component of a field along the cable, times the static stretch |x'|. */
static double along(const struct hawser_modes *modes, const double *field)
{
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0;

	for (int i = 0; i < grid->points; i++)
		sum += grid->weight[i]*field[3*i]
		       *(1.0 + hawser_statics_frame(&modes->statics, grid->s[i]).strain);
	return sum;
}

void hawser_modes_convection(const struct hawser_modes *modes, double *G, double *D, double *g,
                             double *d)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t size = (size_t)grid->points*3, n = (size_t)modes->n;

	for (size_t j = 0; j < n; j++) {
		const double *shape = modes->shape + j*size, *slope = modes->slope + j*size;

		for (size_t k = 0; k <= j; k++) {
			const double *shape_k = modes->shape + k*size, *slope_k = modes->slope + k*size;

			if (G) {
				G[j*n + k] = 0.5*(integral(grid, shape, slope_k)
				                  - integral(grid, shape_k, slope));
				G[k*n + j] = -G[j*n + k];
			}
			if (D)
				D[j*n + k] = D[k*n + j] = integral(grid, slope, slope_k);
		}
		if (g)
			g[j] = along(modes, shape);
		if (d)
			d[j] = along(modes, slope);
	}
}

/* modes/label.c - norm, sign, family and symmetry of a mode (doc/theory-modes.md, "Labels").
 *
 *   share_f  integral of component f squared, over that of Phi.Phi: part of the kinetic energy
 *   sigma    integral of f(s) f(l-s) over that of f(s)^2, f the component with the largest share:
 *            1 - 2*(share of the antisymmetric part), so 1 symmetric and -1 antisymmetric
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "modes/grid.h"
#include "modes/label.h"

/* A mode is called symmetric when at least 99 % of its dominant component's energy is. */
static const double symmetric_from = 0.98;
/* The sign is set where the dominant component first comes to this part of its maximum: never near
 * a zero, and before the first extremum, so round-off cannot turn it. */
static const double sign_at = 0.3;

static double mirrored(const struct hawser_grid *grid, const double *shape, int f, int i)
{
	double all[3];

	if (grid->elements == 1)
		return shape[3*(grid->points - 1 - i) + f];
	hawser__grid_at(all, grid, shape, 3, 3, grid->edge[grid->elements] - grid->s[i]);
	return all[f];
}

static double mirror_product(const struct hawser_grid *grid, const double *shape, int f)
{
	double sum = 0.0;

	for (int i = 0; i < grid->points; i++)
		sum += grid->weight[i]*shape[3*i + f]*mirrored(grid, shape, f, i);
	return sum;
}

static double sign_of(const struct hawser_grid *grid, const double *shape, int f)
{
	double largest = 0.0;

	for (int i = 0; i < grid->points; i++)
		largest = fmax(largest, fabs(shape[3*i + f]));
	for (int i = 0; i < grid->points; i++)
		if (fabs(shape[3*i + f]) >= sign_at*largest)
			return shape[3*i + f] < 0.0 ? -1.0 : 1.0;
	return 1.0;
}

double hawser__mode_label(struct hawser_modes *modes, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	struct hawser_mode *mode = modes->mode + k;
	double *shape = modes->shape + (size_t)k*3*(size_t)grid->points;
	double *slope = modes->slope + (size_t)k*3*(size_t)grid->points;
	double share[3] = {0.0}, all, scale, sigma;
	int f = 0;

	for (int i = 0; i < grid->points; i++)
		for (int c = 0; c < 3; c++)
			share[c] += grid->weight[i]*shape[3*i + c]*shape[3*i + c];
	all = share[0] + share[1] + share[2];
	for (int c = 1; c < 3; c++)
		if (share[c] > share[f])
			f = c;
	mode->axial_share = share[0]/all;
	mode->family = f == 0 ? HAWSER_LONGITUDINAL : HAWSER_TRANSVERSE;
	sigma = mirror_product(grid, shape, f)/share[f];
	mode->symmetry = sigma >= symmetric_from ? HAWSER_SYMMETRIC
	                 : sigma <= -symmetric_from ? HAWSER_ANTISYMMETRIC : HAWSER_MIXED;
	scale = sign_of(grid, shape, f)/sqrt(all);
	for (int i = 0; i < 3*grid->points; i++) {
		shape[i] *= scale;
		slope[i] *= scale;
	}
	return sqrt(all);
}

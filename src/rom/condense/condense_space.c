/* rom/condense/condense_space.c - the condition that both ends are fixed, of condense.c, for a
 * cable in space: each piece between attachments has its own plane, so that the multiplier lambda
 * solves a system of three equations.
 *
 *    e, n, b      local frame, b the normal of the plane of the piece
 *    M            integral of eps e e' + (n n' + b b')/k, in axes along and across the chord and z'
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "core/solve3.h"
#include "rom/condense/condense.h"

struct hawser__place hawser__space_place(const struct hawser_modes *modes,
                                         const struct hawser_frame_point *at, double weight)
{
	double chord = hypot(1.0, modes->statics.hs), c = 1.0/chord, sine = modes->statics.hs/chord;
	double g = 1.0 + at->strain;
	struct hawser__place place = {.weight = weight, .eps = modes->statics.epsilon,
	                              .k = at->tension/g, .g2 = g*g, .space = 1};

	for (int k = 0; k < 3; k++) {
		place.axis[k][0] = at->axis[k][0]*c + at->axis[k][1]*sine;
		place.axis[k][1] = at->axis[k][1]*c - at->axis[k][0]*sine;
		place.axis[k][2] = at->axis[k][2];
	}
	return place;
}

void hawser__space_ties_add(struct hawser__ties *ties, const struct hawser__place *at)
{
	ties->space = 1;
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			ties->M[i][j] += at->weight*(at->eps*at->axis[0][i]*at->axis[0][j] +
			                             (at->axis[1][i]*at->axis[1][j] +
			                              at->axis[2][i]*at->axis[2][j])/at->k);
}

/* By Cholesky, from the stiff directions on: M is graded, its least entry along the chord. */
void hawser__space_ties_solve(double lambda[3], const struct hawser__ties *ties, const double r[3])
{
	double M[3][3], b[3], x[3];

	for (int i = 0; i < 3; i++) {
		b[i] = r[2 - i];
		for (int j = 0; j < 3; j++)
			M[i][j] = ties->M[2 - i][2 - j];
	}
	hawser__solve3(x, M, b, 0.0);
	for (int i = 0; i < 3; i++)
		lambda[i] = x[2 - i];
}

void hawser__space_reach(double r[3], const struct hawser__place *at, const double q[3], double factor)
{
	for (int c = 0; c < 3; c++)
		r[c] += factor*(q[0]*at->axis[0][c] + q[1]*at->axis[1][c] + q[2]*at->axis[2][c]);
}

double hawser__space_along(const struct hawser__place *at, const double lambda[3], int k)
{
	return lambda[0]*at->axis[k][0] + lambda[1]*at->axis[k][1] + lambda[2]*at->axis[k][2];
}

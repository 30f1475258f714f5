/* rom/shapes.c - from coordinates back to metres and newtons at the shape points.
 *
 *   P, Q, B   mode shape along e, n, z        a, b, c   its derivative in that frame
 *   e = (ex, ey, 0), n = (-ey, ex, 0)         g         static stretch |x'|
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <hawser/rom.h>

static void add(double out[3], const struct hawser_rom *rom, const double *field, size_t row, int p,
                double factor)
{
	const double *at = field + (row*rom->shapes.points + p)*3;

	for (int i = 0; i < 3; i++)
		out[i] += factor*at[i];
}

/* sum over modes of u_j field_j(p), and of 1/2 u_j u_k second_jk(p) of the condensed ones. */
static void combine(double out[3], const struct hawser_rom *rom, const double *field,
                    const double *second, int p, const double *u)
{
	out[0] = out[1] = out[2] = 0.0;
	for (int j = 0; j < rom->n; j++)
		add(out, rom, field, (size_t)j, p, u[j]);
	for (int k = 0; second && k < rom->n; k++)
		for (int j = 0; j <= k; j++)
			add(out, rom, second, (size_t)k*(k + 1)/2 + j, p,
			    j == k ? 0.5*u[j]*u[k] : u[j]*u[k]);
}

void hawser_rom_displacement(const struct hawser_rom *rom, double *xyz, int p, const double *u)
{
	double ex = rom->shapes.tangent[2*p], ey = rom->shapes.tangent[2*p + 1], local[3];

	combine(local, rom, rom->shapes.shape, rom->shapes.second_shape, p, u);
	xyz[0] = local[0]*ex - local[1]*ey;
	xyz[1] = local[0]*ey + local[1]*ex;
	xyz[2] = local[2];
}

double hawser_rom_tension(const struct hawser_rom *rom, int p, const double *u)
{
	double g = rom->shapes.stretch[p], d[3], more;

	combine(d, rom, rom->shapes.slope, rom->shapes.second_slope, p, u);
	more = d[0]*(2.0*g + d[0]) + d[1]*d[1] + d[2]*d[2]; /* |q'|^2 - g^2, without subtracting */
	return rom->shapes.EA*((g - 1.0) + more/(g + sqrt(g*g + more)));
}

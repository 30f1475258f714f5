/* rom/shapes.c - from coordinates back to metres and newtons at the shape points.
 *
 *   P, Q, B   mode shape along e, n, z        a, b, c   its derivative in that frame
 *   e = (ex, ey, 0), n = (-ey, ex, 0)         g         static stretch |x'|
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <hawser/rom.h>

static void add(double out[3], const double *field, size_t row, int points, int p, double factor)
{
	const double *at = field + (row*points + p)*3;

	for (int i = 0; i < 3; i++)
		out[i] += factor*at[i];
}

/* sum over modes of u_j field_j(p), and of 1/2 u_j u_k second_jk(p) of the condensed ones. */
static void combine(double out[3], int n, int points, const double *field, const double *second,
                    int p, const double *u)
{
	out[0] = out[1] = out[2] = 0.0;
	for (int j = 0; j < n; j++)
		add(out, field, (size_t)j, points, p, u[j]);
	for (int k = 0; second && k < n; k++)
		for (int j = 0; j <= k; j++)
			add(out, second, (size_t)k*(k + 1)/2 + j, points, p,
			    j == k ? 0.5*u[j]*u[k] : u[j]*u[k]);
}

void hawser_rom_displacement(const struct hawser_rom *rom, double *xyz, int p, const double *u)
{
	double ex = rom->shapes.tangent[2*p], ey = rom->shapes.tangent[2*p + 1], local[3];

	combine(local, rom->n, rom->shapes.points, rom->shapes.shape, rom->shapes.second_shape, p,
	        u);
	xyz[0] = local[0]*ex - local[1]*ey;
	xyz[1] = local[0]*ey + local[1]*ex;
	xyz[2] = local[2];
}

/* From the static stretch g and the strains d. Of a travelling cable both are per length of the
 * apparent one, which is 1/(1 - m) of the actual one: EA (|q'|/(1 - m) - 1). */
static double tension(const struct hawser_rom *rom, double g, const double d[3])
{
	double more = d[0]*(2.0*g + d[0]) + d[1]*d[1] + d[2]*d[2]; /* |q'|^2 - g^2, without subtracting */

	double m = rom->shapes.mach2;

	return rom->shapes.EA*((g - 1.0) + more/(g + sqrt(g*g + more)) + m)/(1.0 - m);
}

double hawser_rom_tension(const struct hawser_rom *rom, int p, const double *u)
{
	double d[3];

	combine(d, rom->n, rom->shapes.points, rom->shapes.slope, rom->shapes.second_slope, p, u);
	return tension(rom, rom->shapes.stretch[p], d);
}

int hawser_rom_tensions(const struct hawser_rom *rom, double *least, double *most, const double *u)
{
	const struct hawser_rom_line *line = &rom->line;
	int points = line->points ? line->points : rom->shapes.points;
	double low = HUGE_VAL, high = -HUGE_VAL;

	if (points == 0 || !(rom->shapes.EA > 0.0))
		return 0;
	for (int p = 0; p < points; p++) {
		double d[3], here;

		if (line->points) {
			combine(d, rom->n, points, line->slope, line->second_slope, p, u);
			here = tension(rom, line->stretch[p], d);
		} else {
			here = hawser_rom_tension(rom, p, u);
		}
		low = fmin(low, here);
		high = fmax(high, here);
	}
	*least = low;
	*most = high;
	return 1;
}

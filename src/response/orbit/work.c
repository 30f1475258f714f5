/* response/work.c - what computing orbits costs, counted.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/orbit.h>

#define STAGE 1e-7   /* s of a sample of harmonic balance, over the square of the number of coordinates */
#define JUDGE 1.2e-6 /* s of a set of multipliers, over the cube of that number */
#define FLOP 1e-9    /* s */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, int n)
{
	double square = (double)n*n;

	if (cost->flops > 0.0)
		return FLOP*cost->flops;
	return STAGE*square*(double)cost->stages + JUDGE*square*n*(double)cost->judged;
}

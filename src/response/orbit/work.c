/* response/orbit/work.c - what computing orbits costs, counted.
 *
 * Samples, and the operations of the linear systems and of the multipliers. The constants were fitted
 * to 130 curves of 14 scenes, by balance with 5 to 13 coordinates of tensors and 30 to 42 of exact
 * energy, by shooting with 4 to 16: to their processor time on a core of 2.6 GHz with busy neighbours,
 * times 1.4. Counts over these, of curves that took more than 0.05 s: 0.6 to 1.4, seldom 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/orbit.h>

#define SAMPLE 1.5e-6  /* s of a sample of harmonic balance */
#define TENSORS 8e-8   /* the same over the square of the number of coordinates */
#define EXACT 1.5e-8   /* the same of a model with exact energy */
#define SOLVED 7e-11   /* s, of the linear systems of harmonic balance and of multipliers */
#define FLOP 1.5e-11   /* s, of shooting, where products are long; */
#define SHORT 40.0     /* with so many coordinates they take twice that */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom)
{
	double square = (double)rom->n*rom->n;

	if (cost->flops > 0.0)
		return FLOP*(1.0 + SHORT/rom->n)*cost->flops;
	return (SAMPLE + (rom->exact ? EXACT : TENSORS)*square)*(double)cost->stages +
	       SOLVED*cost->dense;
}

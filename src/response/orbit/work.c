/* response/work.c - what computing orbits costs, counted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/orbit.h>

#define SAMPLE 1e-5   /* s of a sample of harmonic balance */
#define TENSORS 3e-7  /* the same over the square of the number of coordinates; includes solving */
#define EXACT 1e-7    /* the same of a model with exact energy, solved in blocks */
#define JUDGING 6e-7  /* s of a set of multipliers, over the cube of that number */
#define FLOP 2e-10    /* s, of shooting */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom)
{
	double square = (double)rom->n*rom->n;

	if (cost->flops > 0.0)
		return FLOP*cost->flops;
	return (SAMPLE + (rom->exact ? EXACT : TENSORS)*square)*(double)cost->stages +
	       JUDGING*square*rom->n*(double)cost->judged;
}

/* response/orbit/work.c - what computing orbits costs, counted.
 *
 * Samples, and the operations of the linear systems and of the multipliers. Processor time of whole
 * curves on a core of 2 GHz with busy neighbours, over the count: 0.5 to 1.4 for drafts with exact
 * energy of 30 to 72 coordinates (footbridge, conductor, condensed-worse, wave, deep-sag), 1.2 to 1.3
 * for the responses of the first two; 0.6 to 1.0 with 6 to 32 coordinates of tensors (bridge-stay,
 * chairlift), 0.4 to 1.0 by shooting with 5 and 11 (the same).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/orbit.h>

#define SAMPLE 5e-6   /* s of a sample of harmonic balance */
#define TENSORS 1e-7  /* the same over the square of the number of coordinates */
#define EXACT 1.5e-8  /* the same of a model with exact energy */
#define FLOP 2e-10    /* s, of shooting */
#define SOLVED 7e-11  /* s, of the linear systems of harmonic balance and of multipliers */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom)
{
	double square = (double)rom->n*rom->n;

	if (cost->flops > 0.0)
		return FLOP*cost->flops;
	return (SAMPLE + (rom->exact ? EXACT : TENSORS)*square)*(double)cost->stages +
	       SOLVED*cost->dense;
}

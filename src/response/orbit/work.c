/* response/orbit/work.c - what computing orbits costs, counted.
 *
 * Processor time of whole curves on a core of 2 GHz, of which a busy neighbour took up to half, over
 * the count: 0.5 to 1.0 for drafts with exact energy of 30 to 72 coordinates and 0.7 to 1.0 with
 * multipliers of 30 to 36 of them (footbridge, conductor, bridge-stay, tongue, wave); 0.9 to 1.1 with
 * 6 and 32 coordinates of tensors (condensed-worse); 0.5 to 1.7 by shooting with 5 to 16 (chairlift,
 * B Table 5.4, bridge-stay, span-start). Multipliers where hardly any coordinate can be condensed
 * take 5 to 8 times as long (wave, 60 coordinates, 0.6 s).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/orbit.h>

#define SAMPLE 1e-5   /* s of a sample of harmonic balance */
#define TENSORS 3e-7  /* the same over the square of the number of coordinates; includes solving */
#define EXACT 1e-7    /* the same of a model with exact energy, solved in blocks */
#define JUDGING 4e-7  /* s of a set of multipliers, over the cube of that number */
#define FLOP 2e-10    /* s, of shooting and of matrices */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom)
{
	double square = (double)rom->n*rom->n;

	if (cost->flops > 0.0)
		return FLOP*cost->flops;
	return (SAMPLE + (rom->exact ? EXACT : TENSORS)*square)*(double)cost->stages +
	       JUDGING*square*rom->n*(double)cost->judged + FLOP*cost->dense;
}

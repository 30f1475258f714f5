/* response/orbit/work.c - what computing orbits costs, counted.
 *
 * Processor time of whole curves on a core of 2 GHz, of which a busy neighbour took up to half, over
 * the count: 0.5 to 1.0 for drafts with exact energy of 30 to 72 coordinates (footbridge, conductor,
 * bridge-stay, tongue, wave); 0.9 to 1.1 with 6 and 32 coordinates of tensors (condensed-worse); 0.5 to
 * 1.7 by shooting with 5 to 16 (chairlift, B Table 5.4, bridge-stay, span-start). A set of multipliers
 * with exact energy took 2.4 to 8.2 ms on an idle core (30 to 60 coordinates, the same scenes), 0.25 to
 * 0.75 of the count. Where hardly any coordinate can be condensed it takes 5 to 8 times as long.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/orbit.h>

#define SAMPLE 1e-5   /* s of a sample of harmonic balance */
#define TENSORS 3e-7  /* the same over the square of the number of coordinates; includes solving */
#define EXACT 1e-7    /* the same of a model with exact energy, solved in blocks */
#define JUDGING 4e-7  /* s of a set of multipliers, over the cube of that number */
#define JUDGING_EXACT 1.5e-7 /* the same with exact energy */
#define FLOP 2e-10    /* s, of shooting and of matrices */

double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom)
{
	double square = (double)rom->n*rom->n;

	if (cost->flops > 0.0)
		return FLOP*cost->flops;
	return (SAMPLE + (rom->exact ? EXACT : TENSORS)*square)*(double)cost->stages +
	       (rom->exact ? JUDGING_EXACT : JUDGING)*square*rom->n*(double)cost->judged +
	       FLOP*cost->dense;
}

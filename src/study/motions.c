/* study/motions.c - see motions.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "hawser/integrate.h"
#include "study/motions.h"

enum { rows = 48 }; /* samples of a period */

int hawser__nearest_point(const struct hawser_frf *frf, double arc)
{
	int best = 0;

	for (int i = 1; i < frf->points; i++)
		if (fabs(frf->point[i].arc - arc) < fabs(frf->point[best].arc - arc))
			best = i;
	return best;
}

enum hawser_status hawser__weigh_orbit(struct hawser_choice *choice, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf, int i, int whole,
                                       unsigned counted, unsigned peaks,
                                       struct hawser_report *report)
{
	double omega = frf->point[i].omega, period = 2.0*M_PI/omega, *u;
	struct hawser_integrate_options options = {
		.omega = omega, .until = period, .every = period/rows, .rtol = 1e-7, .atol = 1e-12,
		.initial = frf->state + (size_t)i*2*(size_t)frf->n,
	};
	size_t kept = (size_t)(rom->n - rom->inertia.shapes);
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, rom, &options, report);

	u = malloc((size_t)rows*kept*sizeof *u);
	if (!status && !u)
		status = hawser__no_memory(report, "study");
	for (int t = 0; !status && t < rows; t++)
		memcpy(u + (size_t)t*kept, run.state + (size_t)t*2*(size_t)rom->n,
		       kept*sizeof *u);
	if (!status)
		status = hawser__choice_weigh(choice, u, rows, omega, whole, counted, peaks,
		                              rom, report);
	free(u);
	hawser_trajectory_clear(&run);
	return status;
}

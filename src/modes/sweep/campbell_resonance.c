/* modes/sweep/campbell_resonance.c - intersections of excitation lines with the branches of a Campbell
 * diagram. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <hawser/campbell.h>

#include "core/grow.h"
#include "core/report.h"

/* Frequency of branch b minus that of the excitation line of the given slope, at station i,
 * rad/s. */
static double above(const struct hawser_campbell *campbell, int i, int b, double slope)
{
	return campbell->im[i*campbell->branches + b] - slope*campbell->station[i].speed;
}

static enum hawser_status add(struct hawser_campbell_resonance **list, int *count,
                              const struct hawser_campbell_resonance *one,
                              struct hawser_report *report)
{
	if (hawser__more(list, *count, sizeof **list))
		return hawser__no_memory(report, "campbell");
	(*list)[(*count)++] = *one;
	return HAWSER_OK;
}

static enum hawser_status along(struct hawser_campbell_resonance **list, int *count,
                                const struct hawser_campbell *campbell, int b, int harmonic,
                                double slope, struct hawser_report *report)
{
	for (int i = 1; i < campbell->stations; i++) {
		double before = above(campbell, i - 1, b, slope), after = above(campbell, i, b, slope);
		double from = campbell->station[i - 1].speed, to = campbell->station[i].speed;
		double speed = from + (to - from)*before/(before - after);
		const struct hawser_campbell_resonance one = {harmonic, b, speed, slope*speed};
		enum hawser_status status;

		if ((before > 0.0) == (after > 0.0) || isnan(before) || isnan(after))
			continue;
		status = add(list, count, &one, report);
		if (status)
			return status;
	}
	return HAWSER_OK;
}

enum hawser_status hawser_campbell_resonances(struct hawser_campbell_resonance **resonance,
                                              int *count, const struct hawser_campbell *campbell,
                                              double spacing, int harmonics,
                                              struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*resonance = NULL;
	*count = 0;
	if (!(spacing > 0.0 && isfinite(spacing)) || harmonics < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "campbell",
		                    "a spacing of %g m and %d harmonics: give a positive finite spacing, "
		                    "and one harmonic at least", spacing, harmonics);
	for (int n = 1; n <= harmonics && !status; n++)
		for (int b = 0; b < campbell->branches && !status; b++)
			status = along(resonance, count, campbell, b, n, 2.0*M_PI*n/spacing, report);
	if (status) {
		free(*resonance);
		*resonance = NULL;
		*count = 0;
	}
	return status;
}

/* study/accuracy/peaks.c - the peaks of a response, with their errors and their stability.
 *
 *    rest      smallest and largest tension at rest, N
 *    slope     [n] derivatives of these extreme tensions by the coordinates at rest, N
 *
 * The peak of a tension is that of its change from rest, since a response may change the tension by
 * a percent only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/accuracy/landmark.h"

static const double small = 1e-6; /* scaled increment of a coordinate for this derivative; chosen */
/* Longest step in a window in which a branch is traced again, relative to its range: a polynomial
 * of fourth degree needs about seven points, and most of the cost of a window is its first orbit. */
static const double step = 0.2, shorter = 0.1;
/* Required relative errors below which windows are wider and steps shorter, and shorter still. */
static const double fine = 5e-4, finest = 1e-4;

static enum hawser_status tension_at_rest(double rest[2], double **slope,
                                          const struct hawser_rom *rom,
                                          struct hawser_report *report)
{
	double *u = calloc((size_t)rom->n, sizeof *u), least, most;
	int tense, failed;

	*slope = calloc((size_t)rom->n, sizeof **slope);
	rest[0] = rest[1] = 0.0;
	tense = u && *slope && hawser_rom_tensions(rom, &rest[0], &rest[1], u);
	for (int j = 0; tense && j < rom->n; j++) {
		u[j] = small;
		(void)hawser_rom_tensions(rom, &least, &most, u);
		(*slope)[j] = fmax(fabs(most - rest[1]), fabs(least - rest[0]))/small;
		u[j] = 0.0;
	}
	failed = !u || !*slope;
	free(u);
	return failed ? hawser__no_memory(report, "study") : HAWSER_OK;
}

/* From the nearest point such that no event lies between it and the peak. */
static int is_stable(const struct hawser_frf *frf, double arc)
{
	int i = 0, next;

	while (i + 1 < frf->points && frf->point[i + 1].arc <= arc)
		i++;
	next = i + 1 < frf->points ? i + 1 : i;
	if ((frf->point[i].unstable == 0) == (frf->point[next].unstable == 0))
		return frf->point[i].unstable == 0;
	for (int k = 0; k < frf->events; k++)
		if (frf->event[k].after == i && frf->event[k].arc > arc)
			return frf->event[k].unstable[0] == 0;
	return frf->point[next].unstable == 0;
}

void hawser__largest_peaks(struct hawser_landmark *largest, const struct hawser_frf *frf,
                           const struct hawser_landmark *peak, int count)
{
	largest[0] = largest[1] = (struct hawser_landmark){.probe = -1};
	for (int k = 0; k < count; k++) {
		if (peak[k].kind != HAWSER_LANDMARK_PEAK || peak[k].probe < 0 ||
		    peak[k].size <= largest[1].size || !is_stable(frf, peak[k].arc))
			continue;
		largest[1] = peak[k].size > largest[0].size ? largest[0] : peak[k];
		largest[0] = peak[k].size > largest[0].size ? peak[k] : largest[0];
	}
}

enum hawser_status hawser_peaks(struct hawser_landmark **peak, int *count,
                                const struct hawser_frf *frf, const struct hawser_rom *rom,
                                const struct hawser_frf_options *options, double wanted,
                                struct hawser_report *report)
{
	struct hawser_frf_options again = *options;
	double rest[2], *slope;
	enum hawser_status status = tension_at_rest(rest, &slope, rom, report);

	*peak = NULL;
	*count = 0;
	if (!status)
		status = hawser__landmark_peaks(peak, count, frf, rest, slope, report);
	if (!status && wanted > 0.0) {
		/* a shallow copy: the response stays with the caller */
		struct hawser_study_curve curve = {.frf = *frf, .landmark = *peak, .landmarks = *count};
		const struct hawser__sharpening how = {.wanted = wanted, .known = wanted,
			.step = wanted < finest ? 0.0 : wanted < fine ? shorter : step,
			.reach = wanted < fine ? 2 : 1, .orbits = 1};

		again.method = frf->method;
		hawser_frf_settle(&again);
		again.skip_events = 1;
		again.samples = HAWSER_NONE;
		status = hawser__study_sharpen(&curve, rom, &again, &how, report);
	}
	for (int k = 0; !status && k < *count; k++) {
		if (!(wanted > 0.0))
			hawser__peak_allow(&(*peak)[k]);
		(*peak)[k].stable = is_stable(frf, (*peak)[k].arc);
	}
	free(slope);
	if (status) {
		free(*peak);
		*peak = NULL;
		*count = 0;
	}
	return status;
}

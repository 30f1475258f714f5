/* cli/backbone/mms_marks.c - folds and peak of a response, for hawser compare mms.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/backbone/mms_result.h"

/* Amplitude of the coordinate at an event, from the neighbouring points. */
static double at_event(const struct hawser_frf *frf, const struct hawser_frf_event *event, int mode)
{
	enum { THROUGH = 8 };
	int count = frf->points < THROUGH ? frf->points : THROUGH, first = event->after - THROUGH/2 + 1;
	double value = 0.0;

	first = first + count > frf->points ? frf->points - count : first;
	first = first < 0 ? 0 : first;
	for (int k = first; k < first + count; k++) {
		double weight = 1.0;

		for (int l = first; l < first + count; l++)
			if (l != k)
				weight *= (event->arc - frf->point[l].arc)/(frf->point[k].arc - frf->point[l].arc);
		value += weight*frf->coordinate[(size_t)k*(size_t)frf->n + (size_t)mode];
	}
	return value;
}

/* Maximum of the parabola over the arclength through the largest point and its neighbours. */
static void find_peak(struct cli_mms_marks *marks, const struct hawser_frf *frf, int mode)
{
	int best = 0;
	double s[3], y[3], w[3], d, t;

	for (int i = 0; i < frf->points; i++)
		if (frf->coordinate[(size_t)i*(size_t)frf->n + (size_t)mode] >
		    frf->coordinate[(size_t)best*(size_t)frf->n + (size_t)mode])
			best = i;
	marks->peak_omega = frf->point[best].omega;
	marks->peak = frf->coordinate[(size_t)best*(size_t)frf->n + (size_t)mode];
	if (best == 0 || best + 1 >= frf->points)
		return;
	for (int k = 0; k < 3; k++) {
		s[k] = frf->point[best + k - 1].arc - frf->point[best].arc;
		y[k] = frf->coordinate[(size_t)(best + k - 1)*(size_t)frf->n + (size_t)mode] - marks->peak;
		w[k] = frf->point[best + k - 1].omega - frf->point[best].omega;
	}
	d = s[0]*s[2]*(s[0] - s[2]);
	t = (y[0]*s[2]*s[2] - y[2]*s[0]*s[0])/(2.0*(y[0]*s[2] - y[2]*s[0]));
	if (!isfinite(t) || d == 0.0)
		return;
	marks->peak += t*(t*(y[0]*s[2] - y[2]*s[0]) - (y[0]*s[2]*s[2] - y[2]*s[0]*s[0]))/d;
	marks->peak_omega += t*(t*(w[0]*s[2] - w[2]*s[0]) - (w[0]*s[2]*s[2] - w[2]*s[0]*s[0]))/d;
}

void cli_mms_marks(struct cli_mms_marks *marks, const struct hawser_frf *frf, int mode)
{
	*marks = (struct cli_mms_marks){.folds = 0};
	find_peak(marks, frf, mode);
	for (int k = 0; k < frf->events && marks->folds < CLI_MMS_FOLDS; k++) {
		double a = at_event(frf, &frf->event[k], mode);
		int at = marks->folds;

		if (frf->event[k].kind != HAWSER_FOLD)
			continue;
		for (; at > 0 && marks->a[at - 1] < a; at--) {
			marks->a[at] = marks->a[at - 1];
			marks->omega[at] = marks->omega[at - 1];
		}
		marks->a[at] = a;
		marks->omega[at] = frf->event[k].omega;
		marks->folds++;
	}
}

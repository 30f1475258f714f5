/* study/sharpen.c - peaks again, in smaller steps.
 *
 * The continuation's steps are as long as it can safely take, so that a sharp peak may lie between two
 * points. About each peak that the interpolation does not know well enough, from two points before to two
 * after, the branch is followed once more within the narrow range of Omega that it covers there;
 * steps are at most a part of the range, so they are short. Peaks of several components at one resonance
 * share a window. Smaller steps everywhere would cost far more.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/landmark.h"

static const double step = 0.01;  /* of the window's range of Omega */
static const double margin = 0.5; /* of the points' range, on either side: a fold may be between them */
enum { most_points = 400 };

/* A stretch of the branch, from point `first` to point `last`. */
struct window {
	int first, last;
	double length; /* along the branch, when to stop */
	int (*asked)(void *context, const struct hawser_frf *frf);
	void *asked_context;
	int stopped; /* by the caller */
};

/* One point further than the window on either side, for the interpolation. */
static int watch(void *context, const struct hawser_frf *piece)
{
	struct window *window = context;
	const struct hawser_frf_point *end = &piece->point[piece->points - 1];

	if (end->arc - piece->point[0].arc > window->length)
		return 1;
	window->stopped = window->asked && window->asked(window->asked_context, piece);
	return window->stopped;
}

static void range_of(double range[2], const struct hawser_frf *frf, const struct window *window)
{
	double low = frf->point[window->first].omega, high = low, widen;

	for (int i = window->first + 1; i <= window->last; i++) {
		low = fmin(low, frf->point[i].omega);
		high = fmax(high, frf->point[i].omega);
	}
	widen = fmax(margin*(high - low), 1e-9*high);
	range[0] = low - widen;
	range[1] = high + widen;
}

/* Whether Omega rises where the window begins: towards the fold, where one follows at once. */
static int rises(const struct hawser_frf *frf, int first)
{
	double here = frf->point[first].omega;

	for (int i = 0; i < frf->events; i++)
		if (frf->event[i].kind == HAWSER_FOLD && frf->event[i].after == first)
			return frf->event[i].omega > here;
	return frf->point[first + 1].omega > here;
}

/* Follow a window again and look at its peaks. */
static void follow(struct hawser_study_curve *curve, const struct hawser_rom *rom,
                   const struct hawser_frf_options *options, struct window *window)
{
	const struct hawser_frf *frf = &curve->frf;
	const struct hawser_frf_point *first = &frf->point[window->first];
	struct hawser_frf_options again = *options;
	struct hawser_frf piece;
	double range[2];
	int rising = rises(frf, window->first);

	range_of(range, frf, window);
	again.from = range[!rising];
	again.to = range[rising];
	again.begin = first->omega;
	again.start = frf->state + (size_t)window->first*2*frf->n;
	again.step_max = step;
	again.locate = 0;
	again.max_points = most_points;
	again.progress = watch;
	again.progress_context = window;
	/* steps cut corners that shorter ones do not */
	window->length = 1.1*(frf->point[window->last].arc - first->arc);
	if (!hawser_frf_trace(&piece, rom, &again, NULL))
		for (int k = 0; k < curve->landmarks; k++) {
			struct hawser_landmark *peak = &curve->landmark[k];

			if (peak->kind == HAWSER_LANDMARK_PEAK && peak->arc >= first->arc &&
			    peak->arc <= frf->point[window->last].arc)
				(void)hawser__peak_again(peak, &piece, piece.point[0].arc + peak->arc -
				                         first->arc);
		}
	hawser_frf_clear(&piece);
}

/* Two points on either side of every peak that is not known well enough, marked in near [points]. */
static void mark(char *near, const struct hawser_study_curve *curve, double wanted)
{
	const struct hawser_frf *frf = &curve->frf;

	for (int k = 0; k < curve->landmarks; k++) {
		const struct hawser_landmark *peak = &curve->landmark[k];

		if (peak->kind != HAWSER_LANDMARK_PEAK ||
		    fmax(peak->omega_error, peak->size_error) <= wanted)
			continue;
		for (int i = 0; i < frf->points; i++) {
			int before = i > 1 ? i - 2 : 0, after = i + 2 < frf->points ? i + 2 : frf->points - 1;

			if (frf->point[before].arc <= peak->arc && frf->point[after].arc >= peak->arc)
				near[i] = 1;
		}
	}
}

enum hawser_status hawser__study_sharpen(struct hawser_study_curve *curve,
                                         const struct hawser_rom *rom,
                                         const struct hawser_frf_options *options, double wanted,
                                         struct hawser_report *report)
{
	struct window window = {.asked = options->progress, .asked_context = options->progress_context};
	int points = curve->frf.points;
	char *near = calloc((size_t)points + 1, 1);

	if (!near)
		return hawser__no_memory(report, "study");
	mark(near, curve, wanted);
	for (int i = 0; i + 1 < points && !window.stopped; i = window.last + 1) {
		window.first = window.last = i;
		while (near[i] && window.last + 1 < points && near[window.last + 1])
			window.last++;
		if (window.last > window.first)
			follow(curve, rom, options, &window);
	}
	free(near);
	return HAWSER_OK;
}

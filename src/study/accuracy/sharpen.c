/* study/accuracy/sharpen.c - peaks traced again in smaller steps.
 *
 * The continuation takes the longest steps that are safe. A sharp peak may therefore lie between
 * two points, and the interpolation error between distant points is uncertain. The branch is traced
 * again about each peak, from two points before to two after it, within the narrow range of Omega
 * of these points. Since steps are limited relative to the range, they are short. Peaks of several
 * components at one resonance share a window. Smaller steps along the whole branch would cost far
 * more.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy/landmark.h"

static const double step = 0.01;  /* default of the longest step, relative to the window's range of
                                   * Omega; chosen */
static const double margin = 0.5; /* widening of the window on either side, relative to the range of
                                   * its points, since a fold may lie between them; chosen */
enum { most_points = 400, beyond = 3 };
/* Largest number of coordinates for which shooting is used: its cost grows with their square, since
 * it integrates a Jacobian; chosen. */
enum { few = 8 };
/* Relative to the error of the orbits: a smaller interpolation error would not reduce the error of
 * the peak; chosen. */
static const double least = 5.0;

/* Safety factor on the estimated interpolation error between the points of the response. Of 52
 * peaks of the chairlift's response, traced again in steps ten times shorter, two had errors of up
 * to 1.15 times the estimate. */
static const double safety = 2.0;

/* A piece of a branch, from point `first` to point `last`. */
struct window {
	int first, last;
};

/* State of the computation. */
struct job {
	struct hawser_study_curve *curve;
	const struct hawser_rom *rom;
	const struct hawser_frf_options *options;
	const struct hawser__sharpening *how;
	double length; /* arclength of the present piece at which to stop */
	double work;   /* of all pieces, s; at most options->most_work, if above 0 */
	int stopped;   /* 1: stopped by the caller, or no work is left */
	struct window part;       /* of the present piece, which was traced once more, */
	struct hawser_frf closer; /* in these points; none: it failed */
};

void hawser__peak_allow(struct hawser_landmark *peak)
{
	peak->omega_error += (safety - 1.0)*(peak->omega_error - peak->omega_orbits);
	peak->size_error += (safety - 1.0)*(peak->size_error - peak->size_orbits);
}

/* Some points beyond the window, for the interpolation. */
static int watch(void *data, const struct hawser_progress_state *state)
{
	const struct hawser_frf *piece = state->frf;
	struct job *job = data;

	if (piece->points > beyond &&
	    piece->point[piece->points - 1 - beyond].arc - piece->point[0].arc > job->length)
		return 1;
	job->stopped |= hawser__told_to_stop(&job->options->progress, state);
	return job->stopped;
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

/* Whether Omega increases at the start of the window; if a fold follows at once, towards the fold. */
static int rises(const struct hawser_frf *frf, int first)
{
	double here = frf->point[first].omega;

	for (int i = 0; i < frf->events; i++)
		if (frf->event[i].kind == HAWSER_FOLD && frf->event[i].after == first)
			return frf->event[i].omega > here;
	return frf->point[first + 1].omega > here;
}

/* Trace a window of a branch again. */
static enum hawser_status trace(struct hawser_frf *piece, struct job *job,
                                const struct hawser_frf *frf, const struct window *window,
                                const char *method)
{
	const struct hawser_frf_point *first = &frf->point[window->first];
	struct hawser_frf_options again = *job->options;
	double range[2];
	int rising = rises(frf, window->first);
	enum hawser_status status;

	range_of(range, frf, window);
	again.method = method;
	again.from = range[!rising];
	again.to = range[rising];
	again.begin = first->omega;
	again.start = frf->state + (size_t)window->first*2*frf->n;
	again.step_max = job->how->step > 0.0 ? job->how->step : step;
	again.max_points = most_points;
	again.unjudged = 1;
	again.progress = (struct hawser_progress){watch, job};
	/* shorter steps change the arclength, since chords are shorter than arcs */
	job->length = 1.1*(frf->point[window->last].arc - first->arc);
	status = hawser_frf_trace(piece, job->rom, &again, NULL);
	job->work += hawser_orbit_work(&piece->cost, job->rom);
	job->stopped |= again.most_work > 0.0 && job->work > again.most_work;
	return status;
}

/* Locate one peak on a piece that begins `arc` before it; if it is not accurate enough, trace a
 * part of the piece once more, or take the last one: peaks of several components share it. */
static void look(struct hawser_landmark *peak, struct job *job, const struct hawser_frf *piece,
                 double arc)
{
	int best = hawser__peak_again(peak, piece, piece->point[0].arc + arc);
	struct window window = {best - 2, best + 2};

	if (!best || job->stopped || fmax(peak->omega_error, peak->size_error) <=
	                             job->how->wanted + least*piece->point[best].error)
		return;
	if (window.first != job->part.first) {
		job->part = window;
		hawser_frf_clear(&job->closer);
		if (trace(&job->closer, job, piece, &window, piece->method))
			hawser_frf_clear(&job->closer);
	}
	if (job->closer.points > 0)
		(void)hawser__peak_again(peak, &job->closer, job->closer.point[0].arc +
		                                             piece->point[best].arc -
		                                             piece->point[window.first].arc);
}

/* From a given state, shooting may converge to the orbit where harmonic balance does not. */
static void follow(struct job *job, const struct window *window)
{
	const struct hawser_frf *frf = &job->curve->frf;
	double first = frf->point[window->first].arc, last = frf->point[window->last].arc;
	struct hawser_frf piece;
	enum hawser_status status = trace(&piece, job, frf, window, frf->method);

	job->part.first = -1;
	if (status && !job->rom->exact && job->rom->n <= few) {
		hawser_frf_clear(&piece);
		status = trace(&piece, job, frf, window, "shooting");
	}
	if (!status)
		for (int k = 0; k < job->curve->landmarks; k++) {
			struct hawser_landmark *peak = &job->curve->landmark[k];

			if (peak->kind != HAWSER_LANDMARK_FOLD && peak->arc >= first && peak->arc <= last)
				look(peak, job, &piece, peak->arc - first);
		}
	hawser_frf_clear(&piece);
}

/* Mark in near [points] the points on either side of each peak that is not accurate enough and, if the
 * errors of the orbits count, whose error is not mostly theirs, which shorter steps do not reduce. */
static void mark(char *near, const struct hawser_study_curve *curve,
                 const struct hawser__sharpening *how)
{
	const struct hawser_frf *frf = &curve->frf;
	int reach = how->reach ? how->reach : 2;

	for (int k = 0; k < curve->landmarks; k++) {
		const struct hawser_landmark *peak = &curve->landmark[k];

		double orbits = how->orbits ? peak->size_orbits + peak->omega_orbits : 0.0;

		if (peak->kind == HAWSER_LANDMARK_FOLD ||
		    hawser__peak_unread(peak) < fmax(how->known/safety, orbits))
			continue;
		for (int i = 0; i < frf->points; i++) {
			int before = i > reach ? i - reach : 0;
			int after = i + reach < frf->points ? i + reach : frf->points - 1;

			if (frf->point[before].arc <= peak->arc && frf->point[after].arc >= peak->arc)
				near[i] = 1;
		}
	}
}

enum hawser_status hawser__study_sharpen(struct hawser_study_curve *curve,
                                         const struct hawser_rom *rom,
                                         const struct hawser_frf_options *options,
                                         const struct hawser__sharpening *how,
                                         struct hawser_report *report)
{
	struct job job = {curve, rom, options, how, .work = 0.0};
	struct window window;
	int points = curve->frf.points, peaks = curve->landmarks;
	char *near = calloc((size_t)points + 1, 1);
	double *unread = malloc(((size_t)peaks + 1)*sizeof *unread);

	if (!near || !unread) {
		free(near);
		free(unread);
		return hawser__no_memory(report, "study");
	}
	for (int k = 0; k < peaks; k++)
		unread[k] = hawser__peak_unread(&curve->landmark[k]);
	mark(near, curve, how);
	for (int i = 0; i + 1 < points && !job.stopped; i = window.last + 1) {
		window.first = window.last = i;
		while (near[i] && window.last + 1 < points && near[window.last + 1])
			window.last++;
		if (window.last > window.first)
			follow(&job, &window);
	}
	for (int k = 0; how->known > 0.0 && k < peaks; k++)
		if (curve->landmark[k].kind != HAWSER_LANDMARK_FOLD &&
		    hawser__peak_unread(&curve->landmark[k]) >= unread[k])
			hawser__peak_allow(&curve->landmark[k]); /* it was not traced again */
	hawser_frf_clear(&job.closer);
	free(near);
	free(unread);
	return HAWSER_OK;
}

/* study/landmark.c - the folds and peaks of a traced response.
 *
 *   s   arclength along the branch (a point's `arc`)
 *   a   amplitude of one probe component over the period, as a function of s
 *   t   (s - s_i)/h about the largest point i, h half the width of the stencil
 *
 * A curve is known at the continuation's points only, which lie where its steps took it. A peak is
 * the maximum of the interpolating polynomial of a(s) through the five points about the largest
 * one, and its Omega is that of the polynomial through the five Omega. In s, not in Omega: the
 * branch may turn back at the peak. The error is taken as the larger difference to the two
 * polynomials through four of the points, plus that to others through five; what the
 * orbits themselves are off by comes on top: it moves the top the more, the flatter the peak is. At
 * the ends of a branch, and where the interpolant has no single maximum between the neighbours
 * (steps too long, or a kink: the amplitude is the larger of two extremes of one period), the
 * point itself stands, with its distance to the higher neighbour as error; sharpen.c then goes
 * over the place again in smaller steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/landmark.h"

enum { stencil = 5 };
static const double share = 0.05; /* of an orbit's error, that of its Omega (frf.h) */

struct hawser_landmark_options hawser_landmark_defaults(void)
{
	return (struct hawser_landmark_options){.smallest = 0.05, .faintest = 0.01, .prominence = 0.02};
}

/* Growing list. */
struct list {
	struct hawser_landmark *item;
	int count, capacity;
};

static int append(struct list *list, const struct hawser_landmark *item)
{
	if (list->count == list->capacity) {
		int capacity = list->capacity ? 2*list->capacity : 32;
		struct hawser_landmark *larger = realloc(list->item, (size_t)capacity*sizeof *larger);

		if (!larger)
			return 1;
		list->item = larger;
		list->capacity = capacity;
	}
	list->item[list->count++] = *item;
	return 0;
}

/* --- interpolation --- */

/* Newton's form through (t, y) [n]: c becomes the divided differences. */
static void differences(double *c, const double *t, const double *y, int n)
{
	memcpy(c, y, (size_t)n*sizeof *c);
	for (int k = 1; k < n; k++)
		for (int i = n - 1; i >= k; i--)
			c[i] = (c[i] - c[i - 1])/(t[i] - t[i - k]);
}

static double value(const double *c, const double *t, int n, double x, double *slope)
{
	double p = c[n - 1], d = 0.0;

	for (int i = n - 2; i >= 0; i--) {
		d = d*(x - t[i]) + p;
		p = p*(x - t[i]) + c[i];
	}
	if (slope)
		*slope = d;
	return p;
}

/* Where the slope falls through zero in [low, high]; NAN where its signs at the ends say otherwise. */
static double summit(const double *c, const double *t, int n, double low, double high)
{
	double slope;

	(void)value(c, t, n, low, &slope);
	if (slope < 0.0)
		return NAN;
	(void)value(c, t, n, high, &slope);
	if (slope > 0.0)
		return NAN;
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(low + high);

		(void)value(c, t, n, middle, &slope);
		if (slope > 0.0)
			low = middle;
		else
			high = middle;
	}
	return 0.5*(low + high);
}

/* The maximum of the polynomial through n points about one at t = 0, between low and high. */
static int fit(double *t_top, double *size, double *omega, const double *t, const double *a,
               const double *w, int n, const double bounds[2])
{
	double c[stencil];

	differences(c, t, a, n);
	*t_top = summit(c, t, n, bounds[0], bounds[1]);
	if (isnan(*t_top))
		return 1;
	*size = value(c, t, n, *t_top, NULL);
	differences(c, t, w, n);
	*omega = value(c, t, n, *t_top, NULL);
	return 0;
}

/* What orbits i - 2 to i + 2 (those there are) are off by, relative. */
static double orbit_error(const struct hawser_frf *frf, int i)
{
	double worst = 0.0;

	for (int k = i < 2 ? 0 : i - 2; k <= i + 2 && k < frf->points; k++)
		worst = fmax(worst, frf->point[k].error);
	return worst;
}

/* Points about a top of y, where z is wanted too: up to REACH on either side of the middle one. */
enum { REACH = 4 };
struct stencils {
	int count, centre; /* points, and the first of the five in the middle */
	double t[2*REACH + 1], y[2*REACH + 1], z[2*REACH + 1];
	double bounds[2];
	double top, y_top, z_top;
	double y_change, z_change; /* relative, to stencils of four and to others of five */
};

/* Largest change, relative, by `count` points from `first` on, `stride` apart. 1: there is no top. */
static int change(struct stencils *at, double worst[2], int first, int count, int stride)
{
	double t[stencil], y[stencil], z[stencil], top, y_top, z_top;

	if (first < 0 || first + stride*(count - 1) >= at->count)
		return 0;
	for (int k = 0; k < count; k++) {
		t[k] = at->t[first + stride*k];
		y[k] = at->y[first + stride*k];
		z[k] = at->z[first + stride*k];
	}
	if (fit(&top, &y_top, &z_top, t, y, z, count, at->bounds))
		return 1;
	worst[0] = fmax(worst[0], fabs(y_top/at->y_top - 1.0));
	worst[1] = fmax(worst[1], fabs(z_top/at->z_top - 1.0));
	return 0;
}

/* By five points; and what it changes to take four of them, or a neighbour for the one at the other
 * end, or every other point: arcs are sums of chords, so that steps of different lengths meet in
 * kinks, which four of the five need not show. 1 where one of them has no top. */
static int fit_all(struct stencils *at)
{
	int first = at->centre;
	double four[2] = {0.0, 0.0}, five[2] = {0.0, 0.0};

	if (fit(&at->top, &at->y_top, &at->z_top, at->t + first, at->y + first, at->z + first, stencil,
	        at->bounds) ||
	    change(at, four, first, stencil - 1, 1) || change(at, four, first + 1, stencil - 1, 1) ||
	    change(at, five, first - 1, stencil, 1) || change(at, five, first + 1, stencil, 1) ||
	    change(at, five, first - 2, stencil, 2))
		return 1;
	at->y_change = four[0] + five[0];
	at->z_change = four[1] + five[1];
	return 0;
}

/* By how much an error of y moves z at the top: through the slope there, of which a formula for five
 * equidistant points has weights that add up to 3 a unit of t. */
static double moved(const struct stencils *at, double error)
{
	const double near = 0.01, *t = at->t + at->centre;
	double c[stencil], before, after, rate;

	differences(c, t, at->y + at->centre, stencil);
	(void)value(c, t, stencil, at->top - near, &before);
	(void)value(c, t, stencil, at->top + near, &after);
	differences(c, t, at->z + at->centre, stencil);
	(void)value(c, t, stencil, at->top, &rate);
	return fabs(rate)*fmin(3.0*error*2.0*near/fmax(before - after, 1e-300), 1.0);
}

/* --- peaks --- */

/* One component's amplitudes along the branch. */
struct signal {
	const struct hawser_frf *frf;
	int probe, axis;
};

static double amplitude(const struct signal *signal, int i)
{
	const struct hawser_frf *frf = signal->frf;

	return frf->probe[((size_t)i*frf->probes + signal->probe)*3 + signal->axis];
}

static double omega_of(const struct signal *signal, int i)
{
	return signal->frf->point[i].omega;
}

static double largest(const struct signal *signal)
{
	double most = 0.0;

	for (int i = 0; i < signal->frf->points; i++)
		most = fmax(most, amplitude(signal, i));
	return most;
}

/* The amplitude over the largest of all components: an orbit's error is of its own size, and a faint
 * component may have all of it. */
static double part(const struct signal *signal, int i)
{
	const struct hawser_frf *frf = signal->frf;
	double most = 0.0;

	for (int k = 0; k < 3*frf->probes; k++)
		most = fmax(most, frf->probe[(size_t)i*frf->probes*3 + k]);
	return amplitude(signal, i)/most;
}

/* From i on, in direction `way`, the amplitude falls by `depth` before it rises above the peak. An end
 * of the branch counts as a fall if it is one. */
static int falls(const struct signal *signal, int i, int way, double depth)
{
	double top = amplitude(signal, i);

	for (int k = i + way; k >= 0 && k < signal->frf->points; k += way) {
		double here = amplitude(signal, k);

		if (here <= top - depth)
			return 1;
		if (here > top)
			return 0;
	}
	return 0;
}

/* The point itself. */
static void stand(struct hawser_landmark *peak, const struct signal *signal, int i)
{
	int next = amplitude(signal, i + 1) > amplitude(signal, i - 1) ? i + 1 : i - 1;

	peak->arc = signal->frf->point[i].arc;
	peak->size = amplitude(signal, i);
	peak->omega = omega_of(signal, i);
	peak->size_orbits = orbit_error(signal->frf, i)/part(signal, i);
	peak->omega_orbits = share*orbit_error(signal->frf, i);
	peak->size_error = 1.0 - amplitude(signal, next)/peak->size + peak->size_orbits;
	peak->omega_error = fabs(omega_of(signal, next)/peak->omega - 1.0) + peak->omega_orbits;
}

/* 0 < i < points - 1. */
static void refine(struct hawser_landmark *peak, const struct signal *signal, int i)
{
	const struct hawser_frf *frf = signal->frf;
	int first = i > REACH ? i - REACH : 0;
	int count = (i + REACH < frf->points ? i + REACH + 1 : frf->points) - first;
	double error = orbit_error(frf, i), h;
	struct stencils at = {.count = count, .centre = i - 2 - first};

	stand(peak, signal, i);
	if (i < 2 || i + 2 >= frf->points)
		return;
	h = 0.5*(frf->point[i + 2].arc - frf->point[i - 2].arc);
	for (int k = 0; k < count; k++) {
		at.t[k] = (frf->point[first + k].arc - frf->point[i].arc)/h;
		at.y[k] = amplitude(signal, first + k);
		at.z[k] = omega_of(signal, first + k);
	}
	at.bounds[0] = at.t[i - 1 - first];
	at.bounds[1] = at.t[i + 1 - first];
	if (fit_all(&at))
		return;
	peak->arc += h*at.top;
	peak->size = at.y_top;
	peak->omega = at.z_top;
	peak->omega_orbits = share*error + moved(&at, error*peak->size)/peak->omega;
	peak->size_error = at.y_change + peak->size_orbits;
	peak->omega_error = at.z_change + peak->omega_orbits;
}

/* From the maximum at `from` to the highest that belongs to the same peak: in between the amplitude
 * does not fall by as much as tells two peaks apart. The larger of two extremes of a period has two
 * such humps, or three. */
static int climb(const struct signal *signal, int from)
{
	double depth = hawser_landmark_defaults().prominence;
	int best = from;

	for (int way = -1; way <= 1; way += 2) {
		double top = amplitude(signal, from);

		for (int i = from + way; i >= 2 && i + 2 < signal->frf->points; i += way) {
			double here = amplitude(signal, i);

			if (here < top*(1.0 - depth))
				break;
			top = fmax(top, here);
			if (here > amplitude(signal, best))
				best = i;
		}
	}
	return best;
}

static double read_between(const struct hawser_landmark *peak)
{
	return peak->omega_error - peak->omega_orbits + peak->size_error - peak->size_orbits;
}

int hawser__peak_again(struct hawser_landmark *peak, const struct hawser_frf *frf, double arc)
{
	struct signal signal = {frf, peak->probe, peak->axis};
	struct hawser_landmark again = *peak;
	int best = 0;

	for (int i = 2; i + 2 < frf->points; i++)
		if (amplitude(&signal, i) > amplitude(&signal, i - 1) &&
		    amplitude(&signal, i) >= amplitude(&signal, i + 1) &&
		    (!best || fabs(frf->point[i].arc - arc) < fabs(frf->point[best].arc - arc)))
			best = i;
	if (!best)
		return 0;
	best = climb(&signal, best);
	refine(&again, &signal, best);
	/* the orbits are off as much in long steps, whatever is stated of them there */
	if (read_between(&again) < read_between(peak)) {
		again.arc = peak->arc; /* on the branch it belongs to */
		*peak = again;
	}
	return best;
}

static int find_peaks(struct list *list, const struct signal *signal, double least,
                      double prominence)
{
	for (int i = 1; i + 1 < signal->frf->points; i++) {
		double top = amplitude(signal, i);
		struct hawser_landmark peak = {.kind = HAWSER_LANDMARK_PEAK, .probe = signal->probe,
		                               .axis = signal->axis};

		if (!(top > least) || !(top > amplitude(signal, i - 1)) ||
		    top < amplitude(signal, i + 1) || !falls(signal, i, -1, prominence*top) ||
		    !falls(signal, i, 1, prominence*top))
			continue;
		refine(&peak, signal, i);
		if (append(list, &peak))
			return 1;
	}
	return 0;
}

/* --- folds --- */

/* Root of the sum of the probes' squares (of the coordinates' where there are no probes) at point i. */
static double size_at(const struct hawser_frf *frf, int i)
{
	int count = frf->probes ? 3*frf->probes : frf->n;
	const double *all = frf->probes ? frf->probe : frf->coordinate;
	double sum = 0.0;

	for (int k = 0; k < count; k++)
		sum += all[(size_t)i*count + k]*all[(size_t)i*count + k];
	return sqrt(sum);
}

/* Nothing better than the points about it. */
static void stand_by(struct hawser_landmark *fold, const struct hawser_frf *frf, int after)
{
	int next = after + 1 < frf->points ? after + 1 : after;

	fold->size = 0.5*(size_at(frf, after) + size_at(frf, next));
	fold->size_orbits = orbit_error(frf, after);
	fold->size_error = fabs(size_at(frf, after) - size_at(frf, next))/fold->size + fold->size_orbits;
}

/* Size where the polynomial through Omega at five points turns, by the peaks' rule: the event's own
 * arc is not measured as the points' are, and the size may change fast. */
static void measure(struct hawser_landmark *fold, const struct hawser_frf *frf, int after)
{
	int first = after > REACH - 1 ? after - REACH + 1 : 0;
	int count = (after + REACH < frf->points ? after + REACH + 1 : frf->points) - first, begin;
	double error = orbit_error(frf, after), step;
	struct stencils at = {.count = count, .bounds = {0.0, 1.0}};

	stand_by(fold, frf, after);
	if (count < stencil || after + 1 >= frf->points)
		return;
	step = frf->point[after + 1].arc - frf->point[after].arc;
	begin = after - first - (fold->arc - frf->point[after].arc < 0.5*step ? 2 : 1);
	at.centre = begin < 0 ? 0 : begin + stencil > count ? count - stencil : begin;
	for (int k = 0; k < count; k++) {
		at.t[k] = (frf->point[first + k].arc - frf->point[after].arc)/step;
		at.y[k] = fold->turn*frf->point[first + k].omega;
		at.z[k] = size_at(frf, first + k);
	}
	if (fit_all(&at))
		return;
	fold->size = at.z_top;
	fold->size_orbits = error + moved(&at, share*error*fold->omega)/fold->size;
	fold->size_error = at.z_change + fold->size_orbits;
}

/* 1 for a largest Omega, -1 for a smallest: by the one of the two points about it that is further
 * away, for the other may be the fold itself but for round-off. */
static int turn(const struct hawser_frf *frf, const struct hawser_frf_event *event)
{
	double before = event->omega - frf->point[event->after].omega, then = 0.0;

	if (event->after + 1 < frf->points)
		then = event->omega - frf->point[event->after + 1].omega;
	return (fabs(before) > fabs(then) ? before : then) > 0.0 ? 1 : -1;
}

static int add_fold(struct list *list, const struct hawser_frf *frf,
                    const struct hawser_frf_event *event)
{
	struct hawser_landmark fold = {
		.kind = HAWSER_LANDMARK_FOLD, .probe = -1, .axis = -1,
		.turn = turn(frf, event),
		.arc = event->arc, .omega = event->omega,
		.omega_error = event->error, .omega_orbits = event->error,
	};

	measure(&fold, frf, event->after);
	return append(list, &fold);
}

enum hawser_status hawser_landmarks(struct hawser_landmark **landmark, int *count,
                                    const struct hawser_frf *frf,
                                    const struct hawser_landmark_options *options,
                                    struct hawser_report *report)
{
	struct hawser_landmark_options choice = options ? *options : hawser_landmark_defaults();
	struct list list = {NULL, 0, 0};
	double most = 0.0;
	int failed = 0;

	for (int i = 0; i < 3*frf->probes; i++)
		most = fmax(most, largest(&(struct signal){frf, i/3, i % 3}));
	for (int i = 0; i < frf->events && !failed; i++)
		if (frf->event[i].kind == HAWSER_FOLD)
			failed = add_fold(&list, frf, &frf->event[i]);
	for (int i = 0; i < 3*frf->probes && !failed; i++) {
		struct signal signal = {frf, i/3, i % 3};
		double own = largest(&signal);

		if (own > choice.faintest*most)
			failed = find_peaks(&list, &signal, choice.smallest*own, choice.prominence);
	}
	if (failed) {
		free(list.item);
		list = (struct list){NULL, 0, 0};
	}
	*landmark = list.item;
	*count = list.count;
	return failed ? hawser__no_memory(report, "study") : HAWSER_OK;
}

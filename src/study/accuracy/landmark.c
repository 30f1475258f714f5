/* study/accuracy/landmark.c - the folds and peaks of a traced response.
 *
 *    s   arclength along the branch (`arc` of a point)
 *    a   amplitude of one probe component over the period, as a function of s
 *    t   (s - s_i)/h about the largest point i, h half the width of the stencil
 *
 * The curve is known at the points of the continuation. A peak is the maximum of the polynomial
 * a(s) through the five points about the largest point; its Omega is the value there of the
 * polynomial through the five Omega. The variable is s, not Omega, since the branch may have a fold
 * at the peak. The error is the largest difference from the two polynomials through four of these
 * points, plus the difference from others through five. The errors of the orbits are added: they
 * shift the maximum the more, the flatter the peak is. At the ends of a branch, and if the
 * polynomial has no single maximum between the neighbours (long steps, or a kink, since the
 * amplitude is the larger of two extremes of the period), the peak is the point itself, and its
 * error the difference from the higher neighbour. sharpen.c then traces the branch there again in
 * smaller steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "core/settle.h"
#include "study/accuracy/landmark.h"
#include "study/accuracy/stencil.h"

enum { stencil = HAWSER__STENCIL };
#define PROMINENCE 0.02 /* default: drop of the amplitude on either side of a peak */
static const double share = 0.05; /* error of Omega of an orbit, relative to the error of the orbit;
                                   * chosen */
static const double round_off = 1e-9; /* change of a tension, relative, that is none of the motion;
                                       * chosen */

void hawser_landmark_settle(struct hawser_landmark_options *options)
{
	hawser__settle(&options->smallest, 0.05);
	hawser__settle(&options->faintest, 0.01);
	hawser__settle(&options->prominence, PROMINENCE);
}

/* Growing list. */
struct list {
	struct hawser_landmark *item;
	int count;
};

static int append(struct list *list, const struct hawser_landmark *item)
{
	if (hawser__more(&list->item, list->count, sizeof *list->item))
		return 1;
	list->item[list->count++] = *item;
	return 0;
}

/* Relative error of the orbits i - 2 to i + 2, as far as they exist. */
static double orbit_error(const struct hawser_frf *frf, int i)
{
	double worst = 0.0;

	for (int k = i < 2 ? 0 : i - 2; k <= i + 2 && k < frf->points; k++)
		worst = fmax(worst, frf->point[k].error);
	return worst;
}

/* --- peaks --- */

/* A function along the branch: the amplitude of a component of a probe; of a coordinate, if probe
 * is negative; or the change of the tension from its value at rest. */
struct signal {
	const struct hawser_frf *frf;
	enum hawser_landmark_kind kind;
	int probe, axis;
	double rest;
};

static struct signal signal_of(const struct hawser_frf *frf, const struct hawser_landmark *peak)
{
	return (struct signal){frf, peak->kind, peak->probe, peak->axis, peak->rest};
}

static double amplitude(const struct signal *signal, int i)
{
	const struct hawser_frf *frf = signal->frf;

	if (signal->kind == HAWSER_LANDMARK_TENSION)
		return frf->tension[2*(size_t)i + 1] - signal->rest;
	if (signal->kind == HAWSER_LANDMARK_LEAST_TENSION)
		return signal->rest - frf->tension[2*(size_t)i];
	if (signal->probe < 0)
		return frf->coordinate[(size_t)i*frf->n + signal->axis];
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

/* The ratio of the largest component to this one: the error of an orbit is relative to its largest
 * component, and a small component may have all of it. A tension is a small difference of the
 * contributions of the coordinates, each with its own error. */
static double part(const struct signal *signal, const struct hawser_landmark *peak, int i)
{
	const struct hawser_frf *frf = signal->frf;
	int count = frf->probes > 0 ? 3*frf->probes : frf->n;
	const double *all = frf->probes > 0 ? frf->probe : frf->coordinate;
	double most = 0.0;

	if (peak->follows > 0.0)
		return amplitude(signal, i)/peak->follows;
	for (int k = 0; k < count; k++)
		most = fmax(most, all[(size_t)i*(size_t)count + (size_t)k]);
	return amplitude(signal, i)/most;
}

/* Root of the sum of squares of the tension changes that the amplitudes of the single coordinates
 * at point i cause. */
static double followed(const struct hawser_frf *frf, const double *slope, int i)
{
	double sum = 0.0;

	for (int j = 0; j < frf->n; j++)
		sum += pow(slope[j]*frf->coordinate[(size_t)i*(size_t)frf->n + (size_t)j], 2);
	return sqrt(sum);
}

/* Whether, from i in direction `way`, the amplitude decreases by `depth` before it exceeds the
 * peak. An end of the branch counts as a decrease if it is lower. */
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

/* A peak at the point itself. */
static void stand(struct hawser_landmark *peak, const struct signal *signal, int i)
{
	int next = amplitude(signal, i + 1) > amplitude(signal, i - 1) ? i + 1 : i - 1;

	peak->arc = signal->frf->point[i].arc;
	peak->size = amplitude(signal, i);
	peak->omega = omega_of(signal, i);
	peak->size_orbits = orbit_error(signal->frf, i)/part(signal, peak, i);
	peak->omega_orbits = share*orbit_error(signal->frf, i);
	peak->size_error = 1.0 - amplitude(signal, next)/peak->size + peak->size_orbits;
	peak->omega_error = fabs(omega_of(signal, next)/peak->omega - 1.0) + peak->omega_orbits;
}

/* Interpolate; requires 0 < i < points - 1. */
static void refine(struct hawser_landmark *peak, const struct signal *signal, int i)
{
	const struct hawser_frf *frf = signal->frf;
	int first = i > HAWSER__REACH ? i - HAWSER__REACH : 0;
	int count = (i + HAWSER__REACH < frf->points ? i + HAWSER__REACH + 1 : frf->points) - first;
	double error = orbit_error(frf, i), h;
	struct hawser__stencils at = {.count = count, .centre = i - 2 - first};

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
	if (hawser__stencil_top(&at))
		return;
	peak->arc += h*at.top;
	peak->size = at.y_top;
	peak->omega = at.z_top;
	peak->omega_orbits = share*error + hawser__stencil_moved(&at, error*peak->size)/peak->omega;
	peak->size_error = at.y_change + peak->size_orbits;
	peak->omega_error = at.z_change + peak->omega_orbits;
}

/* The highest maximum of the same peak as the one at `from`: between two maxima of a peak the
 * amplitude decreases by less than the required prominence. Since the amplitude is the larger of
 * two extremes of a period, a peak may have two or three maxima. */
static int climb(const struct signal *signal, int from)
{
	double depth = PROMINENCE;
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
	struct signal signal = signal_of(frf, peak);
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
	/* the shorter steps do not reduce the errors of the orbits, whatever error is stated there */
	if (read_between(&again) < read_between(peak)) {
		again.arc = peak->arc; /* arclength on the original branch */
		*peak = again;
	}
	return best;
}

/* The peaks of one signal; *like has the members that describe the signal. */
static int find_peaks(struct list *list, const struct hawser_frf *frf,
                      const struct hawser_landmark *like, const double *slope, double least,
                      double prominence)
{
	struct signal signal = signal_of(frf, like);

	for (int i = 1; i + 1 < frf->points; i++) {
		double top = amplitude(&signal, i);
		struct hawser_landmark peak = *like;

		if (!(top > least) || !(top > amplitude(&signal, i - 1)) ||
		    top < amplitude(&signal, i + 1) || !falls(&signal, i, -1, prominence*top) ||
		    !falls(&signal, i, 1, prominence*top))
			continue;
		if (slope)
			peak.follows = followed(frf, slope, i);
		refine(&peak, &signal, i);
		if (append(list, &peak))
			return 1;
	}
	return 0;
}

/* --- folds --- */

/* Root of the sum of squares over the probes (the coordinates, if there are no probes) at point i. */
static double size_at(const struct hawser_frf *frf, int i)
{
	int count = frf->probes ? 3*frf->probes : frf->n;
	const double *all = frf->probes ? frf->probe : frf->coordinate;
	double sum = 0.0;

	for (int k = 0; k < count; k++)
		sum += all[(size_t)i*count + k]*all[(size_t)i*count + k];
	return sqrt(sum);
}

/* No interpolation is possible: use the neighbouring points. */
static void stand_by(struct hawser_landmark *fold, const struct hawser_frf *frf, int after)
{
	int next = after + 1 < frf->points ? after + 1 : after;

	fold->size = 0.5*(size_at(frf, after) + size_at(frf, next));
	fold->size_orbits = orbit_error(frf, after);
	fold->size_error = fabs(size_at(frf, after) - size_at(frf, next))/fold->size + fold->size_orbits;
}

/* Size at the extreme of the polynomial of Omega through five points, by the same rules as for
 * peaks. The arclength of the event is not used, since it is not measured like that of the points,
 * and the size may change rapidly. */
static void measure(struct hawser_landmark *fold, const struct hawser_frf *frf, int after)
{
	int first = after > HAWSER__REACH - 1 ? after - HAWSER__REACH + 1 : 0;
	int end = after + HAWSER__REACH < frf->points ? after + HAWSER__REACH + 1 : frf->points;
	int count = end - first, begin;
	double error = orbit_error(frf, after), step;
	struct hawser__stencils at = {.count = count, .bounds = {0.0, 1.0}};

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
	if (hawser__stencil_top(&at))
		return;
	fold->size = at.z_top;
	fold->size_orbits = error + hawser__stencil_moved(&at, share*error*fold->omega)/fold->size;
	fold->size_error = at.z_change + fold->size_orbits;
}

/* 1: Omega has a maximum, -1: a minimum. Judged by the neighbouring point that is farther away,
 * since the other may coincide with the fold to round-off. */
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

/* The peaks of all components of the probes, or of the coordinates. */
static int all_peaks(struct list *list, const struct hawser_frf *frf, int coordinates,
                     const struct hawser_landmark_options *choice)
{
	int count = coordinates ? frf->n : 3*frf->probes;
	double most = 0.0;

	for (int round = 0; round < 2; round++)
		for (int i = 0; i < count; i++) {
			struct hawser_landmark like = {.kind = HAWSER_LANDMARK_PEAK,
				.probe = coordinates ? -1 : i/3, .axis = coordinates ? i : i % 3};
			struct signal signal = signal_of(frf, &like);
			double own = largest(&signal);

			if (!round)
				most = fmax(most, own);
			else if (own > choice->faintest*most &&
			         find_peaks(list, frf, &like, NULL, choice->smallest*own,
			                    choice->prominence))
				return 1;
		}
	return 0;
}

static enum hawser_status hand_over(struct hawser_landmark **landmark, int *count,
                                    struct list *list, int failed, struct hawser_report *report)
{
	if (failed) {
		free(list->item);
		*list = (struct list){NULL, 0};
	}
	*landmark = list->item;
	*count = list->count;
	return failed ? hawser__no_memory(report, "study") : HAWSER_OK;
}

enum hawser_status hawser_landmarks(struct hawser_landmark **landmark, int *count,
                                    const struct hawser_frf *frf,
                                    const struct hawser_landmark_options *options,
                                    struct hawser_report *report)
{
	struct hawser_landmark_options choice = {.smallest = 0.0};
	struct list list = {NULL, 0};
	int failed = 0;

	if (options)
		choice = *options;
	hawser_landmark_settle(&choice);
	for (int i = 0; i < frf->events && !failed; i++)
		if (frf->event[i].kind == HAWSER_FOLD)
			failed = add_fold(&list, frf, &frf->event[i]);
	if (!failed && frf->probes > 0)
		failed = all_peaks(&list, frf, 0, &choice);
	return hand_over(landmark, count, &list, failed, report);
}

enum hawser_status hawser__landmark_peaks(struct hawser_landmark **peak, int *count,
                                          const struct hawser_frf *frf, const double rest[2],
                                          const double *slope, struct hawser_report *report)
{
	struct hawser_landmark_options choice = {.smallest = 0.0};
	struct hawser_landmark like = {.kind = HAWSER_LANDMARK_TENSION, .probe = -1, .axis = -1,
		.rest = rest[1]};
	struct list list = {NULL, 0};
	int failed;

	hawser_landmark_settle(&choice);
	failed = all_peaks(&list, frf, frf->probes == 0, &choice);
	for (int i = 0; i < 2 && !failed && frf->tension; i++) {
		struct signal signal = signal_of(frf, &like);
		double most = largest(&signal);

		if (most > round_off*fabs(like.rest))
			failed = find_peaks(&list, frf, &like, slope, choice.smallest*most,
			                    choice.prominence);
		like.kind = HAWSER_LANDMARK_LEAST_TENSION;
		like.rest = rest[0];
	}
	return hand_over(peak, count, &list, failed, report);
}

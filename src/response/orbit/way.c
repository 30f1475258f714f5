/* response/orbit/way.c - the orbits that a response passes as its load is raised from rest, and the
 * curve over the load where that does not lead on.
 *
 *    t    direction of the curve, of length 1 relative to each coordinate of the orbit and to the load
 *         (of fine orbits; rough ones as a whole): by the metric of branches, small components
 *         would make the steps short
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/family.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/orbit/start.h"

#define ARC 0.3         /* first and largest step along the curve over the load, relative to orbit and
                         * load, and */
#define LEAST_ARC 1e-2  /* the least one: if a shorter step is needed, the curve counts as lost,
                         * and is followed again with fine orbits, with */
#define LEAST_FINE 1e-3 /* this least step; all chosen */
#define STRAY 0.3       /* largest distance of an orbit from the predicted one, relative to the step,
                         * and */
#define BEND 0.1        /* that for which the next step is meant */
#define SHIFT 0.02      /* distance, relative to the orbit, by which rough orbits are off the curve
                         * where it turns sharply, however short the step is */
#define SAME 0.9        /* if half the step is off its prediction by this part of what the whole step
                         * was, or more, the two orbits have different harmonics; chosen */
enum { MOST_STEPS = 500 }; /* a closed curve, to which a guide may lead, has no end; chosen */
#define DIP 0.06        /* a fold after which the load falls by less is passed, relative to the load */

/* Number of unknowns before those at the end that are 0. */
static int used(const double *y, int count)
{
	while (count > 0 && y[count - 1] == 0.0)
		count--;
	return count;
}

int hawser__way_add(struct hawser__way *way, double load, const double *y, int count)
{
	struct hawser__passed passed = {.load = load, .length = used(y, count)};

	passed.y = malloc(((size_t)passed.length + 1)*sizeof *passed.y);
	if (!passed.y || hawser__more(&way->passed, way->count, sizeof *way->passed)) {
		free(passed.y);
		return -1;
	}
	memcpy(passed.y, y, (size_t)passed.length*sizeof *y);
	way->passed[way->count++] = passed;
	return 0;
}

void hawser__way_predict(double *y, const struct hawser__way *way, int next, int here,
                         const double *from, int count)
{
	for (int i = 0; i < count; i++) {
		y[i] = i < way->passed[next].length ? way->passed[next].y[i] : 0.0;
		if (here >= 0)
			y[i] += from[i] - (i < way->passed[here].length ? way->passed[here].y[i] : 0.0);
	}
}

void hawser__way_clear(struct hawser__way *way)
{
	for (int i = 0; i < way->count; i++)
		free(way->passed[i].y);
	free(way->passed);
	*way = (struct hawser__way){.count = 0};
}

/* Sum of the squares of coordinate j of y [count]. */
static double squares(const double *y, int count, int n, int j)
{
	double sum = 0.0;

	for (int i = j; i < count; i += n)
		sum += y[i]*y[i];
	return sum;
}

/* The same of y [count] less from [length]. */
static double apart(const double *y, int count, const double *from, int length, int n, int j)
{
	double sum = 0.0;

	for (int i = j; i < count || i < length; i += n) {
		double off = (i < count ? y[i] : 0.0) - (i < length ? from[i] : 0.0);

		sum += off*off;
	}
	return sum;
}

int hawser__orbit_reversed(const double *y, int count, const double *from, int length, int n, int j,
                           double least)
{
	double a = sqrt(squares(y, count, n, j)), b = sqrt(squares(from, length, n, j));

	return fmin(a, b) > least &&
	       sqrt(apart(y, count, from, length, n, j)) > fmax(a, b) + 0.5*fmin(a, b);
}

double hawser__orbit_distance(const double *y, int count, const double *from, int length, int n,
                              double rough)
{
	double off, all;

	count = used(y, count);
	length = used(from, length);
	all = sqrt(squares(from, length, 1, 0));
	off = sqrt(apart(y, count, from, length, 1, 0))/fmax(all, DBL_MIN);

	for (int j = 0; j < n && off < 1.0; j++)
		if (hawser__orbit_reversed(y, count, from, length, n, j, HAWSER__SEEN*rough*all))
			off = 1.0;
	return off;
}

enum hawser_status hawser__climb_open(struct hawser__climb *climb, const struct hawser__orbit *orbit,
                                      double step, struct hawser_report *report)
{
	size_t size = (size_t)orbit->size;

	*climb = (struct hawser__climb){.good = calloc(size, sizeof(double)),
		.last = calloc(size, sizeof(double)), .guess = calloc(size, sizeof(double)),
		.t = calloc(size, sizeof(double)), .row = calloc(size, sizeof(double)),
		.step = step, .growth = 1.5};
	if (!climb->good || !climb->guess || !climb->last || !climb->t || !climb->row)
		return hawser__no_memory(report, "frf");
	return hawser__load_open(&climb->weak, orbit->rom, report);
}

void hawser__climb_close(struct hawser__climb *climb)
{
	hawser__load_clear(&climb->weak);
	free(climb->row);
	free(climb->t);
	free(climb->last);
	free(climb->guess);
	free(climb->good);
}

int hawser__climb_pass(struct hawser__climb *climb, const double *y, double load,
                       const struct hawser__orbit *orbit, const struct hawser__raised *raised)
{
	double *other = climb->last;

	climb->last = climb->good;
	climb->good = other;
	climb->last_load = climb->load;
	memcpy(climb->good, y, (size_t)orbit->size*sizeof *y);
	climb->load = load;
	if (load <= climb->peak)
		return 0;
	climb->peak = load;
	return raised->way && hawser__way_add(raised->way, load, y, orbit->size - 1) ? 3 : 0;
}

/* Rough orbits are compared as a whole: by coordinate, many would count as lost. */
static double own_part(double rough)
{
	return rough < HAWSER__ON_THE_WAY ? rough : 1.0;
}

/* t of length 1, relative to each coordinate of the orbit, and to the load; and its dual. */
static void direct(struct hawser__climb *climb, int count, int n, double rough)
{
	double *t = climb->t, length, sum = pow(t[count]/climb->load, 2);
	int here = used(climb->good, count), moves = used(t, count);
	double part = fmin(1.0, HAWSER__SEEN*own_part(rough));
	double least = part*part*squares(climb->good, here, 1, 0);

	memset(climb->row, 0, (size_t)count*sizeof *t);
	for (int j = 0; j < n; j++) {
		double size = fmax(squares(climb->good, here, n, j), least);

		for (int i = j; i < moves; i += n)
			climb->row[i] = t[i]/size;
		sum += squares(t, moves, n, j)/size;
	}
	climb->row[count] = t[count]/(climb->load*climb->load);
	length = sqrt(sum);
	cblas_dscal(count + 1, 1.0/length, t, 1);
	cblas_dscal(count + 1, 1.0/length, climb->row, 1);
}

/* The direction at the last orbit in which the load rises. Not 0: there is none. */
static int begin_arc(struct hawser__climb *climb, struct hawser__orbit *orbit, double rough)
{
	int count = orbit->size - 1;

	climb->good[count] = climb->load;
	memset(climb->row, 0, (size_t)orbit->size*sizeof *climb->row);
	orbit->ops->metric(orbit, climb->good);
	climb->row[count] = orbit->W;
	if (!isfinite(orbit->ops->defects(orbit, climb->good, 1)) || orbit->ops->factor(orbit, climb->row))
		return 1;
	hawser__orbit_tangent(orbit, climb->t);
	direct(climb, count, orbit->n, rough);
	return 0;
}

/* Whether the last orbit is behind a fold: where the load rises, it comes nearer to the one before. */
static int behind(const struct hawser__climb *climb, int count)
{
	const double *t = climb->t;

	return climb->last_load > 0.0 &&
	       cblas_ddot(count, t, 1, climb->good, 1) < cblas_ddot(count, t, 1, climb->last, 1);
}

static void step_back(struct hawser__climb *climb, const struct hawser__raised *raised)
{
	double *other = climb->good;

	climb->good = climb->last;
	climb->last = other;
	climb->load = climb->peak = climb->last_load;
	climb->last_load = 0.0;
	if (raised->way)
		free(raised->way->passed[--raised->way->count].y);
}

/* Correct y in the plane of the row; returns what correct_at does. */
static int correct_arc(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                       struct hawser__correction *correction, double omega, double rough,
                       struct hawser_report *report)
{
	for (int again = 1; again;) {
		enum hawser_status status;

		orbit->ops->metric(orbit, y);
		if (hawser__orbit_correct(orbit, y, correction, climb->row, rough) ||
		    !(y[orbit->size - 1] > 0.0))
			return 1;
		status = orbit->ops->refine(orbit, &again, rough, omega, report);
		if (status)
			return status == HAWSER_ERR_MEMORY ? 3 : 2;
	}
	return 0;
}

int hawser__climb_turned(const struct hawser__climb *climb)
{
	return climb->load <= (1.0 - DIP)*climb->peak && climb->peak > 0.0;
}

/* The greatest load on the curve between the last orbit and the next one, which is `step` further and
 * has this load and the tangent t: of the parabolas of the load over the arclength that have value and
 * slope of either end. */
static double crest(const struct hawser__climb *climb, double load, const double *t, double step,
                    int count)
{
	double rise = climb->t[count], fall = -t[count]/cblas_ddot(count + 1, climb->row, 1, t, 1);
	double part = 0.5*step/(rise + fall);

	return rise > 0.0 && fall > 0.0 ? fmax(climb->load + rise*rise*part, load + fall*fall*part) : load;
}

/* Correct the last orbit again at its load, with the harmonics that the next one needed, and compute
 * the direction of the curve there. If that fails or ends at another orbit, as near a fold, both stay
 * as they were. Returns what correct_at does. */
static int begin_again(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                       struct hawser__correction *correction, double omega, double rough,
                       struct hawser_report *report)
{
	int failed, count = orbit->size - 1;

	memcpy(y, climb->good, (size_t)orbit->size*sizeof *y);
	memset(climb->row, 0, (size_t)orbit->size*sizeof *climb->row);
	climb->row[orbit->size - 1] = 1.0;
	failed = correct_arc(y, climb, orbit, correction, omega, rough, report);
	if (failed > 1)
		return failed;
	if (failed || hawser__orbit_distance(y, count, climb->good, count, orbit->n,
	                                     own_part(rough)) > SHIFT) {
		direct(climb, orbit->size - 1, orbit->n, rough);
		return 0;
	}
	memcpy(climb->good, y, (size_t)orbit->size*sizeof *y);
	memcpy(climb->guess, climb->t, (size_t)orbit->size*sizeof *y);
	failed = begin_arc(climb, orbit, rough);
	if (!failed && cblas_ddot(orbit->size - 1, climb->t, 1, climb->guess, 1) < 0.0) {
		cblas_dscal(orbit->size, -1.0, climb->t, 1);
		cblas_dscal(orbit->size, -1.0, climb->row, 1);
	}
	return failed;
}

/* See start.h; the parameter of the orbit is the load. */
static int follow_arc(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                      struct hawser__correction *correction, double omega,
                      const struct hawser__raised *raised, struct hawser_report *report)
{
	int count = orbit->size - 1, failed = begin_arc(climb, orbit, raised->rough);
	double least = raised->rough < HAWSER__ON_THE_WAY ? LEAST_FINE : LEAST_ARC;
	double step = ARC, shift = INFINITY; /* by which the last step failed, relative to the orbit */

	if (!failed && behind(climb, count)) {
		step_back(climb, raised);
		failed = begin_arc(climb, orbit, raised->rough);
	}
	if (!failed && climb->load == 1.0) {
		memcpy(y, climb->good, (size_t)count*sizeof *y);
		return 0;
	}
	for (int i = 0; i < MOST_STEPS && !failed && step > least && !hawser__climb_turned(climb); i++) {
		double off, before = climb->load;

		for (int k = 0; k <= count; k++)
			y[k] = climb->guess[k] = climb->good[k] + step*climb->t[k];
		failed = correct_arc(y, climb, orbit, correction, omega, raised->rough, report);
		off = failed ? INFINITY : hawser__orbit_distance(y, count, climb->guess, count, orbit->n,
		                                                own_part(raised->rough))/step;
		if (failed > 1)
			return failed;
		if (!failed)
			hawser__orbit_tangent(orbit, climb->guess);
		failed = 0;
		if ((off > STRAY && off*step > SHIFT) || (climb->guess[count] < 0.0 &&
		                                              crest(climb, y[count], climb->guess, step,
		                                                    count) >= 1.0)) {
			if (isfinite(off) && off*step > SAME*shift &&
			    (failed = begin_again(y, climb, orbit, correction, omega, raised->rough, report)))
				return failed;
			shift = isfinite(off) && off*step <= SAME*shift ? off*step : INFINITY;
			step *= 0.5;
			continue;
		}
		shift = INFINITY;
		if (y[count] >= 1.0) {
			double part = (1.0 - before)/(y[count] - before);

			for (int k = 0; k < count; k++)
				y[k] = climb->good[k] + (y[k] - climb->good[k])*part;
			return 0;
		}
		memcpy(climb->t, climb->guess, (size_t)orbit->size*sizeof *y);
		failed = hawser__climb_pass(climb, y, y[count], orbit, raised);
		direct(climb, count, orbit->n, raised->rough);
		step = fmin(ARC, step*fmin(2.0, sqrt(BEND/fmax(fmin(off, STRAY), DBL_EPSILON))));
	}
	return failed ? failed : 1;
}

int hawser__climb_arc(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                      struct hawser__correction *correction, double omega,
                      const struct hawser__raised *raised, struct hawser_report *report)
{
	const struct hawser_rom *rom = climb->weak.full;
	struct hawser_rom_family loads;
	int failed;

	if (hawser_factor_open(&loads, rom, HAWSER_FACTOR_LOAD, omega/rom->time, report))
		return 3;
	orbit->family = &loads;
	failed = follow_arc(y, climb, orbit, correction, omega, raised, report);
	orbit->family = NULL;
	hawser_factor_close(&loads);
	return failed;
}

/* study/accuracy/carry.c - orbits of one model as first values for another one of the same cable.
 *
 *    y, t    coefficients of an orbit and of the tangent of its curve (orbit/balance.h)
 *    map     the coordinates of the second model that move as those of the first
 *
 * Two models are compared at a few orbits, in place of two curves: Newton's method in the plane through
 * the first orbit that is normal to its curve finds the nearest one of the second, by two or three
 * Jacobians. A point that is far away is no counterpart: the curves then differ by more than what
 * this can tell.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy/carry.h"
#include "response/orbit/balance.h"

#define FAR 0.1    /* largest distance from an orbit to its counterpart, relative; chosen */
#define SETTLED 2  /* times that its fast coordinates are balanced before: one makes their defects
                    * 1e-5 of what they were, or less */
#define KEPT 1e-7  /* smallest pair that is kept then, by the roots of their energies, as those along
                    * the cable that balance a motion of high order; chosen */
#define PATIENCE 3.0 /* contraction that is borne: what was at rest counts most in the metric of an
                      * orbit, and the first steps may grow; FAR decides; chosen */

/* y [size] of the second model; its other harmonics are 0. */
static void take(const struct hawser__balance *balance, double *y, const double *from, int order,
                 const double *map, int n)
{
	int own = balance->base.n, rows = 2*(order < balance->top ? order : balance->top) + 1;

	memset(y, 0, (size_t)balance->base.size*sizeof *y);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, own, n, 1.0, from, n, map, n, 0.0, y,
	            own);
	y[balance->base.size - 1] = from[(2*(size_t)order + 1)*(size_t)n];
}

/* The orbit y [size] of another model as a first value, with its pairs: the coordinates along the cable
 * follow the others. A difference that is hardly to be seen stretches a cable enough for Newton's
 * method to fail from there. */
static enum hawser_status begin(struct hawser__balance *balance, double *y, int order,
                                struct hawser_report *report)
{
	enum hawser_status status;

	hawser__balance_adopt(balance, y, order, 0.0);
	status = hawser__balance_arrange(balance, report);
	for (int i = 0; !status && i < SETTLED; i++)
		status = hawser__balance_settle(balance, y, report);
	if (status)
		return status;
	memset(balance->active, 0, ((size_t)balance->top + 1)*balance->base.n);
	hawser__balance_seed(balance);
	hawser__balance_adopt(balance, y, order, KEPT);
	return hawser__balance_arrange(balance, report);
}

/* How far y is from `start`, relative to that, in Omega or in all coefficients. The metric of the
 * orbits is of no use here: it sizes each coordinate by its own motion, and those that only the second
 * model has begin at rest. */
static double distance(const double *y, const double *start, int size)
{
	double off = 0.0, whole = cblas_dnrm2(size - 1, start, 1);

	for (int i = 0; i < size - 1; i++)
		off = hypot(off, y[i] - start[i]);
	return fmax(off/whole, fabs(y[size - 1]/start[size - 1] - 1.0));
}

/* The row of the plane through an orbit that is normal to the tangent t [size] of its curve, which it
 * replaces: normal as all coefficients are sized alike. In the metric of the orbits those that are at
 * rest count most, and the nearest point is far along the curve. */
static void set_plane(struct hawser__orbit *orbit, double *t)
{
	double length;

	for (int i = 0; i < orbit->size - 1; i++)
		if (orbit->weight[i] > 0.0)
			t[i] /= orbit->weight[i]*orbit->X*orbit->X;
	length = sqrt(hawser__orbit_dot(orbit, t, t));
	for (int i = 0; i < orbit->size; i++)
		t[i] /= length;
}

/* Correct station->y in the plane normal to station->t. */
static enum hawser_status correct(struct hawser__station *station, int *lost,
                                  struct hawser__orbit *orbit, double *start, double tolerance,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int again = 1;

	memcpy(start, station->y, (size_t)orbit->size*sizeof *start);
	orbit->patience = PATIENCE;
	orbit->ops->metric(orbit, station->y);
	set_plane(orbit, station->t);
	while (!status && again && !*lost) {
		*lost = hawser__orbit_correct(orbit, station->y, &station->correction, station->t,
		                              tolerance) ||
		        !(distance(station->y, start, orbit->size) <= FAR);
		if (!*lost)
			status = orbit->ops->refine(orbit, &again, tolerance,
			                            hawser__orbit_omega(orbit, station->y), report);
	}
	if (status == HAWSER_ERR_CONVERGENCE) {
		*lost = 1;
		status = HAWSER_OK;
	}
	station->mesh = orbit->mesh/orbit->X;
	station->error = station->mesh + station->correction.residual;
	return status;
}

enum hawser_status hawser__carry(struct hawser_frf *frf, int *lost, const struct hawser_rom *rom,
                                 const struct hawser__orbits *orbits, const int *which, int count,
                                 const double *map, const struct hawser_frf_options *options,
                                 struct hawser_report *report)
{
	struct hawser_report last = {.status = HAWSER_OK};
	struct hawser__amplitude *amplitude = hawser__amplitude_new(rom);
	struct hawser__station station = {.y = NULL};
	struct hawser__orbit *orbit = NULL;
	struct hawser_progress_state told;
	double *start = NULL, began = hawser__wall_seconds();
	enum hawser_status status = amplitude ? HAWSER_OK : hawser__no_memory(report, "frf");

	*frf = (struct hawser_frf){.n = rom->n, .probes = rom->shapes.points, .branch = 1, .period = 1,
		.length = rom->length, .time = rom->time, .method = hawser__balance_method.about.name};
	*lost = 0;
	if (!status)
		status = hawser__balance_method.open(&orbit, rom, options, report);
	if (!status)
		status = hawser__station_init(&station, orbit, report);
	if (!status && !(start = malloc((size_t)orbit->size*sizeof *start)))
		status = hawser__no_memory(report, "frf");
	for (int i = 0; !status && !*lost && i < count; i++) {
		struct hawser__balance *balance = (struct hawser__balance *)orbit;
		const struct hawser__series *from = &orbits->item[which[i]];

		take(balance, station.y, from->y, from->order, map, orbits->n);
		take(balance, station.t, from->y + hawser__series_length(from, orbits->n), from->order, map,
		     orbits->n);
		station.arc = from->arc;
		status = begin(balance, station.y, from->order, report);
		if (!status)
			status = correct(&station, lost, orbit, start, options->tolerance, &last);
		if (!status && !*lost)
			status = hawser__record_point(frf, amplitude, &station, orbit, report);
		if (!status && !*lost)
			status = orbit->ops->relax(orbit, options->tolerance, report);
		told = hawser__progress_state("marks", "points", i + 1, began);
		if (hawser__told_to_stop(&options->progress, &told)) {
			frf->end = HAWSER_END_INTERRUPTED;
			*lost = 1;
		} else if (options->most_work > 0.0 && i + 1 < count &&
		           hawser_orbit_work(&orbit->cost, rom) > options->most_work) {
			frf->end = HAWSER_END_WORK;
			*lost = 1;
		}
	}
	if (orbit) {
		frf->cost = orbit->cost;
		orbit->ops->clear(orbit);
	}
	hawser__station_clear(&station);
	hawser__amplitude_free(amplitude);
	free(start);
	return status;
}

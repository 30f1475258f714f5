/* net/water/water-statics.c - equilibrium in water, whose loads depend on the places.
 *
 * 1. loads as at the places so far: the energy is convex, and any method of statics finds its least
 * value
 * 2. from there Newton's method with the derivatives of the loads, whose matrix is not symmetric
 *
 * Where 2 fails after some rounds of both, the current grows from 0 in parts, with lines that come
 * out of the water over a larger height, which then becomes small: a line that floats is pushed up
 * below the surface and down above it.
 *
 * At the equilibrium the least energy with the loads held fixed is a bound of that in still water,
 * since the energy of the buoyancy is convex: the certificate is the same. In a current there is
 * none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

enum { ROUNDS = 2, HALVED = 9 };
static const double NARROWER = 0.25; /* of the band, from a step to the next */

/* The places so far begin what comes next. */
static void keep(struct hawser__net_work *work)
{
	memcpy(work->start, work->mesh->q, (size_t)work->mesh->nodes*sizeof *work->start);
}

/* With the loads of where it is. */
static enum hawser_status frozen(struct hawser__net_work *work, const struct hawser__net_method *method,
                                 int *done, struct hawser_report *report)
{
	keep(work);
	hawser__water_load(work->mesh);
	work->own = 0;
	return method->solve(work, done, report);
}

/* The state before a step, and back to it. */
struct kept {
	double *N;
	struct hawser__touch *touch;
};

static void go_back(struct hawser__net_work *work, const struct kept *kept)
{
	struct hawser__mesh *mesh = work->mesh;

	memcpy(mesh->q, work->start, (size_t)mesh->nodes*sizeof *mesh->q);
	memcpy(work->N, kept->N, (size_t)mesh->elements*sizeof *kept->N);
	if (mesh->touches)
		memcpy(mesh->touch, kept->touch, (size_t)mesh->touches*sizeof *kept->touch);
	hawser__water_load(mesh);
}

/* Newton's method from here, and back where it fails. */
static enum hawser_status newton(struct hawser__net_work *work, int *done, const struct kept *kept,
                                 struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	keep(work);
	memcpy(kept->N, work->N, (size_t)mesh->elements*sizeof *kept->N);
	if (mesh->touches)
		memcpy(kept->touch, mesh->touch, (size_t)mesh->touches*sizeof *kept->touch);
	work->rest = INFINITY; /* of other loads */
	mesh->water->follows = 1;
	hawser__water_load(work->mesh);
	status = mesh->touches ? hawser__touch_newton(work, done, report)
	                       : hawser__net_finish(work, done, report);
	mesh->water->follows = 0;
	if (!status && !*done)
		go_back(work, kept);
	return status;
}

/* A step to this part of the current and this band, from the last equilibrium: by Newton's method
 * or, where that fails, by a damped motion. */
static enum hawser_status step(struct hawser__net_work *work, int *done, double part, double band,
                               const struct kept *kept, struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	mesh->water->part = part;
	mesh->water->band = band;
	status = newton(work, done, kept, report);
	if (status || *done)
		return status;
	mesh->water->follows = 1;
	status = hawser__touch_flow(work, done, report);
	mesh->water->follows = 0;
	if (!status && !*done)
		go_back(work, kept);
	return status;
}

/* The current grows, then the band becomes narrow; *done is 0 where it takes too many shorter
 * steps. */
static enum hawser_status grow(struct hawser__net_work *work, int *done, const struct kept *kept,
                               struct hawser_report *report)
{
	double part = 0.0, more = 0.25, band = work->reach, narrow = NARROWER;
	int failed = 0;
	enum hawser_status status = step(work, done, part, band, kept, report);

	while (!status && *done && failed < HALVED && (band > 0.0 || part < 1.0)) {
		double to = fmin(part + more, 1.0);
		double next = part < 1.0 ? band : narrow*band > work->mesh->water->least ? narrow*band : 0.0;

		status = step(work, done, to, next, kept, report);
		band = *done ? next : band;
		part = *done ? to : part;
		more *= *done ? 1.5 : 0.5;
		narrow = *done ? narrow : sqrt(narrow);
		failed = *done ? 0 : failed + 1;
		*done |= failed < HALVED;
	}
	*done = part >= 1.0 && band <= 0.0;
	work->mesh->water->part = 1.0;
	work->mesh->water->band = 0.0;
	return status;
}

enum hawser_status hawser__water_statics(struct hawser__net_work *work,
                                         const struct hawser__net_method *method, int *done,
                                         struct hawser_report *report)
{
	struct kept kept = {
		.N = malloc((size_t)work->mesh->elements*sizeof *kept.N),
		.touch = malloc(((size_t)work->mesh->touches + 1)*sizeof *kept.touch)};
	enum hawser_status status = kept.N && kept.touch ? HAWSER_OK : hawser__no_memory(report, "net");

	*done = 0;
	for (int round = 0; round < ROUNDS && !status && !*done; round++) {
		status = frozen(work, method, done, report);
		if (!status)
			status = newton(work, done, &kept, report);
	}
	if (!status && !*done) {
		work->mesh->water->part = 0.0;
		work->mesh->water->band = work->reach;
		status = frozen(work, method, done, report);
		if (!status)
			status = grow(work, done, &kept, report);
	}
	free(kept.N);
	free(kept.touch);
	return status;
}

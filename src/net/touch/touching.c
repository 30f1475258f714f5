/* net/touch/touching.c - equilibrium of a net with obstacles: interior point, then Newton's method for
 * positions, forces of elements and forces of contacts.
 *
 * Without friction and with planes the energy is convex and the space as well: the interior point
 * (net/statics/interior.c, with the terms of net/touch/touch.c) converges from any start. It leaves
 * which nodes touch and which elements are slack, and Newton's method (that of
 * net/statics/finish.c) ends at round-off. Outside circles and above segments there may be several
 * equilibria; the start is on the side that the scene gives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"

enum { MOST = 60, WORSE = 10, ROUNDS = 5, CURVED = 5, DESCENT = 300 };
/* Of the curvature of the obstacles: with all of it the matrix may not be definite, far from the
 * equilibrium or where a belt circulates without resistance. With less of it steps descend; as little
 * as that needs is left out, so that they are not short. A belt may begin near a position that is not
 * stable: it leaves it by some 20 % more in each step, which is no lack of convergence for DESCENT
 * steps. */
static const double curved[CURVED] = {1.0, 0.999, 0.99, 0.9, 0.0};
/* Of the usual forces at the start: where the interior point fails, another start may do. */
static const double parts[ROUNDS] = {1.0, 10.0, 0.1, 100.0, 0.01};

/* *descends: 1 if a part of the curvature was left out. */
enum hawser_status hawser__touch_step(struct hawser__net_work *work, int *definite, int *descends,
                                      struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = HAWSER_OK;

	*definite = 0;
	for (int k = 0; k < CURVED && !status && !*definite; k++) {
		for (int i = 0; i < mesh->elements; i++)
			hawser__net_linear(work, i);
		hawser__touch_linear(work, curved[k]);
		*descends = k > 0;
		hawser__net_right(work, work->T);
		status = hawser__net_factor(work, definite, report);
	}
	if (status || !*definite)
		return status;
	status = hawser__touch_divide(work, definite, report);
	if (status || !*definite)
		return status;
	for (int i = 0; i < mesh->elements; i++)
		work->N[i] = hawser__net_force_after(work, i);
	hawser__touch_after(work);
	hawser__net_move(work, 1.0);
	hawser__touch_measure(work->mesh);
	work->factored = 0;
	work->iterations++;
	return HAWSER_OK;
}

/* Keep the state nearest to balance: where no start converges, later ones may be far off. */
static void keep_near(struct hawser__net_work *work, double rest, double residual, double gap)
{
	if (!(rest < work->rest))
		return;
	memcpy(work->near, work->mesh->q, (size_t)work->mesh->nodes*sizeof *work->near);
	work->rest = rest;
	work->residual_near = residual;
	work->apart_near = gap;
}

/* The interior point's, on the free side of all obstacles. */
static void keep_interior(struct hawser__net_work *work)
{
	double residual = hawser__net_residual(work), gap = 0.0;

	for (int i = 0; i < work->mesh->touches; i++)
		gap = fmax(gap, -work->mesh->touch[i].g);
	keep_near(work, residual/work->weight + gap/work->reach, residual, gap);
}

/* Whether this is the equilibrium; *rest: how far it is off. */
static int settled(struct hawser__net_work *work, double *rest)
{
	double residual, floor, gap;
	int done = hawser__net_settled(work, &residual, &floor);

	done = hawser__touch_settled(&gap, work) && done;
	*rest = residual/work->weight + gap/work->reach;
	keep_near(work, *rest, residual, gap);
	return done;
}

int hawser__touch_done(struct hawser__net_work *work)
{
	double rest;

	return settled(work, &rest);
}

enum hawser_status hawser__touch_newton(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report)
{
	double best = INFINITY;
	enum hawser_status status = HAWSER_OK;
	int worse = 0, definite = 1, slides = -1, most = MOST + work->mesh->touches, descents = 0;

	work->own = 1;
	*done = 0;
	for (int i = 0; i < most && !*done && !status && definite && worse < WORSE; i++) {
		double rest;
		int descends = 0;

		status = hawser__touch_step(work, &definite, &descends, report);
		if (status || !definite)
			break;
		*done = settled(work, &rest);
		descents += descends;
		worse = rest < 0.5*best || slides != work->slides || (descends && descents <= DESCENT)
			? 0 : worse + 1;
		slides = work->slides;
		best = fmin(best, rest);
		if (!isfinite(rest))
			break;
	}
	return status;
}

/* The interior point leaves N*s = mu: an element whose slack is the larger one has no force. */
static void slacken(struct hawser__net_work *work)
{
	for (int i = 0; i < work->mesh->elements; i++)
		if (work->N[i]/work->weight < work->s[i]/work->mesh->length0[i])
			work->N[i] = 0.0;
}

/* Begin, with a part of the forces of the start. */
static void again(struct hawser__net_work *work, int round)
{
	struct hawser__mesh *mesh = work->mesh;

	work->own = 0;
	memcpy(mesh->q, work->start, (size_t)mesh->nodes*sizeof *mesh->q);
	hawser__net_start_forces(work);
	for (int i = 0; i < mesh->elements; i++)
		work->N[i] *= parts[round];
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		touch->r = touch->aside = 0.0;
		touch->slides = 0;
		memset(touch->friction, 0, sizeof touch->friction);
	}
	hawser__touch_measure(mesh);
}

/* A step along the way of the supports: from the forces of the last one. */
static enum hawser_status history(struct hawser__net_work *work, int *done,
                                  struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	size_t size = (size_t)mesh->touches*sizeof *mesh->touch;
	struct hawser__touch *touch = malloc(size);
	enum hawser_status status;

	if (!touch)
		return hawser__no_memory(report, "net");
	memcpy(touch, mesh->touch, size);
	status = hawser__touch_newton(work, done, report);
	if (!status && !*done) {
		memcpy(mesh->touch, touch, size);
		memcpy(mesh->q, work->start, (size_t)mesh->nodes*sizeof *mesh->q);
		hawser__net_start_forces(work);
		status = hawser__touch_flow(work, done, report);
	}
	free(touch);
	return status;
}

enum hawser_status hawser__net_touching(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*done = 0;
	hawser__touch_measure(work->mesh);
	if (work->first)
		return history(work, done, report);
	for (int round = 0; round < ROUNDS && !status && !*done; round++) {
		again(work, round);
		status = hawser__net_interior(work, done, report);
		keep_interior(work);
		slacken(work);
		if (!status)
			status = hawser__touch_newton(work, done, report);
	}
	if (status || *done)
		return status;
	again(work, 0);
	return hawser__touch_flow(work, done, report);
}

/* net/touch/touch-flow.c - equilibrium of a net with obstacles by a damped motion from the start.
 *
 * D     damping of a node, N s/m, and t the length of a step: D q' = the unbalanced forces r,
 *       by implicit Euler, (K + D/t) d = r with the matrix K of Newton's method
 * size  largest turn of an element in a step, rad, or step of a node over FAR elements
 *
 * Where Newton's method goes to and fro between slack and taut, open and closed, each of its steps
 * is too long for the law of a step. With friction of surfaces that move there is no energy that a
 * line search could lower. The motion takes steps in which little changes; t grows as the motion
 * ends, and the last steps are Newton's (pseudo-transient continuation, Kelley and Keyes 1998).
 * What it finds is stable against motions without inertia.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

enum { MOST = 1000 };
/* A step of this size may be followed by a longer one; a larger one than WILD is taken back. */
static const double CALM = 0.1, WILD = 0.5;
static const double FAR = 4.0;
static const double GROWTH = 3.0, BACK = 8.0; /* of t */
static const double LONGEST = 1e-12, SHORTEST = 1e12; /* of D/t over that of the first step */

struct flow {
	struct hawser__net_work *work;
	double (*q)[3];              /* [nodes] before the step, */
	double *N;                   /* [elements] */
	struct hawser__touch *touch; /* [touches] */
};

static void keep(struct flow *flow, int back)
{
	struct hawser__mesh *mesh = flow->work->mesh;
	size_t nodes = (size_t)mesh->nodes*sizeof *flow->q, N = (size_t)mesh->elements*sizeof *flow->N;
	size_t touches = (size_t)mesh->touches*sizeof *flow->touch;

	memcpy(back ? mesh->q : flow->q, back ? flow->q : mesh->q, nodes);
	memcpy(back ? flow->work->N : flow->N, back ? flow->N : flow->work->N, N);
	if (touches)
		memcpy(back ? mesh->touch : flow->touch, back ? flow->touch : mesh->touch, touches);
	if (back && mesh->water)
		hawser__water_load(mesh);
}

/* Of the step work->x. */
static double size_of(const struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double most = 0.0;

	for (int i = 0; i < mesh->elements; i++) {
		double d[3], size;

		hawser__net_stretch(d, work, i);
		size = sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2])/mesh->length0[i];
		most = fmax(most, isnan(size) ? INFINITY : size);
	}
	for (int i = 0; i < mesh->unknowns; i++) {
		double size = fabs(work->x[i])*mesh->elements/(FAR*work->reach);

		most = fmax(most, isnan(size) ? INFINITY : size);
	}
	return most;
}

static enum hawser_status move(struct flow *flow, int *done, struct hawser_report *report)
{
	struct hawser__net_work *work = flow->work;
	double first = 10.0*work->weight*work->mesh->elements/(work->mesh->nodes*work->reach);
	enum hawser_status status = HAWSER_OK;

	work->own = 1;
	work->damp = first;
	for (int i = 0; i < MOST && !status && !*done && work->damp < SHORTEST*first; i++) {
		int definite, descends;
		double size;

		keep(flow, 0);
		status = hawser__touch_step(work, &definite, &descends, report);
		size = status || !definite ? INFINITY : size_of(work);
		if (!(size <= WILD)) {
			keep(flow, 1);
			work->damp *= BACK;
			continue;
		}
		*done = hawser__touch_done(work);
		if (size < CALM && work->damp > LONGEST*first)
			work->damp /= GROWTH;
	}
	work->damp = 0.0;
	return status;
}

enum hawser_status hawser__touch_flow(struct hawser__net_work *work, int *done,
                                      struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	struct flow flow = {.work = work};
	enum hawser_status status;

	flow.q = malloc((size_t)mesh->nodes*sizeof *flow.q);
	flow.N = malloc((size_t)mesh->elements*sizeof *flow.N);
	flow.touch = malloc(((size_t)mesh->touches + 1)*sizeof *flow.touch);
	status = flow.q && flow.N && flow.touch ? move(&flow, done, report)
	                                        : hawser__no_memory(report, "net");
	free(flow.q);
	free(flow.N);
	free(flow.touch);
	return status;
}

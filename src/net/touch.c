/* net/touch.c - nodes that touch obstacles: their part of the equations of statics.
 *
 * g, n, H  gap of a node, its gradient and its second derivatives
 * r        force of the obstacle along n: r >= 0, g >= 0, r*g = 0
 * f        friction: |f| <= friction*r, equal where it slides, against the slip d from the place `from`
 * k        a stiffness, above that of the net at the node
 *
 * Of Newton's method (Alart and Curnier): r = max(0, r - k*g) holds at the solution for any k > 0, and
 * so does f = (f - k*d, shortened to friction*r). The equations of a step have the derivatives of the
 * right sides, k*n*n' of a touch and k*(I - n*n') of one that sticks, in the matrix of positions; r and
 * f follow from the step. So the matrix stays positive definite and keeps its pattern, whatever
 * touches, and each step leaves of the error the part K/(k + K), K the stiffness of the net.
 *
 * The bound friction*r of a step is that of the last one, which keeps the matrix symmetric: along a
 * rope on a circle the errors are the terms of the series of e^(friction*angle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch.h"

static const double STIFFER = 1e3; /* k over the stiffness of the elements at the node: each iteration
                                    * leaves a thousandth of the error of a gap at most */
/* Of the bound: friction that exceeds it by no more is at it; round-off of forces is below. */
static const double SLIDES = 1e-9;
/* Of an element, where nodes begin above a circle or segment; the least gap then. */
static const double OFF = 0.1, TINY = 1e-14;
static const double ROUND = 16.0;  /* operations whose errors of one ulp add up in a gap */

static double dot(const double a[3], const double b[3])
{
	return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

static double norm(const double a[3])
{
	return sqrt(dot(a, a));
}

static int movable(const struct hawser__mesh *mesh, int node)
{
	const int *unknown = mesh->unknown[node];

	return unknown[0] >= 0 || unknown[1] >= 0 || unknown[2] >= 0;
}

enum hawser_status hawser__touch_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	size_t pairs = (size_t)mesh->nodes*(size_t)net->surfaces;
	int *at;

	if (!pairs)
		return HAWSER_OK;
	at = malloc((size_t)mesh->nodes*sizeof *at);
	mesh->touch = calloc(pairs, sizeof *mesh->touch);
	for (int i = 0; at && i < mesh->nodes; i++)
		at[i] = -1;
	for (int e = 0; at && e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			at[mesh->end[e][end]] = 2*e + end;
	for (int i = 0; at && mesh->touch && i < mesh->nodes; i++)
		for (int s = 0; s < net->surfaces && at[i] >= 0 && movable(mesh, i); s++)
			mesh->touch[mesh->touches++] = (struct hawser__touch){
				.surface = &net->surface[s], .number = s, .node = i, .element = at[i]/2,
				.end = at[i] % 2};
	pairs = at && mesh->touch;
	free(at);
	return pairs ? HAWSER_OK : hawser__no_memory(report, "net");
}

enum hawser_status hawser__touch_again(struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	struct hawser__touch *old = mesh->touch;
	int count = mesh->touches;
	enum hawser_status status;

	mesh->touch = NULL;
	mesh->touches = 0;
	status = hawser__touch_open(mesh, net, report);
	for (int i = 0, j = 0; !status && i < mesh->touches; i++) { /* both are in the order of the nodes */
		while (j < count && old[j].node < mesh->touch[i].node)
			j++;
		if (j < count && old[j].node == mesh->touch[i].node) {
			mesh->touch[i].r = old[j].r;
			mesh->touch[i].slides = old[j].slides;
			memcpy(mesh->touch[i].friction, old[j++].friction, sizeof mesh->touch[i].friction);
		}
	}
	free(old);
	return status;
}

enum hawser_status hawser__touch_none(const struct hawser_net *net, const char *command,
                                      struct hawser_report *report)
{
	if (!net->surfaces)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: %s does not know obstacles in nets "
	                    "yet, hawser statics does: leave the section obstacles out",
	                    net->name ? net->name : "the net", command);
}

void hawser__touch_measure(struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		touch->g = hawser_surface_gap(touch->n, touch->H, touch->surface, mesh->q[touch->node]);
	}
}

int hawser__touch_convex(const struct hawser__mesh *mesh)
{
	int convex = 1;

	for (int i = 0; i < mesh->touches && mesh->touch[i].node == mesh->touch[0].node; i++)
		convex = convex && hawser_surface_convex(mesh->touch[i].surface);
	return convex;
}

/* Off a circle or segment, by a part of an element: see hawser__touch_follow. */
static void lift(struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	const int *unknown = mesh->unknown[touch->node];
	double n[3], g = hawser_surface_gap(n, NULL, touch->surface, mesh->q[touch->node]);
	double off = OFF*mesh->length0[touch->element] - g;

	for (int k = 0; off > 0.0 && !hawser_surface_convex(touch->surface) && k < 3; k++)
		if (unknown[k] >= 0)
			mesh->q[touch->node][k] += off*n[k];
}

void hawser__touch_start(struct hawser__mesh *mesh)
{
	for (int pass = 0; pass < 2; pass++) /* twice, since obstacles may overlap */
		for (int i = 0; i < mesh->touches; i++) {
			const int *unknown = mesh->unknown[mesh->touch[i].node];
			double x[3];

			memcpy(x, mesh->q[mesh->touch[i].node], sizeof x);
			if (!hawser_surface_clear_of(x, mesh->touch[i].surface))
				continue;
			for (int k = 0; k < 3; k++)
				if (unknown[k] >= 0)
					mesh->q[mesh->touch[i].node][k] = x[k];
		}
	for (int i = 0; i < mesh->touches; i++)
		lift(mesh, &mesh->touch[i]);
	hawser__touch_measure(mesh);
}

void hawser__touch_forces(double (*residual)[3], const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int k = 0; k < 3; k++)
			residual[touch->node][k] -= touch->r*touch->n[k] + touch->friction[k];
	}
}

void hawser__touch_matrix(struct hawser__sparse *sparse, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		if (touch->stiff > 0.0)
			hawser__sparse_node(sparse, touch->element, touch->end, touch->block);
	}
}

void hawser__touch_right(double *x, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		const int *unknown = mesh->unknown[touch->node];

		for (int k = 0; k < 3; k++)
			if (unknown[k] >= 0)
				x[unknown[k]] += touch->push[k];
	}
}

void hawser__touch_fixed(struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		touch->stiff = 0.0;
		for (int k = 0; k < 3; k++)
			touch->push[k] = touch->r*touch->n[k] + touch->friction[k];
	}
}

static void step_of(double d[3], const struct hawser__net_work *work, const struct hawser__touch *touch)
{
	const int *unknown = work->mesh->unknown[touch->node];

	for (int k = 0; k < 3; k++)
		d[k] = unknown[k] < 0 ? 0.0 : work->x[unknown[k]];
}

/* block += a*n*n' + b*(I - n*n') */
static void add(struct hawser__touch *touch, double a, double b)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			touch->block[i][j] += (a - b)*touch->n[i]*touch->n[j] + (i == j ? b : 0.0);
}

/* --- interior point --- */

/* The velocity of a surface that moves; 0 if it is at rest. */
static double moving(double v[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	hawser_surface_velocity(v, touch->surface, mesh->q[touch->node]);
	return norm(v);
}

/* Friction of a surface that moves: along its velocity. Returns 0 if it is at rest. */
static int dragged(const struct hawser__mesh *mesh, struct hawser__touch *touch)
{
	double v[3], size = touch->surface->friction > 0.0 ? moving(v, mesh, touch) : 0.0;

	for (int k = 0; size > 0.0 && k < 3; k++)
		touch->friction[k] = touch->surface->friction*fmax(touch->r, 0.0)*v[k]/size;
	return size > 0.0;
}

void hawser__touch_begin(struct hawser__mesh *mesh, double product, double force)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		touch->t = fmax(touch->g, hawser_surface_convex(touch->surface)
		                          ? product/force : TINY*mesh->length0[touch->element]);
		touch->r = product/touch->t;
	}
}

void hawser__touch_mean(double *sum, int *count, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++)
		*sum += mesh->touch[i].r*mesh->touch[i].t;
	*count += mesh->touches;
}

void hawser__touch_interior(struct hawser__mesh *mesh, double mu)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];
		double force = (mu + touch->r*(touch->t - touch->g))/touch->t;

		touch->stiff = touch->r/touch->t;
		memset(touch->block, 0, sizeof touch->block);
		add(touch, touch->stiff, 0.0);
		dragged(mesh, touch);
		for (int k = 0; k < 3; k++)
			touch->push[k] = force*touch->n[k] + touch->friction[k];
	}
}

/* Changes of r and t in a whole step. */
static void change(double *r, double *t, const struct hawser__net_work *work,
                   const struct hawser__touch *touch, double mu)
{
	double d[3];

	step_of(d, work, touch);
	*t = touch->g - touch->t + dot(touch->n, d);
	*r = (mu - touch->r*touch->t - touch->r**t)/touch->t;
}

void hawser__touch_limit(double *step, const struct hawser__net_work *work, double mu)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double r, t;

		change(&r, &t, work, touch, mu);
		if (r < 0.0)
			*step = fmin(*step, -0.99*touch->r/r);
		if (t < 0.0)
			*step = fmin(*step, -0.99*touch->t/t);
	}
}

void hawser__touch_advance(const struct hawser__net_work *work, double mu, double step)
{
	for (int i = 0; i < work->mesh->touches; i++) {
		struct hawser__touch *touch = &work->mesh->touch[i];
		double r, t;

		change(&r, &t, work, touch, mu);
		touch->r += step*r;
		touch->t += step*t;
	}
}

void hawser__touch_follow(struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		if (!hawser_surface_convex(touch->surface))
			touch->t = fmax(touch->g, TINY*mesh->length0[touch->element]);
	}
}

/* --- Newton's method --- */

/* The slip: how far the node is from where it was, along the surface. */
static void slip_of(double d[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	double along;

	for (int k = 0; k < 3; k++)
		d[k] = mesh->q[touch->node][k] - touch->from[k];
	along = dot(d, touch->n);
	for (int k = 0; k < 3; k++)
		d[k] -= along*touch->n[k];
}

/* What friction would be without its bound: f - k*d, along the surface. */
static double trial_of(double trial[3], const struct hawser__touch *touch, const double d[3])
{
	double along;

	for (int k = 0; k < 3; k++)
		trial[k] = touch->friction[k] - touch->stiff*d[k];
	along = dot(trial, touch->n);
	for (int k = 0; k < 3; k++)
		trial[k] -= along*touch->n[k];
	return norm(trial);
}

/* Friction of the next step: block and push, for the bound of the last one. */
static void rub(const struct hawser__net_work *work, struct hawser__touch *touch)
{
	double bound = touch->surface->friction*touch->r, d[3], trial[3], size, along;

	if (!(bound > 0.0))
		return;
	if (dragged(work->mesh, touch)) {
		for (int k = 0; k < 3; k++)
			touch->push[k] += touch->friction[k];
		return;
	}
	if (!work->rubs)
		return;
	slip_of(d, work->mesh, touch);
	size = trial_of(trial, touch, d);
	if (!touch->slides || !(size > 0.0)) {
		add(touch, 0.0, touch->stiff);
		for (int k = 0; k < 3; k++)
			touch->push[k] += trial[k];
		return;
	}
	along = touch->stiff*bound/size;
	add(touch, 0.0, along);
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++)
			touch->block[i][j] -= along*trial[i]*trial[j]/(size*size);
		touch->push[i] += bound*trial[i]/size;
	}
}

void hawser__touch_linear(struct hawser__net_work *work, int curved)
{
	struct hawser__mesh *mesh = work->mesh;

	if (!mesh->touches)
		return;
	for (int i = 0; i < mesh->nodes; i++)
		work->bound[i] = 0.0;
	for (int i = 0; i < mesh->elements; i++)
		for (int end = 0; end < 2; end++)
			work->bound[mesh->end[i][end]] += work->a[i] + fmax(work->b[i], 0.0);
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];
		double force, soft = work->weight/(mesh->nodes*mesh->length0[touch->element]);

		touch->stiff = STIFFER*(work->bound[touch->node] + work->weight/mesh->length0[touch->element]);
		force = touch->r - touch->stiff*touch->g;
		memset(touch->block, 0, sizeof touch->block);
		memset(touch->push, 0, sizeof touch->push);
		if (!(touch->r - soft*touch->g > 0.0)) {
			touch->stiff = touch->r = 0.0;
			continue;
		}
		add(touch, touch->stiff, 0.0);
		for (int k = 0; k < 3; k++)
			touch->push[k] = force*touch->n[k];
		rub(work, touch);
		for (int k = 0; curved && k < 9; k++)
			touch->block[k/3][k%3] -= touch->r*touch->H[k/3][k%3];
	}
}

/* Length that round-off of the positions cannot tell from 0. */
static double least_of(const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	const double *q = mesh->q[touch->node], *at = touch->surface->at;
	double reach = fabs(q[0]) + fabs(q[1]) + fabs(q[2]) + fabs(at[0]) + fabs(at[1]) + fabs(at[2]);

	return fmax(ROUND*DBL_EPSILON*reach, 1e-12*mesh->length0[touch->element]);
}

/* Friction after the step, and whether the node slides in the next one: from sticking to sliding where
 * friction exceeds its bound, and back where the node has gone along with the friction. Slips may be so
 * small that f - k*d is round-off; these signs are not. */
static void rubbed(const struct hawser__net_work *work, struct hawser__touch *touch, double bound)
{
	double d[3], step[3], trial[3], size, part;

	if (dragged(work->mesh, touch) || !work->rubs)
		return;
	step_of(step, work, touch);
	slip_of(d, work->mesh, touch);
	for (int k = 0; k < 3; k++)
		d[k] += step[k];
	size = trial_of(trial, touch, d);
	part = touch->slides || size > bound*(1.0 + SLIDES) ? bound/size : 1.0;
	for (int k = 0; k < 3; k++)
		touch->friction[k] = size > 0.0 ? part*trial[k] : 0.0;
	touch->slides = touch->slides ? dot(d, touch->friction) <= least_of(work->mesh, touch)*bound
	                              : part < 1.0;
}

void hawser__touch_after(struct hawser__net_work *work)
{
	work->slides = 0;
	for (int i = 0; i < work->mesh->touches; i++) {
		struct hawser__touch *touch = &work->mesh->touch[i];
		double d[3], bound;

		if (touch->stiff > 0.0) {
			step_of(d, work, touch);
			touch->r -= touch->stiff*(touch->g + dot(touch->n, d));
			bound = touch->surface->friction*fmax(touch->r, 0.0);
		} else {
			touch->r = bound = 0.0;
		}
		if (bound > 0.0)
			rubbed(work, touch, bound);
		else
			memset(touch->friction, 0, sizeof touch->friction);
		work->slides += touch->slides;
	}
}

/* Whether friction and slip of a node agree. */
static int agrees(const struct hawser__net_work *work, const struct hawser__touch *touch)
{
	double bound = touch->surface->friction*touch->r, size = norm(touch->friction), d[3];

	if (!(bound > 0.0))
		return size == 0.0;
	if (moving(d, work->mesh, touch) > 0.0)
		return fabs(size - bound) <= work->wanted;
	if (!work->rubs)
		return 1;
	slip_of(d, work->mesh, touch);
	if (touch->slides)
		return fabs(size - bound) <= work->wanted &&
		       dot(d, touch->friction) <= least_of(work->mesh, touch)*bound;
	return size <= bound*(1.0 + SLIDES) + work->wanted && norm(d) <= least_of(work->mesh, touch);
}

int hawser__touch_settled(double *gap, const struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	int settled = 1;

	*gap = 0.0;
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double error = touch->r != 0.0 ? fabs(touch->g) : fmax(-touch->g, 0.0);

		*gap = fmax(*gap, error);
		settled = settled && touch->r >= 0.0 && error <= least_of(mesh, touch) && agrees(work, touch);
	}
	return settled;
}

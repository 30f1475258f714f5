/* net/touch/touch.c - nodes that touch obstacles: their part of the equations of statics.
 *
 * g, n, H  gap of a node, its gradient and its second derivatives
 * r        force of the obstacle along n: r >= 0, g >= 0, r*g = 0
 * f        friction: |f| <= friction*r, equal where it slides, against the slip d from the place `from`
 * k        a stiffness, above that of the net at the node
 * c        how far the obstacle gives way over r: its gap is g + c*r, and k is k/(1 + c*k); usually 0
 *
 * Of Newton's method (Alart and Curnier): r = max(0, r - k*g) holds at the solution for any k > 0, and
 * so does f = (f - k*d, shortened to friction*r). The equations of a step have the derivatives of the
 * right sides, k*n*n' of a touch and k*(I - n*n') of one that sticks, in the matrix of positions; r and
 * f follow from the step. So the matrix stays positive definite and keeps its pattern, whatever
 * touches, and each step leaves of the error the part K/(k + K), K the stiffness of the net.
 *
 * Friction at its bound follows r within a step (net/touch/touch-drag.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "net/touch/touch.h"

static const double STIFFER = 1e3; /* k over the stiffness of the elements at the node: each iteration
                                    * leaves a thousandth of the error of a gap at most */
/* Of the bound: friction that exceeds it by no more is at it; round-off of forces is below. */
static const double SLIDES = 1e-9;
/* Of an element: least gap of a node from a circle or segment when the interior point begins. */
static const double TINY = 1e-14;
static const double ROUND = 16.0;  /* operations whose errors of one ulp add up in a gap */

void hawser__touch_measure(struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		touch->g = hawser_surface_gap(touch->n, touch->H, touch->surface, mesh->q[touch->node]);
	}
}

void hawser__touch_forces(double (*residual)[3], const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int k = 0; k < 3; k++)
			residual[touch->node][k] -= touch->r*touch->n[k] + touch->friction[k];
		residual[touch->node][2] -= touch->aside;
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
		touch->push[2] += touch->aside;
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

/* How far a node is from the middle of a groove, along z. */
static double aside_of(const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	return touch->surface->groove ? mesh->q[touch->node][2] - touch->surface->at[2] : 0.0;
}

/* A groove: as stiff along z as the obstacle is along its normal. */
static void guide(const struct hawser__mesh *mesh, struct hawser__touch *touch)
{
	if (!touch->surface->groove)
		return;
	touch->block[2][2] += touch->stiff;
	touch->push[2] += touch->aside - touch->stiff*aside_of(mesh, touch);
}

/* The gap beyond what the obstacle gives way by: 0 of a node that touches. */
static double apart_of(const struct hawser__touch *touch)
{
	return touch->g + touch->give*touch->r;
}

/* --- interior point --- */

/* The speed of a surface that moves, and its velocity v; 0 if it is at rest. */
static double moving(double v[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	hawser_surface_velocity(v, touch->surface, mesh->q[touch->node]);
	return mesh->surfaces_rest ? 0.0 : hawser__norm(v);
}

/* The derivative of the direction of a circle's velocity, which is n turned by a right angle. */
static void turn(struct hawser__touch *touch)
{
	double side = touch->drag[1]*touch->n[0] - touch->drag[0]*touch->n[1]; /* drag = side*(-n1, n0) */

	for (int j = 0; j < 3; j++) {
		touch->turn[0][j] = touch->r*side*touch->H[1][j];
		touch->turn[1][j] = -touch->r*side*touch->H[0][j];
		touch->turn[2][j] = 0.0;
	}
}

/* Friction of a surface that moves: along its velocity. Returns 0 if it is at rest. */
static int dragged(const struct hawser__mesh *mesh, struct hawser__touch *touch)
{
	double v[3], size = hawser__touch_friction(touch) > 0.0 ? moving(v, mesh, touch) : 0.0;

	if (!(size > 0.0))
		return 0;
	for (int k = 0; k < 3; k++)
		touch->drag[k] = hawser__touch_friction(touch)*v[k]/size;
	if (touch->surface->axial > 0.0 && touch->element >= 0)
		hawser__touch_oval(touch->drag, mesh, touch, v);
	for (int k = 0; k < 3; k++)
		touch->friction[k] = touch->drag[k]*fmax(touch->r, 0.0);
	turn(touch);
	return 1;
}

/* No friction that follows r, before it is set. */
static void rest(struct hawser__touch *touch)
{
	memset(touch->drag, 0, sizeof touch->drag);
	memset(touch->turn, 0, sizeof touch->turn);
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
		double way = touch->t + touch->give*touch->r;
		double force = (mu + touch->r*(touch->t - touch->g))/way;

		touch->stiff = touch->r/way;
		memset(touch->block, 0, sizeof touch->block);
		add(touch, touch->stiff, 0.0);
		rest(touch);
		dragged(mesh, touch);
		for (int k = 0; k < 3; k++)
			touch->push[k] = force*(touch->n[k] + touch->drag[k]);
		touch->aside = 0.0;
		guide(mesh, touch);
	}
}

/* Changes of r and t in a whole step. */
static void change(double *r, double *t, const struct hawser__net_work *work,
                   const struct hawser__touch *touch, double mu)
{
	double d[3];

	step_of(d, work, touch);
	*t = touch->g - touch->t + hawser__dot(touch->n, d);
	*r = (mu - touch->r*touch->t - touch->r*(*t + touch->give*touch->r))/
	     (touch->t + touch->give*touch->r);
	*t += touch->give*(touch->r + *r);
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

		if (!hawser_surface_convex(touch->surface) && touch->element >= 0)
			touch->t = fmax(apart_of(touch), TINY*mesh->length0[touch->element]);
		dragged(mesh, touch);
	}
}

/* --- Newton's method --- */

/* 1 if the node is past an end of a segment: the nearest point is the end, a circle of radius 0. No
 * node stays on it, since it slides off to one of its sides. */
static int past(const struct hawser__touch *touch)
{
	return touch->surface->kind == HAWSER_SURFACE_SEGMENT && touch->H[0][0] + touch->H[1][1] > 0.0;
}

/* The slip: how far the node is from where it was, along the surface. */
static void slip_of(double d[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	double along;

	for (int k = 0; k < 3; k++)
		d[k] = mesh->q[touch->node][k] - touch->from[k];
	along = hawser__dot(d, touch->n);
	for (int k = 0; k < 3; k++)
		d[k] -= along*touch->n[k];
	if (touch->surface->groove)
		d[2] = 0.0; /* the groove holds it, not friction */
}

/* What friction would be without its bound: f - k*d, along the surface. */
static double trial_of(double trial[3], const struct hawser__touch *touch, const double d[3])
{
	double along;

	for (int k = 0; k < 3; k++)
		trial[k] = touch->friction[k] - touch->hold*d[k];
	along = hawser__dot(trial, touch->n);
	for (int k = 0; k < 3; k++)
		trial[k] -= along*touch->n[k];
	return hawser__norm(trial);
}

/* Friction of the next step: block, push and drag. force: r if the node stays where it is. */
static void rub(const struct hawser__net_work *work, struct hawser__touch *touch, double force)
{
	double bound = hawser__touch_friction(touch)*touch->r, d[3], trial[3], size, along;

	rest(touch);
	if (dragged(work->mesh, touch)) {
		for (int k = 0; k < 3; k++)
			touch->push[k] += force*touch->drag[k];
		return;
	}
	if (!(bound > 0.0) || !work->rubs)
		return;
	slip_of(d, work->mesh, touch);
	size = trial_of(trial, touch, d);
	if (!touch->slides || !(size > 0.0)) {
		add(touch, 0.0, touch->hold);
		for (int k = 0; k < 3; k++)
			touch->push[k] += trial[k];
		return;
	}
	along = touch->hold*bound/size;
	add(touch, 0.0, along);
	for (int i = 0; i < 3; i++) {
		touch->drag[i] = hawser__touch_friction(touch)*trial[i]/size;
		for (int j = 0; j < 3; j++)
			touch->block[i][j] -= along*trial[i]*trial[j]/(size*size);
		touch->push[i] += force*touch->drag[i];
	}
}

void hawser__touch_linear(struct hawser__net_work *work, double curved)
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

		touch->hold = STIFFER*(work->bound[touch->node] + work->weight/mesh->length0[touch->element]);
		touch->stiff = touch->hold/(1.0 + touch->give*touch->hold);
		force = touch->r*(1.0 - touch->give*touch->stiff) - touch->stiff*touch->g;
		memset(touch->block, 0, sizeof touch->block);
		memset(touch->push, 0, sizeof touch->push);
		if (!(touch->r - soft*apart_of(touch) > 0.0) || past(touch)) {
			touch->stiff = touch->r = touch->aside = 0.0;
			continue;
		}
		add(touch, touch->stiff, 0.0);
		for (int k = 0; k < 3; k++)
			touch->push[k] = force*touch->n[k];
		guide(mesh, touch);
		rub(work, touch, force);
		for (int k = 0; k < 9; k++)
			touch->block[k/3][k%3] -= curved*touch->r*touch->H[k/3][k%3];
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
	touch->slides = touch->slides ? hawser__dot(d, touch->friction) <= least_of(work->mesh, touch)*bound
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
			touch->r -= touch->stiff*(apart_of(touch) + hawser__dot(touch->n, d));
			if (touch->surface->groove)
				touch->aside -= touch->stiff*(aside_of(work->mesh, touch) + d[2]);
			bound = hawser__touch_friction(touch)*fmax(touch->r, 0.0);
		} else {
			touch->r = touch->aside = bound = 0.0;
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
	double bound = hawser__touch_friction(touch)*touch->r, size = hawser__norm(touch->friction), d[3];

	if (!(bound > 0.0))
		return size == 0.0;
	if (moving(d, work->mesh, touch) > 0.0)
		return fabs(size - hawser__norm(touch->drag)*touch->r) <= work->wanted;
	if (!work->rubs)
		return 1;
	slip_of(d, work->mesh, touch);
	if (touch->slides)
		return fabs(size - bound) <= work->wanted &&
		       hawser__dot(d, touch->friction) <= least_of(work->mesh, touch)*bound;
	return size <= bound*(1.0 + SLIDES) + work->wanted &&
	       hawser__norm(d) <= least_of(work->mesh, touch);
}

int hawser__touch_settled(double *gap, const struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	int settled = 1;

	*gap = 0.0;
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double error = touch->r != 0.0 ? fmax(fabs(apart_of(touch)), fabs(aside_of(mesh, touch)))
			: fmax(-touch->g, 0.0);

		*gap = fmax(*gap, error);
		settled = settled && touch->r >= 0.0 && error <= least_of(mesh, touch) && agrees(work, touch);
	}
	return settled;
}

/* tow/steady_bending.c - the cable as a beam in straight flight.
 *
 *   e, d   unit vectors downwards and along the horizontal part of the flow: all is in their plane
 *   theta  angle of the cable's tangent t = cos(theta) e + sin(theta) d; tau = dt/dtheta
 *   n      force in the cable, with its parts along e and d; n' = -q, q the weight and the drag
 * f(u, t)
 *
 * The balance of moments is (EI theta')' + n.tau = 0. At the towing point theta' = 0, or theta = 0
 * where it is clamped. At the end EI theta' is the moment of a ring that is clamped to it, offset
 * n.tau; with a joint or without a ring it is 0, and what the body pulls with does not depend on
 * the cable. Differences of order 2 in theta and n at the nodes, three unknowns each, by Newton's
 * method with the exact derivatives, from the string; the matrix is banded. A part without EI is a
 * string in the same equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "tow/steady.h"

enum { BAND = 5, LD = 3*BAND + 1, /* an equation of a node reaches the unknowns of both neighbours */
       ITERATIONS = 200,          /* of Newton's method: 4 to 20 are usual */
       HALVINGS = 12              /* of a step that does not reduce the residual */ };
#define TOLERANCE 1e-11 /* of the moments and forces, over those of the whole cable */
#define LONGEST 0.5     /* rad, change of an angle in a step */

static const char where[] = "tow steady";

struct beam {
	const struct hawser_tow *tow;
	double u[3], e[3], d[3], normal[3]; /* normal: e x d */
	int nodes, parts;          /* elements + 1; elements are parts times those of the scene */
	double *h, *EI;            /* [nodes-1] */
	int *segment;              /* [nodes-1] */
	double *y, *r, *step, *band; /* [3*nodes] unknowns theta, n.e, n.d; residual; step; [3*nodes][LD] */
	lapack_int *pivot;         /* [3*nodes] */
	double force, moment;      /* scales */
	const struct hawser__tow_end *hung; /* a body whose pull does not depend on the cable's end */
};

static void direction(const struct beam *b, double theta, double t[3], double tau[3])
{
	for (int k = 0; k < 3; k++) {
		t[k] = cos(theta)*b->e[k] + sin(theta)*b->d[k];
		tau[k] = cos(theta)*b->d[k] - sin(theta)*b->e[k];
	}
}

/* Load per length of an element, along e and d, and its derivative by the angle. */
static void load(double q[2], double dq[2], const struct beam *b, int element, double theta)
{
	const struct hawser_tow_segment *segment = &b->tow->segment[b->segment[element]];
	struct hawser_drag drag = {b->tow->density, 0.5*segment->diameter, segment->normal,
	                           segment->tangential};
	double t[3], tau[3], f[3], f_x[3][3], turned[3];

	direction(b, theta, t, tau);
	hawser_drag_line(f, NULL, f_x, &drag, b->u, t);
	for (int k = 0; k < 3; k++)
		turned[k] = hawser__dot(f_x[k], tau);
	q[0] = hawser__dot(f, b->e) + segment->rho*b->tow->g;
	q[1] = hawser__dot(f, b->d);
	dq[0] = hawser__dot(turned, b->e);
	dq[1] = hawser__dot(turned, b->d);
}

/* What a ring pulls with, where its axis has this angle, and the derivative. */
static void pull(double n[2], double dn[2], const struct beam *b, double theta)
{
	static const double still[3] = {0.0};
	const struct hawser_tow_body *body = &b->tow->body;
	double t[3], tau[3], turned[3];
	struct hawser_ring_drag drag;

	direction(b, theta, t, tau);
	hawser_ring_drag(&drag, &body->ring, b->u, t, still);
	for (int k = 0; k < 3; k++)
		turned[k] = hawser__dot(drag.force_turn[k], b->normal);
	n[0] = hawser__dot(drag.force, b->e) + body->mass*b->tow->g;
	n[1] = hawser__dot(drag.force, b->d);
	dn[0] = hawser__dot(turned, b->e);
	dn[1] = hawser__dot(turned, b->d);
}

static void put(struct beam *b, int row, int column, double value)
{
	b->band[(size_t)column*LD + (size_t)(2*BAND + row - column)] += value;
}

/* n.tau and its derivative by the angle. */
static double across(double *slope, const double n[2], double theta)
{
	*slope = -n[0]*cos(theta) - n[1]*sin(theta);
	return -n[0]*sin(theta) + n[1]*cos(theta);
}

/* The moment of bending between node i and the next one, into the equations of both. */
static void bend(struct beam *b, int i)
{
	double stiffness = b->EI[i]/b->h[i], moment = stiffness*(b->y[3*i + 3] - b->y[3*i]);

	for (int side = 0; side < 2; side++) {
		int row = 3*(i + side);
		double sign = side ? -1.0 : 1.0;

		b->r[row] += sign*moment;
		put(b, row, 3*i + 3, sign*stiffness);
		put(b, row, 3*i, -sign*stiffness);
	}
}

static void element(struct beam *b, int i)
{
	double q[2], dq[2], h = b->h[i];

	bend(b, i);
	load(q, dq, b, i, 0.5*(b->y[3*i] + b->y[3*i + 3]));
	for (int k = 0; k < 2; k++) {
		int row = 3*i + 1 + k;

		b->r[row] += b->y[row] - b->y[row + 3] - h*q[k];
		put(b, row, row, 1.0);
		put(b, row, row + 3, -1.0);
		put(b, row, 3*i, -0.5*h*dq[k]);
		put(b, row, 3*i + 3, -0.5*h*dq[k]);
	}
}

static void node(struct beam *b, int i)
{
	double h = 0.5*((i ? b->h[i - 1] : 0.0) + (i + 1 < b->nodes ? b->h[i] : 0.0)), slope;
	double side = across(&slope, &b->y[3*i + 1], b->y[3*i]);

	b->r[3*i] += h*side;
	put(b, 3*i, 3*i, h*slope);
	put(b, 3*i, 3*i + 1, -h*sin(b->y[3*i]));
	put(b, 3*i, 3*i + 2, h*cos(b->y[3*i]));
}

/* The body at the last node, and the moment of a ring that is clamped to it. */
static void end(struct beam *b)
{
	int last = 3*(b->nodes - 1);
	double n[2], dn[2], slope, l = b->tow->body.offset;

	if (b->hung) {
		n[0] = hawser__dot(b->hung->force, b->e);
		n[1] = hawser__dot(b->hung->force, b->d);
		dn[0] = dn[1] = 0.0;
	} else {
		pull(n, dn, b, b->y[last]);
	}
	for (int k = 0; k < 2; k++) {
		b->r[last + 1 + k] += b->y[last + 1 + k] - n[k];
		put(b, last + 1 + k, last + 1 + k, 1.0);
		put(b, last + 1 + k, last, -dn[k]);
	}
	if (b->hung)
		return;
	b->r[last] += l*across(&slope, &b->y[last + 1], b->y[last]);
	put(b, last, last, l*slope);
	put(b, last, last + 1, -l*sin(b->y[last]));
	put(b, last, last + 2, l*cos(b->y[last]));
}

/* Residual and matrix. Returns the largest part of the residual, over its scale. */
static double assemble(struct beam *b)
{
	double worst = 0.0;

	memset(b->band, 0, 3*(size_t)b->nodes*LD*sizeof *b->band);
	memset(b->r, 0, 3*(size_t)b->nodes*sizeof *b->r);
	for (int i = 0; i + 1 < b->nodes; i++)
		element(b, i);
	for (int i = 0; i < b->nodes; i++)
		node(b, i);
	end(b);
	if (b->tow->clamped) { /* downwards, as it hangs at rest */
		for (int j = 0; j <= BAND && j < 3*b->nodes; j++)
			b->band[(size_t)j*LD + (size_t)(2*BAND - j)] = 0.0;
		put(b, 0, 0, b->moment);
		b->r[0] = b->moment*b->y[0];
	}
	for (int i = 0; i < 3*b->nodes; i++)
		worst = fmax(worst, fabs(b->r[i])/(i%3 ? b->force : b->moment));
	return worst == worst ? worst : INFINITY;
}

/* Newton's method; returns the residual that is left. */
static double iterate(struct beam *b)
{
	int size = 3*b->nodes;
	double left = assemble(b), best = left;

	for (int i = 0; i < ITERATIONS && left > TOLERANCE; i++) {
		double largest = 0.0, scale = 1.0;

		memcpy(b->step, b->r, (size_t)size*sizeof *b->r);
		if (LAPACKE_dgbtrf(LAPACK_COL_MAJOR, size, size, BAND, BAND, b->band, LD, b->pivot) != 0 ||
		    LAPACKE_dgbtrs(LAPACK_COL_MAJOR, 'N', size, BAND, BAND, 1, b->band, LD, b->pivot, b->step,
		                   size) != 0)
			break;
		for (int k = 0; k < size; k += 3)
			largest = fmax(largest, fabs(b->step[k]));
		if (largest > LONGEST)
			scale = LONGEST/largest;
		for (int half = 0;; half++) {
			for (int k = 0; k < size; k++)
				b->y[k] -= scale*b->step[k];
			left = assemble(b);
			if (left < best || half == HALVINGS)
				break;
			for (int k = 0; k < size; k++) /* back */
				b->y[k] += scale*b->step[k];
			scale *= 0.5;
		}
		if (!(left < best)) { /* round-off, or no way down */
			left = best;
			break;
		}
		best = left;
	}
	return left;
}

static int open_beam(struct beam *b, const struct hawser_tow *tow, const double *u, int parts)
{
	double side = hypot(u[0], u[2]);
	size_t elements = (size_t)parts*(size_t)hawser__tow_elements(tow), nodes = elements + 1, at = 0;

	b->tow = tow;
	b->parts = parts;
	b->nodes = (int)nodes;
	memcpy(b->u, u, sizeof b->u);
	b->e[1] = -1.0;
	b->d[0] = side > 0.0 ? u[0]/side : 1.0;
	b->d[2] = side > 0.0 ? u[2]/side : 0.0;
	hawser__cross(b->normal, b->e, b->d);
	b->h = calloc(2*elements, sizeof *b->h);
	b->EI = b->h ? b->h + elements : NULL;
	b->segment = calloc(elements, sizeof *b->segment);
	b->y = calloc(9*nodes, sizeof *b->y);
	b->r = b->y ? b->y + 3*nodes : NULL;
	b->step = b->y ? b->y + 6*nodes : NULL;
	b->band = calloc(3*nodes*LD, sizeof *b->band);
	b->pivot = calloc(3*nodes, sizeof *b->pivot);
	if (!b->h || !b->segment || !b->y || !b->band || !b->pivot)
		return 0;
	for (int i = 0; i < tow->segments; i++) {
		int count = parts*(tow->segment[i].elements ? tow->segment[i].elements : HAWSER_TOW_ELEMENTS);

		for (int k = 0; k < count; k++, at++) {
			b->h[at] = tow->segment[i].length/count;
			b->EI[at] = tow->segment[i].EI;
			b->segment[at] = i;
		}
	}
	return 1;
}

static void clear_beam(struct beam *b)
{
	free(b->h);
	free(b->segment);
	free(b->y);
	free(b->band);
	free(b->pivot);
}

/* The string's state at the nodes; it is in point [elements of the scene + 1]. */
static void start(struct beam *b, const struct hawser_tow_point *point)
{
	double length = 0.0;

	for (int i = 0; i < b->nodes; i++) {
		const struct hawser_tow_point *before = &point[i/b->parts];
		const struct hawser_tow_point *after = i%b->parts ? before + 1 : before;
		double part = (double)(i%b->parts)/b->parts, n[2][3];

		for (int k = 0; k < 3; k++) {
			n[0][k] = (1.0 - part)*before->tension*before->along[k] +
			          part*after->tension*after->along[k];
			n[1][k] = (1.0 - part)*before->along[k] + part*after->along[k];
		}
		b->y[3*i] = atan2(hawser__dot(n[1], b->d), hawser__dot(n[1], b->e));
		b->y[3*i + 1] = hawser__dot(n[0], b->e);
		b->y[3*i + 2] = hawser__dot(n[0], b->d);
		b->force = fmax(b->force, hypot(b->y[3*i + 1], b->y[3*i + 2]));
		length += i ? b->h[i - 1] : 0.0;
	}
	b->moment = b->force*(length + b->tow->body.offset);
	if (b->tow->clamped)
		b->y[0] = 0.0;
}

/* The shape, at the nodes that are those of the scene. */
static void lay(struct hawser_tow_point *point, const struct beam *b)
{
	double x[3] = {0.0}, s = 0.0;

	for (int i = 0; i < b->nodes; i++) {
		const double *y = &b->y[3*i];
		double t[3], tau[3], T;

		if (i) {
			const struct hawser_tow_segment *segment = &b->tow->segment[b->segment[i - 1]];

			direction(b, 0.5*(y[0] + y[-3]), t, tau);
			T = 0.5*(y[1] + y[-2])*hawser__dot(t, b->e) + 0.5*(y[2] + y[-1])*hawser__dot(t, b->d);
			for (int k = 0; k < 3; k++)
				x[k] += b->h[i - 1]*(1.0 + T/segment->EA)*t[k];
			s += b->h[i - 1];
		}
		if (i%b->parts)
			continue;
		direction(b, y[0], t, tau);
		point[i/b->parts].s = s;
		point[i/b->parts].tension = y[1]*cos(y[0]) + y[2]*sin(y[0]);
		memcpy(point[i/b->parts].x, x, sizeof x);
		memcpy(point[i/b->parts].along, t, sizeof t);
	}
}

enum hawser_status hawser__tow_bend(struct hawser_tow_point *point, struct hawser__tow_end *body,
                                    const struct hawser__tow_frame *frame,
                                    const struct hawser_tow_point *string, int parts,
                                    struct hawser_report *report)
{
	struct beam b = {0};
	double u[3], left;
	enum hawser_status status = HAWSER_OK;

	hawser__tow_flow(u, frame, (const double [3]){0.0});
	if (!open_beam(&b, frame->tow, u, parts)) {
		status = hawser__no_memory(report, where);
	} else {
		int last = 3*(b.nodes - 1);

		b.hung = frame->tow->body.kind != HAWSER_TOW_RING || frame->tow->body.joint ? body : NULL;
		start(&b, string);
		left = iterate(&b);
		if (!(left < 1e3*TOLERANCE)) /* with long cables round-off is more than the goal */
			status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, ITERATIONS, left,
			                         "the bent cable was not found (residual %.1e of its moments and "
			                         "forces): give cable.segments.elements more, or a smaller EI",
			                         left);
		lay(point, &b);
		if (!b.hung)
			direction(&b, b.y[last], body->axis, u);
		for (int k = 0; k < 3 && !b.hung; k++)
			body->force[k] = b.y[last + 1]*b.e[k] + b.y[last + 2]*b.d[k];
		body->residual = left;
	}
	clear_beam(&b);
	return status;
}

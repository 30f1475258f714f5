/* tow/steady_body.c - what the body pulls with in a steady state, and the attitude of a ring.
 *
 *   a      axis of the ring, from the free end of the cable to its centre, l = offset
 *   F, M   drag on the ring and its moment about the centre
 *   n      force of the body on the cable, m (g - acceleration of the centre) + F
 *
 * The hinge takes no moment across the axis: l a x n + M - spin x J spin = 0 across a (J of the
 * torus). In straight flight M is 0 by symmetry, and a is along n: with the flow and the vertical
 * all is in one plane, tan(tilt) = F_h/(W + F_v), one equation in one angle. In an orbit this
 * state, with the local flow and gravity, is where Newton's method in two angles begins, with the
 * exact derivatives; in straight flight it removes the moment that the segments of the ring leave
 * (1e-9). With l = 0 nothing but M - spin x J spin is left in an orbit; in straight flight the attitude
 * is the limit of small offsets.
 *
 * Of several attitudes one is taken that hangs, a.n > 0, and is stable: the moment turns the ring back,
 * its derivatives by two angles across a have a negative trace and a positive determinant. A vertical
 * pendulum that turns fast is not stable. One that only hangs is preferred to one that is only stable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "tow/steady.h"
#include "water/morison.h"

enum { ITERATIONS = 50, /* of Newton's method: it needs 4 */
       NEAR = 10,       /* bisections of the angle before it: to 3 mrad */
       STARTS = 6,      /* further ones: along the axes, both ways */
       OTHERS = 16      /* iterations from each: a turn by pi takes 11 */ };
#define TOLERANCE 1e-13 /* of the moment over offset times force; round-off is 1e-15 */
#define COARSE 1e-5     /* the same where a sign is looked for: the end of the cable moves by so much of
                         * its offset */
#define ENOUGH 1e-9     /* the same, with which an attitude is accepted: far below the digits shown */
#define CLOSE 0.98      /* cosine of the turn between two places: beyond it is another attitude */

struct ring {
	const struct hawser__tow_frame *frame;
	const struct hawser_tow_body *body;
	const double *x;   /* of the hinge */
	double arm;        /* m: the offset; if that is 0, the ring's radius; moments are divided by it */
	double flow[3];    /* there */
};

static void ring_drag(double f[3], const void *context, const double t[3])
{
	const struct ring *of = context;

	hawser_ring_force(f, &of->body->ring, of->flow, t);
}

static void spin_cross(double c[3], double spin, const double x[3])
{
	c[0] = spin*x[2];
	c[1] = 0.0;
	c[2] = -spin*x[0];
}

/* Moment of the inertia of a torus that turns about y: spin x J spin, J = jt + (ja - jt) a a^T. */
static void gyroscopic(double c[3], const struct hawser_tow_body *body, double spin, const double a[3])
{
	double R = body->ring.radius, r = body->ring.drag.radius;
	double excess = body->mass*(0.5*R*R + 0.125*r*r); /* ja - jt */

	spin_cross(c, spin*spin*excess*a[1], a);
}

/* Column j of the derivatives, for a place of the centre that moves by dx, and a ring that turns. */
static void column(struct hawser__tow_ring *to, const struct hawser_ring_drag *drag,
                   const struct hawser__tow_frame *frame, const double a[3], int j)
{
	const double unit[3] = {j == 0, j == 1, j == 2};
	double spin = frame->spin, l = frame->tow->body.offset, m = frame->tow->body.mass;
	double da[3], part[3], more[3], dx[2][3], dn[2][3], dm[2][3];

	hawser__cross(da, unit, a);
	for (int k = 0; k < 3; k++) {
		dx[0][k] = unit[k];
		dx[1][k] = l*da[k];
	}
	for (int turn = 0; turn < 2; turn++) {
		double du[3];

		spin_cross(du, -spin, dx[turn]);
		for (int i = 0; i < 3; i++) {
			dn[turn][i] = (turn ? drag->force_turn[i][j] : 0.0) +
			              (i == 1 ? 0.0 : m*spin*spin*dx[turn][i]);
			dm[turn][i] = turn ? drag->moment_turn[i][j] : 0.0;
			for (int k = 0; k < 3; k++) {
				dn[turn][i] += drag->force_u[i][k]*du[k];
				dm[turn][i] += drag->moment_u[i][k]*du[k];
			}
		}
		hawser__cross(more, a, dn[turn]);
		for (int i = 0; i < 3; i++)
			dm[turn][i] += l*more[i];
	}
	hawser__cross(part, da, to->n);
	for (int i = 0; i < 3; i++)
		dm[1][i] += l*part[i];
	gyroscopic(part, &frame->tow->body, spin, (const double [3]){da[0], a[1], da[2]});
	gyroscopic(more, &frame->tow->body, spin, (const double [3]){a[0], da[1], a[2]});
	for (int i = 0; i < 3; i++) {
		to->n_x[i][j] = dn[0][i];
		to->moment_x[i][j] = dm[0][i];
		to->n_turn[i][j] = dn[1][i];
		to->moment_turn[i][j] = dm[1][i] - part[i] - more[i];
	}
}

void hawser__tow_ring_at(struct hawser__tow_ring *to, const struct hawser__tow_frame *frame,
                         const double x[3], const double a[3])
{
	const struct hawser_tow_body *body = &frame->tow->body;
	const double omega[3] = {0.0, frame->spin, 0.0};
	double l = body->offset, u[3], w[3], part[3];
	struct hawser_ring_drag drag;

	for (int i = 0; i < 3; i++)
		to->centre[i] = x[i] + l*a[i];
	hawser__tow_flow(u, frame, to->centre);
	hawser__tow_gravity(w, frame, to->centre);
	hawser_ring_drag(&drag, &body->ring, u, a, omega);
	for (int i = 0; i < 3; i++)
		to->n[i] = body->mass*w[i] + drag.force[i];
	hawser__cross(to->moment, a, to->n);
	gyroscopic(part, body, frame->spin, a);
	for (int i = 0; i < 3; i++)
		to->moment[i] = l*to->moment[i] + drag.moment[i] - part[i];
	for (int j = 0; j < 3; j++)
		column(to, &drag, frame, a, j);
}

/* Drag and, in water, buoyancy of a mass. */
static void mass_loads(struct hawser__water_end *loads, const struct hawser__tow_frame *frame,
                       const double x[3])
{
	const struct hawser_tow *tow = frame->tow;
	const struct hawser_tow_body *body = &tow->body;
	struct hawser__water_past past = {
		.height = tow->water.density > 0.0 ? x[1] + frame->lift - tow->water.surface : -1.0};

	hawser__tow_flow(past.r, frame, x);
	hawser__morison_buoy(loads, &(struct hawser_water_buoy){0.0, body->volume, body->CdA, body->added},
	                     tow->density, tow->g, 0.0, &past);
}

void hawser__tow_body_slope(double n_x[3][3], const struct hawser__tow_frame *frame, const double x[3],
                            const struct hawser__tow_end *end)
{
	const struct hawser_tow_body *body = &frame->tow->body;
	double spin = frame->spin;
	struct hawser__water_end loads;
	struct hawser__tow_ring ring;

	memset(n_x, 0, 9*sizeof n_x[0][0]);
	if (spin == 0.0 || body->kind == HAWSER_TOW_NO_BODY)
		return;
	if (body->kind == HAWSER_TOW_RING) {
		hawser__tow_ring_at(&ring, frame, x, end->axis);
		memcpy(n_x, ring.n_x, sizeof ring.n_x);
		return;
	}
	mass_loads(&loads, frame, x);
	for (int j = 0; j < 3; j++) {
		const double unit[3] = {j == 0, j == 1, j == 2};
		double du[3];

		spin_cross(du, -spin, unit);
		for (int i = 0; i < 3; i++)
			n_x[i][j] = (i == j && i != 1 ? body->mass*spin*spin : 0.0) +
			            hawser__dot(loads.by_r[i], du);
	}
}

/* Two unit vectors across a. */
static void across(double e[2][3], const double a[3])
{
	const double from[3] = {fabs(a[0]) < 0.7, fabs(a[0]) >= 0.7, 0.0};
	double length;

	hawser__cross(e[0], a, from);
	length = hawser__norm(e[0]);
	for (int i = 0; i < 3; i++)
		e[0][i] /= length;
	hawser__cross(e[1], a, e[0]);
}

static double quadratic(double (*A)[3], const double *left, const double *right)
{
	double sum = 0.0;

	for (int i = 0; i < 3; i++)
		sum += left[i]*hawser__dot(A[i], right);
	return sum;
}

/* Newton's method from the axis a; returns the moment that is left over arm times force. */
static double attitude(double a[3], struct hawser__tow_ring *b, int *stable, const struct ring *of,
                       double tolerance, int iterations)
{
	double left = INFINITY;

	*stable = 0;

	for (int i = 0; i < iterations; i++) {
		double e[2][3], g[2], A[2][2], det, step[3], turn[2], size, scale;

		hawser__tow_ring_at(b, of->frame, of->x, a);
		across(e, a);
		for (int k = 0; k < 2; k++) {
			g[k] = hawser__dot(e[k], b->moment);
			for (int j = 0; j < 2; j++)
				A[k][j] = quadratic(b->moment_turn, e[k], e[j]);
		}
		left = hypot(g[0], g[1])/(of->arm*hawser__norm(b->n) + DBL_MIN);
		det = A[0][0]*A[1][1] - A[0][1]*A[1][0];
		*stable = det > 0.0 && A[0][0] + A[1][1] < 0.0;
		if (left < tolerance || !(fabs(det) > 0.0))
			break;
		turn[0] = (A[0][1]*g[1] - A[1][1]*g[0])/det;
		turn[1] = (A[1][0]*g[0] - A[0][0]*g[1])/det;
		size = hypot(turn[0], turn[1]);
		scale = size > 0.3 ? 0.3/size : 1.0; /* rad a step: beyond it the linear model says little */
		for (int k = 0; k < 3; k++)
			step[k] = scale*(turn[0]*e[0][k] + turn[1]*e[1][k]);
		hawser__cross(e[0], step, a);
		for (int k = 0; k < 3; k++)
			a[k] += e[0][k];
		size = hawser__norm(a);
		for (int k = 0; k < 3; k++)
			a[k] /= size;
	}
	return left;
}

/* Copy force, axis and centre of the ring at this attitude. The scene's offset places the centre, since
 * ring_of may have replaced an offset of 0. */
static void take(struct hawser__tow_end *end, const struct hawser__tow_ring *b, const double a[3],
                 const struct ring *of)
{
	memcpy(end->force, b->n, sizeof b->n);
	memcpy(end->axis, a, sizeof end->axis);
	for (int i = 0; i < 3; i++)
		end->centre[i] = of->x[i] + of->body->offset*a[i];
}

/* 3: hangs and is stable, 2: hangs, 1: stable, 0: neither. */
static int merit(const struct hawser__tow_ring *b, const double a[3], int stable)
{
	return 2*(hawser__dot(a, b->n) >= 0.0) + stable;
}

/* From the direction between weight and flow; as long as none is found that hangs and is stable, from
 * others. */
static int ring_at(struct hawser__tow_end *end, const struct ring *of)
{
	static const double other[STARTS][3] = {{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0},
	                                        {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
	struct hawser__tow_ring b;
	double w[3], a[3], left;
	int best = -1;

	hawser__tow_gravity(w, of->frame, of->x);
	for (int i = 0; i < 3; i++)
		w[i] *= of->body->mass;
	hawser__tow_direction(a, w, of->flow, ring_drag, of, NEAR);
	for (int i = 0; i <= STARTS && best < 3; i++) {
		int stable;

		if (i)
			memcpy(a, other[i - 1], sizeof a);
		left = attitude(a, &b, &stable, of, TOLERANCE, i ? OTHERS : ITERATIONS);
		if (best < 0)
			end->residual = left;
		if (!(left < ENOUGH) || merit(&b, a, stable) <= best)
			continue;
		best = merit(&b, a, stable);
		end->residual = left;
		take(end, &b, a, of);
	}
	return best >= 0;
}

/* From the attitude that it has; 1: it is near, hangs and is stable. */
static int ring_near(struct hawser__tow_end *end, const struct ring *of, double tolerance)
{
	struct hawser__tow_ring b;
	double a[3];
	int stable;

	memcpy(a, end->axis, sizeof a);
	end->residual = attitude(a, &b, &stable, of, tolerance, ITERATIONS);
	if (merit(&b, a, stable) < 3 || !(end->residual < fmax(tolerance, ENOUGH)) ||
	    hawser__dot(a, end->axis) < CLOSE)
		return 0;
	take(end, &b, a, of);
	return 1;
}

/* The ring with its joint at x. In straight flight an offset of 0 is replaced by the ring's radius, in
 * the copies `own` and `frame`: the force on the ring does not depend on the offset there, and the
 * moment determines the attitude. */
static void ring_of(struct ring *of, struct hawser_tow *own, struct hawser__tow_frame *frame,
                    const struct hawser__tow_frame *from, const double x[3])
{
	const struct hawser_tow_body *body = &from->tow->body;

	*frame = *from;
	*of = (struct ring){.frame = frame, .body = body, .x = x,
	                    .arm = body->offset > 0.0 ? body->offset : body->ring.radius};
	hawser__tow_flow(of->flow, from, x);
	if (body->offset > 0.0 || from->spin != 0.0)
		return;
	*own = *from->tow;
	own->body.offset = of->arm;
	frame->tow = own;
}

int hawser__tow_body_near(struct hawser__tow_end *end, const struct hawser__tow_frame *frame,
                          const double x[3], int coarse)
{
	struct hawser__tow_frame within;
	struct hawser_tow own;
	struct ring ring;

	if (frame->tow->body.kind == HAWSER_TOW_RING && hawser__dot(end->axis, end->axis) > 0.0) {
		ring_of(&ring, &own, &within, frame, x);
		if (ring_near(end, &ring, coarse ? COARSE : TOLERANCE))
			return 1;
	}
	return hawser__tow_body_at(end, frame, x);
}

int hawser__tow_body_at(struct hawser__tow_end *end, const struct hawser__tow_frame *frame,
                        const double x[3])
{
	const struct hawser_tow_body *body = &frame->tow->body;
	struct hawser__tow_frame within;
	struct hawser_tow own;
	struct hawser__water_end loads;
	struct ring ring;
	double w[3];

	memset(end, 0, sizeof *end);
	memcpy(end->centre, x, sizeof end->centre);
	if (body->kind == HAWSER_TOW_NO_BODY)
		return 1;
	if (body->kind == HAWSER_TOW_RING) {
		ring_of(&ring, &own, &within, frame, x);
		return ring_at(end, &ring);
	}
	mass_loads(&loads, frame, x);
	hawser__tow_gravity(w, frame, x);
	for (int i = 0; i < 3; i++)
		end->force[i] = body->mass*w[i] + loads.load[i];
	return 1;
}

/* water/drag.c - drag of a line and of a ring.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/drag.h>

#include "core/hot.h"
#include "core/vec3.h"
#include "water/line.h"

#define PI 3.14159265358979323846 /* to the digits of a double */

HAWSER_HOT
void hawser_drag_line(double f[3], double (*f_u)[3], double (*f_x)[3], const struct hawser_drag *drag,
                      const double u[3], const double x[3])
{
	const double inverse = 1.0/hawser__norm(x), t[3] = {x[0]*inverse, x[1]*inverse, x[2]*inverse};

	hawser__drag_line(f, f_u, f_x, drag, u, t, inverse);
}

void hawser_drag_body(double f[3], double (*f_u)[3], double c, const double u[3])
{
	double speed = hawser__norm(u);

	for (int i = 0; i < 3; i++) {
		f[i] = c*speed*u[i];
		for (int j = 0; f_u && j < 3; j++)
			f_u[i][j] = c*((i == j ? speed : 0.0) + (speed > 0.0 ? u[i]*(u[j]/speed) : 0.0));
	}
}

/* Two unit vectors normal to a unit vector and to each other. */
static void normals(double *e, double *g, const double *axis)
{
	int least = fabs(axis[0]) <= fabs(axis[1]) ? (fabs(axis[0]) <= fabs(axis[2]) ? 0 : 2)
	                                           : (fabs(axis[1]) <= fabs(axis[2]) ? 1 : 2);
	double from[3] = {0.0}, length;

	from[least] = 1.0;
	hawser__cross(e, axis, from);
	length = sqrt(hawser__dot(e, e));
	for (int i = 0; i < 3; i++)
		e[i] /= length;
	hawser__cross(g, axis, e);
}

static void gather(double (*to)[3], const double A[9], double weight)
{
	for (int i = 0; i < 9; i++)
		to[i/3][i % 3] += weight*A[i];
}

/* One segment: at r from the centre, with tangent t and this length. S, Q, T: skew matrices of spin, r
 * and t; with a small turn of the ring r changes by -Q, and t by -T, times the turn. */
static void segment(struct hawser_ring_drag *out, const struct hawser_ring *ring, const double *u,
                    const double *spin, const double *r, const double *t, double length)
{
	double f[3], f_u[3][3], f_x[3][3], U[9], X[9], flow[3], moment[3];
	double S[9], Q[9], T[9], F[9], D[9], part[9], more[9];

	hawser__cross(flow, spin, r);
	for (int i = 0; i < 3; i++)
		flow[i] = u[i] - flow[i];
	hawser_drag_line(f, f_u, f_x, &ring->drag, flow, t);
	hawser__cross(moment, r, f);
	for (int i = 0; i < 3; i++) {
		out->force[i] += length*f[i];
		out->moment[i] += length*moment[i];
	}
	for (int i = 0; i < 9; i++) {
		U[i] = f_u[i/3][i % 3];
		X[i] = f_x[i/3][i % 3];
	}
	hawser__skew(S, spin);
	hawser__skew(Q, r);
	hawser__skew(T, t);
	gather(out->force_u, U, length);
	hawser__mul(part, Q, U);
	gather(out->moment_u, part, length);
	hawser__mul(D, U, Q); /* by the spin: the flow changes by -d x r */
	gather(out->force_spin, D, length);
	hawser__mul(part, Q, D);
	gather(out->moment_spin, part, length);
	hawser__mul(part, S, Q);
	hawser__mul(F, U, part);
	hawser__mul(part, X, T);
	for (int i = 0; i < 9; i++)
		F[i] -= part[i];
	gather(out->force_turn, F, length);
	hawser__mul(part, Q, F);
	hawser__skew(more, f);
	hawser__mul(D, more, Q); /* (d x r) x f = f~ r~ d */
	for (int i = 0; i < 9; i++)
		part[i] += D[i];
	gather(out->moment_turn, part, length);
}

/* The frame of a ring, across its axis; returns the length of a segment. */
static double ring_frame(int *segments, double e[3], double g[3], const struct hawser_ring *ring,
                         const double axis[3])
{
	*segments = ring->segments > 0 ? ring->segments : HAWSER_RING_SEGMENTS;
	normals(e, g, axis);
	return 2.0*PI*ring->radius/ *segments;
}

/* The middle of segment k: the radius of length 1, and the tangent. */
static void middle(double r[3], double t[3], const double e[3], const double g[3], int k, int segments)
{
	double angle = 2.0*PI*(k + 0.5)/segments;

	for (int i = 0; i < 3; i++) {
		r[i] = e[i]*cos(angle) + g[i]*sin(angle);
		t[i] = -e[i]*sin(angle) + g[i]*cos(angle);
	}
}

void hawser_ring_drag(struct hawser_ring_drag *out, const struct hawser_ring *ring, const double u[3],
                      const double axis[3], const double spin[3])
{
	int segments;
	double e[3], g[3], r[3], t[3], length = ring_frame(&segments, e, g, ring, axis);

	memset(out, 0, sizeof *out);
	for (int k = 0; k < segments; k++) {
		middle(r, t, e, g, k, segments);
		for (int i = 0; i < 3; i++)
			r[i] *= ring->radius;
		segment(out, ring, u, spin, r, t, length);
	}
}

void hawser_ring_force(double f[3], const struct hawser_ring *ring, const double u[3],
                       const double axis[3])
{
	int segments;
	double e[3], g[3], r[3], t[3], part[3], length = ring_frame(&segments, e, g, ring, axis);

	memset(f, 0, 3*sizeof *f);
	for (int k = 0; k < segments; k++) {
		middle(r, t, e, g, k, segments);
		hawser_drag_line(part, NULL, NULL, &ring->drag, u, t);
		for (int i = 0; i < 3; i++)
			f[i] += length*part[i];
	}
}

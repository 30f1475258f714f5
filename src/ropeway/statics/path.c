/* ropeway/statics/path.c - the states in which the rope may leave a sheave, as one continuous path.
 *
 * side   1: circle below the rope; -1: above it
 * n, t   normal (upwards) and tangent of the rope on the circle; a slope angle
 * m      friction coefficient times the direction of sliding
 *
 * A support sheave takes up in turn
 *   a mass at the first point of contact: the normal force N bends its kink until the rope leaves
 *   along the tangent (N = 0: the rope only touches the sheave);
 *   an arc, up to the next mass;
 *   this mass at the last point of contact, from N = 0, where the rope leaves in a kink as if the
 *   mass were just behind the circle, to N = weight*cos a, where it is carried; and so on.
 * So a carrier near a point of contact is no special case, and one follows from another without
 * a jump. A compression sheave takes up an arc; a mass cannot lie on it. When the rope behind
 * the mass comes up to the circle again, the first arc is complete, the mass hangs free, and
 * the path goes on as a second arc.
 *
 * Each change of q adds to the sheave's force, by -(side*n - m*t) dN to P, and moves the rope
 * behind by the flexibility times that change, at each S. The point of contact's own motion
 * cancels, since it is one along the rope.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "ropeway/statics/rope.h"

static const double right = 1.5707963267948966;

void hawser__path_open(struct hawser__path *path, const struct hawser__rope *rope, const double A[2],
                       double T)
{
	*path = (struct hawser__path){.rope = rope, .kind = HAWSER__LAUNCH, .end = INFINITY, .last = 1,
	                              .T = T, .lowers = 1};
	path->from.index = -1;
	path->at.x[0] = A[0];
	path->at.x[1] = A[1];
	while (path->at.mass < rope->masses && rope->S[path->at.mass] <= 0.0)
		path->at.mass++;
}

/* q at which an arc reaches the mass at S, or `limit` if it does not. */
static double until(const struct hawser__path *path, double S, double limit)
{
	double q, T, at, length = S - path->at.S;
	const struct hawser__rope *rope = path->rope;

	if (length <= 0.0)
		return 0.0;
	if (!(path->arc.R > 0.0))
		return limit;
	q = length*(1.0 + path->arc.T0/rope->EA)/path->arc.R;
	for (int i = 0; i < 50; i++) {
		double next;

		if (!(q < limit)) {
			hawser__arc_at(&T, &at, &path->arc, rope, limit);
			if (!(at > length) || isnan(T))
				return limit;
			q = limit;
		}
		hawser__arc_at(&T, &at, &path->arc, rope, q);
		if (isnan(T))
			return limit;
		next = q + (length - at)*(1.0 + T/rope->EA)/path->arc.R;
		if (fabs(next - q) <= 1e-15*q || (i > 5 && fabs(next - q) <= 1e-13*q))
			return fmin(next, limit);
		q = next;
	}
	return limit;
}

/* An arc from path->at on, with the tension T. */
static void set_arc(struct hawser__path *path, double T)
{
	int mass = path->at.mass;
	double limit = path->lowers > 0 ? path->angle + right : right - path->angle;

	path->kind = HAWSER__ARC;
	path->arc.angle0 = path->angle;
	path->arc.T0 = T;
	path->at.P[0] = T*cos(path->angle);
	path->at.P[1] = T*sin(path->angle);
	path->end = limit = fmax(limit, 0.0);
	path->last = 1;
	if (mass < path->rope->masses) {
		path->end = until(path, path->rope->S[mass], limit);
		path->last = path->end >= limit;
	}
}

/* The mass at path->at, before P of which the tension is along the tangent or arrives with a kink. */
static void set_mass(struct hawser__path *path)
{
	path->kind = HAWSER__MASS;
	path->at.P[1] += path->rope->weight[path->at.mass];
	path->end = path->at.P[1]*cos(path->angle) - path->at.P[0]*sin(path->angle);
	path->last = 0;
}

void hawser__path_arrive(struct hawser__path *path, const struct hawser__rope *rope,
                         const struct hawser__target *sheave, const struct hawser__meet *meet)
{
	path->rope = rope;
	path->from = *sheave;
	path->count = 0;
	path->at = meet->at;
	path->lowers = sheave->side > 0 ? 1 : -1;
	path->arc.R = sheave->R;
	path->arc.side = sheave->side;
	path->arc.friction = sheave->friction;
	if (meet->vertex && sheave->R > 0.0) {
		path->angle = atan2(-meet->normal[0], meet->normal[1]);
		set_mass(path);
		return;
	}
	path->angle = atan2(meet->at.P[1], meet->at.P[0]);
	set_arc(path, hypot(meet->at.P[0], meet->at.P[1]));
}

void hawser__path_at(struct hawser__rope_point *at, double slope[2], const struct hawser__path *path,
                     double q)
{
	double m = path->arc.friction, T, S, a, N, side = path->arc.side;
	const struct hawser__target *from = &path->from;

	*at = path->at;
	if (path->kind == HAWSER__LAUNCH) {
		double c = 1.0/cosh(q), s = -tanh(q);

		at->P[0] = path->T*c;
		at->P[1] = path->T*s;
		slope[0] = path->T*s*c;
		slope[1] = -path->T*c*c;
		return;
	}
	if (path->kind == HAWSER__MASS) {
		slope[0] = sin(path->angle) + m*cos(path->angle);
		slope[1] = -cos(path->angle) + m*sin(path->angle);
		at->P[0] += q*slope[0];
		at->P[1] += q*slope[1];
		at->mass++;
		return;
	}
	hawser__arc_at(&T, &S, &path->arc, path->rope, q);
	a = path->angle - side*q;
	N = hawser__arc_force(&path->arc, path->rope, T, a);
	if (from->R > 0.0) {
		at->x[0] = from->c[0] - side*from->R*sin(a);
		at->x[1] = from->c[1] + side*from->R*cos(a);
	}
	at->S += S;
	at->P[0] = T*cos(a);
	at->P[1] = T*sin(a);
	slope[0] = N*(side*sin(a) + m*cos(a));
	slope[1] = N*(-side*cos(a) + m*sin(a));
}

void hawser__path_next(struct hawser__path *path, struct hawser__rope_trace *trace)
{
	struct hawser__rope_point at;
	double slope[2], T;

	hawser__path_at(&at, slope, path, path->end);
	if (path->kind == HAWSER__ARC) {
		hawser__trace_arc(trace, path, path->end);
		path->count++;
		path->angle -= path->arc.side*path->end;
		at.S = path->rope->S[at.mass];
		path->at = at;
		set_mass(path);
		return;
	}
	hawser__trace_mass(trace, path, path->end); /* reads count */
	path->count++;
	T = at.P[0]*cos(path->angle) + at.P[1]*sin(path->angle);
	path->at = at;
	set_arc(path, T);
}

void hawser__path_again(struct hawser__path *path, struct hawser__rope_trace *trace, double q,
                        const struct hawser__meet *meet)
{
	struct hawser__rope_point at;
	double slope[2];

	hawser__path_at(&at, slope, path, q);
	hawser__trace_arc(trace, path, q);
	hawser__trace_free(trace, path->rope, &at, &meet->at);
	path->count++;
	path->at = meet->at;
	path->angle = atan2(meet->at.P[1], meet->at.P[0]);
	set_arc(path, hypot(meet->at.P[0], meet->at.P[1]));
}

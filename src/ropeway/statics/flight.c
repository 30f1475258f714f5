/* ropeway/statics/flight.c - the free rope behind a point, and where it comes nearest to a circle's
 * centre.
 *
 * c      the centre;  r = x - c;  e, n tangent and normal (upwards) of the rope
 * g      r.e: half the derivative of |r|^2 along the rope
 *
 * The slope grows along the rope, steadily by its weight and in steps at masses. So the rope is
 * the lower boundary of a convex set. A point below the rope has one nearest point, a tangent
 * point (g = 0, r.n > 0) or a mass (g changes its sign from - to + in its kink). A point above
 * the rope may have several, all of them with g = 0 from - to +. |r.n| or |r|, with its sign,
 * is a continuous function of the rope, and by the envelope theorem its change is n.dx, where
 * dx is the change of the rope's nearest point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "net/statics/catenary.h"
#include "ropeway/statics/rope.h"

void hawser__fly(struct hawser__rope_point *at, double flexibility[3], const struct hawser__rope *rope,
                 double S)
{
	struct hawser__net_catenary piece = {.p = {0.0, -rope->w, 0.0}, .length0 = S - at->S,
	                                     .EA = rope->EA};
	double F[3] = {at->P[0], at->P[1] + rope->w*piece.length0/2.0, 0.0}, chord[3], change[3][3];

	if (!(piece.length0 > 0.0))
		return;
	hawser__catenary(chord, flexibility ? change : NULL, &piece, F);
	at->x[0] += chord[0];
	at->x[1] += chord[1];
	at->P[1] += rope->w*piece.length0;
	at->S = S;
	if (flexibility) {
		flexibility[0] += change[0][0];
		flexibility[1] += change[0][1];
		flexibility[2] += change[1][1];
	}
}

double hawser__fly_stretch(const struct hawser__rope *rope, const double P[2], double L)
{
	struct hawser__net_catenary piece = {.p = {0.0, -rope->w, 0.0}, .length0 = L, .EA = rope->EA};
	double F[3] = {P[0], P[1] + rope->w*L/2.0, 0.0};

	return hawser__catenary_stretch(&piece, F);
}

void hawser__pass(struct hawser__rope_point *at, const struct hawser__rope *rope)
{
	at->P[1] += rope->weight[at->mass++];
}

static double along(const struct hawser__rope_point *at, const double c[2])
{
	double T = hypot(at->P[0], at->P[1]);

	return (at->x[0] - c[0])*(at->P[0]/T) + (at->x[1] - c[1])*(at->P[1]/T);
}

/* The nearest point is at the station: a tangent point or a mass. */
static void settle(struct hawser__meet *meet, const struct hawser__rope_point *at, const double c[2],
                   int vertex)
{
	double r[2] = {at->x[0] - c[0], at->x[1] - c[1]}, T = hypot(at->P[0], at->P[1]), far;

	meet->at = *at;
	meet->vertex = vertex;
	meet->found = 1;
	meet->normal[0] = -at->P[1]/T;
	meet->normal[1] = at->P[0]/T;
	meet->distance = r[0]*meet->normal[0] + r[1]*meet->normal[1];
	far = hypot(r[0], r[1]);
	if (!vertex || !(far > 0.0))
		return;
	meet->normal[0] = r[0]/far;
	meet->normal[1] = r[1]/far;
	meet->distance = far;
}

/* g = 0 between two stations of the same smooth piece, by Newton's method in a bracket. */
static void foot(struct hawser__meet *meet, const struct hawser__rope *rope,
                 const struct hawser__rope_point *a, const struct hawser__rope_point *b,
                 double ga, double gb,
                 const double c[2])
{
	double lo = a->S, hi = b->S, S = lo - ga/(gb - ga)*(hi - lo), flexibility[3];
	struct hawser__rope_point at;

	memcpy(flexibility, meet->flexibility, sizeof flexibility);
	for (int i = 0; i < 100; i++) {
		double T, g, slope, next;

		at = *a;
		hawser__fly(&at, NULL, rope, S);
		T = hypot(at.P[0], at.P[1]);
		g = along(&at, c);
		slope = 1.0 + T/rope->EA + ((at.x[1] - c[1])*(at.P[0]/T) - (at.x[0] - c[0])*(at.P[1]/T))*
		        (rope->w/T)*(at.P[0]/T);
		if (g >= 0.0)
			hi = S;
		else
			lo = S;
		next = S - g/slope;
		if (fabs(next - S) <= 1e-9*(b->S - a->S)) {
			S = fmax(a->S, fmin(b->S, next));
			break;
		}
		if (!(next > lo && next < hi)) {
			next = lo + (hi - lo)/2.0;
			if (!(next > lo && next < hi))
				break;
		}
		S = next;
	}
	at = *a;
	hawser__fly(&at, flexibility, rope, S);
	settle(meet, &at, c, 0);
	memcpy(meet->flexibility, flexibility, sizeof flexibility);
}

/* Is c below the rope? `a`, `b`: ends of a piece between which c[0] is. */
static int is_above(const struct hawser__rope *rope, const struct hawser__rope_point *a,
                    const struct hawser__rope_point *b, const double c[2])
{
	double lo = a->S, hi = b->S;
	struct hawser__rope_point at = *a;

	for (int i = 0; i < 60; i++) {
		double S = lo + (hi - lo)/2.0;

		at = *a;
		hawser__fly(&at, NULL, rope, S);
		if (at.x[0] < c[0])
			lo = S;
		else
			hi = S;
	}
	return at.x[1] > c[1];
}

/* How far the next piece goes at most: a mass, the lowest point of the rope, or the largest
 * turning. INFINITY: no end. */
static double piece_end(const struct hawser__rope *rope, const struct hawser__rope_point *a,
                        double turn)
{
	double mass = a->mass < rope->masses ? rope->S[a->mass] : INFINITY, end = INFINITY;

	if (!(rope->w > 0.0))
		return mass;
	if (a->P[1] < 0.0)
		end = a->S - a->P[1]/rope->w;
	if (turn < 1.0) {
		double angle = atan2(a->P[1], a->P[0]) + turn;

		if (angle < 1.5)
			end = fmin(end, a->S + (a->P[0]*tan(angle) - a->P[1])/rope->w);
	}
	/* at least a step of S */
	end = fmax(end, a->S + 4.0*DBL_EPSILON*(fabs(a->S) + (a->P[0] + fabs(a->P[1]))/rope->w));
	return fmin(end, mass);
}

/* A station of the last piece, which has no end, with g >= 0. */
static int reach_out(struct hawser__rope_point *b, double flexibility[3],
                     const struct hawser__rope *rope,
                     const struct hawser__rope_point *a, double g, const double c[2])
{
	double step = -g*(1.0 + 1e-6) + 4.0*DBL_EPSILON*fabs(a->S), from[3];

	memcpy(from, flexibility, sizeof from);
	for (int i = 0; i < 200; i++, step *= 2.0) {
		*b = *a;
		memcpy(flexibility, from, sizeof from);
		hawser__fly(b, flexibility, rope, a->S + step);
		if (along(b, c) >= 0.0)
			return 1;
	}
	return 0;
}

void hawser__meet(struct hawser__meet *meet, const struct hawser__rope *rope,
                  const struct hawser__rope_point *from, const double c[2], double turn, double reach,
                  int leaving)
{
	struct hawser__rope_point a = *from, b, span[2] = {{{0.0, 0.0}, {0.0, 0.0}, 0.0, 0}};
	double g = along(&a, c), gb, flexibility[3] = {0.0, 0.0, 0.0}, before[3];
	int spans = 0, above;

	meet->found = 0;
	meet->distance = -INFINITY;
	if (leaving && g < 0.0)
		g = 0.0;
	for (;;) {
		double end = piece_end(rope, &a, turn);

		if (!(end < INFINITY) && g >= 0.0)
			break;
		if (a.P[1] >= 0.0 && g >= 0.0 && a.x[1] > c[1])
			break; /* rising and above: it only leaves c */
		if (a.x[0] - c[0] > fmin(reach, meet->found ? -meet->distance : INFINITY))
			break;
		memcpy(before, flexibility, sizeof before);
		b = a;
		if (end < INFINITY)
			hawser__fly(&b, flexibility, rope, end);
		else if (!reach_out(&b, flexibility, rope, &a, g, c))
			break;
		if (!spans && a.x[0] <= c[0] && b.x[0] >= c[0]) {
			span[0] = a;
			span[1] = b;
			spans = 1;
		}
		gb = along(&b, c);
		if (g < 0.0 && gb >= 0.0) {
			struct hawser__meet near = {.distance = 0.0};

			memcpy(near.flexibility, before, sizeof before);
			foot(&near, rope, &a, &b, g, gb, c);
			if (near.distance > meet->distance)
				*meet = near;
			if (meet->distance >= 0.0)
				return;
		}
		if (b.mass < rope->masses && b.S >= rope->S[b.mass]) {
			struct hawser__rope_point mass = b;
			double g1;

			hawser__pass(&b, rope);
			g1 = along(&b, c);
			if (gb < 0.0 && g1 >= 0.0) {
				settle(meet, &mass, c, 1);
				memcpy(meet->flexibility, flexibility, sizeof flexibility);
				return;
			}
			gb = g1;
		}
		a = b;
		g = gb;
	}
	if (meet->found)
		return;
	above = spans ? is_above(rope, &span[0], &span[1], c) : a.x[1] > c[1];
	meet->distance = (above ? 1.0 : -1.0)*hypot(from->x[0] - c[0], from->x[1] - c[1]);
}

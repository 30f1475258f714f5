/* ropeway/statics/search.c - the place on a path from which the rope meets the next sheave, or end B.
 *
 * h      height of the rope over the target: signed distance from its centre, less side*R
 * k      h on a path that lowers the rope, -h on one that raises it
 *
 * k is a continuous function along the path. Where the sheave is pressed it begins positive;
 * the first zero belongs to the taut rope. On a path that lowers, with a given tension, h has
 * one minimum: beyond it the rope gets so slack that it rises again to the target from below
 * its lowest point, and h = 0 has a second zero. So the values of k and of its derivative at
 * any place tell on which side of it the zero is, and a search in a bracket, by Newton's method
 * where it applies, cannot fail where there is one (the method is that of
 * src/statics/tension.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "ropeway/statics/rope.h"

enum { ROUNDS = 400 };
/* h that is round-off of the positions, per their size: a few operations on numbers of this size. */
static const double fine = 4.0*DBL_EPSILON;
/* A force of the sheave that is 0 may come out on either side; the rope then touches the sheave. */
static const double touching = 1e-12;

enum side {
	BEFORE, /* the zero of the taut rope is farther on */
	PASSED, /* between both zeros */
	BEYOND  /* behind the minimum, and above the target */
};

struct probe {
	double q, k, dk; /* dk NAN: not known */
	double scale;    /* m, size of the positions */
	enum side side;
	struct hawser__meet meet;
};

static double turning(const struct hawser__rope *rope, const struct hawser__rope_point *at, double R)
{
	return rope->w*R > 0.1*at->P[0] ? 0.1 : 2.0;
}

static void look(struct probe *probe, const struct hawser__path *path,
                 const struct hawser__target *target,
                 double q)
{
	struct hawser__rope_point at;
	double slope[2], h;
	struct hawser__meet *meet = &probe->meet;

	probe->q = q;
	probe->dk = NAN;
	probe->scale = fabs(target->c[0]) + fabs(target->c[1]) + target->R;
	hawser__path_at(&at, slope, path, q);
	if (!(at.P[0] > 0.0)) { /* no tension is left, or the rope is vertical */
		probe->k = INFINITY;
		probe->side = BEYOND;
		return;
	}
	probe->scale += fabs(at.x[0]) + fabs(at.x[1]);
	hawser__meet(meet, path->rope, &at, target->c,
	             target->side < 0 ? turning(path->rope, &at, target->R) : 2.0, INFINITY, 0);
	h = meet->distance - target->side*target->R;
	probe->k = path->lowers*h;
	if (meet->found) {
		const double *f = meet->flexibility, *n = meet->normal;

		probe->dk = path->lowers*((f[0]*n[0] + f[1]*n[1])*slope[0] + (f[1]*n[0] + f[2]*n[1])*slope[1]);
	}
	if (probe->k <= 0.0)
		probe->side = PASSED;
	else if (path->lowers < 0 || (meet->found ? probe->dk < 0.0 : at.P[1] >= 0.0))
		probe->side = BEFORE;
	else
		probe->side = BEYOND;
}

/* A first guess of the launch: along the chord, less the sag of rope and masses. */
static double guess(const struct hawser__path *path, const struct hawser__target *target, int slack)
{
	const struct hawser__rope *rope = path->rope;
	double dx = target->c[0] - path->at.x[0];
	double dy = target->c[1] + target->side*target->R - path->at.x[1], chord = hypot(dx, dy);
	double weight = rope->w*chord;

	for (int i = path->at.mass; i < rope->masses && rope->S[i] < chord; i++)
		weight += rope->weight[i]*2.0*(1.0 - rope->S[i]/chord);
	if (slack)
		return 1.5;
	return -asinh(dy/dx - fmin(weight/(2.0*path->T), 10.0)*chord/dx);
}

/* Between lo and hi, or beyond the end that is open. */
static double middle(double lo, double hi, double q)
{
	if (isinf(lo) && isinf(hi))
		return q;
	if (isinf(lo))
		return hi - fmax(1.0, fabs(hi));
	if (isinf(hi))
		return lo + fmax(1.0, fabs(lo));
	return lo + (hi - lo)/2.0;
}

enum outcome { FOUND, NOT_PRESSED, ON, NONE };

/* The zero in one segment. ON: it is in a later one. */
static enum outcome segment(struct probe *probe, const struct hawser__path *path,
                            const struct hawser__target *target, int slack, int first)
{
	int launch = path->kind == HAWSER__LAUNCH, top_passed = path->lowers < 0;
	int open = !path->last; /* the end has not been looked at */
	double lo = launch ? -INFINITY : 0.0, hi = path->end, next, newton = INFINITY, last;
	struct probe low = {.k = INFINITY};

	look(probe, path, target, launch ? guess(path, target, slack) : 0.0);
	if (!launch && first && !slack && probe->side == PASSED)
		return probe->k >= -touching*probe->scale ? FOUND : NOT_PRESSED;
	for (int round = 0; round < ROUNDS; round++) {
		double dk = probe->dk;
		int usable = slack ? dk > 0.0 : dk < 0.0;
		int beyond = probe->side == BEYOND || (!slack && probe->side == PASSED);

		if (fabs(probe->k) <= fine*probe->scale && (usable || probe->q > 0.0 || launch))
			return FOUND;
		if (probe->q >= path->end) {
			if (!beyond)
				return ON;
			open = 0;
		}
		if (beyond) {
			hi = probe->q;
			top_passed = probe->side == PASSED;
		} else {
			lo = probe->q;
		}
		if (probe->k > 0.0 && probe->k < low.k)
			low = *probe;
		last = newton;
		newton = usable ? -probe->k/dk : NAN;
		if (launch && fabs(newton) > 2.0)
			newton = copysign(2.0, newton);
		next = probe->q + newton;
		if (fabs(newton) <= 2.0*DBL_EPSILON*fmax(fabs(probe->q),
		                                         path->kind == HAWSER__MASS ? 0.0 : 1.0) &&
		    fabs(probe->k) <= 1e3*fine*probe->scale)
			return FOUND;
		if (open && hi >= path->end && (next >= path->end || !usable)) {
			next = path->end;
			newton = INFINITY;
		} else if (!(next > lo && next < hi) || !(fabs(newton) <= 0.7*fabs(last) || launch)) {
			next = middle(lo, hi, probe->q);
			newton = INFINITY;
		}
		if (launch && fabs(next) > 700.0)
			break;
		if (!(next > lo && next < hi) && !(open && next >= path->end))
			break;
		look(probe, path, target, next);
	}
	if (fabs(probe->k) <= 1e-9*probe->scale && (slack || top_passed))
		return FOUND;
	if (!slack && low.k <= touching*low.scale) { /* the minimum itself touches the target */
		*probe = low;
		return FOUND;
	}
	return NONE;
}

/* Does the rope that leaves a compression sheave at q come back to it? */
static int comes_back(struct probe *probe, const struct hawser__path *path, double q)
{
	struct hawser__rope_point at;
	double slope[2];
	const double *f = probe->meet.flexibility, *n = probe->meet.normal;

	probe->q = q;
	probe->k = -INFINITY;
	probe->dk = NAN;
	hawser__path_at(&at, slope, path, q);
	if (hypot(slope[0], slope[1]) <= 0.0 || slope[0]*-sin(path->angle + q) +
	    slope[1]*cos(path->angle + q) <= 0.0) {
		probe->k = INFINITY;
		return 1;
	}
	hawser__meet(&probe->meet, path->rope, &at, path->from.c, turning(path->rope, &at, path->from.R),
	             path->from.R, 1);
	if (!probe->meet.found)
		return 0;
	probe->k = probe->meet.distance + path->from.R;
	probe->dk = (f[0]*n[0] + f[1]*n[1])*slope[0] + (f[1]*n[0] + f[2]*n[1])*slope[1];
	probe->scale = fabs(path->from.c[0]) + fabs(path->from.c[1]) + path->from.R;
	return probe->k > fine*probe->scale;
}

/* The angle at which the rope behind the arc touches the same circle again, between 0 and q. 0:
 * none. */
static int again(struct probe *probe, const struct hawser__path *path, double q)
{
	double lo = 0.0, hi = q, next, newton;
	int touches = 0;
	struct probe last;

	if (!comes_back(probe, path, q))
		return 0;
	last = *probe;
	for (int round = 0; round < ROUNDS; round++) {
		newton = probe->dk > 0.0 ? -probe->k/probe->dk : NAN;
		next = probe->q + newton;
		if (isfinite(probe->k) && (fabs(probe->k) <= fine*probe->scale ||
		    fabs(newton) <= 2.0*DBL_EPSILON*fmax(probe->q, hi - lo)))
			return 1;
		if (!(next > lo && next < hi))
			next = lo + (hi - lo)/2.0;
		if (!(next > lo && next < hi))
			break;
		touches = comes_back(probe, path, next);
		if (touches) {
			hi = next;
			last = *probe;
		} else {
			lo = next;
		}
	}
	*probe = last;
	return isfinite(probe->k) && probe->k <= 1e-9*probe->scale;
}

enum hawser__search hawser__path_find(struct hawser__path *path, double *q, struct hawser__meet *meet,
                                      struct hawser__rope_trace *trace,
                                      const struct hawser__target *target,
                                      int slack)
{
	struct probe probe, other = {.q = 0.0};

	for (int count = 0;; count++) {
		enum outcome outcome = segment(&probe, path, target, slack, count == 0);

		if (outcome == NOT_PRESSED)
			return HAWSER__NOT_PRESSED;
		if (path->lowers < 0 && path->kind == HAWSER__ARC && path->from.R > 0.0 &&
		    again(&other, path, outcome == FOUND ? probe.q : path->end)) {
			hawser__path_again(path, trace, other.q, &other.meet);
			continue;
		}
		if (outcome == FOUND)
			break;
		if (outcome == NONE)
			return HAWSER__TOO_LOW;
		hawser__path_next(path, trace);
	}
	*q = probe.q;
	*meet = probe.meet;
	return HAWSER__MET;
}

/* statics/profile.c - the profile of a solved span, and its closure error.
 *
 * B (2.85)-(2.86), with differences of asinh and of square roots written as products. Each point is
 * computed from the nearer end, so that the profile ends exactly at both ends.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "statics/catenary.h"
#include "statics/profile.h"

/* Add to x and y the scaled distance from slope u to slope v over the scaled arclength s. */
static void advance(const struct hawser_statics *st, double *x, double *y, double u, double v,
                    double s)
{
	double both = u + v;

	*x = st->epsilon*s + hawser__angle_between(u, v, st->delta*s)/st->delta;
	*y = s*both*(0.5*st->epsilon + 1.0/(hypot(1.0, u) + hypot(1.0, v)));
}

/* Slope at the scaled arclength s, from the nearer end. */
static double slope_at(const struct hawser_statics *st, double s)
{
	if (s <= 0.5*st->l)
		return st->eta + st->delta*s;
	return st->V1/st->H - st->delta*(st->l - s);
}

struct hawser_profile_point hawser_statics_at(const struct hawser_statics *st, double S)
{
	struct hawser_profile_point point;
	double d = st->span.d, s = S/d, x, y, u = slope_at(st, s);

	if (s <= 0.5*st->l) {
		advance(st, &x, &y, st->eta, u, s);
		point.x = d*x;
		point.y = d*y;
	} else {
		advance(st, &x, &y, u, st->V1/st->H, (st->length0 - S)/d);
		point.x = d - d*x;
		point.y = st->span.h - d*y;
	}
	point.S = S;
	point.slope = u;
	point.T = st->H*hypot(1.0, u);
	return point;
}

struct hawser_frame_point hawser_statics_frame(const struct hawser_statics *st, double s)
{
	struct hawser_frame_point frame;
	double u = slope_at(st, s), root = hypot(1.0, u);

	frame.u = u;
	frame.ex = 1.0/root;
	frame.ey = u/root;
	frame.curvature = st->delta/root/root;
	frame.strain = st->epsilon*root;
	return frame;
}

double hawser__statics_closure(const struct hawser_statics *st)
{
	double x, y;

	advance(st, &x, &y, st->eta, st->eta + st->delta*st->l, st->l);
	return st->span.d*hypot(x - 1.0, y - st->hs);
}

/* statics/profile.c - the profile of a solved span, and its closure error.
 *
 * B (2.85)-(2.86), with differences of asinh and of square roots written as products. Each point is
 * computed from the nearer end, so that the profile ends exactly at both ends.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "statics/catenary.h"
#include "statics/models.h"

/* Add to x and y the scaled distance from slope u to slope v over the scaled arclength s. */
static void advance(const struct hawser_statics *st, double *x, double *y, double u, double v,
                    double s)
{
	double both = u + v;

	*x = st->epsilon*s + hawser__angle_between(u, v, st->delta*s)/st->delta;
	*y = s*both*(0.5*st->epsilon + 1.0/(hypot(1.0, u) + hypot(1.0, v)));
}

/* Sum of the jumps of the force by attachments up to s, or beyond s. */
static double jumps(const struct hawser_statics *st, double s, int beyond)
{
	double sum = 0.0;

	for (int i = 0; i < st->attachments; i++)
		if (beyond == (st->attached[i].s > s))
			sum += st->attached[i].jump[1];
	return sum;
}

double hawser_statics_mass(const struct hawser_statics *st)
{
	double sum = 0.0;

	for (int i = 0; i < st->attachments; i++)
		sum += st->attached[i].m;
	return st->l + sum;
}

/* Slope at the scaled arclength s, from the nearer end. */
static double slope_at(const struct hawser_statics *st, double s)
{
	if (st->attachments > 0)
		return s <= 0.5*st->l ? st->eta + st->delta*(s + jumps(st, s, 0))
		                      : st->V1/st->H - st->delta*(st->l - s + jumps(st, s, 1));
	if (s <= 0.5*st->l)
		return st->eta + st->delta*s;
	return st->V1/st->H - st->delta*(st->l - s);
}

/* Scaled distances from end A to s or, if `back`, from s to end B, piece by piece. */
static void pieces(const struct hawser_statics *st, double *x, double *y, double s, int back)
{
	double from = back ? s : 0.0, to = back ? st->l : s, u = back ? slope_at(st, s) : st->eta;

	*x = *y = 0.0;
	for (int i = 0; i <= st->attachments; i++) {
		const struct hawser_attached *next = &st->attached[i];
		int last = i == st->attachments || next->s > to;
		double dx, dy, end = last ? to : next->s, v;

		if (!last && end <= from && back)
			continue; /* its jump is part of slope_at */
		v = u + st->delta*(end - from);
		advance(st, &dx, &dy, u, v, end - from);
		*x += dx;
		*y += dy;
		if (last)
			return;
		u = v + st->delta*next->jump[1];
		from = end;
	}
}

static struct hawser_profile_point point_between(const struct hawser_statics *st, double S)
{
	double d = st->span.d, s = S/d, x, y, u = slope_at(st, s);
	int back = s > 0.5*st->l;

	pieces(st, &x, &y, s, back);
	return (struct hawser_profile_point){.S = S, .x = back ? d - d*x : d*x,
	                                     .y = back ? st->span.h - d*y : d*y, .slope = u,
	                                     .T = st->H*hypot(1.0, u)};
}

struct hawser_profile_point hawser_statics_at(const struct hawser_statics *st, double S)
{
	struct hawser_profile_point point = {.z = 0.0};
	double d = st->span.d, s = S/d, x, y, u;

	if (st->space)
		return hawser__space_at(st, S);
	u = slope_at(st, s);
	if (st->attachments > 0)
		return point_between(st, S);
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

struct hawser_profile_point hawser_statics_before(const struct hawser_statics *st, int i)
{
	struct hawser_profile_point at;

	if (st->space)
		return hawser__space_before(st, i);
	at = hawser_statics_at(st, st->attached[i].S);
	at.slope -= st->delta*st->attached[i].jump[1];
	at.T = st->H*hypot(1.0, at.slope);
	return at;
}

struct hawser_frame_point hawser_statics_frame(const struct hawser_statics *st, double s)
{
	struct hawser_frame_point frame;
	double u, root;

	if (st->space) {
		hawser__space_frame(&frame, st, s);
		return frame;
	}
	u = slope_at(st, s);
	root = hypot(1.0, u);
	frame = (struct hawser_frame_point){.axis = {{1.0/root, u/root, 0.0}, {-u/root, 1.0/root, 0.0},
	                                             {0.0, 0.0, 1.0}}};
	frame.u = u;
	frame.tension = root;
	frame.ex = 1.0/root;
	frame.ey = u/root;
	frame.curvature = st->delta/root/root;
	frame.strain = st->epsilon*root;
	return frame;
}

double hawser__statics_closure(const struct hawser_statics *st)
{
	double x, y;

	if (st->space)
		return hawser__space_closure(st);
	if (st->attachments > 0)
		pieces(st, &x, &y, st->l, 0);
	else
		advance(st, &x, &y, st->eta, st->eta + st->delta*st->l, st->l);
	return st->span.d*hypot(x - 1.0, y - st->hs);
}

void hawser_statics_damper(double axis[3][3], const struct hawser_statics *st, int i)
{
	static const double plain[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
	const double beside = 1e-9; /* of the arclength: on both sides of a kink; chosen above round-off */
	struct hawser_frame_point before, after;
	double ex, ey, length, s;

	memcpy(axis, plain, sizeof plain);
	if (i >= st->attachments || !st->attached[i].damper_local)
		return;
	s = st->attached[i].s;
	before = hawser_statics_frame(st, s*(1.0 - beside));
	after = hawser_statics_frame(st, s*(1.0 + beside));
	ex = before.ex + after.ex;
	ey = before.ey + after.ey;
	length = hypot(ex, ey);
	axis[0][0] = axis[1][1] = ex/length;
	axis[0][1] = ey/length;
	axis[1][0] = -axis[0][1];
}

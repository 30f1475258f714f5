/* statics/profile_space.c - the profile of a cable in space (space.c), and what it reaches farthest.
 *
 *   X, V, Z   force over H: azimuth, eta + delta*s and the jumps of the attachments before s
 *   h, u      hypot(X, Z), constant on a piece, and the slope V/h in the plane of the piece
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "statics/catenary.h"
#include "statics/loaded.h"
#include "statics/models.h"

/* Force over H at s; at an attachment that on the side of end B, or before `until` attachments. */
static void force_at(double f[3], const struct hawser_statics *st, double s, int until)
{
	f[0] = st->azimuth[0];
	f[1] = st->eta + st->delta*s;
	f[2] = st->azimuth[1];
	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3 && (until < 0 ? st->attached[i].s <= s : i < until); c++)
			f[c] += st->delta*st->attached[i].jump[c];
}

/* Add the piece of length s that begins with the force f. */
static void advance(double x[3], const struct hawser_statics *st, const double f[3], double s)
{
	double h = hypot(f[0], f[2]), V = f[1], end = V + st->delta*s;
	double A = st->epsilon*s + hawser__angle_between(V/h, end/h, st->delta*s/h)/st->delta;

	x[0] += f[0]*A;
	x[1] += s*(V + end)*(0.5*st->epsilon + 1.0/(hypot(h, V) + hypot(h, end)));
	x[2] += f[2]*A;
}

/* Scaled position of s; `until` attachments are passed. */
static void position(double x[3], const struct hawser_statics *st, double s)
{
	double f[3], from = 0.0;

	x[0] = x[1] = x[2] = 0.0;
	force_at(f, st, 0.0, 0);
	for (int i = 0; i <= st->attachments; i++) {
		int last = i == st->attachments || st->attached[i].s > s;
		double to = last ? s : st->attached[i].s;

		advance(x, st, f, to - from);
		if (last)
			return;
		force_at(f, st, to, i + 1);
		from = to;
	}
}

static struct hawser_profile_point point(const struct hawser_statics *st, double S, const double f[3])
{
	struct hawser_profile_point to = {.S = S, .slope = f[1]/hypot(f[0], f[2])};
	double x[3], T = sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]);

	position(x, st, S/st->span.d);
	to.x = st->span.d*x[0];
	to.y = st->span.d*x[1];
	to.z = st->span.d*x[2];
	to.T = st->H*T;
	for (int c = 0; c < 3; c++)
		to.tangent[c] = f[c]/T;
	return to;
}

struct hawser_profile_point hawser__space_at(const struct hawser_statics *st, double S)
{
	double f[3];

	force_at(f, st, S/st->span.d, -1);
	return point(st, S, f);
}

struct hawser_profile_point hawser__space_before(const struct hawser_statics *st, int i)
{
	double f[3];

	force_at(f, st, st->attached[i].s, i);
	return point(st, st->attached[i].S, f);
}

void hawser__space_frame(struct hawser_frame_point *at, const struct hawser_statics *st, double s)
{
	double f[3], h, T;

	force_at(f, st, s, -1);
	h = hypot(f[0], f[2]);
	T = hypot(h, f[1]);
	at->u = f[1]/h;
	at->ex = h/T;
	at->ey = f[1]/T;
	at->tension = T;
	at->strain = st->epsilon*T;
	at->curvature = st->delta*(h/T)/T;
	for (int c = 0; c < 3; c++)
		at->axis[0][c] = f[c]/T;
	at->axis[1][0] = -at->ey*f[0]/h;
	at->axis[1][1] = at->ex;
	at->axis[1][2] = -at->ey*f[2]/h;
	at->axis[2][0] = -f[2]/h;
	at->axis[2][1] = 0.0;
	at->axis[2][2] = f[0]/h;
}

double hawser__space_closure(const struct hawser_statics *st)
{
	double x[3];

	position(x, st, st->l);
	return st->span.d*hypot(hypot(x[0] - 1.0, x[1] - st->hs), x[2]);
}

void hawser__space_total(double total[3], const struct hawser_statics *st)
{
	double scale = st->span.rho*st->span.g*st->span.d;

	for (int c = 0; c < 3; c++) {
		total[c] = c == 1 ? -scale*st->l : 0.0;
		for (int i = 0; i < st->attachments; i++)
			total[c] -= scale*st->attached[i].jump[c];
	}
}

/* n.x is stationary where n.f = 0; f is linear in s on each piece, with the slope delta along y. */
void hawser_statics_farthest(double *most, const struct hawser_statics *st, const double n[3])
{
	*most = fmax(0.0, n[0] + n[1]*st->hs)*st->span.d; /* the ends */
	for (int i = 0; i <= st->attachments; i++) {
		double from = i > 0 ? st->attached[i - 1].s : 0.0, f[3], place[2];
		double to = i < st->attachments ? st->attached[i].s : st->l;

		force_at(f, st, from, i);
		place[0] = from;
		place[1] = from - (n[0]*f[0] + n[1]*f[1] + n[2]*f[2])/(st->delta*n[1]);
		for (int k = 0; k < 2; k++)
			if (place[k] >= from && place[k] <= to) {
				double x[3];

				position(x, st, place[k]);
				*most = fmax(*most, st->span.d*(n[0]*x[0] + n[1]*x[1] + n[2]*x[2]));
			}
	}
}

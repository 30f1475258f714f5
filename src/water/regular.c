/* water/regular.c - a regular wave at its phase, and its derivatives by place and frequency.
 *
 *   s        distance along the wave, k s - tau + phase = q
 *   y, b     height at which the formulas are taken, and how far beyond on the tangent
 *   P, R     factors of the height: P = C + k b S, R = S + k b C, with C and S of hawser/waves.h
 *   d[3]     derivatives by s, the height of the place, and omega with tau held
 *
 * Along the wave u = a omega P cos q, upwards a omega R sin q, and accelerations a omega^2 P sin q and
 * -a omega^2 R cos q, as hawser_waves_at. By y, P and R have the derivatives k R and k P; by k
 *
 *   C_k = y S - h cosh(k y)/sinh(k h)^2,   S_k = y C - h sinh(k y)/sinh(k h)^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "water/near.h"

enum { S, Y, OMEGA, ALL };

struct hawser__regular hawser__regular_wave(const struct hawser_waves *waves, double omega, double g)
{
	const double h = waves->depth, k = hawser_wave_number(omega, h, g);
	const double T = isfinite(h) ? tanh(k*h) : 1.0, bend = isfinite(h) ? k*h*(1.0 - T)*(1.0 + T) : 0.0;

	return (struct hawser__regular){waves, waves->wave->amplitude, waves->wave->phase, omega, k,
	                                2.0*omega/(g*(T + bend))};
}

/* The height y of the formulas and its derivatives by the height of the place and the elevation. */
static void take_height(double *y, double by[2], double *beyond, const struct hawser_waves *waves,
                        double height, double elevation)
{
	double stretch = 1.0 + elevation/waves->depth;

	*y = hawser__wave_height(beyond, waves, height, elevation);
	by[0] = by[1] = 0.0;
	if (*y <= -waves->depth)
		return;
	by[0] = 1.0;
	if (waves->stretching == HAWSER_STRETCH_WHEELER) {
		by[0] = 1.0/stretch;
		by[1] = -(1.0 + height/waves->depth)/(stretch*stretch);
	} else if (waves->stretching != HAWSER_STRETCH_NONE && height > 0.0) {
		by[0] = 0.0;
	}
}

/* C_k and S_k. */
static struct hawser__profile by_number(const struct hawser__profile *at, double k, double y, double h)
{
	double far = exp(-2.0*k*h), up = 0.0, back = 0.0, scale = 0.0;

	if (isfinite(h)) {
		up = exp(k*(y - 2.0*h));
		back = exp(-k*(y + 2.0*h));
		scale = 2.0*h/((1.0 - far)*(1.0 - far));
	}
	return (struct hawser__profile){y*at->S - scale*(up + back), y*at->C - scale*(up - back)};
}

/* to [ALL] = scale*(factor d[] + rate*slope[]). */
static void derive(double to[ALL], double scale, double factor, const double d[ALL], double rate,
                   const double slope[ALL])
{
	for (int i = 0; i < ALL; i++)
		to[i] = scale*(factor*d[i] + rate*slope[i]);
}

/* Axes x, y, z of a quantity along the wave or upwards. */
static void spread(double by[4], const double d[ALL], double axis, const double along[2])
{
	by[0] = axis*d[S]*along[0];
	by[1] = axis*d[Y];
	by[2] = axis*d[S]*along[1];
	by[3] = axis*d[OMEGA];
}

void hawser__regular_at(struct hawser__regular_flow *flow, const struct hawser__regular *wave,
                        const double x[3], double tau)
{
	const struct hawser_waves *of = wave->of;
	const double k = wave->k, w = wave->omega, a = wave->amplitude, height = x[1] - of->surface;
	const double s = of->along[0]*x[0] + of->along[1]*x[2], q = k*s - tau + wave->phase;
	const double c = cos(q), n = sin(q), dq[ALL] = {[S] = k, [OMEGA] = wave->slope*s};
	const double axis[3] = {of->along[0], 1.0, of->along[1]};
	double y, by[2], b, P, R, dP[ALL], dR[ALL], eta[ALL], u[2][ALL], du[2][ALL];
	struct hawser__profile at, at_k;

	take_height(&y, by, &b, of, height, a*c);
	at = hawser__wave_profile(k, y, of->depth);
	at_k = by_number(&at, k, y, of->depth);
	P = at.C + k*b*at.S;
	R = at.S + k*b*at.C;
	for (int i = 0; i < ALL; i++) {
		double dk = i == OMEGA ? wave->slope : 0.0, db = i == Y && b > 0.0, dy;

		eta[i] = -a*n*dq[i];
		dy = by[1]*eta[i] + (i == Y ? by[0] : 0.0);
		dP[i] = k*R*dy + k*at.S*db + (at_k.C + b*at.S + k*b*at_k.S)*dk;
		dR[i] = k*P*dy + k*at.C*db + (at_k.S + b*at.C + k*b*at_k.C)*dk;
	}
	derive(u[0], a*w, c, dP, -P*n, dq);
	derive(u[1], a*w, n, dR, R*c, dq);
	derive(du[0], a*w*w, n, dP, P*c, dq);
	derive(du[1], -a*w*w, c, dR, -R*n, dq);
	u[0][OMEGA] += a*P*c;
	u[1][OMEGA] += a*R*n;
	du[0][OMEGA] += 2.0*a*w*P*n;
	du[1][OMEGA] -= 2.0*a*w*R*c;
	flow->elevation = a*c;
	spread(flow->elevation_by, eta, 1.0, of->along);
	for (int i = 0; i < 3; i++) {
		flow->u[i] = axis[i]*a*w*(i & 1 ? R*n : P*c);
		flow->du[i] = axis[i]*a*w*w*(i & 1 ? -R*c : P*n);
		spread(flow->u_by[i], u[i & 1], axis[i], of->along);
		spread(flow->du_by[i], du[i & 1], axis[i], of->along);
	}
}

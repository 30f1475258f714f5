/* water/waves.c - linear waves at a place and time (hawser/waves.h).
 *
 * C and S are computed as exp(k y) (1 +- exp(-2 k (y + h)))/(1 - exp(-2 k h)), y < 0 here: hyperbolic
 * functions of k h overflow in deep water. So infinite depth is no other case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/waves.h>

#include "water/near.h"
#include "water/water.h"

/* Newton's method for f(K) = K tanh K - v with K = k h, v = omega^2 h/g. f is convex below K = 1.2 and
 * nearly linear above, and both starts are above its root: K tanh K > v for K = v/sqrt(tanh v), as tanh
 * is concave. */
double hawser_wave_number(double omega, double depth, double g)
{
	double deep = omega*omega/g, v = deep*depth, K;

	if (!isfinite(depth) || v > 400.0)
		return deep;
	K = v/sqrt(tanh(v));
	for (int i = 0; i < 50; i++) {
		double T = tanh(K), step = (K*T - v)/(T + K*(1.0 - T)*(1.0 + T));

		K -= step;
		if (fabs(step) <= 4e-16*K)
			break;
	}
	return K/depth;
}

double hawser__wave_highest(double omega, double depth, double g)
{
	double k = hawser_wave_number(omega, depth, g);

	return 0.142*2.0*M_PI/k*(isfinite(depth) ? tanh(k*depth) : 1.0);
}

/* By bisection, below the frequency in deep water. */
double hawser_wave_breaking(double height, double depth, double g)
{
	double from = 0.0, to = sqrt(0.142*2.0*M_PI*g/height);

	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(from + to);

		*(hawser__wave_highest(middle, depth, g) > height ? &from : &to) = middle;
	}
	return from;
}

struct hawser__profile hawser__wave_profile(double k, double y, double depth)
{
	double up = exp(k*y)/-expm1(-2.0*k*depth), back = exp(-2.0*k*(y + depth));

	return (struct hawser__profile){up*(1.0 + back), up*(1.0 - back)};
}

double hawser__wave_height(double *beyond, const struct hawser_waves *waves, double y,
                           double elevation)
{
	*beyond = waves->stretching == HAWSER_STRETCH_EXTRAPOLATE ? fmax(y, 0.0) : 0.0;
	if (waves->stretching == HAWSER_STRETCH_WHEELER)
		y = (y - elevation)/(1.0 + elevation/waves->depth);
	else if (waves->stretching != HAWSER_STRETCH_NONE)
		y = fmin(y, 0.0);
	return fmax(y, -waves->depth);
}

double hawser__wave_growth(double *rate, const struct hawser_waves *waves, double t)
{
	double q = t/waves->ramp;

	*rate = 0.0;
	if (waves->ramp <= 0.0 || q >= 1.0)
		return 1.0;
	if (q <= 0.0)
		return 0.0;
	*rate = 30.0*q*q*(1.0 - q)*(1.0 - q)/waves->ramp;
	return q*q*q*(10.0 - 15.0*q + 6.0*q*q);
}

double hawser_waves_elevation(const struct hawser_waves *waves, const double x[3], double t)
{
	double rate, grown = hawser__wave_growth(&rate, waves, t), eta = 0.0;
	double s = waves->along[0]*x[0] + waves->along[1]*x[2];

	for (int i = 0; i < waves->count; i++) {
		const struct hawser_wave *wave = &waves->wave[i];

		eta += wave->amplitude*cos(wave->k*s - wave->omega*t + wave->phase);
	}
	return grown*eta;
}

void hawser__wave_flow(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                       const double u[2], const double du[2], double t)
{
	double rate, grown = hawser__wave_growth(&rate, waves, t);
	const double along[3] = {waves->along[0], 1.0, waves->along[1]};

	for (int k = 0; k < 3; k++) {
		flow->u[k] = along[k]*grown*u[k & 1];
		flow->du[k] = along[k]*(grown*du[k & 1] + rate*u[k & 1]);
	}
}

void hawser_waves_at(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                     const double x[3], double t)
{
	double s = waves->along[0]*x[0] + waves->along[1]*x[2], u[2] = {0.0}, du[2] = {0.0}, y, beyond;

	flow->elevation = hawser_waves_elevation(waves, x, t);
	y = hawser__wave_height(&beyond, waves, x[1] - waves->surface, flow->elevation);
	for (int i = 0; i < waves->count; i++) {
		const struct hawser_wave *wave = &waves->wave[i];
		struct hawser__profile at = hawser__wave_profile(wave->k, y, waves->depth);
		double q = wave->k*s - wave->omega*t + wave->phase, rise = wave->amplitude*wave->omega;
		double A = rise*(at.C + wave->k*beyond*at.S), B = rise*(at.S + wave->k*beyond*at.C);

		u[0] += A*cos(q);
		u[1] += B*sin(q);
		du[0] += wave->omega*A*sin(q);
		du[1] -= wave->omega*B*cos(q);
	}
	hawser__wave_flow(flow, waves, u, du, t);
}

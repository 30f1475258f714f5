/* water/waves.c - linear waves at a place and time (hawser/waves.h).
 *
 * C and S are computed as exp(k y) (1 +- exp(-2 k (y + h)))/(1 - exp(-2 k h)), y < 0 here: hyperbolic
 * functions of k h overflow in deep water. So infinite depth is no other case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <hawser/waves.h>

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

/* Value of C and S at y above the mean surface and h - depth below it, as the stretching has it. */
struct profile {
	double C, S;
};

static struct profile formula(double k, double y, double h)
{
	double up = exp(k*y)/-expm1(-2.0*k*h), back = exp(-2.0*k*(y + h));

	return (struct profile){up*(1.0 + back), up*(1.0 - back)};
}

static struct profile profile(double k, double y, const struct hawser_waves *waves)
{
	double h = waves->depth;

	if (y > 0.0 && waves->stretching == HAWSER_STRETCH_EXTRAPOLATE) {
		struct profile at = formula(k, 0.0, h);

		return (struct profile){at.C + k*y*at.S, at.S + k*y*at.C};
	}
	return formula(k, y, h);
}

/* The height above the mean surface at which the formulas are taken, for y above it. */
static double taken(const struct hawser_waves *waves, double y, double elevation)
{
	double h = waves->depth;

	if (waves->stretching == HAWSER_STRETCH_WHEELER)
		y = (y - elevation)/(1.0 + elevation/h);
	else if (waves->stretching == HAWSER_STRETCH_VERTICAL)
		y = fmin(y, 0.0);
	return fmax(y, -h);
}

/* The factor by which the waves grow, and its rate. */
static double growth(double *rate, double t, double ramp)
{
	double q = t/ramp;

	*rate = 0.0;
	if (ramp <= 0.0 || q >= 1.0)
		return 1.0;
	if (q <= 0.0)
		return 0.0;
	*rate = 30.0*q*q*(1.0 - q)*(1.0 - q)/ramp;
	return q*q*q*(10.0 - 15.0*q + 6.0*q*q);
}

double hawser_waves_elevation(const struct hawser_waves *waves, const double x[3], double t)
{
	double rate, grown = growth(&rate, t, waves->ramp), eta = 0.0;
	double s = waves->along[0]*x[0] + waves->along[1]*x[2];

	if (grown == 0.0)
		return 0.0;
	for (int i = 0; i < waves->count; i++) {
		const struct hawser_wave *wave = &waves->wave[i];

		eta += wave->amplitude*cos(wave->k*s - wave->omega*t + wave->phase);
	}
	return grown*eta;
}

void hawser_waves_at(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                     const double x[3], double t)
{
	double rate, grown = growth(&rate, t, waves->ramp);
	double s = waves->along[0]*x[0] + waves->along[1]*x[2], u[2] = {0.0}, du[2] = {0.0}, y;

	flow->elevation = hawser_waves_elevation(waves, x, t);
	y = taken(waves, x[1] - waves->surface, flow->elevation);
	for (int i = 0; grown > 0.0 && i < waves->count; i++) {
		const struct hawser_wave *wave = &waves->wave[i];
		struct profile at = profile(wave->k, y, waves);
		double q = wave->k*s - wave->omega*t + wave->phase, rise = wave->amplitude*wave->omega;
		double c = rise*cos(q), sn = rise*sin(q);

		u[0] += at.C*c;
		u[1] += at.S*sn;
		du[0] += at.C*wave->omega*sn;
		du[1] -= at.S*wave->omega*c;
	}
	for (int k = 0; k < 2; k++) {
		du[k] = grown*du[k] + rate*u[k];
		u[k] *= grown;
	}
	for (int k = 0; k < 3; k += 2) {
		flow->u[k] = waves->along[k/2]*u[0];
		flow->du[k] = waves->along[k/2]*du[0];
	}
	flow->u[1] = u[1];
	flow->du[1] = du[1];
}

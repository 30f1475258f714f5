/* Damping from measurements: exact data give exact ratios; with noise the confidence interval
 * holds the truth as often as it says. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdint.h>
#include <stdlib.h>

#include <hawser/decay.h>

#include "tests/tap.h"

enum { COUNT = 400, RUNS = 2000 };

static const double truth = 0.02385, omega = 7.3;

/* xorshift and Box-Muller, the same everywhere. */
static uint64_t state = 88172645463325252u;
static double uniform(void)
{
	state ^= state << 13;
	state ^= state >> 7;
	state ^= state << 17;
	return ((double)(state >> 11) + 0.5)/9007199254740992.0;
}

static double normal(void)
{
	return sqrt(-2.0*log(uniform()))*cos(2.0*M_PI*uniform());
}

static void series(double *t, double *x, double ratio, double noise)
{
	for (int i = 0; i < COUNT; i++) {
		t[i] = 3.0 + 0.02*i + 0.003*sin(i); /* not equidistant */
		x[i] =
		        0.7 + 1.4*exp(-ratio*omega*t[i])*cos(omega*sqrt(1.0 - ratio*ratio)*t[i] + 0.4)
		        + noise*normal();
	}
}

static void exact(double ratio)
{
	double t[COUNT], x[COUNT];
	struct hawser_decay decay;
	struct hawser_report report = {.message = ""};

	series(t, x, ratio, 0.0);
	if (!ok(!hawser_decay_fit(&decay, t, x, COUNT, 0.95, &report), "ratio %g: %s", ratio,
	        report.message))
		return;
	close_to(decay.ratio, ratio, 1e-9, "without noise: the ratio");
	close_to(decay.omega, omega, 1e-11, "and the frequency");
	ok(fabs(decay.log_decrement/ratio - 1.0) < 0.05, "logarithmic decrement: %g of %g",
	   decay.log_decrement, ratio);
}

/* Of RUNS intervals at 90 % some 1800 hold the truth, with a standard deviation of 13.4. */
static void coverage(double noise)
{
	double t[COUNT], x[COUNT];
	int held[2] = {0, 0}, fitted = 0;

	for (int r = 0; r < RUNS; r++) {
		struct hawser_decay decay;

		series(t, x, truth, noise);
		if (hawser_decay_fit(&decay, t, x, COUNT, 0.90, NULL))
			continue;
		fitted++;
		held[0] += fabs(decay.ratio - truth) <= decay.ratio_error;
		held[1] += fabs(decay.omega - omega) <= decay.omega_error;
	}
	ok(fitted == RUNS, "noise %g: %d of %d fitted", noise, fitted, RUNS);
	for (int k = 0; k < 2; k++)
		ok(abs(held[k] - 9*RUNS/10) < 4*14,
		   "noise %g: the interval of the %s holds it %d times of %d at 90 %%", noise,
		   k ? "frequency" : "ratio", held[k], RUNS);
}

static void half_power(double ratio, int points)
{
	double w[COUNT], a[COUNT];
	struct hawser_half_power half;
	struct hawser_report report = {.message = ""};

	for (int i = 0; i < points; i++) {
		w[i] = 2.0 + 10.0*(i + 0.3)/points;
		a[i] = 2.5/hypot(omega*omega - w[i]*w[i], 2.0*ratio*omega*w[i]);
	}
	if (!ok(!hawser_half_power_find(&half, w, a, points, &report), "half power, ratio %g: %s",
	        ratio, report.message))
		return;
	close_to(half.ratio, ratio, 1e-9, "the ratio");
	close_to(half.peak, omega*sqrt(1.0 - 2.0*ratio*ratio), 1e-10,
	         "the peak at omega sqrt(1 - 2 xi^2) (F.14)");
}

static void refusals(void)
{
	double t[COUNT], x[COUNT];
	struct hawser_decay decay;
	struct hawser_half_power half;
	struct hawser_report report = {.message = ""};

	series(t, x, truth, 0.0);
	ok(hawser_decay_fit(&decay, t, x, 5, 0.95, &report) == HAWSER_ERR_ARGUMENT, "few: %s",
	   report.message);
	ok(hawser_decay_fit(&decay, t, x, COUNT, 1.5, &report) == HAWSER_ERR_ARGUMENT,
	   "confidence: %s", report.message);
	ok(hawser_decay_fit(&decay, t, x, 40, 0.95, &report) == HAWSER_ERR_ARGUMENT, "one cycle: %s",
	   report.message);
	ok(hawser_half_power_find(&half, t, x, 3, &report) == HAWSER_ERR_ARGUMENT, "few: %s",
	   report.message);
	for (int i = 0; i < COUNT; i++)
		x[i] = 1.0 + 1e-3*i;
	ok(hawser_half_power_find(&half, t, x, COUNT, &report) == HAWSER_ERR_NO_SOLUTION,
	   "no peak: %s", report.message);
	x[7] = NAN;
	ok(hawser_decay_fit(&decay, t, x, COUNT, 0.95, &report) == HAWSER_ERR_NAN, "NaN: %s",
	   report.message);
	x[7] = 1.0;
	t[9] = t[8];
	ok(hawser_decay_fit(&decay, t, x, COUNT, 0.95, &report) == HAWSER_ERR_ARGUMENT, "times: %s",
	   report.message);
}

int main(void)
{
	exact(truth);
	exact(0.15);
	coverage(0.01);
	coverage(0.1);
	half_power(truth, 400);
	half_power(0.3, 60);
	refusals();
	return done_testing();
}

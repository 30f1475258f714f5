/* Damping from measurements: exact data give exact ratios; with noise the confidence interval
 * contains the true ratio with the stated probability.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>

#include <stdint.h>
#include <stdlib.h>

#include <hawser/decay.h>

#include "tests/tap.h"

enum { COUNT = 400, RUNS = 2000 };

static const double truth = 0.02385, omega = 7.3;

/* xorshift and Box-Muller: the same numbers on every machine. */
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

/* Of n intervals with a confidence of 90 % about 0.9 n contain the true ratio, with a standard
 * deviation of sqrt(0.09 n). */
static void coverage(double noise)
{
	double t[COUNT], x[COUNT];
	int held[2] = {0, 0}, fitted = 0, runs = getenv("HAWSER_LONG") ? RUNS : 400;

	for (int r = 0; r < RUNS; r++) {
		struct hawser_decay decay;

		series(t, x, truth, noise); /* of all runs: the random numbers that follow stay the same */
		if (r >= runs)
			continue;
		if (hawser_decay_fit(&decay, t, x, COUNT, 0.90, NULL))
			continue;
		fitted++;
		held[0] += fabs(decay.ratio - truth) <= decay.ratio_error;
		held[1] += fabs(decay.omega - omega) <= decay.omega_error;
	}
	ok(fitted == runs, "noise %g: %d of %d fitted", noise, fitted, runs);
	for (int k = 0; k < 2; k++)
		ok(fabs(held[k] - 0.9*runs) < 4.0*sqrt(0.09*runs),
		   "noise %g: the interval of the %s holds it %d times of %d at 90 %%", noise,
		   k ? "frequency" : "ratio", held[k], runs);
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
	if (!ok(!hawser_half_power_find(&half, w, a, points, 0.95, &report), "half power, ratio %g: %s",
	        ratio, report.message))
		return;
	close_to(half.ratio, ratio, 1e-9, "the ratio");
	close_to(half.peak, omega*sqrt(1.0 - 2.0*ratio*ratio), 1e-10,
	         "the peak at omega sqrt(1 - 2 xi^2) (F.14)");
}

/* Ratio 0.02, with the peak between two samples and the half-power points near one. */
static void known_table(void)
{
	double w[17], a[17];
	struct hawser_half_power half;

	for (int k = 0; k < 17; k++) {
		w[k] = 1.005 + 0.015*(k - 8);
		a[k] = 1.0/hypot(1.0 - w[k]*w[k], 0.04*w[k]);
	}
	ok(!hawser_half_power_find(&half, w, a, 17, 0.95, NULL), "a table of 17 points");
	close_to(half.ratio, 0.02, 1e-12, "its ratio");
	close_to(half.high, sqrt(1.0 - 2.0*4e-4 + 0.04*sqrt(1.0 - 4e-4)), 1e-12,
	         "its upper half-power point");
	ok(half.ratio_error < 1e-10, "its error: %.1e", half.ratio_error);
}

/* Tables of exact oscillators without noise, many with steps wider than the peak. */
static void random_tables(void)
{
	int found = 0, within = 0;
	double worst = 0.0;

	for (int r = 0; r < RUNS/5; r++) {
		double ratio = 0.001*pow(300.0, uniform()), w0 = pow(10.0, 4.0*uniform() - 2.0);
		double width = (0.2 + uniform())*fmax(4.0*ratio, 0.02), w[COUNT], a[COUNT];
		int points = 5 + (int)(60.0*uniform());
		struct hawser_half_power half;

		width = fmin(width, 0.95);
		for (int i = 0; i < points; i++) {
			w[i] = w0*(1.0 - width + 2.0*width*(i + 0.9*uniform())/points);
			a[i] = 3.7/hypot(w0*w0 - w[i]*w[i], 2.0*ratio*w0*w[i]);
		}
		if (hawser_half_power_find(&half, w, a, points, 0.95, NULL))
			continue;
		found++;
		within += fabs(half.ratio - ratio) <= half.ratio_error &&
		          fabs(half.peak - w0*sqrt(1.0 - 2.0*ratio*ratio)) <= half.peak_error;
		worst = fmax(worst, half.ratio_error/ratio);
	}
	ok(found > RUNS/5*3/4 && within == found,
	   "%d of %d random tables have the half-power points, %d within the stated error, %.1e at most",
	   found, RUNS/5, within, worst);
	ok(worst < 1e-8, "which is round-off");
}

/* With noise of 0.5 % of the peak and a second mode: the stated error holds, or the table is
 * refused. */
static void impure_tables(void)
{
	int held[2] = {0}, stated[2] = {0};

	for (int r = 0; r < RUNS/20; r++) {
		double ratio = 0.005 + 0.05*uniform(), w[60], a[60], peak = 0.5/ratio;
		double other = r % 2 == 1 ? 2.0 + 3.0*uniform() : 0.0;
		struct hawser_half_power half;

		for (int i = 0; i < 60; i++) {
			w[i] = 1.0 + 6.0*ratio*((i + 0.5)/30.0 - 1.0);
			a[i] = 1.0/hypot(1.0 - w[i]*w[i], 2.0*ratio*w[i]);
			if (other > 0.0) {
				double re = 1.0 - w[i]*w[i], im = 2.0*ratio*w[i], d = re*re + im*im;

				a[i] = hypot(re/d + 1.0/(other*other - w[i]*w[i]), im/d);
			}
			if (r % 2 == 0)
				a[i] = fabs(a[i] + 0.005*peak*normal());
		}
		if (r % 4 > 1 && !getenv("HAWSER_LONG")) /* the random numbers that follow stay the same */
			continue;
		if (hawser_half_power_find(&half, w, a, 60, 0.95, NULL))
			continue;
		stated[r % 2]++;
		held[r % 2] += fabs(half.ratio - ratio) <= half.ratio_error;
	}
	for (int k = 0; k < 2; k++)
		ok(stated[k] > 18 && held[k] >= 0.93*stated[k], "%s: %d of %d stated errors hold",
		   k ? "a second mode" : "noise", held[k], stated[k]);
}

/* A peak that bends without a fold: omega^2 = 1 + bend a^2 -+ 2 xi sqrt(1/a^2 - 1), xi = 0.02. */
static void bent_tables(int points)
{
	int refused = 0, held = 0;

	for (int r = 0; r < 20; r++) {
		double bend = 0.04*r/20.0, w[COUNT], a[COUNT];
		struct hawser_half_power half;

		for (int i = 0; i < points; i++) {
			double k = 40.0*i/(points - 1) - 20.0, side = k < 0.0 ? -0.04 : 0.04;

			a[i] = 1.0/(1.0 + 0.008*k*k);
			w[i] = sqrt(1.0 + bend*a[i]*a[i] + side*sqrt(1.0/(a[i]*a[i]) - 1.0));
		}
		if (hawser_half_power_find(&half, w, a, points, 0.95, NULL)) {
			refused++;
			continue;
		}
		/* the ratio is relative to the frequency, which the bend increases */
		held += fabs(0.5*tan(2.0*asin(half.ratio))*half.peak*half.peak - 0.02) <=
		        half.ratio_error + 1e-12;
	}
	ok(refused > 0 && refused < 20 && held + refused == 20, "of 20 bent peaks %d are refused, %d "
	   "stated errors hold", refused, held);
}

/* Two modes as close as a seventh of their width, whose sum has a peak that is 5 % wider than that
 * of each (a user's cable, 4.8832 and 4.8988 rad/s, ratio 0.00983); and one mode, which is not
 * taken for two. The fit has their sum to second order in their distance (half_power.c): at most
 * 1.4e-3 of the ratio here, within the stated error, which is 35 times larger. */
static void close_modes(int points, double other)
{
	double ratio = 0.00983, w1 = 4.8832, w2 = 4.8988, w[COUNT], a[COUNT];
	struct hawser_half_power half;

	for (int i = 0; i < points; i++) {
		w[i] = 4.89*(1.0 + 5.0*ratio*(2.0*i/(points - 1) - 1.0));
		a[i] = cabs(1.0/(w1*w1 - w[i]*w[i] + 2.0*I*ratio*w1*w[i]) +
		            other/(w2*w2 - w[i]*w[i] + 2.0*I*ratio*w2*w[i]));
	}
	if (!ok(!hawser_half_power_find(&half, w, a, points, 0.95, NULL), "two modes by %d points", points))
		return;
	ok(half.modes == (other > 0.0 ? 2 : 1) && fabs(half.ratio - ratio) <= half.ratio_error + 1e-9 &&
	   fabs(half.ratio - ratio) < 2e-3*ratio, "%d modes: ratio %.6g +- %.1e", half.modes, half.ratio,
	   half.ratio_error);
}

/* Random pairs, up to one width apart, whose parts have any sizes and signs, of one ratio or of two
 * that differ by up to 40 %: each stated error contains both ratios, or the table is refused. (Before
 * the sum of two modes was fitted, 39 of 93 of one ratio did not, by up to 2.7 times; before the
 * quotient of polynomials 31 of 59 of two, by up to 27 times.) */
static void random_pairs(double differ)
{
	int stated = 0, held = 0, pairs = 0, all = getenv("HAWSER_LONG") ? 200 : differ > 0.0 ? 40 : 24;

	for (int r = 0; r < all; r++) {
		double ratio = pow(10.0, -2.5 + 1.2*uniform()), w1 = 1.0 + 19.0*uniform();
		double apart = 0.02 + 0.98*uniform(), w2 = w1*(1.0 + 2.0*ratio*apart);
		double other = (0.1 + 0.9*uniform())*(uniform() < 0.33 ? -1.0 : 1.0);
		double width = (3.0 + 9.0*uniform())*ratio, w[80], a[80];
		double second = differ > 0.0 ? ratio*(1.0 + differ*(2.0*uniform() - 1.0)) : ratio;
		int points = r % 2 ? 80 : 25;
		struct hawser_half_power half;

		for (int i = 0; i < points; i++) {
			w[i] = 0.5*(w1 + w2)*(1.0 + width*(2.0*i/(points - 1) - 1.0));
			a[i] = cabs(1.0/(w1*w1 - w[i]*w[i] + 2.0*I*ratio*w1*w[i]) +
			            other/(w2*w2 - w[i]*w[i] + 2.0*I*second*w2*w[i]));
		}
		if (hawser_half_power_find(&half, w, a, points, 0.95, NULL))
			continue;
		stated++;
		pairs += half.modes == 2;
		held += fmax(fabs(half.ratio - ratio), fabs(half.ratio - second)) <= half.ratio_error;
	}
	ok(10*stated >= all && 20*pairs >= all && held == stated, "of %d pairs %d are stated, %d as two "
	   "modes, %d within the error", all, stated, pairs, held);
}

/* Pairs with noise, at most half a width apart, of one ratio or of two: each stated error contains the
 * ratio, and those of two that are found, or the table is refused; pair_error contains those that
 * are not found. (Before the interval contained the
 * pairs of one ratio that noise hides, 30 of 80 did not, by up to 5.4 times.) */
static void noisy_pairs(double differ)
{
	int stated = 0, held = 0, hidden = 0, contained = 0;
	int all = getenv("HAWSER_LONG") ? 300 : differ > 0.0 ? 32 : 16;

	for (int r = 0; r < all; r++) {
		double ratio = pow(10.0, -2.5 + uniform()), apart = 0.5*uniform(), w[60], a[60], peak = 0.0;
		double other = (0.1 + 0.9*uniform())*(uniform() < 0.33 ? -0.5 : 1.0);
		double noise = (differ > 0.0 ? 0.0001 : 0.001)*pow(10.0, uniform()), w2 = 1.0 + 2.0*ratio*apart;
		double second = ratio*(1.0 + differ*(2.0*uniform() - 1.0));
		struct hawser_half_power half;

		for (int i = 0; i < 60; i++) {
			w[i] = 0.5*(1.0 + w2)*(1.0 + 6.0*ratio*(2.0*i/59.0 - 1.0));
			a[i] = cabs(1.0/(1.0 - w[i]*w[i] + 2.0*I*ratio*w[i]) +
			            other/(w2*w2 - w[i]*w[i] + 2.0*I*second*w2*w[i]));
			peak = fmax(peak, a[i]);
		}
		for (int i = 0; i < 60; i++)
			a[i] = fabs(a[i] + noise*peak*normal());
		if (hawser_half_power_find(&half, w, a, 60, 0.95, NULL))
			continue;
		second = fmax(fabs(half.ratio - ratio), fabs(half.ratio - second));
		hidden += half.modes == 1;
		contained += half.modes == 1 && second <= half.pair_error;
		if (differ > 0.0 && half.modes == 1)
			continue;
		stated++;
		held += second <= half.ratio_error;
	}
	ok(hidden > 2 && 20*contained >= 19*hidden, "%d of %d pairs that are not seen are within "
	   "pair_error", contained, hidden);
	ok(8*stated >= all && 20*held >= 19*stated, "of %d pairs with noise, %g apart, %d are stated, %d "
	   "within the error", all, differ, stated, held);
}

/* One mode that bends by 6e-4 and -6e-4 of half its width is one mode (u_1 of a small response of the
 * chairlift was taken for two modes, with an error of 7 %, or refused). */
static void slight_bend(double bend)
{
	double ratio = 0.0046, w[46], a[46];
	struct hawser_half_power half;
	struct hawser_report report = {.message = ""};

	for (int i = 0; i < 46; i++) {
		double k = (2.0*i - 45.0)/45.0*1.8, side = 2.0*ratio*sqrt(1.0 - ratio*ratio);

		a[i] = 1.0/sqrt(1.0 + k*k);
		w[i] = sqrt(1.0 - 2.0*ratio*ratio + side*(k + bend*a[i]*a[i]));
	}
	if (ok(!hawser_half_power_find(&half, w, a, 46, 0.95, &report), "a slight bend: %s",
	       report.message))
		ok(half.modes == 1 && fabs(half.ratio - ratio) <= half.ratio_error &&
		   half.ratio_error < 0.003*ratio, "%d mode: %.6g +- %.1e", half.modes, half.ratio,
		   half.ratio_error);
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
	ok(hawser_half_power_find(&half, t, x, 3, 0.95, &report) == HAWSER_ERR_ARGUMENT, "few: %s",
	   report.message);
	for (int i = 0; i < COUNT; i++)
		x[i] = 1.0 + 1e-3*i;
	ok(hawser_half_power_find(&half, t, x, COUNT, 0.95, &report) == HAWSER_ERR_NO_SOLUTION,
	   "no peak: %s", report.message);
	ok(hawser_half_power_find(&half, t, x, COUNT, 1.5, &report) == HAWSER_ERR_ARGUMENT,
	   "confidence: %s", report.message);
	for (int i = 0; i < 9; i++)
		x[100 + i] = i == 4 ? 1.0 : 0.5*fabs(cos(0.3*(i - 4)));
	ok(hawser_half_power_find(&half, t + 100, x + 100, 9, 0.95, &report) ==
	   HAWSER_ERR_NO_SOLUTION, "a spike on a hump: %s", report.message);
	for (int i = 0; i < 9; i++)
		x[100 + i] = i == 4 ? 1.0 : 0.9 - 0.1*abs(i - 4);
	ok(hawser_half_power_find(&half, t + 100, x + 100, 9, 0.95, &report) ==
	   HAWSER_ERR_NO_SOLUTION, "a cusp: %s", report.message);
	x[7] = NAN;
	ok(hawser_decay_fit(&decay, t, x, COUNT, 0.95, &report) == HAWSER_ERR_NAN, "NaN: %s",
	   report.message);
	x[7] = 1.0;
	t[9] = t[8];
	ok(hawser_decay_fit(&decay, t, x, COUNT, 0.95, &report) == HAWSER_ERR_ARGUMENT, "times: %s",
	   report.message);
}

CASE(property_decay)
{
	exact(truth);
	exact(0.15);
	coverage(0.01);
	coverage(0.1);
	half_power(truth, 400);
	half_power(0.3, 60);
	known_table();
	random_tables();
	impure_tables();
	bent_tables(41);
	bent_tables(199);
	close_modes(25, 1.0);
	close_modes(200, 1.0);
	close_modes(60, 0.6);
	close_modes(60, 0.0);
	random_pairs(0.0);
	random_pairs(0.4);
	noisy_pairs(0.0);
	noisy_pairs(0.1);
	slight_bend(6e-4);
	slight_bend(-6e-4);
	slight_bend(1e-5);
	refusals();
	return done_testing();
}

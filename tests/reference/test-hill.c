/* Hill's equation: multipliers against closed forms, boundaries against Mathieu's characteristic
 * values.
 *
 *   constant    x'' + 2c x' + k x = 0: exponents -c +- sqrt(c^2 - k)
 *   Meissner    k jumps between k1 and k2 at half the period: M = M2 M1, each a damped rotation in
 *               closed form
 *   Liouville   the product of all multipliers is exp(-2 c T), whatever the excitation
 *   stress      A = [0 1; -10 cos t, -24 - 10 sin t] has the exponents 0 and -24: the second row
 *               is the
 *               derivative of x' + (24 + 10 sin t) x - ... (a monodromy matrix formed at once
 *               gives -6)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>

#include <hawser/hill.h>

#include "tests/tap.h"

struct oscillator {
	double c, k1, k2; /* stiffness in the first and in the second half of the period */
};

static const double period = 2.385;

static void matrix(void *context, double *A, double t)
{
	const struct oscillator *o = context;

	A[0] = 0.0;
	A[1] = 1.0;
	A[2] = -(fmod(t/period, 1.0) < 0.5 ? o->k1 : o->k2);
	A[3] = -2.0*o->c;
}

/* M [2][2] over the time t, damped oscillation. */
static void exact(double complex M[4], double c, double k, double t)
{
	double complex w = csqrt(k - c*c), s = csin(w*t)/w, cosine = ccos(w*t);
	double decay = exp(-c*t);

	M[0] = decay*(cosine + c*s);
	M[1] = decay*s;
	M[2] = -decay*k*s;
	M[3] = decay*(cosine - c*s);
}

static void meissner(double c, double k1, double k2)
{
	struct oscillator o = {c, k1, k2};
	struct hawser_report report = {.message = ""};
	double log_modulus[2], argument[2], error, worst = 0.0;
	double complex A[4], B[4], trace, det = exp(-2.0*c*period), root;

	exact(A, c, k1, 0.5*period);
	exact(B, c, k2, 0.5*period);
	trace = B[0]*A[0] + B[1]*A[2] + B[2]*A[1] + B[3]*A[3];
	root = csqrt(0.25*trace*trace - det);
	if (!ok(!hawser_periodic_multipliers(log_modulus, argument, &error, matrix, &o, 2, period,
	                                     &report),
	        "c %g, k %g and %g", c, k1, k2))
		return;
	for (int i = 0; i < 2; i++) {
		double complex mu = cexp(log_modulus[i] + I*argument[i]);

		worst = fmax(worst, fmin(cabs(mu - (0.5*trace + root)), cabs(mu - (0.5*trace - root))));
	}
	ok(worst < 1e-12, "multipliers within %.1e of the closed form, and %.1e by their own estimate",
	   worst, error);
	ok(fabs(log_modulus[0] + log_modulus[1] + 2.0*c*period) < 1e-12, "Liouville: off by %.1e",
	   fabs(log_modulus[0] + log_modulus[1] + 2.0*c*period));
}

static void stress_matrix(void *context, double *A, double t)
{
	(void)context;
	A[0] = 0.0;
	A[1] = 1.0;
	A[2] = -10.0*cos(t);
	A[3] = -24.0 - 10.0*sin(t);
}

static void stress(void)
{
	struct hawser_report report = {.message = ""};
	double log_modulus[2], argument[2], error;

	if (!ok(!hawser_periodic_multipliers(log_modulus, argument, &error, stress_matrix, NULL, 2,
	                                     2.0*M_PI,
	                                     &report), "stress test"))
		return;
	ok(fabs(log_modulus[0]/(2.0*M_PI)) < 1e-12, "exponent 0: %.1e", log_modulus[0]/(2.0*M_PI));
	close_to(log_modulus[1]/(2.0*M_PI), -24.0, 1e-12, "exponent -24");
}

static void bad_matrix(void *context, double *A, double t)
{
	(void)context;
	A[0] = t > 1.0 ? NAN : 1.0;
}

static void refusals(void)
{
	struct hawser_report report = {.message = ""};
	double a[2], b[2], error;
	struct hawser_hill_options options = hawser_hill_defaults();
	struct hawser_hill_field field = {.m = 2};
	struct hawser_hill_chart chart;

	ok(hawser_periodic_multipliers(a, b, &error, bad_matrix, NULL, 1, 2.0,
	                               &report) == HAWSER_ERR_NAN,
	   "a matrix that is not finite: %s", report.message);
	ok(hawser_periodic_multipliers(a, b, &error, matrix, NULL, 2, -1.0,
	                               &report) == HAWSER_ERR_ARGUMENT,
	   "a period: %s", report.message);
	ok(hawser_mathieu_value(a, 0, 1, 1.0, &report) == HAWSER_ERR_ARGUMENT, "b_0: %s",
	   report.message);
	ok(hawser_hill_trace(&chart, &field, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "a rectangle: %s",
	   report.message);
	options.to[0] = options.to[1] = 1.0;
	options.lines = 0;
	ok(hawser_hill_trace(&chart, &field, &options, &report) == HAWSER_ERR_ARGUMENT, "lines: %s",
	   report.message);
	hawser_hill_clear(NULL);
	hawser_mathieu_close(NULL);
	hawser_hill_cable_close(NULL);
}

/* --- boundaries --- */

/* Distance of a point from the nearest characteristic value. */
static double off(double delta, double epsilon)
{
	double best = INFINITY;

	for (int r = 0; r <= 6; r++)
		for (int odd = 0; odd < 2; odd++) {
			double value = NAN;

			if ((r || !odd) && !hawser_mathieu_value(&value, r, odd, epsilon, NULL))
				best = fmin(best, fabs(value - delta));
		}
	return best;
}

static int chart_of(struct hawser_hill_chart *chart, double damping, double to)
{
	struct hawser_hill_options options = hawser_hill_defaults();
	struct hawser_hill_field field;
	struct hawser_report report = {.message = ""};
	int good;

	options.from[0] = -1.0;
	options.to[0] = 7.3;
	options.to[1] = to;
	options.step = 0.02;
	options.samples = 120;
	options.lines = 5;
	good = !hawser_mathieu_open(&field, damping, &report) &&
	        !hawser_hill_trace(chart, &field, &options, &report);
	hawser_mathieu_close(&field);
	return ok(good, "a chart with damping %g: %d boundaries", damping,
	          good ? chart->boundaries : 0);
}

static void characteristic(void)
{
	struct hawser_hill_chart chart;
	double worst = 0.0;
	int points = 0;

	if (!chart_of(&chart, 0.0, 3.0))
		return;
	for (int b = 0; b < chart.boundaries; b++)
		for (int i = 0; i < chart.boundary[b].points; i++, points++)
			worst = fmax(worst, off(chart.boundary[b].at[2*i], chart.boundary[b].at[2*i + 1]));
	ok(chart.boundaries == 5, "a_0, b_1, a_1, b_2 and a_2: %d boundaries", chart.boundaries);
	ok(points > 150 && worst < 1e-10, "%d points within %.1e of GSL's characteristic values",
	   points, worst);
	hawser_hill_clear(&chart);
}

/* With damping the first tongue begins at epsilon = 2c (1 + O(c^2)): x = exp(-c t) y, and y may
 * grow as exp(c t). And no boundary of multiplier +-1 lies outside those without damping. */
static void damped(void)
{
	struct hawser_hill_chart chart;
	double lowest = INFINITY, c = 0.02385;

	if (!chart_of(&chart, c, 0.6))
		return;
	for (int b = 0; b < chart.boundaries; b++)
		for (int i = 0; chart.boundary[b].kind == HAWSER_HILL_MINUS &&
		     i < chart.boundary[b].points; i++)
			lowest = fmin(lowest, chart.boundary[b].at[2*i + 1]);
	ok(fabs(lowest/(2.0*c) - 1.0) < 0.02, "the first tongue begins at %.6f, 2c = %.6f", lowest,
	   2.0*c);
	hawser_hill_clear(&chart);
}

/* The error of an expansion to second order falls with epsilon^3, or ^4 where there is no cubic
 * term. */
static void expansions(void)
{
	for (int r = 0; r <= 4; r++)
		for (int odd = 0; odd < 2; odd++) {
			double value[2] = {0.0}, gap[2], printed[2];

			if (r == 0 && odd)
				continue;
			for (int k = 0; k < 2; k++) {
				double e = k ? 0.02 : 0.04;

				if (hawser_mathieu_value(&value[k], r, odd, e, NULL))
					value[k] = NAN;
				gap[k] = fabs(value[k] - hawser_mathieu_expansion(r, odd, e, 0));
				printed[k] = fabs(value[k] - hawser_mathieu_expansion(r, odd, e, 1));
			}
			ok(log2(gap[0]/gap[1]) > 2.9, "%c_%d: corrected, error %.1e of order %.2f",
			   odd ? 'b' : 'a',
			   r, gap[0], log2(gap[0]/gap[1]));
			if (r == 1)
				ok(fabs(log2(printed[0]/printed[1]) - 2.0) < 0.05,
				   "%c_1 as printed in (G.21), (G.22): error %.1e of order %.2f: a wrong square term",
				   odd ? 'b' : 'a', printed[0], log2(printed[0]/printed[1]));
		}
}

int main(void)
{
	meissner(0.0, 1.3, 4.7);
	meissner(0.1, 1.3, 1.3);
	meissner(0.2385, 0.3, -2.0);
	meissner(2.0, 1.0, 9.0);
	stress();
	characteristic();
	damped();
	expansions();
	refusals();
	return done_testing();
}

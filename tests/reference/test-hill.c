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
#include <complex.h>

#include <stdint.h>
#include <stdlib.h>

#include <hawser/hill.h>

#include "tests/gsl_mathieu.h"
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
	struct hawser_hill_options options = {.lines = 0};
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
	options.lines = -1;
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

			if ((r || !odd) && !gsl_mathieu(&value, r, odd, epsilon))
				best = fmin(best, fabs(value - delta));
		}
	return best;
}

static int chart_of(struct hawser_hill_chart *chart, double damping, double to)
{
	struct hawser_hill_options options = {.lines = 0};
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
 * grow as exp(c t). No boundary with a multiplier +-1 lies outside those without damping. */
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

static struct hawser_hill_options window(double delta, double half, double low, double high)
{
	struct hawser_hill_options options = {.lines = 0};

	options.from[0] = delta - half;
	options.to[0] = delta + half;
	options.from[1] = low;
	options.to[1] = high;
	options.step = 0.2;
	return options;
}

/* Relative distance of the boundary from GSL's characteristic value of the same name. */
static double off_named(const struct hawser_hill_boundary *boundary)
{
	double worst = 0.0, a = NAN, b = NAN;

	for (int i = 0; i < boundary->points; i++) {
		const double *at = boundary->at + 2*i;

		if (gsl_mathieu(&a, boundary->order, 0, at[1]) ||
		    (boundary->order && gsl_mathieu(&b, boundary->order, 1, at[1])))
			return INFINITY;
		worst = fmax(worst, fabs(at[0] - (boundary->order == 0 ? a : boundary->upper
		                                  ? fmax(a, b) : fmin(a, b)))/fmax(1.0, fabs(a)));
	}
	return worst;
}

/* Tongues narrower than the sampling of any search line: both boundaries of tongue r near epsilon,
 * and only boundaries of tongues whose values lie in the window. */
static void narrow(int r, double epsilon)
{
	struct hawser_report report = {.message = ""};
	struct hawser_hill_options options;
	struct hawser_hill_chart chart;
	double middle = NAN, worst = 0.0;
	int own = 0, low, high;

	(void)!gsl_mathieu(&middle, r, 0, epsilon);
	options = window(middle, 0.5, epsilon - 0.01, epsilon + 0.01);
	if (!ok(!hawser_mathieu_trace(&chart, 0.0, &options, &report), "tongue %d %s", r, report.message))
		return;
	for (int b = 0; b < chart.boundaries; b++) {
		own += chart.boundary[b].order == r;
		worst = fmax(worst, off_named(&chart.boundary[b]));
	}
	low = chart.tongues > 0 && chart.tongue[0].order == r && chart.tongue[0].width[0] > 0.0;
	high = low && chart.tongue[0].width[1] < 1e-6;
	ok(own == 2 && worst < 2e-14 && low && high, "epsilon %g: tongue %d, %.1e to %.1e wide, %d "
	   "boundaries, within %.1e of GSL's values", epsilon, r,
	   chart.tongues ? chart.tongue[0].width[0] : NAN,
	   chart.tongues ? chart.tongue[0].width[1] : NAN, own, worst);
	hawser_hill_clear(&chart);
}

static uint64_t chance = 2385;

static double between(double low, double high)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return low + (high - low)*(double)(chance >> 11)/9007199254740992.0;
}

static void windows(void)
{
	double worst = 0.0;
	int points = 0, missing = 0, count = getenv("HAWSER_LONG") ? 12 : 5;

	for (int i = 0; i < count; i++) {
		double epsilon = between(-100.0, 100.0);
		struct hawser_hill_options options = window(between(-50.0, 300.0), between(0.1, 20.0),
		                                            epsilon, epsilon + between(0.1, 5.0));
		struct hawser_hill_chart chart;
		int found[64] = {0};

		if (hawser_mathieu_trace(&chart, 0.0, &options, NULL))
			missing++;
		for (int b = 0; b < chart.boundaries; b++) {
			worst = fmax(worst, off_named(&chart.boundary[b]));
			points += chart.boundary[b].points;
			found[chart.boundary[b].order] = 1;
		}
		for (int r = 1; r < 24; r++)
			for (int k = 0; k < 9; k += 4) {
				double a, e = options.from[1] + (options.to[1] - options.from[1])*k/8;

				if (!gsl_mathieu(&a, r, k%2, e))
					missing += a > options.from[0] && a < options.to[0] && !found[r];
			}
		hawser_hill_clear(&chart);
	}
	ok(missing == 0 && points > 300 && worst < 5e-14, "%d windows: %d points within %.1e of GSL's "
	   "values, %d missing", count, points, worst, missing);
}

/* Largest logarithm of a multiplier, by the monodromy matrix. *product of |1 - mu|/(1 + |mu|) is as
 * accurate as the matrix even if two multipliers nearly coincide. */
static double growth(double *product, const struct hawser_hill_field *field, double delta,
                     double epsilon)
{
	double log_modulus[2], argument[2];

	*product = NAN;
	if (field->multipliers(field->context, log_modulus, argument, delta, epsilon, NULL))
		return NAN;
	*product = fabs(tanh(0.5*log_modulus[0])*tanh(0.5*log_modulus[1]));
	return fmax(log_modulus[0], log_modulus[1]);
}

/* With damping: by the monodromy matrix growth begins at the boundaries, and tongues that are
 * reported as closed have no growth. */
static void damped_tongues(void)
{
	double worst = 0.0, product;
	int points = 0, closed = 0, wrong = 0, count = getenv("HAWSER_LONG") ? 14 : 8;

	for (int i = 0; i < count; i++) {
		double c = pow(10.0, between(-6.0, -0.5)), epsilon = between(-30.0, 28.0);
		struct hawser_hill_options options = window(between(-10.0, 130.0), 12.0, epsilon,
		                                            epsilon + 2.0);
		struct hawser_hill_field field;
		struct hawser_hill_chart chart;

		if (hawser_mathieu_trace(&chart, c, &options, NULL) ||
		    hawser_mathieu_open(&field, c, NULL))
			wrong++;
		for (int b = 0; b < chart.boundaries; b++)
			for (int k = 0; k < chart.boundary[b].points; k += 11, points++) {
				const double *at = chart.boundary[b].at + 2*k;

				(void)growth(&product, &field, at[0], at[1]);
				worst = fmax(worst, product);
			}
		for (int t = 0; t < chart.tongues; t++) {
			double a = NAN, b = NAN;

			if (isfinite(chart.tongue[t].opens))
				continue;
			closed++;
			for (int k = 0; k < 3; k++) {
				double e = epsilon + k;

				(void)!gsl_mathieu(&a, chart.tongue[t].order, 0, e);
				(void)!gsl_mathieu(&b, chart.tongue[t].order, 1, e);
				wrong += growth(&product, &field, 0.5*(a + b) + c*c, e) > 1e-12;
			}
		}
		hawser_hill_clear(&chart);
		hawser_mathieu_close(&field);
	}
	ok(points > 20 && closed > (count > 8 ? 5 : 2) && wrong == 0, "%d points with damping, "
	   "%d tongues closed by it, %d wrong", points, closed, wrong);
	ok(worst < 1e-10, "a multiplier 1 or -1 there by the monodromy matrix: %.1e", worst);
}

/* The error of an expansion to second order is proportional to epsilon^3, or to epsilon^4 if there
 * is no cubic term. */
static void expansions(void)
{
	for (int r = 0; r <= 4; r++)
		for (int odd = 0; odd < 2; odd++) {
			double value[2] = {0.0}, gap[2], printed[2];

			if (r == 0 && odd)
				continue;
			for (int k = 0; k < 2; k++) {
				double e = k ? 0.02 : 0.04;

				if (gsl_mathieu(&value[k], r, odd, e))
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

/* Values against GSL's, and the distances of points near them. GSL's own error is about 1e-13
 * here. */
static void characteristic_values(void)
{
	double worst[2] = {0.0, 0.0};
	int missing = 0, count = 0;

	for (int r = 0; r <= 40; r += getenv("HAWSER_LONG") || r < 6 ? 1 : 3)
		for (int odd = r == 0 ? 0 : -1; odd < 1; odd++)
			for (double epsilon = -90.0; epsilon < 100.0; epsilon += 12.5) {
				double gsl, own = NAN, beside = NAN, away = 1e-4*fmax(1.0, 0.01*r);

				if (gsl_mathieu(&gsl, r, -odd, epsilon) ||
				    hawser_mathieu_value(&own, r, -odd, epsilon, NULL) ||
				    hawser_mathieu_distance(&beside, gsl + away, r, -odd, epsilon, NULL))
					missing++;
				count++;
				worst[0] = fmax(worst[0], fabs(own - gsl)/fmax(1.0, fabs(gsl)));
				worst[1] = fmax(worst[1], fabs(beside/away - 1.0));
			}
	ok(missing == 0 && worst[0] < 1e-12, "%d characteristic values are GSL's within %.1e", count,
	   worst[0]);
	ok(worst[1] < 1e-3, "distances of points beside them are right within %.1e", worst[1]);
}

CASE(reference_hill)
{
	characteristic_values();
	meissner(0.0, 1.3, 4.7);
	meissner(0.1, 1.3, 1.3);
	meissner(0.2385, 0.3, -2.0);
	meissner(2.0, 1.0, 9.0);
	stress();
	characteristic();
	damped();
	narrow(13, 25.0);
	narrow(14, 25.0);
	narrow(9, 3.0);
	narrow(30, 100.0);
	windows();
	damped_tongues();
	expansions();
	refusals();
	return done_testing();
}

/* study/half_power.c - damping from half-power points (hawser/decay.h).
 *
 *    xi, w0      damping ratio and undamped frequency; a = f/|w0^2 - w^2 + 2 i xi w0 w|
 *    z, y        omega^2 and 1/a^2: y is of second degree in z
 *    zp, m, D    y = m (1 + (z - zp)^2/D^2): m at the peak, 2 m at the half-power points zp -+ D
 *    p, x, h     y = p0 + p1 x + p2 x^2 with x = (z - zc)/h, zc and h of the points that are fitted
 *    R           triangular factor of the fit's equations, with their right side as a last column
 *    e           (d/D)^2 for two equal modes at zp -+ d; g1 g2/(g1 + g2)^2 (2 d/D)^2 where their
 *                parts of the response are as g1 to g2
 *
 * zp = w0^2 (1 - 2 xi^2) and D = 2 xi sqrt(1 - xi^2) w0^2, so that D/zp = tan(2 asin xi).
 *
 * A parabola is fitted to the points from the last one below zp - D to the first one above zp + D,
 * at least FEWEST. The peak and the half-power points are those of the parabola, not of the largest
 * sample, which is below the peak. The fit minimises the differences of amplitudes, (P(z) - y)
 * a^3/2, since the noise of measured amplitudes does not depend on their size.
 *
 * The stated error is the larger of two. The first is the confidence interval of the fit, from the
 * scatter of the points or, if that is larger, from round-off. The second is the difference from
 * another fit: to the points down to half of the peak or, if the table has no more points, to all
 * but the outer points. If other modes or a nonlinear response make 1/a^2 deviate smoothly from a
 * parabola, only the second shows it.
 *
 * Two modes within each other's width look like a single one with more damping: with x = (z - zp)/D
 * their sum is (1 + e/(x + i)^2)/(x + i) to second order in their distance, and
 *
 *      1/a^2 = x^2 + 1 - 2 e (x^2 - 1)/(x^2 + 1)
 *
 * whose half-power points are at x^2 = 1 + 4 e, while 1/12 of that is left where a parabola is
 * fitted. The points down to half of the peak are therefore fitted twice more, with x^3, and with
 * this term or with x^4. Modes farther away contribute the powers. If the fit with this term is the
 * better one, and its ratio differs from the first by more than its own confidence interval, it is
 * taken: its parabola has the mean damping of both modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include <hawser/decay.h>

#include "core/report.h"

/* P: unknowns of the parabola. FEWEST: points of a fit, so that two degrees of freedom remain for
 * the estimate of the scatter. */
enum { P = 3, FEWEST = 5, ITERATIONS = 20 };
/* SHAPES: unknowns with those of two modes, LEAST_OF_TWO: points; CLOSE_FITS: until zp and D settle. */
enum { SHAPES = 5, LEAST_OF_TWO = SHAPES + FEWEST - P, CLOSE_FITS = 6 };

static const char where[] = "half-power";

/* Largest error relative to the ratio: with a larger one no digit of the ratio is known; chosen. */
static const double too_far = 0.1;

struct table {
	const double *omega, *a; /* [count] */
	int count, best;         /* best: index of the largest amplitude */
	double confidence;
};

struct span {
	int first, last;
};

struct fit {
	double zp, D, ratio;
	double zp_error, ratio_error;
	double scatter; /* standard deviation of a point, relative to the largest amplitude */
};

static double square(double x)
{
	return x*x;
}

/* --- one fit --- */

/* Adds a row, its right side last, to R [count][count + 1] by Givens rotations. */
static void join(double R[SHAPES][SHAPES + 1], double row[SHAPES + 1], int count)
{
	for (int j = 0; j < count; j++) {
		double r = hypot(R[j][j], row[j]), c = r > 0.0 ? R[j][j]/r : 1.0;
		double s = r > 0.0 ? row[j]/r : 0.0;

		for (int k = j; k <= count; k++) {
			double upper = c*R[j][k] + s*row[k];

			row[k] = c*row[k] - s*R[j][k];
			R[j][k] = upper;
		}
	}
}

/* |R^-T g|: the standard deviation of a quantity with the gradient g if that of the points is 1. */
static double spread(const double R[SHAPES][SHAPES + 1], const double g[P], int count)
{
	double v[SHAPES], sum = 0.0;

	for (int j = 0; j < count; j++) {
		v[j] = j < P ? g[j] : 0.0;
		for (int i = 0; i < j; i++)
			v[j] -= R[i][j]*v[i];
		v[j] /= R[j][j];
		sum += v[j]*v[j];
	}
	return sqrt(sum);
}

/* The result and its gradients with respect to p [P]; returns 0 if the parabola is not that of an
 * oscillator. */
static int of_parabola(struct fit *fit, double by_zp[P], double by_ratio[P], const double p[P],
                       double zc, double h)
{
	double b = p[1]/(2.0*p[2]), m = p[0] - b*p[1]/2.0, D = h*sqrt(m/p[2]), zp = zc - h*b, t, slope;

	if (!(p[2] > 0.0) || !(m > 0.0) || !(zp > 0.0) || !isfinite(D))
		return 0;
	t = D/zp;
	*fit = (struct fit){.zp = zp, .D = D, .ratio = sin(0.5*atan(t))};
	slope = 0.5*cos(0.5*atan(t))/(1.0 + t*t)*t;
	for (int i = 0; i < P; i++) {
		double by_m = (const double[P]){1.0, -b, b*b}[i];

		by_zp[i] = (const double[P]){0.0, -h/(2.0*p[2]), h*b/p[2]}[i];
		by_ratio[i] = slope*(0.5*by_m/m - (i == 2 ? 0.5/p[2] : 0.0) - by_zp[i]/zp);
	}
	return 1;
}

/* What adds to the parabola: nothing, modes farther away, or a close one. */
enum others { NONE, FAR, CLOSE };

static int shapes_of(enum others others)
{
	return others == NONE ? P : SHAPES;
}

/* The functions of x of which 1/a^2 is a sum. */
static void shapes_at(double f[SHAPES], double x, enum others others)
{
	f[0] = 1.0;
	f[1] = x;
	f[2] = x*x;
	f[3] = x*x*x;
	f[4] = others == FAR ? x*x*x*x : (x*x - 1.0)/(x*x + 1.0);
}

/* Standard deviation of a point, from the residuals r. With a correlation rho of neighbours, n
 * points count as n (1 - rho)/(1 + rho), but at least FEWEST: smooth residuals, which a curve that
 * is not a parabola causes, do not average out. */
static double scatter(const struct table *table, struct span span, const double *p,
                      enum others others, double zc, double h)
{
	double sum = 0.0, lag = 0.0, before = 0.0, rho, loss, f[SHAPES];
	int count = span.last - span.first + 1, shapes = shapes_of(others);

	for (int i = span.first; i <= span.last; i++) {
		double a = table->a[i]/table->a[table->best], r, y = 0.0;

		shapes_at(f, (square(table->omega[i]) - zc)/h, others);
		for (int j = 0; j < shapes; j++)
			y += p[j]*f[j];
		r = 0.5*a*(a*a*y - 1.0);
		sum += r*r;
		lag += r*before;
		before = r;
	}
	rho = sum > 0.0 ? fmax(lag/sum, 0.0) : 0.0;
	loss = fmin((1.0 + rho)/(1.0 - rho), (double)count/FEWEST);
	return sqrt(sum*loss/(count - shapes));
}

/* With the functions of x = (z - zc)/h. */
static int fit_shapes(struct fit *fit, const struct table *table, struct span span,
                      enum others others, double zc, double h)
{
	int shapes = shapes_of(others);
	double most = table->a[table->best], R[SHAPES][SHAPES + 1] = {{0.0}}, p[SHAPES];
	double f[SHAPES], by_zp[P], by_ratio[P], deviation;
	int free_points = span.last - span.first + 1 - shapes;

	for (int i = span.first; i <= span.last; i++) {
		double a = table->a[i]/most, w = 0.5*a*a*a, row[SHAPES + 1];

		shapes_at(f, (square(table->omega[i]) - zc)/h, others);
		for (int j = 0; j < shapes; j++)
			row[j] = w*f[j];
		row[shapes] = w/(a*a);
		join(R, row, shapes);
	}
	for (int j = shapes - 1; j >= 0; j--) {
		p[j] = R[j][shapes];
		for (int k = j + 1; k < shapes; k++)
			p[j] -= R[j][k]*p[k];
		p[j] /= R[j][j];
	}
	if (!of_parabola(fit, by_zp, by_ratio, p, zc, h))
		return 0;
	/* round-off of the amplitudes, and of x through omega */
	deviation = 8.0*DBL_EPSILON*(1.0 + zc/h);
	fit->scatter = free_points > 0 ? scatter(table, span, p, others, zc, h) : 0.0;
	if (free_points > 0)
		deviation = fmax(deviation, fit->scatter)*
		            gsl_cdf_tdist_Pinv(0.5 + 0.5*table->confidence, free_points);
	fit->zp_error = deviation*spread(R, by_zp, shapes);
	fit->ratio_error = deviation*spread(R, by_ratio, shapes);
	return isfinite(fit->ratio_error);
}

static int fit_span(struct fit *fit, const struct table *table, struct span span)
{
	double z0 = square(table->omega[span.first]), z1 = square(table->omega[span.last]);

	return fit_shapes(fit, table, span, NONE, 0.5*(z0 + z1), 0.5*(z1 - z0));
}

/* --- the points of a fit --- */

/* The points from the last one below zp - reach to the first one above zp + reach, if the table has
 * them. */
static struct span around(const struct table *table, double zp, double reach)
{
	struct span span = {0, table->count - 1};

	while (span.first < span.last && square(table->omega[span.first + 1]) <= zp - reach)
		span.first++;
	while (span.last > span.first && square(table->omega[span.last - 1]) >= zp + reach)
		span.last--;
	while (span.last - span.first + 1 < FEWEST) {
		int up = span.last + 1, down = span.first - 1;

		if (down < 0 || (up < table->count && table->a[up] > table->a[down]))
			span.last = up;
		else
			span.first = down;
	}
	return span;
}

/* The second fit: to the points down to half of the peak or, if there are no more, to all but the
 * outer ones. */
static struct span second(const struct table *table, struct span span, const struct fit *fit)
{
	struct span wider = around(table, fit->zp, sqrt(3.0)*fit->D);

	if (wider.first < span.first || wider.last > span.last)
		return wider;
	return (struct span){span.first + 1, span.last - 1};
}

/* The ratio becomes that of the fit with two modes where it certainly differs, with the difference
 * as its error: terms of third order in the modes' distance, which are left out, are up to as
 * large where one mode is weaker than the other. If the fit needs points beyond half of the peak,
 * or that with modes farther away is better, only the error is taken. Returns the number of modes.
 */
static int close_modes(struct fit *fit, const struct table *table)
{
	double reach = sqrt(3.0)*fit->D, off;
	struct span span = around(table, fit->zp, reach);
	struct fit two = *fit, far = *fit;
	int enough = span.last - span.first + 1 >= LEAST_OF_TWO;

	while (span.last - span.first + 1 < LEAST_OF_TWO && (reach *= 1.25) < 4.0*fit->zp)
		span = around(table, fit->zp, reach);
	if (span.last - span.first + 1 < LEAST_OF_TWO)
		return 1;
	for (int i = 0; i < CLOSE_FITS; i++)
		if (!fit_shapes(&two, table, span, CLOSE, two.zp, two.D)) {
			fit->ratio_error = INFINITY;
			return 1;
		}
	off = fabs(two.ratio - fit->ratio);
	if (!(off > two.ratio_error))
		return 1;
	enough &= !fit_shapes(&far, table, span, FAR, fit->zp, fit->D) || two.scatter < far.scatter;
	if (!enough || !(off < too_far*fit->ratio)) {
		fit->ratio_error = fmax(fit->ratio_error, off);
		return 1;
	}
	fit->ratio = two.ratio;
	fit->ratio_error = fmax(two.ratio_error, off);
	return 2;
}

/* Iterates until the fitted points are those that the half-power points of the parabola require. */
static int settle(struct fit *fit, struct span *span, const struct table *table)
{
	double level = table->a[table->best]*M_SQRT1_2;

	*span = (struct span){table->best, table->best};
	while (span->first > 0 && table->a[span->first] > level)
		span->first--;
	while (span->last < table->count - 1 && table->a[span->last] > level)
		span->last++;
	*span = around(table, 0.5*(square(table->omega[span->first]) + square(table->omega[span->last])),
	               0.5*(square(table->omega[span->last]) - square(table->omega[span->first])));
	for (int i = 0; i < ITERATIONS; i++) {
		struct span now;

		if (!fit_span(fit, table, *span))
			return 0;
		now = around(table, fit->zp, fit->D);
		if (memcmp(&now, span, sizeof now) == 0)
			return 1;
		*span = now;
	}
	return 1;
}

/* --- the table --- */

static enum hawser_status check(struct table *table, struct hawser_report *report)
{
	const double *omega = table->omega, *a = table->a;

	if (table->count < FEWEST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%d points: give at least %d",
		                    table->count, FEWEST);
	if (!(table->confidence > 0.0 && table->confidence < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a confidence of %g: give one between 0 and 1", table->confidence);
	for (int i = 0; i < table->count; i++) {
		if (i > 1 && omega[1] > omega[0] && omega[i] < omega[i - 1])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the frequencies turn back at point %d (%g after %g): half-power "
			                    "points are those of a linear resonance, whose response does not "
			                    "fold; give a response at a lower load", i + 1, omega[i],
			                    omega[i - 1]);
		if (!(a[i] > 0.0) || !(omega[i] > (i ? omega[i - 1] : 0.0)) || !isfinite(a[i] + omega[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "point %d (%g, %g): frequencies must ascend from above zero, and "
			                    "amplitudes be positive", i + 1, omega[i], a[i]);
		table->best = a[i] > a[table->best] ? i : table->best;
	}
	return HAWSER_OK;
}

static enum hawser_status narrow(struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the amplitude does not fall to 0.707 of the largest on both sides of it: "
	                    "widen the range");
}

enum hawser_status hawser_half_power_find(struct hawser_half_power *half, const double *omega,
                                          const double *a, int count, double confidence,
                                          struct hawser_report *report)
{
	struct table table = {omega, a, count, 0, confidence};
	enum hawser_status status = check(&table, report);
	struct fit fit = {.zp = 0.0}, other = {.zp = 0.0};
	struct span span = {0, 0};
	int modes;

	*half = (struct hawser_half_power){.ratio = 0.0};
	if (status)
		return status;
	if (table.best == 0 || table.best == count - 1)
		return narrow(report);
	if (!settle(&fit, &span, &table))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "near %g rad/s, where the amplitude is the largest, it is not that of "
		                    "a linear oscillator (1/a^2 is no parabola in omega^2 with a minimum): "
		                    "give a response at a lower load, in finer steps, of one mode",
		                    omega[table.best]);
	if (!(fit.zp - fit.D >= square(omega[0])) || !(fit.zp + fit.D <= square(omega[count - 1])))
		return narrow(report);
	if (!fit_span(&other, &table, second(&table, span, &fit)))
		other.ratio = other.zp = INFINITY;
	fit.ratio_error = fmax(fit.ratio_error, fabs(other.ratio - fit.ratio));
	modes = close_modes(&fit, &table);
	fit.zp_error = fmax(fit.zp_error, fabs(other.zp - fit.zp));
	if (!(fit.ratio_error <= too_far*fit.ratio))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the points near %g rad/s give the ratio %.3g, to no better than %.1g: "
		                    "they are not those of one linear oscillator (two close modes?), or too "
		                    "far apart for their noise; give a response at a lower load, in finer "
		                    "steps, of one mode",
		                    omega[table.best], fit.ratio, fit.ratio_error);
	*half = (struct hawser_half_power){sqrt(fit.zp), sqrt(fit.zp - fit.D), sqrt(fit.zp + fit.D),
		fit.ratio, fit.ratio_error, 0.5*fit.zp_error/sqrt(fit.zp), modes};
	return HAWSER_OK;
}

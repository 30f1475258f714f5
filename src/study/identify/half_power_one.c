/* study/identify/half_power_one.c - the amplitudes of one mode: 1/a^2 by a parabola, and by what
 * adds to it. The glossary is in half_power.c. SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include <gsl/gsl_cdf.h>

#include "study/identify/half_power.h"

#define LEAST_PART 0.1 /* smallest part of the weaker of two modes, relative to the other; chosen */

/* P: unknowns of the parabola. */
enum { P = HAWSER__HALF_PARABOLA, SHAPES = HAWSER__HALF_SHAPES, MOST = HAWSER__HALF_MOST };

/* The result and its gradients with respect to p [P]; returns 0 if the parabola is not that of an
 * oscillator. */
static int of_parabola(struct hawser__half_fit *fit, double by_zp[P], double by_ratio[P],
                       const double p[P], double zc, double h)
{
	double b = p[1]/(2.0*p[2]), m = p[0] - b*p[1]/2.0, D = h*sqrt(m/p[2]), zp = zc - h*b, t, slope;

	if (!(p[2] > 0.0) || !(m > 0.0) || !(zp > 0.0) || !isfinite(D))
		return 0;
	t = D/zp;
	*fit = (struct hawser__half_fit){.zp = zp, .D = D, .ratio = sin(0.5*atan(t))};
	slope = 0.5*cos(0.5*atan(t))/(1.0 + t*t)*t;
	for (int i = 0; i < P; i++) {
		double by_m = (const double[P]){1.0, -b, b*b}[i];

		by_zp[i] = (const double[P]){0.0, -h/(2.0*p[2]), h*b/p[2]}[i];
		by_ratio[i] = slope*(0.5*by_m/m - (i == 2 ? 0.5/p[2] : 0.0) - by_zp[i]/zp);
	}
	return 1;
}

static int shapes_of(enum hawser__half_others others)
{
	return others == HAWSER__HALF_NONE ? P : SHAPES;
}

/* The functions of x, and of a, of which 1/a^2 is a sum. */
static void shapes_at(double f[SHAPES], double x, double a)
{
	f[0] = 1.0;
	f[1] = x;
	f[2] = x*x;
	f[3] = x*x*x;
	f[4] = x*x*x*x;
	f[5] = a*a*x;
}

static double scatter(double *lag, const struct hawser__half_table *table,
                      struct hawser__half_span span, const double *p,
                      enum hawser__half_others others, double zc, double h)
{
	struct hawser__half_residuals residuals = {0.0, 0.0, 0.0};
	double f[SHAPES];
	int count = span.last - span.first + 1, shapes = shapes_of(others);

	for (int i = span.first; i <= span.last; i++) {
		double a = table->a[i]/table->a[table->best], y = 0.0;

		shapes_at(f, (table->omega[i]*table->omega[i] - zc)/h, a);
		for (int j = 0; j < shapes; j++)
			y += p[j]*f[j];
		hawser__half_add(&residuals, 0.5*a*(a*a*y - 1.0));
	}
	*lag = residuals.lag/fmax(residuals.sum, DBL_MIN);
	return hawser__half_deviation(&residuals, count, shapes);
}

int hawser__half_shapes(struct hawser__half_fit *fit, const struct hawser__half_table *table,
                        struct hawser__half_span span, enum hawser__half_others others, double zc,
                        double h)
{
	int shapes = shapes_of(others);
	double most = table->a[table->best], R[MOST][MOST + 1] = {{0.0}}, p[SHAPES];
	double f[SHAPES], by_zp[SHAPES] = {0.0}, by_ratio[SHAPES] = {0.0}, deviation;
	int free_points = span.last - span.first + 1 - shapes;

	for (int i = span.first; i <= span.last; i++) {
		double a = table->a[i]/most, w = 0.5*a*a*a, row[MOST + 1];

		shapes_at(f, (table->omega[i]*table->omega[i] - zc)/h, a);
		for (int j = 0; j < shapes; j++)
			row[j] = w*f[j];
		row[shapes] = w/(a*a);
		hawser__half_join(R, row, shapes);
	}
	hawser__half_solve(p, (const double (*)[MOST + 1])R, shapes);
	if (!of_parabola(fit, by_zp, by_ratio, p, zc, h))
		return 0;
	/* round-off of the amplitudes, and of x through omega */
	deviation = 8.0*DBL_EPSILON*(1.0 + zc/h);
	fit->scatter = free_points > 0 ? scatter(&fit->lag, table, span, p, others, zc, h) : 0.0;
	if (free_points > 0)
		deviation = fmax(deviation, fit->scatter)*
		            gsl_cdf_tdist_Pinv(0.5 + 0.5*table->confidence, free_points);
	fit->zp_error = deviation*hawser__half_spread((const double (*)[MOST + 1])R, by_zp, shapes);
	fit->ratio_error = deviation*hawser__half_spread((const double (*)[MOST + 1])R, by_ratio, shapes);
	return isfinite(fit->ratio_error);
}

/* Two modes with the parts g and 1 - g about the pole of one, apart by D w in frequency and by D xi in
 * ratio, are
 *
 *      H (1 + c (2 w0^2 H)^2 + ...),    c = g (1 - g) (D w/w0 + i D xi)^2
 *
 * to the second order, with H of the one: the first order is a shift of it. c follows from the
 * amplitudes beside gain, frequency and ratio. A ratio is then off by |D xi| (1 - g) at most, which for
 * parts of which the weaker one is LEAST_PART of the other is sqrt(|c|/LEAST_PART). */
double hawser__half_hidden(const struct hawser__half_fit *fit, const struct hawser__half_table *table,
                           struct hawser__half_span span)
{
	enum { COLUMNS = 5 };
	double R[MOST][MOST + 1] = {{0.0}}, p[SHAPES], most = table->a[table->best], spread = 0.0;
	double xi = fit->ratio, w0 = sqrt(fit->zp/(1.0 - 2.0*xi*xi)), deviation;
	int free_points = span.last - span.first + 1 - COLUMNS;

	if (free_points < 1)
		return NAN;
	for (int i = span.first; i <= span.last; i++) {
		double w = table->omega[i]/w0, a = table->a[i]/most, row[MOST + 1];
		double complex H = 2.0/(1.0 - w*w + 2.0*I*xi*w), square = H*H;

		/* the amplitude of the one mode, of the same size as that of the peak */
		row[0] = cabs(H)*xi*sqrt(1.0 - xi*xi);
		row[1] = -row[0]*creal(H*(1.0 + I*xi*w));
		row[2] = row[0]*cimag(H*w);
		row[3] = row[0]*creal(square);
		row[4] = -row[0]*cimag(square);
		row[5] = a;
		hawser__half_join(R, row, COLUMNS);
	}
	hawser__half_solve(p, (const double (*)[MOST + 1])R, COLUMNS);
	for (int k = 3; k < COLUMNS; k++) {
		const double unit[COLUMNS] = {[3] = k == 3, [4] = k == 4};

		spread = hypot(spread, hawser__half_spread((const double (*)[MOST + 1])R, unit, COLUMNS));
	}
	deviation = fit->scatter*gsl_cdf_tdist_Pinv(0.5 + 0.5*table->confidence, free_points);
	return sqrt((hypot(p[3], p[4])/fabs(p[0]) + deviation*spread)/LEAST_PART);
}

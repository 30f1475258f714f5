/* study/accuracy/stencil.c - the maximum of a function that is known at a few points.
 *
 *    t      variable, scaled such that points two apart have a distance of about 1
 *    y      the function with the maximum; z another function, evaluated there
 *
 * The maximum is that of the polynomial through five points. Its error is the larger difference
 * from the maxima of the two polynomials through four of them, plus the largest difference from
 * three others through five points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "study/accuracy/stencil.h"

enum { stencil = HAWSER__STENCIL };

/* Newton's form of the polynomial through (t, y) [n]: c becomes the divided differences. */
static void differences(double *c, const double *t, const double *y, int n)
{
	memcpy(c, y, (size_t)n*sizeof *c);
	for (int k = 1; k < n; k++)
		for (int i = n - 1; i >= k; i--)
			c[i] = (c[i] - c[i - 1])/(t[i] - t[i - k]);
}

static double value(const double *c, const double *t, int n, double x, double *slope)
{
	double p = c[n - 1], d = 0.0;

	for (int i = n - 2; i >= 0; i--) {
		d = d*(x - t[i]) + p;
		p = p*(x - t[i]) + c[i];
	}
	if (slope)
		*slope = d;
	return p;
}

/* The point in [low, high] at which the slope decreases through zero; NAN if its signs at the ends
 * do not bracket one. */
static double summit(const double *c, const double *t, int n, double low, double high)
{
	double slope;

	(void)value(c, t, n, low, &slope);
	if (slope < 0.0)
		return NAN;
	(void)value(c, t, n, high, &slope);
	if (slope > 0.0)
		return NAN;
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(low + high);

		(void)value(c, t, n, middle, &slope);
		if (slope > 0.0)
			low = middle;
		else
			high = middle;
	}
	return 0.5*(low + high);
}

/* The maximum of the polynomial through n points about t = 0, between low and high. */
static int fit(double *t_top, double *size, double *omega, const double *t, const double *a,
               const double *w, int n, const double bounds[2])
{
	double c[stencil];

	differences(c, t, a, n);
	*t_top = summit(c, t, n, bounds[0], bounds[1]);
	if (isnan(*t_top))
		return 1;
	*size = value(c, t, n, *t_top, NULL);
	differences(c, t, w, n);
	*omega = value(c, t, n, *t_top, NULL);
	return 0;
}

/* Largest relative change if `count` points from `first` on, `stride` apart, are used; 1: no
 * maximum. */
static int change(struct hawser__stencils *at, double worst[2], int first, int count, int stride)
{
	double t[stencil], y[stencil], z[stencil], top, y_top, z_top;

	if (first < 0 || first + stride*(count - 1) >= at->count)
		return 0;
	for (int k = 0; k < count; k++) {
		t[k] = at->t[first + stride*k];
		y[k] = at->y[first + stride*k];
		z[k] = at->z[first + stride*k];
	}
	if (fit(&top, &y_top, &z_top, t, y, z, count, at->bounds))
		return 1;
	worst[0] = fmax(worst[0], fabs(y_top/at->y_top - 1.0));
	worst[1] = fmax(worst[1], fabs(z_top/at->z_top - 1.0));
	return 0;
}

/* The maximum by five points, and its change if four of them are used, or a neighbour replaces the
 * one at the other end, or every other point is used: arclengths are sums of chords, so that steps
 * of different lengths cause kinks, which four of the five points need not show. 1: one of the
 * polynomials has no maximum. */
int hawser__stencil_top(struct hawser__stencils *at)
{
	int first = at->centre;
	double four[2] = {0.0, 0.0}, five[2] = {0.0, 0.0};

	if (fit(&at->top, &at->y_top, &at->z_top, at->t + first, at->y + first, at->z + first, stencil,
	        at->bounds) ||
	    change(at, four, first, stencil - 1, 1) || change(at, four, first + 1, stencil - 1, 1) ||
	    change(at, five, first - 1, stencil, 1) || change(at, five, first + 1, stencil, 1) ||
	    change(at, five, first - 2, stencil, 2))
		return 1;
	at->y_change = four[0] + five[0];
	at->z_change = four[1] + five[1];
	return 0;
}

/* Change of z at the maximum by an error of y: through the slope, for which a formula with five
 * equidistant points has weights that add up to 3 per unit of t. */
double hawser__stencil_moved(const struct hawser__stencils *at, double error)
{
	const double near = 0.01, *t = at->t + at->centre;
	double c[stencil], before, after, rate;

	differences(c, t, at->y + at->centre, stencil);
	(void)value(c, t, stencil, at->top - near, &before);
	(void)value(c, t, stencil, at->top + near, &after);
	differences(c, t, at->z + at->centre, stencil);
	(void)value(c, t, stencil, at->top, &rate);
	return fabs(rate)*fmin(3.0*error*2.0*near/fmax(before - after, 1e-300), 1.0);
}

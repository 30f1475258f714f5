/* water/wet.c - what of a line or of a sphere is in the water.
 *
 * f   wet part of a section, from 1 below the surface to 0 above, linear in the height over a band
 * s   along an element, 0 to 1; N = (1 - s, s)
 *
 * part[i] is the integral of f*N_i, so that buoyancy has an energy, which is convex in the heights:
 * its derivatives `by` are symmetric, and not positive. f is linear between its knots, and all
 * integrals are exact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "water/water.h"

static double within(double f)
{
	return fmin(fmax(f, 0.0), 1.0);
}

/* The part of an element between s = p and q. */
static void piece(struct hawser__wet *wet, double from, double to, double p, double q, double slope)
{
	double f = within(from + (to - from)*p), g = within(from + (to - from)*q), w = q - p;
	double all = 0.5*w*(f + g), far = w*(p*(2.0*f + g) + q*(f + 2.0*g))/6.0;
	double middle = within(from + (to - from)*0.5*(p + q));

	wet->part[0] += all - far;
	wet->part[1] += far;
	if (!(middle > 0.0 && middle < 1.0))
		return;
	wet->by[1][1] += slope*(q*q*q - p*p*p)/3.0;
	wet->by[0][1] += slope*(0.5*(q*q - p*p) - (q*q*q - p*p*p)/3.0);
	wet->by[0][0] += slope*(pow(1.0 - p, 3.0) - pow(1.0 - q, 3.0))/3.0;
}

void hawser__wet_line(struct hawser__wet *wet, double surface, double band, const double y[2])
{
	double from, to, knot[4] = {0.0, 0.0, 1.0, 1.0}, a, b;

	*wet = (struct hawser__wet){.part = {0.5, 0.5}};
	if (surface - y[0] >= 0.5*band && surface - y[1] >= 0.5*band)
		return;
	from = (surface - y[0])/band + 0.5;
	to = (surface - y[1])/band + 0.5;
	*wet = (struct hawser__wet){.part = {0.0}};
	if (from <= 0.0 && to <= 0.0)
		return;
	a = from != to ? within(from/(from - to)) : 0.0;
	b = from != to ? within((from - 1.0)/(from - to)) : 1.0;
	knot[1] = fmin(a, b);
	knot[2] = fmax(a, b);
	for (int i = 0; i < 3; i++)
		piece(wet, from, to, knot[i], knot[i + 1], -1.0/band);
	wet->by[1][0] = wet->by[0][1];
}

double hawser__wet_sphere(double *by, double surface, double volume, double y)
{
	double r = cbrt(0.75*volume/M_PI), h = fmin(fmax(surface - y + r, 0.0), 2.0*r);

	*by = -M_PI*h*(2.0*r - h);
	return h >= 2.0*r ? volume : M_PI*h*h*(3.0*r - h)/3.0;
}

/* statics/irvine.c - Irvine's parameter, in its classical definition and in that of B (4.60).
 *
 * Classical (H. M. Irvine, Cable Structures, 1981), with the chord c, its angle theta and its
 * tension Tc = H/cos(theta):
 *
 *   lambda^2 = (w*cos(theta)*c/Tc)^2 * c*EA/(Tc*Le),  Le = integral of (ds/dx)^3 dx on the chord.
 *
 * With phi the cable's angle, ds/dx = 1/cos(phi - theta), so Le is the integral of
 * dS/cos(phi - theta)^2; S is the unstretched arclength, by which EA and w are defined. In
 * v = u - slope, k = 1 + slope^2, tan(phi - theta) = v/(k + slope*v), so that
 *
 *   Le/d = l + (1/delta) * integral from u(0) - slope to u(l) - slope of (v/(k + slope*v))^2 dv,
 *
 * positive terms only, elementary in y = slope*v/k. Scaled, lambda = delta*(d/c)*sqrt(d/(eps*Le)).
 * If the cable has a tangent perpendicular to its chord, Le is infinite and lambda is 0.
 *
 * B (4.60) has lambda^2 = (delta/eps)*(sin(phi1) - sin(phi0)) instead, which is the printed (1.1)
 * with the integral of cos^3 in the numerator; both are delta^2/eps for a level taut cable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "statics/catenary.h"

/* Integral of (y/(1+y))^2 from 0 to y, divided by y^3: from y + y/(1+y) - 2 log(1+y), or for small
 * y, where this cancels, from its Taylor series. y > -1. */
static double cubic_mean(double y)
{
	double sum = 0.0;

	if (fabs(y) > 0.25)
		return (y + y/(1.0 + y) - 2.0*log1p(y))/(y*y*y);
	for (int n = 27; n >= 0; n--)
		sum = (n + 1.0)/(n + 3.0) - y*sum;
	return sum;
}

/* Integral of (v/(k + slope*v))^2 from 0 to v; NAN where it diverges. */
static double steepness(double v, double slope, double k)
{
	double y = slope*v/k;

	return y > -1.0 ? v*(v/k)*(v/k)*cubic_mean(y) : NAN;
}

double hawser__irvine(const struct hawser__catenary *cat, const struct hawser__chord *chord)
{
	double c = chord->cosc, k = c*c, s = chord->slope;
	double gap = hawser__catenary_gap(cat, chord), half, below, above, Le; /* Le: b*Le/d */

	half = 0.5*(cat->a + gap); /* slope - sinh(p) and sinh(q) - slope as products */
	below = 2.0*sinh(half)*cosh(asinh(s) - half);
	half = 0.5*(cat->a - gap);
	above = 2.0*sinh(half)*cosh(asinh(s) + half);
	Le = cat->coshm*cat->sinha + 0.5*(steepness(above, s, k) - steepness(-below, s, k));
	if (isnan(Le))
		return 0.0; /* a tangent is perpendicular to the chord: Le is infinite */
	return cat->eps > 0.0 ? 2.0*cat->b/c*sqrt(cat->b/(cat->eps*Le)) : INFINITY;
}

double hawser__irvine_source(const struct hawser__catenary *cat)
{
	double p = cat->m - cat->a, q = cat->m + cat->a;

	/* tanh(q) - tanh(p) = sinh(2a)/(cosh(p)*cosh(q)) */
	double sines = 2.0*(cat->sinha/cosh(p))*(cat->cosha/cosh(q));

	return cat->eps > 0.0 ? sqrt(2.0*cat->b/cat->eps*sines) : INFINITY;
}

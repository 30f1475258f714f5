/* statics/length.c - the equilibrium with a given unstretched length L.
 *
 * With B = w*L/(2*EA) = X the closures give tanh(m) and 1/cosh(m) explicitly, and their squares add
 * up to one:
 *
 *   f(a) = A^2 + slope^2*Q^2 = (L/d)^2,     A = sinh(a)/(a+B),  Q = tanh(a)/(tanh(a)+B).
 *
 * A and Q increase with a > 0, from 0 (B > 0) or 1 (B = 0), and A without bound: an elastic cable
 * has exactly one equilibrium for any L > 0, an inextensible one for L > chord and none otherwise.
 * With the squared chord subtracted from both sides, no term has cancellation:
 *
 *   R(a) = (A-1)*(A+1) - slope^2*B*(2*tanh(a)+B)/(tanh(a)+B)^2 - (L^2-d^2-h^2)/d^2,
 *
 * The last term is computed in twice the working precision, for lengths that exceed the chord by a
 * few units in the last place only. The equation is solved for ln a by Newton's method on ln f,
 * inside a bracket.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "statics/catenary.h"
#include "statics/search.h"

struct problem {
	double B;      /* w*L/(2*EA) */
	double slope2; /* slope^2 */
	double ratio2; /* (L/d)^2 */
	double beyond; /* (L^2 - d^2 - h^2)/d^2 */
};

static double two_sum(double a, double b, double *error)
{
	double s = a + b, part = s - a;

	*error = (a - (s - part)) + (b - part);
	return s;
}

/* (L^2 - d^2 - h^2)/d^2, with full relative accuracy in spite of cancellation. */
static double beyond_chord(double L, double d, double h)
{
	double LL, dd, hh, e1, e2, sum, low;
	int scale;

	frexp(fmax(L, fmax(d, h)), &scale);
	L = ldexp(L, -scale);
	d = ldexp(d, -scale);
	h = ldexp(h, -scale);
	LL = L*L;
	dd = d*d;
	hh = h*h;
	low = fma(L, L, -LL) - fma(d, d, -dd) - fma(h, h, -hh);
	sum = two_sum(LL, -fmax(dd, hh), &e1);
	sum = two_sum(sum, -fmin(dd, hh), &e2);
	return (sum + (e1 + e2 + low))/dd;
}

/* ln sqrt(f/ratio2) and its derivative by ln a. */
static double residual(struct hawser__catenary *cat, const struct problem *at, double a,
                       double *derivative)
{
	double B = at->B, T, A, Q, R, f;

	hawser__catenary_width(cat, a);
	T = cat->tanha;
	A = cat->sinha/(a + B);
	Q = T/(T + B);
	R = (cat->excess - B)/(a + B)*(A + 1.0)
	    - at->slope2*(B/(T + B))*((2.0*T + B)/(T + B)) - at->beyond;
	f = A*A + at->slope2*Q*Q;
	*derivative = (A*A*(cat->K + B/(a + B))
	               + at->slope2*Q*Q*(a/cat->sinha)*(B/(T + B))/cat->cosha)/f;
	if (a < 8.0*B || fabs(R) > 0.5*at->ratio2) /* far from the chord f is accurate */
		return 0.5*log(f/at->ratio2);
	return 0.5*log1p(R/at->ratio2);
}

/* Initial value: the root of a^3/(3k) - r*a = 2B, the limit of f for a taut cable, or of
 * sinh(a) = y*(a+B). */
static double guess(const struct problem *at)
{
	double k = 1.0 + at->slope2, r = at->beyond/k, B = at->B, a, y, cubic;

	if (at->beyond > k) {
		y = sqrt(fmax(1.0, at->ratio2 - at->slope2/((1.0 + B)*(1.0 + B))));
		a = asinh(y);
		for (int i = 0; i < 3; i++)
			a = asinh(y*(a + B));
		return a;
	}
	if (r < 0.0) { /* a/(a+B) = L/chord for a negligible sag */
		y = sqrt(1.0 + r);
		a = B*y*(1.0 + y)/-r;
		cubic = cbrt(6.0*k*B);
		return a*cubic/cbrt(a*a*a + cubic*cubic*cubic);
	}
	a = sqrt(3.0*k*r) + cbrt(6.0*k*B);
	for (int i = 0; i < 3; i++) { /* convex: Newton's method converges from above */
		y = a*a/k - r;
		a -= (a*(a*a/(3.0*k) - r) - 2.0*B)/y;
	}
	return a;
}

static enum hawser__found find_width(struct hawser__catenary *cat, const struct problem *at)
{
	struct hawser__search search = {.x = guess(at), .hi = INFINITY, .step = INFINITY};
	double F, derivative;

	if (!(search.x >= DBL_MIN && search.x < 700.0))
		search.x = 1.0;
	do {
		F = residual(cat, at, search.x, &derivative);
		cat->iterations++;
		if (fabs(F) <= DBL_EPSILON*derivative)
			return HAWSER__FOUND;
		if (!(fabs(F) <= DBL_MAX)) /* sinh(a) overflows */
			F = derivative = 1.0;
	} while (hawser__search_next(&search, F > 0.0, -F/derivative));
	return search.x >= DBL_MIN && search.x < 710.0 ? HAWSER__FOUND : HAWSER__RANGE;
}

enum hawser__found hawser__from_length(struct hawser__catenary *cat,
                                       const struct hawser__chord *chord, double length0)
{
	double ratio = length0/chord->d;
	struct problem at = {0.5*chord->w*(length0/chord->EA), chord->slope*chord->slope,
	                     ratio*ratio, beyond_chord(length0, chord->d, chord->h)};
	enum hawser__found outcome;

	cat->iterations = 0;
	if (at.B == 0.0 && at.beyond <= 0.0)
		return isinf(chord->EA) ? HAWSER__NOT_FOUND : HAWSER__RANGE;
	if (!(at.ratio2 <= DBL_MAX && at.slope2 <= DBL_MAX && at.ratio2 >= DBL_MIN))
		return HAWSER__RANGE;
	outcome = find_width(cat, &at);
	if (outcome != HAWSER__FOUND)
		return outcome;
	cat->X = at.B;
	cat->b = cat->a + at.B;
	cat->H = chord->force/cat->b;
	cat->eps = cat->H/chord->EA;
	hawser__catenary_lift(cat, chord);
	return HAWSER__FOUND;
}

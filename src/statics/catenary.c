/* statics/catenary.c - the equilibrium at a given horizontal tension, and its properties.
 *
 * Symbols as in catenary.h. The closure of the span in x and in y, written with products only, is
 *
 *   b = a + eps*cosh(m)*sinh(a)                                                    (x)
 *   slope*b = sinh(m)*sinh(a)*(1 + eps*cosh(m)*cosh(a))                            (y)
 *
 * With a = b/(1+t), X = b*t/(1+t) and D = sinh(a) + X*cosh(a), (y) is sinh(m) = slope*b/D, and (x)
 * becomes the scalar equation in ln t
 *
 *   G = ln t - ln(sinh(a)/a) - ln eps - ln cosh(m) = 0.
 *
 * G is monotone: D increases with a, and with s = sinh(m),
 *
 *   dG/dln t = 1 + K*X/b - [s*s/(1+s*s)]*X*X*a*sinh(a)/(b*D),   K = a*coth(a) - 1 >= 0,
 *
 * where D > X*cosh(a) bounds the last term by (X/b)*a*tanh(a), so that
 * dG/dln t > a/b + (X/b)*a*(coth(a) - tanh(a)) > 0. Its root is bracketed by eps <= X/sinh(a) <=
 * eps*cosh(c), since 0 <= m <= c. Newton's method in ln t inside the bracket always converges. t
 * has full relative accuracy for all cables from nearly inextensible (t -> 0) to nearly weightless
 * and elastic (t -> infinity). Solving the two closures for (eta, l) as in B (2.87) fails at both
 * limits by cancellation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "statics/catenary.h"
#include "statics/search.h"

/* sinh(a) - a. For a < 2 by its Taylor series, since the subtraction would cancel. */
static double sinh_excess(double a, double sinha)
{
	double x = a*a, sum = 1.0;

	if (a >= 2.0)
		return sinha - a;
	for (int k = a < 0.5 ? 14 : 22; k >= 4; k -= 2)
		sum = 1.0 + sum*x/(k*(k + 1));
	return sum*x*a/6.0;
}

void hawser__catenary_width(struct hawser__catenary *cat, double a)
{
	double e = expm1(a), rise; /* rise: cosh(a) - 1 */

	cat->a = a;
	rise = 0.5*e*(e/(1.0 + e));
	cat->sinha = 0.5*(e + e/(1.0 + e));
	cat->cosha = 1.0 + rise;
	cat->tanha = cat->sinha/cat->cosha;
	cat->excess = sinh_excess(a, cat->sinha);
	cat->K = (a*rise - cat->excess)/cat->sinha;
}

/* da and dm by implicit differentiation of (x) and (y); every term is positive. */
static void differentiate(struct hawser__catenary *cat)
{
	double X = cat->X, Y = X/cat->tanha, tau = cat->sinhm/cat->coshm;
	double det = (1.0 + Y - tau*X)*(1.0 + Y + tau*X);

	cat->da = -((X + cat->b)*(1.0 + Y) + tau*tau*X*cat->K)/det;
	cat->dm = tau*((1.0 + Y)*cat->K + X*(X + cat->b))/det;
}

void hawser__catenary_lift(struct hawser__catenary *cat, const struct hawser__chord *chord)
{
	cat->D = cat->sinha + cat->X*cat->cosha;
	cat->sinhm = chord->slope*(cat->b/cat->D);
	cat->coshm = sqrt(1.0 + cat->sinhm*cat->sinhm);
	cat->m = asinh(cat->sinhm);
	differentiate(cat);
}

/* G and its derivative at t; sets the members up to coshm. */
static double residual(struct hawser__catenary *cat, const struct hawser__chord *chord, double t,
                       double *derivative)
{
	double s, b = cat->b, share;

	hawser__catenary_width(cat, b/(1.0 + t));
	cat->X = b*(t/(1.0 + t));
	cat->D = cat->sinha + cat->X*cat->cosha;
	s = cat->sinhm = chord->slope*(b/cat->D);
	cat->coshm = sqrt(1.0 + s*s);
	share = cat->X/b;
	*derivative = 1.0 + cat->K*share
	              - (s/cat->coshm)*(s/cat->coshm)*share*cat->X*cat->a*(cat->sinha/cat->D);
	return log(cat->X/(cat->sinha*cat->eps*cat->coshm));
}

static void solve_stretch(struct hawser__catenary *cat, const struct hawser__chord *chord, double t)
{
	double widest = fmin(cat->b, asinh(cat->b/cat->eps)), G, derivative, newton;
	double more = widest > 1e-4 ? sinh(widest)/widest : 1.0 + 1e-8;
	double round_off = 4.0*DBL_EPSILON*(2.0 + widest);
	struct hawser__search search = {
		.lo = fmax(cat->eps, cat->b/widest - 1.0)*(1.0 - round_off),
		.hi = cat->eps*chord->cosc*more*(1.0 + round_off),
		.step = INFINITY,
	};

	if (!(t > search.lo && t < search.hi))
		t = widest < 1.0 ? search.hi : sqrt(search.lo)*sqrt(search.hi);
	search.x = t;
	for (;;) {
		G = residual(cat, chord, search.x, &derivative);
		cat->iterations++;
		newton = -G/derivative;
		if (fabs(G) <= 2.0*DBL_EPSILON || !hawser__search_next(&search, G > 0.0, newton))
			return;
		if (fabs(newton) < 1e-9 && search.step == fabs(newton))
			break;
	}
	residual(cat, chord, search.x, &derivative); /* quadratic convergence: the rest is round-off */
}

void hawser__catenary_at(struct hawser__catenary *cat, const struct hawser__chord *chord, double H,
                         double stretch)
{
	cat->H = H;
	cat->b = chord->force/H;
	cat->eps = H/chord->EA;
	if (cat->eps < DBL_MIN) { /* the stretch is below round-off */
		hawser__catenary_width(cat, cat->b);
		cat->X = 0.0;
	} else {
		solve_stretch(cat, chord, stretch);
	}
	hawser__catenary_lift(cat, chord);
	if (!(cat->b > 0.0 && cat->sinha > 0.0 && cat->D <= DBL_MAX))
		cat->a = NAN;
}

double hawser__angle_between(double u, double v, double step)
{
	double tangent = step/(hypot(1.0, u) + hypot(1.0, v)); /* tanh of half of it */

	return tangent < 0.9 ? 2.0*atanh(tangent) : asinh(v) - asinh(u);
}

double hawser__catenary_gap(const struct hawser__catenary *cat, const struct hawser__chord *chord)
{
	/* slope - sinh(m) = slope*(D - b)/D, and D - b is a sum of positive terms */
	double rise = cat->sinha*(cat->sinha/(1.0 + cat->cosha)); /* cosh(a) - 1 */
	double more = chord->slope*((cat->excess + cat->X*rise)/cat->D);

	return hawser__angle_between(cat->sinhm, chord->slope, more);
}

double hawser__catenary_tension(const struct hawser__catenary *cat, enum hawser__end end,
                                double *derivative)
{
	double X = cat->X, Y = X/cat->tanha, tau = cat->sinhm/cat->coshm;
	double angle = end == HAWSER__UPPER ? cat->m + cat->a : cat->m - cat->a;

	if (end == HAWSER__UPPER)
		*derivative = 1.0 - tanh(angle)*(X + cat->b - tau*cat->K)/(1.0 + Y + tau*X);
	else
		*derivative = 1.0 + tanh(angle)*(X + cat->b + tau*cat->K)/(1.0 + Y - tau*X);
	return cat->H*cosh(angle);
}

double hawser__catenary_sag(const struct hawser__catenary *cat, const struct hawser__chord *chord,
                            double *derivative)
{
	/* computed from the upper end, where both terms of the geometric part are positive */
	double angle = cat->a - hawser__catenary_gap(cat, chord);
	double e = expm1(angle), rise = 0.5*e*(e/(1.0 + e)), sinhb = 0.5*(e + e/(1.0 + e));
	double reach = chord->slope*rise + chord->cosc*sinhb; /* sinh(q) - slope */
	double upper = chord->cosc*(1.0 + rise) + chord->slope*sinhb; /* cosh(q) */
	double stretch = 0.5*cat->eps*reach*reach;
	double drop = chord->cosc*rise + chord->slope*sinh_excess(angle, sinhb) + stretch;

	*derivative = 1.0 + (reach*(1.0 + cat->eps*upper)*(cat->dm + cat->da) + stretch)/drop;
	return 0.5*chord->d*drop/cat->b;
}

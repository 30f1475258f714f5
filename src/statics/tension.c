/* statics/tension.c - the equilibria with a given tension at one end.
 *
 * The angle p of the lower end increases and q of the upper end decreases monotonically with H:
 *
 *   dp/dln H =  (b + X + tau*K)/(1 + Y - tau*X) > 0,      Y = X*coth(a), tau = tanh(m),
 *   dq/dln H = -(b + X - tau*K)/(1 + Y + tau*X) < 0,      since K < a <= b and X <= Y,
 *
 * and T = H*cosh(angle) gives dln T/dln H = 1 + tanh(p)*dp/dln H, or 1 + tanh(q)*dq/dln H. The
 * derivative is negative for H -> 0, tends to 1 for H -> infinity and changes its sign once: T(H)
 * has one minimum (doc/theory-statics.md: proved for inextensible cables, tested on random samples
 * for elastic ones; tests/property/test-statics-random.c tests it too). At any H, the signs of T(H)
 * - T and of the slope, together with the branch, determine on which side of H the required root
 * lies or, if there is no root, the minimum. The bracket needs no other information, and the
 * minimum is computed only if the search ends there. H <= T is an upper bound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "statics/catenary.h"
#include "statics/search.h"

/* Initial value from the parabola: T^2 = H^2 + (H*slope -+ W/2)^2 with the weight W of the
 * chord. */
static double guess_taut(const struct hawser__chord *chord, enum hawser__end end, double T)
{
	double half = chord->force*chord->cosc/(1.0 + T/chord->EA);
	double side = (end == HAWSER__UPPER ? half : -half)*chord->slope;
	double c = chord->cosc, root;

	/* (c H)^2 + 2 side H + half^2 - T^2 = 0, the larger root */
	root = side*side - c*c*(half - T)*(half + T);
	if (root < 0.0)
		return fmin(0.5*T, half);
	root = sqrt(root);
	return side > 0.0 ? (T - half)*(T + half)/(side + root) : (root - side)/(c*c);
}

/* Initial value for a cable that hangs almost vertically: T = H*exp(a)/2 at both ends. */
static double guess_slack(const struct hawser__chord *chord, double T)
{
	double pull = 2.0*T/chord->force, a = log(pull + 2.0);

	for (int i = 0; i < 3; i++)
		a = log(pull*a + 2.0);
	return chord->force/(a + T/chord->EA);
}

/* X/a at another H by first-order extrapolation from the last equilibrium. */
static double extrapolate(const struct hawser__catenary *cat, double step)
{
	double tau = cat->sinhm/cat->coshm;

	return cat->X/cat->a*exp(step*(1.0 + tau*cat->dm + cat->K/cat->a*cat->da));
}

/* Does the root lie at a smaller H than a point with ln T(H)/T = F and slope F'? */
static int too_large(double F, double slope, enum hawser_branch branch)
{
	return branch == HAWSER_BRANCH_TAUT ? F > 0.0 && slope > 0.0 : F <= 0.0 || slope > 0.0;
}

/* Move *cat to the minimum of T(H), the only change of sign of the slope. */
static enum hawser__found least_tension(struct hawser__catenary *cat,
                                        const struct hawser__chord *chord,
                                        enum hawser__end end)
{
	struct hawser__search search = {.x = cat->H, .hi = INFINITY, .step = INFINITY};
	double slope;

	do {
		hawser__catenary_at(cat, chord, search.x, 0.0);
		hawser__catenary_tension(cat, end, &slope);
	} while (hawser__search_next(&search, slope > 0.0, 0.0));
	return isnan(cat->a) ? HAWSER__RANGE : HAWSER__NOT_FOUND;
}

double hawser__least_tension(struct hawser__catenary *cat, const struct hawser__chord *chord,
                             enum hawser__end end)
{
	double unused;

	cat->iterations = 0;
	cat->H = 0.5*chord->force;
	if (least_tension(cat, chord, end) != HAWSER__NOT_FOUND)
		return 0.0;
	return hawser__catenary_tension(cat, end, &unused);
}

enum hawser__found hawser__from_tension(struct hawser__catenary *cat,
                                        const struct hawser__chord *chord,
                                        enum hawser__end end, double T,
                                        enum hawser_branch branch)
{
	int taut = branch == HAWSER_BRANCH_TAUT, below;
	double stretch = 0.0, F, slope = 0.0, tolerance = 0.0, newton;
	struct hawser__search search = {
		.x = taut ? guess_taut(chord, end, T) : guess_slack(chord, T),
		.hi = T*(1.0 + 4.0*DBL_EPSILON),
		.step = INFINITY,
	};

	cat->iterations = 0;
	if (!(search.x > 0.0 && search.x < search.hi))
		search.x = 0.5*search.hi;
	do {
		hawser__catenary_at(cat, chord, search.x, stretch);
		F = isnan(cat->a) ? INFINITY : log(hawser__catenary_tension(cat, end, &slope)/T);
		tolerance = DBL_EPSILON*(2.0 + fmin(fabs(slope), 1e3) + cat->m + cat->a);
		if (fabs(F) <= tolerance)
			return HAWSER__FOUND;
		if (F <= DBL_MAX) {
			below = too_large(F, slope, branch);
			newton = (taut ? slope > 0.0 : slope < 0.0) ? -F/slope : 0.0;
		} else { /* out of range: T is unbounded only for H -> 0 */
			below = 0;
			newton = 0.0;
		}
		stretch = fabs(newton) < 1.0 && newton != 0.0 ? extrapolate(cat, newton) : 0.0;
	} while (hawser__search_next(&search, below, newton));
	if (fabs(F) <= fmin(32.0*tolerance, 1e-12))
		return HAWSER__FOUND;
	if (!(F > 32.0*tolerance && F <= DBL_MAX && search.x >= DBL_MIN))
		return HAWSER__RANGE;
	return least_tension(cat, chord, end);
}

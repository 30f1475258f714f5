/* statics/sag.c - the equilibrium with a given sag, the largest vertical distance from the chord.
 *
 * The sag occurs where the tangent is parallel to the chord. From there |du/dx| =
 * w*sqrt(1+u^2)/(H + H^2/EA*sqrt(1+u^2)) on both sides, which decreases with H at every u. For a
 * smaller H both halves deviate more from the chord at any distance; since the two distances add up
 * to d for every H, the sag increases. sag(H) is therefore strictly decreasing, from infinity for H
 * -> 0 to 0 for H -> infinity. There is one equilibrium for any sag, found by Newton's method in ln
 * H in a bracket.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "statics/catenary.h"
#include "statics/search.h"

/* Initial H from the parabola (small sag) or from the half width of a level catenary (large
 * sag). */
static double guess(const struct hawser__chord *chord, double sag)
{
	double ratio = 2.0*sag/chord->d, a, H;

	if (ratio < 1.0) { /* H*(1 + H*cosc/EA) = cosc*w*d^2/(8 sag) */
		H = chord->force*chord->cosc*chord->d/(4.0*sag);
		return 2.0*H/(1.0 + sqrt(1.0 + 4.0*H*chord->cosc/chord->EA));
	}
	a = log(2.0*ratio + 2.0);
	for (int i = 0; i < 3; i++)
		a = log(2.0*ratio*a + 2.0);
	return 2.0*chord->force/(a + sqrt(a*a + 4.0*chord->force*ratio/chord->EA));
}

enum hawser__found hawser__from_sag(struct hawser__catenary *cat,
                                    const struct hawser__chord *chord, double sag)
{
	struct hawser__search search = {.x = guess(chord, sag), .hi = INFINITY, .step = INFINITY};
	double stretch = 0.0, F, slope = 1.0, tolerance = 0.0, newton;

	cat->iterations = 0;
	if (!(search.x >= DBL_MIN && search.x <= DBL_MAX))
		return HAWSER__RANGE;
	do {
		hawser__catenary_at(cat, chord, search.x, stretch);
		F = isnan(cat->a) ? INFINITY : log(hawser__catenary_sag(cat, chord, &slope)/sag);
		tolerance = DBL_EPSILON*(2.0 + fmin(fabs(slope), 1e3));
		if (fabs(F) <= tolerance)
			return HAWSER__FOUND;
		newton = fabs(F) <= DBL_MAX ? -F/slope : 0.0; /* overflows only as H -> 0 */
		stretch = newton != 0.0 ? cat->X/cat->a*exp(fmax(-4.0, fmin(4.0, newton))) : 0.0;
	} while (hawser__search_next(&search, F < 0.0, newton));
	return fabs(F) <= fmin(32.0*tolerance, 1e-12) ? HAWSER__FOUND : HAWSER__RANGE;
}

/* statics/precision.c - estimate of the round-off error of a static solution.
 *
 *   k   |d ln value/d ln H| of the given quantity: a relative error e of the given or of the
 *       computed value changes ln H by e/k
 *
 * At a known H every other quantity is computed from positive terms, to a few units of round-off;
 * the error of H adds to it with the logarithmic derivative of the quantity. k is small in two
 * cases. The length of a taut cable hardly depends on its tension (k = H/EA for a weightless cable:
 * with 1e-12, H has four correct digits). Near the least tension k passes zero, and the error of ln
 * H is the square root of the round-off over half the second derivative, which is about one.
 *
 * d ln length0/d ln H is differentiated from length0 = d cosh(m) sinh(a)/b with da and dm of
 * catenary.c; with Y = X coth(a) and t = tanh(m)
 *
 *   k = [(1 - t^2) K + X a (coth^2 a - t^2) + X^2 (coth^2 a - t^2)]/[(1 + Y)^2 - t^2 X^2]
 *
 * without cancellation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>

#include "statics/catenary.h"
#include "statics/precision.h"

/* Errors in units of round-off: of a quantity at known H, and of the given quantity in a search.
 * Measured (bench/estimates statics), with a safety factor of two. */
static const double forward = 8.0, search = 6.0;

static double of_length(const struct hawser__catenary *cat)
{
	double X = cat->X, Y = X/cat->tanha, t = cat->sinhm/cat->coshm, t2 = t*t;
	double steep = 1.0/(cat->coshm*cat->coshm); /* 1 - t^2 */
	double more = steep + 1.0/(cat->sinha*cat->sinha); /* coth^2 a - t^2 */

	return (steep*cat->K + X*(cat->a + X)*more)/((1.0 + Y)*(1.0 + Y) - t2*X*X);
}

double hawser__statics_precision(const struct hawser__catenary *cat,
                                 const struct hawser__chord *chord, enum hawser_given given,
                                 enum hawser__end end)
{
	double lower, upper, sag, length = of_length(cat), k = INFINITY, most;

	(void)hawser__catenary_tension(cat, HAWSER__LOWER, &lower);
	(void)hawser__catenary_tension(cat, HAWSER__UPPER, &upper);
	(void)hawser__catenary_sag(cat, chord, &sag);
	if (given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1)
		k = fmax(fabs(end == HAWSER__UPPER ? upper : lower), sqrt(search*DBL_EPSILON));
	else if (given == HAWSER_GIVEN_LENGTH0)
		k = length;
	else if (given == HAWSER_GIVEN_SAG)
		k = fabs(sag);
	most = fmax(fmax(1.0, length), fmax(fmax(fabs(lower), fabs(upper)), fabs(sag)));
	return DBL_EPSILON*(forward*(1.0 + cat->m + cat->a) +
	                    search*(1.0 + cat->m + cat->a)*most/k);
}

/* statics/limit.c - the speed at which the steady state of a travelling cable ends.
 *
 * If T0 (or T1) is held, the apparent tension (1 - m) T0 - rho v^2 decreases with the speed. The
 * steady state ends at a fold, where the taut and the slack solution meet: there the apparent
 * tension is the least one with which the apparent cable, of mass (1 - m) rho, can hang. In p = rho
 * v^2, with m = p/EA,
 *
 *   F(p) = (1 - p/EA) T0 - p - T_least((1 - p/EA) rho) = 0.
 *
 * The search starts at the root that F would have if the least tension were proportional to the
 * mass, with the slope that F would then have, -1 - (T0 - T_least)/EA. It continues with secant
 * steps, since for strains near 1 F' differs so much from -1 that the fixed-point iteration p +
 * F(p) diverges.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "core/report.h"
#include "statics/catenary.h"
#include "statics/search.h"

/* F(p), or NAN if an intermediate value exceeds the range of double. */
static double excess(const struct hawser_span *span, enum hawser__end end, double T, double p)
{
	struct hawser__catenary least;
	struct hawser__chord chord;
	struct hawser_span apparent = *span;
	double part = 1.0 - p/span->EA, A;

	apparent.rho = part*span->rho;
	if (!(apparent.rho > 0.0))
		return -p;
	hawser__chord_of(&chord, &apparent);
	A = hawser__least_tension(&least, &chord, end);
	return A > 0.0 ? part*T - p - A : NAN;
}

static double largest_thrust(const struct hawser_span *span, enum hawser__end end, double T)
{
	double F = excess(span, end, T, 0.0), p = 0.0, from, last, slope;
	struct hawser__search search = {.x = F/(1.0 + F/span->EA), .hi = INFINITY, .step = INFINITY};

	if (!(F > 0.0))
		return F;
	slope = -1.0 - F/span->EA;
	do {
		from = p;
		last = F;
		p = search.x;
		F = excess(span, end, T, p);
		if (!(fabs(F) > 2.0*DBL_EPSILON*T))
			break;
		if (from > 0.0 && (F - last)/(p - from) < 0.0)
			slope = (F - last)/(p - from);
	} while (hawser__search_next(&search, F < 0.0, log1p(fmax(-F/slope/p, -0.9))));
	return isnan(F) ? F : search.x;
}

enum hawser_status hawser_statics_limit(double *limit, const struct hawser_span *span,
                                        enum hawser_given given, double value,
                                        enum hawser_branch branch, enum hawser_hold hold,
                                        struct hawser_report *report)
{
	struct hawser_statics rest;
	enum hawser_status status = hawser_statics_solve(&rest, span, given, value, branch, report);
	double thrust;

	if (status)
		return status;
	if (hold == HAWSER_HOLD_LENGTH || given == HAWSER_GIVEN_H) {
		*limit = sqrt(span->EA/span->rho);
		return HAWSER_OK;
	}
	thrust = largest_thrust(span, hawser__end_of(span, given),
	                        given == HAWSER_GIVEN_T1 ? rest.T1 : rest.T0);
	if (isnan(thrust))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics",
		                    "the least tension of this span exceeds the range of "
		                    "double-precision numbers");
	*limit = sqrt(fmax(thrust, 0.0)/span->rho);
	return HAWSER_OK;
}

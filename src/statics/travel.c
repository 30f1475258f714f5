/* statics/travel.c - the steady state of a cable that travels along itself.
 *
 * The cable moves along the unstretched length S at v, so that the acceleration of a particle is
 * v^2 x''. With the tension T = EA (|x'| - 1) and A = T - rho v^2 |x'|, the balance (T e)' - rho
 * v^2 x'' = rho g y is (A e)' = rho g y. This is the equation of a cable at rest with the tension
 * A:
 *
 *   m = rho v^2/EA,  S~ = S/(1 - m),  rho~ = (1 - m) rho:   (A e)' = rho~ g y,  dx/dS~ = (1 + A/EA) e.
 *
 * The steady state is therefore computed by the solver for cables at rest, with changed mass,
 * length and tension. The same equivalence holds for the energy of large motions
 * (doc/theory-travel.md), so that the later stages use the apparent cable. For a speed v + V
 * sin(Omega t) the mean of the squared speed takes the place of v^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "core/report.h"
#include "statics/catenary.h"
#include "statics/search.h"
#include "statics/travel.h"

static const char where[] = "statics";

/* The apparent cable of a travelling span. */
struct travel {
	struct hawser_span rest, apparent;
	double thrust; /* rho v^2, N */
	double m;
};

static enum hawser_status check(const struct hawser_motion *motion, struct hawser_report *report)
{
	if (!isfinite(motion->speed) || !(motion->fluctuation >= 0.0 && isfinite(motion->fluctuation)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the travel speed is %g m/s with a fluctuation of %g m/s: both have to "
		                    "be finite, the second not negative", motion->speed,
		                    motion->fluctuation);
	if (motion->hold != HAWSER_HOLD_TENSION && motion->hold != HAWSER_HOLD_LENGTH)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d does not name what a travelling cable holds: choose tension or length",
		                    (int)motion->hold);
	return HAWSER_OK;
}

static enum hawser_status too_fast(const struct hawser_span *span, enum hawser_given given,
                                   double value, enum hawser_branch branch,
                                   const struct hawser_motion *motion,
                                   struct hawser_report *report)
{
	double limit;
	enum hawser_status status = hawser_statics_limit(&limit, span, given, value, branch,
	                                                 motion->hold, report);

	if (status)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "at %.10g m/s%s the cable has no steady state: with its %s held it has one "
	                    "up to %.10g m/s; travel slower, or raise the tension", motion->speed,
	                    motion->fluctuation > 0.0 ? " and its fluctuation" : "",
	                    motion->hold == HAWSER_HOLD_LENGTH ? "length" : "tension", limit);
}

/* H held: H~ + rho v^2/sqrt(1 + eta^2) = (1 - m) H, where eta is the slope of the apparent cable at
 * S = 0. The left side tends to 0 with H~, so that there is a root at every speed. The equation is
 * solved by secant steps in ln H~, since the second term may change more than the first. */
static enum hawser_status from_horizontal(struct hawser_statics *st, const struct travel *travel,
                                          double H, struct hawser_report *report)
{
	double target = (1.0 - travel->m)*H, excess = NAN, last = NAN, from = NAN;
	struct hawser__search search = {.x = target, .hi = INFINITY, .step = INFINITY};
	enum hawser_status status;

	for (;;) {
		double step;

		status = hawser_statics_solve(st, &travel->apparent, HAWSER_GIVEN_H, search.x,
		                              HAWSER_BRANCH_TAUT, report);
		if (status)
			return status;
		last = excess;
		excess = st->H + travel->thrust/hypot(1.0, st->eta) - target;
		if (fabs(excess) <= 2.0*DBL_EPSILON*target)
			return HAWSER_OK;
		step = isnan(last) ? log1p(fmax(-excess/st->H, -0.9))
		                   : -excess*log(search.x/from)/(excess - last);
		from = search.x;
		if (hawser__search_next(&search, excess > 0.0, isfinite(step) ? step : 0.0))
			continue;
		/* without a useful secant step the search bisects */
		if (fabs(excess) <= 8.0*DBL_EPSILON*(target + travel->thrust) ||
		    !hawser__search_next(&search, excess > 0.0, 0.0))
			return HAWSER_OK;
	}
}

/* The apparent tension that belongs to an actual tension at an end. */
static double apparent_tension(const struct travel *travel, double T)
{
	return (1.0 - travel->m)*T - travel->thrust;
}

enum hawser_status hawser__branch_of(enum hawser_branch *branch, const struct hawser_statics *rest,
                                     enum hawser_given given, struct hawser_report *report)
{
	struct hawser__catenary least;
	struct hawser__chord chord;

	hawser__chord_of(&chord, &rest->span);
	if (!(hawser__least_tension(&least, &chord, hawser__end_of(&rest->span, given)) > 0.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the least tension of this span exceeds the range of "
		                    "double-precision numbers");
	*branch = rest->H < least.H ? HAWSER_BRANCH_SLACK : HAWSER_BRANCH_TAUT;
	return HAWSER_OK;
}

static enum hawser_status steady(struct hawser_statics *st, const struct travel *travel,
                                 const struct hawser_statics *rest, enum hawser_given given,
                                 double value, enum hawser_branch branch, enum hawser_hold hold,
                                 struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	double A;

	if (hold == HAWSER_HOLD_LENGTH)
		return hawser_statics_solve(st, &travel->apparent, HAWSER_GIVEN_LENGTH0,
		                            rest->length0/(1.0 - travel->m), HAWSER_BRANCH_TAUT, report);
	if (given == HAWSER_GIVEN_H)
		return from_horizontal(st, travel, value, report);
	if (given != HAWSER_GIVEN_T0 && given != HAWSER_GIVEN_T1) {
		given = HAWSER_GIVEN_T0;
		value = rest->T0;
		status = hawser__branch_of(&branch, rest, given, report);
	}
	A = apparent_tension(travel, value);
	if (!status && !(A > 0.0))
		status = HAWSER_ERR_NO_SOLUTION;
	return status ? status
	              : hawser_statics_solve(st, &travel->apparent, given, A, branch, report);
}

static void fill(struct hawser_statics *st, const struct travel *travel,
                 const struct hawser_motion *motion)
{
	double unit = sqrt(travel->rest.rho/((1.0 - travel->m)*st->H));

	/* the apparent tension is a difference: its relative error is larger by this factor */
	st->error *= 1.0 + (st->T0 + 2.0*travel->thrust)/st->T0;
	st->motion = *motion;
	st->motion.mach2 = travel->m;
	st->motion.nu = motion->speed*unit;
	st->motion.swing = motion->fluctuation*unit;
	st->motion.tension = (st->T0 + travel->thrust)/(1.0 - travel->m);
	st->motion.tension1 = (st->T1 + travel->thrust)/(1.0 - travel->m);
}

static void travel_of(struct travel *travel, const struct hawser_span *span,
                      const struct hawser_motion *motion)
{
	travel->rest = *span;
	travel->apparent = *span;
	travel->thrust = span->rho*(motion->speed*motion->speed
	                            + 0.5*motion->fluctuation*motion->fluctuation);
	travel->m = travel->thrust/span->EA;
	travel->apparent.rho = (1.0 - travel->m)*span->rho;
}

enum hawser_status hawser_statics_travel(struct hawser_statics *st, const struct hawser_span *span,
                                         enum hawser_given given, double value,
                                         enum hawser_branch branch,
                                         const struct hawser_motion *motion,
                                         struct hawser_report *report)
{
	struct hawser_statics rest;
	struct travel travel;
	enum hawser_status status = check(motion, report);

	if (!status)
		status = hawser_statics_solve(&rest, span, given, value, branch, report);
	if (status)
		return status;
	if (motion->speed == 0.0 && motion->fluctuation == 0.0) {
		*st = rest;
		st->motion.hold = motion->hold;
		return HAWSER_OK;
	}
	travel_of(&travel, span, motion);
	if (!(travel.m < 1.0))
		return too_fast(span, given, value, branch, motion, report);
	status = steady(st, &travel, &rest, given, value, branch, motion->hold, report);
	/* with H held there is a state at every speed, so that the cause is the range of double */
	if (status == HAWSER_ERR_NO_SOLUTION && motion->hold == HAWSER_HOLD_TENSION &&
	    given != HAWSER_GIVEN_H)
		return too_fast(span, given, value, branch, motion, report);
	if (!status)
		fill(st, &travel, motion);
	return status;
}

/* Fill *travel if the speed is below that of longitudinal waves. */
static enum hawser_status subsonic(struct travel *travel, const struct hawser_span *span,
                                   const struct hawser_motion *motion, struct hawser_report *report)
{
	enum hawser_status status = check(motion, report);

	if (status)
		return status;
	travel_of(travel, span, motion);
	if (travel->m < 1.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "at %.10g m/s the cable is faster than waves along it, sqrt(EA/rho) = "
	                    "%.10g m/s: it has no steady state", motion->speed,
	                    sqrt(span->EA/span->rho));
}

enum hawser_status hawser__travel_at(struct hawser_statics *st, const struct hawser_span *span,
                                     const struct hawser_motion *motion, double H,
                                     struct hawser_report *report)
{
	struct travel travel;
	enum hawser_status status = subsonic(&travel, span, motion, report);

	if (!status)
		status = hawser_statics_solve(st, &travel.apparent, HAWSER_GIVEN_H, H,
		                              HAWSER_BRANCH_TAUT, report);
	if (!status)
		fill(st, &travel, motion);
	return status;
}

enum hawser_status hawser__travel_with(struct hawser_statics *st, const struct hawser_span *span,
                                       const struct hawser_motion *motion, enum hawser_given given,
                                       double value, struct hawser_report *report)
{
	struct travel travel;
	enum hawser_status status = subsonic(&travel, span, motion, report);

	if (status)
		return status;
	if (given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1)
		value = apparent_tension(&travel, value);
	else if (given == HAWSER_GIVEN_LENGTH0)
		value /= 1.0 - travel.m;
	if (!(value > 0.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "at %.10g m/s the tension must be above rho v^2 = %.10g N: travel "
		                    "slower, or raise the tension", motion->speed, travel.thrust);
	status = given == HAWSER_GIVEN_H && travel.thrust > 0.0
	             ? from_horizontal(st, &travel, value, report)
	             : hawser_statics_solve(st, &travel.apparent, given, value, HAWSER_BRANCH_TAUT,
	                                    report);
	if (!status)
		fill(st, &travel, motion);
	return status;
}

/* The actual tension (N) that belongs to the apparent tension A (N). */
static double actual_tension(const struct hawser_statics *st, double A)
{
	double m = st->motion.mach2;

	return (A + hawser__thrust(st))/(1.0 - m);
}

struct hawser_profile_point hawser_statics_actual_at(const struct hawser_statics *st, double S)
{
	struct hawser_profile_point point = hawser_statics_at(st, S/(1.0 - st->motion.mach2));

	point.S = S;
	point.T = actual_tension(st, point.T);
	return point;
}

struct hawser_statics hawser_statics_actual(const struct hawser_statics *st)
{
	struct hawser_statics actual = *st;
	double stretch = 1.0 - st->motion.mach2;

	actual.span.rho = st->span.rho/stretch;
	actual.length0 = st->length0*stretch;
	actual.T0 = st->motion.tension;
	actual.T1 = st->motion.tension1;
	actual.H = st->H*(actual.T0/st->T0);
	actual.V0 = st->V0*(actual.T0/st->T0);
	actual.V1 = st->V1*(actual.T1/st->T1);
	return actual;
}

/* statics/parabola.c - the parabolic cable: weight per horizontal length, no stretch.
 *
 * B 2.3.3, (2.91)-(2.94): with dS = dx the slope is linear in x, u = u0 + delta*x, and
 *
 *   y = u0*x + delta*x^2/2,   u0 = h* - delta/2,   T = H*sqrt(1 + u^2),   sag = delta*d/8.
 *
 * For given H, sag or tension at an end the solution has a closed form. A given length needs a
 * search, and so does the point at a given arclength. The arclength of the curve is (F(u) -
 * F(u0))/delta with F = (u*sqrt(1 + u^2) + asinh u)/2. In the angles p = asinh u0 and q = asinh u
 * the difference is (cosh(p + q)*sinh(q - p) + q - p)/2, without cancellation.
 *
 *   W  rho*g*d/2, N     c2  1 + h*^2, chord over d, squared
 *
 * Tension at end A: T0^2 = H^2 + (h*H - W)^2, quadratic in H. Only the tension of the lower end has
 * a minimum, W/sqrt(c2). (T1: the same with -h*.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "core/report.h"
#include "statics/catenary.h"
#include "statics/models.h"
#include "statics/search.h"

static const char where[] = "parabola";

/* delta times the arclength between the slopes u and u + step. */
static double arc(double u, double step)
{
	double v = u + step, angle = hawser__angle_between(u, v, step);

	return 0.5*(cosh(asinh(u) + asinh(v))*sinh(angle) + angle);
}

static double scaled_length(double hs, double delta)
{
	return arc(hs - 0.5*delta, delta)/delta;
}

/* delta of the parabola of scaled length l > chord; l increases with delta. 0 if it exceeds the
 * range of double. */
static double delta_of_length(double hs, double l, int *iterations)
{
	double chord = hypot(1.0, hs);
	struct hawser__search search = {
		/* l - chord = delta^2/(24*chord^3) when small */
		.x = sqrt(24.0*(l - chord)*chord)*chord, .lo = 0.0, .hi = INFINITY, .step = INFINITY,
	};
	double error, slope;

	do {
		double delta = search.x, up = hypot(1.0, hs + 0.5*delta);
		double mean = 0.5*(up + hypot(1.0, hs - 0.5*delta)), length = scaled_length(hs, delta);

		++*iterations;
		error = length - l;
		slope = mean - length; /* delta*dl/ddelta */
		if (fabs(error) <= DBL_EPSILON*l)
			return delta;
	} while (hawser__search_next(&search, error > 0.0, slope > 0.0 ? -error/slope : 0.0));
	return fabs(error) <= 64.0*DBL_EPSILON*l ? search.x : 0.0;
}

/* H from the tension T at an end; hs is the slope of the chord towards the other end. 0 if this
 * branch has no solution. */
static double from_tension(double T, double W, double hs, enum hawser_branch branch)
{
	double c2 = 1.0 + hs*hs, squared = (sqrt(c2)*T - W)*(sqrt(c2)*T + W), root;

	if (squared < 0.0)
		return 0.0;
	root = sqrt(squared);
	if (branch == HAWSER_BRANCH_SLACK) /* product of the roots: (W^2 - T^2)/c2 */
		return hs > 0.0 ? fmax(0.0, (W - T)*(W + T)/(hs*W + root)) : 0.0;
	return hs >= 0.0 ? (hs*W + root)/c2 : fmax(0.0, (T - W)*(T + W)/(root - hs*W));
}

static enum hawser_status no_tension(const struct hawser_span *span, double T, double hs,
                                     enum hawser_branch branch, struct hawser_report *report)
{
	double W = 0.5*span->rho*span->g*span->d;

	if (branch == HAWSER_BRANCH_SLACK)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the parabola has no slack equilibrium with an end tension of "
		                    "%.10g N: it has one for the tension of the lower end only, between "
		                    "%.10g and %.10g N", T, W/hypot(1.0, hs), W);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the end tension of %.10g N is below the least one of the parabola, "
	                    "%.10g N: give more than that", T, hs > 0.0 ? W/hypot(1.0, hs) : W);
}

static enum hawser_status tension_of(double *H, const struct hawser_span *span,
                                     enum hawser_given given, double value,
                                     enum hawser_branch branch, int *iterations,
                                     struct hawser_report *report)
{
	double w = span->rho*span->g, hs = span->h/span->d, chord = hypot(span->d, span->h);
	double seen = given == HAWSER_GIVEN_T1 ? -hs : hs;

	switch (given) {
	case HAWSER_GIVEN_T0:
	case HAWSER_GIVEN_T1:
		*H = from_tension(value, 0.5*w*span->d, seen, branch);
		return *H > 0.0 ? HAWSER_OK : no_tension(span, value, seen, branch, report);
	case HAWSER_GIVEN_SAG:
		*H = 0.125*w*span->d/value*span->d;
		return HAWSER_OK;
	case HAWSER_GIVEN_LENGTH0:
		if (!(value > chord))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
			                    "a parabola of length0 = %.17g m doesn't hang between its ends: it "
			                    "doesn't stretch, and the chord is %.17g m", value, chord);
		*H = w*span->d/delta_of_length(hs, value/span->d, iterations);
		return HAWSER_OK;
	default:
		*H = value;
		return HAWSER_OK;
	}
}

/* delta*x at the arclength s (scaled) from the end where the slope is u, 0 < s < l: Newton's method
 * on the arclength, whose derivative is at least 1. `sense` is 1 from end A, -1 from end B. */
static double advance(const struct hawser_statics *st, double u, double s, double sense)
{
	double lo = 0.0, hi = st->delta, step = hi*(s/st->l), error, next;

	for (int i = 0; i < 100; i++) {
		error = sense > 0.0 ? arc(u, step) : arc(u - step, step);
		error -= st->delta*s;
		if (error > 0.0)
			hi = step;
		else
			lo = step;
		next = step - error/hypot(1.0, u + sense*step);
		if (!(next > lo && next < hi))
			next = 0.5*(lo + hi);
		if (fabs(next - step) <= 2.0*DBL_EPSILON*step)
			break;
		step = next;
	}
	return step;
}

struct hawser_profile_point hawser__parabola_at(const struct hawser_statics *st, double S)
{
	struct hawser_profile_point point = {.S = S};
	double d = st->span.d, u1 = st->V1/st->H, step, x;

	if (S <= 0.5*st->length0) {
		step = S > 0.0 ? advance(st, st->eta, S/d, 1.0) : 0.0;
		x = step/st->delta;
		point.slope = st->eta + step;
		point.x = d*x;
		point.y = d*x*(st->eta + 0.5*step);
	} else {
		step = S < st->length0 ? advance(st, u1, (st->length0 - S)/d, -1.0) : 0.0;
		x = step/st->delta;
		point.slope = u1 - step;
		point.x = d - d*x;
		point.y = st->span.h - d*x*(u1 - 0.5*step);
	}
	point.T = st->H*hypot(1.0, point.slope);
	return point;
}

enum hawser_status hawser__parabola_solve(struct hawser_statics *st, const struct hawser_span *span,
                                          enum hawser_given given, double value,
                                          enum hawser_branch branch, struct hawser_report *report)
{
	enum hawser_status status = hawser__statics_check(span, given, value, branch, report);
	double H = 0.0, u1;

	*st = (struct hawser_statics){.span = *span, .given = given};
	if (!status)
		status = tension_of(&H, span, given, value, branch, &st->iterations, report);
	if (status)
		return status;
	if (given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1)
		st->branch = branch;
	st->span.EA = st->irvine = st->irvine_source = INFINITY;
	st->H = H;
	st->delta = span->rho*span->g*span->d/H;
	st->hs = span->h/span->d;
	st->eta = st->hs - 0.5*st->delta;
	u1 = st->hs + 0.5*st->delta;
	st->V0 = H*st->eta;
	st->V1 = H*u1;
	st->T0 = H*hypot(1.0, st->eta);
	st->T1 = H*hypot(1.0, u1);
	st->l = scaled_length(st->hs, st->delta);
	st->length0 = st->length = span->d*st->l;
	st->sag = 0.125*span->d*st->delta;
	if (!(H >= DBL_MIN && st->delta >= DBL_MIN && st->length <= DBL_MAX && st->T0 <= DBL_MAX &&
	      st->T1 <= DBL_MAX))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "some result of this parabola (tension, length or slope) exceeds the "
		                    "range of double-precision numbers");
	st->error = 0.0;
	st->closure = span->d*fabs(advance(st, st->eta, st->l, 1.0)/st->delta - 1.0)*hypot(1.0, u1);
	return HAWSER_OK;
}

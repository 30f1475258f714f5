/* statics/solve.c - static solution from its arguments: checks, choice of the search, mirror image
 * of a span that descends from A to B, estimate of the round-off error, and messages.
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
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "core/report.h"
#include "statics/catenary.h"
#include "statics/loaded.h"
#include "statics/models.h"

static const char where[] = "statics";
static const double steepest = 1e9; /* largest |h|/d */

static const struct {
	const char *name, *unit;
} given_names[] = {
	[HAWSER_GIVEN_H] = {"horizontal tension H", "N"},
	[HAWSER_GIVEN_T0] = {"tension T0 at end A", "N"},
	[HAWSER_GIVEN_T1] = {"tension T1 at end B", "N"},
	[HAWSER_GIVEN_LENGTH0] = {"unstretched length length0", "m"},
	[HAWSER_GIVEN_SAG] = {"sag", "m"},
};

static enum hawser_status positive(double value, const char *name, const char *unit,
                                   struct hawser_report *report)
{
	if (value > 0.0 && value <= DBL_MAX)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "the %s is %g %s: it has to be a positive, finite number", name, value,
	                    unit);
}

enum hawser_status hawser__statics_check(const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if ((int)given < HAWSER_GIVEN_H || given > HAWSER_GIVEN_SAG)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d is none of the quantities: give one of H, T0, T1, length0, sag",
		                    (int)given);
	if (branch != HAWSER_BRANCH_TAUT && branch != HAWSER_BRANCH_SLACK)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d is no branch: choose taut or slack", (int)branch);
	if (!isinf(span->EA) || span->EA < 0.0)
		status = positive(span->EA, "axial stiffness EA", "N", report);
	if (!status)
		status = positive(span->rho, "mass per length rho", "kg/m", report);
	if (!status)
		status = positive(span->g, "gravity g", "m/s^2", report);
	if (!status)
		status = positive(span->d, "horizontal span d", "m", report);
	if (!status && !isfinite(span->h))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "the height difference h is %g m: it has to be finite", span->h);
	if (!status && fabs(span->h) > steepest*span->d)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "the height difference h = %g m over the horizontal span d = %g m: "
		                      "a slope beyond %g is a vertical cable, which H doesn't describe",
		                      span->h, span->d, steepest);
	if (!status)
		status = positive(value, given_names[given].name, given_names[given].unit, report);
	return status;
}

static enum hawser_status out_of_range(enum hawser_given given, double value,
                                       struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "with the %s = %g %s some result of this span (tension, length or slope) "
	                    "exceeds the range of double-precision numbers", given_names[given].name,
	                    value, given_names[given].unit);
}

/* The message for HAWSER__NOT_FOUND. If a tension is given, *cat is the equilibrium of the least
 * tension. */
static enum hawser_status none(const struct hawser__catenary *cat,
                               const struct hawser__chord *chord, enum hawser_given given,
                               enum hawser__end end, double value, struct hawser_report *report)
{
	double unused, least;

	if (given == HAWSER_GIVEN_LENGTH0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "an inextensible cable of length0 = %.17g m doesn't hang between its "
		                    "ends: the chord is %.17g m; give a longer cable or a finite EA", value,
		                    hypot(chord->d, chord->h));
	least = hawser__catenary_tension(cat, end, &unused);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the %s = %.10g N is below the least one with which this span can hang, "
	                    "%.10g N (at H = %.10g N, length0 = %.10g m): give at least that",
	                    given_names[given].name, value, least, cat->H,
	                    chord->d*(cat->coshm*cat->sinha/cat->b));
}

static enum hawser__found search(struct hawser__catenary *cat, const struct hawser__chord *chord,
                                 enum hawser_given given, enum hawser__end end, double value,
                                 enum hawser_branch branch)
{
	switch (given) {
	case HAWSER_GIVEN_T0:
	case HAWSER_GIVEN_T1:
		return hawser__from_tension(cat, chord, end, value, branch);
	case HAWSER_GIVEN_LENGTH0:
		return hawser__from_length(cat, chord, value);
	case HAWSER_GIVEN_SAG:
		return hawser__from_sag(cat, chord, value);
	default:
		cat->iterations = 0;
		hawser__catenary_at(cat, chord, value, 0.0);
		return isnan(cat->a) ? HAWSER__RANGE : HAWSER__FOUND;
	}
}

/* Slopes at the ends. A level cable with a deep sag closes in y only if both slopes have the same
 * round-off error, which sinh of two rounded angles does not ensure, whereas the products do. For a
 * steep cable the products cancel. */
static void slopes(const struct hawser__catenary *cat, double *low, double *up)
{
	if (cat->m < 0.5 && cat->a > 1.0) {
		*low = cat->sinhm*cat->cosha - cat->coshm*cat->sinha;
		*up = cat->sinhm*cat->cosha + cat->coshm*cat->sinha;
	} else {
		*low = sinh(cat->m - cat->a);
		*up = sinh(cat->m + cat->a);
	}
}

/* Fill the result from the equilibrium of the span with |h|. */
static void fill(struct hawser_statics *st, const struct hawser__catenary *cat,
                 const struct hawser__chord *chord)
{
	double lower = cat->m - cat->a, upper = cat->m + cat->a, unused, low, up, u0, u1;
	int falls = st->span.h < 0.0;

	st->attachments = 0;
	st->elastic = 0;
	slopes(cat, &low, &up);
	u0 = falls ? -up : low;
	u1 = falls ? -low : up;
	st->H = cat->H;
	st->T0 = cat->H*cosh(falls ? upper : lower);
	st->T1 = cat->H*cosh(falls ? lower : upper);
	st->V0 = cat->H*u0;
	st->V1 = cat->H*u1;
	st->eta = u0;
	st->epsilon = cat->eps;
	st->delta = 2.0*cat->b;
	st->l = cat->coshm*cat->sinha/cat->b;
	st->hs = st->span.h/st->span.d;
	st->length0 = st->span.d*st->l;
	/* eps times the integral of 1 + u^2 over the angle */
	st->length = st->length0 + 0.5*chord->d/cat->b*(cat->eps*cat->a + cat->X/cat->coshm*cat->cosha
	             *(cat->coshm*cat->coshm + cat->sinhm*cat->sinhm));
	st->sag = hawser__catenary_sag(cat, chord, &unused);
	st->irvine = hawser__irvine(cat, chord);
	st->irvine_source = hawser__irvine_source(cat);
	st->closure = hawser__statics_closure(st);
	st->motion.tension = st->T0;
	st->motion.tension1 = st->T1;
	st->iterations = cat->iterations;
}

static int representable(const struct hawser_statics *st)
{
	const double values[] = {st->H, st->T0, st->T1, st->delta, st->l, st->length0, st->length,
	                         st->sag};

	for (size_t i = 0; i < sizeof values/sizeof *values; i++)
		if (!(values[i] >= DBL_MIN && values[i] <= DBL_MAX))
			return 0;
	return isfinite(st->closure) && isfinite(st->V0) && isfinite(st->V1);
}

void hawser__chord_of(struct hawser__chord *chord, const struct hawser_span *span)
{
	chord->EA = span->EA;
	chord->w = span->rho*span->g;
	chord->d = span->d;
	chord->h = fabs(span->h);
	chord->force = 0.5*chord->w*chord->d;
	chord->slope = chord->h/chord->d;
	chord->cosc = hypot(1.0, chord->slope);
}

enum hawser__end hawser__end_of(const struct hawser_span *span, enum hawser_given given)
{
	return (given == HAWSER_GIVEN_T1) != (span->h < 0.0) ? HAWSER__UPPER : HAWSER__LOWER;
}

/* --- round-off --- */

/* Errors in units of round-off: of a quantity at known H, and of the given quantity in a search.
 * Measured (bench/estimates statics), with a safety factor of two. */
static const double forward = 8.0, inverse = 6.0;

static double of_length(const struct hawser__catenary *cat)
{
	double X = cat->X, Y = X/cat->tanha, t = cat->sinhm/cat->coshm, t2 = t*t;
	double steep = 1.0/(cat->coshm*cat->coshm); /* 1 - t^2 */
	double more = steep + 1.0/(cat->sinha*cat->sinha); /* coth^2 a - t^2 */

	return (steep*cat->K + X*(cat->a + X)*more)/((1.0 + Y)*(1.0 + Y) - t2*X*X);
}

/* The largest relative error of H, T0, T1, length0, length and sag for an exact given quantity; for a
 * given tension, `end` is its end. */
static double precision(const struct hawser__catenary *cat, const struct hawser__chord *chord,
                        enum hawser_given given, enum hawser__end end)
{
	double lower, upper, sag, length = of_length(cat), k = INFINITY, most;

	(void)hawser__catenary_tension(cat, HAWSER__LOWER, &lower);
	(void)hawser__catenary_tension(cat, HAWSER__UPPER, &upper);
	(void)hawser__catenary_sag(cat, chord, &sag);
	if (given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1)
		k = fmax(fabs(end == HAWSER__UPPER ? upper : lower), sqrt(inverse*DBL_EPSILON));
	else if (given == HAWSER_GIVEN_LENGTH0)
		k = length;
	else if (given == HAWSER_GIVEN_SAG)
		k = fabs(sag);
	most = fmax(fmax(1.0, length), fmax(fmax(fabs(lower), fabs(upper)), fabs(sag)));
	return DBL_EPSILON*(forward*(1.0 + cat->m + cat->a) +
	                    inverse*(1.0 + cat->m + cat->a)*most/k);
}

/* --- the solution --- */

enum hawser_status hawser_statics_solve(struct hawser_statics *st, const struct hawser_span *span,
                                        enum hawser_given given, double value,
                                        enum hawser_branch branch, struct hawser_report *report)
{
	enum hawser__end end = hawser__end_of(span, given);
	int tension = given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1;
	enum hawser_status status = hawser__statics_check(span, given, value, branch, report);
	struct hawser__catenary cat;
	struct hawser__chord chord;
	enum hawser__found outcome;

	if (status)
		return status;
	hawser__chord_of(&chord, span);
	if (!(chord.force >= DBL_MIN && chord.force <= DBL_MAX))
		return out_of_range(given, value, report);
	outcome = search(&cat, &chord, given, end, value, branch);
	if (outcome == HAWSER__NOT_FOUND)
		return none(&cat, &chord, given, end, value, report);
	if (outcome == HAWSER__RANGE)
		return out_of_range(given, value, report);
	st->motion = (struct hawser_motion){0};
	st->span = *span;
	st->given = given;
	st->branch = tension ? branch : HAWSER_BRANCH_TAUT;
	st->turned = 0;
	st->space = 0;
	st->bending = (struct hawser_bending){0};
	memset(st->moved, 0, sizeof st->moved);
	st->imbalance = 0.0;
	fill(st, &cat, &chord);
	st->error = precision(&cat, &chord, given, end);
	if (!representable(st))
		return out_of_range(given, value, report);
	if (st->closure > 1e-9*(chord.d*chord.cosc + st->length))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, cat.iterations, st->closure,
		                       "the profile misses end B by %g m with the %s = %.17g %s",
		                       st->closure, given_names[given].name, value,
		                       given_names[given].unit);
	return HAWSER_OK;
}

enum hawser_status hawser_statics_scene(struct hawser_statics *st, const struct hawser_scene *scene,
                                        struct hawser_report *report)
{
	struct hawser_motion motion = {.speed = scene->travel.speed,
	                               .fluctuation = scene->travel.fluctuation,
	                               .hold = scene->travel.hold};
	struct hawser_equivalent equal;
	struct hawser_held held[2];
	enum hawser_status status = hawser_statics_equivalent(&equal, scene, report);

	if (status)
		return status;
	if (scene->attachments > 0) /* such a cable does not travel */
		status = hawser__statics_attached(st, &equal, scene, report);
	else
		status = hawser_statics_travel(st, &equal.span, equal.given, equal.value, equal.branch,
		                               &motion, report);
	if (status)
		return status;
	hawser_statics_turn(st, &equal);
	if (scene->cable.EI > 0.0)
		st->bending = (struct hawser_bending){scene->cable.EI, {scene->ends[0], scene->ends[1]}};
	(void)hawser_statics_held(held, scene);
	return hawser_statics_hold(st, held, report);
}

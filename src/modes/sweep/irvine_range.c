/* modes/sweep/irvine_range.c - the range of a sweep of the tension, and its stations.
 *
 * Irvine's parameter decreases monotonically with H, so that bisection in log H solves for a given
 * value.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "modes/sweep/branches.h"
#include "statics/travel.h"

static const double lambda_taut = 0.1*M_PI, lambda_slack = 10.0*M_PI; /* B, figures 4.4 and 4.5 */
static const double strain_most = 0.1, delta_most = 4.0;
static const double beside = 1.25; /* ratio of the end of the range to a tension that it contains */
enum { BISECTIONS = 60, SAMPLES = 256 };

static const char *const given_names[] = {"none", "H", "T0", "T1", "length0", "sag"};

const char *hawser_given_name(enum hawser_given given)
{
	return (unsigned)given < sizeof given_names/sizeof *given_names ? given_names[given] : "none";
}

double hawser_irvine_value(const struct hawser_statics *st, enum hawser_given sweep)
{
	int moves = st->motion.speed != 0.0 || st->motion.fluctuation != 0.0;
	struct hawser_statics actual = moves ? hawser_statics_actual(st) : *st;

	switch (sweep) {
	case HAWSER_GIVEN_H: return actual.H;
	case HAWSER_GIVEN_T0: return actual.T0;
	case HAWSER_GIVEN_T1: return actual.T1;
	case HAWSER_GIVEN_LENGTH0: return actual.length0;
	case HAWSER_GIVEN_SAG: return st->sag;
	default: return NAN;
	}
}

/* The swept quantity of a cable at a constant speed. */
struct sweep {
	const struct hawser_span *span;
	const struct hawser_irvine_options *options;
	enum hawser_given given;
};

static struct hawser_motion motion_of(const struct hawser_irvine_options *options)
{
	return (struct hawser_motion){.speed = options->speed, .fluctuation = options->fluctuation};
}

static enum hawser_status attached(struct hawser_statics *st, const struct hawser_span *span,
                                   const struct hawser_irvine_options *options,
                                   enum hawser_given given, double value,
                                   struct hawser_report *report)
{
	const double gravity[3] = {0.0, options->gravity > 0.0 ? -options->gravity : -span->g, 0.0};

	return hawser_statics_weighted(st, span, given, value, HAWSER_BRANCH_TAUT, options->attach,
	                               options->attachments, gravity, report);
}

enum hawser_status hawser__irvine_at(struct hawser_statics *st, const struct hawser_span *span,
                                     const struct hawser_irvine_options *options, double H,
                                     struct hawser_report *report)
{
	const struct hawser_motion motion = motion_of(options);

	if (options->attachments > 0)
		return attached(st, span, options, HAWSER_GIVEN_H, H, report);
	return hawser__travel_at(st, span, &motion, H, report);
}

static enum hawser_status at_tension(struct hawser_statics *st, const struct sweep *sweep, double x,
                                     struct hawser_report *report)
{
	return hawser__irvine_at(st, sweep->span, sweep->options, exp(x), report);
}

/* Solve irvine_source = lambda for *x in [low, high]; without a solution *x is the nearer end. */
static enum hawser_status find(double *x, const struct sweep *sweep, double lambda, double low,
                               double high, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser_statics st;

	for (int i = 0; i < BISECTIONS && !status; i++) {
		*x = 0.5*(low + high);
		status = at_tension(&st, sweep, *x, report);
		if (!status && st.irvine_source > lambda)
			low = *x;
		else
			high = *x;
	}
	return status;
}

/* Move *end towards x so that the swept quantity is monotone between x and *end. */
static enum hawser_status cut_turn(double *end, const struct sweep *sweep, double x,
                                   struct hawser_report *report)
{
	double last = INFINITY, start = x, stop = *end;

	for (int i = 0; i <= SAMPLES; i++) {
		struct hawser_statics st;
		enum hawser_status status;

		x = start + (stop - start)*i/SAMPLES;
		status = at_tension(&st, sweep, x, report);
		if (status)
			return status;
		if (hawser_irvine_value(&st, sweep->given) >= last)
			return HAWSER_OK;
		last = hawser_irvine_value(&st, sweep->given);
		*end = x;
	}
	return HAWSER_OK;
}

/* The range [*slack, *taut] in log H. */
static enum hawser_status find_range(double *taut, double *slack, const struct sweep *sweep,
                                     struct hawser_report *report)
{
	const struct hawser_span *span = sweep->span;
	double low = log(span->rho*span->g*span->d/delta_most), high = log(strain_most*span->EA);
	double contained = log(sweep->options->contained);
	enum hawser_status status;

	if (isinf(span->EA))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "an inextensible cable (EA infinite) has an infinite Irvine "
		                    "parameter at every tension: give a finite EA, such as 1e14 N");
	if (!(low < high))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "no default range: a cable with EA = %g N that weighs %g N over its "
		                    "span is strained by more than %g or hangs very deep; give the "
		                    "range yourself", span->EA, span->rho*span->g*span->d, strain_most);
	status = find(taut, sweep, lambda_taut, low, high, report);
	if (!status)
		status = find(slack, sweep, lambda_slack, low, high, report);
	if (!status && isfinite(contained)) {
		*taut = fmax(*taut, fmin(contained + log(beside), high));
		*slack = fmin(*slack, fmax(contained - log(beside), low));
	}
	if (!status && (sweep->given == HAWSER_GIVEN_T0 || sweep->given == HAWSER_GIVEN_T1))
		status = cut_turn(slack, sweep, *taut, report);
	if (!status && !(*slack < *taut - 0.01))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "no default range: where this cable is taut its strain would be above "
		                    "%g; give the range yourself", strain_most);
	return status;
}

enum hawser_status hawser__irvine_range(double *from, double *to, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        enum hawser_given given, struct hawser_report *report)
{
	const struct sweep sweep = {span, options,
	                            given == HAWSER_GIVEN_NONE ? HAWSER_GIVEN_H : given};
	struct hawser_statics st;
	double taut = NAN, slack = NAN;
	enum hawser_status status;

	/* fails for an invalid span */
	status = hawser_statics_solve(&st, span, HAWSER_GIVEN_H, span->rho*span->g*span->d,
	                              HAWSER_BRANCH_TAUT, report);
	if (!status)
		status = find_range(&taut, &slack, &sweep, report);
	if (!status)
		status = at_tension(&st, &sweep, taut, report);
	if (status)
		return status;
	*from = hawser_irvine_value(&st, sweep.given);
	status = at_tension(&st, &sweep, slack, report);
	if (!status)
		*to = hawser_irvine_value(&st, sweep.given);
	return status;
}

enum hawser_status hawser_irvine_range(double *from, double *to, const struct hawser_span *span,
                                       enum hawser_given sweep, struct hawser_report *report)
{
	const struct hawser_irvine_options rest = {.attachments = 0};

	return hawser__irvine_range(from, to, span, &rest, sweep, report);
}

static enum hawser_status tension_of(double *x, const struct hawser_span *span,
                                     const struct hawser_irvine_options *options, double value,
                                     struct hawser_report *report)
{
	const struct hawser_motion motion = motion_of(options);
	struct hawser_statics st;
	enum hawser_status status;

	if (options->attachments > 0)
		status = attached(&st, span, options, options->sweep, value, report);
	else
		status = hawser__travel_with(&st, span, &motion, options->sweep, value, report);
	if (!status)
		*x = log(st.H);
	return status;
}

enum hawser_status hawser__irvine_place(double *x, int points, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        struct hawser_report *report)
{
	double ratio = options->to/options->from;
	int last = points - 1, by_tension = options->sweep == HAWSER_GIVEN_LENGTH0;
	enum hawser_status status = tension_of(&x[0], span, options, options->from, report);

	if (!status)
		status = tension_of(&x[last], span, options, options->to, report);
	for (int i = 1; i < last && !status; i++) {
		double part = (double)i/last;

		if (by_tension)
			x[i] = x[0] + part*(x[last] - x[0]);
		else
			status = tension_of(&x[i], span, options, options->from*pow(ratio, part), report);
	}
	for (int i = 1; i < points && !status; i++)
		if (!((x[i] - x[i - 1])*(x[last] - x[0]) > 0.0))
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
			                      "the tension does not change between neighbouring stations "
			                      "near %s = %g: give a wider range or fewer points",
			                      hawser_given_name(options->sweep),
			                      options->from*pow(ratio, (double)i/last));
	return status;
}

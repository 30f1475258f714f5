/* modes/irvine_range.c - where a sweep begins and ends, and its stations in between.
 *
 * Irvine's parameter falls monotonically with H: its value is met by bisection in log H.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stddef.h>

#include "core/report.h"
#include "modes/irvine_range.h"

static const double lambda_taut = 0.1*M_PI, lambda_slack = 10.0*M_PI; /* B, figures 4.4 and 4.5 */
static const double strain_most = 0.1, delta_most = 4.0;
enum { BISECTIONS = 60, SAMPLES = 256 };

static const char *const given_names[] = {"none", "H", "T0", "T1", "length0", "sag"};

const char *hawser_given_name(enum hawser_given given)
{
	return (unsigned)given < sizeof given_names/sizeof *given_names ? given_names[given] : "none";
}

double hawser_irvine_value(const struct hawser_statics *st, enum hawser_given sweep)
{
	switch (sweep) {
	case HAWSER_GIVEN_H: return st->H;
	case HAWSER_GIVEN_T0: return st->T0;
	case HAWSER_GIVEN_T1: return st->T1;
	case HAWSER_GIVEN_LENGTH0: return st->length0;
	case HAWSER_GIVEN_SAG: return st->sag;
	default: return NAN;
	}
}

static enum hawser_status at_tension(struct hawser_statics *st, const struct hawser_span *span,
                                     double x, struct hawser_report *report)
{
	return hawser_statics_solve(st, span, HAWSER_GIVEN_H, exp(x), HAWSER_BRANCH_TAUT, report);
}

/* *x between low and high where irvine_source is lambda; the end that is nearest where it is not. */
static enum hawser_status find(double *x, const struct hawser_span *span, double lambda, double low,
                               double high, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser_statics st;

	for (int i = 0; i < BISECTIONS && !status; i++) {
		*x = 0.5*(low + high);
		status = at_tension(&st, span, *x, report);
		if (!status && st.irvine_source > lambda)
			low = *x;
		else
			high = *x;
	}
	return status;
}

/* Along the way from x to *end the quantity changes in one sense: cut *end where it turns. */
static enum hawser_status cut_turn(double *end, const struct hawser_span *span, double x,
                                   enum hawser_given sweep, struct hawser_report *report)
{
	double last = INFINITY, start = x, stop = *end;

	for (int i = 0; i <= SAMPLES; i++) {
		struct hawser_statics st;
		enum hawser_status status;

		x = start + (stop - start)*i/SAMPLES;
		status = at_tension(&st, span, x, report);
		if (status)
			return status;
		if (hawser_irvine_value(&st, sweep) >= last)
			return HAWSER_OK;
		last = hawser_irvine_value(&st, sweep);
		*end = x;
	}
	return HAWSER_OK;
}

/* The range in log H. */
static enum hawser_status find_range(double *taut, double *slack, const struct hawser_span *span,
                                     enum hawser_given sweep, struct hawser_report *report)
{
	double low = log(span->rho*span->g*span->d/delta_most), high = log(strain_most*span->EA);
	enum hawser_status status;

	if (isinf(span->EA))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "an inextensible cable (EA infinite) has an infinite Irvine "
		                    "parameter at every tension: give a finite EA, such as 1e14 N");
	if (!(low < high))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "no usual range: a cable with EA = %g N that weighs %g N over its "
		                    "span is strained by more than %g or hangs very deep; give the "
		                    "range yourself", span->EA, span->rho*span->g*span->d, strain_most);
	status = find(taut, span, lambda_taut, low, high, report);
	if (!status)
		status = find(slack, span, lambda_slack, low, high, report);
	if (!status && (sweep == HAWSER_GIVEN_T0 || sweep == HAWSER_GIVEN_T1))
		status = cut_turn(slack, span, *taut, sweep, report);
	if (!status && !(*slack < *taut - 0.01))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "irvine",
		                    "no usual range: where this cable is taut its strain would be above "
		                    "%g; give the range yourself", strain_most);
	return status;
}

enum hawser_status hawser_irvine_range(double *from, double *to, const struct hawser_span *span,
                                       enum hawser_given sweep, struct hawser_report *report)
{
	struct hawser_statics st;
	double taut, slack;
	enum hawser_status status;

	if (sweep == HAWSER_GIVEN_NONE)
		sweep = HAWSER_GIVEN_H;
	/* complains about a span that makes no sense */
	status = hawser_statics_solve(&st, span, HAWSER_GIVEN_H, span->rho*span->g*span->d,
	                              HAWSER_BRANCH_TAUT, report);
	if (!status)
		status = find_range(&taut, &slack, span, sweep, report);
	if (!status)
		status = at_tension(&st, span, taut, report);
	if (status)
		return status;
	*from = hawser_irvine_value(&st, sweep);
	status = at_tension(&st, span, slack, report);
	if (!status)
		*to = hawser_irvine_value(&st, sweep);
	return status;
}

static enum hawser_status tension_of(double *x, const struct hawser_span *span,
                                     enum hawser_given sweep, double value,
                                     struct hawser_report *report)
{
	struct hawser_statics st;
	enum hawser_status status = hawser_statics_solve(&st, span, sweep, value,
	                                                 HAWSER_BRANCH_TAUT, report);

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
	enum hawser_status status = tension_of(&x[0], span, options->sweep, options->from, report);

	if (!status)
		status = tension_of(&x[last], span, options->sweep, options->to, report);
	for (int i = 1; i < last && !status; i++) {
		double part = (double)i/last;

		if (by_tension)
			x[i] = x[0] + part*(x[last] - x[0]);
		else
			status = tension_of(&x[i], span, options->sweep, options->from*pow(ratio, part),
			                    report);
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

/* Approximate static models against the elastic catenary: orders of their errors, the same parabola
 * from every given quantity, its profile, and failures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/statics-draw.h"
#include "tests/tap.h"

enum { CATENARY, INEXTENSIBLE, PARABOLA };

static struct hawser_statics solved(int model, struct hawser_span span, enum hawser_given given,
                                    double value, enum hawser_branch branch)
{
	struct hawser_statics st = {0};
	struct hawser_report report = {.message = ""};

	if (hawser_statics_model(model)->solve(&st, &span, given, value, branch, &report))
		ok(0, "%s: %s", hawser_statics_model(model)->name, report.message);
	return st;
}

/* d = 100 m, weight 1 N/m: H = 100/delta. */
static struct hawser_statics weighed(int model, double delta, double slope)
{
	const struct hawser_span span = {INFINITY, 1.0, 1.0, 100.0, 100.0*slope};

	return solved(model, span, HAWSER_GIVEN_H, 100.0/delta, HAWSER_BRANCH_TAUT);
}

/* Series for a level span: the relative differences are delta^2/48 for the sag (smaller),
 * delta^4/96 for T, delta^4/480 for the length, and delta^3/384 for the position at mid-span. */
static void orders(void)
{
	static const double delta[] = {0.2385, 0.11925};
	struct hawser_statics_error error[2];

	for (int i = 0; i < 2; i++) {
		struct hawser_statics exact = weighed(CATENARY, delta[i], 0.0);
		struct hawser_statics st = weighed(PARABOLA, delta[i], 0.0);

		hawser_statics_compare(&error[i], hawser_statics_model(PARABOLA), &st, &exact);
	}
	close_to(error[1].sag, -delta[1]*delta[1]/48.0, 1e-3, "sag's error");
	close_to(error[0].sag/error[1].sag, 4.0, 2e-3, "falls at second order");
	close_to(error[1].T0, -pow(delta[1], 4.0)/96.0, 1e-2, "tension's error");
	close_to(error[0].T1/error[1].T1, 16.0, 2e-2, "falls at fourth order");
	close_to(error[1].length, -pow(delta[1], 4.0)/480.0, 1e-2, "length's error");
	close_to(error[0].length0/error[1].length0, 16.0, 2e-2, "falls at fourth order");
	close_to(error[1].position, 100.0*pow(delta[1], 3.0)/384.0, 1e-3, "the curve's error");
}

/* With the weight per length of the span instead of the cable, the sag of an inclined parabola is
 * smaller by the factor cos(theta). */
static void inclined(void)
{
	struct hawser_statics exact = weighed(CATENARY, 1e-4, 0.75), st = weighed(PARABOLA, 1e-4, 0.75);
	struct hawser_statics_error error;

	hawser_statics_compare(&error, hawser_statics_model(PARABOLA), &st, &exact);
	close_to(error.sag, 0.8 - 1.0, 1e-6, "a taut parabola at 3/4: sag times cos(theta)");
}

/* The inextensible catenary is the limit EA -> infinity, with an error of first order in epsilon. */
static void stretch(void)
{
	struct hawser_span span = {1e9, 6.0, 9.81, 250.0, 60.0};
	struct hawser_statics_error soft, stiff, none;
	struct hawser_statics st, exact = solved(CATENARY, span, HAWSER_GIVEN_H, 8e4, 0);

	st = solved(INEXTENSIBLE, span, HAWSER_GIVEN_H, 8e4, 0);
	ok(isinf(st.span.EA) && st.epsilon == 0.0 && isinf(st.irvine), "EA is infinite");
	hawser_statics_compare(&soft, hawser_statics_model(INEXTENSIBLE), &st, &exact);
	span.EA = 2e9;
	exact = solved(CATENARY, span, HAWSER_GIVEN_H, 8e4, 0);
	hawser_statics_compare(&stiff, hawser_statics_model(INEXTENSIBLE), &st, &exact);
	close_to(soft.sag/stiff.sag, 2.0, 1e-3, "sag's error halves with epsilon");
	close_to(soft.length0/stiff.length0, 2.0, 1e-3, "length's error halves with epsilon");
	span.EA = INFINITY;
	exact = solved(CATENARY, span, HAWSER_GIVEN_H, 8e4, 0);
	hawser_statics_compare(&none, hawser_statics_model(INEXTENSIBLE), &st, &exact);
	ok(none.H == 0.0 && none.T0 == 0.0 && none.T1 == 0.0 && none.length == 0.0 && none.sag == 0.0 &&
	   none.position < 1e-12*span.d, "of an inextensible cable it is the catenary: %.1e m",
	   none.position);
}

/* The same parabola from each of its quantities; a tension at the lower end belongs to two
 * parabolas. */
static void roundtrips(void)
{
	double worst = 0.0, slack = 0.0, order = 0.0;
	int pairs = 0;

	for (int i = 0; i < 400; i++) {
		struct hawser_span span;
		double H = draw_span(&span);
		struct hawser_statics st = solved(PARABOLA, span, HAWSER_GIVEN_H, H, 0), back;
		double W = 0.5*span.rho*span.g*span.d, slope = fabs(st.hs), c2 = 1.0 + slope*slope;
		enum hawser_given low = span.h > 0.0 ? HAWSER_GIVEN_T0 : HAWSER_GIVEN_T1;
		enum hawser_given up = span.h > 0.0 ? HAWSER_GIVEN_T1 : HAWSER_GIVEN_T0;
		double Tlow = span.h > 0.0 ? st.T0 : st.T1, Tup = span.h > 0.0 ? st.T1 : st.T0;
		int taut = H > slope*W/c2;
		/* dT/dH is 0 at the minimum of T; at an upper end it is 0 at H = 0 */
		double flat = fabs(H - slope*W/c2)*c2*H/(Tlow*Tlow);
		double flat_up = (H*c2 + slope*W)*H/(Tup*Tup);

		back = solved(PARABOLA, span, HAWSER_GIVEN_SAG, st.sag, 0);
		worst = fmax(worst, fabs(back.H/H - 1.0));
		back = solved(PARABOLA, span, up, Tup, 0);
		worst = fmax(worst, fabs(back.H/H - 1.0)*flat_up);
		if (flat > 1e-3) {
			back = solved(PARABOLA, span, low, Tlow,
			              taut ? HAWSER_BRANCH_TAUT : HAWSER_BRANCH_SLACK);
			(taut ? (void)(worst = fmax(worst, fabs(back.H/H - 1.0)*flat))
			      : (void)(slack = fmax(slack, fabs(back.H/H - 1.0)*flat)));
			pairs += !taut;
		}
		if (st.l > 1.0001*hypot(1.0, slope)) { /* otherwise the round-off of the length changes H */
			back = solved(PARABOLA, span, HAWSER_GIVEN_LENGTH0, st.length0, 0);
			order = fmax(order, fabs(back.H/H - 1.0));
		}
	}
	ok(worst < 1e-13, "from sag and tensions: %.1e", worst);
	ok(pairs > 20 && slack < 1e-11, "slack ones, %d: %.1e", pairs, slack);
	ok(order < 1e-11, "from lengths: %.1e", order);
}

/* Ends, slope, tension, and the length of the curve as a sum of chords. */
static void profile(double delta, double slope)
{
	enum { pieces = 4000 };
	struct hawser_statics st = weighed(PARABOLA, delta, slope);
	struct hawser_profile_point a = hawser_statics_model(PARABOLA)->at(&st, 0.0), b = a, start = a;
	double off = 0.0, along = 0.0, steep = 0.0, tight = 0.0;

	for (int i = 1; i <= pieces; i++) {
		double x, y;

		b = hawser_statics_model(PARABOLA)->at(&st, st.length0*i/pieces);
		x = b.x/100.0;
		y = (slope - 0.5*delta)*x + 0.5*delta*x*x; /* B (2.93) */
		off = fmax(off, fabs(b.y/100.0 - y));
		steep = fmax(steep, fabs(b.slope - (slope - 0.5*delta + delta*x)));
		tight = fmax(tight, fabs(b.T/(st.H*hypot(1.0, b.slope)) - 1.0));
		along = fmax(along, fabs(hypot(b.x - a.x, b.y - a.y)*pieces/st.length0 - 1.0));
		a = b;
	}
	ok(start.x == 0.0 && start.y == 0.0 && b.x == 100.0 && b.y == 100.0*slope, "ends are met");
	ok(off < 1e-14*(1.0 + slope + delta) && steep < 1e-14*(1.0 + slope + delta) && tight < 1e-15,
	   "delta %g, slope %g: on the parabola %.1e, slope %.1e, tension %.1e", delta, slope, off,
	   steep, tight);
	/* a chord is shorter than its arc by the square of the angle over 24 */
	ok(along < 0.1*(delta*st.l/pieces)*(delta*st.l/pieces) + 1e-11,
	   "points stand at equal arclengths: %.1e", along);
	ok(st.closure < 1e-11, "closes: %.1e m", st.closure);
}

static void refused(int model, struct hawser_span span, enum hawser_given given, double value,
                    enum hawser_branch branch, enum hawser_status want, const char *words)
{
	struct hawser_statics st;
	struct hawser_report report = {.message = ""};
	enum hawser_status got = hawser_statics_model(model)->solve(&st, &span, given, value, branch,
	                                                            &report);

	ok(got == want && report.status == want && strstr(report.message, words),
	   "%s, saying \"%s\": %s", hawser_status_name(got), words, report.message);
}

static void refusals(void)
{
	struct hawser_span span = {1e8, 6.0, 9.81, 300.0, 400.0}; /* chord 500 m, W = 8829 N */
	enum hawser_status none = HAWSER_ERR_NO_SOLUTION, wrong = HAWSER_ERR_ARGUMENT;

	refused(PARABOLA, span, HAWSER_GIVEN_LENGTH0, 500.0, 0, none, "the chord is 500 m");
	refused(INEXTENSIBLE, span, HAWSER_GIVEN_LENGTH0, 499.0, 0, none, "chord is 500 m");
	refused(PARABOLA, span, HAWSER_GIVEN_T0, 5297.0, 0, none, "5297.4 N"); /* W*d/chord */
	refused(PARABOLA, span, HAWSER_GIVEN_T1, 8829.0, 0, none, "8829 N");
	refused(PARABOLA, span, HAWSER_GIVEN_T0, 8830.0, HAWSER_BRANCH_SLACK, none, "no slack");
	refused(PARABOLA, span, HAWSER_GIVEN_T1, 9000.0, HAWSER_BRANCH_SLACK, none, "lower end only");
	refused(PARABOLA, span, HAWSER_GIVEN_H, 1e-320, 0, none, "range of double");
	span.EA = -3.0; /* not used, and invalid */
	refused(PARABOLA, span, HAWSER_GIVEN_H, 1e4, 0, wrong, "EA is -3 N");
	refused(INEXTENSIBLE, span, HAWSER_GIVEN_H, 1e4, 0, wrong, "EA is -3 N");
	span.EA = 1e8;
	refused(PARABOLA, span, HAWSER_GIVEN_H, NAN, 0, wrong, "tension H is nan");
	refused(PARABOLA, span, HAWSER_GIVEN_H, 1e4, (enum hawser_branch)7, wrong, "branch");
}

CASE(property_statics_models)
{
	const struct hawser_statics_model *row;

	if (!ok(!strcmp(hawser_statics_model(CATENARY)->name, "catenary") &&
	        !strcmp(hawser_statics_model(INEXTENSIBLE)->name, "inextensible") &&
	        !strcmp(hawser_statics_model(PARABOLA)->name, "parabola"), "the table, the catenary first"))
		return done_testing();
	for (int i = 0; (row = hawser_statics_model(i)); i++)
		ok(row->summary && row->source && row->solve && row->at, "%s", row->name);
	orders();
	inclined();
	stretch();
	roundtrips();
	profile(0.37, 0.0);
	profile(1e-5, 0.62);
	profile(3.9, -2.385);
	refusals();
	return done_testing();
}

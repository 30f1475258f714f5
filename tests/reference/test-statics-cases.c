/* Statics against published spans and against limits with closed forms.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/statics-draw.h"
#include "tests/tap.h"

static struct hawser_statics solve(struct hawser_span span, enum hawser_given given, double value)
{
	struct hawser_statics st = {.H = NAN};
	struct hawser_report report = {.message = ""};

	if (hawser_statics_solve(&st, &span, given, value, HAWSER_BRANCH_TAUT, &report))
		ok(0, "%s", report.message);
	return st;
}

/* Catenaries from the test suites of mooring programs: x, z, unstretched length, EA, weight per
 * length; the tension components at the ends to the published digits. */
static void mooring(void)
{
	struct hawser_span deep = {7.51e12, 200.0, 1.0, 400.0, 200.0};
	struct hawser_span taut = {7e8, 3.08735, 1.0, 246.22420940032947, 263.55766330843164};
	struct hawser_statics st = solve(deep, HAWSER_GIVEN_LENGTH0, 500.0);

	ok(fabs(st.H - 43694.6) < 0.05, "(400, 200, 500): H %.3f against 43694.6 N", st.H);
	ok(fabs(st.V0 + 22365.6) < 0.05, "V at the lower end %.3f against -22365.6 N", st.V0);
	ok(fabs(st.V1 - 77634.4) < 0.05, "V at the upper end %.3f against 77634.4 N", st.V1);
	st = solve(taut, HAWSER_GIVEN_LENGTH0, 360.63566262396927);
	ok(fabs(st.H - 58377.24) < 0.005, "nearly taut: H %.4f against 58377.24 N", st.H);
}

/* The chairlift span, B Table 4.2, and B Table 4.5: equilibrium of the whole cable and of its
 * halves, and the parabola's figures nearby. */
static void ropeway(void)
{
	struct hawser_span chairlift = {400e6, 6.0, 9.81, 250.0, 10.0};
	struct hawser_span hauling = {400e6, 5.0, 9.81, 300.0, 10.0};
	struct hawser_statics st = solve(chairlift, HAWSER_GIVEN_T0, 80e3);
	struct hawser_profile_point half = hawser_statics_at(&st, 0.5*st.length0);

	close_to(st.V1 - st.V0, 6.0*9.81*st.length0, 1e-14, "Table 4.2: the ends carry the weight");
	close_to(half.T*half.T - st.H*st.H, 0.25*(st.V0 + st.V1)*(st.V0 + st.V1), 1e-11,
	         "and the middle its half");
	close_to(st.sag, 6.0*9.81*250.0*250.0/(8.0*st.H)*hypot(1.0, 0.04), 1e-3,
	         "sag near the parabola's w*d^2/(8 H cos(theta))");
	close_to(st.irvine*st.irvine, pow(st.delta, 2)/st.epsilon, 2e-2, "lambda^2, nearly level");
	st = solve(hauling, HAWSER_GIVEN_H, 100e3);
	close_to(st.epsilon, 2.5e-4, 1e-15, "Table 4.5: epsilon");
	close_to(st.delta, 0.14715, 1e-14, "delta");
	close_to(st.irvine_source, st.irvine, 5e-3, "Irvine's parameter, nearly level, either way");
}

/* Level parabola: sag = w*d^2/(8 H), and the next term of the inextensible catenary,
 * sag/d = delta/8*(1 + delta^2/48 + ...). */
static void parabola(void)
{
	for (double delta = 1e-1; delta > 1e-7; delta *= 0.1) {
		struct hawser_span span = {INFINITY, 2.385, 9.81, 137.0, 0.0};
		double w = span.rho*span.g, H = w*span.d/delta;
		struct hawser_statics st = solve(span, HAWSER_GIVEN_H, H);
		double want = span.d*delta/8.0*(1.0 + delta*delta/48.0);

		ok(fabs(st.sag/want - 1.0) <= delta*delta*delta*delta/5000.0 + 1e-15,
		   "parabola at delta %.0e: %.15g against %.15g", delta, st.sag, want);
		ok(isinf(st.irvine) && st.length == st.length0, "inextensible");
	}
}

/* EA = 1e14 N against infinite EA, for a given length: the difference is of order epsilon. */
static void inextensible(void)
{
	struct hawser_span stiff = {1e14, 3.0, 9.81, 100.0, 33.0}, rigid = stiff;
	struct hawser_statics a, b;

	rigid.EA = INFINITY;
	a = solve(stiff, HAWSER_GIVEN_LENGTH0, 130.0);
	b = solve(rigid, HAWSER_GIVEN_LENGTH0, 130.0);
	ok(b.epsilon == 0.0, "epsilon is 0");
	close_to(a.H, b.H, 1e-10, "H");
	close_to(a.T1, b.T1, 1e-10, "T1");
	close_to(a.sag, b.sag, 1e-10, "sag");
	close_to(hawser_statics_at(&a, 50.0).y, hawser_statics_at(&b, 50.0).y, 1e-10, "y");
	close_to(b.T1 - b.T0, 3.0*9.81*33.0, 1e-12, "T1 - T0 = w*h on an inextensible cable");
}

/* A nearly weightless cord: T = EA*(chord/L - 1), and Irvine's parameter with Le = L. */
static void light_cord(void)
{
	struct hawser_span cord = {1e4, 1e-9, 9.81, 30.0, 40.0};
	struct hawser_statics st = solve(cord, HAWSER_GIVEN_LENGTH0, 40.0);

	close_to(st.T0, 1e4*(50.0/40.0 - 1.0), 1e-9, "a light cord stretched by a quarter: T0");
	close_to(st.H, 0.6*2500.0, 1e-9, "H");
	close_to(st.length, 50.0, 1e-9, "length");
	close_to(st.irvine*st.irvine, pow(st.delta, 2)*pow(0.6, 2)/st.epsilon/(40.0/30.0), 1e-9,
	         "lambda^2 = (w cos c/Tc)^2 c EA/(Tc L0)");
}

CASE(reference_statics_cases)
{
	mooring();
	ropeway();
	parabola();
	inextensible();
	light_cord();
	return done_testing();
}

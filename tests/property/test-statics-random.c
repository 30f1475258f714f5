/* Statics on random spans: every given quantity leads back to the same state; mirror image; change
 * of units; monotonicity that the searches rely on; field equations along the profile; order of
 * convergence to the inextensible limit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/statics-draw.h"
#include "tests/tap.h"

static const char *const givens[] = {"", "H", "T0", "T1", "length0", "sag"};

static int from_H(struct hawser_statics *st, const struct hawser_span *span, double H)
{
	return !hawser_statics_solve(st, span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL);
}

static double away(double got, double want)
{
	return got == want ? 0.0 : fabs(got/want - 1.0);
}

/* 20000 spans, a million when HAWSER_LONG is set. */
static void round_trips(void)
{
	int spans = getenv("HAWSER_LONG") ? 1000000 : 20000;
	double error[6] = {0.0}, closure[6] = {0.0}, e;
	int failed[6] = {0}, most[6] = {0};
	struct hawser_statics st, back;
	struct hawser_span span;

	for (int n = 0; n < spans; n++) {
		double H = draw_span(&span);

		if (!from_H(&st, &span, H)) {
			failed[HAWSER_GIVEN_H]++;
			continue;
		}
		for (int g = HAWSER_GIVEN_H; g <= HAWSER_GIVEN_SAG; g++) {
			enum hawser_given given = (enum hawser_given)g;
			double value = value_of(&st, given);

			if (hawser_statics_solve(&back, &span, given, value, branch_of(&st, given), NULL)) {
				failed[g]++;
				continue;
			}
			e = away(value_of(&back, given), value);
			error[g] = e <= error[g] ? error[g] : e;
			e = draw_closure(&back);
			closure[g] = e <= closure[g] ? closure[g] : e;
			most[g] = back.iterations > most[g] ? back.iterations : most[g];
		}
	}
	for (int g = HAWSER_GIVEN_H; g <= HAWSER_GIVEN_SAG; g++) {
		ok(failed[g] == 0, "%d spans from %s: %d failed", spans, givens[g], failed[g]);
		ok(error[g] < 1e-13, "the given %s is met to %.1e", givens[g], error[g]);
		ok(closure[g] < 1e-12, "both ends to %.1e of the chord", closure[g]);
		ok(most[g] < 400, "iterations: %d at most", most[g]);
	}
}

/* The mirror image, and other units. */
static void symmetries(void)
{
	double mirror = 0.0, units = 0.0;
	struct hawser_span span, other;
	struct hawser_statics a, b;

	for (int n = 0; n < 2000; n++) {
		double H = draw_span(&span);

		other = span;
		other.h = -span.h;
		if (!from_H(&a, &span, H) || !from_H(&b, &other, H))
			mirror = NAN;
		mirror += (a.T0 != b.T1) + (a.V0 != -b.V1) + (a.length0 != b.length0) + (a.sag != b.sag);
		other = span; /* metres to halves, newtons to eighths: exact in binary */
		other.EA *= 8.0;
		other.rho *= 4.0;
		other.d *= 2.0;
		other.h *= 2.0;
		if (!from_H(&b, &other, 8.0*H))
			units = NAN;
		units += (b.T0 != 8.0*a.T0) + (b.length0 != 2.0*a.length0) + (b.eta != a.eta)
		         + (b.irvine != a.irvine);
	}
	ok(mirror == 0.0, "a span and its mirror image agree to the last bit");
	ok(units == 0.0, "other units change nothing");
}

/* One span over 14 decades of H: length0 and sag decrease, T0 and T1 have one minimum. */
static void shape_of_the_problem(void)
{
	int rises = 0, turns = 0, spans = 0;
	struct hawser_span span;
	struct hawser_statics st, last;

	for (int n = 0; n < 400; n++) {
		double w, up0 = 0.0, up1 = 0.0;
		int started = 0;

		draw_span(&span);
		if (n % 4 == 0)
			span.EA = INFINITY;
		w = span.rho*span.g*span.d;
		spans++;
		for (double H = 3e-3*w; H < 1e9*w; H *= 1.31) {
			if (!from_H(&st, &span, H))
				continue;
			if (started) {
				rises += st.length0 > last.length0*(1.0 + 1e-14) || st.sag >= last.sag;
				turns += up0 > 0.0 && st.T0 < last.T0*(1.0 - 1e-14);
				turns += up1 > 0.0 && st.T1 < last.T1*(1.0 - 1e-14);
				up0 = st.T0 > last.T0*(1.0 + 1e-14) ? 1.0 : up0;
				up1 = st.T1 > last.T1*(1.0 + 1e-14) ? 1.0 : up1;
			}
			last = st;
			started = 1;
		}
	}
	ok(rises == 0, "length0 and sag never rise with H (%d spans)", spans);
	ok(turns == 0, "T0 and T1 never fall again once they rise");
}

/* Positions by Gauss quadrature of dx = e*(1 + strain)*dS from end A to each of 8 points, and the
 * largest distance from the chord by a search. */
static void field_equations(void)
{
	static const double node[] = {-0.9061798459386640, -0.5384693101056831, 0.0,
	                              0.5384693101056831, 0.9061798459386640};
	static const double weight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
	                                0.4786286704993665, 0.2369268850561891};
	enum { PANELS = 4096 };
	double worst = 0.0, sag_error = 0.0;
	struct hawser_span span;
	struct hawser_statics st;

	for (int n = 0; n < 40; n++) {
		double H = draw_span(&span), x = 0.0, y = 0.0, sag = 0.0, step;

		if (!from_H(&st, &span, fmax(H, 0.2*span.rho*span.g*span.d)))
			continue;
		step = st.l/PANELS;
		for (int i = 0; i < PANELS; i++) {
			struct hawser_profile_point point = hawser_statics_at(&st, i*step*span.d);

			worst = fmax(worst, hypot(point.x/span.d - x, point.y/span.d - y)
			             /hypot(1.0, st.hs));
			sag = fmax(sag, point.x*st.hs - point.y);
			for (int k = 0; k < 5; k++) {
				struct hawser_frame_point f =
					hawser_statics_frame(&st, step*(i + 0.5 + 0.5*node[k]));

				x += 0.5*step*weight[k]*(1.0 + f.strain)*f.ex;
				y += 0.5*step*weight[k]*(1.0 + f.strain)*f.ey;
			}
		}
		if (st.delta > 1e-3)
			sag_error = fmax(sag_error, away(sag, st.sag));
	}
	ok(worst < 1e-11, "the profile is the integral of its tangent: %.1e of the chord", worst);
	ok(sag_error < 1e-4, "the sag is the largest distance from the chord: %.1e", sag_error);
}

/* H(length0) of an elastic cable converges to that of the inextensible one with order 1 in 1/EA;
 * the sag converges to that of the parabola with order 2 in delta. */
static void orders(void)
{
	struct hawser_span span = {INFINITY, 2.385, 9.81, 173.0, 41.0}, level = span;
	struct hawser_statics st;
	double H, error[2];

	(void)!hawser_statics_solve(&st, &span, HAWSER_GIVEN_LENGTH0, 200.0, HAWSER_BRANCH_TAUT, NULL);
	H = st.H;
	for (int i = 0; i < 2; i++) {
		span.EA = i ? 4e8 : 1e8;
		(void)!hawser_statics_solve(&st, &span, HAWSER_GIVEN_LENGTH0, 200.0, HAWSER_BRANCH_TAUT,
		                            NULL);
		error[i] = fabs(st.H - H);
	}
	close_to(log(error[0]/error[1])/log(4.0), 1.0, 1e-3, "inextensible limit: order");
	level.h = 0.0;
	for (int i = 0; i < 2; i++) {
		double delta = i ? 0.01 : 0.04;

		if (!from_H(&st, &level, level.rho*level.g*level.d/delta))
			st.sag = NAN;
		error[i] = away(st.sag, level.d*delta/8.0);
	}
	close_to(log(error[0]/error[1])/log(4.0), 2.0, 1e-3, "parabola: order");
}

CASE(property_statics_random)
{
	round_trips();
	symmetries();
	shape_of_the_problem();
	field_equations();
	orders();
	return done_testing();
}

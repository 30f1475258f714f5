/* A cable with point masses: a published case, the equilibrium by quadrature of the differential
 * equation, every given quantity, mirror images, limits, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/statics.h>
#include <stdlib.h>

#include "tests/tap.h"

static struct hawser_report report;

static double uniform(double from, double to)
{
	return from + (to - from)*(rand()/(RAND_MAX + 1.0));
}

/* Jayaraman, Knudson, Computers & Structures 14 (1981) 175: a cable of two parts that hangs between
 * level ends 1000 ft apart, and the displacement of the node between them by a load of 8 kip. */
static void published(void)
{
	const double ft = 0.3048, lb = 4.4482216152605, g = 9.81;
	const double parts[] = {412.8837*ft, 613.0422*ft};
	struct hawser_span span = {0.85*19e6*lb, 3.16*lb/ft/g, g, 1000.0*ft, 0.0};
	struct hawser_attachment node = {.at = parts[0], .by_length = 1, .mass = 8000.0*lb/g};
	struct hawser_statics bare, loaded;
	struct hawser_profile_point a, b;

	if (!ok(!hawser_statics_solve(&bare, &span, HAWSER_GIVEN_LENGTH0, parts[0] + parts[1],
	                              HAWSER_BRANCH_TAUT, &report) &&
	        !hawser_statics_loaded(&loaded, &span, HAWSER_GIVEN_LENGTH0, parts[0] + parts[1],
	                               HAWSER_BRANCH_TAUT, &node, 1, &report), "the case is solved"))
		return;
	a = hawser_statics_at(&bare, parts[0]);
	b = hawser_statics_at(&loaded, parts[0]);
	ok(fabs((b.x - a.x)/ft + 2.8194) < 6e-4, "horizontal displacement %.4f ft (published -2.8194)",
	   (b.x - a.x)/ft);
	ok(fabs((b.y - a.y)/ft + 18.4567) < 6e-4, "vertical displacement %.4f ft (published -18.4567)",
	   (b.y - a.y)/ft);
}

/* Distance of the end from B by Simpson's rule with 400 intervals between masses, relative to the
 * length; no formula is shared with the library. */
static double miss(const struct hawser_statics *st, const struct hawser_span *span)
{
	enum { N = 400 };
	double V = st->V0, S = 0.0, x = 0.0, y = 0.0;

	for (int i = 0; i <= st->attachments; i++) {
		double end = i < st->attachments ? st->attached[i].S : st->length0, h = (end - S)/N;

		for (int k = 0; k <= N; k++) {
			double v = V + span->rho*span->g*k*h, T = sqrt(st->H*st->H + v*v);
			double w = h/3.0*(k == 0 || k == N ? 1.0 : k%2 ? 4.0 : 2.0);

			x += w*(1.0/span->EA + 1.0/T)*st->H;
			y += w*(1.0/span->EA + 1.0/T)*v;
		}
		V += span->rho*span->g*(end - S);
		if (i < st->attachments)
			V += span->g*st->attached[i].mass;
		S = end;
	}
	return hypot(x - span->d, y - span->h)/st->length0;
}

static double worst(double a, double b)
{
	return a > b || isnan(a) ? a : b;
}

/* Largest relative difference of the solution from that for `given`, whose value it has. */
static double again(const struct hawser_statics *st, const struct hawser_span *span,
                    const struct hawser_attachment *attach, int count, enum hawser_given given)
{
	double value = given == HAWSER_GIVEN_H ? st->H : given == HAWSER_GIVEN_T0 ? st->T0
	               : given == HAWSER_GIVEN_T1 ? st->T1 : given == HAWSER_GIVEN_LENGTH0 ? st->length0
	               : st->sag;
	struct hawser_statics other;
	double error;

	if (hawser_statics_loaded(&other, span, given, value, HAWSER_BRANCH_TAUT, attach, count,
	                          &report)) {
		printf("# %s\n", report.message);
		return INFINITY;
	}
	error = fabs(other.H/st->H - 1.0);
	error = worst(error, fabs(other.length0/st->length0 - 1.0));
	return error/(1e3*(st->error + other.error));
}

static void random_spans(int count)
{
	double off = 0.0, closure = 0.0, same = 0.0, mirror = 0.0, sag = 0.0;

	srand(2385);
	for (int i = 0; i < count; i++) {
		struct hawser_span span = {pow(10.0, uniform(5.5, 9.0)), uniform(0.5, 20.0), 9.81,
		                           uniform(50.0, 500.0), 0.0};
		struct hawser_attachment attach[5] = {{0}}, other[5] = {{0}};
		double chord, H = span.rho*span.g*span.d*uniform(0.6, 12.0), turned;
		struct hawser_statics st, back;
		int n = 1 + i%5;

		span.h = span.d*uniform(-1.0, 1.0);
		for (int k = 0; k < n; k++) {
			attach[k].at = (k + uniform(0.2, 0.9))/n;
			attach[k].mass = span.rho*span.d*uniform(0.0, 0.5);
			other[k] = attach[k];
			other[k].at = 1.0 - attach[k].at;
		}
		if (!ok(!hawser_statics_loaded(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, attach, n,
		                               &report), "span %d", i))
			continue;
		off = worst(off, miss(&st, &span));
		chord = st.closure/st.length;
		closure = worst(closure, chord);
		for (enum hawser_given given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++)
			same = worst(same, again(&st, &span, attach, n, given));
		for (int p = 1; p < 200; p++) {
			struct hawser_profile_point at = hawser_statics_at(&st, st.length0*p/200.0);

			sag = worst(sag, (span.h/span.d*at.x - at.y)/st.sag - 1.0);
		}
		span.h = -span.h;
		turned = hawser_statics_loaded(&back, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, other, n,
		                               &report) ? INFINITY : fabs(back.T1/st.T0 - 1.0);
		mirror = worst(mirror, turned);
	}
	ok(off < 3e-9, "the ends close by quadrature, %.1e of the length", off);
	ok(closure < 1e-14, "the profile closes, %.1e of the length", closure);
	ok(same < 1.0, "every given quantity has the same equilibrium, %.2f of a thousand errors", same);
	ok(mirror < 1e-12, "mirror images agree, %.1e", mirror);
	ok(sag < 1e-13 , "no point is further from the chord than the sag, %.1e", sag);
}

/* Light masses change nothing, and masses without weight nothing at all. */
static void limits(void)
{
	const struct hawser_span span = {4e8, 6.0, 9.81, 250.0, 61.7};
	struct hawser_attachment a[2] = {{.at = 0.23, .mass = 1e-13}, {.at = 101.7, .by_length = 1}};
	struct hawser_statics bare, st;

	a[1].damper[1] = 2385.0;
	if (!ok(!hawser_statics_solve(&bare, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_TAUT, &report) &&
	        !hawser_statics_loaded(&st, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_TAUT, a, 2,
	                               &report), "light masses: %s", report.message))
		return;
	close_to(st.H, bare.H, 1e-14, "H");
	close_to(st.length0, bare.length0, 1e-14, "length");
	close_to(st.sag, bare.sag, 1e-12, "sag");
	close_to(st.length, bare.length, 1e-14, "stretched length");
	ok(st.attachments == 2 && st.attached[0].index == 0 && st.attached[1].S == 101.7,
	   "they are sorted");
	a[0].mass = 0.0;
	ok(!hawser_statics_loaded(&st, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_TAUT, a, 2, &report) &&
	   st.H == bare.H && st.length0 == bare.length0 && st.attachments == 2,
	   "a damper leaves the equilibrium as it is");
}

static void refusals(void)
{
	const struct hawser_span span = {4e8, 6.0, 9.81, 250.0, 61.7};
	struct hawser_attachment a[2] = {{.at = 0.5, .mass = 300.0}, {.at = 1000.0, .by_length = 1}};
	struct hawser_statics st;
	enum hawser_status status;

	a[1].mass = 2.0;
	status = hawser_statics_loaded(&st, &span, HAWSER_GIVEN_H, 8e4, HAWSER_BRANCH_TAUT, a, 2,
	                               &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "attach[1]"), "beyond the end: %s",
	   report.message);
	status = hawser_statics_loaded(&st, &span, HAWSER_GIVEN_T0, 2e3, HAWSER_BRANCH_TAUT, a, 1,
	                               &report);
	ok(status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "least"), "too little tension: %s",
	   report.message);
	a[1] = a[0];
	status = hawser_statics_loaded(&st, &span, HAWSER_GIVEN_H, 8e4, HAWSER_BRANCH_TAUT, a, 2,
	                               &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "same point"), "one point: %s",
	   report.message);
	status = hawser_statics_loaded(&st, &span, HAWSER_GIVEN_H, 8e4, HAWSER_BRANCH_TAUT, a, 33,
	                               &report);
	ok(status == HAWSER_ERR_ARGUMENT, "too many: %s", report.message);
}

CASE(property_statics_loaded)
{
	published();
	random_spans(40);
	limits();
	refusals();
	return done_testing();
}

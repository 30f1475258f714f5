/* tests/extremes/test-irvine.c - invalid sweeps of the tension, and difficult stations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/irvine.h>

#include "tests/tap.h"

static const struct hawser_span usual = {40e6, 6.0, 9.81, 100.0, 0.0};

static void refused(enum hawser_status want, const char *words, struct hawser_span span,
                    struct hawser_irvine_options options)
{
	struct hawser_irvine irvine;
	struct hawser_report report = {0};
	enum hawser_status status = hawser_irvine_trace(&irvine, &span, &options, &report);

	ok(status == want && strstr(report.message, words), "%s: %s", hawser_status_name(status),
	   report.message);
	ok(!irvine.omega && !irvine.station && irvine.branches == 0, "and nothing is left behind");
	if (!status)
		hawser_irvine_clear(&irvine);
}

static void failures(void)
{
	struct hawser_span span = usual;
	const double H = 30e3;

	refused(HAWSER_ERR_ARGUMENT, "branches", span, (struct hawser_irvine_options){.n = -1});
	refused(HAWSER_ERR_ARGUMENT, "branches", span, (struct hawser_irvine_options){.n = 501});
	refused(HAWSER_ERR_ARGUMENT, "points", span, (struct hawser_irvine_options){.points = 1});
	refused(HAWSER_ERR_ARGUMENT, "from 30000 to 30000", span,
	        (struct hawser_irvine_options){.from = H, .to = H});
	refused(HAWSER_ERR_ARGUMENT, "positive", span, (struct hawser_irvine_options){.from = -H});
	refused(HAWSER_ERR_ARGUMENT, "positive", span,
	        (struct hawser_irvine_options){.from = NAN, .to = H});
	refused(HAWSER_ERR_ARGUMENT, "correlation", span,
	        (struct hawser_irvine_options){.correlation = 0.3});
	refused(HAWSER_ERR_ARGUMENT, "gap", span, (struct hawser_irvine_options){.crossing = 0.1});
	refused(HAWSER_ERR_ARGUMENT, "no method", span,
	        (struct hawser_irvine_options){.method = "nosuch"});
	refused(HAWSER_ERR_ARGUMENT, "does not change", span,
	        (struct hawser_irvine_options){.from = H, .to = H*(1.0 + 1e-15), .points = 50});
	refused(HAWSER_ERR_NO_SOLUTION, "least", span,
	        (struct hawser_irvine_options){.sweep = HAWSER_GIVEN_T0, .from = H, .to = 1.0});
	refused(HAWSER_ERR_CONVERGENCE, "relative error", span,
	        (struct hawser_irvine_options){.tolerance = 1e-17});
	span.EA = INFINITY;
	refused(HAWSER_ERR_NO_SOLUTION, "inextensible", span, (struct hawser_irvine_options){0});
	refused(HAWSER_ERR_NO_SOLUTION, "inextensible", span,
	        (struct hawser_irvine_options){.from = 2.0*H, .to = H});
	span.EA = 1e3;
	refused(HAWSER_ERR_NO_SOLUTION, "no default range", span, (struct hawser_irvine_options){0});
	span.d = -1.0;
	refused(HAWSER_ERR_ARGUMENT, "d", span, (struct hawser_irvine_options){0});
	hawser_irvine_clear(NULL);
	ok(isnan(hawser_irvine_value(&(struct hawser_statics){.H = 1.0}, HAWSER_GIVEN_NONE)),
	   "no quantity has no value");
}

/* A station on a crossing, where the shapes are undetermined: it is shifted, and no branches are
 * exchanged. */
static void on_a_crossing(void)
{
	struct hawser_irvine_options options = {.from = 60e3, .to = 20e3, .points = 11, .n = 4};
	struct hawser_irvine irvine, again;
	double H, moved = 0.0;
	int last, same = 1;

	if (!ok(!hawser_irvine_trace(&irvine, &usual, &options, NULL) && irvine.crossovers > 0,
	        "a level span has a crossing"))
		return;
	H = irvine.crossover[0].H;
	last = irvine.stations - 1;
	options.points = 3;
	options.from = 2.0*H;
	options.to = 0.5*H;
	if (ok(!hawser_irvine_trace(&again, &usual, &options, NULL), "a station on it")) {
		for (int i = 0; i < again.stations; i++)
			moved = fmax(moved, fabs(again.station[i].moved));
		ok(moved > 0.0 && moved < 1e-4, "steps aside by %.1e", moved);
		ok(again.crossovers > 0 && again.crossover[0].kind == HAWSER_CROSSING &&
		   fabs(again.crossover[0].H/H - 1.0) < 1e-10, "and the crossing is found again");
		for (int b = 0; b < irvine.in_plane; b++)
			same &= irvine.symmetry[last*irvine.branches + b] ==
			        again.symmetry[(again.stations - 1)*again.branches + b];
		ok(same, "with the same branches after it");
		hawser_irvine_clear(&again);
	}
	hawser_irvine_clear(&irvine);
}

/* Ranges that are limited by the strain and by a minimum of T0. */
static void cut_ranges(void)
{
	struct hawser_span heavy = {1e6, 30.0, 9.81, 100.0, 0.0};
	struct hawser_irvine_options options = {.sweep = HAWSER_GIVEN_T0, .points = 12, .n = 6};
	struct hawser_irvine irvine;
	double from, to, least;

	ok(!hawser_irvine_range(&from, &to, &heavy, HAWSER_GIVEN_H, NULL), "a heavy soft cable");
	close_to(from, 0.1*heavy.EA, 1e-12, "begins where its strain is 0.1");
	ok(!hawser_irvine_range(&from, &least, &heavy, HAWSER_GIVEN_T0, NULL) && least < from,
	   "and by T0 it ends");
	if (ok(!hawser_irvine_trace(&irvine, &heavy, &options, NULL), "where a sweep by T0 can end")) {
		ok(irvine.station[irvine.stations - 1].statics.H > to, "before the least T0");
		hawser_irvine_clear(&irvine);
	}
}

/* Deep sag, several elements; almost inextensible; many branches; steep. */
static void hard(void)
{
	const struct {
		struct hawser_span span;
		struct hawser_irvine_options options;
	} all[] = {
		{{1e8, 5.0, 9.81, 100.0, 0.0}, {.from = 5e4, .to = 400.0, .points = 40, .n = 6}},
		{{1e8, 5.0, 9.81, 100.0, 40.0}, {.from = 5e4, .to = 400.0, .points = 40, .n = 6}},
		{{1e14, 5.0, 9.81, 100.0, 25.0}, {.points = 40, .n = 10}},
		{{40e6, 6.0, 9.81, 100.0, 0.0}, {.points = 60, .n = 40}},
		{{40e6, 6.0, 9.81, 100.0, 1000.0}, {.points = 40, .n = 10}},
	};

	for (size_t i = 0; i < sizeof all/sizeof *all; i++) {
		struct hawser_irvine irvine;
		struct hawser_report report = {0};
		enum hawser_status status = hawser_irvine_trace(&irvine, &all[i].span, &all[i].options,
		                                                &report);
		int bad = 0;

		if (!ok(!status, "hard case %zu %s", i + 1, report.message))
			continue;
		for (int k = 0; k < irvine.stations*irvine.branches; k++)
			bad += !(irvine.omega[k] > 0.0);
		ok(bad == 0, "%d branches, %d stations, %d crossovers, %d solutions", irvine.branches,
		   irvine.stations, irvine.crossovers, irvine.solves);
		hawser_irvine_clear(&irvine);
	}
}

CASE(extremes_irvine)
{
	failures();
	on_a_crossing();
	cut_ranges();
	hard();
	return done_testing();
}

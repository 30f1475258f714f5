/* Traces of branches over the tension (Irvine) and over the speed (Campbell), with every pair of
 * parameters varied up to their limits.
 *
 * Each trace is compared with separate modal solutions at its stations, the index theorem, closed forms
 * for small sag, a trace of twice the steps, and a trace in the opposite direction. Each crossover is
 * compared with modes at it and near it (traces-check.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define SHOOT_LONG_DOUBLE
#include "tests/extremes/traces-judge.h"

#define COUNT(a) ((int)(sizeof(a)/sizeof(a)[0]))

static const double epsilons[] = {1e-14, 1e-11, 1e-8, 1e-6, 1e-4, 1e-2, 0.5};
static const double deltas[] = {1e-9, 1e-6, 1e-3, 0.03, 0.3, 3.0};
static const double extents[] = {1.0 + 1e-15, 1.0 + 1e-13, 1.0 + 1e-9, 1.001, 3.0, 30.0, 1e3};
static const double slopes[] = {-50.0, -1.0, -1e-6, 0.0, 1e-12, 1e-9, 0.04, 0.3, 3.0, 20.0, 1e3};
static const double counts[] = {1.0, 2.0, 7.0, 16.0, 40.0};
static const double points[] = {2.0, 3.0, 12.0, 100.0, 2000.0};
static const double quantities[] = {1.0, 2.0, 3.0, 4.0, 5.0};
static const double paces[] = {0.0, 1e-6, 0.3, 2.0};

static const double weights[] = {1e-6, 1e-4, 1e-2, 0.1, 1.0};
static const double slants[] = {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 3.0};
static const double which[] = {1.0, 2.0, 3.0, 5.0};
static const double asides[] = {-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 4e-16, 1e-11, 1e-8, 1e-4};
static const double where[] = {0.0, 1.0, 2.0};
static const double flat[] = {1e-9, 1e-7, 1e-5, 1e-3};
static const double lambdas[] = {1e-2, 1.0, 10.0, 100.0};
static const double widths[] = {1.0 + 1e-9, 3.0, 30.0};
static const double begins[] = {0.0, 1e-9, 1e-3, 0.3, 0.9, 1.0 - 1e-6, 1.0 - 1e-8};
static const double ends[] = {1e-6, 0.3, 0.9, 0.999, 1.0 - 1e-6, 1.0 - 1e-9, 1.0, 2.0};
static const double softness[] = {1e-14, 1e-11, 1e-8, 1e-6, 1e-4, 1e-2, 0.5};
static const double tensions[] = {0.8, 1.0, 3.0, 30.0, 1e3, 1e6, 1e9};
static const double steps[] = {2.0, 3.0, 7.0, 30.0, 200.0};
static const double holds[] = {0.0, 1.0};

/* For a pair of axes: number of points, and number of tested points, which selects the check. */
static int counted, turn_of;

/* As sweep_left_out, but the count restarts for each pair of axes, so that every pair has a point. */
static int left_out(int few, int many)
{
	int of = sweep_long() ? many : few;

	return counted++ % of != 5 % of;
}

/* A trace that takes more than a second is for HAWSER_LONG. */
static int heavy(double branches, double stations)
{
	return !sweep_long() && (branches > 16.0 || stations > 100.0);
}

/* --- the tension --- */

/* x: strain and weight over tension at the start, ratio of the tensions at start and end, slope,
 * branches, points, quantity, speed over the wave speed at the end. */
static void irvine(struct sweep_point *point, const double *x, void *unused)
{
	struct hawser_span span = {INFINITY, 6.0, 9.81, 100.0, x[3]*100.0};
	double weight = span.rho*span.g*span.d, taut = weight/x[1], slack = taut/x[2];
	struct hawser_irvine_options o = {.sweep = (enum hawser_given)(int)x[6], .n = (int)x[4],
	                                  .points = (int)x[5]};
	struct hawser_irvine result;
	struct hawser_statics st;
	int nth;

	(void)unused;
	point->skip = x[1]*x[2] > (x[7] != 0.0 ? 5.0 : sweep_long() ? 30.0 : 10.0) ||
	              (x[7] != 0.0 && (x[4] > 7.0 || x[5] > 100.0)) || heavy(x[4], x[5]) ||
	              left_out(17, 3);
	if (point->skip)
		return;
	nth = turn_of++;
	span.EA = taut/x[0];
	o.speed = x[7]*sqrt(slack/span.rho);
	point->status = hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, taut, HAWSER_BRANCH_TAUT,
	                                     &point->report);
	o.from = hawser_irvine_value(&st, o.sweep);
	if (!point->status)
		point->status = hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, slack,
		                                     HAWSER_BRANCH_TAUT, &point->report);
	o.to = hawser_irvine_value(&st, o.sweep);
	if (nth % 2) {
		o.to = o.from;
		o.from = hawser_irvine_value(&st, o.sweep);
	}
	if (!point->status)
		point->status = hawser_irvine_trace(&result, &span, &o, &point->report);
	if (point->status)
		return;
	judge_irvine(point, &result, &o, nth);
	hawser_irvine_clear(&result);
}

/* --- stations on crossings --- */

static double apart(double H, double to)
{
	return fabs(H/to - 1.0);
}

/* Position of the crossover nearest to H (on a level span, the crossing); 0: none. *found is the
 * crossover. */
static double locate(struct hawser_irvine_crossover *found, const struct hawser_irvine *irvine,
                     double H)
{
	double best = 0.0;

	for (int i = 0; i < irvine->crossovers; i++)
		if ((irvine->span.h != 0.0 || irvine->crossover[i].kind == HAWSER_CROSSING) &&
		    (best == 0.0 || apart(irvine->crossover[i].H, H) < apart(best, H))) {
			*found = irvine->crossover[i];
			best = found->H;
		}
	return best;
}

/* x: weight over tension, slope, index of the crossover, distance of a station from it, and index of
 * that station (middle, first, last). A level span of small sag has its crossovers at
 * lambda = 2 n pi, up to terms of order delta^2 (Irvine). */
static void crossing(struct sweep_point *point, const double *x, void *unused)
{
	struct hawser_span span = {INFINITY, 6.0, 9.81, 100.0, x[1]*100.0};
	double weight = span.rho*span.g*span.d, lambda = 2.0*M_PI*x[2], H = weight/x[0], at, place;
	struct hawser_irvine_options o = {.from = 1.9*H, .to = 0.55*H, .n = 4*(int)x[2] + 3,
	                                  .points = 2};
	struct hawser_irvine_crossover known = {0};
	struct hawser_irvine result;

	(void)unused;
	point->skip = left_out(17, 3);
	if (point->skip)
		return;
	span.EA = H*lambda*lambda/(x[0]*x[0]);
	point->status = hawser_irvine_trace(&result, &span, &o, &point->report);
	if (point->status)
		return;
	at = locate(&known, &result, H);
	judge_irvine(point, &result, &o, turn_of++);
	hawser_irvine_clear(&result);
	point->skip = at == 0.0 && x[1] != 0.0;
	if (point->skip || isnan(point->error))
		return;
	if (x[1] == 0.0 && (known.kind != HAWSER_CROSSING ||
	                    fabs(weight/at*sqrt(span.EA/at)/lambda - 1.0) > 0.1*x[0]*x[0] + 1e-11))
		trace_wrong(point, "the crossover is a %s at lambda/2n pi - 1 = %.3e",
		            hawser_crossover_name(known.kind), weight/at*sqrt(span.EA/at)/lambda - 1.0);
	if (fabs(x[1]*x[0]) >= 1e-8 && known.kind == HAWSER_CROSSING)
		trace_wrong(point, "branches cross on a slope, gap %.3e", known.relative_gap);
	place = at*(1.0 + x[3]);
	o.from = x[4] == 1.0 ? place : 2.0*place;
	o.to = x[4] == 2.0 ? place : 0.5*place;
	o.points = x[4] == 0.0 ? 3 : 2;
	point->status = hawser_irvine_trace(&result, &span, &o, &point->report);
	if (point->status)
		return;
	judge_irvine(point, &result, &o, turn_of++);
	/* the position of a veering is known to 1e-5 of its width, which is proportional to its gap */
	if (x[4] == 0.0 && !(apart(locate(&known, &result, at), at) <= 1e-10 + 2e-5*known.relative_gap))
		trace_wrong(point, "with a station beside it the crossover at %.17g moves to %.17g", at,
		            known.H);
	hawser_irvine_clear(&result);
}

/* Irvine's closed form for a level span of small sag. With y = omega d sqrt(rho/H)/2, the antisymmetric
 * in-plane modes have y = n pi, the symmetric ones tan y = y - 4 y^3/lambda^2, and all out-of-plane
 * modes y = n pi/2. Returns the relative distance of y from the nearest of these. */
static double parabola(double y, double lambda, enum hawser_symmetry symmetry)
{
	double a, b, n = floor(y/M_PI + 0.5);

	if (symmetry == HAWSER_ANTISYMMETRIC)
		return fabs(y/(M_PI*fmax(n, 1.0)) - 1.0);
	/* sin y = (y - 4 y^3/lambda^2) cos y, by bisection between the zeros of the cosine */
	a = fmax(1e-3, (n - 0.5)*M_PI);
	b = (n + 0.5)*M_PI;
	for (int i = 0; i < 100; i++) {
		double c = 0.5*(a + b), f = (sin(c) - (c - 4.0*c*c*c/(lambda*lambda))*cos(c))*cos(M_PI*n);

		if (f < 0.0)
			a = c;
		else
			b = c;
	}
	return fabs(y/a - 1.0);
}

/* x: weight over tension and lambda at the start, ratio of the tensions at start and end, branches. */
static void small_sag(struct sweep_point *point, const double *x, void *unused)
{
	struct hawser_span span = {INFINITY, 6.0, 9.81, 100.0, 0.0};
	double weight = span.rho*span.g*span.d, H = weight/x[0];
	struct hawser_irvine_options o = {.from = H, .to = H/x[2], .n = (int)x[3], .points = 4};
	struct hawser_irvine irvine;

	(void)unused;
	point->skip = heavy(x[3], 2.0) || left_out(8, 1);
	if (point->skip)
		return;
	span.EA = H*x[1]*x[1]/(x[0]*x[0]);
	point->status = hawser_irvine_trace(&irvine, &span, &o, &point->report);
	if (point->status)
		return;
	for (int i = 0; i < irvine.stations; i++) {
		double here = irvine.station[i].statics.H, delta = weight/here, lambda;

		lambda = delta*sqrt(span.EA/here);
		for (int b = 0; b < irvine.branches; b++) {
			int at = i*irvine.branches + b;
			double y = 0.5*irvine.omega[at]*span.d*sqrt(span.rho/here), error;

			if (irvine.family[at] == HAWSER_LONGITUDINAL)
				continue;
			error = b >= irvine.in_plane
				? fabs(2.0*y/(M_PI*(irvine.place[at] + 1)) - 1.0)
				: parabola(y, lambda, irvine.symmetry[at]);
			trace_keep(point, error, delta*delta + 4.0*here/span.EA*(1.0 + y*y)
			                         + 2.0*irvine.residual[at]);
		}
	}
	hawser_irvine_clear(&irvine);
}

/* --- the speed --- */

/* x: first speed over the limit, last speed as a fraction of the remaining range, weight over EA,
 * slope, T0 over weight, branches, points, quantity held. */
static void campbell(struct sweep_point *point, const double *x, void *unused)
{
	struct hawser_scene scene = {.cable = {.rho = 6.0}, .span = {100.0, x[3]*100.0}, .g = 9.81,
	                             .tension = {.given = HAWSER_GIVEN_T0}, .travel = {.present = 1}};
	double weight = 6.0*9.81*100.0, to = 0.0, limit;
	struct hawser_campbell_options o = {.n = (int)x[5], .points = (int)x[6]};
	struct hawser_campbell result;

	(void)unused;
	point->skip = heavy(x[5], x[6]) || (x[5] > 16.0 && x[1] > 0.3) || left_out(17, 7);
	if (point->skip)
		return;
	scene.cable.EA = weight/x[2];
	scene.tension.value = x[4]*weight;
	scene.travel.hold = x[7] == 1.0 ? HAWSER_HOLD_LENGTH : HAWSER_HOLD_TENSION;
	point->status = hawser_campbell_range(&to, &limit, &scene, &point->report);
	o.from = x[0]*to;
	o.to = o.from + x[1]*(to - o.from);
	if (!point->status)
		point->status = hawser_campbell_trace(&result, &scene, &o, &point->report);
	if (point->status)
		return;
	judge_campbell(point, &result, &scene, o, turn_of++);
	hawser_campbell_clear(&result);
}

/* Every pair of axes; without HAWSER_LONG neighbouring axes only. */
static void pairs(const char *stage, const struct sweep_axis *axis, int axes, sweep_function *solve)
{
	for (int i = 0; i < axes; i++)
		for (int j = i + 1; j < axes; j++) {
			counted = 0;
			turn_of = i + j;
			if (sweep_long() || (j == i + 1 && i % 2 == 0) || (i == 0 && j == axes - 1))
				sweep_pair(stage, axis, axes, i, j, solve, NULL);
		}
}

CASE(extremes_traces_sweep)
{
	double few = sweep_long() ? 5.0 : 3.0, far = sweep_long() ? 0.9 : 0.5;
	const struct sweep_axis meetings[] = {
		{"weight", 0.1, weights, COUNT(weights), 0}, {"slope", 0.0, slants, COUNT(slants), 0},
		{"crossover", 1.0, which, COUNT(which), 0},  {"aside", 0.0, asides, COUNT(asides), 0},
		{"where", 0.0, where, COUNT(where), 0}};
	const struct sweep_axis sags[] = {
		{"weight", 1e-5, flat, COUNT(flat), 0},      {"lambda", 1.0, lambdas, COUNT(lambdas), 0},
		{"extent", 30.0, widths, COUNT(widths), 0},  {"branches", 7.0, counts, COUNT(counts), 0}};
	const struct sweep_axis speeds[] = {
		{"from", 0.0, begins, COUNT(begins), 0},     {"to", far, ends, COUNT(ends), 0},
		{"extensibility", 1e-4, softness, COUNT(softness), 0},
		{"slope", 0.04, slopes, COUNT(slopes), 0},   {"tension", 3.0, tensions, COUNT(tensions), 0},
		{"branches", few, counts, COUNT(counts), 0}, {"points", 4.0, steps, COUNT(steps), 0},
		{"hold", 0.0, holds, COUNT(holds), 0}};
	const struct sweep_axis tension[] = {
		{"strain", 1e-4, epsilons, COUNT(epsilons), 0}, {"weight", 0.03, deltas, COUNT(deltas), 0},
		{"extent", 6.0*few, extents, COUNT(extents), 0},   {"slope", 0.0, slopes, COUNT(slopes), 0},
		{"branches", few, counts, COUNT(counts), 0},    {"points", 5.0, points, COUNT(points), 0},
		{"quantity", 1.0, quantities, COUNT(quantities), 0},
		{"speed", 0.0, paces, COUNT(paces), 0}};

	pairs("irvine", tension, 8, irvine);
	pairs("irvine/crossing", meetings, 5, crossing);
	pairs("irvine/parabola", sags, 4, small_sag);
	pairs("campbell", speeds, 8, campbell);
	return done_testing();
}

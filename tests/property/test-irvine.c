/* tests/property/test-irvine.c - sweeps of the tension: crossings and veerings where theory
 * predicts them, branches that keep their identity, and the same branches from either end and with
 * any step.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/irvine.h>
#include <stdlib.h>
#include <time.h>

#include "tests/tap.h"

/* B Table 4.1, with level ends. */
static const struct hawser_span table41[] = {
	{235e6, 12.94, 9.81, 100.0, 0.0},
	{40e6, 6.0, 9.81, 100.0, 0.0},
	{1e6, 3.0, 9.81, 100.0, 0.0},
};

static int trace(struct hawser_irvine *irvine, const struct hawser_span *span,
                 struct hawser_irvine_options options)
{
	struct hawser_report report = {0};
	enum hawser_status status = hawser_irvine_trace(irvine, span, &options, &report);

	return ok(!status, "EA %g, h/d %.3g: a sweep of %d points %s", span->EA, span->h/span->d,
	          options.points, report.message);
}

static const struct hawser_irvine_crossover *first_of(const struct hawser_irvine *irvine, int below,
                                                      int above)
{
	for (int k = 0; k < irvine->crossovers; k++)
		if (irvine->crossover[k].below == below && irvine->crossover[k].above == above)
			return irvine->crossover + k;
	return NULL;
}

/* A level span near lambda = 2 pi, for the given delta. */
static struct hawser_span about_crossover(double delta, double slope, double *H)
{
	struct hawser_span span = {.rho = 2.385, .g = 9.81, .d = 73.1};

	span.h = slope*span.d;
	*H = span.rho*span.g*span.d/delta;
	span.EA = *H*4.0*M_PI*M_PI/(delta*delta);
	return span;
}

/* H. M. Irvine, Cable Structures (1981): the first symmetric and antisymmetric mode of a level
 * cable cross at lambda = 2 pi, up to terms of order delta^2. */
static void level_crossover(void)
{
	double off[3];

	for (int i = 0; i < 3; i++) {
		double H, delta = (double[]){1e-3, 0.02, 0.04}[i];
		struct hawser_span span = about_crossover(delta, 0.0, &H);
		struct hawser_irvine_options options = {.from = 2.0*H, .to = 0.5*H, .points = 9, .n = 4};
		const struct hawser_irvine_crossover *at;
		struct hawser_irvine irvine;

		if (!trace(&irvine, &span, options))
			return;
		at = first_of(&irvine, 1, 2);
		off[i] = at ? 1.0 - at->irvine/(2.0*M_PI) : NAN;
		ok(at && at->kind == HAWSER_CROSSING && at->relative_gap < 1e-11, "delta %g: a crossing",
		   delta);
		ok(i > 0 || (at && fabs(at->irvine - 2.0*M_PI) < 1e-5 &&
		             fabs(at->irvine_source - 2.0*M_PI) < 1e-5), "at lambda = 2 pi");
		hawser_irvine_clear(&irvine);
	}
	close_to(off[2]/off[1], 4.0, 0.01, "its distance from 2 pi is of order delta^2");
}

/* Modes at one tension, solved separately: relative gap of the first two in-plane frequencies. */
static double gap_at(const struct hawser_span *span, double H)
{
	struct hawser_modes_options options = {.n = 8};
	struct hawser_statics st;
	struct hawser_modes modes;
	double omega[2] = {NAN, NAN};
	int found = 0;

	if (hawser_statics_solve(&st, span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL) ||
	    hawser_modes_solve(&modes, &st, &options, NULL))
		return NAN;
	for (int k = 0; k < modes.n && found < 2; k++)
		if (modes.mode[k].plane == HAWSER_IN_PLANE)
			omega[found++] = modes.mode[k].omega;
	hawser_modes_clear(&modes);
	return 2.0*(omega[1] - omega[0])/(omega[1] + omega[0]);
}

/* If the span is inclined, the two branches veer. The gap is proportional to the slope while it is
 * small. */
static void slopes(void)
{
	const double slope[] = {1e-4, 1e-3, 0.01, 0.1, 1.0/3.0, 1.0, 2.0};
	double last = 0.0, per_slope = 0.0;

	for (size_t i = 0; i < sizeof slope/sizeof *slope; i++) {
		double H;
		struct hawser_span span = about_crossover(0.1874, slope[i], &H);
		struct hawser_irvine_options options = {.from = 3.0*H, .to = 0.3*H, .points = 21, .n = 4};
		const struct hawser_irvine_crossover *at;
		struct hawser_irvine irvine;

		if (!trace(&irvine, &span, options))
			return;
		at = first_of(&irvine, 1, 2);
		if (ok(at && at->kind == HAWSER_VEERING && at->relative_gap > last, "slope %g: veering, "
		       "gap %.3g", slope[i], at ? at->relative_gap : NAN)) {
			double here = gap_at(&span, at->H), w = 0.1*at->relative_gap;

			close_to(here, at->relative_gap, 1e-9, "the gap by a solution of its own");
			ok(gap_at(&span, at->H*(1.0 + w)) > here && gap_at(&span, at->H*(1.0 - w)) > here,
			   "and it is the least");
			last = at->relative_gap;
		}
		if (i == 0)
			per_slope = last/slope[i];
		if (i == 1 || i == 2)
			close_to(last/slope[i], per_slope, 1e-3, "in proportion");
		hawser_irvine_clear(&irvine);
	}
}

/* --- the branches of B Table 4.1 --- */

static double omega(const struct hawser_irvine *irvine, int i, int b)
{
	return irvine->omega[i*irvine->branches + b];
}

/* 1 if branch b of one sweep is branch c of the other, which has the opposite direction. Inserted
 * stations may differ. */
static int same_branch(const struct hawser_irvine *down, int b, const struct hawser_irvine *up, int c)
{
	int j = up->stations - 1;

	for (int i = 0; i < down->stations; i++) {
		if (down->station[i].inserted)
			continue;
		while (up->station[j].inserted)
			j--;
		if (fabs(down->station[i].statics.H/up->station[j].statics.H - 1.0) > 1e-12 ||
		    fabs(omega(down, i, b)/omega(up, j, c) - 1.0) > 1e-10)
			return 0;
		j--;
	}
	return 1;
}

/* Each branch of the downward sweep is a branch of the upward one. */
static void retrace(const struct hawser_irvine *down, const struct hawser_irvine *up)
{
	for (int b = 0; b < down->branches; b++) {
		int found = 0;

		for (int c = 0; c < up->branches; c++)
			found += up->branch[c].plane == down->branch[b].plane &&
			         same_branch(down, b, up, c);
		ok(found == 1, "%s branch %d is one branch of the sweep back",
		   hawser_plane_name(down->branch[b].plane), down->branch[b].number);
	}
}

/* Level span: each branch keeps its symmetry through all crossings. */
static void constant_symmetry(const struct hawser_irvine *irvine)
{
	int mixed = 0, changed = 0;

	for (int b = 0; b < irvine->branches; b++)
		for (int i = 0; i < irvine->stations; i++) {
			enum hawser_symmetry here = irvine->symmetry[i*irvine->branches + b];
			enum hawser_family family = irvine->family[i*irvine->branches + b];

			/* symmetry of the dominant component; its label changes where P becomes dominant */
			if (family != irvine->family[b])
				here = here == HAWSER_SYMMETRIC ? HAWSER_ANTISYMMETRIC
				       : here == HAWSER_ANTISYMMETRIC ? HAWSER_SYMMETRIC : here;
			mixed += here == HAWSER_MIXED;
			changed += here != irvine->symmetry[b];
		}
	ok(mixed == 0 && changed == 0, "level: no branch changes its symmetry (%d mixed, %d changed)",
	   mixed, changed);
}

/* Neighbours with a crossing between two stations exchange their places, others do not. */
static void order(const struct hawser_irvine *irvine)
{
	int crossings = 0, disorder = 0, low = 0;

	for (int k = 0; k < irvine->crossovers; k++)
		crossings += irvine->crossover[k].kind == HAWSER_CROSSING;
	for (int i = 0; i < irvine->stations; i++)
		for (int b = 1; b < irvine->branches; b++) {
			disorder += b < irvine->in_plane && omega(irvine, i, b) < omega(irvine, i, b - 1);
			low += b > irvine->in_plane && omega(irvine, i, b) <= omega(irvine, i, b - 1);
		}
	ok(low == 0, "branches out of the plane never meet");
	ok((crossings > 0) == (disorder > 0) && (irvine->span.h == 0.0) == (crossings > 0),
	   "branches in the plane change their order on level spans only (%d crossings)", crossings);
	ok(irvine->least_correlation >= 0.9, "shapes are followed: squared correlation %.4f",
	   irvine->least_correlation);
}

static void same_crossovers(const struct hawser_irvine *a, const struct hawser_irvine *b)
{
	int same = a->crossovers == b->crossovers;

	for (int k = 0; same && k < a->crossovers; k++)
		same = a->crossover[k].kind == b->crossover[k].kind &&
		       a->crossover[k].below == b->crossover[k].below &&
		       a->crossover[k].above == b->crossover[k].above &&
		       fabs(a->crossover[k].H/b->crossover[k].H - 1.0) < 1e-5;
	ok(same, "%d and %d points: the same %d crossovers", a->stations, b->stations, a->crossovers);
}

static void one_case(struct hawser_span span, double slope)
{
	struct hawser_irvine_options options = {.points = getenv("HAWSER_LONG") ? 400 : 40};
	struct hawser_irvine down, up, coarse;
	clock_t start = clock();

	span.h = slope*span.d;
	if (!trace(&down, &span, options))
		return;
	printf("# %d branches, %d stations: %.3f s of processor time\n", down.branches, down.stations,
	       (double)(clock() - start)/CLOCKS_PER_SEC);
	order(&down);
	if (slope == 0.0)
		constant_symmetry(&down);
	options.from = down.station[down.stations - 1].value;
	options.to = down.station[0].value;
	options.n = 18;
	if (trace(&up, &span, options)) {
		retrace(&down, &up);
		hawser_irvine_clear(&up);
	}
	options = (struct hawser_irvine_options){.points = 7};
	if (trace(&coarse, &span, options)) {
		same_crossovers(&down, &coarse);
		hawser_irvine_clear(&coarse);
	}
	hawser_irvine_clear(&down);
}

/* The family of equilibria does not depend on the swept quantity. */
static void quantities(void)
{
	struct hawser_span span = table41[1];
	const enum hawser_given by[] = {HAWSER_GIVEN_T0, HAWSER_GIVEN_T1, HAWSER_GIVEN_LENGTH0,
	                                HAWSER_GIVEN_SAG};
	struct hawser_irvine irvine, other;

	span.h = 17.3;
	if (!trace(&irvine, &span, (struct hawser_irvine_options){.points = 30}))
		return;
	for (int i = 0; i < 4; i++) {
		struct hawser_irvine_options options = {.sweep = by[i], .points = 30};
		double from, to;

		if (!trace(&other, &span, options))
			continue;
		same_crossovers(&irvine, &other);
		ok(!hawser_irvine_range(&from, &to, &span, by[i], NULL), "and there is a range by %s",
		   hawser_given_name(by[i]));
		close_to(other.station[0].value, from, 1e-12, "which it begins");
		close_to(other.station[other.stations - 1].value, to, 1e-12, "and ends");
		close_to(other.station[0].statics.irvine_source, 0.1*M_PI, 1e-6, "at 0.1 pi");
		close_to(other.station[other.stations - 1].statics.irvine_source, 10.0*M_PI, 1e-6,
		         "and 10 pi");
		hawser_irvine_clear(&other);
	}
	hawser_irvine_clear(&irvine);
}

CASE(property_irvine)
{
	level_crossover();
	slopes();
	for (int i = 0; i < 3; i++) {
		if (i == 0 || getenv("HAWSER_LONG"))
			one_case(table41[i], 0.0);
		if (i > 0 || getenv("HAWSER_LONG"))
			one_case(table41[i], 1.0/3.0);
	}
	quantities();
	return done_testing();
}

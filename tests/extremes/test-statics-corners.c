/* Statics at and beyond the limits of its inputs. Every combination of extreme inputs must either be
 * solved (all results finite, the given quantity and both ends met) or be refused with a message. A
 * not-a-number, a wrong result and a run without end are failures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <stdlib.h>

#include "tests/statics-draw.h"
#include "tests/tap.h"

static int solved, none, wrong;
static double worst_given, worst_closure;

static int finite_all(const struct hawser_statics *st)
{
	const double all[] = {st->H, st->T0, st->T1, st->V0, st->V1, st->length0, st->length, st->sag,
	                      st->eta, st->epsilon, st->delta, st->l, st->hs, st->closure};

	for (size_t i = 0; i < sizeof all/sizeof *all; i++)
		if (!isfinite(all[i]))
			return 0;
	return !isnan(st->irvine) && !isnan(st->irvine_source);
}

static void attempt(struct hawser_span span, enum hawser_given given, double value,
                    enum hawser_branch branch)
{
	struct hawser_statics st;
	struct hawser_report report = {.message = ""};
	enum hawser_status status = hawser_statics_solve(&st, &span, given, value, branch, &report);
	double e;

	if (status == HAWSER_ERR_NO_SOLUTION && report.message[0] && report.status == status) {
		none++;
		return;
	}
	if (status || !finite_all(&st)) {
		wrong++;
		ok(0, "EA %g rho %g d %g h %g given %d = %g branch %d: %s %s", span.EA, span.rho, span.d,
		   span.h, (int)given, value, (int)branch, hawser_status_name(status), report.message);
		return;
	}
	solved++;
	e = fabs(value_of(&st, given)/value - 1.0);
	worst_given = e <= worst_given ? worst_given : e;
	e = st.closure/(hypot(span.d, span.h) + st.length);
	worst_closure = e <= worst_closure ? worst_closure : e;
	if (worst_given > 1e-12 || worst_closure > 1e-12) {
		wrong++;
		ok(0, "EA %g rho %g d %g h %g given %d = %g branch %d: off by %.1e, %.1e", span.EA,
		   span.rho, span.d, span.h, (int)given, value, (int)branch, worst_given, worst_closure);
		worst_given = worst_closure = 0.0;
	}
}

static void attempt_each(struct hawser_span span, const double *values, size_t count)
{
	for (size_t i = 0; i < count; i++)
		for (int g = HAWSER_GIVEN_H; g <= HAWSER_GIVEN_SAG; g++) {
			attempt(span, (enum hawser_given)g, values[i], HAWSER_BRANCH_TAUT);
			attempt(span, (enum hawser_given)g, values[i], HAWSER_BRANCH_SLACK);
		}
}

static void tally(const char *what)
{
	ok(wrong == 0 && solved > 0, "%s: %d solved (given met to %.1e, ends to %.1e), %d refused",
	   what, solved, worst_given, worst_closure, none);
	solved = none = wrong = 0;
	worst_given = worst_closure = 0.0;
}

/* Every corner of a box far larger than any cable. */
static void corners(double EA[], size_t nEA, double rho[], double d[], double slope[], size_t n,
                    const double values[], size_t nvalues)
{
	for (size_t i = 0; i < nEA; i++)
		for (size_t j = 0; j < n; j++)
			for (size_t k = 0; k < n; k++)
				for (size_t m = 0; m < n; m++) {
					struct hawser_span span = {EA[i], rho[j], 9.81, d[k], slope[m]*d[k]};

					attempt_each(span, values, nvalues);
				}
}

/* Lengths equal to the chord, and a few units in the last place different. */
static void around_the_chord(void)
{
	struct hawser_span rigid = {INFINITY, 6.0, 9.81, 30.0, 40.0}, stiff = rigid;
	struct hawser_statics st, last = {.H = INFINITY};
	double L = 50.0;
	int falling = 1;

	stiff.EA = 1e14;
	ok(hawser_statics_solve(&st, &rigid, HAWSER_GIVEN_LENGTH0, 50.0, HAWSER_BRANCH_TAUT, NULL) ==
	   HAWSER_ERR_NO_SOLUTION, "the chord itself isn't long enough");
	for (int ulp = 1; ulp <= 4; ulp++) {
		double excess = ulp*0x1p-47, want; /* L - chord, exactly */

		L = nextafter(L, 60.0);
		if (hawser_statics_solve(&st, &rigid, HAWSER_GIVEN_LENGTH0, L, HAWSER_BRANCH_TAUT, NULL)) {
			ok(0, "%d units above the chord", ulp);
			continue;
		}
		/* L^2 - chord^2 = (d*delta)^2/12 for small delta */
		want = 6.0*9.81*30.0*30.0/sqrt(12.0*2.0*50.0*excess);
		close_to(st.H, want, 1e-9, "H from the last digit of the length");
	}
	L = 50.0*(1.0 - 8.0*DBL_EPSILON);
	for (int i = 0; i < 16; i++, L = nextafter(L, 60.0)) {
		if (hawser_statics_solve(&st, &stiff, HAWSER_GIVEN_LENGTH0, L, HAWSER_BRANCH_TAUT, NULL))
			falling = 0;
		falling = falling && st.H < last.H;
		last = st;
	}
	ok(falling, "elastic: H falls from one double to the next, across the chord");
}

/* Tensions that approach the minimum, on both branches; the distance is halved in each step. */
static void around_the_minimum(void)
{
	struct hawser_span span = {4e7, 6.0, 9.81, 100.0, 33.0};
	struct hawser_statics taut, slack;
	struct hawser_report report = {.message = ""};
	double least, wrong_side = 0.0;
	const char *at;

	if (hawser_statics_solve(&taut, &span, HAWSER_GIVEN_T1, 1.0, HAWSER_BRANCH_TAUT, &report) !=
	    HAWSER_ERR_NO_SOLUTION)
		wrong_side++;
	at = strstr(report.message, "can hang, ");
	least = at ? strtod(at + 10, NULL)*(1.0 + 1e-10) : NAN;
	for (double above = 1.0; above > 1e-9; above *= 0.5) {
		if (hawser_statics_solve(&taut, &span, HAWSER_GIVEN_T1, least*(1.0 + above),
		                         HAWSER_BRANCH_TAUT, NULL) ||
		    hawser_statics_solve(&slack, &span, HAWSER_GIVEN_T1, least*(1.0 + above),
		                         HAWSER_BRANCH_SLACK, NULL))
			wrong_side++;
		else
			wrong_side += !(slack.H < taut.H) + !(slack.length0 > taut.length0);
		wrong_side += hawser_statics_solve(&taut, &span, HAWSER_GIVEN_T1, least*(1.0 - 0.9*above),
		                                   HAWSER_BRANCH_TAUT, NULL) != HAWSER_ERR_NO_SOLUTION;
	}
	ok(wrong_side == 0.0, "two above the minimum and none below, down to a billionth");
}

CASE(extremes_statics_corners)
{
	double EA[] = {1e4, 1e9, 1e14, INFINITY}, wildEA[] = {1e-200, 1e-3, 1e30, 1e300, INFINITY};
	double rho[] = {1e-4, 1.0, 1e3}, wild_rho[] = {1e-200, 1e-12, 1e150};
	double d[] = {0.1, 250.0, 1e5}, wild_d[] = {1e-150, 1e8, 1e150};
	double slope[] = {-20.0, 1e-9, 20.0}, wild_slope[] = {-1e6, 0.0, 1e9};
	const double values[] = {1e-3, 1.0, 300.0, 1e5, 1e9, 1e14};
	const double wild[] = {5e-324, 1e-300, 1e-100, 1e-8, 1.0, 1e8, 1e100, 1e300};

	corners(EA, 4, rho, d, slope, 3, values, 6);
	tally("corners of the box");
	corners(wildEA, 5, wild_rho, wild_d, wild_slope, 3, wild, 8);
	tally("far outside it");
	around_the_chord();
	around_the_minimum();
	return done_testing();
}

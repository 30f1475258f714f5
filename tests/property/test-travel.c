/* The steady state of a travelling cable by independent routes: the source's closed forms, direct
 * integration of the balance without an apparent cable, both kinds of hold, and the fold at which
 * the taut and the slack state coincide.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <string.h>

#include <hawser/statics.h>

#include "tests/tap.h"

static const struct hawser_span table_5_3 = {100e6, 5.0, 9.81, 100.0, 5.0};

static struct hawser_report report;

static int travel(struct hawser_statics *st, const struct hawser_span *span, enum hawser_given given,
                  double value, enum hawser_branch branch, double speed, enum hawser_hold hold)
{
	const struct hawser_motion motion = {.speed = speed, .hold = hold};
	enum hawser_status status = hawser_statics_travel(st, span, given, value, branch, &motion,
	                                                  &report);

	if (status)
		printf("# at %.15g m/s: %s\n", speed, report.message);
	return status == HAWSER_OK;
}

static double value_of(const struct hawser_statics *st, enum hawser_given given)
{
	const double values[] = {NAN, st->H, st->T0, st->T1, st->length0, st->sag};

	return values[given];
}

/* B 5.16-5.20 (signs and norms as derived in doc/theory-travel.md) at unstretched S, actual scaling. */
static void closed_form(double *x, double *y, double *stretch, const struct hawser_statics *actual,
                        double speed, double S)
{
	const struct hawser_span *span = &actual->span;
	double eps = actual->H/span->EA, delta = span->rho*span->g*span->d/actual->H;
	double nu2 = span->rho*speed*speed/actual->H, eta = actual->V0/actual->H, s = S/span->d;
	double beta = 1.0 - eps*nu2 - nu2/hypot(1.0, eta), part = 1.0 - eps*nu2;
	double u = eta + delta/beta*s;

	*x = span->d*(eps*beta*s + beta/delta*(asinh(u) - asinh(eta)))/part;
	*y = span->d*(eps*(beta*eta*s + 0.5*delta*s*s)
	              + beta/delta*(hypot(1.0, u) - hypot(1.0, eta)))/part;
	*stretch = (1.0 + eps*beta*hypot(1.0, u))/part;
}

static void check_closed_form(const struct hawser_statics *st, const char *what)
{
	struct hawser_statics actual = hawser_statics_actual(st);
	double worst = 0.0, tension = 0.0, x, y, stretch;

	for (int i = 0; i <= 20; i++) {
		double S = actual.length0*i/20;
		struct hawser_profile_point point = hawser_statics_actual_at(st, S);

		closed_form(&x, &y, &stretch, &actual, st->motion.speed, S);
		worst = fmax(worst, hypot(x - point.x, y - point.y)/actual.length);
		tension = fmax(tension, fabs(actual.span.EA*(stretch - 1.0)/point.T - 1.0));
	}
	ok(worst < 1e-12, "%s: the profile is that of B 5.19 and 5.20, off by %.1e of the length", what,
	   worst);
	/* |x'| - 1 is 1e-4 times its terms, so that four digits are lost */
	ok(tension < 1e-11, "%s: the tension is EA (|x'| - 1), off by %.1e", what, tension);
	closed_form(&x, &y, &stretch, &actual, st->motion.speed, actual.length0);
	ok(hypot(x - actual.span.d, y - actual.span.h) < 1e-12*actual.length,
	   "%s: B 5.21 is met", what);
}

/* (T e - rho v^2 |x'| e)' = (0, rho g): the vector R is linear in S, and x' is parallel to it, with
 * |R| = EA (|x'| - 1) - rho v^2 |x'|. Simpson's rule in S from end A, with actual quantities only. */
static void integrate(double end[2], const struct hawser_statics *actual, double speed)
{
	const struct hawser_span *span = &actual->span;
	double thrust = span->rho*speed*speed, R = actual->T0 - thrust*(1.0 + actual->T0/span->EA);
	double slope = actual->V0/actual->H, Rx = R/hypot(1.0, slope), Ry0 = Rx*slope;
	const int steps = 20000;

	end[0] = end[1] = 0.0;
	for (int i = 0; i <= steps; i++) {
		double S = actual->length0*i/steps, Ry = Ry0 + span->rho*span->g*S;
		double size = hypot(Rx, Ry), stretch = (size + span->EA)/(span->EA - thrust);
		double weight = (i == 0 || i == steps ? 1.0 : i%2 ? 4.0 : 2.0)/3.0;

		end[0] += weight*stretch*Rx/size*actual->length0/steps;
		end[1] += weight*stretch*Ry/size*actual->length0/steps;
	}
}

static void check_integrated(const struct hawser_statics *st, const char *what)
{
	struct hawser_statics actual = hawser_statics_actual(st);
	double end[2], off;

	integrate(end, &actual, st->motion.speed);
	off = hypot(end[0] - actual.span.d, end[1] - actual.span.h)/actual.length;
	ok(off < 1e-10, "%s: the balance integrated from end A comes to end B, off by %.1e", what, off);
}

/* Spans with end B above, level with and below end A; every given quantity; both kinds of hold. */
static void check_givens(void)
{
	static const char *const names[] = {"", "H", "T0", "T1", "length0", "sag"};
	static const double heights[] = {5.0, 0.0, -23.85, 140.0};
	char what[80];

	for (int i = 0; i < 4; i++) {
		struct hawser_span span = {40e6, 6.0, 9.81, 100.0, heights[i]};
		struct hawser_statics rest, st, actual;

		if (hawser_statics_solve(&rest, &span, HAWSER_GIVEN_H, 2.385e4, HAWSER_BRANCH_TAUT,
		                         &report))
			continue;
		for (int given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++)
			for (int hold = 0; hold < 2; hold++) {
				double value = value_of(&rest, (enum hawser_given)given), kept;

				snprintf(what, sizeof what, "h %g, %s given, %s held", span.h, names[given],
				         hold == HAWSER_HOLD_LENGTH ? "length" : "tension");
				if (!ok(travel(&st, &span, (enum hawser_given)given, value,
				               HAWSER_BRANCH_TAUT, 41.7, (enum hawser_hold)hold),
				        "%s: solved", what))
					continue;
				actual = hawser_statics_actual(&st);
				kept = hold == HAWSER_HOLD_LENGTH ? actual.length0/rest.length0
				       : given <= HAWSER_GIVEN_T1
				             ? value_of(&actual, (enum hawser_given)given)/value
				             : actual.T0/rest.T0;
				ok(fabs(kept - 1.0) < 1e-13, "%s: it is, to %.1e", what, kept - 1.0);
				check_closed_form(&st, what);
				check_integrated(&st, what);
			}
	}
}

/* At speed 0 it is the cable at rest to the last bit; at a very small speed it is close to it. */
static void check_slow(void)
{
	struct hawser_statics rest, st;

	for (int hold = 0; hold < 2; hold++)
		for (int given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++) {
			double value = given <= HAWSER_GIVEN_T1 ? 85e3
			               : given == HAWSER_GIVEN_SAG ? 0.7218 : 100.0536;
			/* the relative round-off of a length is that of the strain, and divided by H/EA that of
			 * the tension */
			double tolerance = 4.0*DBL_EPSILON*table_5_3.EA/85e3;
			int same, near;

			if (hawser_statics_solve(&rest, &table_5_3, (enum hawser_given)given, value,
			                         HAWSER_BRANCH_TAUT, &report))
				continue;
			if (!travel(&st, &table_5_3, (enum hawser_given)given, value,
			            HAWSER_BRANCH_TAUT, 0.0, (enum hawser_hold)hold)) {
				ok(0, "speed 0: solved");
				continue;
			}
			same = st.H == rest.H && st.T0 == rest.T0 && st.T1 == rest.T1 && st.V0 == rest.V0
			       && st.V1 == rest.V1 && st.length0 == rest.length0
			       && st.sag == rest.sag && st.eta == rest.eta && st.delta == rest.delta
			       && st.epsilon == rest.epsilon && st.motion.nu == 0.0
			       && st.motion.tension == rest.T0;
			ok(same, "given %d, hold %d: at speed 0 the cable at rest to the last bit", given,
			   hold);
			near = travel(&st, &table_5_3, (enum hawser_given)given, value,
			              HAWSER_BRANCH_TAUT, 1e-8, (enum hawser_hold)hold)
			       && fabs(st.H/rest.H - 1.0) < tolerance
			       && fabs(st.sag/rest.sag - 1.0) < tolerance;
			ok(near && st.motion.nu > 0.0, "and at 1e-8 m/s beside it");
		}
}

/* Near the limit the taut and the slack state differ by the square root of the distance to the
 * limit, because they coincide in a fold. */
static void check_fold(const struct hawser_span *span, enum hawser_given given, double value)
{
	static const double left[] = {1e-3, 1e-6, 1e-8, 1e-12};
	double limit, gap[4] = {0.0};
	struct hawser_statics taut, slack, actual;
	enum hawser_status status = hawser_statics_limit(&limit, span, given, value,
	                                                 HAWSER_BRANCH_TAUT, HAWSER_HOLD_TENSION,
	                                                 &report);
	const struct hawser_motion beyond = {.speed = limit*(1.0 + 1e-9)};
	char name[32];

	ok(!status && limit < sqrt(value/span->rho), "h %g: it ends at %.12g m/s, before sqrt(T/rho)",
	   span->h, limit);
	for (int i = 0; i < 4; i++) {
		double speed = limit*(1.0 - left[i]);

		if (!ok(travel(&taut, span, given, value, HAWSER_BRANCH_TAUT, speed,
		               HAWSER_HOLD_TENSION) &&
		        travel(&slack, span, given, value, HAWSER_BRANCH_SLACK, speed,
		               HAWSER_HOLD_TENSION), "1 - %g of it: taut and slack", left[i]))
			return;
		gap[i] = log(slack.sag/taut.sag);
		actual = hawser_statics_actual(&taut);
		ok(fabs(value_of(&actual, given)/value - 1.0) < 1e-13, "the tension is held");
		check_integrated(&taut, "taut");
		check_integrated(&slack, "slack");
	}
	close_to(gap[1]/gap[2], 10.0, 1e-2, "apart as the square root of what is left");
	ok(gap[3] < 1e-4*gap[0], "at 1 - 1e-12 of it they are 1 (%.1e)", gap[3]);
	status = hawser_statics_travel(&taut, span, given, value, HAWSER_BRANCH_TAUT, &beyond, &report);
	snprintf(name, sizeof name, "%.6g", limit);
	ok(status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, name),
	   "1 + 1e-9 of it is refused, and the message has the limit: %s", report.message);
}

/* At the limit T0 has its minimum over the states, which is found by golden section. */
static void check_limit(void)
{
	double limit, p, low = log(1.0), high = log(1e6);
	const double golden = 0.381966011250105;
	struct hawser_span apparent = table_5_3;
	struct hawser_statics st;

	if (!ok(!hawser_statics_limit(&limit, &table_5_3, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT,
	                              HAWSER_HOLD_TENSION, &report), "Table 5.3: a limit"))
		return;
	close_to(limit, 127.556, 5e-6, "127.556 m/s");
	p = apparent.rho*limit*limit;
	apparent.rho *= 1.0 - p/apparent.EA;
	for (int i = 0; i < 60; i++) {
		double x[2] = {low + golden*(high - low), high - golden*(high - low)}, T[2] = {0.0};

		for (int k = 0; k < 2; k++)
			if (!hawser_statics_solve(&st, &apparent, HAWSER_GIVEN_H, exp(x[k]),
			                          HAWSER_BRANCH_TAUT, &report))
				T[k] = st.T0;
		if (T[0] < T[1])
			high = x[1];
		else
			low = x[0];
	}
	close_to((st.T0 + p)/(1.0 - p/apparent.EA), 85e3, 1e-12,
	         "there the least apparent tension leaves just the T0 held");
}

/* The tension increases by rho v^2 everywhere, without other changes: true of inextensible cables,
 * but often stated for elastic ones. */
static void check_inextensible(void)
{
	struct hawser_span span = {INFINITY, 5.0, 9.81, 100.0, 5.0};
	struct hawser_statics rest, st;
	double v = 61.3, worst = 0.0;

	if (!ok(!hawser_statics_solve(&rest, &span, HAWSER_GIVEN_SAG, 3.1, HAWSER_BRANCH_TAUT, &report)
	        && travel(&st, &span, HAWSER_GIVEN_SAG, 3.1, HAWSER_BRANCH_TAUT, v,
	                  HAWSER_HOLD_LENGTH), "inextensible, length held"))
		return;
	for (int i = 0; i <= 10; i++) {
		struct hawser_profile_point at = hawser_statics_at(&rest, rest.length0*i/10);
		struct hawser_profile_point now = hawser_statics_actual_at(&st, rest.length0*i/10);

		worst = fmax(worst, fmax(fabs(now.y - at.y)/span.d,
		                         fabs((now.T - at.T)/(span.rho*v*v) - 1.0)));
	}
	ok(worst < 1e-12, "its profile stays, its tension grows by rho v^2 everywhere: %.1e", worst);
	ok(travel(&st, &span, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT, 100.0, HAWSER_HOLD_TENSION) &&
	   fabs(st.T0/(85e3 - 5.0*1e4) - 1.0) < 1e-14, "tension held: rho v^2 less of it is left");
}

static void check_motion(void)
{
	struct hawser_motion motion = {.speed = 20.0, .fluctuation = 6.0};
	struct hawser_statics both, mean;
	double limit;

	if (ok(!hawser_statics_travel(&both, &table_5_3, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT,
	                              &motion, &report)
	       && travel(&mean, &table_5_3, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT,
	                 sqrt(400.0 + 18.0), HAWSER_HOLD_TENSION), "a fluctuating speed")) {
		ok(fabs(both.H/mean.H - 1.0) < 1e-14, "counts by its mean square");
		close_to(both.motion.nu, mean.motion.nu*20.0/sqrt(418.0), 1e-14, "nu is the mean's");
		close_to(both.motion.swing, mean.motion.nu*6.0/sqrt(418.0), 1e-14, "swing its own");
	}
	ok(!hawser_statics_limit(&limit, &table_5_3, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT,
	                         HAWSER_HOLD_LENGTH, &report)
	   && fabs(limit/sqrt(100e6/5.0) - 1.0) < 1e-15, "length held: up to sqrt(EA/rho)");
	/* far above sqrt(H/rho) the tension is mostly rho v^2 */
	ok(travel(&both, &table_5_3, HAWSER_GIVEN_H, 85e3, HAWSER_BRANCH_TAUT, 300.0,
	          HAWSER_HOLD_TENSION) && both.H > 0.0, "H held: steep at %.4g m/s", 300.0);
	close_to(hawser_statics_actual(&both).H, 85e3, 1e-13, "and H is held");
	check_integrated(&both, "H held");
}

/* B Table 5.1: sqrt(EA/rho), to the digits printed. */
static void check_table_5_1(void)
{
	static const double EA[] = {235e6, 40e6, 1e6}, rho[] = {12.94, 6.0, 3.0};
	static const double printed[] = {4261.5, 2582.0, 577.4}, digits[] = {0.05, 0.5, 0.05};

	for (int i = 0; i < 3; i++) {
		const struct hawser_span span = {EA[i], rho[i], 9.81, 100.0, 33.0};
		double limit;
		enum hawser_status status = hawser_statics_limit(&limit, &span, HAWSER_GIVEN_LENGTH0,
		                                                 106.0, HAWSER_BRANCH_TAUT,
		                                                 HAWSER_HOLD_LENGTH, &report);

		ok(!status && fabs(limit - printed[i]) <= digits[i], "B Table 5.1: %.6g m/s, printed %g",
		   limit, printed[i]);
	}
}

static void check_refusals(void)
{
	static const struct hawser_motion wrong[] = {
		{.speed = NAN}, {.speed = INFINITY}, {.speed = 1.0, .fluctuation = -1.0},
		{.speed = 1.0, .fluctuation = NAN}, {.speed = 1.0, .hold = (enum hawser_hold)7}};
	const struct hawser_motion sound = {.speed = 4480.0, .hold = HAWSER_HOLD_LENGTH};
	struct hawser_statics st;
	enum hawser_status status;

	for (int i = 0; i < 5; i++) {
		status = hawser_statics_travel(&st, &table_5_3, HAWSER_GIVEN_T0, 85e3,
		                               HAWSER_BRANCH_TAUT, &wrong[i], &report);
		ok(status == HAWSER_ERR_ARGUMENT, "refused: %s", report.message);
	}
	status = hawser_statics_travel(&st, &table_5_3, HAWSER_GIVEN_T0, 85e3, HAWSER_BRANCH_TAUT,
	                               &sound, &report);
	ok(status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "4472.1"),
	   "faster than waves along the cable: %s", report.message);
	status = hawser_statics_travel(&st, &table_5_3, HAWSER_GIVEN_T0, 200.0, HAWSER_BRANCH_TAUT,
	                               &sound, &report);
	ok(status == HAWSER_ERR_NO_SOLUTION, "nothing at rest: %s", report.message);
}

CASE(property_travel)
{
	const struct hawser_span below = {40e6, 6.0, 9.81, 100.0, -33.0};

	check_givens();
	check_slow();
	check_fold(&table_5_3, HAWSER_GIVEN_T0, 85e3);
	check_fold(&below, HAWSER_GIVEN_T1, 31.7e3);
	check_limit();
	check_inextensible();
	check_motion();
	check_table_5_1();
	check_refusals();
	return done_testing();
}

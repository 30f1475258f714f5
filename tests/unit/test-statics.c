/* Statics: invalid arguments and their messages, the minimum of the end tension, the ends of the
 * profile, the frame, the function for scenes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/statics-draw.h"
#include "tests/tap.h"

static const struct hawser_span chairlift = {400e6, 6.0, 9.81, 250.0, 10.0};

static void refused(struct hawser_span span, enum hawser_given given, double value,
                    enum hawser_status want, const char *words)
{
	struct hawser_statics st;
	struct hawser_report report = {.message = ""};
	enum hawser_status got = hawser_statics_solve(&st, &span, given, value,
	                                              HAWSER_BRANCH_TAUT, &report);

	ok(got == want && report.status == want && strstr(report.message, words),
	   "%s, saying \"%s\": %s", hawser_status_name(got), words, report.message);
}

static void refuse_arguments(void)
{
	static const double bad[] = {0.0, -3.5, NAN, INFINITY};
	struct hawser_span span;

	for (size_t i = 0; i < sizeof bad/sizeof *bad; i++) {
		span = chairlift;
		span.EA = bad[i];
		if (!isinf(bad[i]))
			refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "EA is ");
		span = chairlift;
		span.rho = bad[i];
		refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "rho is ");
		span = chairlift;
		span.g = bad[i];
		refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "g is ");
		span = chairlift;
		span.d = bad[i];
		refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "d is ");
		refused(chairlift, HAWSER_GIVEN_H, bad[i], HAWSER_ERR_ARGUMENT, "tension H is ");
		refused(chairlift, HAWSER_GIVEN_T0, bad[i], HAWSER_ERR_ARGUMENT, "T0 at end A is ");
		refused(chairlift, HAWSER_GIVEN_T1, bad[i], HAWSER_ERR_ARGUMENT, "T1 at end B is ");
		refused(chairlift, HAWSER_GIVEN_LENGTH0, bad[i], HAWSER_ERR_ARGUMENT, "length0 is ");
		refused(chairlift, HAWSER_GIVEN_SAG, bad[i], HAWSER_ERR_ARGUMENT, "sag is ");
	}
	span = chairlift;
	span.EA = -INFINITY;
	refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "-inf N");
	span = chairlift;
	span.h = NAN;
	refused(span, HAWSER_GIVEN_T0, 8e4, HAWSER_ERR_ARGUMENT, "height difference h is nan m");
	span.d = 0.01;
	span.h = 1e8;
	refused(span, HAWSER_GIVEN_H, 1.0, HAWSER_ERR_ARGUMENT, "vertical cable");
	refused(chairlift, HAWSER_GIVEN_NONE, 1.0, HAWSER_ERR_ARGUMENT, "one of H, T0, T1");
	refused(chairlift, (enum hawser_given)6, 1.0, HAWSER_ERR_ARGUMENT, "one of H, T0, T1");
}

static void refuse_branch(void)
{
	struct hawser_statics st;
	struct hawser_report report = {.message = ""};

	ok(hawser_statics_solve(&st, &chairlift, HAWSER_GIVEN_T0, 8e4, (enum hawser_branch)2,
	                        &report) == HAWSER_ERR_ARGUMENT && strstr(report.message, "branch"),
	   "an unknown branch: %s", report.message);
}

/* The message states the least tension and its H; both branches coincide there. */
static void minimum(struct hawser_span span, enum hawser_given given)
{
	struct hawser_statics st, taut, slack;
	struct hawser_report report = {.message = ""};
	const char *at;
	double least, H;

	if (!ok(hawser_statics_solve(&st, &span, given, 20.0, HAWSER_BRANCH_TAUT, &report) ==
	        HAWSER_ERR_NO_SOLUTION, "20 N is too little: %s", report.message))
		return;
	at = strstr(report.message, "can hang, ");
	least = at ? strtod(at + 10, NULL) : NAN;
	at = strstr(report.message, "at H = ");
	H = at ? strtod(at + 7, NULL) : NAN;
	ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL), "that H");
	close_to(value_of(&st, given), least, 1e-9, "has that tension");
	ok(hawser_statics_solve(&st, &span, given, least*(1.0 - 1e-9), HAWSER_BRANCH_SLACK, NULL) ==
	   HAWSER_ERR_NO_SOLUTION, "a billionth less, slack: none");
	ok(hawser_statics_solve(&st, &span, given, least*(1.0 - 1e-9), HAWSER_BRANCH_TAUT, NULL) ==
	   HAWSER_ERR_NO_SOLUTION, "a billionth less, taut: none");
	ok(!hawser_statics_solve(&taut, &span, given, least*(1.0 + 1e-9), HAWSER_BRANCH_TAUT, NULL) &&
	   !hawser_statics_solve(&slack, &span, given, least*(1.0 + 1e-9), HAWSER_BRANCH_SLACK, NULL),
	   "a billionth more: two");
	ok(taut.H > H && slack.H < H, "one on either side");
	close_to(value_of(&taut, given), least*(1.0 + 1e-9), 1e-14, "taut meets it");
	close_to(value_of(&slack, given), least*(1.0 + 1e-9), 1e-14, "slack meets it");
}

/* Ends, middle, lowest point and frame of the chairlift span and of a falling one. */
static void profile(struct hawser_span span)
{
	struct hawser_statics st;
	struct hawser_profile_point a, b, middle;
	struct hawser_frame_point frame;

	if (!ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_SLACK, NULL),
	        "a slack span with h = %g m", span.h))
		return;
	ok(st.branch == HAWSER_BRANCH_SLACK && st.given == HAWSER_GIVEN_T0, "says what was asked");
	a = hawser_statics_at(&st, 0.0);
	b = hawser_statics_at(&st, st.length0);
	ok(a.x == 0.0 && a.y == 0.0 && b.x == span.d && b.y == span.h, "meets both ends exactly");
	close_to(a.T, st.T0, 1e-15, "T at A");
	close_to(b.T, st.T1, 4e-15, "T at B");
	close_to(st.H*st.H + st.V0*st.V0, st.T0*st.T0, 4e-15, "H, V0 and T0");
	close_to(st.V1 - st.V0, span.rho*span.g*st.length0, 4e-15, "the ends carry the weight");
	middle = hawser_statics_at(&st, -st.eta/st.delta*span.d);
	ok(fabs(middle.slope) < 1e-12, "level at the lowest point: %g", middle.slope);
	close_to(middle.T, st.H, 1e-15, "where the tension is H");
	frame = hawser_statics_frame(&st, 0.3*st.l);
	close_to(frame.strain, hawser_statics_at(&st, 0.3*st.length0).T/span.EA, 4e-15, "strain");
	close_to(frame.ey/frame.ex, frame.u, 4e-16, "tangent");
	close_to(frame.curvature, st.delta*frame.ex*frame.ex, 4e-16, "curvature");
}

static void wrap_scene(void)
{
	struct hawser_scene scene = {
		.cable = {.EA = 400e6, .rho = 6.0}, .span = {250.0, 10.0}, .g = 9.81,
		.tension = {.given = HAWSER_GIVEN_T1, .value = 2e4, .branch = HAWSER_BRANCH_SLACK},
	};
	struct hawser_statics a, b;

	ok(!hawser_statics_scene(&a, &scene, NULL) &&
	   !hawser_statics_solve(&b, &chairlift, HAWSER_GIVEN_T1, 2e4, HAWSER_BRANCH_SLACK, NULL),
	   "a scene");
	ok(a.H == b.H && a.T0 == b.T0 && a.length0 == b.length0, "is the same as its span");
	scene.tension.value = 10.0;
	ok(hawser_statics_scene(&a, &scene, NULL) == HAWSER_ERR_NO_SOLUTION,
	   "no solution, and no report wanted");
}

CASE(unit_statics)
{
	struct hawser_span falls = chairlift, rigid = chairlift, soft = chairlift;
	struct hawser_statics st;

	falls.h = -130.0;
	rigid.EA = INFINITY;
	soft.EA = 700.0;
	refuse_arguments();
	refuse_branch();
	refused(rigid, HAWSER_GIVEN_LENGTH0, 250.1, HAWSER_ERR_NO_SOLUTION, "chord is 250.1999200");
	minimum(chairlift, HAWSER_GIVEN_T0);
	minimum(falls, HAWSER_GIVEN_T0);
	minimum(falls, HAWSER_GIVEN_T1);
	minimum(rigid, HAWSER_GIVEN_T1);
	minimum(soft, HAWSER_GIVEN_T0);
	profile(chairlift);
	profile(falls);
	wrap_scene();
	ok(!hawser_statics_solve(&st, &chairlift, HAWSER_GIVEN_LENGTH0, 200.0, HAWSER_BRANCH_SLACK,
	                         NULL) && st.branch == HAWSER_BRANCH_TAUT,
	   "a length below the chord prestresses an elastic cable; the branch only serves T0 and T1");
	ok(st.length > 250.19 && st.length0 < 200.0*(1.0 + 1e-14), "stretched from %g to %g m",
	   st.length0, st.length);
	return done_testing();
}

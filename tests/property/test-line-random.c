/* Statics of random lines: whatever is returned is an equilibrium (balance, no pull by a sheave,
 * no rope inside a sheave, and the differential equations integrated step by step from A to B), a
 * refusal states the least tension, and other ways to ask have an answer too. The tension at B may
 * belong to several equilibria: with another tension other masses hang in other spans.
 *
 * HAWSER_LONG: 10 000 lines instead of 60.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>

#include "tests/line-judge.h"
#include "tests/tap.h"

/* Largest difference of two solutions of the same line, over the tension. */
static double apart(const struct hawser_line_statics *a, const struct hawser_line_statics *b)
{
	double worst = fmax(fabs(a->T_A - b->T_A), fabs(a->T_B - b->T_B))/a->T_A;

	for (int k = 0; k < a->line->sheaves; k++)
		for (int i = 0; i < 2; i++)
			worst = fmax(worst, fabs(a->contact[k].force[i] - b->contact[k].force[i])/a->T_A);
	return worst;
}

/* The same line from its other end. */
static void mirror(struct line_random *to, const struct line_random *from,
                   const struct hawser_line_statics *st)
{
	int n = from->line.sheaves, count = 0;

	*to = *from;
	to->line.sheave = to->sheave;
	to->line.mass = to->mass;
	to->line.A[0] = -from->line.B[0];
	to->line.A[1] = from->line.B[1];
	to->line.B[0] = -from->line.A[0];
	to->line.B[1] = from->line.A[1];
	for (int k = 0; k < n; k++) {
		to->sheave[k] = from->sheave[n - 1 - k];
		to->sheave[k].centre[0] *= -1.0;
	}
	for (int i = from->line.masses - 1; i >= 0; i--)
		if (from->mass[i].S < st->length0) {
			to->mass[count] = from->mass[i];
			to->mass[count++].S = st->length0 - from->mass[i].S;
		}
	to->line.masses = count;
	to->line.sliding = from->line.sliding == HAWSER_LINE_NONE ? HAWSER_LINE_NONE
	                   : from->line.sliding == HAWSER_LINE_TOWARD_A ? HAWSER_LINE_TOWARD_B
	                   : HAWSER_LINE_TOWARD_A;
	to->line.given = HAWSER_LINE_T_A;
	to->line.value = st->T_B;
}

struct tally {
	int solved, refused, failed, lifted, wrong, other, others;
	double deepest, integrated, end, mirrored, pressed, length;
};

/* The line that is given by another quantity of its solution. */
static void other_givens(struct tally *tally, const struct line_random *r,
                         const struct hawser_line_statics *st)
{
	struct hawser_report report;
	struct hawser_line_statics other;
	struct line_random back;
	struct hawser_line line = r->line;

	mirror(&back, r, st);
	if (!hawser_line_solve(&other, &back.line, &report)) {
		tally->mirrored = fmax(tally->mirrored, fabs(other.T_B/st->T_A - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
	line.given = HAWSER_LINE_T_B;
	line.value = st->T_B;
	if (!hawser_line_solve(&other, &line, &report)) {
		tally->wrong += wrong(&other) != NULL;
		tally->others += apart(st, &other) > 1e-7;
		tally->end = fmax(tally->end, fabs(other.T_B/st->T_B - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
	line.given = HAWSER_LINE_LENGTH0;
	line.value = st->length0;
	while (line.masses && line.mass[line.masses - 1].S > line.value)
		line.masses--;
	if (!hawser_line_solve(&other, &line, &report)) {
		tally->wrong += wrong(&other) != NULL;
		tally->length = fmax(tally->length, fabs(other.length0/st->length0 - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
}

/* The same line with the sheaves that the rope presses, and no others. */
static void only_pressed(struct tally *tally, const struct line_random *r,
                         const struct hawser_line_statics *st)
{
	struct hawser_line_statics other;
	struct line_random fewer = *r;
	struct hawser_report report;
	int count = 0;

	for (int k = 0; k < r->line.sheaves; k++)
		if (st->contact[k].touches)
			fewer.sheave[count++] = r->sheave[k];
	if (count < r->line.sheaves) {
		struct hawser_line line = r->line;

		line.lift = 0;
		if (hawser_line_solve(&other, &line, &report) != HAWSER_ERR_NO_SOLUTION ||
		    !strstr(report.message, "lifts off"))
			tally->other++;
	}
	fewer.line.sheave = fewer.sheave;
	fewer.line.mass = fewer.mass;
	fewer.line.sheaves = count;
	fewer.line.lift = 0;
	if (hawser_line_solve(&other, &fewer.line, &report)) {
		tally->other++;
		return;
	}
	tally->pressed = fmax(tally->pressed, fabs(other.T_B/st->T_B - 1.0));
	hawser_line_statics_clear(&other);
}

/* A tension that is too low: the least one that the report states is right to 1e-6. */
static int least_is_right(struct line_random *r, const char *message)
{
	const char *at = strstr(message, "at least ");
	struct hawser_report report;
	struct hawser_line_statics st;
	double least = at ? strtod(at + 9, NULL) : 0.0;

	if (!(least > r->line.value*(1.0 - 1e-9)))
		return 0;
	r->line.value = least*(1.0 + 1e-6);
	if (hawser_line_solve(&st, &r->line, &report) || wrong(&st))
		return 0;
	hawser_line_statics_clear(&st);
	r->line.value = least*(1.0 - 1e-6);
	if (hawser_line_solve(&st, &r->line, &report))
		return 1;
	hawser_line_statics_clear(&st);
	return 0;
}

static void one(struct tally *tally, int number)
{
	struct line_random r;
	struct hawser_line_statics st;
	struct hawser_report report;
	enum hawser_status status;
	const char *what;
	double miss;

	line_random(&r, number);
	status = hawser_line_solve(&st, &r.line, &report);
	if (status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "too low")) {
		tally->refused++;
		if (number%5 == 0 && !least_is_right(&r, report.message)) {
			printf("# line %d: %s\n", number, report.message);
			tally->wrong++;
		}
		return;
	}
	if (status) {
		printf("# line %d: %s\n", number, report.message);
		tally->failed++;
		return;
	}
	tally->solved++;
	what = wrong(&st);
	if (what) {
		printf("# line %d: %s\n", number, what);
		tally->wrong++;
	}
	for (int k = 0; k < r.line.sheaves; k++)
		if (!st.contact[k].touches) {
			tally->lifted++;
			break;
		}
	tally->deepest = fmax(tally->deepest, inside(&st, 8)/size_of(&r.line));
	miss = integrated(&st, 60);
	if (miss > 1e-6)
		miss = integrated(&st, 2000);
	tally->integrated = isnan(miss) ? INFINITY : fmax(tally->integrated, miss);
	if (number%3 == 0)
		only_pressed(tally, &r, &st);
	if (number%5 == 0)
		other_givens(tally, &r, &st);
	hawser_line_statics_clear(&st);
}

CASE(property_line_random)
{
	struct tally tally = {0};
	int count = getenv("HAWSER_LONG") ? 10000 : 60;

	for (int number = 0; number < count; number++)
		one(&tally, number);
	ok(tally.failed == 0, "%d lines solved (%d with sheaves without contact), %d with too low a "
	   "tension, %d failed", tally.solved, tally.lifted, tally.refused, tally.failed);
	ok(tally.wrong == 0, "%d that are no equilibria", tally.wrong);
	ok(tally.deepest <= 1e-11, "rope in sheaves: %.1e of the line's size at most", tally.deepest);
	ok(tally.integrated <= 1e-7, "integration step by step: %.1e", tally.integrated);
	ok(tally.other == 0, "%d failures of other ways to ask", tally.other);
	ok(tally.pressed <= 1e-11, "without the sheaves that are not pressed: %.1e", tally.pressed);
	ok(tally.end <= 1e-9, "given the tension at B: %.1e (%d have another equilibrium with it)",
	   tally.end, tally.others);
	ok(tally.length <= 1e-9, "given the length: %.1e", tally.length);
	ok(tally.mirrored <= 1e-9, "from the other end: %.1e", tally.mirrored);
	return done_testing();
}

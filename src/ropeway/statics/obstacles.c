/* ropeway/statics/obstacles.c - statics of a span that passes over or under circles, and the limits
 * within which friction holds it.
 *
 * At rest friction leaves the tensions undetermined. With one circle the ratio T_out/T_in of an
 * equilibrium lies between those of the rope that is about to slide toward A and toward B, and each
 * equilibrium between is possible. The state computed with contact.sliding: none is the one without
 * any tangential force. With several circles these two limits are those at which the whole rope
 * begins to slide; on single circles it may be held beyond them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/obstacles.h>
#include "core/report.h"
#include "ropeway/statics/line.h"

#define STEP 2.0  /* factor of the tension by which the length changes more than by round-off */
#define MOST 1e-3 /* largest error of the tensions: three digits */

/* Another equilibrium of the scene; only the lack of memory is a failure. */
static enum hawser_status other(struct hawser_obstacles_limit *limit, const struct hawser_line *line)
{
	limit->status = hawser_line_solve(&limit->st, line, &limit->report);
	return limit->status == HAWSER_ERR_MEMORY ? HAWSER_ERR_MEMORY : HAWSER_OK;
}

static enum hawser_status limits(struct hawser_obstacles_statics *st, struct hawser_report *report)
{
	const struct hawser_line *line = &st->line[0];
	enum hawser_status status;

	st->line[1] = *line;
	st->line[1].given = HAWSER_LINE_LENGTH0;
	st->line[1].value = st->st.length0;
	st->line[1].sheaves = 0;
	status = other(&st->clear, &st->line[1]);
	for (int i = 0; i < line->sheaves; i++)
		st->friction |= (line->sliding == HAWSER_LINE_NONE || line->sliding == HAWSER_LINE_HELD) &&
		                st->st.contact[i].touches &&
		                line->sheave[i].friction > 0.0;
	for (int side = 0; side < 2 && st->friction && !status; side++) {
		st->line[2 + side] = *line;
		st->line[2 + side].sliding = side ? HAWSER_LINE_TOWARD_B : HAWSER_LINE_TOWARD_A;
		status = other(&st->slide[side], &st->line[2 + side]);
	}
	return status ? hawser__no_memory(report, "statics") : HAWSER_OK;
}

/* Where a given length leaves no equilibrium: is the rope too short? The shortest way is that of a rope
 * without weight that does not stretch, at any tension. */
static enum hawser_status explain(enum hawser_status status, const struct hawser_line *line,
                                  struct hawser_report *report)
{
	struct hawser_line tight = *line;
	struct hawser_line_statics st;
	struct hawser_report inner;
	double shortest;

	tight.EA = INFINITY;
	tight.rho = 0.0;
	tight.given = HAWSER_LINE_T_A;
	tight.value = 1.0; /* N */
	tight.sliding = HAWSER_LINE_NONE;
	if (status == HAWSER_ERR_MEMORY || line->given != HAWSER_LINE_LENGTH0 ||
	    hawser_line_solve(&st, &tight, &inner))
		return status;
	shortest = st.length;
	hawser_line_statics_clear(&st);
	if (line->value > shortest)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics",
	                    "tension.length0 = %.9g m is shorter than the shortest way past the obstacles, "
	                    "%.9g m: give a longer rope, or look at the side of each obstacle (above, "
	                    "below)", line->value, shortest);
}

/* Of a given length, ln T changes by `steep` times as much as ln length0, whose round-off that of a few
 * operations is. */
static enum hawser_status judge(struct hawser_obstacles_statics *st, struct hawser_report *report)
{
	struct hawser_line near = st->line[0];
	struct hawser_line_statics other;
	struct hawser_report inner;
	double steep = 1.0;

	near.given = HAWSER_LINE_T_A;
	near.value = STEP*st->st.T_A;
	if (st->line[0].given == HAWSER_LINE_LENGTH0 && !hawser_line_solve(&other, &near, &inner)) {
		steep = fmax(log(STEP)/fabs(log(other.length0/st->st.length0)), 1.0);
		hawser_line_statics_clear(&other);
	}
	st->error = 4.0*DBL_EPSILON*steep;
	return st->error <= MOST ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics",
		               "tension.length0 = %.17g m is so near the shortest way past the obstacles "
		               "that the tension is not determined (relative error %.1e): give a longer "
		               "rope, or T0 or T1",
		               st->line[0].value, st->error);
}

enum hawser_status hawser_obstacles_solve(struct hawser_obstacles_statics *st,
                                          const struct hawser_obstacles *obstacles,
                                          struct hawser_report *report)
{
	enum hawser_status status;

	memset(st, 0, sizeof *st);
	st->line[0] = obstacles->line;
	if (obstacles->history) {
		status = hawser__obstacles_history(st, obstacles, report);
		if (status) {
			hawser_obstacles_statics_clear(st);
			return hawser__in_file(report, status, obstacles->name);
		}
	}
	status = hawser_line_solve(&st->st, &st->line[0], report);
	status = status ? explain(status, &st->line[0], report) : judge(st, report);
	if (!status)
		status = limits(st, report);
	if (status)
		hawser_obstacles_statics_clear(st);
	return hawser__in_file(report, status, obstacles->name);
}

void hawser_obstacles_statics_clear(struct hawser_obstacles_statics *st)
{
	if (!st)
		return;
	hawser_line_statics_clear(&st->st);
	hawser_line_statics_clear(&st->clear.st);
	for (int side = 0; side < 2; side++)
		hawser_line_statics_clear(&st->slide[side].st);
	free(st->held);
	free(st->path.value);
	free(st->path.T);
	free(st->path.grip);
	free(st->path.slid);
	memset(st, 0, sizeof *st);
}

/* Which of the touched circles have friction, turn freely, have a groove. */
struct touched {
	int count, rough, turning, grooves, smooth; /* smooth: the last one without friction, or -1 */
};

static struct touched touched(const struct hawser_obstacles *obstacles,
                              const struct hawser_line_statics *st)
{
	struct touched of = {.smooth = -1};

	for (int i = 0; i < obstacles->line.sheaves; i++) {
		const struct hawser_obstacle *one = &obstacles->obstacle[i];

		if (!st->contact[i].touches)
			continue;
		of.count++;
		of.rough += one->friction > 0.0;
		of.turning += one->rotation == HAWSER_ROTATION_FREE;
		of.grooves += one->groove;
		if (!(one->friction > 0.0))
			of.smooth = i;
	}
	return of;
}

enum hawser_status hawser_obstacles_contact(enum hawser_line_contact_kind *contact, int *loose,
                                            const struct hawser_obstacles *obstacles,
                                            const struct hawser_line_statics *st,
                                            struct hawser_report *report)
{
	const struct touched of = touched(obstacles, st);
	int stick = obstacles->modes >= 0 ? obstacles->modes == HAWSER_LINE_STICK
	                                  : of.rough > 0 && (obstacles->line.sliding == HAWSER_LINE_NONE ||
	                                      obstacles->line.sliding == HAWSER_LINE_HELD);

	*contact = !stick ? HAWSER_LINE_SLIP : of.turning ? HAWSER_LINE_ROLL : HAWSER_LINE_STICK;
	*loose = of.count > 0 && of.grooves == 0;
	if (stick && of.smooth >= 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "obstacles.%s has no friction, so that the rope does not stick to it: give "
		                    "it a friction, or contact.modes: slip",
		                    obstacles->line.sheave[of.smooth].name);
	if (stick && of.turning && of.turning < of.count)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d of %d obstacles turn freely (rotation: free): modes that stick are for "
		                    "all alike: give all the same rotation, or contact.modes: slip", of.turning,
		                    of.count);
	if (of.grooves && of.grooves < of.count)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d of %d obstacles have a groove: modes are for all alike: give all "
		                    "groove: yes, or all groove: no", of.grooves, of.count);
	return HAWSER_OK;
}

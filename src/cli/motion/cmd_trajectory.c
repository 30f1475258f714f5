/* cli/motion/cmd_trajectory.c - hawser trajectory: the path of a towing point, and its derivatives.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/frame/view.h"
#include "core/report.h"
#include "output/structures/structures.h"

#define LAPS 1.0   /* of an orbit without ramp, by default */
#define AFTER 0.25 /* of the ramp's time, shown after it by default */
#define AT_ONCE 60.0 /* s, of straight flight without ramp, by default */
enum { POINTS = 501 /* by default: smooth curves in pictures */ };

struct settings {
	struct cli_common common;
	const char *from, *to;
	int points;
};
static const struct settings defaults = {.points = POINTS};

static const struct cli_option options[] = {
	CLI_TEXT_OPTION(from, "TIME", "first time (the path's)"),
	CLI_TEXT_OPTION(to, "TIME", "last time (the path's; a lap; the ramp and a quarter more)"),
	{"points", 0, "N", "number of times, at equal intervals (501)", CLI_COUNT(points)},
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"The scene's section tow has waypoints, a file of them, a speed or an orbit. Shown are position,",
	"velocity, acceleration, jerk and snap at any time, and the largest of each.",
	NULL,
};

struct result {
	const struct cli_common *common;
	struct hawser_tow tow;
	struct hawser_path_largest largest;
	struct hawser__trajectory_point *point; /* [points] */
	int points;
	double from, to;
};

/* --- fields --- */

HAWSER__LABELS(kind_name, hawser_path_name, enum hawser_path_kind)
HAWSER__LABELS(minimise_name, hawser_minimise_name, enum hawser_minimise)

#define STATE(order) .kind = HAWSER__NUMBERS, .vector = &cli_axes, \
	.offset = offsetof(struct hawser__trajectory_point, state) + (order)*3*sizeof(double), \
	.size = 3*sizeof(double)
static const struct hawser__field point_field[] = {
	{"t", "t", "time", HAWSER__AT(struct hawser__trajectory_point, t), .unit = HAWSER__SECOND},
	{"position", "", "x, y, z, y upwards", STATE(0), .unit = HAWSER__METRE},
	{"velocity", "velocity_", "its derivative by time", STATE(1), .unit = HAWSER__METRE_S},
	{"acceleration", "acceleration_", "the second derivative", STATE(2), .unit = HAWSER__METRE_S2},
	{"jerk", "jerk_", "the third derivative", STATE(3), .unit = HAWSER__METRE_S3},
	{"snap", "snap_", "the fourth derivative", STATE(4), .unit = HAWSER__METRE_S4},
	HAWSER__END,
};
static const struct hawser__list point_list =
	HAWSER__STORED_ROWS(struct result, point, points, point_field);

#define OF(member) HAWSER__AT(struct hawser_waypoint, member)
static const struct hawser__field waypoint_field[] = {
	{"t", NULL, "time", OF(t), .unit = HAWSER__SECOND},
	{"position", NULL, "x, y, z", .kind = HAWSER__NUMBERS, .unit = HAWSER__METRE,
	 .offset = offsetof(struct hawser_waypoint, at), .size = 3*sizeof(double)},
	HAWSER__END,
};
#undef OF

/* Largest norms of derivatives, and when. */
#define PLACE(member, order) .kind = HAWSER__REAL, .size = sizeof(double), \
	.offset = offsetof(struct hawser_path_largest, member) + (order)*sizeof(double)
static const struct hawser__field largest_field[] = {
	{"speed", NULL, "norm of the velocity", PLACE(value, 1), .unit = HAWSER__METRE_S},
	{"speed_t", NULL, "when it is largest", PLACE(t, 1), .unit = HAWSER__SECOND},
	{"acceleration", NULL, "norm of the acceleration", PLACE(value, 2), .unit = HAWSER__METRE_S2},
	{"acceleration_t", NULL, "when it is largest", PLACE(t, 2), .unit = HAWSER__SECOND},
	{"jerk", NULL, "norm of the jerk", PLACE(value, 3), .unit = HAWSER__METRE_S3},
	{"jerk_t", NULL, "when it is largest", PLACE(t, 3), .unit = HAWSER__SECOND},
	{"snap", NULL, "norm of the snap", PLACE(value, 4), .unit = HAWSER__METRE_S4},
	{"snap_t", NULL, "when it is largest", PLACE(t, 4), .unit = HAWSER__SECOND},
	HAWSER__END,
};

/* Only paths through waypoints have them. */
HAWSER__GIVEN(by_waypoints, struct result, of->tow.path.kind == HAWSER_PATH_WAYPOINTS)

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field field[] = {
	{"kind", NULL, "waypoints, straight or orbit",
	 HAWSER__LABEL_AT(struct result, tow.path.kind, kind_name)},
	{"minimise", NULL, "snap, jerk, acceleration or none",
	 HAWSER__LABEL_AT(struct result, tow.path.minimise, minimise_name), .given = by_waypoints},
	{"cost", NULL, "integral of the squared norm of what is minimised (none: of the snap), SI",
	 OF(tow.path.cost), .given = by_waypoints},
	{"smooth", NULL, "order up to which derivatives are continuous", OF(tow.path.smooth)},
	{"error", NULL, "estimated relative error by round-off", OF(tow.path.error), .given = by_waypoints},
	{"largest", NULL, "in the range of time", HAWSER__PART_OF(struct result, largest, largest_field)},
	{"waypoints", NULL, "that the scene or its file gives",
	 HAWSER__STORED(struct result, tow.waypoint, tow.waypoints, waypoint_field), .given = by_waypoints},
	{"points", NULL, "of the path", HAWSER__OBJECTS_OF(point_list)},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_trajectory_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", field, 1},
	{NULL, NULL, 0},
};

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;
	const struct hawser_path *path = &result->tow.path;

	return cli_si_head(result->common, "trajectory", path->kind == HAWSER_PATH_ORBIT ? "circle"
	                   : path->kind == HAWSER_PATH_STRAIGHT ? "straight line"
	                   : path->minimise == HAWSER_MINIMISE_NOTHING ? "polynomials of least degree"
	                   : "polynomials by one banded system", NULL, 0);
}

static void comments(struct hawser__table *table, const void *of)
{
	static const char *const name[] = {"position", "speed", "acceleration", "jerk", "snap"};
	static const char *const unit[] = {"m", "m/s", "m/s^2", "m/s^3", "m/s^4"};
	const struct result *result = of;
	const struct hawser_path *path = &result->tow.path;
	static const char *const squared[] = {"m^2/s^7", "m^2/s^5", "m^2/s^3", "m^2/s^7"};
	const struct hawser__shown_unit cost = hawser__shown_unit(squared[path->minimise]);

	if (path->kind == HAWSER_PATH_WAYPOINTS)
		hawser__table_comment(table, "%d waypoints from t = %.10g s to %.10g s; minimised: %s",
		                      result->tow.waypoints, path->from, path->to,
		                      hawser_minimise_name(path->minimise));
	if (path->kind == HAWSER_PATH_WAYPOINTS)
		hawser__table_comment(table, "integral of the squared %s = %.10g %s; derivatives are "
		                      "continuous up to order %d; estimated relative error %.1e",
		                      path->minimise == HAWSER_MINIMISE_NOTHING ? "snap"
		                      : hawser_minimise_name(path->minimise), path->cost/cost.per, cost.name,
		                      path->smooth, path->error);
	if (path->kind == HAWSER_PATH_ORBIT)
		hawser__table_comment(table, "radius = %.10g m, speed = %.10g m/s, a lap in %.10g s",
		                      path->radius, path->speed,
		                      2.0*acos(-1.0)*path->radius/fabs(path->speed));
	if (path->ramp_time > 0.0)
		hawser__table_comment(table, "the speed grows in %.10g s, by the law %s", path->ramp_time,
		                      path->ramp == HAWSER_PATH_RAMP_ERF ? "erf" : "smooth");
	for (int k = 1; k < HAWSER_PATH_ORDERS; k++)
		hawser__table_comment(table, "largest %s = %.10g %s at t = %.10g s", name[k],
		                      result->largest.value[k], unit[k], result->largest.t[k]);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;
	struct hawser__trajectory_picture picture = {.point = result->point, .points = result->points};

	for (int i = 0; i < result->tow.waypoints; i++) {
		const struct hawser_waypoint *one = &result->tow.waypoint[i];

		if (one->t < result->from || one->t > result->to)
			continue;
		if (!picture.waypoints++) {
			picture.waypoint = one;
			picture.first = i;
		}
	}
	return hawser__plot_trajectory(path, &picture, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &point_list, .fields = field, .draw = draw};

/* --- the command --- */

/* The range that is shown: that of the path or, if it has no end, a part that shows all of it. */
static double default_end(const struct hawser_path *path)
{
	double lap = path->kind == HAWSER_PATH_ORBIT && path->speed != 0.0
	             ? LAPS*2.0*acos(-1.0)*path->radius/fabs(path->speed) : 0.0;

	if (path->kind == HAWSER_PATH_WAYPOINTS)
		return path->to;
	if (lap > 0.0)
		return path->ramp_time + lap;
	return path->ramp_time > 0.0 ? (1.0 + AFTER)*path->ramp_time : AT_ONCE;
}

static enum hawser_status range(struct result *result, const struct settings *s,
                                struct hawser_report *report)
{
	const struct hawser_path *path = &result->tow.path;
	enum hawser_status status;

	result->from = path->from;
	result->to = default_end(path);
	status = cli_quantity(&result->from, s->from, "s", CLI_ANY, "trajectory", "from", report);
	if (!status)
		status = cli_quantity(&result->to, s->to, "s", CLI_ANY, "trajectory", "to", report);
	if (!status && !(result->from < result->to))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "trajectory", "the range of time is from "
		                      "%.10g s to %.10g s: --from must be less than --to", result->from,
		                      result->to);
	return status;
}

static enum hawser_status sample(struct result *result, int points, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	result->point = calloc((size_t)points, sizeof *result->point);
	if (!result->point)
		return hawser__no_memory(report, "trajectory");
	result->points = points;
	for (int i = 0; i < points && !status; i++) {
		struct hawser__trajectory_point *one = &result->point[i];
		double part = (double)i/(points - 1);

		one->t = i < points - 1 ? (1.0 - part)*result->from + part*result->to : result->to;
		status = hawser_path_at(one->state, &result->tow.path, one->t, report);
	}
	return status;
}

/* A warning [size] of a path that is not smooth; "" of others. */
static void roughness(char *text, size_t size, const struct hawser_path *path)
{
	static const char *const name[] = {"velocity", "acceleration"};

	*text = '\0';
	if (path->smooth < 2)
		snprintf(text, size, "the %s of the path jumps at waypoints: give more derivatives there, or "
		         "minimise snap", name[path->smooth]);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;
	struct result result = {.common = &s->common};
	char warning[128];
	enum hawser_status status = cli_outputs_check(&s->common, report);

	if (!status)
		status = cli_read_tow(&result.tow, &s->common, report);
	if (!status)
		status = range(&result, s, report);
	if (!status)
		status = sample(&result, s->points, report);
	if (!status)
		status = hawser_path_largest(&result.largest, &result.tow.path, result.from, result.to,
		                                   report);
	if (!status) {
		roughness(warning, sizeof warning, &result.tow.path);
		if (*warning)
			cli_warn(warning);
		status = cli_show(&s->common, &showing, &result, report);
	}
	free(result.point);
	hawser_tow_clear(&result.tow);
	return status;
}

const struct cli_command cli_trajectory = {
	"trajectory", "SCENE", "Path of a towing point: waypoints, minimum snap, orbits", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_trajectory_listing,
	.takes = CLI_TOW,
};

/* cli/motion/cmd_tow_steady.c - hawser tow steady: a towed body in straight flight and in an orbit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/frame/view.h"
#include "output/structures/structures.h"

static const struct cli_option options[] = {
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"The scene has tow (speed or orbit), cable, air or water, and body; the state is that at the full",
	"speed. The cable is a string, or with EI a rod that bends.",
	NULL,
};

struct result {
	const struct cli_common *common;
	struct hawser_tow tow;
	struct hawser_tow_steady steady;
};

/* --- fields --- */

#define OF(member) HAWSER__AT(struct hawser_tow_point, member)
static const struct hawser__field point_field[] = {
	{NULL, "s", "unstretched length from the towing point", OF(s), .unit = HAWSER__METRE},
	{NULL, "", "x, y, z, y upwards", OF(x), .unit = HAWSER__METRE, .vector = &cli_axes},
	{NULL, "T", "tension", OF(tension), .unit = HAWSER__NEWTON},
	{NULL, "along_", "unit vector along the cable, away from the towing point", OF(along),
	 .vector = &cli_axes},
	{NULL, "curvature", "of a rod; 0 of a string", OF(curvature), .unit = HAWSER__PER_M},
	HAWSER__END,
};
#undef OF
static const struct hawser__list point_list =
	HAWSER__STORED_ROWS(struct result, steady.point, steady.points, point_field);

#define OF(member) HAWSER__AT(struct hawser_tow_point, member)
static const struct hawser__field place_field[] = {
	{"s", NULL, "unstretched length from the towing point", OF(s)},
	{"x", NULL, "its place", OF(x[0])},
	{"y", NULL, "", OF(x[1])},
	{"z", NULL, "", OF(x[2])},
	HAWSER__END,
};
static const struct hawser__field tension_field[] = {
	{"tension", NULL, "at the points of the shape", OF(tension), .unit = HAWSER__NEWTON},
	HAWSER__END,
};
#undef OF
static const struct hawser__list place_list =
	HAWSER__STORED_ROWS(struct result, steady.point, steady.points, place_field);
static const struct hawser__list tension_list =
	HAWSER__STORED_ROWS(struct result, steady.point, steady.points, tension_field);

HAWSER__GIVEN(has_ring, struct result, of->tow.body.kind == HAWSER_TOW_RING)

HAWSER__GIVEN(in_orbit, struct result, of->steady.spin != 0.0)

#define OF(member) HAWSER__AT(struct hawser_tow_state, member)
static const struct hawser__field state_field[] = {
	{"radius", NULL, "of the free end about the axis of the orbit", OF(radius), .unit = HAWSER__METRE},
	{"lag", NULL, "angle about the axis by which the free end is behind", OF(lag),
	 .unit = HAWSER__RADIAN},
	{"depth", NULL, "of the free end below the towing point", OF(depth), .unit = HAWSER__METRE},
	{"tension_top", NULL, "at the towing point", OF(tension_top), .unit = HAWSER__NEWTON},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct result, steady.member)
static const struct hawser__field body_field[] = {
	{"position", NULL, "of the body's centre, x, y, z; without a body the free end", OF(centre),
	 .unit = HAWSER__METRE},
	{"attitude", NULL, "quaternion w, x, y, z that turns -y into the axis of the ring (of others: "
	 "the cable's direction at its end), without twist", OF(attitude)},
	{"rotation", NULL, "the same as a rotation vector", OF(rotation), .unit = HAWSER__RADIAN},
	{"force", NULL, "on the cable", OF(body_force), .unit = HAWSER__NEWTON},
	HAWSER__END,
};
static const struct hawser__field field[] = {
	{"tilt", NULL, "angle of the body's axis to the vertical; negative if it is behind the towing "
	 "point (at rest: toward -x)", OF(tilt), .unit = HAWSER__RADIAN},
	{"tension_top", NULL, "at the towing point", OF(tension_top), .unit = HAWSER__NEWTON},
	{"tension_end", NULL, "at the free end", OF(tension_end), .unit = HAWSER__NEWTON},
	{"end", NULL, "the free end of the cable, x, y, z", OF(end), .unit = HAWSER__METRE},
	{"depth", NULL, "of the free end below the towing point", OF(state.depth), .unit = HAWSER__METRE},
	{"radius", NULL, "of an orbit: of the free end about its axis", OF(state.radius),
	 .unit = HAWSER__METRE, .given = in_orbit},
	{"lag", NULL, "of an orbit: angle by which the free end is behind", OF(state.lag),
	 .unit = HAWSER__RADIAN, .given = in_orbit},
	{"spin", NULL, "of an orbit: angular velocity about y", OF(spin), .unit = HAWSER__RADIAN_S,
	 .given = in_orbit},
	{"body", NULL, "at the end", HAWSER__OBJECT_OF(body_field)},
	{"residual", NULL, "largest of the distance of the cable's end from the towing point over its "
	 "length, and the moment on the body over offset times force", OF(residual)},
	{"mesh_error", NULL, "largest change of a point if the number of elements is halved, and error "
	 "of a point by the segments of a ring", OF(mesh_error), .unit = HAWSER__METRE},
	{"ring_error", NULL, "error by the segments of a ring: of its force, relative, and of its axis "
	 "(rad), the larger; null: not known", OF(ring_error), .given = has_ring},
	{"bent", NULL, "whether the cable is a rod (EI), not a string",
	 HAWSER__FLAG_AT(struct result, steady.bent)},
	{"raised", NULL, "elements, of twice those of the scene, whose EI was raised to 1 % of T h^2",
	 OF(raised)},
	{"bending", NULL, "largest sqrt(EI/T), the length near the ends within which bending matters; 0 "
	 "without EI", OF(bending), .unit = HAWSER__METRE},
	{"others", NULL, "further steady states of an orbit",
	 HAWSER__STORED_WITHIN(struct result, steady.other, steady.others, state_field),
	 .given = in_orbit},
	{"shape", NULL, "[[s, x, y, z], ...] (m)", HAWSER__ROWS_OF(place_list), .flags = HAWSER__BRIEF},
	{"", NULL, "", HAWSER__ARRAYS_OF(tension_list)},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_tow_steady_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", field, 1},
	{NULL, NULL, 0},
};

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(result->common, "tow steady", result->steady.bent
	                   ? "geometrically exact rod, elements of order 2, from the string"
	                   : "string from its free end, Runge-Kutta of order 4", NULL, 0);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_tow_steady *s = &result->steady;

	if (result->tow.water.density > 0.0)
		hawser__table_comment(table, "g = %.10g m/s^2, water %.6g kg/m^3 below y = %.6g m",
		                      result->tow.g, result->tow.density, result->tow.water.surface);
	else
		hawser__table_comment(table, "g = %.10g m/s^2, air %.6g kg/m^3, wind [%.6g, %.6g, %.6g] m/s",
		                      result->tow.g, result->tow.density, result->tow.wind[0],
		                      result->tow.wind[1], result->tow.wind[2]);
	hawser__table_comment(table, "tension: %.9g N at the towing point, %.9g N at the free end",
	                      s->tension_top, s->tension_end);
	hawser__table_comment(table, "free end at [%.9g, %.9g, %.9g] m, %.9g m below the towing point",
	                      s->end[0], s->end[1], s->end[2], s->state.depth);
	if (s->spin != 0.0)
		hawser__table_comment(table, "orbit: radius of the free end = %.9g m, lag = %.9g rad",
		                      s->state.radius, s->state.lag);
	hawser__table_comment(table, "tilt = %.9g rad", s->tilt);
	if (result->tow.body.kind != HAWSER_TOW_NO_BODY)
		hawser__table_comment(table, "body at [%.9g, %.9g, %.9g] m", s->centre[0], s->centre[1],
		                      s->centre[2]);
	hawser__table_comment(table, "residual %.1e, mesh error %.1e m", s->residual, s->mesh_error);
	if (result->tow.body.kind == HAWSER_TOW_RING)
		hawser__table_comment(table, "segments of the ring: error %.1e of its force, and rad of its "
		                      "axis: body.ring.segments makes it smaller", s->ring_error);
	if (s->bent)
		hawser__table_comment(table, "bending matters most within some %.3g m of the ends", s->bending);
	if (s->raised)
		hawser__table_comment(table, "EI is below 1 %% of T h^2 in %d of %d elements and was raised to "
		                      "that: give cable.segments.elements more to see its effect", s->raised,
		                      2*(s->points - 1));
	for (int i = 0; i < s->others; i++)
		hawser__table_comment(table, "another steady state: radius = %.9g m, lag = %.9g rad, depth = "
		                      "%.9g m, tension %.9g N", s->other[i].radius, s->other[i].lag,
		                      s->other[i].depth, s->other[i].tension_top);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_tow(path, &result->tow, &result->steady, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &point_list, .fields = field, .draw = draw};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct cli_common *common = context;
	struct result result = {.common = common};
	enum hawser_status status = cli_outputs_check(common, report);

	if (!status)
		status = cli_read_tow(&result.tow, common, report);
	if (!status)
		status = hawser_tow_steady_solve(&result.steady, &result.tow, report);
	if (!status)
		status = cli_show(common, &showing, &result, report);
	hawser_tow_steady_clear(&result.steady);
	hawser_tow_clear(&result.tow);
	return status;
}

const struct cli_command cli_tow_steady = {
	"tow steady", "SCENE", "Towed body in steady flight: shape, tension, tilt", notes, options,
	NULL, sizeof(struct cli_common), 1, run, cli_tow_steady_listing,
	.takes = CLI_TOW,
};

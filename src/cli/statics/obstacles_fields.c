/* cli/statics/obstacles_fields.c - columns and keys of the statics of a span over obstacles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/statics/statics_kinds.h"

/* the end of a field's row */
#define NEWTON .unit = HAWSER__NEWTON /* a force */
#define METRE .unit = HAWSER__METRE   /* a length */
#define RADIAN .unit = HAWSER__RADIAN /* an angle */

HAWSER__GIVEN(touched, struct cli_obstacle, of->touches)

static int passed(const void *row, const void *parent)
{
	return !touched(row, parent);
}

#define OF(member) HAWSER__AT(struct cli_obstacle, member), .given = touched
const struct hawser__field cli_obstacle_field[] = {
	{"name", NULL, "name of the obstacle", HAWSER__AT(struct cli_obstacle, name)},
	{"side", NULL, "above or below: where the rope passes", HAWSER__AT(struct cli_obstacle, side)},
	{"rotation", NULL, "locked, free or drive", HAWSER__AT(struct cli_obstacle, rotation)},
	{"touches", NULL, "whether the rope touches it", HAWSER__FLAG_AT(struct cli_obstacle, touches)},
	{"clearance", NULL, "distance from the rope, if it does not",
	 HAWSER__AT(struct cli_obstacle, c.clearance), METRE, .given = passed},
	{"T_in", NULL, "tension on the side of end A", OF(c.T_in), NEWTON},
	{"T_out", NULL, "tension on the side of end B", OF(c.T_out), NEWTON},
	{"H_in", NULL, "horizontal tension on the side of end A", OF(H_in), NEWTON},
	{"H_out", NULL, "horizontal tension on the side of end B", OF(H_out), NEWTON},
	{"angle_in", NULL, "slope angle of the rope on the side of end A", OF(c.angle_in), RADIAN},
	{"angle_out", NULL, "the same on the side of end B", OF(c.angle_out), RADIAN},
	{"wrap", NULL, "angle of contact", OF(c.wrap), RADIAN},
	{"from", NULL, "first point of contact, [x, y]", OF(from), METRE},
	{"to", NULL, "last point of contact, [x, y]", OF(to), METRE},
	{"reaction", NULL, "force of the obstacle on the rope, [x, y]", OF(c.force), NEWTON},
	{"pressing", NULL, "force by which the rope is pressed on the obstacle", OF(pressing), NEWTON},
	{"pressure", NULL, "least normal force per length of contact; 0 of a point", OF(c.pressure_min),
	 .unit = HAWSER__NEWTON_M},
	{"margin", NULL, "friction*wrap - |ln(T_out/T_in)|: below 0 the rope slides at rest",
	 OF(c.margin)},
	{"T_out_min", NULL, "least T_out that friction holds at this T_in", OF(c.T_out_min), NEWTON},
	{"T_out_max", NULL, "largest T_out that friction holds at this T_in", OF(c.T_out_max), NEWTON},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_obstacle_span, member)
#define LIMIT .flags = HAWSER__NULL, .when = CLI_OBSTACLES_FRICTION /* the end of a field's row */
static const struct hawser__field span_field[] = {
	{"name", "span", "free part of the rope, from end or obstacle to end or obstacle", OF(label)},
	{"H", "H", "horizontal tension", OF(H), NEWTON},
	{"T_from", "T_from", "tension at its beginning, the side of end A", OF(T_from), NEWTON},
	{"T_to", "T_to", "tension at its end", OF(T_to), NEWTON},
	{"angle_from", "angle_from", "slope angle at its beginning", OF(angle_from), RADIAN},
	{"angle_to", "angle_to", "slope angle at its end", OF(angle_to), RADIAN},
	{"sag", "sag", "largest vertical distance from its chord", OF(sag), METRE},
	{"length0", "length0", "unstretched length", OF(length0), METRE},
	{"from", NULL, "its beginning, [x, y]", OF(from), METRE},
	{"to", NULL, "its end, [x, y]", OF(to), METRE},
	{"H_toward_A", "H_toward_A", "H of the rope about to slide toward A; null: no such "
	 "equilibrium with the same contacts", OF(H_toward[0]), NEWTON, LIMIT},
	{"H_toward_B", "H_toward_B", "the same toward B", OF(H_toward[1]), NEWTON, LIMIT},
	HAWSER__END,
};
#undef LIMIT
#undef OF
const struct hawser__list cli_obstacle_span_list =
	HAWSER__STORED_ROWS(struct cli_obstacles, span, spans, span_field);

#define OF(member) HAWSER__AT(struct cli_obstacle_point, member)
static const struct hawser__field point_field[] = {
	{"S", "S", "unstretched arclength from end A", OF(S), METRE},
	{"x", "x", "distance from end A", OF(x), METRE},
	{"y", "y", "height above end A", OF(y), METRE},
	{"angle", "angle", "slope angle", OF(angle), RADIAN},
	{"T", "T", "tension", OF(T), NEWTON},
	{"y_clear", "y_clear", "height of the same rope without obstacles at this x", OF(y_clear), METRE,
	 .flags = HAWSER__OMIT},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_obstacle_point_list =
	HAWSER__STORED_ROWS(struct cli_obstacles, point, points, point_field);

static const char *sliding_word(const void *row)
{
	static const char *const word[] = {"none", "toward-A", "toward-B", "history"};
	const struct cli_obstacles *of = row;

	return word[of->scene.line.sliding];
}

static const char *why_of(const struct hawser_obstacles_limit *limit)
{
	return limit->status ? limit->report.message : "";
}

/* Another equilibrium: the state of its ends, or why there is none. */
#define OF(member) HAWSER__AT(struct hawser_line_statics, member)
static const struct hawser__field ends_field[] = {
	{"T0", NULL, "tension at end A", OF(T_A), NEWTON},
	{"T1", NULL, "tension at end B", OF(T_B), NEWTON},
	{"angle0", NULL, "slope angle at end A", OF(angle_A), RADIAN},
	{"angle1", NULL, "slope angle at end B", OF(angle_B), RADIAN},
	{"length0", NULL, "unstretched length", OF(length0), METRE},
	{"length", NULL, "stretched length", OF(length), METRE},
	{"reaction_A", NULL, "force of end A on the rope, [x, y]", OF(reaction_A), NEWTON},
	{"reaction_B", NULL, "force of end B on the rope, [x, y]", OF(reaction_B), NEWTON},
	HAWSER__END,
};
static const struct hawser__field defect_field[] = {
	{"closure", NULL, "largest distance of the rope from what it has to meet", OF(closure), METRE},
	{"balance", NULL, "largest defect of the balance of forces", OF(balance), NEWTON},
	HAWSER__END,
};
#undef OF

HAWSER__GIVEN(solved, struct hawser_obstacles_limit, of->status == HAWSER_OK)

static const char *why_word(const void *row)
{
	return why_of(row);
}

static const struct hawser__field limit_field[] = {
	{"why", NULL, "why there is no such equilibrium, if there is none", HAWSER__TEXT_BY(why_word),
	 .flags = HAWSER__OMIT},
	{"", NULL, "", HAWSER__PART_OF(struct hawser_obstacles_limit, st, ends_field), .given = solved},
	HAWSER__END,
};

static void path_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_obstacles *of = row;
	const struct hawser_obstacles_path *path = &of->st.path;
	int sheaves = of->scene.line.sheaves;
	json_t *list;

	if (!of->scene.history)
		return;
	list = hawser__json_array(json, into, "path");
	for (int i = 0; i < path->points; i++) {
		json_t *to = hawser__json_object(json, list, NULL);

		hawser__json_number(json, to, "value", path->value[i]);
		hawser__json_number(json, to, "T0", path->T[2*i]);
		hawser__json_number(json, to, "T1", path->T[2*i + 1]);
		hawser__json_numbers(json, to, "grip", path->grip + i*sheaves, sheaves, 1.0);
		hawser__json_numbers(json, to, "slid", path->slid + i*sheaves, sheaves, 1.0);
	}
}

#define PART(member, fields) HAWSER__PART_OF(struct cli_obstacles, member, fields)
const struct hawser__field cli_obstacles_field[] = {
	{"sliding", NULL, "none, toward-A, toward-B or history", HAWSER__TEXT_BY(sliding_word)},
	{"", NULL, "", PART(st.st, ends_field)},
	{"obstacles", NULL, "in the order of x",
	 HAWSER__STORED(struct cli_obstacles, obstacle, obstacles, cli_obstacle_field)},
	{"spans", NULL, "free parts of the rope",
	 HAWSER__STORED(struct cli_obstacles, span, spans, span_field)},
	{"path", NULL, "with sliding: history, states from the first to the last: value (N or m), T0, T1 "
	 "(N), grip (friction that acts at each obstacle, > 0: T grows toward B), slid (m of rope that has "
	 "passed it toward B)", HAWSER__CALLS(path_json)},
	{"toward_A", NULL, "with sliding: none or history and friction, the rope about to slide toward A",
	 PART(st.slide[0], limit_field), .when = CLI_OBSTACLES_FRICTION},
	{"toward_B", NULL, "the same toward B", PART(st.slide[1], limit_field),
	 .when = CLI_OBSTACLES_FRICTION, .flags = HAWSER__BRIEF},
	{"clear", NULL, "the same unstretched rope between the ends without obstacles",
	 PART(st.clear, limit_field), .flags = HAWSER__BRIEF},
	{"", NULL, "", PART(st.st, defect_field)},
	{"error", NULL, "estimated relative error of the tensions by round-off",
	 HAWSER__AT(struct cli_obstacles, st.error)},
	{"profile_columns", NULL, "columns of the profile", HAWSER__KEYS_OF(cli_obstacle_point_list)},
	{"profile", NULL, "points: lists of these columns", HAWSER__ROWS_OF(cli_obstacle_point_list)},
	HAWSER__END,
};
#undef PART

const struct cli_listing cli_obstacles_listing[] = {
	{"Columns of a span over obstacles:", point_field, 0},
	{"Columns of a span over obstacles with --spans:", span_field, 0},
	{"Keys of JSON of a span over obstacles:", cli_obstacles_field, 1},
	{NULL, NULL, 0},
};

unsigned cli_obstacles_view(const struct cli_obstacles *of)
{
	return of->st.friction ? CLI_OBSTACLES_FRICTION : 0u;
}

/* cli/statics/ropeway_fields.c - columns and keys of the statics of a ropeway.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/statics/statics_kinds.h"

/* the end of a field's row */
#define NEWTON .unit = HAWSER__NEWTON /* a force */
#define METRE .unit = HAWSER__METRE   /* a length */
#define RADIAN .unit = HAWSER__RADIAN /* an angle */

/* The range of a quantity, in JSON. */
#define OF(member) HAWSER__AT(struct hawser_ropeway_range, member)
static const struct hawser__field range_field[] = {
	{"min", NULL, "least value, in the SI unit of the quantity", OF(min)},
	{"max", NULL, "largest value", OF(max)},
	{"at_min", NULL, "the phase of the least value", OF(at_min), METRE},
	{"at_max", NULL, "the phase of the largest value", OF(at_max), METRE},
	HAWSER__END,
};
#undef OF
#define RANGE(type, member) HAWSER__PART_OF(type, member, range_field), .flags = HAWSER__BRIEF

/* --- towers --- */

#define OF(member) HAWSER__AT(struct cli_ropeway_tower, member)
static const struct hawser__field tower_field[] = {
	{NULL, "lane", "up or down", OF(lane)},
	{"name", "tower", "name of the tower", OF(name)},
	{"battery", "battery", "support or compression", OF(battery)},
	{"touches", "touches", "number of sheaves that the rope presses", OF(c.touches)},
	{"T_in", "T_in", "tension on the side of the bottom station", OF(c.T_in), NEWTON},
	{"T_out", "T_out", "tension on the side of the top station", OF(c.T_out), NEWTON},
	{"angle_in", "angle_in", "slope angle of the rope on the side of the bottom station",
	 OF(c.angle_in), RADIAN},
	{"angle_out", "angle_out", "the same on the side of the top station", OF(c.angle_out), RADIAN},
	{"wrap", "wrap", "angle of contact, a sum over the sheaves", OF(c.wrap), RADIAN},
	{"reaction", NULL, "force of the battery on the rope, [x, y]", OF(c.reaction), NEWTON},
	{NULL, "reaction_x", "force of the battery on the rope along x", OF(c.reaction[0]), NEWTON},
	{NULL, "reaction_y", "the same along y: above 0 of a support", OF(c.reaction[1]), NEWTON},
	{"pressing", "pressing", "force by which the rope is pressed on the battery", OF(c.pressing),
	 NEWTON},
	{"pressure", "pressure", "least normal force per length of contact; 0 of a point",
	 OF(c.pressure), .unit = HAWSER__NEWTON_M},
	{"margin", "margin", "friction*wrap - |ln(T_out/T_in)|", OF(c.margin)},
	{"T_out_min", NULL, "least T_out that friction would hold at this T_in", OF(c.T_out_min),
	 NEWTON},
	{"T_out_max", NULL, "largest T_out that friction would hold at this T_in", OF(c.T_out_max),
	 NEWTON},
	{"sheave_force", "sheave_force", "largest force of one sheave", OF(c.sheave_force), NEWTON},
	{"sheave_wrap", "sheave_wrap", "largest deflection at one sheave", OF(c.sheave_wrap), RADIAN},
	{"clearance", NULL, "distance from the rope, if it is not touched", OF(c.clearance), METRE},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_ropeway_tower_list =
	HAWSER__STORED_ROWS(struct cli_ropeway, tower, towers, tower_field);

/* --- spans --- */

HAWSER__OF(eta, double, struct cli_ropeway_span, tan(of->s.angle_from))

#define OF(member) HAWSER__AT(struct cli_ropeway_span, member)
static const struct hawser__field span_field[] = {
	{NULL, "lane", "up or down", OF(lane)},
	{"name", "span", "from the one tower to the next", OF(label)},
	{"T_from", "T_from", "tension at its lower end, the side of the bottom station", OF(s.T_from),
	 NEWTON},
	{"T_to", "T_to", "tension at its other end", OF(s.T_to), NEWTON},
	{"T_min", "T_min", "least tension", OF(s.T_min), NEWTON},
	{"T_max", "T_max", "largest tension", OF(s.T_max), NEWTON},
	{"eta", "eta", "slope at its beginning, vertical over horizontal force", HAWSER__BY(eta)},
	{"angle_from", "angle_from", "slope angle at its beginning", OF(s.angle_from), RADIAN},
	{"angle_to", "angle_to", "slope angle at its end", OF(s.angle_to), RADIAN},
	{"sag", "sag", "largest vertical distance from the chord", OF(s.sag), METRE},
	{"length0", "length0", "unstretched length, from contact to contact", OF(s.length0), METRE},
	{"length", "length", "stretched length", OF(s.length), METRE},
	{"from", NULL, "its beginning, [x, y]", OF(s.from), METRE},
	{"to", NULL, "its end, [x, y]", OF(s.to), METRE},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_ropeway_span_list =
	HAWSER__STORED_ROWS(struct cli_ropeway, span, spans, span_field);

/* --- profile --- */

#define OF(member) HAWSER__AT(struct cli_ropeway_point, member)
static const struct hawser__field point_field[] = {
	{"lane", "lane", "up or down", OF(lane)},
	{"S", "S", "unstretched length from the bottom station", OF(S), METRE},
	{"x", "x", "horizontal position", OF(x), METRE},
	{"y", "y", "height", OF(y), METRE},
	{"angle", "angle", "slope angle", OF(angle), RADIAN},
	{"T", "T", "tension", OF(T), NEWTON},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_ropeway_point_list =
	HAWSER__STORED_ROWS(struct cli_ropeway, point, points, point_field);

/* --- worst values --- */

#define OF(member) HAWSER__AT(struct cli_ropeway_worst, r.member)
static const struct hawser__field tower_worst_field[] = {
	{NULL, "lane", "up or down", HAWSER__AT(struct cli_ropeway_worst, lane)},
	{NULL, "tower", "name of the tower", HAWSER__AT(struct cli_ropeway_worst, name)},
	{NULL, "T_max", "largest tension at the tower", OF(T.max), NEWTON},
	{NULL, "T_max_phase", "its phase", OF(T.at_max), METRE},
	{NULL, "T_min", "least tension at the tower", OF(T.min), NEWTON},
	{NULL, "T_min_phase", "its phase", OF(T.at_min), METRE},
	{NULL, "pressing_min", "least force by which the rope is pressed on the battery",
	 OF(pressing.min), NEWTON},
	{NULL, "pressing_min_phase", "its phase", OF(pressing.at_min), METRE},
	{NULL, "pressing_max", "largest such force", OF(pressing.max), NEWTON},
	{NULL, "pressing_max_phase", "its phase", OF(pressing.at_max), METRE},
	{NULL, "pressure_min", "least normal force per length of contact", OF(pressure.min),
	 .unit = HAWSER__NEWTON_M},
	{NULL, "pressure_min_phase", "its phase", OF(pressure.at_min), METRE},
	{NULL, "reaction_y_min", "least vertical force of the battery", OF(reaction_y.min), NEWTON},
	{NULL, "reaction_y_max", "largest vertical force of the battery", OF(reaction_y.max), NEWTON},
	{NULL, "angle_in_min", "least slope angle on the side of the bottom station", OF(angle_in.min),
	 RADIAN},
	{NULL, "angle_in_max", "largest slope angle there", OF(angle_in.max), RADIAN},
	{NULL, "angle_out_min", "least slope angle on the side of the top station", OF(angle_out.min),
	 RADIAN},
	{NULL, "angle_out_max", "largest slope angle there", OF(angle_out.max), RADIAN},
	{NULL, "wrap_max", "largest angle of contact", OF(wrap.max), RADIAN},
	{NULL, "wrap_max_phase", "its phase", OF(wrap.at_max), METRE},
	{NULL, "sheave_force_max", "largest force of one sheave", OF(sheave_force.max), NEWTON},
	{NULL, "sheave_wrap_max", "largest deflection at one sheave", OF(sheave_wrap.max), RADIAN},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_ropeway_worst_list =
	HAWSER__STORED_ROWS(struct cli_ropeway, range, towers, tower_worst_field);

#define OF(member) HAWSER__AT(struct cli_ropeway_tower, member)
#define OVER(member) HAWSER__THROUGH(struct cli_ropeway_tower, range, member)
#define ON(member) RANGE(struct hawser_ropeway_tower_range, member)
static const struct hawser__field tower_range_inner[] = {
	{"T", NULL, "tension: min, max, and the phases of both, at_min and at_max", ON(T)},
	{"reaction_x", NULL, "force of the battery on the rope", ON(reaction_x)},
	{"reaction_y", NULL, "the same along y", ON(reaction_y)},
	{"pressing", NULL, "force by which the rope is pressed on the battery", ON(pressing)},
	{"pressure", NULL, "normal force per length of contact", ON(pressure)},
	{"angle_in", NULL, "slope angle on the side of the bottom station", ON(angle_in)},
	{"angle_out", NULL, "the same on the side of the top station", ON(angle_out)},
	{"wrap", NULL, "angle of contact", ON(wrap)},
	{"margin", NULL, "friction*wrap - |ln(T_out/T_in)|", ON(margin)},
	{"sheave_force", NULL, "largest force of one sheave", ON(sheave_force)},
	{"sheave_wrap", NULL, "largest deflection at one sheave", ON(sheave_wrap)},
	HAWSER__END,
};
static const struct hawser__field tower_range_field[] = {
	{"name", NULL, "name of the tower", OF(name)},
	{"", NULL, "", OVER(tower_range_inner)},
	HAWSER__END,
};
#undef ON
#undef OVER
#undef OF
#define ON(member) RANGE(struct hawser_ropeway_span_range, member)
static const struct hawser__field span_range_inner[] = {
	{"T", NULL, "tension", ON(T)},
	{"sag", NULL, "largest vertical distance from the chord", ON(sag)},
	{"length0", NULL, "unstretched length", ON(length0)},
	HAWSER__END,
};
#undef ON
static const struct hawser__field span_range_field[] = {
	{"name", NULL, "from the one tower to the next", HAWSER__AT(struct cli_ropeway_span, label)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_ropeway_span, range, span_range_inner)},
	HAWSER__END,
};
#define ON(member) RANGE(struct hawser_ropeway_lane_range, member)
static const struct hawser__field lane_range_inner[] = {
	{"T", NULL, "tension anywhere on the lane", ON(T)},
	{"T_top", NULL, "tension at the top station", ON(T_top)},
	HAWSER__END,
};
#undef ON

static void envelope_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_ropeway_lane *lane = of;
	int points = lane->range ? lane->spans*HAWSER_ROPEWAY_ENVELOPE : 0;
	json_t *list = lane->range ? hawser__json_array(json, into, "envelope") : NULL;

	for (int i = 0; i < points; i++) {
		const struct hawser_ropeway_range *T = &lane->range->envelope[i];
		const double *x = lane->range->place[i],
					 row[] = {x[0], x[1], T->min, T->max, T->at_min, T->at_max};

		hawser__json_numbers(json, list, NULL, row, 6, 1.0);
	}
}

static const struct hawser__field lane_worst_field[] = {
	{"towers", NULL, "ranges at each tower", HAWSER__STORED(struct cli_ropeway_lane, tower, towers,
	                                                        tower_range_field)},
	{"spans", NULL, "ranges of each span", HAWSER__STORED(struct cli_ropeway_lane, span, spans,
	                                                      span_range_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_ropeway_lane, range, lane_range_inner)},
	{"envelope", NULL, "[x, y, T_min, T_max, phase of T_min, phase of T_max] along the rope",
	 HAWSER__CALLS(envelope_json)},
	HAWSER__END,
};

/* --- lanes --- */

HAWSER__GIVEN(is_down, struct cli_ropeway, of->st.lanes > 1)

static void carriers_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_ropeway_lane *lane = of;
	json_t *list = hawser__json_array(json, into, "carriers");

	for (int i = 0; i < lane->lane->carriers; i++)
		hawser__json_numbers(json, list, NULL, lane->lane->st.carrier[i].x, 2, 1.0);
}

#define ON(member) HAWSER__AT(struct hawser_ropeway_lane, st.member)
static const struct hawser__field line_field[] = {
	{"T_bottom", NULL, "tension at the bottom station", ON(T_A), NEWTON},
	{"T_top", NULL, "tension at the top station", ON(T_B), NEWTON},
	{"angle_bottom", NULL, "slope angle at the bottom station", ON(angle_A), RADIAN},
	{"angle_top", NULL, "slope angle at the top station", ON(angle_B), RADIAN},
	{"reaction_bottom", NULL, "force of the bottom station on the rope, [x, y]", ON(reaction_A),
	 NEWTON},
	{"reaction_top", NULL, "force of the top station on the rope, [x, y]", ON(reaction_B), NEWTON},
	{"length0", NULL, "unstretched length", ON(length0), METRE},
	{"length", NULL, "stretched length", ON(length), METRE},
	{"closure", NULL, "largest distance of the rope from what it has to meet", ON(closure), METRE},
	{"balance", NULL, "largest defect of the balance of forces", ON(balance), NEWTON},
	HAWSER__END,
};
#undef ON
static const struct hawser__field lane_field[] = {
	{"towers", NULL, "from the bottom station on",
	 HAWSER__STORED(struct cli_ropeway_lane, tower, towers, tower_field)},
	{"spans", NULL, "between them",
	 HAWSER__STORED(struct cli_ropeway_lane, span, spans, span_field)},
	{"carriers", NULL, "places of the carriers on the rope, [x, y]", HAWSER__CALLS(carriers_json)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_ropeway_lane, lane, line_field)},
	HAWSER__END,
};

/* --- the result --- */

static const char *sliding_word(const void *row)
{
	static const char *const word[] = {"running", "rest", "reverse"};
	const struct cli_ropeway *of = row;

	return word[of->ropeway.sliding];
}

HAWSER__OF(case_word, const char *, struct cli_ropeway,
	of->ropeway.load_case[of->st.load_case].name)

#define OF(member) HAWSER__AT(struct cli_ropeway, st.member)
static const struct hawser__field drive_field[] = {
	{"force", NULL, "on the rope: T_top of lane up minus that of lane down", OF(force), NEWTON},
	{"power", NULL, "W: force times drive.speed", OF(power)},
	{"needed_friction", NULL, "|ln(T_up/T_down)|/wrap, of T - rho v^2", OF(needed_friction)},
	{"margin", NULL, "drive.friction - needed_friction, if it is given", OF(drive_margin),
	 .flags = HAWSER__OMIT},
	{"slips", NULL, "whether the rope slips on the bullwheel",
	 HAWSER__FLAG_AT(struct cli_ropeway, st.slips)},
	HAWSER__END,
};
static const struct hawser__field weight_field[] = {
	{"force", NULL, "on the carriage of the bottom station", OF(weight), NEWTON},
	{"T0", NULL, "tension that it sets: force/2 + rho v^2", OF(T0), NEWTON},
	{"travel", NULL, "of the carriage, from its place with the empty rope towards the line",
	 OF(travel), METRE},
	{"stopped", NULL, "whether that is beyond a stop",
	 HAWSER__FLAG_AT(struct cli_ropeway, st.stopped)},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct cli_ropeway, worst.member)
#define ON(member) RANGE(struct cli_ropeway, worst.member)
static const struct hawser__field worst_drive[] = {
	{"force", NULL, "on the rope", ON(force)},
	{"power", NULL, "W", ON(power)},
	{"needed_friction", NULL, "of the bullwheel", ON(needed_friction)},
	HAWSER__END,
};
static const struct hawser__field worst_weight[] = {
	{"T0", NULL, "tension at the bottom station", ON(T0)},
	{"travel", NULL, "of the carriage", ON(travel)},
	HAWSER__END,
};
static const struct hawser__field worst_field[] = {
	{"phases", NULL, "number of phases, equidistant over the spacing", OF(phases)},
	{"lifts", NULL, "number of phases in which a battery is not pressed", OF(lifts)},
	{"slips", NULL, "number in which the drive slips", OF(slips)},
	{"stops", NULL, "number in which the carriage is beyond a stop", OF(stops)},
	{"failed", NULL, "number without equilibrium", OF(failed)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_ropeway, lane[0], lane_worst_field)},
	{"down", NULL, "the same of lane down",
	 HAWSER__PART_OF(struct cli_ropeway, lane[1], lane_worst_field), .given = is_down,
	 .flags = HAWSER__BRIEF},
	{"drive", NULL, "ranges", HAWSER__OBJECT_OF(worst_drive), .given = is_down},
	{"counterweight", NULL, "ranges", HAWSER__OBJECT_OF(worst_weight)},
	HAWSER__END,
};
#undef ON
#undef OF

#define OF(member) HAWSER__AT(struct cli_ropeway_case, member)
static const struct hawser__field failed_field[] = {
	{"name", "case", "name of the case", OF(name)},
	{"solved", NULL, "whether there is a solution", HAWSER__NOT_AT(struct cli_ropeway_case, status)},
	{"why", NULL, "reason why there is none", OF(why)},
	HAWSER__END,
};
const struct hawser__field cli_ropeway_case_field[] = {
	{"name", "case", "name of the case", OF(name)},
	{"solved", NULL, "whether there is a solution",
	 HAWSER__NOT_AT(struct cli_ropeway_case, status)},
	{"phases", NULL, "number of phases", OF(phases)},
	{"T_max", "T_max", "largest tension", OF(T.max), NEWTON},
	{"T_max_phase", "T_max_phase", "its phase", OF(T.at_max), METRE},
	{"T_max_lane", "T_max_lane", "its lane", OF(T_lane)},
	{"T_max_span", "T_max_span", "its span", OF(T_where)},
	{"T_min", "T_min", "least tension", OF(T.min), NEWTON},
	{"pressing_min", "pressing_min", "least force by which the rope is pressed on a battery",
	 OF(pressing), NEWTON, .flags = HAWSER__NULL},
	{"pressing_min_phase", "pressing_min_phase", "its phase", OF(pressing_at), METRE,
	 .flags = HAWSER__NULL},
	{"pressing_min_lane", "pressing_min_lane", "its lane", OF(press_lane), .flags = HAWSER__NULL},
	{"pressing_min_tower", "pressing_min_tower", "its tower", OF(press_tower),
	 .flags = HAWSER__NULL},
	{"sag_max", "sag_max", "largest sag", OF(sag), METRE},
	{"sag_max_phase", "sag_max_phase", "its phase", OF(sag_at), METRE},
	{"sag_max_span", "sag_max_span", "its span", OF(sag_where)},
	{"force_min", "force_min", "least force of the drive", OF(force.min), NEWTON},
	{"force_max", "force_max", "largest force of the drive", OF(force.max), NEWTON},
	{"needed_friction", "needed_friction", "largest needed friction of the drive",
	 OF(needed_friction.max)},
	{"travel_min", "travel_min", "least travel of the carriage", OF(travel.min), METRE},
	{"travel_max", "travel_max", "largest travel of the carriage", OF(travel.max), METRE},
	{"lifts", "lifts", "number of phases in which a battery is not pressed", OF(lifts)},
	{"slips", "slips", "number in which the drive slips", OF(slips)},
	{"stops", "stops", "number in which the carriage is beyond a stop", OF(stops)},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_ropeway_case_list =
	HAWSER__STORED_ROWS(struct cli_ropeway, load_case, cases, cli_ropeway_case_field);

static void cases_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_ropeway *of = row;
	const struct hawser__view view = cli_si_view(0);
	json_t *list = hawser__json_array(json, into, "cases");

	for (int i = 0; i < of->cases; i++)
		hawser__fields_json(json, hawser__json_object(json, list, NULL),
		                    of->load_case[i].status ? failed_field : cli_ropeway_case_field,
		                    &of->load_case[i], &view);
}

#define OF(member) HAWSER__AT(struct cli_ropeway, member)
const struct hawser__field cli_ropeway_field[] = {
	{"sliding", NULL, "running, rest or reverse", HAWSER__TEXT_BY(sliding_word)},
	{"case", NULL, "the load case", HAWSER__TEXT_BY(case_word)},
	{"phase", NULL, "S of the first carrier of lane up", OF(st.phase), METRE},
	{"counterweight", NULL, "of the bottom station", HAWSER__OBJECT_OF(weight_field)},
	{"drive", NULL, "of the top station, if both lanes are modelled",
	 HAWSER__OBJECT_OF(drive_field), .given = is_down},
	{"loop0", NULL, "unstretched length of the loop, with half turns on both bullwheels",
	 OF(st.loop0), METRE},
	{"", NULL, "", HAWSER__PART_OF(struct cli_ropeway, lane[0], lane_field)},
	{"down", NULL, "towers, spans, carriers and the rest of lane down",
	 HAWSER__PART_OF(struct cli_ropeway, lane[1], lane_field), .given = is_down,
	 .flags = HAWSER__BRIEF},
	{"worst", NULL, "over the phases, with phase: sweep or --worst", HAWSER__OBJECT_OF(worst_field),
	 .when = CLI_ROPEWAY_SWEPT},
	{"cases", NULL, "with --cases", HAWSER__CALLS(cases_json), .inner = cli_ropeway_case_field,
	 .when = CLI_ROPEWAY_CASES},
	{"profile", NULL, "with --profile",
	 HAWSER__STORED(struct cli_ropeway, point, points, point_field),
	 .when = CLI_ROPEWAY_PROFILE},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_ropeway_listing[] = {
	{"Columns of a ropeway:", tower_field, 0},
	{"Columns of a ropeway with --spans:", span_field, 0},
	{"Columns of a ropeway with --worst:", tower_worst_field, 0},
	{"Columns of a ropeway with --cases:", cli_ropeway_case_field, 0},
	{"Columns of a ropeway with --profile:", point_field, 0},
	{"Keys of JSON of a ropeway:", cli_ropeway_field, 1},
	{NULL, NULL, 0},
};

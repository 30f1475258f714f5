/* cli/motion/transient_fields.c - columns and keys of hawser transient.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/motion/transient_ropeway.h"
#include "core/names.h"

/* the end of a field's row */
#define NEWTON .unit = HAWSER__NEWTON
#define METRE .unit = HAWSER__METRE
#define METRE_S .unit = HAWSER__METRE_S
#define METRE_S2 .unit = HAWSER__METRE_S2
#define SECOND .unit = HAWSER__SECOND
#define RADIAN .unit = HAWSER__RADIAN
#define OR_NULL .flags = HAWSER__NULL /* unknown values */

/* --- over time --- */

#define OF(member) HAWSER__AT(struct hawser_transient_row, member)
static const struct hawser__field row_field[] = {
	{"t", "t", "time", OF(t), SECOND},
	{"travelled", "travelled", "travel of the rope at the drive", OF(travelled), METRE},
	{"speed", "speed", "speed of the rope at the drive", OF(speed), METRE_S},
	{"wheel", "wheel", "speed of the drive bullwheel's surface", OF(wheel), METRE_S},
	{"force", "force", "force of the bullwheel on the rope, in the direction of running", OF(force),
	 NEWTON},
	{"motor", "motor", "force of drive or brake at the bullwheel's circumference", OF(motor), NEWTON},
	{"limit", "limit", "largest force before the rope slips", OF(limit), NEWTON, OR_NULL},
	{"needed_friction", "needed_friction", "friction that the drive bullwheel needs",
	 OF(needed_friction)},
	{"slip_arc", "slip_arc", "part of the wrap on which the rope slips", OF(slip_arc), RADIAN, OR_NULL},
	{"T_up", "T_up", "tension of lane up at the drive", OF(T_up), NEWTON},
	{"T_down", "T_down", "tension of lane down at the drive", OF(T_down), NEWTON},
	{"T_bottom_up", "T_bottom_up", "tension of lane up at the bottom station", OF(T_bottom_up), NEWTON},
	{"T_bottom_down", "T_bottom_down", "tension of lane down at the bottom station", OF(T_bottom_down),
	 NEWTON},
	{"travel", "travel", "travel of the carriage, towards the line", OF(travel), METRE},
	{"travel_speed", "travel_speed", "speed of the carriage", OF(travel_speed), METRE_S},
	{"T_min", "T_min", "least tension of both lanes", OF(T_min), NEWTON},
	{"T_max", "T_max", "largest tension of both lanes", OF(T_max), NEWTON},
	{"pressing", "pressing", "least force that presses the rope on a battery", OF(pressing), NEWTON,
	 OR_NULL},
	{"acceleration", "acceleration", "largest acceleration of the rope along the line, with its sign",
	 OF(acceleration), METRE_S2},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_transient_row_list =
	HAWSER__STORED_ROWS(struct cli_transient, run.row, run.rows, row_field);

/* --- spans and towers --- */

#define OF(member) HAWSER__AT(struct hawser_transient_range, member)
static const struct hawser__field range_field[] = {
	{"min", NULL, "least value, in the SI unit of the quantity", OF(min), OR_NULL},
	{"max", NULL, "largest value", OF(max), OR_NULL},
	{"at_min", NULL, "when it is least", OF(at_min), SECOND, OR_NULL},
	{"at_max", NULL, "when it is largest", OF(at_max), SECOND, OR_NULL},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct cli_transient_place, member)
#define RANGE(member) HAWSER__PART_OF(struct cli_transient_place, of.member, range_field), \
	.flags = HAWSER__BRIEF
#define SPREAD(name, what, member, u) \
	{NULL, name "_min", "least " what, OF(of.member.min), .unit = (u)}, \
	{NULL, name "_min_at", "its time", OF(of.member.at_min), SECOND}, \
	{NULL, name "_max", "largest " what, OF(of.member.max), .unit = (u)}, \
	{NULL, name "_max_at", "its time", OF(of.member.at_max), SECOND}

static const struct hawser__field span_field[] = {
	{"lane", "lane", "up or down", OF(lane)},
	{"name", "span", "the towers at its ends", OF(name)},
	SPREAD("T", "tension", T, HAWSER__NEWTON),
	SPREAD("sag", "change of the sag by the motion", other, HAWSER__METRE),
	SPREAD("acceleration", "acceleration of the rope along the line", acceleration, HAWSER__METRE_S2),
	{"T", NULL, "range of the tension", RANGE(T)},
	{"sag_change", NULL, "range of the change of the sag by the motion", RANGE(other)},
	{"acceleration", NULL, "range of the acceleration along the line", RANGE(acceleration)},
	HAWSER__END,
};
static const struct hawser__field tower_field[] = {
	{"lane", "lane", "up or down", OF(lane)},
	{"name", "tower", "name of the tower", OF(name)},
	SPREAD("T", "tension beside it", T, HAWSER__NEWTON),
	SPREAD("pressing", "force that presses the rope on the battery", other, HAWSER__NEWTON),
	{"T", NULL, "range of the tension beside it", RANGE(T)},
	{"pressing", NULL, "range of the force that presses the rope on the battery", RANGE(other)},
	{"acceleration", NULL, "range of the rope's acceleration", RANGE(acceleration)},
	HAWSER__END,
};
#undef OF
#undef RANGE
const struct hawser__list cli_transient_span_list =
	HAWSER__STORED_ROWS(struct cli_transient, span, spans, span_field);
const struct hawser__list cli_transient_tower_list =
	HAWSER__STORED_ROWS(struct cli_transient, tower, towers, tower_field);

/* --- a carrier passes a battery --- */

static HAWSER__NAMES(state_name, int, "span", "first", "arc", "last")

#define OF(member) HAWSER__AT(struct hawser_passing_row, member)
static const struct hawser__field passing_field[] = {
	{"t", "t", "time from the middle of the contact", OF(t), SECOND},
	{"phase", "phase", "phase of the carriers", OF(phase), METRE},
	{"S", "S", "unstretched length from the bottom station to the carrier", OF(S), METRE},
	{"x", NULL, "place of the carrier's grip, [x, y]", OF(x), METRE},
	{NULL, "x", "place of the carrier's grip", OF(x[0]), METRE},
	{NULL, "y", "its height", OF(x[1]), METRE},
	{"state", "state", "span, first (point of contact, with a kink), arc, or last point",
	 HAWSER__LABEL_AT(struct hawser_passing_row, state, state_name)},
	{"angle_before", "angle_before", "slope angle of the rope at the carrier, bottom side",
	 OF(angle_before), RADIAN},
	{"angle_after", "angle_after", "the same on the side of the top station", OF(angle_after), RADIAN},
	{"carried", "carried", "part of the carrier's weight that the battery carries", OF(carried),
	 NEWTON},
	{"T_in", "T_in", "tension at the tower, bottom side", OF(contact.T_in), NEWTON},
	{"T_out", "T_out", "tension at the tower, top side", OF(contact.T_out), NEWTON},
	{"angle_in", "angle_in", "slope angle of the rope at the tower, bottom side", OF(contact.angle_in),
	 RADIAN},
	{"angle_out", "angle_out", "the same on the side of the top station", OF(contact.angle_out),
	 RADIAN},
	{"wrap", "wrap", "angle of contact", OF(contact.wrap), RADIAN},
	{"pressing", "pressing", "force that presses the rope on the battery", OF(contact.pressing),
	 NEWTON},
	{"pressure", "pressure", "least normal force per length of contact", OF(contact.pressure),
	 .unit = HAWSER__NEWTON_M},
	{"sheave_force", "sheave_force", "largest force of one sheave", OF(contact.sheave_force), NEWTON},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_passing_list =
	HAWSER__STORED_ROWS(struct cli_transient, passing.row, passing.rows, passing_field);

/* --- JSON --- */

#define OF(member) HAWSER__AT(struct hawser_transient_energy, member)
static const struct hawser__field energy_field[] = {
	{"kinetic", NULL, "change of the kinetic energy, J", OF(kinetic)},
	{"stored", NULL, "change of the energy by tensions that are not those of statics, J", OF(stored)},
	{"work", NULL, "work of drive or brake, J", OF(work)},
	{"slow", NULL, "work of weights and of the statics that changes with the phase, J", OF(slow)},
	{"exchanged", NULL, "part of slow: of carriers that pass from node to node, J", OF(exchanged)},
	{"dissipated", NULL, "work lost on batteries, bottom bullwheel, by slip and in the rope, J",
	 OF(dissipated)},
	{"closure", NULL, "largest defect of kinetic + stored - work - slow + dissipated, relative",
	 OF(closure)},
	HAWSER__END,
};
#undef OF

HAWSER__GIVEN(runs, struct cli_transient, !of->passes)
static int passes(const void *row, const void *parent)
{
	return !runs(row, parent);
}

#define OF(member) HAWSER__AT(struct cli_transient, run.member)
#define RANGE(member) HAWSER__PART_OF(struct cli_transient, run.member, range_field), \
	.flags = HAWSER__BRIEF, .given = runs
const struct hawser__field cli_transient_field[] = {
	{"event", NULL, "start, stop, run or pass", HAWSER__AT(struct cli_transient, event)},
	{"mass", NULL, "mass that moves with the rope at t = 0, kg", OF(mass), .given = runs},
	{"rest_force", NULL, "force of the drive without friction and motion at t = 0", OF(rest_force),
	 NEWTON,
	 .given = runs},
	{"force", NULL, "range of the force of the bullwheel on the rope", RANGE(force)},
	{"T", NULL, "range of the tension", RANGE(T)},
	{"needed_friction", NULL, "range of the friction that the drive needs", RANGE(needed_friction)},
	{"slip_arc", NULL, "range of the arc of slip", RANGE(slip_arc)},
	{"travel", NULL, "range of the carriage's travel", RANGE(travel)},
	{"acceleration", NULL, "range of the acceleration along the line", RANGE(acceleration)},
	{"stopped_at", NULL, "when the rope at the drive comes to rest", OF(stopped_at), SECOND,
	 .flags = HAWSER__NULL, .given = runs},
	{"slipped", NULL, "length of rope that slips on the bullwheel", OF(slipped), METRE, .given = runs},
	{"creep", NULL, "largest (T_up - T_down)/EA: speed of creep over that of the rope", OF(creep),
	 .given = runs},
	{"slips", NULL, "steps in which the rope slips on the whole bullwheel", OF(slips), .given = runs},
	{"lifts", NULL, "steps in which a battery is not pressed", OF(lifts), .given = runs},
	{"stops", NULL, "steps with the carriage beyond a stop", OF(stops), .given = runs},
	{"energy", NULL, "balance of energy at the end of the run",
	 HAWSER__PART_OF(struct cli_transient, run.energy, energy_field), .given = runs},
	{"error.force", NULL, "difference of the force from a run with half the elements and steps",
	 OF(error_force), NEWTON, .flags = HAWSER__NULL, .given = runs},
	{"error.T", NULL, "the same of the least and largest tension", OF(error_T), NEWTON,
	 .flags = HAWSER__NULL, .given = runs},
	{"error.travel", NULL, "the same of the carriage's travel", OF(error_travel), METRE,
	 .flags = HAWSER__NULL, .given = runs},
	{"elements", NULL, "elements of a span", OF(options.elements), .given = runs},
	{"step", NULL, "step of time", OF(options.step), SECOND, .given = runs},
	{"steps", NULL, "number of steps", OF(steps), .given = runs},
	{"solves", NULL, "solutions of the equations of a step, of all steps", OF(solves), .given = runs},
	{"spans", NULL, "spans of both lanes", HAWSER__OBJECTS_OF(cli_transient_span_list), .given = runs},
	{"towers", NULL, "towers of both lanes", HAWSER__OBJECTS_OF(cli_transient_tower_list),
	 .given = runs},
	{"rows", NULL, "over time", HAWSER__OBJECTS_OF(cli_transient_row_list), .given = runs},
	{"lane", NULL, "with --pass: the lane", HAWSER__AT(struct cli_transient, lane), .given = passes},
	{"passing", NULL, "with --pass: states while the carrier passes",
	 HAWSER__OBJECTS_OF(cli_passing_list), .given = passes},
	HAWSER__END,
};

const struct cli_listing cli_transient_listing[] = {
	{"Columns of the table:", row_field, 0},
	{"Columns of the table with --spans:", span_field, 0},
	{"Columns of the table with --towers:", tower_field, 0},
	{"Columns of the table with --pass:", passing_field, 0},
	{"Keys of JSON:", cli_transient_field, 1},
	{NULL, NULL, 0},
};

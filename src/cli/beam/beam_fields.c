/* cli/beam/beam_fields.c - the fields of hawser beam: eigenvalues, sweeps, boundaries, motions.
 *
 * A result is a list of variants; each has its own scale, as the key that is varied may be the length.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "cli/frame/view.h"

enum { VARIED = 1, SWEEP = 2, MOTION = 4, DIMENSIONAL = 8, PLAIN = 16 };

static struct hawser__view view_of(const struct cli_beam_result *result,
                                   const struct cli_beam_variant *v)
{
	double rate = cli_beam_per_rate(&v->beam);
	int si = v->beam.time > 0.0;
	struct hawser__view view = {
		.scale = hawser__scale_of(si ? v->beam.length : 1.0, rate, 1.0, si), .context = result,
		.options = (result->vary ? VARIED : 0u) | (result->kind == CLI_BEAM_SWEEP ? SWEEP : 0u) |
		           (result->kind == CLI_BEAM_MOTION ? MOTION : 0u) | (si ? DIMENSIONAL : PLAIN)};

	view.scale.pure = !si;
	view.scale.factor[HAWSER__S] = si ? v->beam.time : 1.0;
	view.scale.factor[HAWSER__M_S] = cli_beam_per_speed(&v->beam);
	return view;
}

static void varied(char *text, size_t size, const void *context)
{
	const struct cli_beam_result *result = context;

	snprintf(text, size, "%s", result->vary ? result->vary : "");
}

static void parameter(char *text, size_t size, const void *context)
{
	snprintf(text, size, "%s", ((const struct cli_beam_result *)context)->boundary);
}
HAWSER__OF(varied_unit, const char *, struct cli_beam_result,
	of->vary ? cli_key_unit(of->vary) : "")

HAWSER__OF(parameter_unit, const char *, struct cli_beam_result, cli_key_unit(of->boundary))
#define VARIED_FIELD \
	{NULL, "KEY", "value of the varied key", HAWSER__IN(struct cli_beam_variant, value), \
	 .named = varied, .si = varied_unit}

/* --- eigenvalues --- */

#define OF(member) HAWSER__AT(struct hawser_beam_eigenvalue, member)
static const struct hawser__field eigenvalue_field[] = {
	VARIED_FIELD,
	{NULL, "number", "from 1, by modulus", .kind = HAWSER__INDEX},
	{"re", "re", "real part", OF(re), .unit = HAWSER__PER_S},
	{"im", "im", "imaginary part", OF(im), .unit = HAWSER__RAD_S},
	{"residual", "residual", "backward error", OF(residual)},
	{"condition", "condition", "condition number, relative", OF(condition)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list eigenvalue_list =
	HAWSER__STORED_ROWS(struct cli_beam_variant, eigenvalue, found, eigenvalue_field);

/* --- sweep --- */

static int two(const void *context)
{
	(void)context;
	return 2;
}
static const struct hawser__vector pair = {.count = two};

HAWSER__LABELS(event_name, hawser_beam_event_name, enum hawser_beam_event_kind)
HAWSER__LABELS(cause_name, hawser_beam_cause_name, enum hawser_beam_cause)

static const struct hawser__field branch_field[] = {
	{"branch", NULL, "number, from 1", .kind = HAWSER__INDEX},
	{"re", NULL, "both real parts of the pair", .unit = HAWSER__PER_S, .axis = "Real part",
	 HAWSER__VECTOR_ALONG(struct hawser_beam_sweep, re, pair)},
	{"im", NULL, "imaginary part", HAWSER__ALONG(struct hawser_beam_sweep, im),
	 .unit = HAWSER__RAD_S, .axis = "Imaginary part"},
	HAWSER__END,
};
static const struct hawser__list branch_list =
	HAWSER__MATRIX_PART(struct hawser_beam_sweep, branches, branch_field);

#define OF(member) HAWSER__AT(struct hawser_beam_station, member)
static const struct hawser__field station_field[] = {
	{"speed", NULL, "travel speed", OF(speed), .unit = HAWSER__M_S,
	 .axis = "Speed {/:Italic v}"},
	{"growing", NULL, "number of growing modes", OF(growing)},
	{"inserted", NULL, "whether the refinement added it",
	 HAWSER__FLAG_AT(struct hawser_beam_station, inserted)},
	{"branches", NULL, "eigenvalues by branch", HAWSER__OBJECTS_OF(branch_list)},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct hawser_beam_event, member)
static const struct hawser__field event_field[] = {
	{"kind", NULL, "what happens", HAWSER__LABEL_AT(struct hawser_beam_event, kind, event_name)},
	{"speed", NULL, "where", OF(speed), .unit = HAWSER__M_S, .flags = HAWSER__NULL},
	{"im", NULL, "imaginary part there", OF(im), .unit = HAWSER__RAD_S},
	{"growing_before", NULL, "growing modes before it", OF(growing[0])},
	{"growing_beyond", NULL, "growing modes after it", OF(growing[1])},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct hawser_beam_sweep, member)
static const struct hawser__field sweep_field[] = {
	{"speeds", NULL, "stations of the sweep",
	 HAWSER__STORED(struct hawser_beam_sweep, station, stations, station_field)},
	{"events", NULL, "changes of stability",
	 HAWSER__STORED(struct hawser_beam_sweep, event, events, event_field)},
	{"least_correlation", NULL, "least correlation of a branch between successive stations",
	 OF(least_correlation)},
	{"unsure", NULL, "stations with branches not separated", OF(unsure)},
	HAWSER__END,
};
#undef OF

/* The table has a row for each station, with all branches. */
HAWSER__OF(branch_columns, int, struct cli_beam_result, 3*of->variant[0].sweep.branches)

static void branch_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, k % 3 == 2 ? "im_%d" : k % 3 ? "re_%d_low" : "re_%d_high", k/3 + 1);
}

static double branch_at(const void *context, const void *parent, size_t station, int k)
{
	const struct hawser_beam_sweep *sweep = &((const struct cli_beam_variant *)parent)->sweep;
	size_t cell = station*(size_t)sweep->branches + (size_t)(k/3);

	(void)context;
	return k % 3 < 2 ? sweep->re[2*cell + (size_t)(k % 3)] : sweep->im[cell];
}

static enum hawser__unit branch_unit(const void *context, int k)
{
	(void)context;
	return k % 3 < 2 ? HAWSER__PER_S : HAWSER__RAD_S;
}
static const struct hawser__vector branch_vector = {
	.shown = "re_J_high", .count = branch_columns, .name = branch_name, .number = branch_at,
	.unit = branch_unit};

#define OF(member) HAWSER__AT(struct hawser_beam_station, member)
static const struct hawser__field speed_field[] = {
	VARIED_FIELD,
	{NULL, "speed", "travel speed", OF(speed), .unit = HAWSER__M_S},
	{NULL, "growing", "number of growing modes", OF(growing)},
	{NULL, "inserted", "1: added by the refinement", OF(inserted)},
	{NULL, "", "larger real part of the pair of branch J; re_J_low: the other, im_J: imaginary part",
	 HAWSER__VECTOR_OF(branch_vector), .unit = HAWSER__PER_S},
	HAWSER__END,
};
#undef OF
static const struct hawser__list speed_list = HAWSER__STORED_ROWS(
	struct cli_beam_variant, sweep.station, sweep.stations, speed_field);

/* --- boundaries --- */

/* A point, with its speed in the unit of the beam at this parameter. */
struct point {
	struct hawser_beam_boundary_point at;
	double speed;
	const char *what, *cause;
};
#define OF(member) HAWSER__AT(struct point, member)
static const struct hawser__field point_field[] = {
	VARIED_FIELD,
	{NULL, "boundary", "v_crit or v_bif", OF(what)},
	{"parameter", "KEY", "value of the key of the boundary", OF(at.parameter), .named = parameter,
	 .si = parameter_unit},
	{"speed", "speed", "speed", OF(speed), .unit = HAWSER__METRE_S, .when = DIMENSIONAL},
	{"speed", "speed", "speed, scaled", OF(speed), .when = PLAIN},
	{"im_scaled", "im_scaled", "imaginary part of the critical eigenvalue, scaled", OF(at.im)},
	{"cause", NULL, "why", HAWSER__LABEL_AT(struct point, at.cause, cause_name)},
	{NULL, "cause", "why it becomes unstable, of v_crit", OF(cause)},
	{"growing_below", "growing_below", "growing modes just below", OF(at.growing[0])},
	{"growing_above", "growing_above", "growing modes just above", OF(at.growing[1])},
	{"piece", "piece", "index of the piece of the boundary", OF(at.piece)},
	HAWSER__END,
};
#undef OF

static const void *fill(struct point *row, const struct cli_beam_variant *v, int turn, size_t i)
{
	const struct hawser_beam_boundary_point *at = &v->boundary[turn].point[i];

	*row = (struct point){.at = *at, .speed = at->speed*at->per_speed,
	                      .what = turn ? "v_bif" : "v_crit",
	                      .cause = turn ? "" : hawser_beam_cause_name(at->cause)};
	return row;
}

static const void *critical_row(void *row, const void *parent, size_t i)
{
	return fill(row, parent, 0, i);
}

static const void *bifurcation_row(void *row, const void *parent, size_t i)
{
	return fill(row, parent, 1, i);
}
static const struct hawser__list boundary_list[2] = {
	HAWSER__MADE_ROWS(struct point, point_field, struct cli_beam_variant, boundary[0].points,
	                  critical_row),
	HAWSER__MADE_ROWS(struct point, point_field, struct cli_beam_variant, boundary[1].points,
	                  bifurcation_row)};

/* --- motion --- */

#define OF(member) HAWSER__ALONG(struct cli_beam_variant, motion.member)
static const struct hawser__field motion_field[] = {
	VARIED_FIELD,
	{"times", "time", "time", OF(time), .unit = HAWSER__S, .axis = "Time {/:Italic t}"},
	{"y", "y", "deflection", OF(y), .unit = HAWSER__M, .axis = "Deflection {/:Italic y}"},
	{"energy", "energy", "energy between the supports, scaled", OF(energy)},
	{"change", "change", "rate of change of the energy", OF(change)},
	{"power_ends", "power_ends", "power at the supports", OF(ends)},
	{"power_weight", "power_weight", "power of the weight", OF(weight)},
	{"power_drag", "power_drag", "power of the drag", OF(drag)},
	{"jacobi", "jacobi", "Jacobi's energy", OF(jacobi)},
	{"material_rate", "material_rate", "rate of energy of the material between the supports",
	 OF(material), .axis = "Energy rate"},
	HAWSER__END,
};
#undef OF
static const struct hawser__list motion_list = {
	.field = motion_field, .count_at = offsetof(struct cli_beam_variant, motion.rows)};

static void balance_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_beam_motion *motion = &((const struct cli_beam_variant *)row)->motion;

	hawser__json_number(json, into, "unbalanced", cli_beam_unbalanced(motion));
	hawser__json_number(json, into, "growth", cli_beam_growth(motion));
}

/* --- a variant --- */

static void units_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_beam *beam = &((const struct cli_beam_variant *)row)->beam;

	hawser__json_number(json, into, "length", beam->time > 0.0 ? beam->length : 1.0);
	hawser__json_number(json, into, "time", beam->time > 0.0 ? beam->time : 1.0);
}

#define OF(member) HAWSER__AT(struct cli_beam_variant, beam.member)
static const struct hawser__field scaled_field[] = {
	{"theta", NULL, "bending rigidity", OF(theta)},
	{"tension", NULL, "at the end where it leaves", OF(tension)},
	{"weight", NULL, "fall of the tension along the beam", OF(weight)},
	{"drag", NULL, "coefficient of drag", OF(drag)},
	{"rotary", NULL, "square of radius of gyration over length", OF(rotary)},
	{"speed", NULL, "travel speed", OF(speed)},
	{"across", NULL, "weight across the travel", OF(across)},
	{"length, time", NULL, "units, SI", HAWSER__CALLS(units_json)},
	HAWSER__END,
};
#undef OF
#define OF(member) HAWSER__AT(struct cli_beam_variant, member)
static const struct hawser__field variant_field[] = {
	{"value", NULL, "of the varied key", OF(value), .when = VARIED},
	{"scaled", NULL, "the scaled beam", HAWSER__OBJECT_OF(scaled_field)},
	{"size", NULL, "of the discretisation", OF(size)},
	{"discretisation_error", NULL, "relative", OF(error)},
	{"v_crit", NULL, "least speed at which a mode grows; null: none", OF(limits.v_crit),
	 .unit = HAWSER__M_S, .flags = HAWSER__NULL},
	{"v_crit_first", NULL, "the same of the first mode", OF(limits.v_first), .unit = HAWSER__M_S,
	 .flags = HAWSER__NULL},
	{"v_bif", NULL, "least speed at which the first frequency is 0", OF(limits.v_bif),
	 .unit = HAWSER__M_S, .flags = HAWSER__NULL},
	{"searched", NULL, "greatest speed examined", OF(limits.searched), .unit = HAWSER__M_S,
	 .flags = HAWSER__NULL},
	{"cause", NULL, "why it becomes unstable",
	 HAWSER__LABEL_AT(struct cli_beam_variant, limits.cause, cause_name)},
	{"growth_slope", NULL, "growth rate over speed, for the cause flux", OF(limits.slope),
	 .unit = HAWSER__PER_M},
	{"eigenvalues", NULL, "at the scene's speed", HAWSER__OBJECTS_OF(eigenvalue_list)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_beam_variant, sweep, sweep_field), .when = SWEEP},
	{"boundary", NULL, "points of v_crit", HAWSER__OBJECTS_OF(boundary_list[0]),
	 .flags = HAWSER__OMIT},
	{"bifurcation", NULL, "points of v_bif", HAWSER__OBJECTS_OF(boundary_list[1]),
	 .flags = HAWSER__OMIT},
	{"", NULL, "", HAWSER__ARRAYS_OF(motion_list), .when = MOTION},
	{"unbalanced, growth", NULL, "largest error of the energy balance over its largest "
	 "term; growth rate in the last fifth",
	 HAWSER__CALLS(balance_json),
	 .when = MOTION},
	HAWSER__END,
};
#undef OF

static struct hawser__axis axis_of(const struct cli_beam_result *result,
                                   const struct hawser__field *field, const char *name)
{
	struct hawser__view view = view_of(result, &result->variant[0]);

	return hawser__fields_axis(field, name, &view, 0.0);
}

void cli_beam_sweep_axes(struct hawser__axis axis[CLI_BEAM_AXES], const struct cli_beam_result *result)
{
	axis[CLI_BEAM_SPEED] = axis_of(result, station_field, "speed");
	axis[CLI_BEAM_RE] = axis_of(result, branch_field, "re");
	axis[CLI_BEAM_IM] = axis_of(result, branch_field, "im");
}

void cli_beam_motion_axes(struct hawser__axis axis[CLI_BEAM_AXES], const struct cli_beam_result *result)
{
	axis[CLI_BEAM_TIME] = axis_of(result, motion_field, "times");
	axis[CLI_BEAM_Y] = axis_of(result, motion_field, "y");
	axis[CLI_BEAM_RATE] = axis_of(result, motion_field, "material_rate");
}

const struct cli_listing cli_beam_listing[] = {
	{"Columns of the table:", eigenvalue_field, 0},
	{"Columns with --to:", speed_field, 0},
	{"Columns with --boundary:", point_field, 0},
	{"Columns with --until:", motion_field, 0},
	{"Keys of JSON:", variant_field, 1},
	{NULL, NULL, 0},
};

static void rows(struct hawser__table *table, const void *of)
{
	static const struct {
		const struct hawser__list *list;
		int lists;
	} shown[] = {[CLI_BEAM_EIGENVALUES] = {&eigenvalue_list, 1}, [CLI_BEAM_SWEEP] = {&speed_list, 1},
	             [CLI_BEAM_BOUNDARY] = {boundary_list, 2}, [CLI_BEAM_MOTION] = {&motion_list, 1}};
	const struct cli_beam_result *result = of;
	struct hawser__view view = view_of(result, &result->variant[0]);

	hawser__fields_columns(table, shown[result->kind].list->field, &view);
	for (int i = 0; i < result->variants; i++)
		for (int k = 0; k < shown[result->kind].lists; k++) {
			view = view_of(result, &result->variant[i]);
			hawser__fields_rows(table, NULL, &shown[result->kind].list[k], &result->variant[i], &view);
		}
}

/* The members of the first variant are at the top level, the other variants in "variants". */
static void fill_json(struct hawser__json *json, const void *of)
{
	const struct cli_beam_result *result = of;
	struct hawser__view view = view_of(result, &result->variant[0]);
	json_t *list;

	cli_echo_json(json, result->common, "beam", &result->scene);
	hawser__json_text(json, json->root, "method", result->method->name);
	if (result->vary)
		hawser__json_text(json, json->root, "vary", result->vary);
	hawser__fields_json(json, json->root, variant_field, &result->variant[0], &view);
	list = result->variants > 1 ? hawser__json_array(json, json->root, "variants") : NULL;
	for (int i = 0; list && i < result->variants; i++) {
		view = view_of(result, &result->variant[i]);
		hawser__fields_json(json, hawser__json_object(json, list, NULL), variant_field,
		                    &result->variant[i], &view);
	}
	(void)cli_stats_json(json, result->common);
}

static struct cli_head head(const void *of)
{
	const struct cli_beam_result *result = of;

	return (struct cli_head){result->common, "beam", result->method->name, &result->scene,
	                         view_of(result, &result->variant[0]), NULL, NULL, NULL};
}

const struct cli_showing cli_beam_showing = {
	.head = head, .comments = cli_beam_comments, .more = rows, .json = fill_json,
	.draw = cli_beam_draw};

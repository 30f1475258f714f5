/* cli/modes/modes_ropeway_fields.c - columns and keys of the modes of a ropeway.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/modes/modes_result.h"

/* One mode. */
struct row {
	const struct cli_ropeway_modes *of;
	struct hawser_mode mode; /* with the eigenvalue in 1/s */
	int index;
	const char *plane, *family, *lane, *span;
	double span_share; /* of the span with the largest share */
	double up;         /* of the spans of lane up */
	double bodies;     /* of carriage and bullwheels */
	double sheaves;    /* of the rope on sheaves, and of the sheaves */
};

/* Share of the kinetic energy of a body: its mass over the unit of mass, times its displacement. */
static double body_share(const struct cli_ropeway_modes *of, int k, int i)
{
	const struct hawser_line_modes *modes = &of->modes;
	int parts = modes->gyroscopic ? 2 : 1;
	double sum = 0.0;

	for (int part = 0; part < parts; part++) {
		double w = modes->freedom_at[(k*parts + part)*modes->freedoms + i];

		sum += w*w;
	}
	return sum*of->freedom[i].mass/(modes->rho*modes->length_unit);
}

static const void *mode_row(void *to, const void *parent, size_t k)
{
	const struct cli_ropeway_modes *of = parent;
	const double *share = of->share + k*(size_t)of->spans;
	struct row *row = to;
	double spans = 0.0;
	int most = 0;

	*row = (struct row){.of = of, .mode = of->modes.mode[k], .index = (int)k + 1};
	row->mode.re /= of->modes.time_unit;
	row->mode.omega /= of->modes.time_unit;
	row->plane = hawser_plane_name(row->mode.plane);
	row->family = hawser_family_name(row->mode.family);
	for (int i = 0; i < of->spans; i++) {
		if (share[i] > share[most])
			most = i;
		spans += share[i];
		row->up += i <= of->towers ? share[i] : 0.0;
	}
	row->lane = of->span[most].lane;
	row->span = of->span[most].name;
	row->span_share = share[most];
	for (int i = 0; i < of->modes.freedoms; i++)
		row->bodies += body_share(of, (int)k, i);
	row->sheaves = fmax(0.0, 1.0 - spans - row->bodies);
	return row;
}

/* --- JSON --- */

static void spans_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct row *row = of;
	const struct cli_ropeway_modes *result = row->of;
	json_t *list = hawser__json_array(json, into, "spans");

	for (int i = 0; i < result->spans; i++) {
		json_t *to = hawser__json_object(json, list, NULL);

		if (*result->span[i].lane)
			hawser__json_text(json, to, "lane", result->span[i].lane);
		hawser__json_text(json, to, "name", result->span[i].name);
		hawser__json_number(json, to, "share", result->share[(row->index - 1)*result->spans + i]);
	}
}

static void bodies_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct row *row = of;
	const struct cli_ropeway_modes *result = row->of;
	json_t *list = hawser__json_array(json, into, "bodies");

	for (int i = 0; i < result->modes.freedoms; i++) {
		json_t *to = hawser__json_object(json, list, NULL);

		hawser__json_text(json, to, "name", result->freedom[i].name);
		hawser__json_number(json, to, "mass", result->freedom[i].mass);
		hawser__json_number(json, to, "share", body_share(result, row->index - 1, i));
	}
}

static const char *per_s(const void *context)
{
	(void)context;
	return "1/s";
}

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_modes_ropeway_field[] = {
	{"index", "index", "from 1, by frequency", OF(index)},
	{"omega", "omega", "circular frequency", OF(mode.omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", OF(mode.omega), .unit = HAWSER__HERTZ},
	{"re", "re_per_s", "if the rope runs: real part of the eigenvalue (1/s)", OF(mode.re),
	 .when = CLI_MODES_RUNS, .si = per_s},
	{"im", NULL, "if it runs: imaginary part, the same as omega", OF(mode.omega),
	 .unit = HAWSER__RADIAN_S, .when = CLI_MODES_RUNS},
	{"plane", "plane", "in-plane or out-of-plane", OF(plane)},
	{"family", "family", "transverse or longitudinal, by the larger share of the kinetic energy",
	 OF(family)},
	{"lane", "lane", "of ropeways: of the span with the largest share", OF(lane),
	 .when = CLI_MODES_ROPEWAY},
	{"span", "span", "with the largest share of the kinetic energy", OF(span)},
	{"span_share", "span_share", "its share, with its carriers", OF(span_share)},
	{"up_share", "up_share", "share of the spans of lane up", OF(up), .when = CLI_MODES_LOOP},
	{"sheaves_share", "sheaves_share", "share of the rope on sheaves, and of sheaves that turn",
	 OF(sheaves)},
	{"bodies_share", "bodies_share", "of ropeways: share of the carriage and the bullwheels",
	 OF(bodies), .when = CLI_MODES_ROPEWAY},
	{"residual", "residual", "error estimate of the frequency, relative", OF(mode.residual)},
	{"condition", "condition", "if it runs: condition number of the eigenvalue, relative",
	 OF(mode.condition), .when = CLI_MODES_RUNS},
	{"axial_share", "axial_share", "share of the squared shape along the rope", OF(mode.axial_share)},
	{"normal_share", "normal_share", "share normal to the rope", OF(mode.normal_share)},
	{"out_of_plane_share", "out_of_plane_share", "share out of plane", OF(mode.out_of_plane_share)},
	{"effective_mass", "effective_mass_",
	 "at rest: modal effective mass over the mass of rope and carriers", OF(mode.effective_mass),
	 .vector = &cli_axes, .when = CLI_MODES_REST},
	{"downstream", "downstream", "if it runs: share of downstream waves in the kinetic energy",
	 OF(mode.downstream), .when = CLI_MODES_RUNS},
	{"spans", NULL, "share of the kinetic energy in each span: lane, name, share",
	 HAWSER__CALLS(spans_json)},
	{"bodies", NULL, "carriage and bullwheels: name, mass (kg; of a bullwheel its inertia over the "
	 "radius squared, and the rope on it), share", HAWSER__CALLS(bodies_json),
	 .when = CLI_MODES_ROPEWAY},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_modes_ropeway_list = HAWSER__MADE_ROWS(
	struct row, cli_modes_ropeway_field, struct cli_ropeway_modes, modes.n, mode_row);

/* --- shapes --- */

HAWSER__OF(parts_of, int, struct cli_ropeway_modes, of->modes.gyroscopic ? 2 : 1)

static int numbers_of(const void *context)
{
	return 3*parts_of(context);
}

static int columns(const void *context)
{
	return numbers_of(context)*((const struct cli_ropeway_modes *)context)->modes.n;
}

static void column_name(char *text, size_t size, const void *context, int k)
{
	int parts = parts_of(context), numbers = numbers_of(context), part = k % numbers;

	snprintf(text, size, "%c%s_%d", "PQB"[part % 3], parts == 1 ? "" : part >= 3 ? "_im" : "_re",
	         k/numbers + 1);
}

static void part_name(char *text, size_t size, const void *context, int k)
{
	int parts = parts_of(context);

	snprintf(text, size, "%c%c%s", "PQB"[k % 3], parts == 1 ? '\0' : HAWSER__NESTED,
	         k >= 3 ? "im" : "re");
}

struct shape {
	int mode, rows;
};

static double part_at(const void *context, const void *parent, size_t i, int k)
{
	const struct cli_ropeway_modes *of = context;

	return of->shape[i*(size_t)columns(of) +
	                 (size_t)(((const struct shape *)parent)->mode*numbers_of(of) + k)];
}
static const struct hawser__vector
	column_vector = {.shown = "P_J", .count = columns, .name = column_name},
	part_vector = {.count = numbers_of, .name = part_name, .number = part_at, .object = 1};

#define ALONG(member) HAWSER__ALONG(struct cli_ropeway_modes, member)
const struct hawser__field cli_modes_ropeway_point[] = {
	{"lane", "lane", "of ropeways: up or down", ALONG(lane), .when = CLI_MODES_ROPEWAY},
	{"S", "S", "unstretched length of rope from the bottom station, or from end A", ALONG(S),
	 .unit = HAWSER__METRE},
	{"x", "x", "place in equilibrium", ALONG(x), .unit = HAWSER__METRE},
	{"y", "y", "its height", ALONG(y), .unit = HAWSER__METRE},
	{NULL, "", "of mode J: P along the rope, Q normal to it, B out of plane; P_re_J and P_im_J if the "
	 "rope runs", HAWSER__VECTOR_ALONG(struct cli_ropeway_modes, shape, column_vector)},
	HAWSER__END,
};
#undef ALONG
const struct hawser__list cli_modes_ropeway_points = {
	.field = cli_modes_ropeway_point, .count_at = offsetof(struct cli_ropeway_modes, rows)};
static const struct hawser__field part_field[] = {
	{"P, Q, B", NULL, "lists; objects of re and im if the rope runs", HAWSER__VECTOR_OF(part_vector)},
	HAWSER__END,
};
static const struct hawser__list part_list = {
	.field = part_field, .count_at = offsetof(struct shape, rows)};
static const struct hawser__field shape_field[] = {
	{"index", NULL, "of the mode", .kind = HAWSER__INDEX},
	{"", NULL, "", HAWSER__ARRAYS_OF(part_list)},
	HAWSER__END,
};

static const void *shape_row(void *to, const void *parent, size_t k)
{
	*(struct shape *)to = (struct shape){(int)k, ((const struct cli_ropeway_modes *)parent)->rows};
	return to;
}
static const struct hawser__list shape_list = HAWSER__MADE_ROWS(
	struct shape, shape_field, struct cli_ropeway_modes, modes.n, shape_row);
const struct hawser__field cli_modes_ropeway_shapes[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(cli_modes_ropeway_points)},
	{"modes", NULL, "shape of each mode", HAWSER__OBJECTS_OF(shape_list)},
	HAWSER__END,
};

/* --- the result --- */

HAWSER__OF(contact_of, const char *, struct cli_ropeway_modes,
	hawser_line_contact_name(of->modes.contact))

HAWSER__OF(case_of, const char *, struct cli_ropeway_modes,
	of->ropeway.load_case[of->st.load_case].name)

HAWSER__OF(speed_of, double, struct cli_ropeway_modes, of->st.lane[0].line->speed)

#define OF(member) HAWSER__AT(struct cli_ropeway_modes, member)
const struct hawser__field cli_modes_ropeway_member[] = {
	{"contact", NULL, "slip, stick or roll", HAWSER__TEXT_BY(contact_of)},
	{"speed", NULL, "of the rope", HAWSER__BY(speed_of), .unit = HAWSER__METRE_S},
	{"case", NULL, "load case", HAWSER__TEXT_BY(case_of)},
	{"phase", NULL, "of the carriers", OF(st.phase), .unit = HAWSER__METRE},
	{"T0", NULL, "tension at the bottom station", OF(st.T0), .unit = HAWSER__NEWTON},
	{"time_unit", NULL, "of the scaled equations", OF(modes.time_unit), .unit = HAWSER__SECOND},
	{"modes", NULL, "by frequency, both planes and lanes together",
	 HAWSER__OBJECTS_OF(cli_modes_ropeway_list)},
	{"shapes", NULL, "with --shapes: points of both lanes, and for each mode the shape at them",
	 HAWSER__OBJECT_OF(cli_modes_ropeway_shapes), .when = CLI_MODES_SHAPES},
	HAWSER__END,
};
#undef OF

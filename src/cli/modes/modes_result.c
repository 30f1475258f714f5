/* cli/modes/modes_result.c - see modes_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <math.h>
#include <string.h>

#include "cli/modes/modes_result.h"
#include "core/report.h"

/* P, Q, B, then their slopes in the local frame; of complex modes each has two parts. */
static const char components[] = "PQBabc";
enum { COMPONENTS = 6 };

static int parts_of(const struct cli_modes_result *result)
{
	return result->modes.gyroscopic ? 2 : 1;
}

/* Numbers of one mode at one point. */
static int numbers_of(const void *context)
{
	return COMPONENTS*parts_of(context);
}

static void sample(double *value, const struct cli_modes_result *result, int k, double s)
{
	int parts = parts_of(result);
	double shape[6], slope[6];

	hawser_modes_at(&result->modes, shape, slope, k, s);
	for (int c = 0; c < 3; c++)
		for (int part = 0; part < parts; part++) {
			value[parts*c + part] = shape[3*part + c];
			value[parts*(3 + c) + part] = slope[3*part + c];
		}
}

enum hawser_status cli_modes_sample(struct cli_modes_result *result, struct hawser_report *report)
{
	const struct hawser_statics *statics = &result->modes.statics;
	size_t points = (size_t)result->points, numbers = (size_t)numbers_of(result);
	size_t n = (size_t)result->modes.n;

	if (points == 0)
		return HAWSER_OK;
	result->S = malloc(points*sizeof *result->S);
	result->shape = malloc(points*n*numbers*sizeof *result->shape);
	if (!result->S || !result->shape)
		return hawser__no_memory(report, "modes");
	for (size_t i = 0; i < points; i++) {
		double s = statics->l*(int)i/(result->points - 1);

		/* of a cable that travels, the actual arclength: that of the apparent cable is longer */
		result->S[i] = s*statics->span.d*(1.0 - statics->motion.mach2);
		for (size_t k = 0; k < n; k++)
			sample(result->shape + (i*n + k)*numbers, result, (int)k, s);
	}
	return HAWSER_OK;
}

static double rad_per_s(const struct hawser_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

/* --- comments --- */

static void shape_comments(struct hawser__table *table, const struct hawser_modes *modes)
{
	for (int k = 0; k < modes->n; k++)
		hawser__table_comment(table, "mode %d: omega = %.15g rad/s, %s%s%s", k + 1,
		                      rad_per_s(modes, k), hawser_plane_name(modes->mode[k].plane),
		                      modes->gyroscopic ? "" : ", ",
		                      modes->gyroscopic ? ""
		                                        : hawser_family_name(modes->mode[k].family));
	if (modes->gyroscopic) {
		hawser__table_comment(table, "shapes: P axial, Q normal, B out of plane, real and imaginary "
		                      "parts; a motion is the real part of shape exp(i omega t)");
		hawser__table_comment(table, "the integral of |P|^2 + |Q|^2 + |B|^2 over s = S/((1 - m) d), "
		                      "m = %.10g, is 1; slopes by s in the local frame: a = P' - kappa Q, "
		                      "b = Q' + kappa P, c = B'", modes->statics.motion.mach2);
	} else {
		hawser__table_comment(table, "shapes: P axial, Q normal, B out of plane; the integral of "
		                             "P^2 + Q^2 + B^2 over S/d is 1");
		hawser__table_comment(table, "slopes by S/d in the local frame: a = P' - kappa Q, "
		                             "b = Q' + kappa P, c = B'");
	}
}

static int dampers(const struct hawser_statics *st)
{
	int any = 0;

	for (int i = 0; i < st->attachments; i++) {
		any |= st->attached[i].absorber_damping > 0.0;
		for (int c = 0; c < 3; c++)
			any |= st->attached[i].damper[c] > 0.0;
	}
	return any;
}

/* L sqrt(T/EI), with the stretched length and the tension at mid-length. */
static double xi_of(const void *of)
{
	const struct hawser_modes *modes = of;
	double S = 0.5*modes->statics.length0, T = hawser_statics_at(&modes->statics, S).T;

	return modes->statics.length*sqrt(T/modes->statics.bending.EI);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_modes_result *result = of;
	const struct hawser_modes *modes = &result->modes;
	const struct hawser_motion *motion = &modes->statics.motion;

	hawser__table_comment(table, strcmp(modes->method, "fe") == 0
	                      ? "mesh of %d cable elements, time unit %.12g s"
	                      : "%d functions a component, time unit %.12g s", modes->basis,
	                      modes->time_unit);
	if (modes->gyroscopic)
		hawser__table_comment(table,
		                      "travels at %.10g m/s; tension at S = 0 %.10g N, apparent one %.10g N",
		                      motion->speed, motion->tension, modes->statics.T0);
	if (modes->statics.space)
		hawser__table_comment(table, "the cable hangs in space: in-plane and out-of-plane name the "
		                      "larger share, in or across the plane of each part between masses; x, "
		                      "y, z are those of the scene");
	else if (modes->statics.turned)
		hawser__table_comment(table, "in-plane means the plane of the cable, which its static load "
		                      "turns by %.6g rad about the chord; x, y, z are those of the scene",
		                      modes->statics.swing);
	if (modes->statics.bending.EI > 0.0)
		hawser__table_comment(table, "xi = L sqrt(T/EI) is %.10g with the tension at mid-length; "
		                      "moments at the ends in N.m per m of the largest displacement",
		                      xi_of(modes));
	if (dampers(&modes->statics))
		hawser__table_comment(table, "the modes are undamped: --damped lists the damping by dampers "
		                      "of attachments");
	if (result->points > 0)
		shape_comments(table, modes);
}

/* --- fields --- */

enum { REST = 1, TRAVELS = 2, SHAPES = 4, BENDS = 8, ABSORBS = 16 };

/* The attachment of absorber k. */
static int absorber_at(const struct hawser_modes *modes, int k)
{
	const struct hawser_statics *st = &modes->statics;
	int i = 0;

	while (i < st->attachments && (!(st->attached[i].absorber > 0.0) || k-- > 0))
		i++;
	return i;
}

static int absorbers(const void *context)
{
	const struct hawser_statics *st = &((const struct cli_modes_result *)context)->modes.statics;
	int count = 0;

	for (int i = 0; i < st->attachments; i++)
		count += st->attached[i].absorber > 0.0;
	return count;
}

/* Absorbers without a name have the number of their attachment in the scene, from 1. */
static void absorber_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_modes_result *result = context;
	int index = result->modes.statics.attached[absorber_at(&result->modes, k)].index;
	const char *name = result->scene.attach[index].name;

	if (*name)
		snprintf(text, size, "%s", name);
	else
		snprintf(text, size, "%d", index + 1);
}

static double stroke_of(const void *context, const void *parent, size_t mode, int k)
{
	const struct hawser_modes *modes = parent;

	(void)context;
	return modes->stroke[(int)mode*modes->statics.attachments + absorber_at(modes, k)];
}
static const struct hawser__vector absorber_vector = {
	.shown = "ABSORBER", .count = absorbers, .name = absorber_name, .number = stroke_of, .object = 1};

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(family_name, hawser_family_name, enum hawser_family)
HAWSER__LABELS(symmetry_name, hawser_symmetry_name, enum hawser_symmetry)

#define OF(member) HAWSER__AT(struct hawser_mode, member)
#define LABEL(member, function) HAWSER__LABEL_AT(struct hawser_mode, member, function)
static const char *per_s(const void *context)
{
	(void)context;
	return "1/s";
}

static const struct hawser__field mode_field[] = {
	{"index", "index", "from 1, by frequency", .kind = HAWSER__INDEX},
	{"omega", "omega", "circular frequency", OF(omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", OF(omega), .unit = HAWSER__HERTZ},
	{"re", "re_per_s", "if the cable travels: real part of the eigenvalue (1/s)", OF(re),
	 .when = TRAVELS, .si = per_s},
	{"im", NULL, "if it travels: imaginary part, the same as omega", OF(omega),
	 .unit = HAWSER__RADIAN_S, .when = TRAVELS},
	{"plane", "plane", "in-plane or out-of-plane", LABEL(plane, plane_name)},
	{"family", "family", "at rest: transverse or longitudinal", LABEL(family, family_name),
	 .when = REST},
	{"symmetry", "symmetry", "at rest: of the dominant component", LABEL(symmetry, symmetry_name),
	 .when = REST},
	{"residual", "residual", "error estimate of the frequency or the eigenvalue, relative",
	 OF(residual)},
	{"condition", "condition", "if it travels: condition number of the eigenvalue, relative",
	 OF(condition), .when = TRAVELS},
	{"axial_share", "axial_share", "share of the squared shape along the cable", OF(axial_share)},
	{"normal_share", "normal_share", "share normal to the cable", OF(normal_share)},
	{"out_of_plane_share", "out_of_plane_share", "share out of plane", OF(out_of_plane_share)},
	{"participation", "participation_", "at rest: integral of the shape along an axis",
	 OF(participation), .vector = &cli_axes, .when = REST},
	{"effective_mass", "effective_mass_",
	 "at rest: modal effective mass over the mass of the cable", OF(effective_mass),
	 .vector = &cli_axes, .when = REST},
	{"stroke", "stroke_", "with absorbers: displacement of each relative to the cable, along its "
	 "direction, in the scale of the shape", HAWSER__VECTOR_OF(absorber_vector), .when = ABSORBS},
	{"moment_A", "moment_A", "with cable.EI: bending moment at end A over the largest displacement",
	 OF(moment[0]), .unit = HAWSER__MOMENT_PER_METRE, .when = BENDS},
	{"moment_B", "moment_B", "with cable.EI: at end B", OF(moment[1]),
	 .unit = HAWSER__MOMENT_PER_METRE, .when = BENDS},
	{"moment_error", "moment_error", "with cable.EI: error estimate of the moments, relative to the "
	 "larger one", OF(moment_error), .when = BENDS},
	{"downstream", "downstream",
	 "if it travels: share of downstream waves in the kinetic energy", OF(downstream),
	 .when = TRAVELS},
	HAWSER__END,
};
#undef LABEL
#undef OF

/* With the eigenvalue in 1/s. */
static const void *mode_row(void *to, const void *parent, size_t k)
{
	const struct hawser_modes *modes = parent;
	struct hawser_mode *mode = to;

	*mode = modes->mode[k];
	mode->re /= modes->time_unit;
	mode->omega /= modes->time_unit;
	return mode;
}
static const struct hawser__list mode_list = HAWSER__MADE_ROWS(
	struct hawser_mode, mode_field, struct hawser_modes, n, mode_row);

/* --- shapes: in the table a column for each part of a mode, in JSON a list for each --- */

static int columns(const void *context)
{
	return numbers_of(context)*((const struct cli_modes_result *)context)->modes.n;
}

static void column_name(char *text, size_t size, const void *context, int k)
{
	int parts = parts_of(context), numbers = numbers_of(context), part = k % numbers;

	snprintf(text, size, "%c%s_%d", components[part/parts],
	         parts == 1 ? "" : part % parts ? "_im" : "_re", k/numbers + 1);
}

static void part_name(char *text, size_t size, const void *context, int k)
{
	int parts = parts_of(context);

	snprintf(text, size, "%c%c%s", components[k/parts], parts == 1 ? '\0' : HAWSER__NESTED,
	         k % parts ? "im" : "re");
}

/* One mode. */
struct shape {
	int mode, points;
};

static double part_at(const void *context, const void *parent, size_t i, int k)
{
	const struct cli_modes_result *result = context;
	int mode = ((const struct shape *)parent)->mode;

	return result->shape[i*(size_t)columns(result) + (size_t)(mode*numbers_of(result) + k)];
}
static const struct hawser__vector
	column_vector = {.shown = "P_J", .count = columns, .name = column_name},
	part_vector = {.count = numbers_of, .name = part_name, .number = part_at, .object = 1};

static const struct hawser__field point_field[] = {
	{"S", "S", "unstretched arclength from end A", HAWSER__ALONG(struct cli_modes_result, S),
	 .unit = HAWSER__METRE, .axis = "Arclength {/:Italic S}"},
	{NULL, "", "of mode J: P axial, Q normal, B out of plane, a, b, c their slopes; P_re_J and "
	 "P_im_J if it travels",
	 HAWSER__VECTOR_ALONG(struct cli_modes_result, shape, column_vector)},
	HAWSER__END,
};
static const struct hawser__list point_list = {
	.field = point_field, .count_at = offsetof(struct cli_modes_result, points)};
static const struct hawser__field part_field[] = {
	{"P, Q, B, a, b, c", NULL, "lists; objects of re and im if the cable travels",
	 HAWSER__VECTOR_OF(part_vector)},
	HAWSER__END,
};
static const struct hawser__list part_list = {
	.field = part_field, .count_at = offsetof(struct shape, points)};
static const struct hawser__field shape_field[] = {
	{"index", NULL, "of the mode", .kind = HAWSER__INDEX},
	{"", NULL, "", HAWSER__ARRAYS_OF(part_list)},
	HAWSER__END,
};

static const void *shape_row(void *to, const void *parent, size_t k)
{
	*(struct shape *)to =
		(struct shape){(int)k, ((const struct cli_modes_result *)parent)->points};
	return to;
}
static const struct hawser__list shape_list = HAWSER__MADE_ROWS(
	struct shape, shape_field, struct cli_modes_result, modes.n, shape_row);
static const struct hawser__field shapes_field[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(point_list)},
	{"modes", NULL, "shape of each mode", HAWSER__OBJECTS_OF(shape_list)},
	HAWSER__END,
};

#define OF(member) HAWSER__AT(struct hawser_modes, member)
static const struct hawser__field modes_field[] = {
	{"method", NULL, "by which they are computed", OF(method)},
	{"basis", NULL, "functions per component; elements with --model fe", OF(basis)},
	{"time_unit", NULL, "of the scaled equations", OF(time_unit), .unit = HAWSER__SECOND},
	{"travel.speed", NULL, "travel speed", OF(statics.motion.speed), .unit = HAWSER__METRE_S,
	 .when = TRAVELS},
	{"travel.tension", NULL, "at S = 0", OF(statics.motion.tension), .unit = HAWSER__NEWTON,
	 .when = TRAVELS},
	{"travel.apparent_tension", NULL, "of the apparent cable there", OF(statics.T0),
	 .unit = HAWSER__NEWTON, .when = TRAVELS},
	{"travel.mach2", NULL, "square of speed over that of axial waves", OF(statics.motion.mach2),
	 .when = TRAVELS},
	{"xi", NULL, "with cable.EI: L sqrt(T/EI), with the tension at mid-length", HAWSER__BY(xi_of),
	 .when = BENDS},
	{"modes", NULL, "by frequency, both planes together", HAWSER__OBJECTS_OF(mode_list)},
	HAWSER__END,
};
#undef OF
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__PART_OF(struct cli_modes_result, modes, modes_field)},
	{"shapes", NULL, "with --shapes", HAWSER__OBJECT_OF(shapes_field), .when = SHAPES},
	HAWSER__END,
};

const struct cli_listing cli_modes_listing[] = {
	{"Columns of the table:", mode_field, 0},
	{"Columns with --shapes:", point_field, 0},
	{"Columns with --damped or --over:", cli_damped_field, 0},
	{"Columns of nets:", cli_modes_net_field, 0},
	{"Columns of ropeways and of spans over obstacles:", cli_modes_ropeway_field, 0},
	{"Columns of these with --shapes:", cli_modes_ropeway_point, 0},
	{"Columns of ropeways and of spans over obstacles with --over:", cli_track_field, 0},
	{"Columns of reduced models:", cli_modes_model_field, 0},
	{"Keys of JSON:", result_field, 1},
	{"Keys of JSON with --damped or --over:", cli_damped_member, 1},
	{"Keys of JSON of nets:", cli_modes_net_member, 1},
	{"Keys of JSON of ropeways:", cli_modes_ropeway_member, 1},
	{"Keys of JSON of spans over obstacles:", cli_modes_obstacles_member, 1},
	{"Keys of JSON of these with --over:", cli_track_member, 1},
	{"Keys of JSON of reduced models:", cli_modes_model_member, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_modes_result *result = of;

	return (struct cli_head){
		result->common, "modes", result->modes.method, &result->scene,
		{.scale = hawser__si, .context = result,
		 .options = (result->modes.gyroscopic ? TRAVELS : REST) |
		            (result->modes.statics.bending.EI > 0.0 ? BENDS : 0u) |
		            (result->modes.stroke ? ABSORBS : 0u) |
		            (result->points > 0 ? SHAPES : 0u)},
		result->points > 0 ? (const void *)result : &result->modes, NULL,
		result->points > 0 ? &point_list : &mode_list};
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_modes_result *result = of;
	const struct hawser_modes *modes = &result->modes;
	struct hawser__view view = head(of).view;
	struct hawser__axis S = hawser__fields_axis(point_field, "S", &view, 0.0);

	if (strcmp(result->view, "profile") == 0)
		return hawser__plot_displaced(path, modes, report);
	if (strcmp(result->view, "waves") == 0 && modes->gyroscopic)
		return hawser__plot_waves(path, modes, &S, report);
	return hawser__plot_modes(path, modes, &S, report);
}

const struct cli_showing cli_modes_showing = {
	.head = head, .comments = comments, .fields = result_field, .draw = draw};

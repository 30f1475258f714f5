/* cli/modes_travel.c - hawser modes of a scene that travels: complex modes as table and JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/modes_travel.h"

static const char components[] = "PQBabc";

/* S (m, actual) and the [12] parts of mode k at sample i of `points`: P, Q, B, a, b, c, each real,
 * then imaginary. */
static double sample(double *value, const struct hawser_modes *modes, int k, int i,
                     int points)
{
	const struct hawser_statics *st = &modes->statics;
	double s = st->l*i/(points - 1), shape[6], slope[6];

	hawser_modes_at(modes, shape, slope, k, s);
	for (int c = 0; c < 3; c++)
		for (int part = 0; part < 2; part++) {
			value[2*c + part] = shape[3*part + c];
			value[6 + 2*c + part] = slope[3*part + c];
		}
	return s*st->span.d*(1.0 - st->motion.mach2);
}

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)

#define OF(member) HAWSER__AT(struct hawser_mode, member)
const struct hawser__field cli_travel_mode_field[] = {
	{"index", "index", "from 1, by frequency", .kind = HAWSER__INDEX},
	{"omega", "omega", "circular frequency", OF(omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", OF(omega), .unit = HAWSER__HERTZ},
	{"re", "re_per_s", "real part of the eigenvalue (1/s)", OF(re)},
	{"im", NULL, "imaginary part, the same as omega", OF(omega), .unit = HAWSER__RADIAN_S},
	{"plane", "plane", "in-plane or out-of-plane",
	 HAWSER__LABEL_AT(struct hawser_mode, plane, plane_name)},
	{"residual", "residual", "error estimate of the eigenvalue, relative", OF(residual)},
	{"condition", "condition", "condition number, relative", OF(condition)},
	{"axial_share", "axial_share", "share of the squared shape along the cable", OF(axial_share)},
	{"normal_share", "normal_share", "share normal to the cable", OF(normal_share)},
	{"out_of_plane_share", "out_of_plane_share", "share out of plane", OF(out_of_plane_share)},
	{"downstream", "downstream", "share of downstream waves in the kinetic energy", OF(downstream)},
	HAWSER__END,
};
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
	struct hawser_mode, cli_travel_mode_field, struct hawser_modes, n, mode_row);

#define OF(member) HAWSER__AT(struct hawser_modes, member)
const struct hawser__field cli_travel_field[] = {
	{"method", NULL, "by which they are computed", OF(method)},
	{"basis", NULL, "functions per component", OF(basis)},
	{"time_unit", NULL, "of the scaled equations", OF(time_unit), .unit = HAWSER__SECOND},
	{"travel.speed", NULL, "travel speed", OF(statics.motion.speed), .unit = HAWSER__METRE_S},
	{"travel.tension", NULL, "at S = 0", OF(statics.motion.tension), .unit = HAWSER__NEWTON},
	{"travel.apparent_tension", NULL, "of the apparent cable there", OF(statics.T0),
	 .unit = HAWSER__NEWTON},
	{"travel.mach2", NULL, "square of speed over that of axial waves", OF(statics.motion.mach2)},
	{"modes", NULL, "by frequency, both planes together", HAWSER__OBJECTS_OF(mode_list)},
	HAWSER__END,
};
#undef OF

static void shape_rows(struct hawser__table *table, const struct hawser_modes *modes,
                       int points)
{
	double value[12], S;

	for (int k = 0; k < modes->n; k++)
		hawser__table_comment(table, "mode %d: omega = %.15g rad/s, %s", k + 1,
		                      modes->mode[k].omega/modes->time_unit,
		                      hawser_plane_name(modes->mode[k].plane));
	hawser__table_comment(table,
	                      "shapes: P axial, Q normal, B out of plane, real and imaginary parts; a "
	                             "motion is the real part of shape exp(i omega t)");
	hawser__table_comment(table,
	                      "the integral of |P|^2 + |Q|^2 + |B|^2 over s = S/((1 - m) d), "
	                      "m = %.10g, is 1; slopes by s in the local frame: a = P' - kappa Q, "
	                             "b = Q' + kappa P, c = B'", modes->statics.motion.mach2);
	hawser__table_column(table, "S_m");
	for (int k = 0; k < modes->n; k++)
		for (int c = 0; c < 12; c++)
			hawser__table_column(table, "%c_%s_%d", components[c/2], c%2 ? "im" : "re", k + 1);
	for (int i = 0; i < points; i++)
		for (int k = 0; k < modes->n; k++) {
			S = sample(value, modes, k, i, points);
			if (k == 0)
				hawser__table_number(table, S);
			for (int c = 0; c < 12; c++)
				hawser__table_number(table, value[c]);
		}
}

void cli_travel_rows(struct hawser__table *table, const struct hawser_modes *modes,
                     int points)
{
	const struct hawser_motion *motion = &modes->statics.motion;
	struct hawser__view view = cli_si_view(0);

	hawser__table_comment(table, "%d functions a component, time unit %.12g s", modes->basis,
	                      modes->time_unit);
	hawser__table_comment(table,
	                      "travels at %.10g m/s; tension at S = 0 %.10g N, apparent one %.10g N",
	                      motion->speed, motion->tension, modes->statics.T0);
	if (points > 0)
		shape_rows(table, modes, points);
	else
		hawser__fields_table(table, &mode_list, modes, &view);
}

/* One part of one component of one mode, or (c < 0) the abscissa. */
static void samples_json(struct hawser__json *json, json_t *into, const char *key,
                         const struct hawser_modes *modes, int k, int c, int points)
{
	json_t *list = hawser__json_array(json, into, key);
	double value[12], S;

	for (int i = 0; i < points; i++) {
		S = sample(value, modes, k, i, points);
		hawser__json_number(json, list, NULL, c < 0 ? S : value[c]);
	}
}

static void shapes_json(struct hawser__json *json, const struct hawser_modes *modes,
                        int points)
{
	json_t *shapes = hawser__json_object(json, json->root, "shapes"), *list, *mode, *component;

	samples_json(json, shapes, "S", modes, 0, -1, points);
	list = hawser__json_array(json, shapes, "modes");
	for (int k = 0; k < modes->n; k++) {
		mode = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, mode, "index", k + 1);
		for (int c = 0; c < 6; c++) {
			const char key[] = {components[c], '\0'};

			component = hawser__json_object(json, mode, key);
			samples_json(json, component, "re", modes, k, 2*c, points);
			samples_json(json, component, "im", modes, k, 2*c + 1, points);
		}
	}
}

void cli_travel_json(struct hawser__json *json, const struct hawser_modes *modes,
                     int points)
{
	struct hawser__view view = cli_si_view(0);

	hawser__fields_json(json, json->root, cli_travel_field, modes, &view);
	if (points > 0)
		shapes_json(json, modes, points);
}

void cli_travel_methods(void)
{
	const struct hawser_modes_method *method;
	int count;

	method = hawser_complex_modes_methods(&count);
	puts("\nwhere the scene travels:");
	for (int i = 0; i < count; i++)
		printf("%s\n  %s\n  %s\n", method[i].name, method[i].summary, method[i].source);
}

/* cli/modes_travel.c - hawser modes of a scene that travels: complex modes as table and JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/modes_travel.h"

static const char components[] = "PQBabc";

/* S (m, actual) and the [12] parts of mode k at sample i of `points`: P, Q, B, a, b, c, each real,
 * then imaginary. */
static double sample(double *value, const struct hawser_complex_modes *modes, int k, int i,
                     int points)
{
	const struct hawser_statics *st = &modes->statics;
	double s = st->l*i/(points - 1), shape[6], slope[6];

	hawser_complex_modes_at(modes, shape, slope, k, s);
	for (int c = 0; c < 3; c++)
		for (int part = 0; part < 2; part++) {
			value[2*c + part] = shape[3*part + c];
			value[6 + 2*c + part] = slope[3*part + c];
		}
	return s*st->span.d*(1.0 - st->motion.mach2);
}

/* Columns of the table and keys of JSON after `index` and the frequencies. */
enum { NUMBERS = 6 };
static const char *const number_name[NUMBERS] = {"residual", "condition", "axial_share",
                                                 "normal_share",
                                                 "out_of_plane_share", "downstream"};

static void numbers_of(double *number, const struct hawser_complex_mode *mode)
{
	number[0] = mode->residual;
	number[1] = mode->condition;
	number[2] = mode->axial_share;
	number[3] = mode->normal_share;
	number[4] = mode->out_of_plane_share;
	number[5] = mode->downstream;
}

static void mode_rows(struct hawser__table *table, const struct hawser_complex_modes *modes)
{
	static const char *const column[] = {"index", "omega_rad_s", "frequency_Hz", "re_per_s",
	                                     "plane"};

	for (int i = 0; i < 5; i++)
		hawser__table_column(table, "%s", column[i]);
	for (int i = 0; i < NUMBERS; i++)
		hawser__table_column(table, "%s", number_name[i]);
	for (int k = 0; k < modes->n; k++) {
		const struct hawser_complex_mode *mode = &modes->mode[k];
		double number[NUMBERS];

		numbers_of(number, mode);
		hawser__table_number(table, k + 1);
		hawser__table_number(table, mode->im/modes->time_unit);
		hawser__table_number(table, mode->im/modes->time_unit/(2.0*M_PI));
		hawser__table_number(table, mode->re/modes->time_unit);
		hawser__table_word(table, hawser_plane_name(mode->plane));
		for (int i = 0; i < NUMBERS; i++)
			hawser__table_number(table, number[i]);
	}
}

static void shape_rows(struct hawser__table *table, const struct hawser_complex_modes *modes,
                       int points)
{
	double value[12], S;

	for (int k = 0; k < modes->n; k++)
		hawser__table_comment(table, "mode %d: omega = %.15g rad/s, %s", k + 1,
		                      modes->mode[k].im/modes->time_unit,
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

void cli_travel_rows(struct hawser__table *table, const struct hawser_complex_modes *modes,
                     int points)
{
	const struct hawser_motion *motion = &modes->statics.motion;

	hawser__table_comment(table, "%d functions a component, time unit %.12g s", modes->basis,
	                      modes->time_unit);
	hawser__table_comment(table,
	                      "travels at %.10g m/s; tension at S = 0 %.10g N, apparent one %.10g N",
	                      motion->speed, motion->tension, modes->statics.T0);
	if (points > 0)
		shape_rows(table, modes, points);
	else
		mode_rows(table, modes);
}

/* One part of one component of one mode, or (c < 0) the abscissa. */
static void samples_json(struct hawser__json *json, json_t *into, const char *key,
                         const struct hawser_complex_modes *modes, int k, int c, int points)
{
	json_t *list = hawser__json_array(json, into, key);
	double value[12], S;

	for (int i = 0; i < points; i++) {
		S = sample(value, modes, k, i, points);
		hawser__json_number(json, list, NULL, c < 0 ? S : value[c]);
	}
}

static void shapes_json(struct hawser__json *json, const struct hawser_complex_modes *modes,
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

void cli_travel_json(struct hawser__json *json, const struct hawser_complex_modes *modes,
                     int points)
{
	const struct hawser_motion *motion = &modes->statics.motion;
	json_t *list, *row, *travel;

	hawser__json_text(json, json->root, "method", modes->method);
	hawser__json_integer(json, json->root, "basis", modes->basis);
	hawser__json_number(json, json->root, "time_unit", modes->time_unit);
	travel = hawser__json_object(json, json->root, "travel");
	hawser__json_number(json, travel, "speed", motion->speed);
	hawser__json_number(json, travel, "tension", motion->tension);
	hawser__json_number(json, travel, "apparent_tension", modes->statics.T0);
	hawser__json_number(json, travel, "mach2", motion->mach2);
	list = hawser__json_array(json, json->root, "modes");
	for (int k = 0; k < modes->n; k++) {
		const struct hawser_complex_mode *mode = &modes->mode[k];
		double number[NUMBERS];

		numbers_of(number, mode);
		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "index", k + 1);
		hawser__json_number(json, row, "omega", mode->im/modes->time_unit);
		hawser__json_number(json, row, "frequency", mode->im/modes->time_unit/(2.0*M_PI));
		hawser__json_number(json, row, "re", mode->re/modes->time_unit);
		hawser__json_number(json, row, "im", mode->im/modes->time_unit);
		hawser__json_text(json, row, "plane", hawser_plane_name(mode->plane));
		for (int i = 0; i < NUMBERS; i++)
			hawser__json_number(json, row, number_name[i], number[i]);
	}
	if (points > 0)
		shapes_json(json, modes, points);
}

void cli_travel_methods(void)
{
	const struct hawser_complex_modes_method *method;
	int count;

	method = hawser_complex_modes_methods(&count);
	puts("\nwhere the scene travels:");
	for (int i = 0; i < count; i++)
		printf("%s\n  %s\n  %s\n", method[i].name, method[i].summary, method[i].source);
}

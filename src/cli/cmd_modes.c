/* cli/cmd_modes.c - hawser modes: natural frequencies and mode shapes about the static profile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/modes_travel.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *method, *view;
	int n, basis, points, shapes, list;
};
static const struct settings defaults = {.view = "components", .points = 201};

static enum hawser_status store_view(void *field, const struct cli_option *option,
                                     const char *const *values, struct hawser_report *report)
{
	if (strcmp(values[0], "components") != 0 && strcmp(values[0], "profile") != 0 &&
	    strcmp(values[0], "waves") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write components, profile or waves", option->name, values[0]);
	return cli_store_text(field, option, values, report);
}

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", cli_store_integer,
	 offsetof(struct settings, n)},
	{"method", 0, "NAME", "method (spectral)", cli_store_text,
	 offsetof(struct settings, method)},
	{"basis", 0, "N", "functions per component (as many as the tolerance requires)",
	 cli_store_integer, offsetof(struct settings, basis)},
	{"shapes", 0, "", "write the shapes and slopes to the table, and to JSON", cli_store_flag,
	 offsetof(struct settings, shapes)},
	{"points", 0, "N", "number of points of a shape (201)", cli_store_count,
	 offsetof(struct settings, points)},
	{"view", 0, "NAME", "contents of the picture: components, profile or waves (components)",
	 store_view, offsetof(struct settings, view)},
	{"list-methods", 0, "", "list the methods and exit", cli_store_flag,
	 offsetof(struct settings, list)},
	{NULL, 0, NULL, NULL, NULL, 0},
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	int travels; /* complex modes, not `modes` */
	struct hawser_modes modes;
	struct hawser_complex_modes travelling;
};

static double rad_per_s(const struct hawser_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

/* S (m) and P, Q, B, a, b, c of mode k at sample i. */
static double sample(double *value, const struct result *result, int k, int i)
{
	double s = result->modes.statics.l*i/(result->settings->points - 1);

	hawser_modes_at(&result->modes, value, value + 3, k, s);
	return s*result->modes.statics.span.d;
}
static const char components[] = "PQBabc";

static void mode_rows(struct hawser__table *table, const struct hawser_modes *modes)
{
	static const char *const column[] = {"index", "omega_rad_s", "frequency_Hz", "plane",
	                                     "family", "symmetry", "residual", "axial_share",
	                                     "normal_share", "out_of_plane_share"};
	int i, c;

	for (i = 0; i < 10; i++)
		hawser__table_column(table, "%s", column[i]);
	for (c = 0; c < 3; c++)
		hawser__table_column(table, "participation_%c", "xyz"[c]);
	for (c = 0; c < 3; c++)
		hawser__table_column(table, "effective_mass_%c", "xyz"[c]);
	for (i = 0; i < modes->n; i++) {
		const struct hawser_mode *mode = &modes->mode[i];

		hawser__table_number(table, i + 1);
		hawser__table_number(table, rad_per_s(modes, i));
		hawser__table_number(table, rad_per_s(modes, i)/(2.0*M_PI));
		hawser__table_word(table, hawser_plane_name(mode->plane));
		hawser__table_word(table, hawser_family_name(mode->family));
		hawser__table_word(table, hawser_symmetry_name(mode->symmetry));
		hawser__table_number(table, mode->residual);
		hawser__table_number(table, mode->axial_share);
		hawser__table_number(table, mode->normal_share);
		hawser__table_number(table, mode->out_of_plane_share);
		for (c = 0; c < 3; c++)
			hawser__table_number(table, mode->participation[c]);
		for (c = 0; c < 3; c++)
			hawser__table_number(table, mode->effective_mass[c]);
	}
}

static void shape_rows(struct hawser__table *table, const struct result *result)
{
	const struct hawser_modes *modes = &result->modes;
	double value[6], S;
	int i, k, c;

	for (k = 0; k < modes->n; k++)
		hawser__table_comment(table, "mode %d: omega = %.15g rad/s, %s, %s", k + 1,
		                      rad_per_s(modes, k), hawser_plane_name(modes->mode[k].plane),
		                      hawser_family_name(modes->mode[k].family));
	hawser__table_comment(table, "shapes: P axial, Q normal, B out of plane; the integral of "
	                             "P^2 + Q^2 + B^2 over S/d is 1");
	hawser__table_comment(table, "slopes by S/d in the local frame: a = P' - kappa Q, "
	                             "b = Q' + kappa P, c = B'");
	hawser__table_column(table, "S_m");
	for (k = 0; k < modes->n; k++)
		for (c = 0; c < 6; c++)
			hawser__table_column(table, "%c_%d", components[c], k + 1);
	for (i = 0; i < result->settings->points; i++)
		for (k = 0; k < modes->n; k++) {
			S = sample(value, result, k, i);
			if (k == 0)
				hawser__table_number(table, S);
			for (c = 0; c < 6; c++)
				hawser__table_number(table, value[c]);
		}
}

static void fill_table(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_modes *modes = &result->modes;

	cli_echo_table(table, &result->settings->common, "modes", &result->scene,
	               result->travels ? result->travelling.method : modes->method);
	if (result->travels) {
		cli_travel_rows(table, &result->travelling,
		                result->settings->shapes ? result->settings->points : 0);
		return;
	}
	hawser__table_comment(table, "%d functions a component, time unit %.12g s", modes->basis,
	                      modes->time_unit);
	if (result->settings->shapes)
		shape_rows(table, result);
	else
		mode_rows(table, modes);
}

/* One component of one mode, or (c < 0) the abscissa. */
static void samples_json(struct hawser__json *json, json_t *into, const char *key,
                         const struct result *result, int k, int c)
{
	json_t *list = hawser__json_array(json, into, key);
	double value[6], S;
	int i;

	for (i = 0; i < result->settings->points; i++) {
		S = sample(value, result, k, i);
		hawser__json_number(json, list, NULL, c < 0 ? S : value[c]);
	}
}

static void shapes_json(struct hawser__json *json, const struct result *result)
{
	json_t *shapes = hawser__json_object(json, json->root, "shapes"), *list, *mode;
	int k, c;

	samples_json(json, shapes, "S", result, 0, -1);
	list = hawser__json_array(json, shapes, "modes");
	for (k = 0; k < result->modes.n; k++) {
		mode = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, mode, "index", k + 1);
		for (c = 0; c < 6; c++) {
			const char key[] = {components[c], '\0'};

			samples_json(json, mode, key, result, k, c);
		}
	}
}

/* [3] values along x, y, z. */
static void axes_json(struct hawser__json *json, json_t *row, const char *key, const double *value)
{
	json_t *list = hawser__json_array(json, row, key);
	int c;

	for (c = 0; c < 3; c++)
		hawser__json_number(json, list, NULL, value[c]);
}

static void fill_json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	const struct hawser_modes *modes = &result->modes;
	json_t *list, *row;
	int k;

	cli_echo_json(json, &result->settings->common, "modes", &result->scene);
	if (result->travels) {
		cli_travel_json(json, &result->travelling,
		                result->settings->shapes ? result->settings->points : 0);
		cli_stats_json(json, &result->settings->common);
		return;
	}
	hawser__json_text(json, json->root, "method", modes->method);
	hawser__json_integer(json, json->root, "basis", modes->basis);
	hawser__json_number(json, json->root, "time_unit", modes->time_unit);
	list = hawser__json_array(json, json->root, "modes");
	for (k = 0; k < modes->n; k++) {
		const struct hawser_mode *mode = &modes->mode[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "index", k + 1);
		hawser__json_number(json, row, "omega", rad_per_s(modes, k));
		hawser__json_number(json, row, "frequency", rad_per_s(modes, k)/(2.0*M_PI));
		hawser__json_text(json, row, "plane", hawser_plane_name(mode->plane));
		hawser__json_text(json, row, "family", hawser_family_name(mode->family));
		hawser__json_text(json, row, "symmetry", hawser_symmetry_name(mode->symmetry));
		hawser__json_number(json, row, "residual", mode->residual);
		hawser__json_number(json, row, "axial_share", mode->axial_share);
		hawser__json_number(json, row, "normal_share", mode->normal_share);
		hawser__json_number(json, row, "out_of_plane_share", mode->out_of_plane_share);
		axes_json(json, row, "participation", mode->participation);
		axes_json(json, row, "effective_mass", mode->effective_mass);
	}
	if (result->settings->shapes)
		shapes_json(json, result);
	cli_stats_json(json, &result->settings->common);
}

static enum hawser_status draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct result *result = context;

	if (result->travels && strcmp(result->settings->view, "components") == 0)
		return hawser__plot_complex_modes(path, &result->travelling, report);
	if (result->travels)
		return strcmp(result->settings->view, "profile") == 0
		           ? hawser__plot_passing(path, &result->travelling, report)
		           : hawser__plot_waves(path, &result->travelling, report);
	return strcmp(result->settings->view, "profile") == 0
	           ? hawser__plot_displaced(path, &result->modes, report)
	           : hawser__plot_modes(path, &result->modes, report);
}

static void list_methods(void)
{
	const struct hawser_modes_method *method;
	int count, i;

	method = hawser_modes_methods(&count);
	for (i = 0; i < count; i++)
		printf("%s\n  %s\n  %s\n", method[i].name, method[i].summary, method[i].source);
	cli_travel_methods();
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	struct hawser_modes_options choice;
	struct hawser_statics statics;
	enum hawser_status status = cli_scene_load(&result->scene, &settings->common, settings->n,
	                                           report);

	if (!status)
		status = hawser_statics_scene(&statics, &result->scene, report);
	if (status)
		return status;
	choice = cli_modes_options(&result->scene);
	choice.method = settings->method;
	if (settings->basis > 0)
		choice.basis = settings->basis;
	result->travels = statics.motion.nu != 0.0;
	if (result->travels)
		return hawser_complex_modes_solve(&result->travelling, &statics, &choice, report);
	if (strcmp(settings->view, "waves") == 0 && settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "--view waves shows the modes of a cable that travels, and this one does "
		                    "not: give it a travel.speed, or choose components or profile");
	return hawser_modes_solve(&result->modes, &statics, &choice, report);
}

static const struct cli_showing showing = {fill_table, fill_json, draw};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result result = {.settings = settings};
	enum hawser_status status;

	if (settings->list) {
		list_methods();
		return HAWSER_OK;
	}
	if (!settings->common.input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes needs a SCENE (hawser modes --help)");
	status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = solve(&result, report);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	hawser_modes_clear(&result.modes);
	hawser_complex_modes_clear(&result.travelling);
	hawser_scene_clear(&result.scene);
	return status;
}

const struct cli_command cli_modes = {
	"modes", "SCENE", "Natural frequencies and mode shapes", NULL, options, &defaults,
	sizeof(struct settings), 0, run, NULL,
};

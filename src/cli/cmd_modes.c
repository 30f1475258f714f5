/* cli/cmd_modes.c - hawser modes: natural frequencies and mode shapes about the static profile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/modes_travel.h"
#include "cli/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *method, *view;
	int n, basis, points, shapes, list;
};
static const struct settings defaults = {.view = "components", .points = 201};

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", CLI_INTEGER(n)},
	{"method", 0, "NAME", "method (spectral)", CLI_TEXT(method)},
	{"basis", 0, "N", "functions per component (as many as the tolerance requires)",
	 CLI_INTEGER(basis)},
	{"shapes", 0, "", "write the shapes and slopes to the table, and to JSON", CLI_FLAG(shapes)},
	{"points", 0, "N", "number of points of a shape (201)", CLI_COUNT(points)},
	{"view", 0, "NAME", "contents of the picture: components, profile or waves (components)",
	 CLI_TEXT(view)},
	{"list-methods", 0, "", "list the methods and exit", CLI_FLAG(list)},
	CLI_NO_OPTION,
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	struct hawser_modes modes; /* complex ones if the cable travels */
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

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(family_name, hawser_family_name, enum hawser_family)
HAWSER__LABELS(symmetry_name, hawser_symmetry_name, enum hawser_symmetry)

#define OF(member) HAWSER__AT(struct hawser_mode, member)
#define LABEL(member, function) HAWSER__LABEL_AT(struct hawser_mode, member, function)
static const struct hawser__field mode_field[] = {
	{"index", "index", "from 1, by frequency", .kind = HAWSER__INDEX},
	{"omega", "omega", "circular frequency", OF(omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", OF(omega), .unit = HAWSER__HERTZ},
	{"plane", "plane", "in-plane or out-of-plane", LABEL(plane, plane_name)},
	{"family", "family", "transverse or longitudinal", LABEL(family, family_name)},
	{"symmetry", "symmetry", "of the dominant component", LABEL(symmetry, symmetry_name)},
	{"residual", "residual", "error estimate of the frequency, relative", OF(residual)},
	{"axial_share", "axial_share", "share of the kinetic energy along the cable", OF(axial_share)},
	{"normal_share", "normal_share", "share normal to the cable", OF(normal_share)},
	{"out_of_plane_share", "out_of_plane_share", "share out of plane", OF(out_of_plane_share)},
	{"participation", "participation_", "integral of the shape along an axis", OF(participation),
	 .vector = &cli_axes},
	{"effective_mass", "effective_mass_", "modal effective mass over the mass of the cable",
	 OF(effective_mass),
	 .vector = &cli_axes},
	HAWSER__END,
};
#undef LABEL
#undef OF

/* With the frequency in rad/s. */
static const void *mode_row(void *to, const void *parent, size_t k)
{
	const struct hawser_modes *modes = parent;
	struct hawser_mode *mode = to;

	*mode = modes->mode[k];
	mode->omega = rad_per_s(modes, (int)k);
	return mode;
}
static const struct hawser__list mode_list = HAWSER__MADE_ROWS(
	struct hawser_mode, mode_field, struct hawser_modes, n, mode_row);

#define OF(member) HAWSER__AT(struct hawser_modes, member)
static const struct hawser__field modes_field[] = {
	{"method", NULL, "by which they are computed", OF(method)},
	{"basis", NULL, "functions per component", OF(basis)},
	{"time_unit", NULL, "of the scaled equations", OF(time_unit), .unit = HAWSER__SECOND},
	{"modes", NULL, "by frequency, both planes together", HAWSER__OBJECTS_OF(mode_list)},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_modes_listing[] = {
	{"Columns of the table:", mode_field, 0},
	{"Columns of a scene that travels:", cli_travel_mode_field, 0},
	{"Keys of JSON:", modes_field, 1},
	{"Keys of a scene that travels:", cli_travel_field, 1},
	{NULL, NULL, 0},
};

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
	struct hawser__view view = cli_si_view(0);

	cli_echo_table(table, &result->settings->common, "modes", &result->scene,
	               modes->method);
	if (result->modes.gyroscopic) {
		cli_travel_rows(table, &result->modes,
		                result->settings->shapes ? result->settings->points : 0);
		return;
	}
	hawser__table_comment(table, "%d functions a component, time unit %.12g s", modes->basis,
	                      modes->time_unit);
	if (result->settings->shapes)
		shape_rows(table, result);
	else
		hawser__fields_table(table, &mode_list, modes, &view);
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

static void fill_json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	struct hawser__view view = cli_si_view(0);

	cli_echo_json(json, &result->settings->common, "modes", &result->scene);
	if (result->modes.gyroscopic) {
		cli_travel_json(json, &result->modes,
		                result->settings->shapes ? result->settings->points : 0);
		cli_stats_json(json, &result->settings->common);
		return;
	}
	hawser__fields_json(json, json->root, modes_field, &result->modes, &view);
	if (result->settings->shapes)
		shapes_json(json, result);
	cli_stats_json(json, &result->settings->common);
}

static enum hawser_status draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct result *result = context;

	if (result->modes.gyroscopic && strcmp(result->settings->view, "components") == 0)
		return hawser__plot_complex_modes(path, &result->modes, report);
	if (result->modes.gyroscopic)
		return strcmp(result->settings->view, "profile") == 0
		           ? hawser__plot_passing(path, &result->modes, report)
		           : hawser__plot_waves(path, &result->modes, report);
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
	if (statics.motion.nu == 0.0 && strcmp(settings->view, "waves") == 0 && settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "--view waves shows the modes of a cable that travels, and this one does "
		                    "not: give it a travel.speed, or choose components or profile");
	return hawser_steady_modes_solve(&result->modes, &statics, &choice, report);
}

static const struct cli_showing showing = {
	.table = fill_table, .json = fill_json, .draw = draw};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result result = {.settings = settings};
	enum hawser_status status;

	static const char *const views[] = {"components", "profile", "waves"};
	int view;

	if (settings->list) {
		list_methods();
		return HAWSER_OK;
	}
	if (!settings->common.input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes needs a SCENE (hawser modes --help)");
	status = cli_choose(&view, "modes", "view", settings->view, views, 3, report);
	if (!status)
		status = cli_outputs_check(&settings->common, report);
	if (!status)
		status = solve(&result, report);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	hawser_modes_clear(&result.modes);
	hawser_scene_clear(&result.scene);
	return status;
}

const struct cli_command cli_modes = {
	"modes", "SCENE", "Natural frequencies and mode shapes", NULL, options, &defaults,
	sizeof(struct settings), 0, run, cli_modes_listing,
};

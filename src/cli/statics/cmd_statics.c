/* cli/statics/cmd_statics.c - hawser statics: the shape and the tensions of a span, at rest or
 * travelling. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"

struct settings {
	struct cli_statics_kinds kinds;
	const char *model, *from, *to;
	int models, compatibility, speeds, elements;
};
static const struct settings defaults = {.kinds.points = 201};

static const char *const notes[] = {
	"Methods for nets: automatic, interior-point, cone, forces, catenary.",
	NULL,
};

static const struct cli_option options[] = {
	{"model", 0, "NAME", "static model: catenary, inextensible, parabola or fe (catenary)",
	 CLI_TEXT_FOR(model, CLI_SPAN)},
	{"points", 0, "N", "number of points of the profile or of the curves (201)",
	 CLI_COUNT_FOR(kinds.points, CLI_SPAN | CLI_OBSTACLES)},
	{"cases", 0, "", "table of the load cases of the scene",
	 CLI_FLAG_FOR(kinds.cases, CLI_SPAN | CLI_ROPEWAY), .excludes = "model"},
	CLI_HEADING("Tables of a span"),
	{"models", 0, "", "table of all models and their errors against the catenary",
	 CLI_FLAG_FOR(models, CLI_SPAN), .excludes = "compatibility, speeds, cases, model"},
	{"compatibility", 0, "", "table of epsilon, delta, eta and more over the tension",
	 CLI_FLAG_FOR(compatibility, CLI_SPAN), .excludes = "speeds, cases, model"},
	{"speeds", 0, "", "table of the steady state over the speed, for both holds",
	 CLI_FLAG_FOR(speeds, CLI_SPAN), .excludes = "cases, model"},
	{"from", 0, "VALUE", "curves: lowest horizontal tension (delta = 4), or speed (0)",
	 CLI_TEXT_FOR(from, CLI_SPAN), .needs = "models, compatibility, speeds"},
	{"to", 0, "VALUE", "curves: highest tension (epsilon = 0.02), or speed (past the limit)",
	 CLI_TEXT_FOR(to, CLI_SPAN), .needs = "models, compatibility, speeds"},
	{"elements", 0, "N", "elements of the mesh of --model fe (120)",
	 CLI_INTEGER_FOR(elements, CLI_SPAN), .needs = "model=fe"},
	CLI_HEADING("Nets, ropeways and obstacles"),
	CLI_STATICS_KINDS_OPTIONS,
	CLI_NO_OPTION,
};

struct result {
	const struct settings *settings;
	struct hawser_scene scene;
	const struct hawser_statics_model *model;
	int fe;                               /* 1: a mesh of cable elements, and `mesh` is set */
	struct hawser_net_span_statics mesh;
	struct hawser_statics statics; /* travelling: with the apparent quantities */
	struct hawser_statics actual;  /* the actual ones */
	double limit;                  /* m/s, if the cable travels */
	struct cli_loaded loaded;
	struct hawser__spot *profile; /* [points] */
	int points;
	struct cli_mark mark[HAWSER_ATTACH_MAX]; /* [marks] */
	int marks;
	struct cli_curves curves;
	struct cli_speeds speeds;
	struct cli_cases cases;
};

enum { TRAVELS = 1, MODELS = 2, COMPATIBILITY = 4, SPEEDS = 8, ATTACHED = 16, LOADED = 32,
       TURNED = 64, CASES = 128, MESH = 256 };

#define OF(member) HAWSER__AT(struct hawser__spot, member)
static const struct hawser__field profile_field[] = {
	{"S", "S", "unstretched arclength from end A", OF(S), .unit = HAWSER__METRE},
	{"x", "x", "distance from end A", OF(x), .unit = HAWSER__METRE,
	 .axis = "Distance {/:Italic x}"},
	{"y", "y", "height above end A", OF(y), .unit = HAWSER__METRE,
	 .axis = "Height {/:Italic y}"},
	{"T", "T", "tension", OF(T), .unit = HAWSER__NEWTON, .axis = "Tension {/:Italic T}"},
	{NULL, "slope", "dy/dx", OF(slope), .flags = HAWSER__INFINITE | HAWSER__NULL},
	{NULL, "z", "distance from the vertical plane through the ends", OF(z), .unit = HAWSER__METRE,
	 .axis = "Distance {/:Italic z}", .when = TURNED},
	HAWSER__END,
};
#undef OF
static const struct hawser__list profile_list =
	HAWSER__STORED_ROWS(struct result, profile, points, profile_field);

HAWSER__OF(hold_word, const char *, struct result,
	of->statics.motion.hold == HAWSER_HOLD_LENGTH ? "length" : "tension")

/* eta, epsilon, delta and Irvine's parameters are those of the apparent cable, as modes use them. */
static void travel_comments(struct hawser__table *table, const struct result *result)
{
	const struct hawser_motion *motion = &result->statics.motion;

	hawser__table_comment(table, "speed = %.12g m/s, fluctuation = %.12g m/s, %s held",
	                      motion->speed, motion->fluctuation, hold_word(result));
	hawser__table_comment(table, "limit = %.12g m/s, end of the steady state", result->limit);
	hawser__table_comment(table, "nu = %.12g", motion->nu);
	hawser__table_comment(table, "apparent_H = %.12g N, of a cable at rest with this shape, to which "
	                             "eta, epsilon, delta and both irvine belong", result->statics.H);
}

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field travel_field[] = {
	{"speed", NULL, "travel speed", OF(statics.motion.speed), .unit = HAWSER__METRE_S},
	{"fluctuation", NULL, "its amplitude", OF(statics.motion.fluctuation),
	 .unit = HAWSER__METRE_S},
	{"hold", NULL, "tension or length", HAWSER__TEXT_BY(hold_word)},
	{"limit", NULL, "end of the steady state; null: none", OF(limit), .unit = HAWSER__METRE_S,
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"nu", NULL, "speed over that of transverse waves", OF(statics.motion.nu)},
	{"mach2", NULL, "square of speed over that of axial waves", OF(statics.motion.mach2)},
	{"apparent_H", NULL, "H of the apparent cable", OF(statics.H), .unit = HAWSER__NEWTON},
	{"apparent_T0", NULL, "T0 of the apparent cable", OF(statics.T0), .unit = HAWSER__NEWTON},
	{"apparent_T1", NULL, "T1 of the apparent cable", OF(statics.T1), .unit = HAWSER__NEWTON},
	HAWSER__END,
};
#undef OF

static const struct hawser__field point_field[] = {
	{"profile_z", NULL, "z of these points, under a static load", HAWSER__AT(struct hawser__spot, z),
	 .unit = HAWSER__METRE, .when = TURNED},
	HAWSER__END,
};
static const struct hawser__list point_list =
	HAWSER__STORED_ROWS(struct result, profile, points, point_field);
static const struct hawser__field name_field[] = {
	{"model", NULL, "static model", HAWSER__AT(struct hawser_statics_model, name)},
	HAWSER__END,
};
#define PART(member, fields) {"", NULL, "", HAWSER__PART_OF(struct result, member, fields)
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct result, model, name_field)},
	PART(actual, cli_statics_field)},
	PART(mesh, cli_statics_mesh_field), .when = MESH},
	{"travel", NULL, "of a cable that travels", HAWSER__OBJECT_OF(travel_field), .when = TRAVELS},
	{"attachments", NULL, "of the scene, by S",
	 HAWSER__STORED_WITHIN(struct result, mark, marks, cli_mark_field), .when = ATTACHED},
	{"loaded", NULL, "with a static load or a change of temperature",
	 HAWSER__PART_OF(struct result, loaded, cli_loaded_field), .when = LOADED},
	{"profile_columns", NULL, "S, x, y, T", HAWSER__KEYS_OF(profile_list)},
	{"profile", NULL, "points: lists of these", HAWSER__ROWS_OF(profile_list)},
	{"", NULL, "", HAWSER__ARRAYS_OF(point_list)},
	PART(curves, cli_models_member), .when = MODELS},
	PART(speeds, cli_speeds_member), .when = SPEEDS},
	PART(cases, cli_cases_member), .when = CASES},
	PART(curves, cli_compatibility_member), .when = COMPATIBILITY},
	HAWSER__END,
};
#undef PART

const struct cli_listing cli_statics_listing[] = {
	{"Columns of the table:", profile_field, 0},
	{"Columns with --models:", cli_model_field, 0},
	{"Columns with --compatibility:", cli_compatibility_field, 0},
	{"Columns with --speeds:", cli_speed_field, 0},
	{"Columns with --cases:", cli_case_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* 1 if the cable has displacements across the vertical plane of its ends. */
static int aside(const struct hawser_statics *st)
{
	return st->turned || st->space;
}

static const char *method_of(const struct result *result)
{
	const struct hawser_statics *st = &result->statics;

	if (result->fe)
		return "mesh of cable elements that carry tension only";
	if (result->model != hawser_statics_model(0))
		return result->model->summary;
	return st->space ? "elastic catenaries in space, Newton's method for the force at end A"
	                 : "elastic catenary, bracketed monotone solve";
}

static struct cli_head head(const void *of)
{
	const struct result *result = of;
	const struct settings *settings = result->settings;

	return (struct cli_head){
		&settings->kinds.common, "statics", method_of(result), &result->scene,
		cli_si_view((result->scene.travel.present ? TRAVELS : 0u) |
		            (result->marks ? ATTACHED : 0u) |
		            (result->loaded.present ? LOADED : 0u) |
		            (aside(&result->statics) ? TURNED : 0u) |
		            (settings->models ? MODELS : 0u) | (settings->kinds.cases ? CASES : 0u) |
		            (settings->speeds ? SPEEDS : 0u) | (result->fe ? MESH : 0u) |
		            (settings->compatibility ? COMPATIBILITY : 0u)), NULL, NULL, NULL};
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	struct hawser__view view = cli_si_view(0);

	hawser__fields_comments(table, cli_statics_field, &result->actual, &view);
	if (result->fe)
		cli_statics_mesh_comments(table, &result->mesh);
	if (result->scene.travel.present)
		travel_comments(table, result);
	cli_marks_comments(table, result->mark, result->marks);
	if (result->loaded.present)
		cli_loaded_comments(table, &result->loaded);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct settings *settings = result->settings;
	struct hawser__view view = cli_si_view(aside(&result->statics) ? TURNED : 0u);

	if (settings->kinds.cases)
		cli_cases_rows(table, &result->cases);
	else if (settings->speeds)
		cli_speeds_rows(table, &result->speeds);
	else if (settings->models)
		cli_models_rows(table, &result->curves);
	else if (settings->compatibility)
		hawser__fields_table(table, &cli_compatibility_list, &result->curves, &view);
	else
		hawser__fields_table(table, &profile_list, result, &view);
}

static enum hawser_status draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct result *result = context;
	const struct hawser__view view = cli_si_view(aside(&result->statics) ? TURNED : 0u);
	const struct hawser__axis axis[] = {
		hawser__fields_axis(profile_field, "x", &view, 0.0),
		hawser__fields_axis(profile_field, "y", &view, 0.0),
		hawser__fields_axis(profile_field, "T", &view, fmax(result->actual.T0, result->actual.T1)),
		hawser__fields_axis(profile_field, "z", &view, 0.0)};
	double most = 0.0;

	for (int i = 0; i < result->cases.rows; i++)
		most = fmax(most, fmax(result->cases.row[i].T0, result->cases.row[i].T1));
	const struct hawser__axis highest = hawser__fields_axis(profile_field, "T", &view, most);
	struct hawser__spot kink[2*HAWSER_ATTACH_MAX];
	const struct hawser__span_picture picture = {
		&result->scene, result->profile, kink, result->points, result->marks,
		aside(&result->statics)};

	if (result->settings->kinds.cases)
		return cli_cases_draw(path, &result->cases, &highest, report);
	if (result->settings->models)
		return cli_models_draw(path, &result->curves, report);
	if (result->settings->compatibility)
		return cli_compatibility_draw(path, &result->curves, report);
	if (result->settings->speeds)
		return cli_speeds_draw(path, &result->speeds, report);
	for (int i = 0; i < result->marks; i++) {
		kink[2*i] = result->mark[i].before;
		kink[2*i + 1] = result->mark[i].after;
	}
	return hawser__plot_statics(path, &picture, axis, report);
}

static enum hawser_status choose_model(struct result *result, struct hawser_report *report)
{
	const char *name[16];
	int count = 0, i;
	enum hawser_status status;

	result->model = hawser_statics_model(0);
	if (!result->settings->model)
		return HAWSER_OK;
	for (; hawser_statics_model(count); count++)
		name[count] = hawser_statics_model(count)->name;
	name[count] = "fe";
	status = cli_choose(&i, "statics", "model", result->settings->model, name, count + 1, report);
	result->fe = !status && i == count;
	result->model = hawser_statics_model(status || result->fe ? 0 : i);
	return status;
}

static enum hawser_status fill_speeds(struct result *result, struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	enum hawser_status status;

	if (!result->scene.travel.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--speeds is for a travelling cable: add travel: {speed: 1 m/s} to the "
		                    "scene (the speed itself does not matter here)");
	status = cli_quantity(&result->speeds.from, settings->from, "m/s", CLI_NOT_NEGATIVE, "statics",
	                      "from", report);
	if (!status)
		status = cli_quantity(&result->speeds.to, settings->to, "m/s", CLI_NOT_NEGATIVE, "statics",
		                      "to", report);
	return status ? status
	              : cli_speeds_fill(&result->speeds, &result->scene, settings->kinds.points, report);
}

static enum hawser_status fill_curves(struct result *result, struct hawser_report *report)
{
	const struct settings *settings = result->settings;
	double from = 0.0, to = 0.0;
	enum hawser_status status;

	if (settings->kinds.cases)
		return cli_cases_fill(&result->cases, &result->scene, report);
	if (settings->speeds)
		return fill_speeds(result, report);
	if (!settings->models && !settings->compatibility)
		return HAWSER_OK;
	status = cli_quantity(&from, settings->from, "N", CLI_ABOVE_ZERO, "statics", "from", report);
	if (!status)
		status = cli_quantity(&to, settings->to, "N", CLI_ABOVE_ZERO, "statics", "to", report);
	return status ? status
	              : cli_curves_fill(&result->curves, &result->scene, settings->models ? 16 : 1,
	                                settings->kinds.points, from, to, report);
}

static enum hawser_status limit_of(struct result *result, const struct hawser_equivalent *equal,
                                   struct hawser_report *report)
{
	const struct hawser_scene *scene = &result->scene;
	double V = scene->travel.fluctuation;
	enum hawser_status status = hawser_statics_limit(&result->limit, &equal->span, equal->given,
	                                                 equal->value, equal->branch,
	                                                 scene->travel.hold, report);

	if (!status && V > 0.0)
		result->limit = sqrt(fmax(result->limit*result->limit - 0.5*V*V, 0.0));
	return status;
}

static struct hawser__spot point(const struct result *result, double S)
{
	const struct hawser_statics *st = &result->statics;
	struct hawser_profile_point in = result->scene.travel.present ? hawser_statics_actual_at(st, S)
	                                                              : result->model->at(st, S);

	return cli_place(st, &in);
}

static enum hawser_status solve_state(struct result *result, struct hawser_report *report)
{
	const struct hawser_scene *scene = &result->scene;
	struct hawser_equivalent equal;
	enum hawser_status status = hawser_statics_equivalent(&equal, scene, report);

	if (!status && equal.yields && result->model != hawser_statics_model(0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                      "--model %s is for ends that stay where they are, and these have moved "
		                      "on springs: leave it out, or leave support.A.stiffness and "
		                      "support.B.stiffness out", result->model->name);
	if (status)
		return status;
	status = scene->travel.present || scene->attachments > 0
	             ? hawser_statics_scene(&result->statics, scene, report)
	             : result->model->solve(&result->statics, &equal.span, equal.given, equal.value,
	                                    equal.branch, report);
	if (!status && scene->travel.present)
		status = limit_of(result, &equal, report);
	if (status)
		return status;
	hawser_statics_turn(&result->statics, &equal);
	return cli_loaded_fill(&result->loaded, &result->statics, scene, report);
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct hawser_scene *scene = &result->scene;
	const struct settings *settings = result->settings;
	int points = settings->kinds.points, i;
	enum hawser_status status = choose_model(result, report);

	if (!status)
		status = cli_scene_load(&result->scene, &result->settings->kinds.common, 0, report);
	if (status)
		return status;
	if (scene->travel.present && result->model != hawser_statics_model(0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--model %s knows no travelling cable: take catenary, or a scene "
		                    "without travel", result->model->name);
	if (scene->attachments > 0 && (result->model != hawser_statics_model(0) ||
	                               settings->models || settings->compatibility))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "%s compares cables without attachments: leave it out, or set "
		                    "attach=[]", settings->models ? "--models"
		                    : settings->compatibility ? "--compatibility" : "--model");
	status = solve_state(result, report);
	if (!status)
		status = fill_curves(result, report);
	if (status)
		return status;
	result->actual = scene->travel.present ? hawser_statics_actual(&result->statics)
	                                       : result->statics;
	if (result->fe) {
		status = cli_statics_mesh(&result->profile, &result->mesh, scene, &result->statics,
		                          settings->elements, report);
		result->actual = result->mesh.statics;
		result->points = result->mesh.points;
		return status;
	}
	result->profile = calloc((size_t)points, sizeof *result->profile);
	if (!result->profile)
		return hawser__no_memory(report, "statics");
	result->marks = cli_marks_fill(result->mark, &result->statics, scene);
	for (i = 0; i < points; i++)
		result->profile[i] = point(result, result->actual.length0*i/(points - 1));
	return HAWSER_OK;
}

/* More points would not fit in memory; each point of a curve is a complete equilibrium. */
enum { most_profile_points = 10000000, most_curve_points = 1000000 };

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	int curves = settings->models || settings->compatibility || settings->speeds;
	const char *scales = settings->compatibility ? "xy" : settings->speeds ? "y" : "";
	int most = curves ? most_curve_points : most_profile_points;
	enum hawser_status status;

	if (settings->kinds.points > most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--points %d: at most %d points%s are possible", settings->kinds.points,
		                    most, curves ? " of curves" : "");
	status = cli_statics_mesh_check(settings->model, settings->kinds.points, defaults.kinds.points,
	                                report);
	return status ? status : cli_outputs_check_scales(&settings->kinds.common, scales, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field, .draw = draw};

enum hawser_status cli_statics_span(const void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct result result = {.settings = settings, .points = settings->kinds.points};
	enum hawser_status status = solve(&result, report);

	if (!status)
		status = cli_show(&settings->kinds.common, &showing, &result, report);
	free(result.profile);
	hawser_net_span_statics_clear(&result.mesh);
	cli_curves_clear(&result.curves);
	cli_speeds_clear(&result.speeds);
	free(result.cases.row);
	hawser_scene_clear(&result.scene);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	enum hawser_status status = check(settings, report);

	return status ? status : cli_part(&cli_statics, &settings->kinds.common)->run(settings, report);
}

const struct cli_command cli_statics = {
	"statics", "SCENE", "Static shape and tensions of a span, a net, a ropeway or a rod",
	notes, options, &defaults, sizeof(struct settings), 1, run, cli_statics_listing,
	.part = CLI_PART(statics),
};

/* cli/statics/statics_curves.c - hawser statics --models and --compatibility: comparison of the static
 * models, and one cable at different horizontal tensions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/figure.h"

/* Default range: from delta = 4, very slack, to epsilon = 0.02, or delta = 1e-3 of an inextensible
 * cable. */
static const double slackest = 4.0, tautest_strain = 0.02, tautest_delta = 1e-3;

static enum hawser_status range(double *from, double *to, const struct hawser_span *span,
                                struct hawser_report *report)
{
	double weight = span->rho*span->g*span->d;

	if (*from == 0.0)
		*from = weight/slackest;
	if (*to == 0.0)
		*to = isinf(span->EA) ? weight/tautest_delta : tautest_strain*span->EA;
	if (*from < *to)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
	                    "tensions from %.10g N to %.10g N are no range: give --from and --to, the "
	                    "smaller one first", *from, *to);
}

static enum hawser_status sweep(struct cli_curves *curves, const struct hawser_span *span,
                                double from, double to, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int i, k;

	for (k = 0; k < curves->models && !status; k++)
		for (i = 0; i < curves->points && !status; i++)
			status = hawser_statics_model(k)->solve(
			    curves->curve + k*curves->points + i, span, HAWSER_GIVEN_H,
			    from*pow(to/from, (double)i/(curves->points - 1)), HAWSER_BRANCH_TAUT, report);
	return status;
}

enum hawser_status cli_curves_fill(struct cli_curves *curves, const struct hawser_scene *scene,
                                   int models, int points, double from, double to,
                                   struct hawser_report *report)
{
	struct hawser_equivalent equal;
	enum hawser_status status = hawser_statics_equivalent(&equal, scene, report);
	int rows = 0, k;

	if (!status)
		status = range(&from, &to, &equal.span, report);
	if (status)
		return status;
	while (rows < models && hawser_statics_model(rows))
		rows++;
	curves->models = rows;
	curves->points = points;
	curves->here = calloc((size_t)rows, sizeof *curves->here);
	curves->status = calloc((size_t)rows, sizeof *curves->status);
	curves->report = calloc((size_t)rows, sizeof *curves->report);
	curves->curve = calloc((size_t)rows*(size_t)points, sizeof *curves->curve);
	if (!curves->here || !curves->status || !curves->report || !curves->curve)
		return hawser__no_memory(report, "statics");
	for (k = 0; k < curves->models; k++)
		curves->status[k] = hawser_statics_model(k)->solve(
			&curves->here[k], &equal.span, equal.given, equal.value, equal.branch,
			&curves->report[k]);
	if (curves->status[0]) { /* the solution of the catenary is that of the scene */
		*report = curves->report[0];
		return curves->status[0];
	}
	return sweep(curves, &equal.span, from, to, report);
}

void cli_curves_clear(struct cli_curves *curves)
{
	free(curves->here);
	free(curves->status);
	free(curves->report);
	free(curves->curve);
	memset(curves, 0, sizeof *curves);
}

/* --- --compatibility --- */

#define OF(member) HAWSER__AT(struct hawser_statics, member)
const struct hawser__field cli_compatibility_field[] = {
	{"H", "H", "horizontal tension", OF(H), .unit = HAWSER__NEWTON},
	{"delta", "delta", "rho g d/H", OF(delta), .axis = "Weight ratio {/:Italic δ}"},
	{"epsilon", "epsilon", "H/EA", OF(epsilon), .axis = "Elastic ratio {/:Italic ε}"},
	{"eta", "eta", "V0/H", OF(eta), .axis = "Slope at end A {/:Italic η}"},
	{"l", "l", "unstretched length over span", OF(l)},
	{"T0", "T0", "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"T1", "T1", "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"length0", "length0", "unstretched length", OF(length0), .unit = HAWSER__METRE},
	{"sag", "sag", "largest vertical distance from the chord", OF(sag), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_compatibility_list =
	HAWSER__STORED_ROWS(struct cli_curves, curve, points, cli_compatibility_field);
const struct hawser__field cli_compatibility_member[] = {
	{"compatibility", NULL, "with --compatibility: lists by name",
	 HAWSER__ARRAYS_OF(cli_compatibility_list)},
	HAWSER__END,
};

#define BIND(figure, statics, count, x, y) \
	hawser__figure_bind(figure, count, &(statics)->x, sizeof *(statics), &(statics)->y, \
	                    sizeof *(statics))

enum hawser_status cli_compatibility_draw(const char *path, const struct cli_curves *curves,
                                          struct hawser_report *report)
{
	static const char *const shown[] = {"delta", "eta", "epsilon"};
	struct hawser__view view = cli_si_view(0);
	struct hawser__figure figure = {0};
	struct hawser__axis axis[3];
	enum hawser_status status;
	char name[80];

	for (int k = 0; k < 3; k++)
		axis[k] = hawser__fields_axis(cli_compatibility_field, shown[k], &view, 0.0);
	if (curves->here->epsilon == 0.0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics",
		                    "the curves of an inextensible cable have epsilon = 0 everywhere, which "
		                    "has no place on a logarithmic axis: give a finite EA");
	status = hawser__figure_begin(&figure, path, 17.0, 9.4, report);
	if (status)
		return status;
	snprintf(name, sizeof name, "this cable, {/:Italic h/d} = %.4g", curves->here->hs);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.53, 0.29, 0.96,
		.x = {&axis[0], .logarithmic = 1}, .y = {&axis[2], .logarithmic = 1}});
	BIND(&figure, curves->curve, curves->points, delta, epsilon);
	hawser__figure_draw(&figure, name, "with lines lt 1");
	BIND(&figure, curves->here, 1, delta, epsilon);
	hawser__figure_draw(&figure, "scene", "with points pt 7 ps 1 lt 2");
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.60, 0.96, 0.29, 0.96,
		.x = {&axis[1], .tics = 5, .open = 1}, .y = {&axis[2], .logarithmic = 1, .bare = 1}});
	BIND(&figure, curves->curve, curves->points, eta, epsilon);
	hawser__figure_draw(&figure, NULL, "with lines lt 1");
	BIND(&figure, curves->here, 1, eta, epsilon);
	hawser__figure_draw(&figure, NULL, "with points pt 7 ps 1 lt 2");
	return hawser__figure_finish(&figure, report);
}

/* --- --models --- */

/* The solution of a model, or the reason why there is none. */
struct solution {
	const char *name, *why;
	int failed;
	struct hawser_statics here;
	struct hawser_statics_error error;
};
#define OF(member) HAWSER__AT(struct solution, here.member)
#define OFF(member) HAWSER__AT(struct solution, error.member)
/* Fields of a model without a solution; the reason is a comment in the table. */
static const struct hawser__field failed_field[] = {
	{"name", "model", "of the model", HAWSER__AT(struct solution, name)},
	{"solved", NULL, "whether there is a solution", HAWSER__NOT_AT(struct solution, failed)},
	{"why", NULL, "reason why there is none", HAWSER__AT(struct solution, why)},
	HAWSER__END,
};
const struct hawser__field cli_model_field[] = {
	{"name", "model", "of the model", HAWSER__AT(struct solution, name)},
	{"solved", NULL, "whether there is a solution", HAWSER__NOT_AT(struct solution, failed)},
	{"H", "H", "horizontal tension", OF(H), .unit = HAWSER__NEWTON},
	{"T0", "T0", "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"T1", "T1", "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"length0", "length0", "unstretched length", OF(length0), .unit = HAWSER__METRE},
	{"length", "length", "stretched length", OF(length), .unit = HAWSER__METRE},
	{"sag", "sag", "largest vertical distance from the chord", OF(sag), .unit = HAWSER__METRE},
	{"error.H", "error_H", "error of H, relative to the catenary, as the following", OFF(H)},
	{"error.T0", "error_T0", "of T0", OFF(T0)},
	{"error.T1", "error_T1", "of T1", OFF(T1)},
	{"error.length0", "error_length0", "of length0", OFF(length0)},
	{"error.length", "error_length", "of length", OFF(length)},
	{"error.sag", "error_sag", "of sag", OFF(sag)},
	{"error.position", "error_position", "largest vertical distance", OFF(position),
	 .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OFF
#undef OF

/* Returns its fields. */
static const struct hawser__field *solution_of(struct solution *row, const struct cli_curves *curves,
                                               int k)
{
	*row = (struct solution){.name = hawser_statics_model(k)->name,
	                         .why = curves->report[k].message,
	                         .failed = curves->status[k] != HAWSER_OK, .here = curves->here[k]};
	if (row->failed)
		return failed_field;
	hawser_statics_compare(&row->error, hawser_statics_model(k), &curves->here[k], &curves->here[0]);
	return cli_model_field;
}

void cli_models_rows(struct hawser__table *table, const struct cli_curves *curves)
{
	struct hawser__view view = cli_si_view(0);
	struct solution row;
	int k;

	for (k = 0; k < curves->models; k++) {
		const struct hawser_statics_model *model = hawser_statics_model(k);

		hawser__table_comment(table, "model %s: %s; %s", model->name, model->summary,
		                      model->source);
		if (curves->status[k])
			hawser__table_comment(table, "model %s: no solution: %s", model->name,
			                      curves->report[k].message);
	}
	hawser__table_comment(table, "errors are relative, against the elastic catenary; "
	                             "error_position is the largest vertical distance");
	hawser__fields_columns(table, cli_model_field, &view);
	for (k = 0; k < curves->models; k++) {
		const struct hawser__field *field = solution_of(&row, curves, k);

		hawser__fields_row(table, cli_model_field, field, &row, &view);
	}
}

static void models_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_curves *curves = of;
	json_t *list = hawser__json_array(json, into, "models");
	struct hawser__view view = cli_si_view(0);
	struct solution row;

	for (int k = 0; k < curves->models; k++) {
		const struct hawser__field *field = solution_of(&row, curves, k);

		hawser__fields_json(json, hawser__json_object(json, list, NULL), field, &row, &view);
	}
}

const struct hawser__field cli_models_member[] = {
	{"models", NULL, "with --models: each of them", HAWSER__CALLS(models_json),
	 .inner = cli_model_field},
	HAWSER__END,
};

/* Sag over span of each model; relative to that of the first one. */
static void draw_sags(struct hawser__figure *figure, const struct cli_curves *curves, int errors)
{
	static const char *const dash[] = {"solid", "(14,5)", "(5,4)", "(14,4,3,4)"};

	for (int k = errors; k < curves->models; k++) {
		const struct hawser_statics *of = curves->curve + k*curves->points;

		for (int i = 0; i < curves->points; i++)
			hawser__figure_put(figure, curves->curve[i].delta, errors
			                   ? fabs(of[i].sag/curves->curve[i].sag - 1.0)
			                   : of[i].sag/curves->here->span.d);
		hawser__figure_draw(figure, hawser_statics_model(k)->name, "with lines lt %d dt %s", k + 1,
		                    dash[k < 4 ? k : 3]);
	}
	hawser__figure_upright(figure, "scene", curves->here->delta, "lt 7 lw 0.8 dt (4,4)");
}

enum hawser_status cli_models_draw(const char *path, const struct cli_curves *curves,
                                   struct hawser_report *report)
{
	static const struct hawser__axis sag = {"Sag over span (–)", "", 1.0};
	static const struct hawser__axis error = {"Relative error of sag (–)", "", 1.0};
	struct hawser__view view = cli_si_view(0);
	struct hawser__axis delta = hawser__fields_axis(cli_compatibility_field, "delta", &view, 0.0);
	double from = curves->curve[curves->points - 1].delta, to = curves->curve[0].delta;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, 13.0, report);

	if (status)
		return status;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.60, 0.97,
		.x = {&delta, from, to, .logarithmic = 1, .bare = 1}, .y = {&sag, .logarithmic = 1}});
	draw_sags(&figure, curves, 0);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.22, 0.55,
		.x = {&delta, from, to, .logarithmic = 1}, .y = {&error, .logarithmic = 1}});
	draw_sags(&figure, curves, 1);
	return hawser__figure_finish(&figure, report);
}

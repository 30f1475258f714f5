/* cli/statics/statics_cases.c - hawser statics --cases: a row for each load case of the scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"
#include "output/drawing/figure.h"

#define OF(member) HAWSER__AT(struct cli_case, member)
#define ON(member) HAWSER__AT(struct cli_case, loaded.member)
/* A case without a solution: the reason is a comment in the table. */
static const struct hawser__field failed_field[] = {
	{"name", "case", "name of the case", OF(name)},
	{"solved", NULL, "whether there is a solution", HAWSER__NOT_AT(struct cli_case, status)},
	{"why", NULL, "reason why there is none", OF(why)},
	HAWSER__END,
};
const struct hawser__field cli_case_field[] = {
	{"name", "case", "name of the case", OF(name)},
	{"solved", NULL, "whether there is a solution", HAWSER__NOT_AT(struct cli_case, status)},
	{"H", "H", "tension across the static force (horizontal)", OF(H), .unit = HAWSER__NEWTON},
	{"T0", "T0", "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"T1", "T1", "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"sag", "sag", "largest distance from the chord along the static force", OF(sag),
	 .unit = HAWSER__METRE},
	{"sag_vertical", "sag_vertical", "largest vertical distance from the chord", ON(sag_vertical),
	 .unit = HAWSER__METRE},
	{"blowout", "blowout", "largest distance from the vertical plane through the ends", ON(blowout),
	 .unit = HAWSER__METRE},
	{"swing_angle", "swing_angle", "from the vertical plane to that of the cable", ON(swing),
	 .unit = HAWSER__RADIAN},
	{"length0", "length0", "unstretched length, at the temperature of the case", OF(length0),
	 .unit = HAWSER__METRE},
	{"length", "length", "stretched length", OF(length), .unit = HAWSER__METRE},
	{"pull_A", NULL, "force of the cable on support A along x, y, z", ON(pull[0]),
	 .unit = HAWSER__NEWTON},
	{"pull_B", NULL, "the same on support B", ON(pull[1]), .unit = HAWSER__NEWTON},
	{"moved_A", NULL, "displacement of end A on its springs along x, y, z", ON(moved[0]),
	 .unit = HAWSER__METRE},
	{"moved_B", NULL, "the same of end B", ON(moved[1]), .unit = HAWSER__METRE},
	{"imbalance", NULL, "largest force by which springs and cable differ", ON(imbalance),
	 .unit = HAWSER__NEWTON},
	HAWSER__END,
};
#undef ON
#undef OF

static void fill(struct cli_case *row, const struct hawser_scene *scene)
{
	struct hawser_statics st;
	struct hawser_report *report = &row->report;

	row->status = (int)hawser_statics_scene(&st, scene, report);
	if (!row->status)
		row->status = (int)cli_loaded_fill(&row->loaded, &st, scene, report);
	if (row->status)
		return;
	st = hawser_statics_actual(&st);
	row->H = st.H;
	row->T0 = st.T0;
	row->T1 = st.T1;
	row->sag = st.sag;
	row->length0 = st.length0;
	row->length = st.length;
}

enum hawser_status cli_cases_fill(struct cli_cases *cases, const struct hawser_scene *scene,
                                  struct hawser_report *report)
{
	enum hawser_status status;
	int failed = 0;

	if (scene->cases == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--cases is for a scene with load cases: add, for example, cases: "
		                    "[{name: ice, load: {static: {mass: 0.9 kg/m}}}]");
	cases->row = calloc((size_t)scene->cases + 1, sizeof *cases->row);
	if (!cases->row)
		return hawser__no_memory(report, "statics");
	for (int i = -1; i < scene->cases; i++) {
		struct cli_case *row = &cases->row[cases->rows++];
		struct hawser_scene *one = malloc(sizeof *one);

		if (!one)
			return hawser__no_memory(report, "statics");
		row->name = i < 0 ? "reference" : scene->load_case[i].name;
		status = hawser_statics_case(one, scene, i < 0 ? 0 : i, report);
		if (i < 0)
			one->static_load.present = one->wind.present = one->temperature.present = 0;
		if (!status)
			fill(row, one);
		row->why = row->report.message;
		failed += row->status != 0;
		free(one);
		if (status)
			return status;
	}
	if (failed < cases->rows)
		return HAWSER_OK;
	*report = cases->row[0].report;
	return (enum hawser_status)cases->row[0].status;
}

void cli_cases_rows(struct hawser__table *table, const struct cli_cases *cases)
{
	const struct hawser__view view = cli_si_view(0);

	for (int i = 0; i < cases->rows; i++)
		if (cases->row[i].status)
			hawser__table_comment(table, "case %s: no solution: %s", cases->row[i].name,
			                      cases->row[i].why);
		else if (cases->row[i].loaded.elastic)
			cli_moved_comment(table, cases->row[i].name, &cases->row[i].loaded);
	hawser__fields_columns(table, cli_case_field, &view);
	for (int i = 0; i < cases->rows; i++)
		hawser__fields_row(table, cli_case_field,
		                   cases->row[i].status ? failed_field : cli_case_field, &cases->row[i],
		                   &view);
}

static void cases_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_cases *cases = of;
	const struct hawser__view view = cli_si_view(0);
	json_t *list = hawser__json_array(json, into, "cases");

	for (int i = 0; i < cases->rows; i++)
		hawser__fields_json(json, hawser__json_object(json, list, NULL),
		                    cases->row[i].status ? failed_field : cli_case_field, &cases->row[i],
		                    &view);
}

const struct hawser__field cli_cases_member[] = {
	{"cases", NULL, "with --cases: the reference state, and each case", HAWSER__CALLS(cases_json),
	 .inner = cli_case_field},
	HAWSER__END,
};

/* The names along x, or only tics. */
static void tics(FILE *script, const struct cli_cases *cases, int named)
{
	fputs("set xtics rotate by 30 right (", script);
	for (int i = 0; i < cases->rows; i++) {
		fputs(i ? ", '" : "'", script);
		hawser__picture_literal(script, named ? cases->row[i].name : "", 0);
		fprintf(script, "' %d", i);
	}
	fprintf(script, ")\nset xrange [-0.6:%.9g]\n", cases->rows - 0.4);
}

/* Two quantities, each beside the case: tensions, or sag and blowout. */
static void draw_pair(struct hawser__figure *figure, const struct cli_cases *cases, int sags)
{
	static const struct {
		const char *title, *style;
		int colour;
		double shift;
	} shown[] = {{"largest tension", "pt 7 ps 0.7", 1, -0.08},
	             {"H, across the static force", "pt 6 ps 0.7", 2, 0.08},
	             {"sag", "pt 5 ps 0.7", 3, -0.08}, {"blowout", "pt 4 ps 0.7", 4, 0.08}};

	tics(figure->out.script, cases, sags);
	for (int k = 2*sags; k < 2*sags + 2; k++) {
		for (int i = 0; i < cases->rows; i++) {
			const struct cli_case *row = &cases->row[i];
			const double of[] = {fmax(row->T0, row->T1), row->H, row->sag, row->loaded.blowout};

			if (!row->status)
				hawser__figure_put(figure, i + shown[k].shift, of[k]);
		}
		hawser__figure_draw(figure, NULL, "with impulses lt %d lw 1.2", shown[k].colour);
		hawser__figure_again(figure, shown[k].title, "with points %s lt %d", shown[k].style,
		                     shown[k].colour);
	}
}

enum hawser_status cli_cases_draw(const char *path, const struct cli_cases *cases,
                                  const struct hawser__axis *axis, struct hawser_report *report)
{
	const struct hawser__axis length = hawser__axis_of("Sag, blowout", "m", 0.0);
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, 13.4, report);

	if (status)
		return status;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.68, 0.97,
		.x = {.as_set = 1},
		.y = {axis, .zero = 1}});
	draw_pair(&figure, cases, 0);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.34, 0.63,
		.x = {.as_set = 1},
		.y = {&length, .zero = 1}});
	draw_pair(&figure, cases, 1);
	return hawser__figure_finish(&figure, report);
}

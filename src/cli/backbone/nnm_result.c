/* cli/backbone/nnm_result.c - see nnm_result.h. In SI if the model has units.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/backbone/backbone.h"
#include "cli/backbone/nnm_result.h"
#include "output/drawing/figure.h"

/* --- fields --- */

struct row {
	int curve; /* index */
	struct hawser_backbone_point point;
	const double *coordinate, *probe, *start;
};

#define OF(member) HAWSER__AT(struct row, point.member)
static const struct hawser__field point_field[] = {
	{NULL, "curve", "from 1", HAWSER__AT(struct row, curve), .flags = HAWSER__FROM_1},
	{"Omega", "Omega", "frequency of the motion; of k periods, k times it", OF(omega),
	 .unit = HAWSER__RAD_S, .axis = "Frequency {/:Italic Ω}"},
	{"energy", "energy", "its energy", OF(energy), .unit = HAWSER__J, .axis = "Energy"},
	{"unstable", "unstable", "multipliers outside the unit circle", OF(unstable)},
	CLI_AMPLITUDE(HAWSER__VECTOR_AT, struct row, probe),
	CLI_COORDINATES(HAWSER__VECTOR_AT, struct row, coordinate),
	{"start", NULL, "coordinates at phase 0; of those with sign -1 the velocity over Omega",
	 HAWSER__VECTOR_AT(struct row, start, cli_coordinates), .unit = HAWSER__M},
	{"residual", "residual", "defect of the orbit, relative", OF(residual)},
	{"mesh", "mesh", "truncation error of the orbit, relative", OF(mesh)},
	{"energy_gap", "energy_gap", "largest change of the energy over half a period, relative",
	 OF(energy_gap)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct hawser_backbone_branch, member)
static const struct hawser__field branch_field[] = {
	{"Omega", NULL, "frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"energy", NULL, "energy", OF(energy), .unit = HAWSER__J},
	{"turned", NULL, "whether motions begin that whirl: with other signs",
	 HAWSER__FLAG_AT(struct hawser_backbone_branch, turned)},
	{"after", NULL, "index of the point before it", OF(after)},
	HAWSER__END,
};
#undef OF

struct curve {
	const struct hawser_nnm_curve *own;
	int number, points, branches, parent, born;
};

static const void *point_row(void *to, const void *parent, size_t i)
{
	const struct curve *curve = parent;
	const struct hawser_backbone *motion = &curve->own->motion;
	size_t n = (size_t)motion->n;

	*(struct row *)to = (struct row){.curve = curve->number, .point = motion->point[i],
		.coordinate = motion->coordinate + i*n, .start = motion->start + i*n,
		.probe = motion->probe + 3*i*(size_t)motion->probes};
	return to;
}

static const void *branch_row(void *to, const void *parent, size_t i)
{
	*(struct hawser_backbone_branch *)to = ((const struct curve *)parent)->own->motion.branch[i];
	return to;
}
static const struct hawser__list
	point_list = HAWSER__MADE_ROWS(struct row, point_field, struct curve, points, point_row),
	branch_list = HAWSER__MADE_ROWS(struct hawser_backbone_branch, branch_field, struct curve,
	                                branches, branch_row);

static const char *end_of(const struct hawser_nnm_curve *curve)
{
	return *curve->message ? "lost" : cli_backbone_end(curve->motion.end);
}

static void end_json(struct hawser__json *json, json_t *into, const void *row)
{
	hawser__json_text(json, into, "end", end_of(((const struct curve *)row)->own));
}

static void signs_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_backbone *motion = &((const struct curve *)row)->own->motion;
	json_t *list = json_array();

	for (int j = 0; list && j < motion->n; j++)
		json_array_append_new(list, json_integer(motion->sign[j]));
	json_object_set_new(into, "signs", list);
	(void)json;
}

static const char *message_of(const void *row)
{
	const struct hawser_nnm_curve *own = ((const struct curve *)row)->own;

	return *own->message ? own->message : NULL;
}

static const struct hawser__field curve_field[] = {
	{"parent", NULL, "the curve at whose branch point it begins, from 1; 0: the linear mode",
	 HAWSER__AT(struct curve, parent)},
	{"branch_point", NULL, "number of that branch point, from 1; 0: none",
	 HAWSER__AT(struct curve, born)},
	{"signs", NULL, "1: the coordinate is even in time, at rest at phase 0; -1: odd, and zero there",
	 HAWSER__CALLS(signs_json)},
	{"end", NULL, "why it ends", HAWSER__CALLS(end_json)},
	{"message", NULL, "why it was lost", HAWSER__TEXT_BY(message_of),
	 .flags = HAWSER__OMIT},
	{"branch_points", NULL, "where other motions begin, in order along it",
	 HAWSER__OBJECTS_OF(branch_list)},
	{"points", NULL, "motions, in order along it", HAWSER__OBJECTS_OF(point_list)},
	HAWSER__END,
};

static const void *curve_row(void *to, const void *parent, size_t c)
{
	const struct hawser_nnm_curve *own = &((const struct hawser_nnm *)parent)->curve[c];

	*(struct curve *)to = (struct curve){.own = own, .number = (int)c, .points = own->motion.points,
		.branches = own->motion.branches, .parent = own->parent + 1, .born = own->born + 1};
	return to;
}
static const struct hawser__list
	curve_list = HAWSER__MADE_ROWS(struct curve, curve_field, struct hawser_nnm, curves, curve_row);

static const struct hawser__field nnm_field[] = {
	{"curves", NULL, "the mode's own first, then its branches", HAWSER__OBJECTS_OF(curve_list)},
	{"not_followed", NULL, "number of branch points from which no curve could be begun",
	 HAWSER__AT(struct hawser_nnm, lost)},
	{"interrupted", NULL, "whether curves are incomplete",
	 HAWSER__FLAG_AT(struct hawser_nnm, interrupted)},
	{"energy_to", NULL, "the largest energy", HAWSER__AT(struct hawser_nnm, energy), .unit = HAWSER__J},
	HAWSER__END,
};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_nnm_result, model, cli_si_field)},
	{"mode", NULL, "from 1", HAWSER__AT(struct cli_nnm_result, mode), .flags = HAWSER__FROM_1},
	{"periods", NULL, "of the longest motions looked for", HAWSER__AT(struct cli_nnm_result, periods)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_nnm_result, nnm, nnm_field)},
	HAWSER__END,
};

const struct cli_listing cli_nnm_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* --- showing --- */

static struct cli_head head(const void *of)
{
	const struct cli_nnm_result *result = of;

	return cli_model_head(result->common, "nnm",
	                      "shooting over half a period, pseudo-arclength continuation", result->model,
	                      0u);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_nnm_result *result = of;
	const struct hawser_nnm *nnm = result->nnm;
	struct hawser__scale scale = cli_scale(result->model);
	const char *rad_s = cli_unit(result->model, " rad/s"), *joule = cli_unit(result->model, " J");

	hawser__table_comment(table, "nonlinear normal mode %d, without damping and load, to an energy of "
	                      "%.9g%s", result->mode + 1,
	                      hawser__in_unit(nnm->energy, HAWSER__J, &scale), joule);
	for (int c = 0; c < nnm->curves; c++) {
		const struct hawser_nnm_curve *curve = &nnm->curve[c];
		const struct hawser_backbone *motion = &curve->motion;

		for (int b = 0; b < motion->branches; b++)
			hawser__table_comment(table, "curve %d: branch point at Omega = %.12g%s, energy = %.9g%s%s",
			                      c + 1,
			                      hawser__in_unit(motion->branch[b].omega, HAWSER__RAD_S, &scale),
			                      rad_s, hawser__in_unit(motion->branch[b].energy, HAWSER__J, &scale),
			                      joule, motion->branch[b].turned ? ", where whirling begins" : "");
		if (curve->parent >= 0)
			hawser__table_comment(table, "curve %d: begins at branch point %d of curve %d", c + 1,
			                      curve->born + 1, curve->parent + 1);
		hawser__table_comment(table, "curve %d: %d points, ends at %s%s%s", c + 1, motion->points,
		                      end_of(curve), *curve->message ? ": " : "", curve->message);
	}
	if (nnm->interrupted)
		hawser__table_comment(table, "interrupted: the curves are incomplete");
	if (nnm->lost > 0)
		hawser__table_comment(table, "%d branch points from which no curve could be begun", nnm->lost);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct cli_nnm_result *result = of;
	struct hawser__view view = head(of).view;
	struct curve curve;
	struct row row;

	hawser__fields_columns(table, point_field, &view);
	for (int c = 0; c < result->nnm->curves; c++) {
		curve_row(&curve, result->nnm, (size_t)c);
		for (int i = 0; i < curve.points; i++)
			hawser__fields_row(table, NULL, point_field, point_row(&row, &curve, (size_t)i), &view);
	}
}

/* The parts of a curve that are stable, or not; each goes up to the first point of the other kind. */
static void put_part(struct hawser__figure *figure, const struct hawser_backbone *motion, int unstable,
                     const struct hawser__scale *scale)
{
	for (int i = 0; i < motion->points; i++) {
		const struct hawser_backbone_point *p = &motion->point[i];
		int here = (p->unstable > 0) == unstable;

		if (!(p->energy > 0.0))
			continue;
		if (here || (i > 0 && (p[-1].unstable > 0) == unstable))
			hawser__figure_put(figure, hawser__in_unit(p->energy, HAWSER__J, scale),
			                   hawser__in_unit(p->omega, HAWSER__RAD_S, scale));
		if (!here)
			hawser__figure_gap(figure);
	}
}

static void draw_curves(struct hawser__figure *figure, const struct hawser_nnm *nnm,
                        const struct hawser__scale *scale)
{
	static const char *const style[] = {"with lines lc rgb '#0072B2' lw 1.8",
		"with lines lc rgb '#D55E00' lw 1.3", "with lines lc rgb '#009E73' lw 1.3"};
	static const char dashed[] = "with lines lc rgb '#404040' lw 1.3 dt (6,4)";

	for (int c = 0; c < nnm->curves; c++) {
		int depth = nnm->curve[c].depth < 2 ? nnm->curve[c].depth : 2;

		put_part(figure, &nnm->curve[c].motion, 0, scale);
		hawser__figure_draw(figure, depth ? "branches" : "the mode", "%s", style[depth]);
		put_part(figure, &nnm->curve[c].motion, 1, scale);
		hawser__figure_draw(figure, NULL, "%s dt (6,4)", style[depth]);
	}
	hawser__legend_once(&figure->legend, "unstable", dashed);
	for (int c = 0; c < nnm->curves; c++)
		for (int b = 0; b < nnm->curve[c].motion.branches; b++)
			hawser__figure_put(
				figure, hawser__in_unit(nnm->curve[c].motion.branch[b].energy, HAWSER__J, scale),
				hawser__in_unit(nnm->curve[c].motion.branch[b].omega, HAWSER__RAD_S, scale));
	hawser__figure_draw(figure, "branch points", "with points pt 7 ps 0.5 lc rgb 'black'");
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_nnm_result *result = of;
	struct hawser__scale scale = cli_scale(result->model);
	struct hawser__axis energy = cli_backbone_axis("energy", result->model);
	struct hawser__axis frequency = cli_backbone_axis("Omega", result->model);
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, 11.5, report);

	if (status)
		return status;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.14, 0.965, 0.25, 0.97,
		.x = {&energy, .logarithmic = 1}, .y = {&frequency, .tics = 7, .room = 0.04}});
	draw_curves(&figure, result->nnm, &scale);
	return hawser__figure_finish(&figure, report);
}

const struct cli_showing cli_nnm_showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field, .draw = draw};

/* cli/backbone/cmd_nnm.c - hawser nnm: nonlinear normal modes over energy and frequency.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/nnm.h>

#include "cli/model/axis.h"
#include "cli/backbone/backbone.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/figure.h"

struct settings {
	struct cli_common common;
	const char *from, *to;
	double energy, tolerance, step;
	int n, mode, quadrature, branches, periods, points;
};
static const struct settings defaults = {.mode = 1, .from = NULL};

static const struct cli_option options[] = {
	{"mode", 0, "J", "the mode at which the motions begin (1)", CLI_INTEGER(mode)},
	CLI_RANGE_OPTIONS("end of the range of frequencies (a quarter of the mode's)",
	                  "the other end (four times the mode's)"),
	{"energy-to", 0, "ENERGY", "largest energy in J (see the manual page)", CLI_POSITIVE(energy)},
	{"branches", 0, "DEPTH", "follow what begins at branch points, to this depth",
	 CLI_INTEGER(branches)},
	CLI_MODES_OPTION,
	CLI_HEADING("Further motions"),
	{"quadrature", 0, "K", "whirl: begin in mode K too, of the same frequency",
	 CLI_INTEGER(quadrature)},
	{"periods", 0, "K", "look for motions of up to K periods (1)", CLI_INTEGER(periods)},
	CLI_HEADING("Steps"),
	CLI_TOLERANCE_OPTION("defect and truncation error, relative to the orbit (1e-9)"),
	{"step", 0, "NUMBER", "longest step, relative to the motion (0.05)", CLI_POSITIVE(step)},
	CLI_POINTS_OPTION("end a curve after this many points (1000)"),
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Free periodic motions of the model without damping and load, from a linear mode to large",
	"energies, with the branches at internal resonances. Frequency over energy: --plot.",
	NULL,
};

/* In SI if the model has units. */
struct result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_nnm *nnm;
	int mode, depth, periods; /* index of the mode */
};

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
	{"", NULL, "", HAWSER__THROUGH(struct result, model, cli_si_field)},
	{"mode", NULL, "from 1", HAWSER__AT(struct result, mode), .flags = HAWSER__FROM_1},
	{"periods", NULL, "of the longest motions looked for", HAWSER__AT(struct result, periods)},
	{"", NULL, "", HAWSER__THROUGH(struct result, nnm, nnm_field)},
	HAWSER__END,
};

static const struct cli_listing listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* --- showing --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_model_head(result->common, "nnm",
	                      "shooting over half a period, pseudo-arclength continuation", result->model,
	                      0u);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
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
	const struct result *result = of;
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
	const struct result *result = of;
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

static const struct cli_showing showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field, .draw = draw};

/* --- the command --- */

static enum hawser_status trace(struct hawser_nnm *nnm, const struct settings *settings,
                                struct cli_model *model, struct hawser_report *report)
{
	struct cli_watch watch = {.progress = {.quiet = settings->common.quiet}};
	struct hawser__scale scale = cli_scale(model);
	struct hawser_nnm_options choice = {.mode = settings->mode - 1, .depth = settings->branches,
		.quadrature = settings->quadrature, .periods = settings->periods,
		.max_points = settings->points};
	enum hawser_status status = HAWSER_OK;

	if (settings->mode > model->rom.n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "nnm",
		                    "--mode %d: the model has modes 1 to %d", settings->mode, model->rom.n);
	if (settings->from || settings->to) {
		double w = model->rom.n > 0 ? sqrt(model->rom.K[(size_t)(settings->mode - 1)*
		                                                ((size_t)model->rom.n + 1)]) : 0.0;

		choice.lo = 0.25*w;
		choice.hi = 4.0*w;
		if (settings->from)
			status = cli_map_frequency(&choice.lo, settings->from, "from", model, report);
		if (!status && settings->to)
			status = cli_map_frequency(&choice.hi, settings->to, "to", model, report);
		if (status)
			return status;
		choice.lo /= settings->from ? cli_per_omega(model) : 1.0;
		choice.hi /= settings->to ? cli_per_omega(model) : 1.0;
		if (choice.lo > choice.hi) {
			double swap = choice.lo;

			choice.lo = choice.hi;
			choice.hi = swap;
		}
	}
	if (settings->energy > 0.0)
		choice.energy = settings->energy/hawser__in_unit(1.0, HAWSER__J, &scale);
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->step > 0.0)
		choice.step_max = settings->step;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_nnm_trace(nnm, &model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct hawser_nnm nnm = {0};
	struct cli_model model = {0};
	struct result result = {.common = &settings->common, .model = &model, .nnm = &nnm,
		.mode = settings->mode - 1, .depth = settings->branches,
		.periods = settings->periods > 0 ? settings->periods : 1};
	enum hawser_status status = cli_outputs_check_scales(&settings->common, "x", report);
	double *reached = NULL;

	if (!status)
		status = cli_model_load_modal(&model, &settings->common, settings->n, report);
	if (!status)
		status = trace(&nnm, settings, &model, report);
	for (int k = 0; !status && k < nnm.curves; k++)
		reached = cli_range_reach(reached, &model, nnm.curve[k].motion.coordinate,
		                          nnm.curve[k].motion.points, model.rom.n);
	cli_range_warn(&model, reached);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	hawser_nnm_clear(&nnm);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_nnm = {
	"nnm", "SCENE|MODEL", "Nonlinear normal modes over energy", notes, options,
	&defaults, sizeof(struct settings), 1, run, listing,
	.takes = CLI_MODELS,
};

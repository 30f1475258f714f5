/* cli/curves/frf_fields.c - the fields of a frequency response: its points, sweeps, events, and
 * the rest. A new column is a row of a table here. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/backbone/backbone.h"
#include "cli/curves/frf_lift.h"
#include "cli/curves/frf_over.h"
#include "cli/curves/frf_tori.h"
#include "cli/curves/frf_waves.h"
#include "cli/frame/view.h"
#include "cli/model/made.h"
#include "cli/model/certificate.h"
#include "cli/backbone/mms_result.h"

/* Options of a result. */
enum { TENSION = 1, MULTIPLIERS = 2, SWEEPS = 4, BACKBONE = 8, SAMPLE = 16, PEAKS = 32,
	UNDECIDED = 64, BRANCHES = 128, OVER = 256, TORI = 512, CONTACT = 1024, OWN = 2048,
	PLAIN = 4096 };

HAWSER__LABELS(event_name, hawser_event_name, enum hawser_event_kind)
HAWSER__LABELS(end_name, hawser_frf_end_name, enum hawser_frf_end)

HAWSER__OF(multipliers, int, struct cli_model, 4*of->rom.n)
static const struct hawser__vector multiplier_vector = {
	.count = multipliers, .pair = {"log_modulus", "argument"}};

/* --- points of the curve --- */

HAWSER__GIVEN(has_label, struct hawser_frf_point, of->label > 0)

#define OF(member) HAWSER__AT(struct hawser_frf_point, member)
#define TENSION_OF(which) HAWSER__ALONG(struct hawser_frf, tension), .stride = 2, .item = (which), \
	.unit = HAWSER__NEWTON, .when = TENSION
static const struct hawser__field point_field[] = {
	{"parameter", "parameter", "value of the key of --over, in SI", OF(parameter), .when = OVER},
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S,
	 .axis = "Forcing frequency {/:Italic Ω}"},
	{"stable", "stable", "whether the motion is stable",
	 HAWSER__NOT_AT(struct hawser_frf_point, unstable)},
	{"unstable", "unstable", "multipliers outside the unit circle by more than their error",
	 OF(unstable)},
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct hawser_frf, probe),
	{NULL, "T_min", "least tension over a period", TENSION_OF(0)},
	{NULL, "T_max", "greatest tension over a period", TENSION_OF(1)},
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct hawser_frf, coordinate),
	{"swing", "A_", "half of the largest less the smallest u_j over a period, without an excitation",
	 HAWSER__VECTOR_ALONG(struct hawser_frf, swing, cli_coordinates), .unit = HAWSER__M, .when = OWN},
	{"tension.min", NULL, "least tension over a period", TENSION_OF(0)},
	{"tension.max", NULL, "greatest tension over a period", TENSION_OF(1)},
	{"contact.least", "contact", "smallest angle of contact of a sheave over a period, relative to "
	 "that at rest; below 0 the rope leaves it", OF(contact), .when = CONTACT},
	{"contact.sheave", "sheave", "on which, from 0 in the list sheaves", OF(sheave), .when = CONTACT},
	{"certificate.residual", "residual", "defect of the orbit, relative", OF(residual)},
	{"certificate.mesh", "mesh", "truncation error of the orbit, relative", OF(mesh)},
	{"certificate.error", "error", "estimated error of the orbit, relative", OF(error)},
	{"certificate.liouville", "liouville", "gap in Liouville's formula for the multipliers",
	 OF(liouville)},
	{"undecided", "undecided", "multipliers on the unit circle within their error", OF(undecided),
	 .when = UNDECIDED},
	{NULL, "branch", "number of the branch, from 1", HAWSER__IN(struct hawser_frf, branch),
	 .when = BRANCHES},
	{NULL, "sweep", "0 on the curve, 1 on the up-sweep, -1 on the down-sweep",
	 HAWSER__CONSTANT_IS(0), .when = SWEEPS},
	{NULL, "tori", "0, or the number of a curve of tori", HAWSER__CONSTANT_IS(0), .when = TORI},
	{NULL, "extreme", "of tori: 1 with the greatest amplitudes, -1 with the least",
	 HAWSER__CONSTANT_IS(0), .when = TORI},
	{NULL, "backbone", "of rows of a backbone: its mode", HAWSER__CONSTANT_IS(HAWSER__NO_INTEGER),
	 .when = BACKBONE},
	{NULL, "energy", "of rows of a backbone: its energy", HAWSER__CONSTANT_IS(HAWSER__NO_INTEGER),
	 .unit = HAWSER__J, .when = BACKBONE},
	{"trivial", "trivial", "of a limit cycle: distance of the multiplier that is 1 from 1",
	 HAWSER__ALONG(struct hawser_frf, trivial), .when = OWN},
	{"truncation", NULL, "the same as mesh", OF(mesh)},
	{"arc", NULL, "arclength along the curve, in the metric of the continuation", OF(arc)},
	{"iterations", NULL, "of the corrector", OF(iterations)},
	{"steps", NULL, "Runge-Kutta steps a period, or coefficients a coordinate", OF(steps)},
	CLI_STATE(HAWSER__VECTOR_ALONG, struct hawser_frf, state),
	{"label", NULL, "number of this point, by which a run can begin here", OF(label),
	 .given = has_label},
	{"multipliers", NULL, "Floquet multipliers: logarithm of the modulus, argument",
	 HAWSER__VECTOR_ALONG(struct hawser_frf, multiplier, multiplier_vector), .when = MULTIPLIERS},
	HAWSER__END,
};
#undef OF
static const struct hawser__list point_list =
	HAWSER__STORED_ROWS(struct hawser_frf, point, points, point_field);

/* --- sweeps --- */

#define ALONG(member) HAWSER__ALONG(struct cli_sweep, run.member)
static const struct hawser__field settled_field[] = {
	{"Omega", "Omega", "forcing frequency", ALONG(omega), .unit = HAWSER__RAD_S},
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct cli_sweep, run.probe),
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct cli_sweep, run.coordinate),
	{"residual", "residual", "how far the motion is from periodic, relative", ALONG(residual)},
	{NULL, "sweep", "1 up, -1 down", HAWSER__IN(struct cli_sweep, direction)},
	HAWSER__END,
};
#undef ALONG
static const struct hawser__list settled_list = {
	.field = settled_field, .count_at = offsetof(struct cli_sweep, run.points)};

static const char *direction_name(int direction)
{
	return direction > 0 ? "up" : "down";
}

static const struct hawser__field sweep_field[] = {
	{"direction", NULL, "of Omega: up or down",
	 HAWSER__LABEL_AT(struct cli_sweep, direction, direction_name)},
	{"interrupted", NULL, "whether the sweep is incomplete",
	 HAWSER__FLAG_AT(struct cli_sweep, run.interrupted)},
	{"points", NULL, "settled motions", HAWSER__OBJECTS_OF(settled_list)},
	HAWSER__END,
};

/* --- events, sample, cost --- */

HAWSER__GIVEN(over_omega, struct hawser_frf_event, of->parameter == of->omega)

static int over_parameter(const void *row, const void *parent)
{
	return !over_omega(row, parent);
}

HAWSER__GIVEN(is_hopf, struct hawser_frf_event, of->kind == HAWSER_HOPF)

static int has_state(const void *row, const void *parent)
{
	const struct hawser_frf *frf = parent;
	size_t at = (size_t)((const struct hawser_frf_event *)row - frf->event);

	return frf->event_state && isfinite(frf->event_state[2*(size_t)frf->n*at]);
}

#define OF(member) HAWSER__AT(struct hawser_frf_event, member)
static const struct hawser__field event_field[] = {
	{"kind", NULL, "fold, period-doubling, torus, branch-point, hopf or unexplained",
	 HAWSER__LABEL_AT(struct hawser_frf_event, kind, event_name)},
	{"Omega", NULL, "where it is", OF(omega), .unit = HAWSER__RAD_S},
	{"parameter", NULL, "the same with --over", OF(parameter), .when = OVER},
	{"residual", NULL, "of its test function, relative", OF(residual)},
	{"error", NULL, "estimated relative error of Omega, or of the parameter", OF(error)},
	{"suspected", NULL, "whether the count of unstable multipliers does not confirm it",
	 HAWSER__FLAG_AT(struct hawser_frf_event, suspected)},
	{"located", NULL, "false where it is unexplained or its error exceeds 0.01",
	 HAWSER__FLAG_AT(struct hawser_frf_event, located)},
	{"after", NULL, "index of the point before it", OF(after)},
	{"bracket", NULL, "Omega of the two orbits between which it lies", OF(bracket),
	 .unit = HAWSER__RAD_S, .given = over_omega},
	{"bracket", NULL, "the parameter of these orbits, with --over", OF(bracket),
	 .given = over_parameter},
	{"unstable_before", NULL, "unstable multipliers at the first of them", OF(unstable[0])},
	{"unstable_after", NULL, "unstable multipliers at the second", OF(unstable[1])},
	{"label", NULL, "number of this event, by which a run can begin here", OF(label)},
	{"l1", NULL, "of a Hopf point: first Lyapunov coefficient", OF(hopf.l1), .given = is_hopf,
	 .flags = HAWSER__NULL},
	{"growth_slope", NULL, "of its growth rate, scaled", OF(hopf.growth), .given = is_hopf},
	{"coordinate", NULL, "that moves most in its cycles, from 1", OF(hopf.coordinate),
	 .flags = HAWSER__FROM_1, .given = is_hopf},
	{"swing_slope", NULL, "of the square of its amplitude, scaled", OF(hopf.swing),
	 .given = is_hopf, .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"state", NULL, "u and u' of its motion at the start of a period, if it has one",
	 HAWSER__VECTOR_ALONG(struct hawser_frf, event_state, cli_states), .unit = HAWSER__M,
	 .given = has_state},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct hawser_frf, member)
static const struct hawser__field sample_field[] = {
	{"points", NULL, "points computed again by another method", OF(sampled)},
	{"gap", NULL, "how far off they are, relative; null: not all were found again", OF(sample_gap),
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"disagreements", NULL, "points with another stability", OF(sample_disagreements)},
	HAWSER__END,
};

static const struct hawser__field cost_field[] = {
	{"points", NULL, "points of the curve", OF(points)},
	{"maps", NULL, "period maps without variational equations", OF(cost.maps)},
	{"flows", NULL, "period maps with them", OF(cost.flows)},
	{"stages", NULL, "Runge-Kutta stages", OF(cost.stages)},
	{"solves", NULL, "bordered linear solves", OF(cost.solves)},
	HAWSER__END,
};

/* --- the whole result --- */

static const struct hawser__field curve_field[] = {
	{"points", NULL, "points of the curve", HAWSER__OBJECTS_OF(point_list),
	 .flags = HAWSER__STREAM},
	{"events", NULL, "bifurcations, in order along the curve",
	 HAWSER__STORED(struct hawser_frf, event, events, event_field)},
	HAWSER__END,
};
static const struct hawser__field end_field[] = {
	{"method", NULL, "for periodic orbits", OF(method)},
	{"sample", NULL, "a check by another method", HAWSER__OBJECT_OF(sample_field), .when = SAMPLE},
	{"end", NULL, "why the curve ends", HAWSER__LABEL_AT(struct hawser_frf, end, end_name)},
	HAWSER__END,
};
#undef OF

static void parameters_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct hawser_rom_source *source = &((const struct cli_frf_result *)row)->model->source;
	json_t *object = source->parameters > 0 ? hawser__json_object(json, into, "parameters") : NULL;

	for (int i = 0; object && i < source->parameters; i++)
		hawser__json_number(json, object, source->parameter[i].name, source->parameter[i].value);
}

HAWSER__GIVEN(has_direction, struct cli_frf_result, of->direction != 0)

#define OF(member) HAWSER__AT(struct cli_over, member)
static const struct hawser__field over_field[] = {
	{"key", NULL, "the parameter", OF(axis.key)},
	{"unit", NULL, "its unit, or \"\"", OF(axis.unit)},
	{"from", NULL, "where the curve begins", OF(from)},
	{"to", NULL, "the other end of the range", OF(to)},
	HAWSER__END,
};
#undef OF

#define THROUGH(member, fields) {"", NULL, "", HAWSER__THROUGH(struct cli_frf_result, member, fields)}
/* A branch that begins at an event of another one. */
static const struct hawser__field born_field[] = {
	{"period", NULL, "periods of the load in one of the motion", HAWSER__AT(struct hawser_frf, period)},
	{"parent", NULL, "number of the branch at an event of which this one begins",
	 HAWSER__AT(struct hawser_frf, parent)},
	{"born", NULL, "Omega of that event", HAWSER__AT(struct hawser_frf, born),
	 .unit = HAWSER__RAD_S},
	{"born_at", NULL, "parameter of that event, with --over", HAWSER__AT(struct hawser_frf, born_at),
	 .when = OVER},
	HAWSER__END,
};

static int is_born(const void *row, const void *parent)
{
	(void)parent;
	return ((const struct cli_frf_result *)row)->frf->parent > 0;
}

static const struct hawser__field period_field[] = {
	{"period", NULL, "periods of the load in one of the motion, if more than 1",
	 HAWSER__AT(struct hawser_frf, period)},
	HAWSER__END,
};

HAWSER__GIVEN(is_slower, struct cli_frf_result, of->frf->period > 1)

/* A further branch is a result with its own curve. */
static const struct hawser__field branch_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_frf_result, frf, born_field), .given = is_born},
	{"", NULL, "", HAWSER__PART_OF(struct cli_frf_result, error, cli_fixed_field)},
	THROUGH(frf, curve_field),
	{"peaks", NULL, "see PEAKS", HAWSER__OBJECTS_OF(cli_frf_peak_list), .when = PEAKS},
	THROUGH(frf, end_field),
	HAWSER__END,
};

static const void *gap_row(void *to, const void *parent, size_t k)
{
	return memcpy(to, ((const struct cli_frf_result *)parent)->gap + 2*k, 2*sizeof(double));
}
struct gap {
	double from, to;
};
static const struct hawser__field gap_field[] = {
	{"from", NULL, "Omega", HAWSER__AT(struct gap, from), .unit = HAWSER__RAD_S},
	{"to", NULL, "Omega", HAWSER__AT(struct gap, to), .unit = HAWSER__RAD_S},
	HAWSER__END,
};
static const struct hawser__list gap_list =
	HAWSER__MADE_ROWS(struct gap, gap_field, struct cli_frf_result, gaps, gap_row);

static const struct hawser__field stats_field[] = {
	THROUGH(frf, cost_field),
	HAWSER__END,
};

static int is_certified(const void *row, const void *parent)
{
	const struct cli_certificate *certificate = ((const struct cli_frf_result *)row)->certificate;

	(void)parent;
	return certificate && certificate->own.count > 0;
}

static const struct hawser__field result_field[] = {
	THROUGH(scales, cli_modulation_field),
	THROUGH(model, cli_si_field),
	{"parameters", NULL, "of a model file or library that names some", HAWSER__CALLS(parameters_json)},
	{"made", NULL, "options by which the model is made again: set, of nets and ropeways keep and more",
	 HAWSER__CALLS(cli_made_json)},
	{"over", NULL, "with --over", HAWSER__THROUGH(struct cli_frf_result, over, over_field)},
	{"range", NULL, "of Omega", HAWSER__PAIR_AT(struct cli_frf_result, from, to),
	 .unit = HAWSER__RAD_S},
	{"", NULL, "", HAWSER__THROUGH(struct cli_frf_result, frf, period_field), .given = is_slower},
	THROUGH(model, cli_naturals_field),
	THROUGH(model, cli_choice_field),
	{"", NULL, "", HAWSER__PART_OF(struct cli_frf_result, error, cli_fixed_field)},
	{"certified", NULL, "of nets and spans: folds and peaks corrected in the mesh",
	 HAWSER__THROUGH(struct cli_frf_result, certificate, cli_certificate_field),
	 .given = is_certified},
	THROUGH(frf, curve_field),
	{"sheaves", NULL, "of ropeways: names of the sheaves of contact.sheave",
	 HAWSER__CALLS(cli_frf_sheaves_json), .when = CONTACT},
	{"lift", NULL, "of ropeways: where the curve first takes the rope off a sheave, interpolated",
	 HAWSER__CALLS(cli_frf_lift_json), .when = CONTACT},
	{"peaks", NULL, "see PEAKS", HAWSER__OBJECTS_OF(cli_frf_peak_list), .when = PEAKS},
	{"branches", NULL, "further branches, where the first does not cover the range",
	 HAWSER__STORED(struct cli_frf_result, other, others, branch_field), .when = BRANCHES},
	{"gaps", NULL, "parts of the range in which no branch was found",
	 HAWSER__OBJECTS_OF(gap_list), .when = BRANCHES},
	THROUGH(model, cli_basis_field),
	{"tori", NULL, "curves of quasi-periodic motions, with --tori",
	 HAWSER__STORED(struct cli_frf_result, tori, curves, cli_tori_field), .when = TORI},
	{"sweeps", NULL, "sweeps by settled time integration",
	 HAWSER__STORED(struct cli_frf_result, sweep, sweeps, sweep_field), .when = SWEEPS},
	{"backbone", NULL, "free motions of a mode",
	 HAWSER__THROUGH(struct cli_frf_result, backbone, cli_backbone_field)},
	THROUGH(frf, end_field),
	{"direction", NULL, "in which Omega changed at the last point: 1 or -1",
	 HAWSER__AT(struct cli_frf_result, direction), .given = has_direction},
	HAWSER__END,
};

const struct cli_listing cli_frf_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Columns of the table with --peaks:", cli_frf_peak_column, 0},
	{"Keys of JSON:", result_field, 1},
	{"Columns of a net in waves:", cli_waves_field, 0},
	{"Keys of JSON of a net in waves:", cli_waves_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_frf_result *result = of;
	const struct hawser_frf *frf = result->frf;
	struct cli_head head = cli_model_head(
		result->common, result->command ? result->command : "frf", frf->method, result->model,
		(frf->tension ? TENSION : 0u) | (result->multipliers ? MULTIPLIERS : 0u) |
		(result->sweeps > 0 ? SWEEPS : 0u) | (result->backbone ? BACKBONE : 0u) |
		(frf->sampled > 0 ? SAMPLE : 0u) | (result->located ? PEAKS : 0u) |
		(frf->undecided > 0 ? UNDECIDED : 0u) |
		(result->others + result->gaps > 0 ? BRANCHES : 0u) | (result->over ? OVER : PLAIN) |
		(frf->swing ? OWN : 0u) |
		(result->tori ? TORI : 0u) | (result->model->rom.contacts.count > 0 ? CONTACT : 0u));

	head.rows = frf;
	head.also = ", pseudo-arclength continuation";
	return head;
}

/* The rows after the curve: further branches, sweeps, backbone. */
static void more(struct hawser__table *table, const void *of)
{
	const struct cli_frf_result *result = of;
	struct hawser__view view = head(of).view;

	for (int k = 0; k < result->others; k++)
		hawser__fields_rows(table, point_field, &point_list, result->other[k].frf, &view);
	for (int k = 0; k < result->sweeps; k++)
		hawser__fields_rows(table, point_field, &settled_list, &result->sweep[k], &view);
	for (int k = 0; k < result->curves; k++) {
		hawser__fields_rows(table, point_field, &cli_torus_most_list, &result->tori[k], &view);
		hawser__fields_rows(table, point_field, &cli_torus_least_list, &result->tori[k], &view);
	}
	if (result->backbone)
		hawser__fields_rows(table, point_field, &cli_backbone_free_list, result->backbone, &view);
}

static struct cli_head peaks_head(const void *of)
{
	struct cli_head of_peaks = head(of);

	of_peaks.rows = of;
	return of_peaks;
}

static void more_peaks(struct hawser__table *table, const void *of)
{
	const struct cli_frf_result *result = of;
	struct hawser__view view = head(of).view;

	for (int k = 0; k < result->others; k++)
		hawser__fields_rows(table, cli_frf_peak_column, &cli_frf_peak_rows, &result->other[k], &view);
}

struct cli_showing cli_frf_show_peaks(const struct cli_frf_result *result)
{
	struct cli_showing showing = cli_frf_showing;

	showing.head = peaks_head;
	showing.rows = result->highest > 0 ? &cli_frf_highest_rows : &cli_frf_peak_rows;
	showing.more = result->highest > 0 ? NULL : more_peaks;
	return showing;
}

struct hawser__axis cli_frf_axis(const struct cli_model *model)
{
	const struct hawser__view view = cli_view(model, 0);

	return hawser__fields_axis(point_field, "Omega", &view, 0.0);
}

struct hawser__axis cli_backbone_axis(const char *column, const struct cli_model *model)
{
	const struct hawser__view view = cli_view(model, 0);

	return hawser__fields_axis(cli_backbone_free_field, column, &view, 0.0);
}

const struct cli_showing cli_frf_showing = {
	.head = head, .comments = cli_frf_comments, .rows = &point_list, .more = more,
	.fields = result_field, .stats = stats_field, .draw = cli_frf_draw};

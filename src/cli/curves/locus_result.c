/* cli/curves/locus_result.c - loci of bifurcations as a table and as JSON, in SI if the model
 * has units. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>
#include <stdio.h>

#include "cli/model/exact.h"
#include "cli/curves/locus_result.h"
#include "cli/frame/view.h"

/* --- comments --- */

static const char *first_name(const struct cli_locus_result *result)
{
	return result->first ? result->first : "Omega";
}
static const char *first_unit(const struct cli_locus_result *result)
{
	return result->first ? "" : cli_unit(result->model, " rad/s");
}
static double per_first(const struct cli_locus_result *result)
{
	return result->first ? 1.0 : cli_per_omega(result->model);
}

static void comment_curve(struct hawser__table *table, const struct cli_locus_result *result, int c)
{
	const struct hawser_locus *locus = result->locus;
	const struct hawser_locus_curve *curve = &locus->curve[c];

	for (int e = curve->first_event; e < curve->first_event + curve->events; e++) {
		const struct hawser_locus_event *event = &locus->event[e];

		if (event->kind != HAWSER_LOCUS_START)
			hawser__table_comment(table, "curve %d: %s at %s = %.12g%s, %s = %.12g", c + 1,
			                      hawser_locus_special_name(locus->kind, event->kind),
			                      first_name(result), event->omega*per_first(result),
			                      first_unit(result), result->key, event->parameter);
	}
	hawser__table_comment(table, "curve %d: %d points; ends: %s, %s%s%s", c + 1, curve->points,
	                      hawser_locus_end_name(curve->end[0]), hawser_locus_end_name(curve->end[1]),
	                      *curve->message ? ": " : "", curve->message);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_locus_result *result = of;
	const struct hawser_locus *locus = result->locus;
	double per = per_first(result);

	hawser__table_comment(table, "range: %s from %.12g to %.12g%s, %s from %.12g to %.12g%s%s",
	                      first_name(result), result->from*per, result->to*per, first_unit(result),
	                      result->key,
	                      result->parameter_from, result->parameter_to,
	                      *result->unit && *result->unit != '1' ? " " : "",
	                      *result->unit != '1' ? result->unit : "");
	if (locus->response.period > 1)
		hawser__table_comment(table, "motions of %d periods of the load", locus->response.period);
	if (result->first && result->omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g%s", result->omega,
		                      cli_unit(result->model, " rad/s"));
	cli_basis_comment(table, result->model);
	cli_exact_range_comments(table, result->model);
	hawser__table_comment(table, "kind: %s, begun at %s = %.12g", hawser_event_name(locus->kind),
	                      result->key, locus->at);
	for (int c = 0; c < locus->curves; c++)
		comment_curve(table, result, c);
	for (int i = 0; i < locus->lost; i++)
		hawser__table_comment(table, "not followed: the %s at %s = %.12g%s",
		                      hawser_event_name(locus->kind), first_name(result),
		                      locus->lost_at[i]*per, first_unit(result));
	if (locus->interrupted)
		hawser__table_comment(table, "interrupted: the curves are incomplete");
	if (locus->costly)
		hawser__table_comment(table, "costly: the search ended at its limit of work, "
		                      "and more curves may exist: --max-points N lifts the limit");
	hawser__table_comment(table, "%d curve%s, %d points", locus->curves, locus->curves == 1 ? "" : "s",
	                      locus->points);
}

/* --- fields --- */

/* the first parameter is Omega, or another one; of bifurcations, or of resonances */
/* OWN: of an autonomous model; SLOWER: of motions of several periods of the load */
enum { LINE = 1, PLANE = 2, BIFURCATION = 4, RESONANCE = 8, OWN = 16, SLOWER = 32 };

HAWSER__LABELS(kind_name, hawser_event_name, enum hawser_event_kind)

struct row {
	int curve; /* index */
	const char *kind;
	struct hawser_locus_point point;
	struct hawser_locus_event event;
	const double *coordinate, *state;
};

#define OF(member) HAWSER__AT(struct row, point.member)
static const struct hawser__field point_field[] = {
	{NULL, "curve", "from 1", HAWSER__AT(struct row, curve), .flags = HAWSER__FROM_1},
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S, .when = LINE},
	{"first", "first", "the parameter of --and, in SI units", OF(omega), .when = PLANE},
	{"parameter", "parameter", "the other parameter, in SI units", OF(parameter)},
	{NULL, "kind", "of the locus, or of a special point", HAWSER__AT(struct row, kind)},
	{"angle", "angle", "argument of the critical multipliers, 0 to pi", OF(angle), .when = BIFURCATION},
	{"frequency", "frequency", "of the limit cycle, or of the pair of a Hopf point; 0: an equilibrium",
	 OF(own), .unit = HAWSER__RAD_S, .when = OWN},
	{"l1", "l1", "first Lyapunov coefficient of a Hopf point", OF(l1), .flags = HAWSER__NULL,
	 .when = OWN},
	{"unstable", "unstable", "multipliers outside the unit circle besides critical ones",
	 OF(unstable)},
	{"amplitude", "amplitude", "of the harmonic of a resonance, along the load", OF(amplitude),
	 .unit = HAWSER__M, .when = RESONANCE},
	{"phase", "phase", "by which it lags the load", OF(phase), .unit = HAWSER__RADIAN,
	 .when = RESONANCE},
	{"energy", "energy", "mean over the period", OF(energy), .unit = HAWSER__J, .when = RESONANCE},
	{"work", "work", "of the load in a period", OF(work), .unit = HAWSER__J, .when = RESONANCE},
	{"damping_ratio", "damping_ratio", "work/(4 pi energy)", OF(damping), .when = RESONANCE},
	CLI_COORDINATES(HAWSER__VECTOR_AT, struct row, coordinate),
	{"residual", "residual", "defect of all equations, relative", OF(residual)},
	{"truncation", "truncation", "estimated error of the truncated series, relative", OF(mesh)},
	{"harmonics", "harmonics", "number of harmonics in use", OF(harmonics)},
	{"iterations", NULL, "of the corrector", OF(iterations)},
	{"arc", NULL, "arclength along the curve, in the metric of the continuation", OF(arc)},
	CLI_STATE(HAWSER__VECTOR_AT, struct row, state),
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct row, event.member)
static const struct hawser__field event_field[] = {
	{NULL, "curve", "from 1", HAWSER__AT(struct row, curve), .flags = HAWSER__FROM_1},
	{"kind", "kind", "what it is", HAWSER__AT(struct row, kind)},
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S, .when = LINE},
	{"first", "first", "the parameter of --and", OF(omega), .when = PLANE},
	{"parameter", "parameter", "the other parameter", OF(parameter)},
	{"angle", "angle", "argument of the critical multipliers", OF(angle), .when = BIFURCATION},
	{"frequency", "frequency", "of the cycle or of the pair", OF(own), .unit = HAWSER__RAD_S,
	 .when = OWN},
	{"error", NULL, "estimated error of both parameters, relative to their ranges", OF(error)},
	{"after", NULL, "index of the point before it", OF(after)},
	HAWSER__END,
};
#undef OF

/* A curve: a range of the points and events of all curves. */
struct curve {
	const struct hawser_locus *locus;
	const struct hawser_locus_curve *own;
	const char *message;
	int number, points, events;
};

static const void *point_row(void *to, const void *parent, size_t index)
{
	const struct curve *curve = parent;
	const struct hawser_locus *locus = curve->locus;
	size_t i = (size_t)curve->own->first + index, n = (size_t)locus->n;

	*(struct row *)to = (struct row){
		.curve = curve->number, .kind = hawser_event_name(locus->kind), .point = locus->point[i],
		.coordinate = locus->coordinate + i*n, .state = locus->state + i*2*n};
	return to;
}

static const void *event_row(void *to, const void *parent, size_t index)
{
	const struct curve *curve = parent;
	struct row *row = to;

	*row = (struct row){.curve = curve->number,
	                    .event = curve->locus->event[(size_t)curve->own->first_event + index]};
	row->kind = hawser_locus_special_name(curve->locus->kind, row->event.kind);
	row->event.after -= curve->own->first;
	return row;
}
static const struct hawser__list
	point_list = HAWSER__MADE_ROWS(struct row, point_field, struct curve, points, point_row),
	event_list = HAWSER__MADE_ROWS(struct row, event_field, struct curve, events, event_row);

HAWSER__LABELS(curve_end_name, hawser_locus_end_name, enum hawser_locus_end)
static const struct hawser__field ends_field[] = {
	{"ends", NULL, "why it ends, at both ends",
	 HAWSER__WORDS_AT(struct hawser_locus_curve, end, curve_end_name)},
	HAWSER__END,
};
static const struct hawser__field curve_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct curve, own, ends_field)},
	{"message", NULL, "why it failed", HAWSER__AT(struct curve, message), .flags = HAWSER__OMIT},
	{"events", NULL, "special points, in order along it", HAWSER__OBJECTS_OF(event_list)},
	{"points", NULL, "bifurcations, in order along it", HAWSER__OBJECTS_OF(point_list)},
	HAWSER__END,
};

static const void *curve_row(void *to, const void *parent, size_t c)
{
	const struct hawser_locus *locus = parent;
	const struct hawser_locus_curve *own = &locus->curve[c];

	*(struct curve *)to = (struct curve){
		.locus = locus, .own = own, .number = (int)c, .points = own->points,
		.events = own->events, .message = *own->message ? own->message : NULL};
	return to;
}
static const struct hawser__list
	curve_list = HAWSER__MADE_ROWS(struct curve, curve_field, struct hawser_locus, curves, curve_row);

static const struct hawser__field locus_field[] = {
	{"kind", NULL, "of the bifurcations", HAWSER__LABEL_AT(struct hawser_locus, kind, kind_name)},
	{"harmonic", NULL, "of the load, of resonances", HAWSER__AT(struct hawser_locus, harmonic),
	 .when = RESONANCE},
	{"period", NULL, "periods of the load in one of the motion, if more than 1",
	 HAWSER__AT(struct hawser_locus, response.period), .when = SLOWER},
	{"at", NULL, "the parameter at which the curves begin", HAWSER__AT(struct hawser_locus, at)},
	{"curves", NULL, "loci", HAWSER__OBJECTS_OF(curve_list)},
	{"not_followed", NULL, "number of bifurcations from which no curve could be begun",
	 HAWSER__AT(struct hawser_locus, lost)},
	{"interrupted", NULL, "whether curves are incomplete",
	 HAWSER__FLAG_AT(struct hawser_locus, interrupted)},
	{"costly", NULL, "whether the search ended at its limit of work",
	 HAWSER__FLAG_AT(struct hawser_locus, costly)},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"points", NULL, "points of all curves", HAWSER__AT(struct hawser_locus, points)},
	{"solves", NULL, "linear systems factorised", HAWSER__AT(struct hawser_locus, solves)},
	HAWSER__END,
};

static const struct hawser__field stats_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_locus_result, locus, cost_field)},
	HAWSER__END,
};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_locus_result, model, cli_exact_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_locus_result, model, cli_si_field)},
	{"range", NULL, "of Omega", HAWSER__PAIR_AT(struct cli_locus_result, from, to),
	 .unit = HAWSER__RAD_S, .when = LINE},
	{"Omega", NULL, "forcing frequency, of --Omega", HAWSER__AT(struct cli_locus_result, omega),
	 .when = PLANE},
	{"first", NULL, "the parameter of --and", HAWSER__AT(struct cli_locus_result, first),
	 .when = PLANE},
	{"first_range", NULL, "its range", HAWSER__PAIR_AT(struct cli_locus_result, from, to),
	 .when = PLANE},
	{"key", NULL, "the other parameter", HAWSER__AT(struct cli_locus_result, key)},
	{"parameter_range", NULL, "its range",
	 HAWSER__PAIR_AT(struct cli_locus_result, parameter_from, parameter_to)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_locus_result, locus, locus_field)},
	HAWSER__END,
};

const struct cli_listing cli_locus_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_locus_result *result = of;
	int resonance = result->locus->kind == HAWSER_RESONANCE;

	if (result->first && result->omega == 0.0)
		return cli_model_head(result->common, "locus", "bifurcations of autonomous models on lines "
		                      "across the curve", result->model, PLANE | BIFURCATION | OWN);
	return cli_model_head(result->common, "locus", resonance
	                      ? "harmonic balance, phase quadrature, pseudo-arclength continuation"
	                      : "harmonic balance, minimally augmented bifurcation, pseudo-arclength "
	                        "continuation", result->model,
	                      (result->first ? PLANE : LINE) | (resonance ? RESONANCE : BIFURCATION) |
	                      (result->locus->response.period > 1 ? SLOWER : 0));
}

static void rows(struct hawser__table *table, const void *of)
{
	static const struct hawser__curve_lists lists = {&curve_list, &point_list, &event_list,
	                                                 offsetof(struct row, event.after)};
	const struct cli_locus_result *result = of;
	struct hawser__view view = head(of).view;

	hawser__fields_curves(table, &lists, result->locus, &view);
}

const struct cli_showing cli_locus_showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field, .stats = stats_field,
	.draw = cli_locus_draw};

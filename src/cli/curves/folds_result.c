/* cli/curves/folds_result.c - fold curves as a table and as JSON, in SI if the model has units.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>
#include <stdio.h>

#include "cli/model/exact.h"
#include "cli/curves/folds_result.h"
#include "cli/frame/view.h"

/* --- table --- */

/* ", load.per_length 0.61, 0.61, 0.61 N/m" for a scene's load at this factor, else "". */
static void load_text(char *text, size_t size, const struct cli_folds_result *result,
                      double factor)
{
	const struct hawser_scene *scene = &result->model->scene;
	const double *f = scene->load.per_length;

	text[0] = '\0';
	if (result->model->has_scene && scene->load.present && scene->loads == 0)
		snprintf(text, size, " (%.6g, %.6g, %.6g N/m)", factor*f[0], factor*f[1], factor*f[2]);
}

static const char *meaning(const struct hawser_folds_event *event)
{
	switch (event->kind) {
	case HAWSER_FOLDS_CUSP:
		return event->minimum > 0 ? "two folds appear as the load grows: jumps begin"
		                          : "two folds vanish as the load grows";
	case HAWSER_FOLDS_ISOLA:
		return event->minimum > 0 ? "a closed response curve appears as the load grows"
		                          : "a closed response curve vanishes as the load grows";
	case HAWSER_FOLDS_BIFURCATION:
		return event->minimum > 0 ? "two response curves part as the load grows"
		                          : "two response curves join as the load grows";
	default:
		return "";
	}
}

static void comment_event(struct hawser__table *table, const struct cli_folds_result *result, int c,
                          int e)
{
	const struct hawser_folds_event *event = &result->folds->event[e];
	char load[96];

	if (event->kind == HAWSER_FOLDS_NOMINAL)
		return;
	load_text(load, sizeof load, result, event->load);
	hawser__table_comment(table, "curve %d: %s at Omega = %.12g%s, load factor %.12g%s: %s", c + 1,
	                      hawser_folds_kind_name(event->kind),
	                      event->omega*cli_per_omega(result->model), cli_unit(result->model, " rad/s"),
	                      event->load, load, meaning(event));
}

static void comment_curve(struct hawser__table *table, const struct cli_folds_result *result, int c)
{
	const struct hawser_folds_curve *curve = &result->folds->curve[c];
	char load[96];
	int e;

	for (e = curve->first_event; e < curve->first_event + curve->events; e++)
		comment_event(table, result, c, e);
	load_text(load, sizeof load, result, curve->least_load);
	hawser__table_comment(table, "curve %d: folds from load factor %.12g%s upward (%s); ends: %s, "
	                      "%s%s%s", c + 1, curve->least_load, load,
	                      curve->least_event >= 0
	                      ? hawser_folds_kind_name(result->folds->event[curve->least_event].kind)
	                      : "the end of the curve", hawser_folds_end_name(curve->end[0]),
	                      hawser_folds_end_name(curve->end[1]), *curve->message ? ": " : "",
	                      curve->message);
}

/* The least load with a fold, its kind, and the searches that confirm it. */
static void comment_least(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	double per_omega = cli_per_omega(result->model);
	const char *rad_s = cli_unit(result->model, " rad/s");
	char load[96];

	if (folds->curves == 0)
		return;
	load_text(load, sizeof load, result, folds->least_load);
	if (folds->interrupted)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, by the curves so far",
		                      folds->least_load, load);
	else if (folds->least_kind == HAWSER_FOLDS_LEAST_BOUND)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, at Omega = %.12g%s: a "
		                      "bound, for the search at lower loads is incomplete",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s);
	else if (folds->least_kind == HAWSER_FOLDS_LEAST_LOAD)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, the smallest one asked "
		                      "for, at Omega = %.12g%s: lower --load-from to see where they begin",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s);
	else
		hawser__table_comment(table, "jumps begin at load factor %.12g%s, at Omega = %.12g%s (%s)",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s,
		                      hawser_folds_least_name(folds->least_kind));
	for (int i = 0; i < folds->levels; i++)
		hawser__table_comment(table, "searched: load factor %.6g, Omega from %.6g to %.6g%s, from "
		                      "both ends: %d folds", folds->level[i].load,
		                      folds->level[i].from*per_omega, folds->level[i].to*per_omega, rad_s,
		                      folds->level[i].folds);
	if (folds->nearly_linear)
		hawser__table_comment(table, "searched: the last of these responses is nearly linear");
}

static void comment_lost(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;

	for (int i = 0; i < folds->lost; i++)
		hawser__table_comment(table, "not followed: the fold at Omega = %.12g%s, load factor %.6g: "
		                      "no curve could be begun there; where no other one passes it, change "
		                      "%s a little",
		                      folds->lost_at[i].omega*cli_per_omega(result->model),
		                      cli_unit(result->model, " rad/s"), folds->lost_at[i].load,
		                      folds->lost_at[i].load == 1.0 ? "--tolerance" : "--load-to");
}

/* What was done to find detached curves that no fold curve shows. */
static void comment_starts(struct hawser__table *table, const struct hawser_folds *folds)
{
	const struct hawser_folds_starts *starts = &folds->starts;

	if (starts->starts == 0)
		hawser__table_comment(table, "isolas: not looked for by pseudo-random motions (--starts), only "
		                      "through the folds above");
	else
		hawser__table_comment(table, "isolas: looked for by %d pseudo-random motions at %d frequencies "
		                      "of the range at the model's load: %d on known curves, %d on no orbit, "
		                      "%d curves found%s; others may exist (--starts)", starts->starts,
		                      starts->frequencies, starts->known, starts->lost, starts->fresh,
		                      starts->attached ? ", besides those that begin at branch points" : "");
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_folds_result *result = of;
	const struct hawser_folds *folds = result->folds;
	const struct cli_model *model = result->model;
	double per_omega = cli_per_omega(model);
	const char *rad_s = cli_unit(result->model, " rad/s");
	int c, e, i;

	hawser__table_comment(table, "range: Omega from %.12g to %.12g%s, load factor from %.12g to "
	                      "%.12g", result->from*per_omega, result->to*per_omega, rad_s,
	                      result->load_from, result->load_to);
	cli_choice_comments(table, model);
	cli_basis_comment(table, model);
	cli_exact_range_comments(table, model);
	for (c = 0; c < folds->curves; c++)
		comment_curve(table, result, c);
	if (result->label)
		hawser__table_comment(table, "folds: those of the response through %s only: others were not "
		                      "looked for", result->label);
	else
		comment_least(table, result);
	for (i = 0; i < folds->isolas; i++) {
		const struct hawser_frf *frf = &folds->isola[i];

		hawser__table_comment(table, "detached response curve %d at the model's load: %d points, "
		                      "%s", i + 1, frf->points, hawser_frf_end_name(frf->end));
		for (e = 0; e < frf->events; e++)
			hawser__table_comment(table, "detached response curve %d: %s at Omega = %.12g%s",
			                      i + 1, hawser_event_name(frf->event[e].kind),
			                      frf->event[e].omega*per_omega, rad_s);
	}
	if (!result->label)
		comment_starts(table, folds);
	comment_lost(table, result);
	if (folds->note[0])
		hawser__table_comment(table, "note: %s", folds->note);
	if (folds->interrupted)
		hawser__table_comment(table, "interrupted: the curves are incomplete");
	if (folds->costly)
		hawser__table_comment(table, "costly: the search ended at its limit of work, "
		                      "and more folds may exist: --max-points N lifts the limit");
	hawser__table_comment(table, "%d curve%s, %d points", folds->curves, folds->curves == 1 ? "" : "s",
	                      folds->points);
}

/* --- fields --- */

HAWSER__LABELS(event_name, hawser_event_name, enum hawser_event_kind)
HAWSER__LABELS(end_name, hawser_frf_end_name, enum hawser_frf_end)
HAWSER__LABELS(kind_name, hawser_folds_kind_name, enum hawser_folds_kind)
HAWSER__LABELS(least_name, hawser_folds_least_name, enum hawser_folds_least_kind)

/* A point or an event of a curve. */
struct row {
	int curve; /* index */
	const char *kind;
	struct hawser_folds_point point;
	struct hawser_folds_event event;
	const double *probe, *coordinate, *state;
};

#define OF(member) HAWSER__AT(struct row, point.member)
static const struct hawser__field point_field[] = {
	{NULL, "curve", "from 1", HAWSER__AT(struct row, curve), .flags = HAWSER__FROM_1},
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"load", NULL, "load factor", OF(load)},
	{NULL, "load_factor", "factor of the model's own load", OF(load)},
	{NULL, "kind", "fold, or the kind of an event", HAWSER__AT(struct row, kind)},
	CLI_AMPLITUDE(HAWSER__VECTOR_AT, struct row, probe),
	CLI_COORDINATES(HAWSER__VECTOR_AT, struct row, coordinate),
	{"residual", "residual", "defect of the orbit, relative", OF(residual)},
	{"truncation", "truncation", "estimated error of the truncated series, relative", OF(mesh)},
	{"harmonics", "harmonics", "number of harmonics in use", OF(harmonics)},
	{"iterations", NULL, "of the corrector", OF(iterations)},
	{"arc", NULL, "arclength along the curve, in the metric of the continuation", OF(arc)},
	CLI_STATE(HAWSER__VECTOR_AT, struct row, state),
	{"load_factor", NULL, "the same as load", OF(load)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct row, event.member)
static const struct hawser__field event_field[] = {
	{NULL, "curve", "from 1", HAWSER__AT(struct row, curve), .flags = HAWSER__FROM_1},
	{"kind", "kind", "what it is", HAWSER__LABEL_AT(struct row, event.kind, kind_name)},
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"load", "load_factor", "load factor", OF(load)},
	{"minimum", NULL, "1 where the load is least along the curve, -1 where it is greatest",
	 OF(minimum), .flags = HAWSER__OMIT},
	{"residual", NULL, "of its test function, relative", OF(residual)},
	{"after", NULL, "index of the point before it", OF(after)},
	CLI_STATE(HAWSER__VECTOR_AT, struct row, state),
	{"load_factor", NULL, "the same as load", OF(load)},
	HAWSER__END,
};
#undef OF

/* A curve: a range of the points and events of all curves. */
struct curve {
	const struct hawser_folds *folds;
	const struct hawser_folds_curve *own;
	double least_load, least_omega;
	const char *least_kind, *message;
	int number, points, events;
};

static const void *point_row(void *to, const void *parent, size_t index)
{
	const struct curve *curve = parent;
	const struct hawser_folds *folds = curve->folds;
	size_t i = (size_t)curve->own->first + index, n = (size_t)folds->n;

	*(struct row *)to = (struct row){
		.curve = curve->number, .kind = "fold", .point = folds->point[i],
		.probe = folds->probe + i*(size_t)folds->probes*3,
		.coordinate = folds->coordinate + i*n, .state = folds->state + i*2*n};
	return to;
}

static const void *event_row(void *to, const void *parent, size_t index)
{
	const struct curve *curve = parent;
	size_t e = (size_t)curve->own->first_event + index;
	struct row *row = to;

	*row = (struct row){.curve = curve->number, .event = curve->folds->event[e],
	                    .state = curve->folds->event_state + e*2*(size_t)curve->folds->n};
	row->event.after -= curve->own->first;
	if (row->event.kind == HAWSER_FOLDS_NOMINAL)
		row->event.minimum = HAWSER__NO_INTEGER;
	return row;
}
static const struct hawser__list
	point_list = HAWSER__MADE_ROWS(struct row, point_field, struct curve, points, point_row),
	event_list = HAWSER__MADE_ROWS(struct row, event_field, struct curve, events, event_row);

HAWSER__LABELS(curve_end_name, hawser_folds_end_name, enum hawser_folds_end)
static const struct hawser__field ends_field[] = {
	{"ends", NULL, "why it ends, at both ends",
	 HAWSER__WORDS_AT(struct hawser_folds_curve, end, curve_end_name)},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct curve, member)
static const struct hawser__field curve_field[] = {
	{"least_load", NULL, "least load factor on the curve", OF(least_load)},
	{"least_Omega", NULL, "where that is", OF(least_omega), .unit = HAWSER__RAD_S},
	{"least_kind", NULL, "kind of event that it is, or end", OF(least_kind)},
	{"", NULL, "", HAWSER__THROUGH(struct curve, own, ends_field)},
	{"message", NULL, "why it failed, or what was not located", OF(message), .flags = HAWSER__OMIT},
	{"events", NULL, "in order along it", HAWSER__OBJECTS_OF(event_list)},
	{"points", NULL, "folds, in order along it", HAWSER__OBJECTS_OF(point_list)},
	HAWSER__END,
};
#undef OF

static const void *curve_row(void *to, const void *parent, size_t c)
{
	const struct hawser_folds *folds = parent;
	const struct hawser_folds_curve *own = &folds->curve[c];

	*(struct curve *)to = (struct curve){
		.folds = folds, .own = own, .number = (int)c, .points = own->points,
		.events = own->events, .least_load = own->least_load,
		.least_omega = own->least_omega, .message = own->message,
		.least_kind = own->least_event < 0 ? "end"
		              : hawser_folds_kind_name(folds->event[own->least_event].kind)};
	return to;
}
static const struct hawser__list curve_list = HAWSER__MADE_ROWS(
	struct curve, curve_field, struct hawser_folds, curves, curve_row);

/* A response at the nominal load; each point has fewer members than in hawser frf. */
static const struct hawser__field response_event_field[] = {
	{"kind", NULL, "what it is", HAWSER__LABEL_AT(struct hawser_frf_event, kind, event_name)},
	{"Omega", NULL, "where it is", HAWSER__AT(struct hawser_frf_event, omega),
	 .unit = HAWSER__RAD_S},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct hawser_frf_point, member)
static const struct hawser__field response_point_field[] = {
	{"Omega", NULL, "forcing frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"stable", NULL, "whether the motion is stable",
	 HAWSER__NOT_AT(struct hawser_frf_point, unstable)},
	{"unstable", NULL, "multipliers outside the unit circle by more than their error", OF(unstable)},
	{"undecided", NULL, "multipliers on the unit circle within their error", OF(undecided)},
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct hawser_frf, probe),
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct hawser_frf, coordinate),
	{"error", NULL, "estimated error of the orbit, relative", OF(error)},
	CLI_STATE(HAWSER__VECTOR_ALONG, struct hawser_frf, state),
	HAWSER__END,
};
#undef OF
static const struct hawser__field response_field[] = {
	{"end", NULL, "why the curve ends", HAWSER__LABEL_AT(struct hawser_frf, end, end_name)},
	{"method", NULL, "for periodic orbits", HAWSER__AT(struct hawser_frf, method)},
	{"events", NULL, "bifurcations",
	 HAWSER__STORED(struct hawser_frf, event, events, response_event_field)},
	{"points", NULL, "points of the curve",
	 HAWSER__STORED(struct hawser_frf, point, points, response_point_field)},
	HAWSER__END,
};

/* --- the whole result --- */

#define OF(member) HAWSER__AT(struct hawser_folds_level, member)
static const struct hawser__field level_field[] = {
	{"load", NULL, "load factor", OF(load)},
	{"range", NULL, "of Omega", HAWSER__PAIR_AT(struct hawser_folds_level, from, to),
	 .unit = HAWSER__RAD_S},
	{"folds", NULL, "folds found", OF(folds)},
	HAWSER__END,
};
#undef OF
static const struct hawser__field lost_field[] = {
	{"Omega", NULL, "forcing frequency", HAWSER__AT(struct hawser_folds_lost, omega),
	 .unit = HAWSER__RAD_S},
	{"load", NULL, "load factor", HAWSER__AT(struct hawser_folds_lost, load)},
	HAWSER__END,
};

#define OF(member) HAWSER__AT(struct hawser_folds_starts, member)
static const struct hawser__field starts_field[] = {
	{"starts", NULL, "number of pseudo-random motions", OF(starts)},
	{"frequencies", NULL, "number of frequencies at which they settled", OF(frequencies)},
	{"known", NULL, "of them: on known curves", OF(known)},
	{"lost", NULL, "of them: on no orbit", OF(lost)},
	{"found", NULL, "detached curves found by them", OF(fresh)},
	{"attached", NULL, "curves found that begin at a branch point of a known one", OF(attached)},
	HAWSER__END,
};
#undef OF

enum { CURVES = 1 };
#define OF(member) HAWSER__AT(struct hawser_folds, member)
static const struct hawser__field folds_field[] = {
	{"least_load", NULL, "least load factor with a fold", OF(least_load), .when = CURVES},
	{"least_Omega", NULL, "where that is", OF(least_omega), .unit = HAWSER__RAD_S, .when = CURVES},
	{"least_kind", NULL, "kind of that point, or of the end of the search",
	 HAWSER__LABEL_AT(struct hawser_folds, least_kind, least_name), .when = CURVES},
	{"searched", NULL, "responses that were searched for folds",
	 HAWSER__STORED(struct hawser_folds, level, levels, level_field)},
	{"nearly_linear", NULL, "whether the search ended at a nearly linear response",
	 HAWSER__FLAG_AT(struct hawser_folds, nearly_linear)},
	{"curves", NULL, "fold curves", HAWSER__OBJECTS_OF(curve_list)},
	{"response", NULL, "at the model's own load",
	 HAWSER__PART_OF(struct hawser_folds, response, response_field)},
	{"isolas", NULL, "detached response curves at that load, with the keys of response",
	 HAWSER__STORED(struct hawser_folds, isola, isolas, response_field),
	 .flags = HAWSER__BRIEF},
	{"isola_search", NULL, "the search for detached curves that no fold curve shows",
	 HAWSER__PART_OF(struct hawser_folds, starts, starts_field)},
	{"not_followed", NULL, "folds from which no curve was found",
	 HAWSER__STORED(struct hawser_folds, lost_at, lost, lost_field)},
	{"note", NULL, "what could not be looked at", OF(note), .flags = HAWSER__OMIT},
	{"interrupted", NULL, "whether curves are incomplete",
	 HAWSER__FLAG_AT(struct hawser_folds, interrupted)},
	{"costly", NULL, "whether the search ended at its limit of work",
	 HAWSER__FLAG_AT(struct hawser_folds, costly)},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"points", NULL, "points of all curves", OF(points)},
	{"solves", NULL, "linear systems factorised", OF(solves)},
	HAWSER__END,
};
#undef OF

static const struct hawser__field stats_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_folds_result, folds, cost_field)},
	HAWSER__END,
};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_folds_result, model, cli_choice_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_folds_result, model, cli_exact_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_folds_result, model, cli_si_field)},
	{"range", NULL, "of Omega", HAWSER__PAIR_AT(struct cli_folds_result, from, to),
	 .unit = HAWSER__RAD_S},
	{"load_range", NULL, "of load factors",
	 HAWSER__PAIR_AT(struct cli_folds_result, load_from, load_to)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_folds_result, folds, folds_field)},
	HAWSER__END,
};

const struct cli_listing cli_folds_listing[] = {
	{"Columns of the table:", point_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_folds_result *result = of;

	return cli_model_head(
		result->common, "folds",
		"harmonic balance, minimally augmented fold, pseudo-arclength continuation",
		result->model, result->folds->curves > 0 ? CURVES : 0u);
}

static void rows(struct hawser__table *table, const void *of)
{
	static const struct hawser__curve_lists lists = {&curve_list, &point_list, &event_list,
	                                                 offsetof(struct row, event.after)};
	const struct cli_folds_result *result = of;
	struct hawser__view view = head(of).view;

	hawser__fields_curves(table, &lists, result->folds, &view);
}

const struct cli_showing cli_folds_showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field, .stats = stats_field,
	.draw = cli_folds_draw};

/* cli/compare/compare_result.c - see compare_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/compare/compare_result.h"
#include "cli/frame/view.h"

static const char *const axis_name[] = {"x", "y", "z"};

int cli_compare_has(const struct cli_compare_result *result, int i)
{
	return result->done[i] && !result->curve[i].status;
}

const char *cli_compare_outcome(const struct cli_compare_result *result, int i)
{
	const struct hawser_study_curve *curve = &result->curve[i];

	if (!result->done[i])
		return "interrupted";
	if (curve->status)
		return "failed";
	if (curve->frf.points > 0 && curve->frf.end != HAWSER_END_RANGE)
		return curve->frf.end == HAWSER_END_RETURNED ? "returned" : "cut";
	return curve->unreached ? "unreached" : "complete";
}

static const char *role(const struct cli_compare_result *result, int i)
{
	return i == result->reference ? "reference" : "compared";
}

/* Scaled Omega of the last point; NAN if nothing was computed. */
static double last_omega(const struct hawser_study_curve *curve)
{
	return curve->frf.points > 0 ? curve->frf.point[curve->frf.points - 1].omega : NAN;
}

/* A measured time; NAN if the result is to be reproducible. */
static double measured(const struct cli_compare_result *result, double seconds)
{
	return result->common->reproducible ? NAN : seconds;
}

/* --- table --- */

/* Results of runs that the user interrupted are not shown, so that an interruption is that by the
 * limit. */
const char *cli_compare_ended(const struct hawser_study_curve *curve)
{
	return curve->frf.end == HAWSER_END_INTERRUPTED ? "the time limit"
	       : hawser_frf_end_name(curve->frf.end);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_compare_result *result = of;
	struct hawser_match_options match = {.omega = 0.0};
	double unit = cli_per_omega(result->model);

	hawser_match_settle(&match);
	hawser__table_comment(table, "range: Omega from %.12g to %.12g rad/s", result->from*unit,
	                      result->to*unit);
	hawser__table_comment(table, "reference: %s; errors are relative, value over the reference's "
	                      "minus 1, the largest of the matched folds or peaks",
	                      result->curve[result->reference].choice.name);
	hawser__table_comment(table, "the same fold or peak: less than %g %% apart in Omega and a "
	                      "factor of %.3g in size, both counted together, in the same order "
	                      "along the branch", 100.0*match.omega, exp(match.size));
	cli_speeding_comment(table, result->model, fmax(result->from, result->to));
	for (int i = 0; i < result->count; i++) {
		const struct hawser_study_curve *curve = &result->curve[i];

		if (result->done[i] && curve->status)
			hawser__table_comment(table, "%s failed: %s", curve->choice.name,
			                      curve->report.message);
		else if (result->done[i] && curve->frf.points > 0 &&
		         curve->frf.end != HAWSER_END_RANGE)
			hawser__table_comment(table, "%s ended before the range did, at Omega %.6g rad/s: "
			                      "%s; what it lacks for that is counted as missing",
			                      curve->choice.name, last_omega(curve)*unit,
			                      cli_compare_ended(curve));
		else if (result->done[i] && curve->unreached)
			hawser__table_comment(table, "%s did not reach that: %.2g by its own estimate",
			                      curve->choice.name, curve->estimated);
		else if (!result->done[i])
			hawser__table_comment(table, "%s was interrupted", curve->choice.name);
	}
}

/* --- fields --- */

/* A fold or peak of a fidelity and that of the reference; if the fidelity does not have it, that of
 * the reference alone. */
struct mark {
	const char *fidelity, *curve, *kind, *turn, *probe, *axis, *outcome;
	int partner; /* index of the reference's; -1: none */
	double omega, size, omega_uncertainty, size_uncertainty;
	double other_omega, other_size, omega_error, size_error; /* NAN: none */
};
#define OF(member) HAWSER__AT(struct mark, member)
static const struct hawser__field mark_field[] = {
	{NULL, "fidelity", "whose it is", OF(fidelity)},
	{NULL, "curve", "outcome of that one's curve", OF(curve)},
	{"kind", "kind", "fold or peak", OF(kind)},
	{NULL, "Omega_is", "of a fold, whether Omega is largest or smallest there", OF(turn)},
	{"probe", "probe", "of a peak", OF(probe), .flags = HAWSER__OMIT},
	{"axis", "axis", "of a peak: x, y or z", OF(axis), .flags = HAWSER__OMIT},
	{"Omega_is", NULL, "of a fold, whether Omega is largest or smallest there", OF(turn),
	 .flags = HAWSER__OMIT},
	{NULL, "outcome", "matched, missing or extra", OF(outcome)},
	{"Omega", "Omega", "where it is", OF(omega), .unit = HAWSER__RAD_S, .flags = HAWSER__OMIT},
	{"size", "size", "amplitude; of a fold, root of the sum of squares of all", OF(size),
	 .unit = HAWSER__M, .flags = HAWSER__OMIT},
	{"Omega_uncertainty", "Omega_uncertainty", "relative", OF(omega_uncertainty),
	 .flags = HAWSER__OMIT},
	{"size_uncertainty", "size_uncertainty", "relative", OF(size_uncertainty),
	 .flags = HAWSER__OMIT},
	{"partner", NULL, "index of the reference's; null: none", OF(partner), .flags = HAWSER__NULL},
	{NULL, "reference_Omega", "the reference's", OF(other_omega), .unit = HAWSER__RAD_S,
	 .flags = HAWSER__OMIT},
	{NULL, "reference_size", "the reference's", OF(other_size), .unit = HAWSER__M,
	 .flags = HAWSER__OMIT},
	{"Omega_error", "Omega_error", "over the reference's, minus 1", OF(omega_error),
	 .flags = HAWSER__OMIT},
	{"size_error", "size_error", "over the reference's, minus 1", OF(size_error),
	 .flags = HAWSER__OMIT},
	HAWSER__END,
};
#undef OF

/* A fidelity: its curve and its errors. */
struct fidelity {
	const struct cli_compare_result *result;
	int index, n, points, landmarks;
	long entries;
	const char *name, *family, *role, *outcome, *message, *end, *planned_is;
	double number, omega_end, build, respond, processor, planned; /* NAN: none */
	double tension, least;
	struct hawser_study_error error;
};
#define OF(member) HAWSER__AT(struct fidelity, member)
/* Fields of all fidelities, also of failed ones. */
#define CHOICE_FIELDS \
	{"name", "fidelity", "the fidelity", OF(name)}, \
	{"family", NULL, "the fidelity without its number", OF(family)}, \
	{"number", NULL, "its number, such as that of modes", OF(number)}, \
	{"role", "role", "reference or compared", OF(role)}, \
	{"outcome", "outcome", "complete, or why not", OF(outcome)}, \
	{"message", NULL, "why it failed", OF(message), .flags = HAWSER__OMIT}

static const struct hawser__field failed_field[] = {CHOICE_FIELDS, HAWSER__END};

static const void *mark_row(void *to, const void *parent, size_t k);
static const struct hawser__list mark_list = HAWSER__MADE_ROWS(
	struct mark, mark_field, struct fidelity, landmarks, mark_row);

/* A number that may be unknown: null. */
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
static const struct hawser__field fidelity_field[] = {
	CHOICE_FIELDS,
	{"coordinates", "coordinates", "of the model", OF(n), .place = 2},
	{"tensor_entries", "tensor_entries", "of the model", OF(entries), .place = 2},
	{"points", "points", "of the curve", OF(points), .place = 6},
	{"end", NULL, "why the curve ended", OF(end), .flags = HAWSER__OMIT},
	{"Omega_end", "Omega_end", "where the curve ended", OF(omega_end), .unit = HAWSER__RAD_S,
	 .flags = HAWSER__OMIT, .place = 1},
	{"build_secs", "build_s", "wall time of the model (s)", MAYBE(build), .place = 7},
	{"response_secs", "response_s", "wall time of the response (s)", MAYBE(respond), .place = 7},
	{"processor_secs", "processor_s", "processor time of both (s)", MAYBE(processor), .place = 7},
	{"planned_secs", "planned_s", "the plan's estimate of that (s)", MAYBE(planned), .place = 7},
	{"planned_is", "planned_is", "estimate", OF(planned_is), .place = 7},
	{"tension", "tension", "largest tension on the cable, of all orbits",
	 MAYBE(tension), .unit = HAWSER__NEWTON,
	 .place = 4},
	{"least_tension", "least_tension", "least tension on the cable, of all orbits",
	 MAYBE(least), .unit = HAWSER__NEWTON,
	 .place = 5},
	{"tension_error", "tension_error", "error of the largest tension, relative",
	 MAYBE(error.tension),
	 .place = 4},
	{"landmark_uncertainty", "landmark_uncertainty", "estimated error of a compared "
	 "frequency, relative; smaller differences mean nothing",
	 OF(error.floor), .place = 3},
	{"distance", "distance", "of the whole response from the reference, relative; parts that only "
	 "one of them has count too",
	 MAYBE(error.distance), .place = 2},
	{"folds.matched", "folds_matched", "pairs that match", OF(error.fold.matched), .place = 2},
	{"folds.missing", "folds_missing", "of the reference, without a partner here",
	 OF(error.fold.missing), .place = 2},
	{"folds.extra", "folds_extra", "without a partner in the reference",
	 OF(error.fold.extra), .place = 2},
	{"folds.Omega_error", "fold_Omega_error", "largest error of those that match, relative",
	 MAYBE(error.fold.omega),
	 .place = 2},
	{"folds.size_error", NULL, "largest error of those that match, relative",
	 MAYBE(error.fold.size)},
	{"peaks.matched", "peaks_matched", "pairs that match", OF(error.peak.matched), .place = 2},
	{"peaks.missing", "peaks_missing", "of the reference, without a partner here",
	 OF(error.peak.missing), .place = 2},
	{"peaks.extra", "peaks_extra", "without a partner in the reference",
	 OF(error.peak.extra), .place = 2},
	{"peaks.Omega_error", "peak_Omega_error", "largest error of those that match, relative",
	 MAYBE(error.peak.omega),
	 .place = 2},
	{"peaks.size_error", "peak_amplitude_error", "largest error of those that match, relative",
	 MAYBE(error.peak.size),
	 .place = 2},
	{"largest_peaks.matched", NULL, "matching pairs of the largest peaks of components",
	 OF(error.largest.matched)},
	{"largest_peaks.missing", "largest_peaks_missing", "of the reference, without a partner here",
	 OF(error.largest.missing),
	 .place = 2},
	{"largest_peaks.extra", NULL, "without a partner in the reference", OF(error.largest.extra)},
	{"largest_peaks.Omega_error", "largest_peak_Omega_error",
	 "largest error of those that match, relative",
	 MAYBE(error.largest.omega), .place = 2},
	{"largest_peaks.size_error", "largest_peak_amplitude_error",
	 "largest error of those that match, relative",
	 MAYBE(error.largest.size), .place = 2},
	{"landmarks", NULL, "folds and peaks", HAWSER__OBJECTS_OF(mark_list)},
	HAWSER__END,
};
#undef OF
#undef MAYBE

/* Was it compared? */
static int is_compared(const struct cli_compare_result *result, int i)
{
	return cli_compare_has(result, i) && result->error[i].partner;
}

static const struct fidelity *fidelity_of(struct fidelity *row,
                                          const struct cli_compare_result *result, int i)
{
	const struct hawser_study_curve *curve = &result->curve[i];

	*row = (struct fidelity){
		.result = result, .index = i, .name = curve->choice.name,
		.family = curve->choice.fidelity->name, .number = curve->choice.number,
		.role = role(result, i), .outcome = cli_compare_outcome(result, i),
		.message = result->done[i] && curve->status ? curve->report.message : NULL};
	if (!is_compared(result, i))
		return row;
	row->n = curve->n;
	row->entries = curve->quads + curve->cubics;
	row->points = curve->frf.points;
	row->end = curve->frf.points > 0 ? hawser_frf_end_name(curve->frf.end) : NULL;
	row->omega_end = last_omega(curve);
	row->build = measured(result, curve->build_seconds);
	row->respond = measured(result, curve->respond_seconds);
	row->processor = measured(result, curve->processor_seconds);
	row->planned = measured(result, result->estimate[i]);
	row->planned_is = isfinite(row->planned) ? "estimate" : "";
	row->tension = curve->tension;
	row->least = curve->least_tension;
	row->error = result->error[i];
	row->landmarks = curve->landmarks;
	return row;
}

/* --- landmarks --- */

/* All fidelities have the same probes. */
static const char *probe_of(const struct cli_compare_result *result, int p)
{
	return result->model->made ? result->model->rom.shapes.name[p]
	                           : result->curve[result->reference].probe[p];
}

static struct mark mark_of(const struct cli_compare_result *result, int i,
                           const struct hawser_landmark *own, const struct hawser_landmark *other,
                           const char *outcome)
{
	const struct hawser_landmark *shown = own ? own : other;
	int fold = shown->kind != HAWSER_LANDMARK_PEAK;

	return (struct mark){
		.fidelity = result->curve[i].choice.name, .curve = cli_compare_outcome(result, i),
		.kind = fold ? "fold" : "peak", .outcome = outcome, .partner = -1,
		.turn = shown->turn > 0 ? "largest" : shown->turn < 0 ? "smallest" : "",
		.probe = shown->probe < 0 ? "" : probe_of(result, shown->probe),
		.axis = shown->axis < 0 ? "" : axis_name[shown->axis],
		.omega = own ? own->omega : NAN, .size = own ? own->size : NAN,
		.omega_uncertainty = own ? own->omega_error : NAN,
		.size_uncertainty = own ? own->size_error : NAN,
		.other_omega = other ? other->omega : NAN, .other_size = other ? other->size : NAN,
		.omega_error = own && other ? own->omega/other->omega - 1.0 : NAN,
		.size_error = own && other ? own->size/other->size - 1.0 : NAN};
}

/* Fold or peak k of a fidelity. */
static const void *mark_row(void *to, const void *parent, size_t k)
{
	const struct fidelity *fidelity = parent;
	const struct cli_compare_result *result = fidelity->result;
	int i = fidelity->index, partner = result->error[i].partner[k];
	struct mark *mark = to;

	*mark = mark_of(result, i, &result->curve[i].landmark[k], partner < 0 ? NULL
	                : &result->curve[result->reference].landmark[partner],
	                partner < 0 ? "extra" : "matched");
	mark->partner = partner < 0 ? HAWSER__NO_INTEGER : partner;
	return mark;
}

static int is_partner(const struct hawser_study_error *error, int count, int index)
{
	for (int i = 0; i < count; i++)
		if (error->partner[i] == index)
			return 1;
	return 0;
}

static void landmark_table(struct hawser__table *table, const struct cli_compare_result *result,
                           const struct hawser__view *view)
{
	const struct hawser_study_curve *reference = &result->curve[result->reference];

	hawser__fields_columns(table, mark_field, view);
	for (int i = 0; i < result->count; i++) {
		struct fidelity fidelity;

		if (!is_compared(result, i))
			continue;
		fidelity_of(&fidelity, result, i);
		hawser__fields_rows(table, NULL, &mark_list, &fidelity, view);
		for (int k = 0; k < reference->landmarks; k++)
			if (!is_partner(&result->error[i], result->curve[i].landmarks, k)) {
				struct mark mark = mark_of(result, i, NULL, &reference->landmark[k], "missing");

				hawser__fields_row(table, NULL, mark_field, &mark, view);
			}
	}
}

static void fidelity_table(struct hawser__table *table, const struct cli_compare_result *result,
                           const struct hawser__view *view)
{
	struct fidelity row;

	hawser__fields_columns(table, fidelity_field, view);
	for (int i = 0; i < result->count; i++)
		hawser__fields_row(table, fidelity_field,
		                   is_compared(result, i) ? fidelity_field : failed_field,
		                   fidelity_of(&row, result, i), view);
}

static struct cli_head head(const void *of)
{
	const struct cli_compare_result *result = of;

	return cli_model_head(result->common, "compare", "folds and peaks matched along the branch",
	                      result->model, 0);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct cli_compare_result *result = of;
	struct hawser__view view = head(of).view;

	(result->landmarks ? landmark_table : fidelity_table)(table, result, &view);
}

/* --- JSON --- */

static void fidelities_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_compare_result *result = row;
	struct hawser__view view = cli_view(result->model, 0);
	json_t *list = hawser__json_array(json, into, "fidelities");

	for (int i = 0; i < result->count; i++) {
		struct fidelity fidelity;

		hawser__fields_json(json, hawser__json_object(json, list, NULL),
		                    is_compared(result, i) ? fidelity_field : failed_field,
		                    fidelity_of(&fidelity, result, i), &view);
	}
}

static const struct hawser__field match_field[] = {
	{"Omega", NULL, "largest distance, relative", HAWSER__AT(struct hawser_match_options, omega)},
	{"size", NULL, "logarithm of the largest ratio", HAWSER__AT(struct hawser_match_options, size)},
	HAWSER__END,
};

static void match_json(struct hawser__json *json, json_t *into, const void *row)
{
	struct hawser_match_options match = {.omega = 0.0};
	struct hawser__view view = cli_si_view(0);

	(void)row;
	hawser_match_settle(&match);
	hawser__fields_json(json, hawser__json_object(json, into, "match"), match_field, &match, &view);
}

static void reference_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_compare_result *result = row;

	hawser__json_text(json, into, "reference", result->curve[result->reference].choice.name);
}

#define OF(member) HAWSER__AT(struct cli_compare_result, member)
static const struct hawser__field result_field[] = {
	{"reference", NULL, "the fidelity that is the reference", HAWSER__CALLS(reference_json)},
	{"from", NULL, "end of the range of Omega", OF(from), .unit = HAWSER__RAD_S},
	{"to", NULL, "its other end", OF(to), .unit = HAWSER__RAD_S},
	{"tolerance", NULL, "of the responses", OF(tolerance)},
	{"limit_secs", NULL, "processor time of a curve", OF(limit)},
	{"match", NULL, "what counts as the same landmark", HAWSER__CALLS(match_json),
	 .inner = match_field},
	{"fidelities", NULL, "in the order asked for", HAWSER__CALLS(fidelities_json),
	 .inner = fidelity_field},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_compare_listing[] = {
	{"Columns of the table:", fidelity_field, 0},
	{"Columns with --landmarks:", mark_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* --- picture --- */

static enum hawser_status draw(const char *path, const void *context,
                               struct hawser_report *report)
{
	const struct cli_compare_result *result = context;
	struct hawser__precision run[CLI_FIDELITIES];
	int runs = 0;

	for (int i = 0; i < result->count; i++) {
		const struct hawser_study_curve *curve = &result->curve[i];
		const struct hawser_study_error *error = &result->error[i];

		if (!cli_compare_has(result, i) || !error->partner || i == result->reference)
			continue;
		run[runs++] = (struct hawser__precision){
			.family = curve->choice.fidelity->name, .number = curve->n,
			.seconds = curve->processor_seconds,
			.fold = fabs(error->fold.omega), .peak = fabs(error->peak.omega),
			.amplitude = fabs(error->peak.size),
			.incomplete = error->fold.missing + error->fold.extra + error->peak.missing +
			              error->peak.extra > 0,
		};
	}
	return hawser__plot_precision(path, run, runs,
	                              result->curve[result->reference].choice.name, report);
}

const struct cli_showing cli_compare_showing = {
	.head = head, .comments = comments, .more = rows, .fields = result_field,
	.draw = draw};

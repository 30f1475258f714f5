/* cli/compare_result.c - see compare_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "cli/compare_result.h"

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

/* Scaled Omega of the last point; NAN where nothing was traced. */
static double last_omega(const struct hawser_study_curve *curve)
{
	return curve->frf.points > 0 ? curve->frf.point[curve->frf.points - 1].omega : NAN;
}

/* NAN: no such number. */
static void number_or_blank(struct hawser__table *table, double number)
{
	if (isnan(number))
		hawser__table_word(table, "");
	else
		hawser__table_number(table, number);
}

/* A measured time, unless the result is to be reproducible. */
static double measured(const struct cli_compare_result *result, double seconds)
{
	return result->common->reproducible ? NAN : seconds;
}

/* --- table --- */

/* A run that was interrupted by the user is not looked at: here it was the limit. */
const char *cli_compare_ended(const struct hawser_study_curve *curve)
{
	return curve->frf.end == HAWSER_END_INTERRUPTED ? "the time limit"
	       : hawser_frf_end_name(curve->frf.end);
}

static void comments(struct hawser__table *table, const struct cli_compare_result *result)
{
	const struct hawser_match_options match = hawser_match_defaults();
	double unit = cli_per_omega(result->model);

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

static void kind_cells(struct hawser__table *table, const struct hawser_study_kind_error *error,
                       int with_size)
{
	hawser__table_number(table, error->matched);
	hawser__table_number(table, error->missing);
	hawser__table_number(table, error->extra);
	number_or_blank(table, error->omega);
	if (with_size)
		number_or_blank(table, error->size);
}

static void fidelity_row(struct hawser__table *table, const struct cli_compare_result *result,
                         int i, size_t columns)
{
	const struct hawser_study_curve *curve = &result->curve[i];
	const struct hawser_study_error *error = &result->error[i];

	hawser__table_word(table, curve->choice.name);
	hawser__table_word(table, role(result, i));
	hawser__table_word(table, cli_compare_outcome(result, i));
	if (!cli_compare_has(result, i) || !error->partner) {
		for (size_t k = 3; k < columns; k++)
			hawser__table_word(table, "");
		return;
	}
	number_or_blank(table, last_omega(curve)*cli_per_omega(result->model));
	hawser__table_number(table, curve->n);
	hawser__table_number(table, curve->quads + curve->cubics);
	kind_cells(table, &error->fold, 0);
	kind_cells(table, &error->peak, 1);
	hawser__table_number(table, error->largest.missing);
	number_or_blank(table, error->largest.omega);
	number_or_blank(table, error->largest.size);
	hawser__table_number(table, error->floor);
	number_or_blank(table, curve->tension);
	number_or_blank(table, error->tension);
	number_or_blank(table, curve->least_tension);
	hawser__table_number(table, curve->frf.points);
	number_or_blank(table, measured(result, curve->build_seconds));
	number_or_blank(table, measured(result, curve->respond_seconds));
	number_or_blank(table, measured(result, curve->processor_seconds));
	number_or_blank(table, measured(result, result->estimate[i]));
}

static void fidelity_table(struct hawser__table *table, const struct cli_compare_result *result)
{
	static const char *const column[] = {
		"fidelity", "role", "outcome", "Omega_end_rad_s", "coordinates", "tensor_entries",
		"folds_matched", "folds_missing",
		"folds_extra", "fold_Omega_error", "peaks_matched", "peaks_missing", "peaks_extra",
		"peak_Omega_error", "peak_amplitude_error", "largest_peaks_missing",
		"largest_peak_Omega_error", "largest_peak_amplitude_error", "landmark_uncertainty", "tension_N",
		"tension_error", "least_tension_N", "points", "build_s", "response_s",
		"processor_s", "planned_s",
	};
	const size_t columns = sizeof column/sizeof *column;

	for (size_t i = 0; i < columns; i++)
		hawser__table_column(table, "%s", column[i]);
	for (int i = 0; i < result->count; i++)
		fidelity_row(table, result, i, columns);
}

static const char *kind_name(const struct hawser_landmark *landmark)
{
	return landmark->kind == HAWSER_LANDMARK_PEAK ? "peak" : "fold";
}

/* All fidelities have the same probes. */
static const char *probe_name(const struct cli_compare_result *result,
                              const struct hawser_landmark *landmark)
{
	return landmark->probe < 0 ? "" : result->curve[result->reference].probe[landmark->probe];
}

static void landmark_row(struct hawser__table *table, const struct cli_compare_result *result,
                         int i, const struct hawser_landmark *own,
                         const struct hawser_landmark *other, const char *outcome)
{
	const struct hawser_landmark *shown = own ? own : other;

	if (!shown)
		return;
	hawser__table_word(table, result->curve[i].choice.name);
	hawser__table_word(table, cli_compare_outcome(result, i));
	hawser__table_word(table, kind_name(shown));
	hawser__table_word(table, shown->turn > 0 ? "largest" : shown->turn < 0 ? "smallest" : "");
	hawser__table_word(table, probe_name(result, shown));
	hawser__table_word(table, shown->axis < 0 ? "" : axis_name[shown->axis]);
	hawser__table_word(table, outcome);
	number_or_blank(table, own ? own->omega*cli_per_omega(result->model) : NAN);
	number_or_blank(table, own ? own->size*cli_per_length(result->model) : NAN);
	number_or_blank(table, own ? own->omega_error : NAN);
	number_or_blank(table, own ? own->size_error : NAN);
	number_or_blank(table, other ? other->omega*cli_per_omega(result->model) : NAN);
	number_or_blank(table, other ? other->size*cli_per_length(result->model) : NAN);
	number_or_blank(table, own && other ? own->omega/other->omega - 1.0 : NAN);
	number_or_blank(table, own && other ? own->size/other->size - 1.0 : NAN);
}

static int is_partner(const struct hawser_study_error *error, int count, int index)
{
	for (int i = 0; i < count; i++)
		if (error->partner[i] == index)
			return 1;
	return 0;
}

static void landmark_table(struct hawser__table *table, const struct cli_compare_result *result)
{
	static const char *const column[] = {
		"fidelity", "curve", "kind", "Omega_is", "probe", "axis", "outcome", "Omega_rad_s", "size_m",
		"Omega_uncertainty", "size_uncertainty", "reference_Omega_rad_s", "reference_size_m",
		"Omega_error", "size_error",
	};
	const struct hawser_study_curve *reference = &result->curve[result->reference];

	for (size_t i = 0; i < sizeof column/sizeof *column; i++)
		hawser__table_column(table, "%s", column[i]);
	for (int i = 0; i < result->count; i++) {
		const struct hawser_study_curve *curve = &result->curve[i];
		const struct hawser_study_error *error = &result->error[i];

		if (!cli_compare_has(result, i) || !error->partner)
			continue;
		for (int k = 0; k < curve->landmarks; k++)
			landmark_row(table, result, i, &curve->landmark[k],
			             error->partner[k] < 0 ? NULL : &reference->landmark[error->partner[k]],
			             error->partner[k] < 0 ? "extra" : "matched");
		for (int k = 0; k < reference->landmarks; k++)
			if (!is_partner(error, curve->landmarks, k))
				landmark_row(table, result, i, NULL, &reference->landmark[k], "missing");
	}
}

void cli_compare_table(struct hawser__table *table, const void *of)
{
	const struct cli_compare_result *result = of;

	cli_echo_table(table, result->common, "compare", &result->model->scene,
	               "folds and peaks matched along the branch");
	comments(table, result);
	if (result->landmarks)
		landmark_table(table, result);
	else
		fidelity_table(table, result);
}

/* --- JSON --- */

static void number_or_null(struct hawser__json *json, json_t *into, const char *key, double number)
{
	if (isnan(number))
		hawser__json_null(json, into, key);
	else
		hawser__json_number(json, into, key, number);
}

static void landmark_json(struct hawser__json *json, json_t *list,
                          const struct cli_compare_result *result, int i, int k)
{
	const struct hawser_landmark *own = &result->curve[i].landmark[k], *other;
	int partner = result->error[i].partner ? result->error[i].partner[k] : -1;
	json_t *row = hawser__json_object(json, list, NULL);

	hawser__json_text(json, row, "kind", kind_name(own));
	if (own->kind == HAWSER_LANDMARK_PEAK) {
		hawser__json_text(json, row, "probe", probe_name(result, own));
		hawser__json_text(json, row, "axis", axis_name[own->axis]);
	} else {
		hawser__json_text(json, row, "Omega_is", own->turn > 0 ? "largest" : "smallest");
	}
	hawser__json_number(json, row, "Omega", own->omega*cli_per_omega(result->model));
	hawser__json_number(json, row, "size", own->size*cli_per_length(result->model));
	hawser__json_number(json, row, "Omega_uncertainty", own->omega_error);
	hawser__json_number(json, row, "size_uncertainty", own->size_error);
	if (partner < 0) {
		hawser__json_null(json, row, "partner");
		return;
	}
	other = &result->curve[result->reference].landmark[partner];
	hawser__json_integer(json, row, "partner", partner);
	hawser__json_number(json, row, "Omega_error", own->omega/other->omega - 1.0);
	hawser__json_number(json, row, "size_error", own->size/other->size - 1.0);
}

static void kind_json(struct hawser__json *json, json_t *row, const char *key,
                      const struct hawser_study_kind_error *error)
{
	json_t *into = hawser__json_object(json, row, key);

	hawser__json_integer(json, into, "matched", error->matched);
	hawser__json_integer(json, into, "missing", error->missing);
	hawser__json_integer(json, into, "extra", error->extra);
	number_or_null(json, into, "Omega_error", error->omega);
	number_or_null(json, into, "size_error", error->size);
}

static void fidelity_json(struct hawser__json *json, json_t *list,
                          const struct cli_compare_result *result, int i)
{
	const struct hawser_study_curve *curve = &result->curve[i];
	const struct hawser_study_error *error = &result->error[i];
	json_t *row = hawser__json_object(json, list, NULL), *landmarks;

	hawser__json_text(json, row, "name", curve->choice.name);
	hawser__json_text(json, row, "family", curve->choice.fidelity->name);
	hawser__json_number(json, row, "number", curve->choice.number);
	hawser__json_text(json, row, "role", role(result, i));
	hawser__json_text(json, row, "outcome", cli_compare_outcome(result, i));
	if (result->done[i] && curve->status)
		hawser__json_text(json, row, "message", curve->report.message);
	if (!cli_compare_has(result, i) || !error->partner)
		return;
	hawser__json_integer(json, row, "coordinates", curve->n);
	hawser__json_integer(json, row, "tensor_entries", curve->quads + curve->cubics);
	hawser__json_integer(json, row, "points", curve->frf.points);
	if (curve->frf.points > 0) {
		hawser__json_text(json, row, "end", hawser_frf_end_name(curve->frf.end));
		hawser__json_number(json, row, "Omega_end",
		                    last_omega(curve)*cli_per_omega(result->model));
	}
	number_or_null(json, row, "build_secs", measured(result, curve->build_seconds));
	number_or_null(json, row, "response_secs", measured(result, curve->respond_seconds));
	number_or_null(json, row, "processor_secs", measured(result, curve->processor_seconds));
	number_or_null(json, row, "planned_secs", measured(result, result->estimate[i]));
	number_or_null(json, row, "tension", curve->tension);
	number_or_null(json, row, "least_tension", curve->least_tension);
	number_or_null(json, row, "tension_error", error->tension);
	hawser__json_number(json, row, "landmark_uncertainty", error->floor);
	kind_json(json, row, "folds", &error->fold);
	kind_json(json, row, "peaks", &error->peak);
	kind_json(json, row, "largest_peaks", &error->largest);
	landmarks = hawser__json_array(json, row, "landmarks");
	for (int k = 0; k < curve->landmarks; k++)
		landmark_json(json, landmarks, result, i, k);
}

void cli_compare_json(struct hawser__json *json, const void *of)
{
	const struct cli_compare_result *result = of;
	const struct hawser_match_options match = hawser_match_defaults();
	double unit = cli_per_omega(result->model);
	json_t *list, *limits;

	cli_echo_json(json, result->common, "compare", &result->model->scene);
	hawser__json_text(json, json->root, "reference",
	                  result->curve[result->reference].choice.name);
	hawser__json_number(json, json->root, "from", result->from*unit);
	hawser__json_number(json, json->root, "to", result->to*unit);
	hawser__json_number(json, json->root, "tolerance", result->tolerance);
	hawser__json_number(json, json->root, "limit_secs", result->limit);
	limits = hawser__json_object(json, json->root, "match");
	hawser__json_number(json, limits, "Omega", match.omega);
	hawser__json_number(json, limits, "size", match.size);
	list = hawser__json_array(json, json->root, "fidelities");
	for (int i = 0; i < result->count; i++)
		fidelity_json(json, list, result, i);
	cli_stats_json(json, result->common);
}

/* --- picture --- */

enum hawser_status cli_compare_draw(const char *path, const void *context,
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

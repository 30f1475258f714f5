/* cli/plan_result.c - see plan_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/plan_result.h"

/* Does the load drive mode j? */
static int is_driven(const struct cli_plan_result *result, int j)
{
	double most = 0.0;

	for (int k = 0; k < result->plan.modes.n; k++)
		most = fmax(most, fabs(result->plan.load[k]));
	return most > 0.0 && fabs(result->plan.load[j]) > 1e-12*most;
}

void cli_plan_forget_times(struct hawser_plan *plan)
{
	plan->seconds = NAN;
	for (int i = 0; i < plan->rows; i++) {
		struct hawser_plan_row *row = &plan->row[i];

		row->seconds = row->least = row->most = row->points = NAN;
		row->basis = HAWSER_BASIS_NONE;
		row->bound = 0;
		row->status = HAWSER_OK;
		row->foreseen[0] = '\0';
	}
}

/* --- settings --- */

/* "[0.8, 0.8, 0.8]", or nothing where the scene has no such list. */
static int list_text(char *text, size_t size, const struct hawser_scene *scene, const char *path)
{
	char element[96];
	size_t length = 0;
	double value;
	int i;

	for (i = 0;; i++) {
		snprintf(element, sizeof element, "%s[%d]", path, i);
		if (hawser_scene_get(scene, &value, element, NULL))
			break;
		length += (size_t)snprintf(text + length, size - length, "%s%.10g", i ? ", " : "[",
		                           value);
	}
	if (i > 0)
		snprintf(text + length, size - length, "]");
	return i > 0;
}

/* The scene's value of a key as text; 0 where it has none. */
static int key_text(char *text, size_t size, const struct hawser_scene *scene,
                    const struct hawser_scene_key *key)
{
	char word[HAWSER_WORD_SIZE];
	double value;

	if (strncmp(key->type, "numbers", 7) == 0)
		return list_text(text, size, scene, key->path);
	if (hawser_scene_get(scene, &value, key->path, NULL) == HAWSER_OK) {
		snprintf(text, size, "%.10g", value);
		return 1;
	}
	if (hawser_scene_word(scene, word, key->path, NULL) == HAWSER_OK) {
		snprintf(text, size, "%s", word);
		return 1;
	}
	return 0;
}

/* Of the response: what hawser frf and hawser compare use where no option says otherwise. */
static int response_settings(struct cli_setting *setting, int count)
{
	static const char *const name[] = {"--tolerance", "--step", "--max-points", "--segments",
	                                   "--method"};
	static const char *const doc[] = {
		"residual and integration error of an orbit, relative to its size",
		"longest step along the response, as a part of the range",
		"end of a curve", "of the period, in shooting", "for periodic orbits"};
	const struct hawser_frf_options options = hawser_frf_defaults();

	for (int i = 0; i < 5; i++, count++) {
		struct cli_setting *now = &setting[count];

		*now = (struct cli_setting){.unit = "", .doc = doc[i]};
		snprintf(now->name, sizeof now->name, "%s", name[i]);
		if (i == 0)
			snprintf(now->value, sizeof now->value, "%g", options.tolerance);
		else if (i == 1)
			snprintf(now->value, sizeof now->value, "%g", CLI_STEP);
		else if (i == 2)
			snprintf(now->value, sizeof now->value, "%d", options.max_points);
		else
			snprintf(now->value, sizeof now->value, "%s", i == 3 ? "as many as needed"
			         : options.method ? options.method : "as suits the model");
	}
	return count;
}

int cli_plan_settings(struct cli_setting *setting, const struct cli_plan_result *result)
{
	const struct hawser_scene *scene = &result->model->scene;
	size_t keys;
	const struct hawser_scene_key *key = hawser_scene_keys(&keys);
	int count = 0;

	for (size_t i = 0; i < keys && count < CLI_SETTINGS - 8; i++) {
		struct cli_setting *now = &setting[count];

		*now = (struct cli_setting){.unit = strcmp(key[i].unit, "1") ? key[i].unit : "",
		                            .doc = key[i].doc,
		                            .written = hawser_scene_written(scene, key[i].path)};
		snprintf(now->name, sizeof now->name, "%s", key[i].path);
		count += key_text(now->value, sizeof now->value, scene, &key[i]);
	}
	return response_settings(setting, count);
}

/* --- text --- */

static void print_decisions(FILE *stream, const struct cli_plan_result *result)
{
	fputs("\nModelled\n", stream);
	for (int i = 0; i < result->plan.decisions; i++) {
		const struct hawser_plan_decision *decision = &result->plan.decision[i];

		fprintf(stream, "  %-4s %-34s %s\n", decision->modelled ? "yes" : "no",
		        decision->subject, decision->why);
	}
}

/* Modes up to the last that is kept or worth it. */
static int modes_shown(const struct hawser_plan *plan)
{
	int last = 0;

	for (int j = 0; j < plan->modes.n; j++)
		if (plan->mode[j].kept || plan->mode[j].worth)
			last = j + 1;
	return last;
}

static void print_modes(FILE *stream, const struct cli_plan_result *result)
{
	const struct hawser_plan *plan = &result->plan;
	double unit = cli_per_omega(result->model);
	int shown = modes_shown(plan);

	fprintf(stream, "\nModes, %d of %d looked at; kept in the scene's model, or worth it for "
	        "model.accuracy %g\n  %4s %12s  %-13s %-14s %-4s %-5s %-13s %s\n", shown, plan->modes.n,
	        result->model->scene.model.accuracy, "mode", "omega rad/s", "plane", "symmetry", "kept",
	        "worth", "as", "left out, it should cost");
	for (int j = 0; j < shown; j++) {
		const struct hawser_mode *mode = &plan->modes.mode[j];
		const struct hawser_plan_mode *at = &plan->mode[j];

		fprintf(stream, "  %4d %12.6g  %-13s %-14s %-4s %-5s ", j + 1, mode->omega*unit,
		        hawser_plane_name(mode->plane), hawser_symmetry_name(mode->symmetry),
		        at->kept ? "yes" : "no", !plan->chosen ? "" : at->worth ? "yes" : "no");
		if (plan->chosen)
			fprintf(stream, "%-13s %.2g%s", hawser_reason_name(at->reason), at->measure,
			        at->kept && at->reason == HAWSER_NOT_EXCITED
			        ? ", kept: whether it stays at rest is looked at" : "");
		fputs("\n", stream);
	}
}

static void print_resonances(FILE *stream, const struct cli_plan_result *result)
{
	const struct hawser_plan *plan = &result->plan;
	double unit = cli_per_omega(result->model);

	fprintf(stream, "\nPrimary resonances in the range, each alone (estimates)\n"
	        "  %4s %12s %12s %8s %6s %11s %11s  %s\n", "mode", "omega rad/s", "peak rad/s",
	        "motion m", "folds", "cubic", "unlocked", "meets");
	if (plan->undamped > 0)
		fprintf(stream, "  %d of %d have no damping, so no peak\n", plan->undamped,
		        plan->undamped + plan->resonances);
	else if (plan->resonances == 0)
		fputs("  none\n", stream);
	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		char meets[40] = "";

		if (at->partner >= 0)
			snprintf(meets, sizeof meets, "mode %d (1:%d)", at->partner + 1, at->order);
		fprintf(stream, "  %4d %12.6g %12.6g %8.3g %6d %11.4g %11.4g  %s\n", at->mode + 1,
		        at->omega*unit, at->peak_omega*unit, at->motion*cli_per_length(result->model),
		        at->folds, at->cubic, at->unlocked, meets);
	}
}

/* "-" where there is no number. */
static const char *figure(char text[16], const char *format, double number)
{
	if (isnan(number))
		return "-";
	if (isinf(number))
		return "missing";
	if (number > 1.0 && strchr(format, 'e'))
		return "over 1";
	snprintf(text, 16, format, number); /* NOLINT: the formats are literals below */
	return text;
}

/* What the time is. */
static const char *kind(const struct hawser_plan_row *row)
{
	return row->basis == HAWSER_BASIS_NONE ? "" : row->bound ? "bound" : "estimate";
}

/* "0.2 to 0.8", or "over 0.2" where nobody knows the end. */
static const char *span(char text[32], double least, double most)
{
	if (isnan(least))
		return "-";
	if (isfinite(most))
		snprintf(text, 32, "%.2g to %.2g", least, most);
	else
		snprintf(text, 32, "over %.2g", least);
	return text;
}

static void print_foreseen(FILE *stream, const struct hawser_plan *plan)
{
	for (int i = 0; i < plan->rows; i++)
		if (*plan->row[i].foreseen)
			fprintf(stream, "  %s%s: %s\n", plan->row[i].choice.name,
			        plan->row[i].status ? " fails" : "", plan->row[i].foreseen);
	if (isfinite(plan->seconds))
		fprintf(stream, "  this plan itself took %.2g s of processor time\n", plan->seconds);
}

static void print_rows(FILE *stream, const struct cli_plan_result *result)
{
	const struct hawser_plan *plan = &result->plan;

	fputs("\nFidelities (time of this machine's processor, measured where the response is short, else "
	      "estimated, or >= what it takes at least; error estimated)\n", stream);
	fprintf(stream, "  %-20s %8s %8s %9s %7s %9s %-14s %-8s %9s  %s\n", "fidelity", "unknowns", "Q",
	        "C", "points", "time s", "between", "by", "error", "error of the frequencies, from");
	for (int i = 0; i < plan->rows; i++) {
		const struct hawser_plan_row *row = &plan->row[i];
		char text[3][16], between[32];

		fprintf(stream, "  %-20s %8d %8ld %9ld %7s %2s%7s %-14s %-8s %9s  %s\n", row->choice.name,
		        row->n, row->quads, row->cubics, figure(text[0], "%.0f", row->points),
		        row->bound ? ">=" : "", figure(text[1], "%.2g", row->seconds),
		        span(between, row->least, row->most),
		        hawser_plan_basis_name(row->basis), figure(text[2], "%.1e", row->omega_error),
		        row->why);
	}
	print_foreseen(stream, plan);
}

static void print_settings(FILE *stream, const struct cli_plan_result *result)
{
	struct cli_setting setting[CLI_SETTINGS];
	int count = cli_plan_settings(setting, result);

	fputs("\nSettings in use\n", stream);
	for (int i = 0; i < count; i++) {
		char value[128];

		snprintf(value, sizeof value, "%s%s%s", setting[i].value, *setting[i].unit ? " " : "",
		         setting[i].unit);
		fprintf(stream, "  %-26s %-24s %-8s %s\n", setting[i].name, value,
		        setting[i].written ? "yours" : "default", setting[i].doc);
	}
}

void cli_plan_print(FILE *stream, const struct cli_plan_result *result)
{
	double unit = cli_per_omega(result->model);

	fprintf(stream, "hawser %s plan: %s\nresponse over Omega from %.6g to %.6g rad/s\n",
	        hawser_version(), result->model->scene.name, result->plan.from*unit,
	        result->plan.to*unit);
	print_decisions(stream, result);
	print_modes(stream, result);
	print_resonances(stream, result);
	print_rows(stream, result);
	print_settings(stream, result);
}

/* --- table: the fidelities; the rest as comments --- */

static void number_or_blank(struct hawser__table *table, double number)
{
	if (isfinite(number))
		hawser__table_number(table, number);
	else
		hawser__table_word(table, isinf(number) ? "missing" : "");
}

void cli_plan_table(struct hawser__table *table, const void *of)
{
	const struct cli_plan_result *result = of;
	static const char *const column[] = {"fidelity", "unknowns", "Q_entries", "C_entries", "points",
	                                     "time_s", "least_time_s", "most_time_s", "time_by",
	                                     "time_is", "Omega_error", "worst_mode"};
	const struct hawser_plan *plan = &result->plan;
	struct cli_setting setting[CLI_SETTINGS];
	int settings = cli_plan_settings(setting, result);

	cli_echo_table(table, result->common, "plan", &result->model->scene,
	               "Omega_error is an estimate; time_s is measured where time_by is run, and the least "
	               "time where time_is is bound");
	hawser__table_comment(table, "range: Omega from %.12g to %.12g rad/s",
	                      plan->from*cli_per_omega(result->model),
	                      plan->to*cli_per_omega(result->model));
	for (int i = 0; i < plan->decisions; i++)
		hawser__table_comment(table, "%s: %s: %s",
		                      plan->decision[i].modelled ? "modelled" : "left out",
		                      plan->decision[i].subject, plan->decision[i].why);
	for (int i = 0; i < settings; i++)
		hawser__table_comment(table, "%s: %s = %s%s%s", setting[i].written ? "yours" : "default",
		                      setting[i].name, setting[i].value, *setting[i].unit ? " " : "",
		                      setting[i].unit);
	for (int i = 0; i < plan->rows; i++)
		if (*plan->row[i].foreseen)
			hawser__table_comment(table, "%s%s: %s", plan->row[i].choice.name,
			                      plan->row[i].status ? " fails" : "", plan->row[i].foreseen);
	if (isfinite(plan->seconds))
		hawser__table_comment(table, "plan's own processor time: %.2g s", plan->seconds);
	for (size_t i = 0; i < sizeof column/sizeof *column; i++)
		hawser__table_column(table, "%s", column[i]);
	for (int i = 0; i < plan->rows; i++) {
		const struct hawser_plan_row *row = &plan->row[i];

		hawser__table_word(table, row->choice.name);
		hawser__table_number(table, row->n);
		hawser__table_number(table, (double)row->quads);
		hawser__table_number(table, (double)row->cubics);
		number_or_blank(table, row->points);
		number_or_blank(table, row->seconds);
		number_or_blank(table, row->least);
		number_or_blank(table, isinf(row->most) ? NAN : row->most);
		hawser__table_word(table, hawser_plan_basis_name(row->basis));
		hawser__table_word(table, kind(row));
		number_or_blank(table, row->omega_error);
		number_or_blank(table, row->worst < 0 ? NAN : (double)row->worst + 1.0);
	}
}

/* --- JSON --- */

static void number_or_null(struct hawser__json *json, json_t *into, const char *key, double number)
{
	if (isfinite(number))
		hawser__json_number(json, into, key, number);
	else if (isinf(number))
		hawser__json_text(json, into, key, "missing");
	else
		hawser__json_null(json, into, key);
}

static void decisions_json(struct hawser__json *json, const struct hawser_plan *plan)
{
	json_t *list = hawser__json_array(json, json->root, "decisions");

	for (int i = 0; i < plan->decisions; i++) {
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_text(json, row, "subject", plan->decision[i].subject);
		hawser__json_flag(json, row, "modelled", plan->decision[i].modelled);
		hawser__json_text(json, row, "why", plan->decision[i].why);
	}
}

static void modes_json(struct hawser__json *json, const struct cli_plan_result *result)
{
	const struct hawser_plan *plan = &result->plan;
	json_t *list = hawser__json_array(json, json->root, "modes");

	for (int j = 0; j < plan->modes.n; j++) {
		const struct hawser_mode *mode = &plan->modes.mode[j];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_integer(json, row, "index", j + 1);
		hawser__json_number(json, row, "omega", mode->omega*cli_per_omega(result->model));
		hawser__json_text(json, row, "plane", hawser_plane_name(mode->plane));
		hawser__json_text(json, row, "symmetry", hawser_symmetry_name(mode->symmetry));
		hawser__json_flag(json, row, "driven", is_driven(result, j));
		hawser__json_flag(json, row, "kept", plan->mode[j].kept);
		if (!plan->chosen)
			continue;
		hawser__json_flag(json, row, "worth", plan->mode[j].worth);
		hawser__json_text(json, row, "reason", hawser_reason_name(plan->mode[j].reason));
		number_or_null(json, row, "measure", plan->mode[j].measure);
	}
}

static void resonances_json(struct hawser__json *json, const struct cli_plan_result *result)
{
	json_t *list = hawser__json_array(json, json->root, "resonances");

	for (int i = 0; i < result->plan.resonances; i++) {
		const struct hawser_plan_resonance *at = &result->plan.resonance[i];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_integer(json, row, "mode", at->mode + 1);
		hawser__json_number(json, row, "omega", at->omega*cli_per_omega(result->model));
		hawser__json_number(json, row, "peak_Omega",
		                    at->peak_omega*cli_per_omega(result->model));
		hawser__json_number(json, row, "motion", at->motion*cli_per_length(result->model));
		hawser__json_integer(json, row, "folds", at->folds);
		hawser__json_number(json, row, "cubic", at->cubic);
		hawser__json_number(json, row, "cubic_unlocked", at->unlocked);
		number_or_null(json, row, "cubic_doubt", at->doubt);
		if (at->partner < 0) {
			hawser__json_null(json, row, "meets");
			continue;
		}
		hawser__json_integer(json, row, "meets", at->partner + 1);
		hawser__json_integer(json, row, "order", at->order);
	}
}

static void rows_json(struct hawser__json *json, const struct hawser_plan *plan)
{
	json_t *list = hawser__json_array(json, json->root, "fidelities");

	for (int i = 0; i < plan->rows; i++) {
		const struct hawser_plan_row *at = &plan->row[i];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_text(json, row, "name", at->choice.name);
		hawser__json_text(json, row, "family", at->choice.fidelity->name);
		hawser__json_number(json, row, "number", at->choice.number);
		hawser__json_integer(json, row, "unknowns", at->n);
		hawser__json_integer(json, row, "Q_entries", at->quads);
		hawser__json_integer(json, row, "C_entries", at->cubics);
		number_or_null(json, row, "points", at->points);
		number_or_null(json, row, "time_secs", at->seconds);
		number_or_null(json, row, "least_time_secs", at->least);
		number_or_null(json, row, "most_time_secs", isinf(at->most) ? NAN : at->most);
		hawser__json_text(json, row, "time_by", hawser_plan_basis_name(at->basis));
		hawser__json_text(json, row, "time_is", kind(at));
		hawser__json_flag(json, row, "fails", at->status != HAWSER_OK);
		hawser__json_text(json, row, "foreseen", at->foreseen);
		number_or_null(json, row, "Omega_error", at->omega_error);
		if (at->worst < 0)
			hawser__json_null(json, row, "worst_mode");
		else
			hawser__json_integer(json, row, "worst_mode", at->worst + 1);
		hawser__json_text(json, row, "why", at->why);
	}
}

static void settings_json(struct hawser__json *json, const struct cli_plan_result *result)
{
	struct cli_setting setting[CLI_SETTINGS];
	int count = cli_plan_settings(setting, result);
	json_t *list = hawser__json_array(json, json->root, "settings");

	for (int i = 0; i < count; i++) {
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_text(json, row, "name", setting[i].name);
		hawser__json_text(json, row, "value", setting[i].value);
		hawser__json_text(json, row, "unit", setting[i].unit);
		hawser__json_text(json, row, "by", setting[i].written ? "user" : "default");
		hawser__json_text(json, row, "doc", setting[i].doc);
	}
}

void cli_plan_json(struct hawser__json *json, const void *of)
{
	const struct cli_plan_result *result = of;

	cli_echo_json(json, result->common, "plan", &result->model->scene);
	hawser__json_number(json, json->root, "from", result->plan.from*cli_per_omega(result->model));
	hawser__json_number(json, json->root, "to", result->plan.to*cli_per_omega(result->model));
	decisions_json(json, &result->plan);
	modes_json(json, result);
	resonances_json(json, result);
	rows_json(json, &result->plan);
	number_or_null(json, json->root, "own_time_secs", result->plan.seconds);
	settings_json(json, result);
	cli_stats_json(json, result->common);
}

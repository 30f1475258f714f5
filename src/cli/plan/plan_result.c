/* cli/plan/plan_result.c - see plan_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/plan/plan_result.h"

void cli_plan_forget_times(struct hawser_plan *plan)
{
	plan->seconds = NAN;
	for (int i = 0; i < plan->rows; i++) {
		struct hawser_plan_row *row = &plan->row[i];

		row->seconds = row->least = row->most = NAN;
	}
}

/* --- settings --- */

/* "[0.8, 0.8, 0.8]", or "" if the scene has no such list. */
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
		if (length + 32 < size)
			length += (size_t)snprintf(text + length, size - length, "%s%.10g",
			                           i ? ", " : "[", value);
	}
	if (i > 0)
		snprintf(text + length, size - length, length + 32 < size ? "]" : ", ...]");
	return i > 0;
}

/* The scene's value of a key as text; returns 0 if it has none. */
static int key_text(char *text, size_t size, const struct hawser_scene *scene,
                    const struct hawser_scene_key *key)
{
	char word[HAWSER_WORD_SIZE];
	double value;

	if (strncmp(key->type, "numbers", 7) == 0 ||
	    (strcmp(key->type, "series") == 0 &&
	     hawser_scene_get(scene, &value, key->path, NULL) != HAWSER_OK))
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

/* Settings of the response: the defaults of hawser frf and hawser compare. */
static int response_settings(struct cli_setting *setting, int count)
{
	static const char *const name[] = {"--tolerance", "--step", "--max-points", "--segments",
	                                   "--method"};
	static const char *const doc[] = {
		"residual and integration error of an orbit, relative to its size",
		"longest step along the response, as a part of the range",
		"end of a curve", "of the period, in shooting", "for periodic orbits"};
	struct hawser_frf_options options = {.method = NULL};

	hawser_frf_settle(&options);
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
	const struct hawser_scene_key *key;
	int count = 0;

	for (int i = 0; count < CLI_SETTINGS - 8 && (key = hawser_scene_key(i)); i++) {
		struct cli_setting *now = &setting[count];

		*now = (struct cli_setting){.unit = strcmp(key->unit, "1") ? key->unit : "",
		                            .doc = key->doc,
		                            .written = hawser_scene_written(scene, key->path)};
		snprintf(now->name, sizeof now->name, "%s", key->path);
		count += key_text(now->value, sizeof now->value, scene, key);
	}
	return response_settings(setting, count);
}

/* --- text --- */

/* A sentence with its numbers in the chosen units. */
static void print_text(FILE *stream, const char *text)
{
	char *shown = hawser__units_text(text);

	fputs(shown ? shown : text, stream);
	free(shown);
}

void cli_plan_print_decisions(FILE *stream, const struct cli_plan_result *result)
{
	fputs("\nModelled\n", stream);
	for (int i = 0; i < result->plan.decisions; i++) {
		const struct hawser_plan_decision *decision = &result->plan.decision[i];

		fprintf(stream, "  %-4s %-34s ", decision->modelled ? "yes" : "no", decision->subject);
		print_text(stream, decision->why);
		fputc('\n', stream);
	}
}

/* Modes up to the last one that is kept or that the accuracy requires. */
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
	const struct hawser__shown_unit omega = hawser__shown_unit("rad/s");
	double unit = cli_per_omega(result->model)/omega.per;
	int shown = modes_shown(plan);
	char head[HAWSER__UNIT_SIZE + 8];

	snprintf(head, sizeof head, "omega %s", omega.name);
	fprintf(stream, "\nModes, %d of %d looked at; kept in the scene's model, or worth it for "
	        "model.accuracy %g\n  %4s %12s  %-13s %-14s %-4s %-5s %-13s %s\n", shown, plan->modes.n,
	        result->model->scene.model.accuracy, "mode", head, "plane", "symmetry", "kept",
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
	const struct hawser__shown_unit omega = hawser__shown_unit("rad/s");
	const struct hawser__shown_unit length = hawser__shown_unit("m");
	double unit = cli_per_omega(result->model)/omega.per;
	char head[3][HAWSER__UNIT_SIZE + 8];

	snprintf(head[0], sizeof head[0], "omega %s", omega.name);
	snprintf(head[1], sizeof head[1], "peak %s", omega.name);
	snprintf(head[2], sizeof head[2], "motion %s", length.name);
	fprintf(stream, "\nPrimary resonances in the range, each alone (estimates)\n"
	        "  %4s %12s %12s %8s %6s %11s %11s  %s\n", "mode", head[0], head[1],
	        head[2], "folds", "cubic", "unlocked", "meets");
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
		        at->omega*unit, at->peak_omega*unit,
		        at->motion*cli_per_length(result->model)/length.per,
		        at->folds, at->cubic, at->unlocked, meets);
	}
}

/* "-" if there is no number. */
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

/* "0.2 to 0.8" */
static const char *span(char text[32], double least, double most)
{
	if (isnan(least))
		return "-";
	snprintf(text, 32, "%.2g to %.2g", least, most);
	return text;
}

static void print_foreseen(FILE *stream, const struct hawser_plan *plan)
{
	for (int i = 0; i < plan->rows; i++)
		if (*plan->row[i].foreseen) {
			fprintf(stream, "  %s%s: ", plan->row[i].choice.name, plan->row[i].status ? " fails" : "");
			print_text(stream, plan->row[i].foreseen);
			fputc('\n', stream);
		}
	if (isfinite(plan->seconds))
		fprintf(stream, "  this plan itself took %.2g s of processor time\n", plan->seconds);
}

static void print_rows(FILE *stream, const struct cli_plan_result *result)
{
	const struct hawser_plan *plan = &result->plan;

	fputs("\nFidelities (time of this machine's processor and error, estimated by formulas)\n", stream);
	fprintf(stream, "  %-20s %8s %8s %9s %7s %7s %-14s %9s  %s\n", "fidelity", "unknowns", "Q", "C",
	        "points", "time s", "between", "error", "of folds and peaks, from");
	for (int i = 0; i < plan->rows; i++) {
		const struct hawser_plan_row *row = &plan->row[i];
		char text[3][16], between[32];

		fprintf(stream, "  %-20s %8d %8ld %9ld %7s %7s %-14s %9s  %s\n", row->choice.name, row->n,
		        row->quads, row->cubics, figure(text[0], "%.0f", row->points),
		        figure(text[1], "%.2g", row->seconds), span(between, row->least, row->most),
		        figure(text[2], "%.1e", row->omega_error), row->why);
	}
	print_foreseen(stream, plan);
}

/* The numbers of a setting, "80000" or "[0, 0.8]", in the chosen unit. */
static void in_unit(char *text, size_t size, const struct cli_setting *setting)
{
	const struct hawser__shown_unit shown = hawser__shown_unit(setting->unit);
	size_t used = 0;

	*text = '\0';
	for (const char *c = setting->value; *c && used + 1 < size;) {
		char *end = NULL;
		double number = shown.changed ? strtod(c, &end) : 0.0;

		if (end && end > c && isfinite(number)) {
			used += (size_t)snprintf(text + used, size - used, "%s%.10g", *c == ' ' ? " " : "",
			                         number/shown.per);
			c = end;
		} else {
			text[used++] = *c++;
			text[used] = '\0';
		}
	}
	if (*setting->unit && used < size)
		snprintf(text + used, size - used, " %s", shown.name);
}

static void print_settings(FILE *stream, const struct cli_plan_result *result)
{
	struct cli_setting setting[CLI_SETTINGS];
	int count = cli_plan_settings(setting, result);

	fputs("\nSettings in use\n", stream);
	for (int i = 0; i < count; i++) {
		char value[192];

		in_unit(value, sizeof value, &setting[i]);
		fprintf(stream, "  %-26s %-24s %-8s %s\n", setting[i].name, value,
		        setting[i].written ? "yours" : "default", setting[i].doc);
	}
}

void cli_plan_print(FILE *stream, const struct cli_plan_result *result)
{
	const struct hawser__shown_unit omega = hawser__shown_unit("rad/s");
	double unit = cli_per_omega(result->model)/omega.per;

	fprintf(stream, "hawser %s plan: %s\nresponse over Omega from %.6g to %.6g %s\n",
	        hawser_version(), result->model->scene.name, result->plan.from*unit,
	        result->plan.to*unit, omega.name);
	cli_plan_print_decisions(stream, result);
	print_modes(stream, result);
	print_resonances(stream, result);
	print_rows(stream, result);
	print_settings(stream, result);
}

/* cli/sweep/sweep_result.c - the table of a sweep, and its JSON: packed results are taken apart where
 * they are, and rows and elements are made from them on output. See sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep.h"
#include "cli/frame/view.h"
#include "core/grow.h"
#include "core/report.h"

enum { COMMENTS = 20 }; /* failures in the comments of the table; JSON has all */

/* --- taking apart --- */

static int place_of(struct cli_sweep_result *result, const char *name)
{
	for (int c = 0; c < result->columns; c++)
		if (strcmp(result->column[c], name) == 0)
			return c;
	if (hawser__more(&result->column, result->columns, sizeof *result->column))
		return -1;
	result->column[result->columns] = strdup(name);
	return result->column[result->columns] ? result->columns++ : -1;
}

static int count_tabs(const char *text)
{
	int count = 0;

	for (; *text; text++)
		count += *text == '\t';
	return count;
}

/* The columns of the line C; NULL without memory. */
static struct cli_sweep_head *head_of(struct cli_sweep_result *result, const char *text)
{
	struct cli_sweep_head *head = result->head;
	char *copy, *rest;

	while (head && strcmp(head->text, text) != 0)
		head = head->next;
	if (head)
		return head;
	head = calloc(1, sizeof *head);
	if (!head)
		return NULL;
	head->next = result->head;
	result->head = head;
	head->columns = count_tabs(text) + 1;
	head->text = strdup(text);
	head->place = calloc((size_t)head->columns, sizeof *head->place);
	copy = rest = strdup(text);
	for (int c = 0; c < head->columns && head->place && copy; c++)
		head->place[c] = place_of(result, strsep(&rest, "\t"));
	for (int c = 0; c < head->columns && head->place && copy; c++)
		if (head->place[c] < 0)
			head->columns = 0;
	free(copy);
	return head->text && head->place && copy && head->columns > 0 ? head : NULL;
}

/* The cells of a row end with NUL, not with a tab. */
static void split_cells(char *text)
{
	for (; *text; text++)
		if (*text == '\t')
			*text = '\0';
}

static enum hawser_status take_apart(struct cli_sweep_result *result, long variation, char *text,
                                     struct hawser_report *report)
{
	const struct cli_sweep_head *head = NULL;
	long before = result->lines;

	while (text && *text) {
		char *line = text, *end = strchr(text, '\n');

		text = end ? end + 1 : NULL;
		if (end)
			*end = '\0';
		if (*line == 'S')
			result->status[variation] = hawser_status_exit(cli_sweep_status(line));
		else if (*line == 'M')
			result->message[variation] = line + 2;
		else if (*line == 'W' && !result->warning[variation])
			result->warning[variation] = line + 2;
		else if (*line == 'C' && !(head = head_of(result, line + 2)))
			return hawser__no_memory(report, "sweep");
		else if (*line == 'R') {
			result->line[result->lines++] = (struct cli_sweep_line){variation, line + 2, head};
			split_cells(line + 2);
		}
	}
	if (result->lines == before)
		result->line[result->lines++] = (struct cli_sweep_line){.variation = variation};
	result->failed += result->status[variation] != 0;
	result->warned += result->warning[variation] != NULL;
	return HAWSER_OK;
}

enum hawser_status cli_sweep_result_open(struct cli_sweep_result *result, struct cli_study *sweep,
                                         struct hawser_report *report)
{
	size_t count = (size_t)sweep->plan.count, lines = count;
	enum hawser_status status = HAWSER_OK;

	result->sweep = sweep;
	for (size_t i = 0; i < count; i++)
		for (const char *at = sweep->packed[i].text; (at = strstr(at, "\nR ")) != NULL; at++)
			lines++;
	result->line = calloc(lines, sizeof *result->line);
	result->status = calloc(count, sizeof *result->status);
	result->message = calloc(count, sizeof *result->message);
	result->warning = calloc(count, sizeof *result->warning);
	if (!result->line || !result->status || !result->message || !result->warning)
		return hawser__no_memory(report, "sweep");
	for (long i = 0; i < sweep->plan.count && !status; i++)
		status = take_apart(result, i, sweep->packed[i].text, report);
	return status;
}

void cli_sweep_result_clear(struct cli_sweep_result *result)
{
	while (result->head) {
		struct cli_sweep_head *next = result->head->next;

		free(result->head->text);
		free(result->head->place);
		free(result->head);
		result->head = next;
	}
	for (int c = 0; c < result->columns; c++)
		free(result->column[c]);
	free(result->column);
	free(result->line);
	free(result->status);
	free((void *)result->message);
	free((void *)result->warning);
	memset(result, 0, sizeof *result);
}

/* --- cells --- */

/* cell [columns] of the result: texts, NULL for none. */
static void cells_of(const char **cell, const struct cli_sweep_result *result,
                     const struct cli_sweep_line *line)
{
	const char *text = line->cell;

	for (int c = 0; c < result->columns; c++)
		cell[c] = NULL;
	for (int c = 0; text && c < line->head->columns; c++) {
		cell[line->head->place[c]] = *text ? text : NULL;
		text += strlen(text) + 1;
	}
}

double cli_sweep_number(const struct cli_sweep_line *line, int column)
{
	const char *text = line->cell;

	for (int c = 0; text && c < line->head->columns; c++) {
		if (line->head->place[c] == column)
			return *text && !strchr("'tf", *text) ? strtod(text, NULL) : NAN;
		text += strlen(text) + 1;
	}
	return NAN;
}

/* --- the table --- */

static const char *value_of(const struct cli_sweep_plan *plan, int k, long variation)
{
	return plan->key[k].text ? plan->key[k].text[cli_sweep_at(plan, k, variation)] : "";
}

static void fill_row(struct hawser__table *row, const void *context, size_t index)
{
	const struct cli_sweep_result *result = context;
	const struct cli_sweep_plan *plan = &result->sweep->plan;
	const struct cli_sweep_line *line = &result->line[index];
	const char **cell = calloc((size_t)result->columns + 1, sizeof *cell);

	row->failed |= !cell;
	if (!cell)
		return;
	for (int k = 0; k < plan->keys; k++)
		if (plan->key[k].numbers)
			hawser__table_number(row, plan->key[k].number[cli_sweep_at(plan, k, line->variation)]);
		else
			hawser__table_word(row, value_of(plan, k, line->variation));
	hawser__table_number(row, result->status[line->variation]);
	cells_of(cell, result, line);
	for (int c = 0; c < result->columns; c++)
		if (!cell[c])
			hawser__table_word(row, "");
		else if (*cell[c] == '\'')
			hawser__table_word(row, cell[c] + 1);
		else if (*cell[c] == 't' || *cell[c] == 'f')
			hawser__table_number(row, *cell[c] == 't');
		else
			hawser__table_number(row, strtod(cell[c], NULL));
	free(cell);
}

static void failures(struct hawser__table *table, const struct cli_sweep_result *result)
{
	long count = result->sweep->plan.count, shown = 0, first = -1;
	char name[400];

	hawser__table_remark(table, "variations: %ld, of which %ld without result (status: the exit status "
	                     "of each)", count, result->failed);
	for (long i = 0; i < count && shown < COMMENTS; i++)
		if (result->message[i]) {
			cli_sweep_name(name, sizeof name, &result->sweep->plan, i);
			hawser__table_remark(table, "%s: %s", name, result->message[i]);
			shown++;
		}
	if (result->failed > shown)
		hawser__table_remark(table, "without result: %ld more; JSON says why", result->failed - shown);
	for (long i = 0; i < count && first < 0; i++)
		first = result->warning[i] ? i : -1;
	if (first < 0)
		return;
	cli_sweep_name(name, sizeof name, &result->sweep->plan, first);
	hawser__table_remark(table, "variations with a warning: %ld; the first, %s: %s", result->warned,
	                     name, result->warning[first]);
}

static void add_columns(struct hawser__table *table, const struct cli_sweep_result *result)
{
	const struct cli_sweep_plan *plan = &result->sweep->plan;

	for (int k = 0; k < plan->keys; k++) {
		hawser__table_column(table, "%s", plan->key[k].column);
		hawser__table_about(table, plan->key[k].key, "", "", plan->key[k].unit);
	}
	hawser__table_column(table, "status");
	hawser__table_about(table, "status", "", "exit status", "");
	for (int c = 0; c < result->columns; c++) {
		const char *name = result->column[c];
		enum hawser__unit unit = hawser__unit_of_column(name);
		size_t end = strlen(hawser__unit_suffix(unit, &hawser__si));
		char bare[HAWSER__NAME_SIZE];

		hawser__table_column(table, "%s", name);
		snprintf(bare, sizeof bare, "%.*s", (int)(strlen(name) - end), name);
		hawser__table_about(table, bare, "", "", hawser__unit_name(unit));
	}
}

static void table(struct hawser__table *table, const void *of)
{
	const struct cli_sweep_result *result = of;
	const struct cli_study *sweep = result->sweep;

	hawser__units_elsewhere();
	hawser__table_comment(table, "hawser %s sweep", hawser_version());
	hawser__table_remark(table, "scene: %s", sweep->common->input);
	for (int i = 0; i < sweep->common->sets; i++)
		hawser__table_remark(table, "set: %s", sweep->common->set[i]);
	hawser__table_remark(table, "command: %s", sweep->line);
	failures(table, result);
	add_columns(table, result);
	hawser__table_rows(table, (size_t)result->lines, fill_row, result);
}

/* --- JSON --- */

static void put_key(struct hawser__json *json, json_t *into, const char *name,
                    const struct cli_sweep_plan *plan, int k, long variation)
{
	if (plan->key[k].numbers)
		hawser__json_number(json, into, name, plan->key[k].number[cli_sweep_at(plan, k, variation)]);
	else
		hawser__json_text(json, into, name, value_of(plan, k, variation));
}

static void put_cell(struct hawser__json *json, json_t *into, const char *name, const char *cell)
{
	if (!cell)
		hawser__json_null(json, into, name);
	else if (*cell == '\'')
		hawser__json_text(json, into, name, cell + 1);
	else if (*cell == 't' || *cell == 'f')
		hawser__json_flag(json, into, name, *cell == 't');
	else if (cell[strspn(cell, "-0123456789")] == '\0' && strlen(cell) < 16)
		hawser__json_integer(json, into, name, strtol(cell, NULL, 10));
	else
		hawser__json_number(json, into, name, strtod(cell, NULL));
}

static void row_json(struct hawser__json *json, json_t *list, const void *context, int part,
                     size_t index)
{
	const struct cli_sweep_result *result = context;
	const struct cli_sweep_plan *plan = &result->sweep->plan;
	const struct cli_sweep_line *line = &result->line[index];
	const char **cell = calloc((size_t)result->columns + 1, sizeof *cell);
	json_t *row = hawser__json_object(json, list, NULL);

	(void)part;
	if (!cell) {
		json->status = hawser__no_memory(&json->report, "json");
		return;
	}
	for (int k = 0; k < plan->keys; k++)
		put_key(json, row, plan->key[k].column, plan, k, line->variation);
	hawser__json_integer(json, row, "status", result->status[line->variation]);
	cells_of(cell, result, line);
	for (int c = 0; c < result->columns; c++)
		put_cell(json, row, result->column[c], cell[c]);
	free(cell);
}

/* Variations with a message of this kind. */
static void messages_json(struct hawser__json *json, const char *name,
                          const struct cli_sweep_result *result, const char *const *message)
{
	const struct cli_sweep_plan *plan = &result->sweep->plan;
	json_t *list = hawser__json_array(json, json->root, name);

	for (long i = 0; i < plan->count; i++) {
		json_t *one = message[i] ? hawser__json_object(json, list, NULL) : NULL;

		if (!one)
			continue;
		hawser__json_integer(json, one, "variation", i);
		for (int k = 0; k < plan->keys; k++)
			put_key(json, one, plan->key[k].column, plan, k, i);
		hawser__json_integer(json, one, "status", result->status[i]);
		hawser__json_text(json, one, "message", message[i]);
	}
}

static void json(struct hawser__json *json, const void *of)
{
	const struct cli_sweep_result *result = of;
	const struct cli_study *sweep = result->sweep;
	json_t *scene, *list = NULL;

	hawser__json_begin(json);
	hawser__json_text(json, json->root, "command", "sweep");
	hawser__json_text(json, json->root, "version", hawser_version());
	scene = hawser__json_object(json, json->root, "scene");
	hawser__json_text(json, scene, "name", sweep->common->input);
	if (sweep->common->sets > 0)
		list = hawser__json_array(json, scene, "set");
	for (int i = 0; i < sweep->common->sets; i++)
		hawser__json_text(json, list, NULL, sweep->common->set[i]);
	hawser__json_text(json, json->root, "line", sweep->line);
	list = hawser__json_array(json, json->root, "over");
	for (int k = 0; k < sweep->plan.keys; k++) {
		json_t *one = hawser__json_object(json, list, NULL);

		hawser__json_text(json, one, "key", sweep->plan.key[k].key);
		hawser__json_text(json, one, "column", sweep->plan.key[k].column);
		if (*sweep->plan.key[k].unit)
			hawser__json_text(json, one, "unit", sweep->plan.key[k].unit);
	}
	hawser__json_integer(json, json->root, "variations", sweep->plan.count);
	hawser__json_integer(json, json->root, "failed", result->failed);
	hawser__json_list(json, json->root, "rows", (size_t)result->lines, row_json, result, 0);
	messages_json(json, "failures", result, result->message);
	messages_json(json, "warnings", result, result->warning);
	cli_stats_json(json, sweep->common);
}

const struct cli_showing cli_sweep_showing = {.table = table, .json = json, .draw = cli_sweep_draw};

/* cli/sweep/sweep_take.c - columns and rows of the result of one variation: the values of its JSON,
 * the rows of its table, or those of a list of its JSON. See sweep.h.
 *
 * The values of JSON are in SI and have no units in their names. They are written with their
 * units here (visit.h), and get the names and the units (--units) that columns of tables
 * have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep.h"
#include "cli/frame/view.h"
#include "core/append.h"
#include "core/grow.h"
#include "output/fields/visit.h"

enum { NAME = 256, NUMBER = 32 };

/* What is being taken, and from what. */
struct taking {
	struct cli_sweep_rows *rows;
	const struct cli_taken *result;
	const struct cli_sweep_choice *choice;
	const char *list; /* the name of a list with "[0]." behind it, of which a row is taken; or "" */
	int arrays;       /* 1: short arrays are values too */
};

/* --- columns and cells --- */

static int column_of(struct cli_sweep_rows *rows, const char *name, const char *bare, int expected)
{
	struct cli_sweep_column *last;

	if (expected < rows->columns && strcmp(rows->column[expected].name, name) == 0)
		return expected;
	for (int c = 0; c < rows->columns; c++)
		if (strcmp(rows->column[c].name, name) == 0)
			return c;
	if (hawser__more(&rows->column, rows->columns, sizeof *rows->column)) {
		rows->failed = 1;
		return -1;
	}
	last = &rows->column[rows->columns];
	*last = (struct cli_sweep_column){strdup(name), strdup(bare)};
	rows->failed |= !last->name || !last->bare;
	return rows->columns++;
}

static void new_row(struct cli_sweep_rows *rows)
{
	rows->failed |= hawser__more(&rows->row, rows->rows, sizeof *rows->row);
	if (!rows->failed)
		rows->row[rows->rows++] = (struct cli_sweep_row){NULL, 0};
}

/* A cell of the last row. `kind`: what a text begins with, or "". */
static void put(struct cli_sweep_rows *rows, const char *name, const char *bare, const char *kind,
                const char *text)
{
	struct cli_sweep_row *row = rows->failed || rows->rows == 0 ? NULL : &rows->row[rows->rows - 1];
	int column = row ? column_of(rows, name, bare, row->cells) : -1;
	size_t size = strlen(kind) + strlen(text) + 1;

	if (rows->failed || column < 0)
		return;
	for (; column >= row->cells; row->cell[row->cells++] = NULL) {
		rows->failed |= hawser__more(&row->cell, row->cells, sizeof *row->cell);
		if (rows->failed)
			return;
	}
	free(row->cell[column]);
	row->cell[column] = malloc(size);
	rows->failed |= !row->cell[column];
	if (!row->cell[column])
		return;
	snprintf(row->cell[column], size, "%s%s", kind, text);
	for (char *c = row->cell[column]; *c; c++)
		if (*c == '\t' || *c == '\n')
			*c = ' ';
}

/* --- values of JSON --- */

/* The field of a value, of the fields of this result or those of the command. */
static const struct hawser__field *field_of(const struct taking *taking, const char *name)
{
	const struct cli_listing *row = taking->choice->command->listing;
	char place[2*NAME];

	snprintf(place, sizeof place, "%s%s", taking->list, name);
	if (taking->result->fields)
		return hawser__fields_at(taking->result->fields, place);
	for (; row && row->title; row++) {
		const struct hawser__field *field = row->json ? hawser__fields_at(row->field, place) : NULL;

		if (field)
			return field;
	}
	return NULL;
}

/* A number or null with this unit, whose columns end with `suffix`. */
static void put_number(struct taking *taking, const char *name, const json_t *value,
                       const char *unit,
                       const char *suffix)
{
	struct hawser__shown_unit shown = hawser__shown_unit(unit);
	char full[NAME + HAWSER__UNIT_SIZE], end[HAWSER__UNIT_SIZE + 2], text[NUMBER] = "";

	hawser__unit_end(end, sizeof end, shown.name);
	snprintf(full, sizeof full, "%s%s", name, shown.changed ? end : suffix);
	if (!json_is_null(value))
		snprintf(text, sizeof text, json_is_integer(value) ? "%.0f" : "%.17g",
		         json_number_value(value)/shown.per + 0.0);
	put(taking->rows, full, name, "", text);
}

/* A value that was not written with its unit: elements of arrays, and what functions write. */
static void put_plain(struct taking *taking, const char *name, const json_t *value)
{
	const struct hawser__field *field = field_of(taking, name);
	enum hawser__unit unit = field ? field->unit : HAWSER__NONE;
	const char *suffix = hawser__unit_suffix(unit, taking->result->scale);

	put_number(taking, name, value, *suffix ? hawser__unit_name(unit) : "", suffix);
}

static void flatten(struct taking *taking, const char *name, const json_t *value);

/* Members of an object, elements of an array. */
static void flatten_parts(struct taking *taking, const char *name, const json_t *value)
{
	char inner[NAME];
	const char *key;
	json_t *part;
	size_t i;

	json_object_foreach((json_t *)value, key, part) {
		snprintf(inner, sizeof inner, "%s%s%s", name, *name ? "." : "", key);
		flatten(taking, inner, part);
	}
	json_array_foreach((json_t *)value, i, part) {
		snprintf(inner, sizeof inner, "%s[%zu]", name, i);
		flatten(taking, inner, part);
	}
}

static void flatten(struct taking *taking, const char *name, const json_t *value)
{
	const char *unit = json_string_value(json_object_get(value, HAWSER__UNIT_KEY));

	if (unit) {
		put_number(taking, name, json_object_get(value, HAWSER__VALUE_KEY), unit,
		           json_string_value(json_object_get(value, HAWSER__SUFFIX_KEY)));
		return;
	}
	switch (json_typeof(value)) {
	case JSON_REAL:
	case JSON_INTEGER:
	case JSON_NULL:
		put_plain(taking, name, value);
		break;
	case JSON_TRUE:
	case JSON_FALSE:
		put(taking->rows, name, name, json_is_true(value) ? "t" : "f", "");
		break;
	case JSON_STRING:
		put(taking->rows, name, name, "'", json_string_value(value));
		break;
	case JSON_ARRAY:
		if (!taking->arrays)
			break;
		/* fall through */
	case JSON_OBJECT:
		flatten_parts(taking, name, value);
	}
}

/* The element of an array with this number or `name`. */
static json_t *element(struct hawser__json *json, json_t *array, const char *which, size_t length)
{
	char text[NAME], *end;
	unsigned long number;
	json_t *one;
	size_t i;

	snprintf(text, sizeof text, "%.*s", (int)length, which);
	hawser__json_elements(json, array);
	number = strtoul(text, &end, 10);
	if (end != text && !*end)
		return json_array_get(array, number);
	json_array_foreach(array, i, one) {
		const char *name = json_string_value(json_object_get(one, "name"));

		if (name && strcmp(name, text) == 0)
			return one;
	}
	return NULL;
}

/* The value at a place such as "counterweight.force", "modes[0].frequency",
 * "towers[T1].reaction". */
static json_t *value_at(struct hawser__json *json, const char *place)
{
	json_t *value = json->root;

	while (value && *place) {
		size_t length = strcspn(place, *place == '[' ? "]" : ".[");
		char key[NAME];

		if (*place == '[') {
			value = element(json, value, place + 1, length - 1);
			place += length + (place[length] == ']');
		} else {
			snprintf(key, sizeof key, "%.*s", (int)length, place);
			value = json_object_get(value, key);
			place += length;
		}
		place += *place == '.';
	}
	return value;
}

/* Members that say how the result was made, or that are no values of it. */
static int is_head(const char *key)
{
	static const char *const head[] = {"command", "version", "scene", "stats", "warnings"};

	for (size_t i = 0; i < sizeof head/sizeof *head; i++)
		if (strcmp(key, head[i]) == 0)
			return 1;
	return 0;
}

static int has_column(const struct cli_sweep_rows *rows, const char *name)
{
	for (int c = 0; c < rows->columns; c++)
		if (strcmp(rows->column[c].name, name) == 0 || strcmp(rows->column[c].bare, name) == 0)
			return 1;
	return 0;
}

/* All values but arrays; of arrays what --keep names. */
static void take_values(struct taking *taking)
{
	const struct cli_sweep_choice *choice = taking->choice;
	const char *key;
	json_t *value;

	new_row(taking->rows);
	json_object_foreach(taking->result->json->root, key, value)
		if (!is_head(key))
			flatten(taking, key, value);
	taking->arrays = 1;
	for (int k = 0; k < choice->keeps; k++) {
		value = has_column(taking->rows, choice->keep[k])
			? NULL : value_at(taking->result->json, choice->keep[k]);
		if (value)
			flatten(taking, choice->keep[k], value);
	}
}

/* The names of lists, "modes, events". */
static void list_names(char *text, size_t size, const json_t *root)
{
	const char *key;
	json_t *value;

	*text = '\0';
	json_object_foreach((json_t *)root, key, value) {
		int plain = json_array_size(value) > 0 && !json_is_object(json_array_get(value, 0));

		if (json_is_array(value) && !is_head(key) && !plain)
			hawser__append(text, size, ", ", "%s", key);
	}
}

/* A row for each element of a list. */
static void take_list(struct taking *taking)
{
	struct hawser__json *json = taking->result->json;
	const char *name = taking->choice->rows;
	json_t *list = value_at(json, name), *one;
	char names[200], within[NAME];
	size_t i;

	if (!json_is_array(list)) {
		list_names(names, sizeof names, json->root);
		cli_sweep_miss(taking->rows, "--rows %s: the result of %s has no such list; there is table%s%s",
		               name, taking->choice->command->name, *names ? ", " : "", names);
		return;
	}
	snprintf(within, sizeof within, "%s[0].", name);
	taking->list = within;
	taking->arrays = 1;
	hawser__json_elements(json, list);
	json_array_foreach(list, i, one) {
		new_row(taking->rows);
		if (json_is_object(one))
			flatten_parts(taking, "", one);
		else
			flatten(taking, name, one);
	}
	taking->list = "";
}

/* --- the table --- */

static int take_row(void *to, const struct hawser__cell *cell, size_t columns)
{
	struct taking *taking = to;
	const struct hawser__table *table = taking->result->table;
	char number[NUMBER];

	new_row(taking->rows);
	for (size_t c = 0; c < columns; c++) {
		const char *word = cell[c].word;

		snprintf(number, sizeof number, "%.17g", cell[c].number);
		put(taking->rows, table->column[c], table->column[c], word && *word ? "'" : "",
		    word ? word : number);
	}
	return taking->rows->failed;
}

void cli_sweep_take(struct cli_sweep_rows *rows, const struct cli_taken *result,
                    const struct cli_sweep_choice *choice)
{
	struct taking taking = {.rows = rows, .result = result, .choice = choice, .list = ""};
	struct hawser__visitor by = {take_row, &taking};

	cli_sweep_rows_clear(rows); /* of a command that shows two results, the last */
	if (strcmp(choice->rows, "table") == 0) {
		for (int c = 0; c < result->table->columns; c++) {
			const char *key = json_string_value(json_object_get(
				json_array_get(result->table->about, (size_t)c), "key"));

			(void)column_of(rows, result->table->column[c], key ? key : result->table->column[c], c);
		}
		rows->failed |= hawser__table_visit(result->table, &by) != 0;
	} else if (strcmp(choice->rows, "values") == 0) {
		take_values(&taking);
	} else {
		take_list(&taking);
	}
	if (!rows->failed && !rows->missing)
		cli_sweep_choose(rows, choice);
}

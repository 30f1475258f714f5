/* scene/tree_fill.c - values of a tree by the table of keys, into structures.
 *
 * A value may have several forms, each a row of the same path: a word or a number, a number or a list.
 * The row whose form fits is taken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "scene/tree_keys.h"

/* The next row of this path after `row` (NULL: the first one), or NULL. */
static const struct hawser__tree_key *next(const struct hawser__tree_key *row, const char *path)
{
	const struct hawser__tree_table *table = hawser__tree_table(path);

	for (row = row ? row + 1 : table->row; row < table->row + table->rows; row++)
		if (!strcmp(row->path, path))
			return row;
	return NULL;
}

/* The number of a text among words "a|b", or -1. */
static int word_of(const char *text, const char *words)
{
	for (int i = 0; *words; i++) {
		size_t length = strcspn(words, "|");

		if (strlen(text) == length && !strncmp(words, text, length))
			return i;
		words += length + (words[length] == '|');
	}
	return -1;
}

static int fits(const struct hawser__tree_key *row, const struct hawser__tree *tree)
{
	switch (row->type) {
	case HAWSER__TREE_NUMBER:
		return row->count ? tree->kind == HAWSER__SEQUENCE && tree->children == row->count
		                  : tree->kind == HAWSER__SCALAR;
	case HAWSER__TREE_WORD:
		return tree->text && word_of(tree->text, row->unit) >= 0;
	case HAWSER__TREE_MAPPING:
		return tree->kind == HAWSER__MAPPING;
	case HAWSER__TREE_LIST:
		return tree->kind == HAWSER__SEQUENCE;
	default:
		return tree->kind == HAWSER__SCALAR;
	}
}

/* "a number, or a list of 2 numbers in N": the forms of a value. */
static void forms_of(char *text, size_t size, const char *path)
{
	*text = '\0';
	for (const struct hawser__tree_key *row = next(NULL, path), *after; row; row = after) {
		const char *between;

		after = next(row, path);
		between = after ? ", " : ", or ";
		if (row->count && row->type != HAWSER__TREE_WORD)
			hawser__append(text, size, between, "a list of %d numbers", row->count);
		else
			hawser__append(text, size, between, "%s",
			               row->type == HAWSER__TREE_WORD ? row->unit
			               : row->type == HAWSER__TREE_MAPPING ? "a mapping"
			               : row->type == HAWSER__TREE_LIST ? "a list"
			               : row->type == HAWSER__TREE_TEXT ? "a name" : "a number");
		if (row->type == HAWSER__TREE_NUMBER && strcmp(row->unit, "1") != 0)
			hawser__append(text, size, " ", "in %s", row->unit);
	}
}

/* The form of a value of this path. */
static enum hawser_status form_of(struct hawser__reader *reader, const struct hawser__tree_key **form,
                                  const struct hawser__tree *tree, const char *what, const char *path)
{
	const struct hawser__tree_key *scalar = NULL;
	char forms[HAWSER__TEXT_ROOM], shown[HAWSER__SHOWN];
	int words = 0, rows = 0;

	for (*form = next(NULL, path); *form && !fits(*form, tree); *form = next(*form, path)) {
		rows++;
		words |= (*form)->type == HAWSER__TREE_WORD;
	}
	scalar = *form;
	if (scalar && !(words && scalar->type == HAWSER__TREE_NUMBER && tree->text &&
	                isalpha((unsigned char)*tree->text)))
		return HAWSER_OK;
	*form = next(NULL, path);
	if (rows == 1 && !scalar) /* what reads this form says what is wrong */
		return HAWSER_OK;
	forms_of(forms, sizeof forms, path);
	return hawser__reader_fail(reader, &tree->at, "%s%s%s%s must be %s", what, tree->text ? ": \"" : "",
	                           tree->text ? hawser__shown(shown, tree->text) : "",
	                           tree->text ? "\"" : "", forms);
}

static enum hawser_status whole(struct hawser__reader *reader, int *value,
                                const struct hawser__tree *tree, const char *what,
                                const struct hawser__tree_key *row)
{
	double number = 0.0;
	enum hawser_status status = hawser__tree_number(reader, &number, tree, what, "1",
	                                                HAWSER__TREE_ANY);

	if (!status && (number != floor(number) || number < row->least || number > row->most))
		return hawser__reader_fail(reader, &tree->at, "%s: %.9g is not a whole number from %.0f to "
		                           "%.0f", what, number, row->least, row->most);
	*value = (int)number;
	return status;
}

/* One number, or so many of a list. */
static enum hawser_status numbers(struct hawser__reader *reader, double *value,
                                  const struct hawser__tree *tree, const char *what,
                                  const struct hawser__tree_key *row)
{
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;
	char shown[HAWSER__SHOWN];

	if (!row->count) {
		status = hawser__tree_number(reader, value, tree, what, row->unit, row->range);
		for (int k = 1; k < row->copies; k++)
			value[k] = value[0];
		if (!status && row->most > 0.0 && *value > row->most)
			status = hawser__reader_fail(reader, &tree->at, "%s: \"%s\" is out of range: it must be "
			                             "from 0 to %g (%s)", what, hawser__shown(shown, tree->text),
			                             row->most, row->doc);
		return status;
	}
	if (tree->kind != HAWSER__SEQUENCE || tree->children != row->count)
		return hawser__reader_fail(reader, &tree->at, "%s must be a list of %d numbers%s%s, %s%.*s",
		                           what, row->count, strcmp(row->unit, "1") ? " in " : "",
		                           strcmp(row->unit, "1") ? row->unit : "",
		                           strpbrk(row->doc, "[2") ? "" : row->count == 2 ? "along x and y: "
		                           : "along x, y and z: ", (int)strcspn(row->doc, ":;"), row->doc);
	for (int k = 0; k < row->count && !status; k++, child = child->next)
		status = hawser__tree_number(reader, &value[k], child, what, row->unit, row->range);
	return status;
}

static enum hawser_status word(struct hawser__reader *reader, int *value,
                               const struct hawser__tree *tree, const char *what, const char *words)
{
	enum { MOST = 8 };
	char copy[HAWSER__TEXT_ROOM], *list[MOST];
	int count = 0;

	snprintf(copy, sizeof copy, "%s", words);
	for (char *at = copy; at && count < MOST; count++) {
		list[count] = at;
		at = strchr(at, '|');
		if (at)
			*at++ = '\0';
	}
	return hawser__tree_word(reader, value, tree, what, (const char *const *)list, count);
}

static enum hawser_status take(struct hawser__reader *reader, void *to, const struct hawser__tree *tree,
                               const char *what, const struct hawser__tree_key *row)
{
	double scratch[4];
	void *at = row->at == HAWSER__TREE_CHECKED ? (void *)scratch
	           : row->at == HAWSER__TREE_NOWHERE ? to : (void *)((char *)to + row->at);
	const char *text;
	enum hawser_status status;

	switch (row->type) {
	case HAWSER__TREE_NUMBER: return numbers(reader, at, tree, what, row);
	case HAWSER__TREE_INTEGER: return whole(reader, at, tree, what, row);
	case HAWSER__TREE_WORD: return word(reader, at, tree, what, row->unit);
	case HAWSER__TREE_MAPPING:
		return row->at == HAWSER__TREE_NOWHERE ? HAWSER_OK
			: hawser__tree_fill(reader, to, tree, what, row->path);
	case HAWSER__TREE_TEXT:
		status = hawser__tree_text(reader, &text, tree, what);
		if (!status && !(*(char **)at = strdup(text)))
			status = hawser__no_memory(reader->report, "scene");
		return status;
	default: return HAWSER_OK;
	}
}

enum hawser_status hawser__tree_value(struct hawser__reader *reader, void *to,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *path)
{
	const struct hawser__tree_key *form;
	enum hawser_status status = form_of(reader, &form, tree, what, path);

	return status ? status : take(reader, to, tree, what, form);
}

/* Store a default "0", "[1, 0, 0]", ".inf", "pi" or a word; words about a default are none. */
static void preset(void *to, const struct hawser__tree_key *row)
{
	void *at = (char *)to + row->at;
	double value[4] = {0.0};
	char *end = (char *)(uintptr_t)row->given;
	int count = 0, most = row->count ? row->count : 1;

	if (!end || row->at == HAWSER__TREE_NOWHERE || row->at == HAWSER__TREE_CHECKED)
		return;
	if (row->type == HAWSER__TREE_WORD && word_of(end, row->unit) >= 0)
		*(int *)at = word_of(end, row->unit);
	if (row->type > HAWSER__TREE_INTEGER)
		return;
	if (!strcmp(end, ".inf") || !strcmp(end, "pi")) {
		*(double *)at = *end == '.' ? INFINITY : acos(-1.0);
		return;
	}
	for (end += *end == '['; count < most; end += strspn(end, ", ")) {
		char *begin = end;

		value[count++] = strtod(begin, &end);
		if (end == begin)
			return;
	}
	if (*end && strcmp(end, "]") != 0)
		return;
	if (row->type == HAWSER__TREE_INTEGER)
		*(int *)at = (int)value[0];
	else
		memcpy(at, value, (size_t)most*sizeof *value);
}

static enum hawser_status missing(struct hawser__reader *reader, const struct hawser__tree *tree,
                                  const char *what, const struct hawser__tree_key *row)
{
	const char *unit = row->type == HAWSER__TREE_NUMBER && strcmp(row->unit, "1") ? row->unit : "";
	char keys[HAWSER__TREE_LIST_SIZE] = "";

	if (row->type == HAWSER__TREE_MAPPING)
		hawser__tree_key_list(keys, sizeof keys, row->path);
	return hawser__reader_fail(reader, &tree->at, "%s is missing: give it%s%s%s%s (%s)", what,
	                           *unit ? " in " : "", unit, *keys ? ", with the keys " : "", keys,
	                           row->doc);
}

/* One of those of a mapping that exclude each other, of which `first` is the first one. */
static enum hawser_status choose(struct hawser__reader *reader, void *to,
                                 const struct hawser__tree *tree, const char *section,
                                 const struct hawser__tree_key *first, const char *of)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	const struct hawser__tree *found = NULL, *other = NULL;
	char keys[HAWSER__TEXT_ROOM] = "", units[HAWSER__TEXT_ROOM] = "", what[HAWSER__TEXT_ROOM];
	int number = 0;

	for (const struct hawser__tree_key *row = first, *after; row; row = after, number++) {
		const char *key = hawser__tree_key_of(row->path, of);
		const struct hawser__tree *one = hawser__tree_find(tree, key);
		size_t used = strlen(keys), long_ = strlen(units);
		const char *comma;

		for (after = row + 1; after < table->row + table->rows &&
		     !(after->pick == first->pick && hawser__tree_key_of(after->path, of)); after++)
			continue;
		if (after == table->row + table->rows)
			after = NULL;
		comma = row == first ? "" : after ? ", " : " and ";
		snprintf(keys + used, sizeof keys - used, "%s%s", comma, key);
		snprintf(units + long_, sizeof units - long_, "%s%s%s%s%s", comma, key,
		         *row->unit ? " (" : "", row->unit, *row->unit ? ")" : "");
		if (!one)
			continue;
		if (found && !other)
			other = one;
		if (found)
			continue;
		found = one;
		*(int *)(void *)((char *)to + first->pick) = number;
	}
	if (other)
		return hawser__reader_fail(reader, &other->at, "%s has %s and %s: give one of %s", section,
		                           found->name, other->name, keys);
	if (!found)
		return hawser__reader_fail(reader, &tree->at, "%s needs one of %s", section, units);
	snprintf(what, sizeof what, "%.150s.%.60s", section, found->name);
	{
		char path[HAWSER__TEXT_ROOM];

		snprintf(path, sizeof path, "%.150s.%.60s", of, found->name);
		return hawser__tree_value(reader, to, found, what, path);
	}
}

/* The value of a key that has a place. */
static enum hawser_status key_of(struct hawser__reader *reader, void *to,
                                 const struct hawser__tree *tree, const char *section,
                                 const struct hawser__tree_key *row, const char *key)
{
	const struct hawser__tree *one = tree ? hawser__tree_find(tree, key) : NULL;
	char what[HAWSER__TEXT_ROOM];

	snprintf(what, sizeof what, "%.150s%s%.60s", section, *section ? "." : "", key);
	if (one)
		return hawser__tree_value(reader, to, one, what, row->path);
	if (tree && row->need == HAWSER__TREE_REQUIRED)
		return missing(reader, tree, what, row);
	for (; row; row = next(row, row->path))
		if (row->type != HAWSER__TREE_MAPPING)
			preset(to, row);
		else if (row->at != HAWSER__TREE_NOWHERE)
			return hawser__tree_fill(reader, to, NULL, what, row->path);
	return HAWSER_OK;
}

/* Has a form of the value of this row a place? */
static int placed(const struct hawser__tree_key *row)
{
	const char *path = row->path;

	while (row && row->at == HAWSER__TREE_NOWHERE)
		row = next(row, path);
	return row != NULL;
}

enum hawser_status hawser__tree_fill(struct hawser__reader *reader, void *to,
                                     const struct hawser__tree *tree, const char *section,
                                     const char *of)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	size_t chosen = HAWSER__TREE_NOWHERE;
	enum hawser_status status = HAWSER_OK;

	if (tree)
		status = hawser__tree_keys(reader, tree, *section ? section : "the scene", of);
	for (int i = 0; i < table->rows && !status; i++) {
		const struct hawser__tree_key *row = &table->row[i];
		const char *key = hawser__tree_key_of(row->path, of);

		if (!key || *key == '*' || next(NULL, row->path) != row || !placed(row))
			continue;
		if (row->pick == HAWSER__TREE_NOWHERE)
			status = key_of(reader, to, tree, section, row, key);
		else if (tree && row->pick != chosen)
			status = choose(reader, to, tree, section, row, of);
		if (row->pick != HAWSER__TREE_NOWHERE)
			chosen = row->pick;
	}
	return status;
}

void *hawser__tree_items(struct hawser__reader *reader, enum hawser_status *status,
                         const struct hawser__tree *tree, const char *what, size_t size, int least,
                         int most, const char *such)
{
	void *room = NULL;

	if (tree->kind != HAWSER__SEQUENCE || tree->children < least)
		*status = hawser__reader_fail(reader, &tree->at, "%s must be a list of mappings, such as [%s]",
		                              what, such);
	else if (most && tree->children > most)
		*status = hawser__reader_fail(reader, &tree->at, "%s: %d are more than %d: give fewer", what,
		                              tree->children, most);
	else if (!(room = calloc((size_t)tree->children + 1, size)))
		*status = hawser__no_memory(reader->report, "scene");
	else
		*status = HAWSER_OK;
	return room;
}

enum hawser_status hawser__tree_name_item(struct hawser__reader *reader, char *name, size_t size,
                                          int number, const struct hawser__tree *tree,
                                          const char *what, char letter)
{
	const struct hawser__tree *given = hawser__tree_find(tree, "name");
	char called[HAWSER__TEXT_ROOM];
	const char *text;
	enum hawser_status status = HAWSER_OK;

	snprintf(called, sizeof called, "%.60s.name", what);
	snprintf(name, HAWSER__TREE_NAME, "%c%d", letter, number);
	if (given)
		status = hawser__tree_text(reader, &text, given, called);
	if (!status && given)
		status = hawser__tree_name(reader, name, given, text, called);
	for (int i = 1; i <= number && !status; i++)
		if (!strcmp(name - (size_t)i*size, name))
			status = hawser__reader_fail(reader, given ? &given->at : &tree->at, "two %s have the name "
			                             "%s: give different ones (without one, the first is %c0, the "
			                             "next %c1 and so on)", what, name, letter, letter);
	return status;
}

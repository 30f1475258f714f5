/* scene/tree_fill.c - values of a tree by the table of keys, into structures.
 *
 * A value may have several forms, each a row of the same path: a word or a number, a number or a list.
 * The row whose form fits is taken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "scene/tree_keys.h"

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
	case HAWSER__TREE_LIMIT:
	case HAWSER__TREE_WORD:
		return tree->text && word_of(tree->text, row->unit) >= 0;
	case HAWSER__TREE_MAPPING:
		return tree->kind == HAWSER__MAPPING;
	case HAWSER__TREE_LIST:
		return tree->kind == HAWSER__SEQUENCE;
	default:
		return row->count ? tree->kind == HAWSER__SEQUENCE && tree->children == row->count
		                  : tree->text && *tree->text;
	}
}

/* "a, b or c" of "a|b|c". */
static void append_words(char *text, size_t size, const char *between, const char *words)
{
	for (; *words; between = strchr(words, '|') ? ", " : " or ") {
		size_t length = strcspn(words, "|");

		hawser__append(text, size, between, "%.*s", (int)length, words);
		words += length + (words[length] == '|');
	}
}

/* "a number, or a list of 2 numbers in N": the forms of a value. */
static void forms_of(char *text, size_t size, const char *path)
{
	*text = '\0';
	for (const struct hawser__tree_key *row = hawser__tree_next(NULL, path), *after; row; row = after) {
		static const char *const sort[] = {"a number", "a whole number", NULL, "a name", NULL,
			/* NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one text */
		                                   "a fraction of the length such as 40 %, or a length such as "
		                                   "12 m", "a mapping", "a list"};
		const char *between;

		after = hawser__tree_next(row, path);
		between = after ? ", " : ", or ";
		if (sort[row->type] && !row->count)
			hawser__append(text, size, between, "%s", sort[row->type]);
		else if (row->count)
			hawser__append(text, size, between, "a list of %d numbers", row->count);
		else
			append_words(text, size, between, row->unit);
		if (row->type == HAWSER__TREE_NUMBER && row->unit && strcmp(row->unit, "1") != 0)
			hawser__append(text, size, " ", "in %s", row->unit);
		if (row->type != HAWSER__TREE_MAPPING || after || row != hawser__tree_next(NULL, path))
			continue;
		hawser__append(text, size, " ", "with the keys ");
		hawser__tree_key_list(text + strlen(text), size - strlen(text), path);
	}
}

/* Fail for a value that has none of the forms of its path. */
static enum hawser_status formless(struct hawser__reader *reader, const struct hawser__tree *tree,
                                   const char *what, const char *path)
{
	const struct hawser__tree_key *row = hawser__tree_next(NULL, path);
	const struct hawser__mark *at = &tree->value;
	char forms[HAWSER__TREE_LIST_SIZE], shown[HAWSER__SHOWN];

	forms_of(forms, sizeof forms, path);
	if (tree->kind == HAWSER__MAPPING)
		return hawser__reader_fail(reader, at, "%s is a mapping, but must be %s", what, forms);
	if (tree->kind == HAWSER__SEQUENCE && row->count)
		return hawser__reader_fail(reader, at, "%s has %d value%s, but must be %s (%s)", what,
		                           tree->children, tree->children == 1 ? "" : "s", forms, row->doc);
	if (tree->kind == HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, at, "%s is a list, but must be %s", what, forms);
	if (!*tree->text)
		return hawser__reader_fail(reader, at, "%s has no value: give %s", what, forms);
	return hawser__reader_fail(reader, at, "%s: \"%s\" must be %s", what,
	                           hawser__shown(shown, tree->text), forms);
}

/* The form of a value of this path. */
static enum hawser_status form_of(struct hawser__reader *reader, const struct hawser__tree_key **form,
                                  const struct hawser__tree *tree, const char *what, const char *path)
{
	int words = 0, letters = tree->text && isalpha((unsigned char)*tree->text);

	*form = NULL;
	for (const struct hawser__tree_key *row = hawser__tree_next(NULL, path); row;
	     row = hawser__tree_next(row, path)) {
		int is_words = row->type == HAWSER__TREE_WORD || row->type == HAWSER__TREE_LIMIT;

		words |= is_words;
		if (fits(row, tree) && (is_words || !*form))
			*form = row;
	}
	if (*form && words && letters && (*form)->type <= HAWSER__TREE_INTEGER)
		*form = NULL; /* a word that is none of those */
	return *form ? HAWSER_OK : formless(reader, tree, what, path);
}

static enum hawser_status whole(struct hawser__reader *reader, int *value,
                                const struct hawser__tree *tree, const char *what,
                                const struct hawser__tree_key *row)
{
	double number = 0.0;
	enum hawser_status status = hawser__tree_number(reader, &number, tree, what, "1",
	                                                HAWSER__TREE_ANY);

	if (!status && (number != floor(number) || number < row->least || number > row->most))
		return hawser__reader_fail(reader, &tree->value, "%s: %.9g is not a whole number from %.0f to "
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
	char shown[HAWSER__SHOWN], element[HAWSER__TEXT_ROOM];

	if (!row->count) {
		status = hawser__tree_number(reader, value, tree, what, row->unit, row->range);
		for (int k = 1; k < row->copies; k++)
			value[k] = value[0];
		if (!status && row->most > 0.0 && *value > row->most)
			status = hawser__reader_fail(reader, &tree->value, "%s: \"%s\" is out of range: it must be "
			                             "from 0 to %g (%s)", what, hawser__shown(shown, tree->text),
			                             row->most, row->doc);
		return status;
	}
	for (int k = 0; k < row->count && !status; k++, child = child->next) {
		snprintf(element, sizeof element, "%.200s[%d]", what, k);
		status = hawser__tree_number(reader, &value[k], child, element, row->unit, row->range);
	}
	if (!status && row->range == HAWSER__TREE_INCREASING && value[1] <= value[0])
		status = hawser__reader_fail(reader, &tree->value, "%s: [%g, %g] does not increase: give the "
		                             "smaller number first", what, value[0], value[1]);
	return status;
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
	case HAWSER__TREE_WORD:
		*(int *)at = word_of(tree->text, row->unit);
		return HAWSER_OK;
	case HAWSER__TREE_LIMIT:
		*(double *)at = word_of(tree->text, row->unit) ? INFINITY : 0.0;
		return HAWSER_OK;
	case HAWSER__TREE_POSITION:
		return hawser__tree_position(reader, at, (int *)(void *)((double *)at + 1), tree, what,
		                             row->range);
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

int hawser__tree_default(double *value, int most, const char *given)
{
	char *end = (char *)(uintptr_t)given;
	int count = 0;

	for (end += *end == '['; count < most; end += strspn(end, ", ")) {
		char *begin = end;

		if (!strncmp(begin, ".inf", 4) || !strcmp(begin, "pi")) {
			value[count++] = *begin == '.' ? INFINITY : acos(-1.0);
			end = begin + (*begin == '.' ? 4 : 2);
			continue;
		}
		value[count++] = strtod(begin, &end);
		if (end == begin)
			return 0;
	}
	return *end && strcmp(end, "]") != 0 ? 0 : count;
}

/* Store a default; words about a default are none. */
static void preset(void *to, const struct hawser__tree_key *row)
{
	void *at = (char *)to + row->at;
	double value[4] = {0.0};
	int most = row->count ? row->count : 1;

	if (!row->given || row->at == HAWSER__TREE_NOWHERE || row->at == HAWSER__TREE_CHECKED)
		return;
	if (row->type == HAWSER__TREE_WORD && word_of(row->given, row->unit) >= 0)
		*(int *)at = word_of(row->given, row->unit);
	if ((row->type > HAWSER__TREE_INTEGER && row->type != HAWSER__TREE_POSITION) ||
	    !hawser__tree_default(value, most, row->given))
		return;
	if (row->type == HAWSER__TREE_INTEGER)
		*(int *)at = (int)value[0];
	else
		memcpy(at, value, (size_t)most*sizeof *value);
}

enum hawser_status hawser__tree_missing(struct hawser__reader *reader, const struct hawser__tree *tree,
                                        const char *what, const char *path)
{
	const struct hawser__tree_key *row = hawser__tree_next(NULL, path);
	char forms[HAWSER__TREE_LIST_SIZE];

	forms_of(forms, sizeof forms, path);
	return hawser__reader_fail(reader, &tree->at, "%s is missing: give %s (%s)", what, forms, row->doc);
}

/* The next row of the mapping `of` with the same choice, or NULL. */
static const struct hawser__tree_key *rival_of(const struct hawser__tree_key *row, const char *of)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	size_t pick = row->pick;

	for (row++; row < table->row + table->rows; row++)
		if (row->pick == pick && hawser__tree_key_of(row->path, of) &&
		    hawser__tree_next(NULL, row->path) == row)
			return row;
	return NULL;
}

static enum hawser_status contradict(struct hawser__reader *reader, const struct hawser__tree *a,
                                     const struct hawser__tree *b, const char *section,
                                     const char *keys)
{
	int later = a->at.line != b->at.line ? a->at.line > b->at.line : a->at.column > b->at.column;
	const struct hawser__tree *last = later ? a : b, *first = later ? b : a;
	char where[48];

	return hawser__reader_fail(reader, &last->at, "%s.%s contradicts %s.%s %s: give one of %s", section,
	                           last->name, section, first->name,
	                           hawser__mark_text(where, sizeof where, &first->at), keys);
}

/* One of those of a mapping that exclude each other, of which `first` is the first one. `late`: only
 * see whether one is given. */
static enum hawser_status choose(struct hawser__reader *reader, void *to,
                                 const struct hawser__tree *tree, const char *section,
                                 const struct hawser__tree_key *first, const char *of, int late)
{
	const struct hawser__tree *found = NULL, *other = NULL;
	const char *path = NULL;
	char keys[HAWSER__TEXT_ROOM] = "", units[HAWSER__TEXT_ROOM] = "", what[HAWSER__TEXT_ROOM];
	int number = 0;

	for (const struct hawser__tree_key *row = first, *after; row; row = after, number++) {
		const char *key = hawser__tree_key_of(row->path, of);
		const struct hawser__tree *one = hawser__tree_find(tree, key);
		const char *unit = row->unit && strcmp(row->unit, "1") != 0 ? row->unit : "";

		after = rival_of(row, of);
		hawser__append(keys, sizeof keys, after ? ", " : " and ", "%s", key);
		hawser__append(units, sizeof units, after ? ", " : " and ", "%s%s%s%s", key,
		               *unit ? " (" : "", unit, *unit ? ")" : "");
		if (one && found)
			other = one;
		if (!one || found)
			continue;
		found = one;
		path = row->path;
		*(int *)(void *)((char *)to + first->pick) = row->member ? row->member : number;
	}
	if (other)
		return contradict(reader, found, other, section, keys);
	if (!found && late && first->need != HAWSER__TREE_AT_MOST_ONE)
		return hawser__reader_fail(reader, &tree->at, "%s needs one of %s", section, units);
	if (!found || late)
		return HAWSER_OK;
	snprintf(what, sizeof what, "%.150s.%.60s", section, found->name);
	return hawser__tree_value(reader, to, found, what, path);
}

/* A value must be given: `tree` is its mapping. */
static int needed(const struct hawser__tree_key *row, const struct hawser__tree *tree, const char *of)
{
	if (row->need != HAWSER__TREE_TOGETHER)
		return row->need == HAWSER__TREE_REQUIRED;
	for (const struct hawser__tree *one = tree->child; one; one = one->next) {
		char path[HAWSER__TEXT_ROOM];

		snprintf(path, sizeof path, "%.150s.%.60s", of, one->name);
		if (hawser__tree_next(NULL, path)->type != HAWSER__TREE_MAPPING)
			return 1;
	}
	return !tree->child;
}

/* The value of a key that has a place. `late`: only see whether it is given. */
static enum hawser_status key_of(struct hawser__reader *reader, void *to,
                                 const struct hawser__tree *tree, const char *section,
                                 const struct hawser__tree_key *row, const char *of, int late)
{
	const char *key = hawser__tree_key_of(row->path, of);
	const struct hawser__tree *one = tree ? hawser__tree_find(tree, key) : NULL;
	char what[HAWSER__TEXT_ROOM];

	snprintf(what, sizeof what, "%.150s%s%.60s", section, *section ? "." : "", key);
	if (late)
		return tree && !one && needed(row, tree, of)
		       ? hawser__tree_missing(reader, tree, what, row->path) : HAWSER_OK;
	if (one)
		return hawser__tree_value(reader, to, one, what, row->path);
	for (; row; row = hawser__tree_next(row, row->path))
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
		row = hawser__tree_next(row, path);
	return row != NULL;
}

/* The keys directly in a mapping. */
static enum hawser_status keys_of(struct hawser__reader *reader, void *to,
                                  const struct hawser__tree *tree, const char *section,
                                  const char *of, int late)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	size_t chosen = HAWSER__TREE_NOWHERE;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < table->rows && !status; i++) {
		const struct hawser__tree_key *row = &table->row[i];
		const char *key = hawser__tree_key_of(row->path, of);

		if (!key || *key == '*' || hawser__tree_next(NULL, row->path) != row || !placed(row))
			continue;
		if (row->pick == HAWSER__TREE_NOWHERE)
			status = key_of(reader, to, tree, section, row, of, late);
		else if (tree && row->pick != chosen)
			status = choose(reader, to, tree, section, row, of, late);
		if (row->pick != HAWSER__TREE_NOWHERE)
			chosen = row->pick;
	}
	return status;
}

/* What is wrong comes before what is missing. */
enum hawser_status hawser__tree_fill(struct hawser__reader *reader, void *to,
                                     const struct hawser__tree *tree, const char *section,
                                     const char *of)
{
	enum hawser_status status = HAWSER_OK;

	if (tree)
		status = hawser__tree_keys(reader, tree, *section ? section : "the scene", of);
	if (!status)
		status = keys_of(reader, to, tree, section, of, 0);
	return status ? status : keys_of(reader, to, tree, section, of, 1);
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

/* scene/value.c - read one value (a number with its unit, a list of numbers, or a word), check it
 * against its row of the table and store it in the scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "scene/reader.h"
#include "scene/tree.h"

/* A value being read: its key, its name in messages ("load.extent[1]"), its place. */
struct item {
	int index;
	char called[96];
	struct hawser__mark place;
};

static const struct hawser_scene_key *key_of(const struct item *item)
{
	return hawser_scene_key(item->index);
}

static void *field(struct hawser__reader *reader, const struct item *item)
{
	return hawser__field(reader->scene, item->index, reader->item);
}

/* "a number in N", "a list of 3 numbers in N/m", "one of taut|slack" */
static const char *wanted(char *text, size_t size, const struct item *item)
{
	const struct hawser_scene_key *key = key_of(item);
	const struct hawser__row *row = &hawser__rows()[item->index];
	int count = hawser__type_count(row->type), pure = !strcmp(key->unit, "1");
	const char *in = pure ? "" : " in ", *unit = pure ? "" : key->unit;

	if (row->type == HAWSER__WORD)
		snprintf(text, size, "one of %s", key->words);
	else if (row->type == HAWSER__PLACE)
		snprintf(text, size, "a fraction of the length such as 40 %%, or a length such as 12 m");
	else if (row->type == HAWSER__NAME)
		snprintf(text, size, "a name");
	else if (row->type == HAWSER__INTEGER)
		snprintf(text, size, "a whole number%s%s", key->words ? " or " : "",
		         key->words ? key->words : "");
	else if (row->type == HAWSER__SERIES)
		snprintf(text, size, "a number, or a list of 1 to %d numbers%s%s", HAWSER_RATIOS, in, unit);
	else if (count)
		snprintf(text, size, "a list of %d numbers%s%s", count, in, unit);
	else if (key->words)
		snprintf(text, size, "one of %s, or a number%s%s", key->words, in, unit);
	else
		snprintf(text, size, "a number%s%s", in, unit);
	return text;
}

static enum hawser_status number(struct hawser__reader *reader, double *value,
                                 const struct item *item, const char *text)
{
	const struct hawser_scene_key *key = key_of(item);
	enum hawser__number answer = hawser__units_read(&reader->units, value, text, key->unit);
	char sentence[320], shown[HAWSER__SHOWN];

	if (answer == HAWSER__NUMBER_DATABASE) {
		hawser__units_explain(sentence, sizeof sentence, answer, text, key->unit);
		return hawser__fail(reader->report, HAWSER_ERR_IO, "scene", "%s %s", item->called,
		                    sentence);
	}
	hawser__shown(shown, text);
	if (answer != HAWSER__NUMBER_OK) {
		hawser__units_explain(sentence, sizeof sentence, answer, text, key->unit);
		if (key->words && isalpha((unsigned char)*text))
			return hawser__reader_fail(reader, &item->place,
			                           "%s: \"%s\" is none of the words %s, and %s",
			                           item->called, shown, key->words, sentence);
		return hawser__reader_fail(reader, &item->place,
		                           "%s: \"%s\" %s", item->called, shown,
		                           sentence);
	}
	if (hawser__in_range(item->index, *value))
		return HAWSER_OK;
	return hawser__reader_fail(reader, &item->place,
	                           "%s: \"%s\" is out of range: it must be %s%s%s", item->called,
	                           shown, key->range, strcmp(key->unit, "1") ? ", in " : "",
	                           strcmp(key->unit, "1") ? key->unit : "");
}

static enum hawser_status integer(struct hawser__reader *reader, const struct item *item,
                                  const char *text)
{
	const char *word = key_of(item)->words;
	double value = 0.0;
	enum hawser_status status = HAWSER_OK;
	char shown[HAWSER__SHOWN];
	int whole;

	if (word && isalpha((unsigned char)*text) && strcmp(text, word) != 0)
		return hawser__reader_fail(reader, &item->place,
		                           "%s: \"%s\" is neither a whole number nor %s", item->called,
		                           hawser__shown(shown, text), word);
	if (!word || strcmp(text, word) != 0)
		status = number(reader, &value, item, text);
	if (status != HAWSER_OK)
		return status;
	whole = (int)value; /* fits: the range has been checked */
	if (whole != value)
		return hawser__reader_fail(reader, &item->place, "%s: \"%s\" is not a whole number",
		                           item->called, hawser__shown(shown, text));
	memcpy(field(reader, item), &whole, sizeof whole);
	return HAWSER_OK;
}

static enum hawser_status word(struct hawser__reader *reader, const struct item *item,
                               const char *text)
{
	const char *words = key_of(item)->words;
	size_t length = strlen(text);
	char shown[HAWSER__SHOWN];

	for (int choice = 0; *words; choice++) {
		size_t span = strcspn(words, "|");

		if (span == length && !strncmp(words, text, span)) {
			memcpy(field(reader, item), &choice, sizeof choice);
			return HAWSER_OK;
		}
		words += span + (words[span] == '|');
	}
	return hawser__reader_fail(reader, &item->place, "%s: \"%s\" is not one of %s",
	                           item->called, hawser__shown(shown, text), key_of(item)->words);
}

/* 1 if the text is one of the words that stand for 0 and infinity. */
static int limit(double *value, const struct item *item, const char *text)
{
	const char *words = key_of(item)->words;
	size_t first = words ? strcspn(words, "|") : 0, length = strlen(text);
	int zero = words && length == first && !strncmp(text, words, first);

	*value = zero ? 0.0 : INFINITY;
	return zero || (words && !strcmp(text, words + first + 1));
}

/* A fraction of the length if the text has no unit or a pure number's, else a length. */
static enum hawser_status place(struct hawser__reader *reader, const struct item *item,
                                const char *text)
{
	char *to = field(reader, item);
	enum hawser__number answer;
	int by_length;
	char shown[HAWSER__SHOWN], want[96];
	double value = 0.0;

	answer = hawser__units_read(&reader->units, &value, text, "1");
	by_length = answer == HAWSER__NUMBER_DIMENSION;
	if (by_length)
		answer = hawser__units_read(&reader->units, &value, text, "m");
	if (answer == HAWSER__NUMBER_DATABASE)
		return number(reader, &value, item, text);
	hawser__shown(shown, text);
	if (answer != HAWSER__NUMBER_OK)
		return hawser__reader_fail(reader, &item->place, "%s: \"%s\" is no position: give %s",
		                           item->called, shown, wanted(want, sizeof want, item));
	if (!hawser__place_in(item->index, value, by_length))
		return hawser__reader_fail(reader, &item->place,
		                           "%s: \"%s\" is not between the ends: give %s", item->called,
		                           shown, wanted(want, sizeof want, item));
	memcpy(to, &value, sizeof value);
	memcpy(to + sizeof value, &by_length, sizeof by_length);
	return HAWSER_OK;
}

static enum hawser_status name(struct hawser__reader *reader, const struct item *item,
                               const char *text)
{
	char shown[HAWSER__SHOWN];
	size_t length = strlen(text);
	int digits = 1;

	for (size_t i = 0; i < length; i++) {
		unsigned char c = (unsigned char)text[i];

		if (!isalnum(c) && c != '_' && c != '-')
			length = HAWSER_NAME_SIZE;
		digits = digits && isdigit(c);
	}
	if (length >= HAWSER_NAME_SIZE || digits)
		return hawser__reader_fail(reader, &item->place,
		                           "%s: \"%s\" is no name: at most %d letters, digits, _ and -, "
		                           "and not only digits", item->called,
		                           hawser__shown(shown, text), HAWSER_NAME_SIZE - 1);
	memcpy(field(reader, item), text, length + 1);
	return HAWSER_OK;
}

static enum hawser_status scalar(struct hawser__reader *reader, const struct item *item,
                                 const char *text)
{
	char want[96];
	double value = 0.0;
	enum hawser_status status = HAWSER_OK;

	if (!*text)
		return hawser__reader_fail(reader, &item->place, "%s has no value: give %s",
		                           item->called, wanted(want, sizeof want, item));
	switch (hawser__rows()[item->index].type) {
	case HAWSER__WORD: return word(reader, item, text);
	case HAWSER__INTEGER: return integer(reader, item, text);
	case HAWSER__PLACE: return place(reader, item, text);
	case HAWSER__NAME: return name(reader, item, text);
	default: break;
	}
	if (!limit(&value, item, text))
		status = number(reader, &value, item, text);
	if (status == HAWSER_OK && hawser__rows()[item->index].type == HAWSER__SERIES) {
		memset(reader->scene->damping.ratio_next, 0, sizeof reader->scene->damping.ratio_next);
		reader->scene->damping.ratios = 0;
	}
	if (status == HAWSER_OK)
		memcpy(field(reader, item), &value, sizeof value);
	return status;
}

static const char *kind(const struct hawser__tree *tree)
{
	return tree->kind == HAWSER__MAPPING ? "a mapping"
	       : tree->kind == HAWSER__SEQUENCE ? "a list" : "a single value";
}

/* Most elements of a list. */
static int room(const struct item *list)
{
	enum hawser__type type = hawser__rows()[list->index].type;

	return type == HAWSER__SERIES ? HAWSER_RATIOS : hawser__type_count(type);
}

/* Element i of a list into *value. */
static enum hawser_status element(struct hawser__reader *reader, double *value,
                                  const struct hawser__tree *tree, const struct item *list, int i)
{
	struct item item = {.index = list->index, .place = tree->value};
	char want[96];

	snprintf(item.called, sizeof item.called, "%s[%d]", key_of(list)->path, i);
	if (i == room(list))
		return hawser__reader_fail(reader, &item.place, "%s has more than %d values: give %s",
		                           list->called, i, wanted(want, sizeof want, list));
	if (tree->kind != HAWSER__SCALAR)
		return hawser__reader_fail(reader, &item.place, "%s is %s, but must be a number",
		                           item.called, kind(tree));
	return number(reader, value, &item, tree->text);
}

static enum hawser_status list(struct hawser__reader *reader, const struct item *item,
                               const struct hawser__tree *tree)
{
	const struct hawser__row *row = &hawser__rows()[item->index];
	int series = row->type == HAWSER__SERIES, count = series ? 1 : room(item), n = 0;
	double value[HAWSER_RATIOS + 1] = {0.0};
	char want[96];

	for (const struct hawser__tree *child = tree->child; child; child = child->next, n++) {
		enum hawser_status status = element(reader, &value[n], child, item, n);

		if (status)
			return status;
	}
	if (n < count)
		return hawser__reader_fail(reader, &item->place, "%s has %d value%s: give %s",
		                           item->called, n, n == 1 ? "" : "s",
		                           wanted(want, sizeof want, item));
	if (row->range == HAWSER__INCREASING && value[1] <= value[0])
		return hawser__reader_fail(reader, &item->place,
		                           "%s: [%g, %g] does not increase: give "
		                                                 "the end nearer to A first",
		                           item->called, value[0], value[1]);
	memcpy(field(reader, item), value, (size_t)(series ? HAWSER_RATIOS : n)*sizeof *value);
	if (series)
		reader->scene->damping.ratios = n;
	return HAWSER_OK;
}

enum hawser_status hawser__value_read(struct hawser__reader *reader, const struct hawser__tree *tree,
                                      int index)
{
	struct item item = {.index = index, .place = tree->value};
	int is_list = room(&item) > 0, series = hawser__rows()[index].type == HAWSER__SERIES;
	char want[96];

	snprintf(item.called, sizeof item.called, "%s", key_of(&item)->path);
	if (tree->kind == HAWSER__SCALAR && (!is_list || series || !*tree->text))
		return scalar(reader, &item, tree->text);
	if (tree->kind == HAWSER__SEQUENCE && is_list)
		return list(reader, &item, tree);
	return hawser__reader_fail(reader, &item.place, "%s is %s, but must be %s", item.called,
	                           kind(tree), wanted(want, sizeof want, &item));
}

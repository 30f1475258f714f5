/* scene/tree_value.c - values of a tree: numbers with units, vectors, names, words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "scene/tree.h"

static const struct hawser__tree_limits limits[HAWSER__TREE_RANGES] = {
	[HAWSER__TREE_ANY] = {"finite", -INFINITY, INFINITY, 1, 1},
	[HAWSER__TREE_POSITIVE] = {"> 0", 0.0, INFINITY, 1, 1},
	[HAWSER__TREE_POSITIVE_OR_INF] = {"> 0 or .inf", 0.0, INFINITY, 1, 0},
	[HAWSER__TREE_NOT_NEGATIVE] = {">= 0", 0.0, INFINITY, 0, 1},
	[HAWSER__TREE_NOT_NEGATIVE_OR_INF] = {">= 0 or .inf", 0.0, INFINITY, 0, 0},
	[HAWSER__TREE_RIGHT_ANGLE] = {"within [-pi/2, pi/2]", -1.5707963267948968, 1.5707963267948968,
	                              0, 0}, /* pi/2 rounded, inclusive */
	[HAWSER__TREE_OPEN_UNIT] = {"between 0 and 1", 0.0, 1.0, 1, 1},
	[HAWSER__TREE_INCREASING] = {"within [0, 1], increasing", 0.0, 1.0, 0, 0},
	[HAWSER__TREE_CHANGE] = {"within [-300, 300]", -300.0, 300.0, 0, 0}, /* K: beyond, expansion is
	                                                                       * not linear */
	[HAWSER__TREE_WITHIN] = {"within [0, 1], or a length >= 0", 0.0, INFINITY, 0, 1},
	[HAWSER__TREE_INSIDE] = {"between 0 and 1, or a length > 0", 0.0, INFINITY, 1, 1},
};

const struct hawser__tree_limits *hawser__tree_limits(enum hawser__tree_range range)
{
	return &limits[range];
}

int hawser__tree_in_range(enum hawser__tree_range range, double value)
{
	const struct hawser__tree_limits *of = &limits[range];

	return (value > of->least || (value == of->least && !of->above)) &&
	       (value < of->most || (value == of->most && !of->below));
}

int hawser__tree_between(enum hawser__tree_range range, double value, int by_length)
{
	return hawser__tree_in_range(range, value) &&
	       (by_length || (range == HAWSER__TREE_INSIDE ? value < 1.0 : value <= 1.0));
}

enum hawser_status hawser__tree_text(struct hawser__reader *reader, const char **text,
                                    const struct hawser__tree *tree, const char *what)
{
	*text = tree->text;
	if (tree->kind == HAWSER__SCALAR && tree->text && *tree->text)
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->value, "%s is %s, but must be a single value", what,
	                           tree->kind == HAWSER__MAPPING ? "a mapping"
	                           : tree->kind == HAWSER__SEQUENCE ? "a list" : "empty");
}

/* Read a number, of any value. */
static enum hawser_status read_number(struct hawser__reader *reader, double *value,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *unit)
{
	const char *text;
	char sentence[320], shown[HAWSER__SHOWN];
	enum hawser__number answer;
	enum hawser_status status = hawser__tree_text(reader, &text, tree, what);

	if (status)
		return status;
	answer = hawser__units_read(&reader->units, value, text, unit);
	if (answer == HAWSER__NUMBER_OK)
		return HAWSER_OK;
	hawser__units_explain(sentence, sizeof sentence, answer, text, unit);
	if (answer == HAWSER__NUMBER_DATABASE)
		return hawser__fail(reader->report, HAWSER_ERR_IO, "scene", "%s %s", what, sentence);
	return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" %s", what, hawser__shown(shown, text),
	                           sentence);
}

enum hawser_status hawser__tree_number(struct hawser__reader *reader, double *value,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *unit, enum hawser__tree_range range)
{
	const char *in = strcmp(unit, "1") ? ", in " : "", *shown_unit = strcmp(unit, "1") ? unit : "";
	char shown[HAWSER__SHOWN];
	enum hawser_status status = read_number(reader, value, tree, what, unit);
	int above_0 = limits[range].above && limits[range].least == 0.0;
	int sized = reader->any_size || isinf(*value) ||
	            (fabs(*value) <= 1e100 && !(above_0 && *value < 1e-100));

	if (status || (hawser__tree_in_range(range, *value) && sized))
		return status;
	hawser__shown(shown, tree->text);
	if (range && isinf(*value) && *value > 0.0 && limits[range].most == *value)
		return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" is not finite: give a number that "
		                           "is %s%s%s%s", what, shown, limits[range].text, in, shown_unit,
		                           strstr(what, "EA") ? "; of a cable that hardly stretches, 1e6 times "
		                           "its tension" : "");
	return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" is out of range: it must be %s%s%s%s",
	                           what, shown, limits[range].text, in, shown_unit,
	                           strcmp(what, "span.d") == 0 && *value == 0.0
	                           ? "; of a vertical rope 1e-5 of its height, or take a net" : "");
}

enum hawser_status hawser__tree_position(struct hawser__reader *reader, double *value, int *by_length,
                                         const struct hawser__tree *tree, const char *what,
                                         enum hawser__tree_range range)
{
	static const char such[] = "a fraction of the length such as 40 %, or a length such as 12 m";
	enum hawser__number answer;
	char shown[HAWSER__SHOWN];
	const char *text;
	enum hawser_status status = hawser__tree_text(reader, &text, tree, what);

	if (status)
		return status;
	answer = hawser__units_read(&reader->units, value, text, "1");
	*by_length = answer == HAWSER__NUMBER_DIMENSION;
	if (*by_length)
		answer = hawser__units_read(&reader->units, value, text, "m");
	if (answer == HAWSER__NUMBER_DATABASE)
		return read_number(reader, value, tree, what, "m");
	if (answer == HAWSER__NUMBER_OK && hawser__tree_between(range, *value, *by_length))
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" is %s: give %s", what,
	                           hawser__shown(shown, text), answer == HAWSER__NUMBER_OK
	                           ? "not between the ends" : "no position", such);
}

enum hawser_status hawser__tree_vector(struct hawser__reader *reader, double *value, int count,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit)
{
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || tree->children != count)
		return hawser__reader_fail(reader, &tree->value, "%s must be a list of %d numbers in %s, along "
		                           "%s", what, count, unit, count == 2 ? "x and y" : "x, y and z");
	for (int k = 0; k < count && !status; k++, child = child->next)
		status = hawser__tree_number(reader, &value[k], child, what, unit, HAWSER__TREE_ANY);
	return status;
}

enum hawser_status hawser__tree_word(struct hawser__reader *reader, int *index,
                                     const struct hawser__tree *tree, const char *what,
                                     const char *const *words, int count)
{
	char list[HAWSER__TEXT_ROOM] = "", shown[HAWSER__SHOWN];
	const char *text;
	enum hawser_status status = hawser__tree_text(reader, &text, tree, what);

	if (status)
		return status;
	for (*index = 0; *index < count; ++*index) {
		if (!strcmp(text, words[*index]))
			return HAWSER_OK;
		hawser__append(list, sizeof list, *index == count - 1 ? " or " : ", ", "%s", words[*index]);
	}
	return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" must be %s", what,
	                           hawser__shown(shown, text), list);
}

enum hawser_status hawser__tree_name(struct hawser__reader *reader, char name[HAWSER__TREE_NAME],
                                    const struct hawser__tree *tree, const char *text,
                                    const char *what)
{
	size_t length = strlen(text);
	char shown[HAWSER__SHOWN];
	int good = length && length < HAWSER__TREE_NAME && strspn(text, "0123456789") < length;

	for (size_t i = 0; i < length && good; i++)
		good = isalnum((unsigned char)text[i]) || text[i] == '_' || text[i] == '-';
	if (!good)
		return hawser__reader_fail(reader, &tree->value, "%s: \"%s\" is no name: at most %d letters, "
		                           "digits, _ and -, and not only digits", what,
		                           hawser__shown(shown, text), HAWSER__TREE_NAME - 1);
	memcpy(name, text, length + 1);
	return HAWSER_OK;
}

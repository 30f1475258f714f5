/* scene/tree_value.c - values of a tree: numbers with units, vectors, names, words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "scene/tree.h"

enum hawser_status hawser__tree_text(struct hawser__reader *reader, const char **text,
                                    const struct hawser__tree *tree, const char *what)
{
	*text = tree->text;
	if (tree->kind == HAWSER__SCALAR && tree->text && *tree->text)
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->at, "%s is %s, but must be a single value", what,
	                           tree->kind == HAWSER__MAPPING ? "a mapping"
	                           : tree->kind == HAWSER__SEQUENCE ? "a list" : "empty");
}

enum hawser_status hawser__tree_number(struct hawser__reader *reader, double *value,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *unit, enum hawser__tree_range range)
{
	const char *text, *rule = range == HAWSER__TREE_NOT_NEGATIVE ? ">= 0" : range ? "> 0" : "finite";
	char sentence[320], shown[HAWSER__SHOWN];
	enum hawser__number answer;
	enum hawser_status status = hawser__tree_text(reader, &text, tree, what);

	if (status)
		return status;
	answer = hawser__units_read(&reader->units, value, text, unit);
	hawser__shown(shown, text);
	if (answer != HAWSER__NUMBER_OK) {
		hawser__units_explain(sentence, sizeof sentence, answer, text, unit);
		if (answer == HAWSER__NUMBER_DATABASE)
			return hawser__fail(reader->report, HAWSER_ERR_IO, "scene", "%s %s", what, sentence);
		return hawser__reader_fail(reader, &tree->at, "%s: \"%s\" %s", what, shown, sentence);
	}
	if (range == HAWSER__TREE_POSITIVE_OR_INF) {
		if (isinf(*value) && *value > 0.0)
			return HAWSER_OK;
		range = HAWSER__TREE_POSITIVE;
	}
	if (isfinite(*value) && fabs(*value) <= 1e100 &&
	    !(range == HAWSER__TREE_POSITIVE && *value < 1e-100) &&
	    !(range == HAWSER__TREE_NOT_NEGATIVE && *value < 0.0))
		return HAWSER_OK;
	if (range && !isfinite(*value))
		return hawser__reader_fail(reader, &tree->at, "%s: \"%s\" is not finite: give a number that is "
		                           "%s%s%s%s", what, shown, rule, strcmp(unit, "1") ? ", in " : "",
		                           strcmp(unit, "1") ? unit : "", isinf(*value) && *value > 0.0 &&
		                           !strcmp(unit, "N") ? "; of a cable that hardly stretches, an EA of "
		                           "1e6 times its tension" : "");
	return hawser__reader_fail(reader, &tree->at, "%s: \"%s\" is out of range: it must be %s%s%s", what,
	                           shown, rule, strcmp(unit, "1") ? ", in " : "",
	                           strcmp(unit, "1") ? unit : "");
}

enum hawser_status hawser__tree_vector(struct hawser__reader *reader, double *value, int count,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit)
{
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || tree->children != count)
		return hawser__reader_fail(reader, &tree->at, "%s must be a list of %d numbers in %s, along "
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
	return hawser__reader_fail(reader, &tree->at, "%s: \"%s\" must be %s", what,
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
		return hawser__reader_fail(reader, &tree->at, "%s: \"%s\" is no name: at most %d letters, "
		                           "digits, _ and -, and not only digits", what,
		                           hawser__shown(shown, text), HAWSER__TREE_NAME - 1);
	memcpy(name, text, length + 1);
	return HAWSER_OK;
}

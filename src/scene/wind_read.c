/* scene/wind_read.c - the lists of a wind, of spans and of nets: sums of powers, rows of the scene, and
 * rows of a file.
 *
 * A file has a row a line, numbers between blanks, tabs or commas; behind # are comments. A first line
 * of names may stand above them: angles are in degrees if there is "deg" in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/locale.h"
#include "scene/tree_keys.h"
#include "scene/tree.h"

enum { WHAT = 64 };

/* A key of at most HAWSER_WIND_POWERS numbers that is given as a list. */
static enum hawser_status powers(struct hawser__reader *reader, double *value, int *count,
                                 const struct hawser__tree *wind, const char *key, const char *of)
{
	const struct hawser__tree *tree = hawser__tree_find(wind, key);
	enum hawser_status status = HAWSER_OK;

	*count = tree ? 0 : *count;
	if (!tree || tree->kind != HAWSER__SEQUENCE)
		return HAWSER_OK;
	if (tree->children < 1 || tree->children > HAWSER_WIND_POWERS)
		return hawser__reader_fail(reader, &tree->value, "%s.%s has %d values: give a number, or a "
		                           "list of 1 to %d numbers", of, key, tree->children,
		                           HAWSER_WIND_POWERS);
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next, ++*count) {
		char what[WHAT];

		snprintf(what, sizeof what, "%.40s.%.8s[%d]", of, key, *count);
		status = hawser__tree_number(reader, &value[*count], one, what, "1", HAWSER__TREE_ANY);
	}
	return status;
}

/* Rows [HAWSER_WIND_ROWS][columns] of numbers whose first ones ascend. The unit is that of the first
 * one. */
struct rows {
	const char *key, *unit;
	int columns, least;
	double *value;
	int *count;
};

/* The row of the table of keys for the items of this list. */
static const struct hawser__tree_key *item_of(const struct rows *rows, const char *of)
{
	char path[HAWSER__TEXT_ROOM];

	snprintf(path, sizeof path, "%s.%s[]", of, rows->key);
	return hawser__tree_next(NULL, path);
}

static enum hawser_status row_of(struct hawser__reader *reader, const struct rows *rows,
                                 const struct hawser__tree *tree, const char *what,
                                 const struct hawser__tree_key *row, double *to)
{
	const struct hawser__tree *one = tree->child;
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || tree->children != rows->columns)
		return hawser__reader_fail(reader, &tree->at, "%s must be a list of %d numbers: %s", what,
		                           rows->columns, row->doc);
	for (int c = 0; c < rows->columns && !status; c++, one = one->next)
		status = hawser__tree_number(reader, &to[c], one, what, c ? "1" : rows->unit, row->range);
	return status;
}

/* The numbers of a line: as many as there are columns, or -1; 0 of an empty one. */
static int split(double *to, const struct rows *rows, char *line)
{
	int count = 0;
	char *at = line, *end;

	line[strcspn(line, "#\r\n")] = '\0';
	for (at += strspn(at, " \t,;"); *at; at = end + strspn(end, " \t,;")) {
		double value = strtod(at, &end);

		if (end == at || !isfinite(value) || count == rows->columns)
			return -1;
		to[count++] = value;
	}
	return count == 0 || count == rows->columns ? count : -1;
}

static enum hawser_status lines(struct hawser__reader *reader, const struct rows *rows,
                                const struct hawser__tree *tree, const char *what, FILE *file)
{
	double per_angle = 1.0, one[3];
	char line[512];
	int n = 0, found;

	for (int number = 1, first = 1; fgets(line, sizeof line, file); number++) {
		int degrees = strstr(line, "deg") != NULL;

		found = split(one, rows, line);
		if (found < 0 && first && strpbrk(line, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"))
			per_angle = degrees && !strcmp(rows->unit, "rad") ? M_PI/180.0 : 1.0;
		else if (found < 0)
			return hawser__reader_fail(reader, &tree->value, "%s: %s:%d: a line must have %d numbers, "
			                           "as the rows of a scene", what, tree->text, number,
			                           rows->columns);
		first = first && found == 0;
		if (found <= 0)
			continue;
		one[0] *= per_angle;
		if (n == HAWSER_WIND_ROWS || (n > 0 && !(one[0] > rows->value[(n - 1)*rows->columns])))
			return hawser__reader_fail(reader, &tree->value, "%s: %s:%d: %s", what, tree->text, number,
			                           n == HAWSER_WIND_ROWS ? "there are more than 256 rows"
			                           : "the first number is not above that of the row before");
		memcpy(rows->value + n++*rows->columns, one, (size_t)rows->columns*sizeof *one);
	}
	*rows->count = n;
	return HAWSER_OK;
}

static enum hawser_status from_file(struct hawser__reader *reader, const struct rows *rows,
                                    const struct hawser__tree *tree, const char *what)
{
	FILE *file = fopen(tree->text, "r");
	struct hawser__locale locale;
	enum hawser_status status;

	if (!file)
		return hawser__reader_fail(reader, &tree->value, "%s: %s: %s: give a list of rows, or a file "
		                           "that can be read", what, tree->text, strerror(errno));
	hawser__locale_begin(&locale);
	status = lines(reader, rows, tree, what, file);
	hawser__locale_end(&locale);
	fclose(file);
	return status;
}

static enum hawser_status read_rows(struct hawser__reader *reader, const struct rows *rows,
                                    const struct hawser__tree *wind, const char *what, const char *of)
{
	const struct hawser__tree *tree = hawser__tree_find(wind, rows->key);
	const struct hawser__tree_key *item = item_of(rows, of);
	enum hawser_status status = HAWSER_OK;
	double *to = rows->value;
	char list[WHAT], called[WHAT + 16];
	int count, n = 0;

	if (!tree)
		return HAWSER_OK;
	snprintf(list, sizeof list, "%.40s.%.10s", what, rows->key);
	if (tree->kind == HAWSER__SCALAR)
		status = from_file(reader, rows, tree, list);
	count = tree->kind == HAWSER__SCALAR ? *rows->count : tree->children;
	if (!status && (count < rows->least || count > HAWSER_WIND_ROWS))
		return hawser__reader_fail(reader, &tree->value, "%s has %d rows: give %d to %d", list, count,
		                           rows->least, HAWSER_WIND_ROWS);
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next, n++) {
		snprintf(called, sizeof called, "%s[%d]", list, n);
		status = row_of(reader, rows, one, called, item, to);
		if (!status && n > 0 && !(to[0] > to[-rows->columns]))
			return hawser__reader_fail(reader, &one->at, "%s begins with %g, which is not above the "
			                           "%g of the row before: write the rows in ascending order",
			                           called, to[0], to[-rows->columns]);
		to += rows->columns;
	}
	*rows->count = count;
	return status;
}

enum hawser_status hawser__wind_lists(struct hawser__reader *reader, struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *of)
{
	const struct rows rows[] = {
		{"profile", strncmp(of, "net", 3) ? "1" : "m", 2, 1, wind->profile[0], &wind->profiles},
		{"table", "rad", 3, 3, wind->table[0], &wind->tables},
		{"reynolds", "1", 2, 3, wind->reynolds[0], &wind->crises}};
	enum hawser_status status = powers(reader, wind->drag, &wind->drags, tree, "drag", what);

	if (hawser__tree_find(tree, "drag") || hawser__tree_find(tree, "lift"))
		wind->tables = 0; /* of the wind that a cable's section takes the rest from */
	if (!status)
		status = powers(reader, wind->lift, &wind->lifts, tree, "lift", what);
	for (size_t i = 0; i < sizeof rows/sizeof *rows && !status; i++)
		status = read_rows(reader, &rows[i], tree, what, of);
	return status;
}

enum hawser_status hawser__wind_check(struct hawser__reader *reader, const struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what)
{
	const struct hawser__tree *drag = hawser__tree_find(tree, "drag");
	const struct hawser__tree *lift = hawser__tree_find(tree, "lift");
	const struct hawser__tree *table = hawser__tree_find(tree, "table");

	if (table && (drag || lift))
		return hawser__reader_fail(reader, &table->at, "%s.table contradicts %s.%s: drag and lift are "
		                           "a table or sums of powers, remove one of them", what, what,
		                           drag ? "drag" : "lift");
	if (!wind->tables && !wind->crises && !wind->wake.present && !drag && wind->drags == 0 &&
	    wind->drag[0] == 0.0)
		return hawser__reader_fail(reader, &tree->at, "%s has no drag: give %s.drag, or %s.table, such "
		                           "as drag: 1.2 of a round cable", what, what, what);
	if ((wind->crises > 0) != (wind->viscosity > 0.0))
		return hawser__reader_fail(reader, &tree->at, "%s.reynolds and %s.viscosity belong together: "
		                           "give both, or none (air: 1.5e-5 m^2/s)", what, what);
	return HAWSER_OK;
}

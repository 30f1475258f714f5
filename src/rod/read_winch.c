/* rod/read_winch.c - read the winch of a scene of kind `rod` or `tow`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "rod/read.h"

/* Column k of the rows from a list of numbers. */
static enum hawser_status column(struct hawser__reader *reader, struct hawser_rod_winch *winch,
                                 const struct hawser__tree *list, int k, const char *what,
                                 const char *unit, enum hawser__tree_range range)
{
	const struct hawser__tree *one = list->child;
	enum hawser_status status = HAWSER_OK;

	if (list->kind != HAWSER__SEQUENCE || list->children < 2)
		return hawser__reader_fail(reader, &list->at, "%s must be a list of at least two numbers in %s",
		                           what, unit);
	if (winch->rows && list->children != winch->rows)
		return hawser__reader_fail(reader, &list->at, "%s: %d numbers for %d times", what,
		                           list->children, winch->rows);
	if (!winch->row)
		winch->row = calloc((size_t)list->children, sizeof *winch->row);
	if (!winch->row)
		return hawser__no_memory(reader->report, "scene");
	winch->rows = list->children;
	for (int i = 0; i < winch->rows && !status; i++, one = one->next) {
		status = hawser__tree_number(reader, &winch->row[i][k], one, what, unit, range);
		if (!status && k == 0 && i > 0 && !(winch->row[i][0] > winch->row[i - 1][0]))
			status = hawser__reader_fail(reader, &one->at, "%s: %.9g s comes after %.9g s: times must "
			                             "grow", what, winch->row[i][0], winch->row[i - 1][0]);
	}
	return status;
}

static enum hawser_status table(struct hawser__reader *reader, struct hawser_rod_winch *winch,
                                const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *times = hawser__tree_find(tree, "times");
	const struct hawser__tree *speeds = hawser__tree_find(tree, "speeds");
	const struct hawser__tree *lengths = hawser__tree_find(tree, "lengths");
	char what[HAWSER__ROD_CALLED];
	enum hawser_status status;

	if (!times || (speeds != NULL) == (lengths != NULL))
		return hawser__reader_fail(reader, &tree->at, "%s: give speed, or times with either speeds or "
		                           "lengths", section);
	winch->lengths = lengths != NULL;
	snprintf(what, sizeof what, "%s.times", section);
	status = column(reader, winch, times, 0, what, "s", HAWSER__TREE_ANY);
	snprintf(what, sizeof what, "%s.%s", section, lengths ? "lengths" : "speeds");
	return status ? status
		: column(reader, winch, lengths ? lengths : speeds, 1, what, lengths ? "m" : "m/s",
		         lengths ? HAWSER__TREE_POSITIVE : HAWSER__TREE_ANY);
}

enum hawser_status hawser__rod_read_winch(struct hawser__reader *reader, struct hawser_rod_winch *winch,
                                          const struct hawser__tree *tree, const char *section,
                                          const char *of)
{
	static const char *const other[] = {"times", "speeds", "lengths"};
	enum hawser_status status = hawser__tree_fill(reader, winch, tree, section, of);

	winch->on = 1;
	if (status)
		return status;
	if (!hawser__tree_find(tree, "speed") && !hawser__tree_find(tree, "rise"))
		return table(reader, winch, tree, section);
	for (int i = 0; i < 3; i++)
		if (hawser__tree_find(tree, other[i]))
			return hawser__reader_fail(reader, &hawser__tree_find(tree, other[i])->at, "%s.%s: the "
			                           "speed is given by %s.speed: leave out one of them", section,
			                           other[i], section);
	return hawser__tree_find(tree, "speed") ? status
		: hawser__reader_fail(reader, &tree->at, "%s.speed is missing: give it in m/s", section);
}

/* tow/read_waypoints.c - read waypoints, and derivatives that are given at them and at the ends.
 *
 * A waypoint is [t, x, y, z], or a mapping with t, at and derivatives. `ends` is a list of
 * derivatives that are 0 at both ends, or a mapping with start and end, each such a list or a mapping
 * of vectors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/read.h"

enum { MOST = 100000, /* waypoints of a scene: more belong into a file */
       NAMED = 4      /* velocity to snap; flat reaches higher */ };

/* The derivatives that have a name in scenes. */
static const char *const order[NAMED + 1] = {"at", "velocity", "acceleration", "jerk", "snap"};

/* The derivatives of a mapping, which belongs to the keys `of`, are given. */
static enum hawser_status vectors(struct hawser__reader *reader, struct hawser_waypoint *point,
                                  const struct hawser__tree *tree, const char *section, const char *of)
{
	enum hawser_status status = hawser__tree_fill(reader, point, tree, section, of);

	for (int k = 1; k <= NAMED && !status; k++)
		point->given[k] |= hawser__tree_find(tree, order[k]) != NULL;
	return status;
}

/* All derivatives up to this order that are not given are 0. */
static enum hawser_status mapping(struct hawser__reader *reader, struct hawser_waypoint *point,
                                  const struct hawser__tree *tree, const char *section)
{
	enum hawser_status status = vectors(reader, point, tree, section, "tow.tow.waypoints[]");
	const struct hawser__tree *flat = hawser__tree_find(tree, "flat");
	char what[HAWSER__TOW_WHAT];
	int most = 0;

	snprintf(what, sizeof what, "%.60s.flat", section);
	if (!status && flat)
		status = hawser__tree_value(reader, &most, flat, what, "tow.tow.waypoints[].flat");
	for (int k = 1; k <= most && !status; k++)
		point->given[k] = 1;
	return status;
}

static enum hawser_status waypoint(struct hawser__reader *reader, struct hawser_waypoint *point,
                                   const struct hawser__tree *tree, int index)
{
	char what[HAWSER__TOW_WHAT];
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;

	snprintf(what, sizeof what, "tow.waypoints[%d]", index);
	if (tree->kind == HAWSER__MAPPING)
		return mapping(reader, point, tree, what);
	if (tree->kind != HAWSER__SEQUENCE || tree->children != 4)
		return hawser__reader_fail(reader, &tree->at, "%s must be [t, x, y, z] in s and m, or a "
		                           "mapping with t, at and derivatives, such as {t: 30 s, at: [100 "
		                           "m, 0, 0], velocity: [6 m/s, 0, 0]}", what);
	status = hawser__tree_number(reader, &point->t, child, what, "s", HAWSER__TREE_ANY);
	for (int axis = 0; axis < 3 && !status; axis++) {
		child = child->next;
		status = hawser__tree_number(reader, &point->at[0][axis], child, what, "m", HAWSER__TREE_ANY);
	}
	return status;
}

enum hawser_status hawser__tow_waypoints(struct hawser__reader *reader, struct hawser_tow *tow,
                                         const struct hawser__tree *list)
{
	enum hawser_status status = HAWSER_OK;

	if (list->kind != HAWSER__SEQUENCE || list->children < 2)
		return hawser__reader_fail(reader, &list->at, "tow.waypoints must be a list of at least "
		                           "two waypoints [t, x, y, z], such as [[0 s, 0, 0, 0], [30 s, "
		                           "100 m, 0, 0]]");
	if (list->children > MOST)
		return hawser__reader_fail(reader, &list->at, "%d waypoints are more than %d: put them "
		                           "into a file of lines t x y z, and give tow.file", list->children,
		                           MOST);
	tow->waypoint = calloc((size_t)list->children, sizeof *tow->waypoint);
	if (!tow->waypoint)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = list->child; one && !status; one = one->next) {
		status = waypoint(reader, &tow->waypoint[tow->waypoints], one, tow->waypoints);
		tow->waypoints++;
	}
	return status;
}

/* A list of derivatives that are 0. */
static enum hawser_status zeros(struct hawser__reader *reader, struct hawser_waypoint *point,
                                const struct hawser__tree *list, const char *what)
{
	const char *words[NAMED];
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < NAMED; k++)
		words[k] = order[k + 1];
	for (const struct hawser__tree *one = list->child; one && !status; one = one->next) {
		int index = 0;

		status = hawser__tree_word(reader, &index, one, what, words, NAMED);
		if (!status && point->given[index + 1])
			status = hawser__reader_fail(reader, &one->at, "%s: the %s of this waypoint is already "
			                             "given: remove one of them", what, words[index]);
		if (!status)
			point->given[index + 1] = 1;
	}
	return status;
}

static enum hawser_status one_end(struct hawser__reader *reader, struct hawser_waypoint *point,
                                  const struct hawser__tree *tree, const char *what)
{
	enum hawser_status status = HAWSER_OK;

	if (!tree)
		return HAWSER_OK;
	if (tree->kind == HAWSER__SEQUENCE)
		return zeros(reader, point, tree, what);
	for (int k = 1; k <= NAMED && !status; k++) {
		const struct hawser__tree *one = hawser__tree_find(tree, order[k]);

		if (one && point->given[k])
			status = hawser__reader_fail(reader, &one->at, "%s: the %s of this waypoint is already "
			                             "given: remove one of them", what, order[k]);
	}
	return status ? status : vectors(reader, point, tree, what, "tow.tow.ends.start");
}

enum hawser_status hawser__tow_ends(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *ends)
{
	struct hawser_waypoint *first = &tow->waypoint[0], *last = &tow->waypoint[tow->waypoints - 1];
	enum hawser_status status;

	if (ends->kind == HAWSER__SEQUENCE) {
		status = zeros(reader, first, ends, "tow.ends");
		return status ? status : zeros(reader, last, ends, "tow.ends");
	}
	if (ends->kind == HAWSER__SCALAR)
		return hawser__reader_fail(reader, &ends->at, "tow.ends must be a list of derivatives that "
		                           "are 0 at both ends, such as [velocity, acceleration], or a "
		                           "mapping with start and end");
	status = hawser__tree_keys(reader, ends, "tow.ends", "tow.tow.ends");
	if (!status)
		status = one_end(reader, first, hawser__tree_find(ends, "start"), "tow.ends.start");
	return status ? status : one_end(reader, last, hawser__tree_find(ends, "end"), "tow.ends.end");
}

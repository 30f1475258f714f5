/* rod/read_loads.c - read the loads of a scene of kind `rod`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/read.h"
#include "rod/so3.h"

/* A place on the rod: start, end, or m from the start. */
static enum hawser_status place(struct hawser__reader *reader, double *s, const struct hawser_rod *rod,
                                const struct hawser__tree *tree, const char *what)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->text && !strcmp(tree->text, "start"))
		*s = 0.0;
	else if (tree->text && !strcmp(tree->text, "end"))
		*s = rod->length;
	else if (tree->text && isalpha((unsigned char)*tree->text))
		status = hawser__reader_fail(reader, &tree->value, "%s: \"%.40s\" must be start, end, or a "
		                             "length in m from the start", what, tree->text);
	else
		status = hawser__tree_number(reader, s, tree, what, "m", HAWSER__TREE_NOT_NEGATIVE);
	if (!status && *s > rod->length*(1.0 + 1e-12))
		status = hawser__reader_fail(reader, &tree->at, "%s: %.9g m is beyond the end of the rod at "
		                             "%.9g m", what, *s, rod->length);
	return status;
}

static enum hawser_status where(struct hawser__reader *reader, struct hawser_rod_load *load,
                                const struct hawser_rod *rod, const struct hawser__tree *tree,
                                const char *section)
{
	const struct hawser__tree *at = hawser__tree_find(tree, "at");
	const struct hawser__tree *from = hawser__tree_find(tree, "from");
	const struct hawser__tree *to = hawser__tree_find(tree, "to");
	char what[HAWSER__ROD_CALLED];
	enum hawser_status status = HAWSER_OK;

	if (at && (from || to))
		return hawser__reader_fail(reader, &at->at, "%s has at and %s: give at for a load at a point, "
		                           "from and to for one per length", section, from ? "from" : "to");
	load->distributed = !at;
	load->to = rod->length;
	if (at) {
		snprintf(what, sizeof what, "%s.at", section);
		status = place(reader, &load->from, rod, at, what);
		load->to = load->from;
		return status;
	}
	snprintf(what, sizeof what, "%s.from", section);
	if (from)
		status = place(reader, &load->from, rod, from, what);
	snprintf(what, sizeof what, "%s.to", section);
	if (!status && to)
		status = place(reader, &load->to, rod, to, what);
	if (!status && !(load->from < load->to))
		status = hawser__reader_fail(reader, to ? &to->at : &tree->at, "%s: from %.9g m to %.9g m is "
		                             "no part of the rod", section, load->from, load->to);
	return status;
}

/* Force or moment, along the axes of the scene or of the section. */
static enum hawser_status vector(struct hawser__reader *reader, double *value,
                                 const struct hawser_rod_load *load, const struct hawser__tree *tree,
                                 const char *section, const char *key, const char *const unit[2])
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	char what[HAWSER__ROD_CALLED];

	snprintf(what, sizeof what, "%s.%s", section, key);
	if (!one)
		return HAWSER_OK;
	if (load->follower && one->children != 3)
		return hawser__reader_fail(reader, &one->at, "%s must be a list of 3 numbers for e1, e2 and e3 "
		                           "in %s", what, unit[load->distributed]);
	return hawser__tree_vector(reader, value, 3, one, what, unit[load->distributed]);
}

/* [[t, factor], ..]: t does not fall. */
static enum hawser_status factor(struct hawser__reader *reader, struct hawser_rod_load *load,
                                 const struct hawser__tree *tree, const char *section)
{
	char what[HAWSER__ROD_CALLED];
	enum hawser_status status = HAWSER_OK;

	snprintf(what, sizeof what, "%s.factor", section);
	if (tree->kind != HAWSER__SEQUENCE || tree->children < 2)
		return hawser__reader_fail(reader, &tree->at, "%s must be a list of times and factors, such as "
		                           "[[0 s, 0], [0.5 s, 1], [1 s, 0]]", what);
	load->factor = calloc((size_t)tree->children, sizeof *load->factor);
	if (!load->factor)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		double *row = load->factor[load->factors];

		if (one->kind != HAWSER__SEQUENCE || one->children != 2)
			return hawser__reader_fail(reader, &one->at, "%s: each must be a list [time, factor]",
			                           what);
		status = hawser__tree_number(reader, &row[0], one->child, what, "s", HAWSER__TREE_NOT_NEGATIVE);
		if (!status)
			status = hawser__tree_number(reader, &row[1], one->child->next, what, "1",
			                             HAWSER__TREE_ANY);
		if (!status && load->factors && row[0] < row[-2])
			status = hawser__reader_fail(reader, &one->at, "%s: the time %.9g s comes after %.9g s",
			                             what, row[0], row[-2]);
		load->factors++;
	}
	return status;
}

static enum hawser_status load(struct hawser__reader *reader, struct hawser_rod *rod,
                               const struct hawser__tree *tree)
{
	static const char *const force[] = {"N", "N/m"}, *const moment[] = {"N.m", "N"};
	struct hawser_rod_load *to = &rod->load[rod->loads];
	const struct hawser__tree *history;
	char section[32];
	enum hawser_status status;

	snprintf(section, sizeof section, "loads.i%d", rod->loads);
	rod->loads++; /* cleared with what it has */
	status = hawser__tree_fill(reader, to, tree, section, "rod.loads[]");
	if (!status)
		status = where(reader, to, rod, tree, section);
	if (!status)
		status = vector(reader, to->force, to, tree, section, "force", force);
	if (!status)
		status = vector(reader, to->moment, to, tree, section, "moment", moment);
	if (!status && hawser__dot(to->force, to->force) == 0.0 &&
	    hawser__dot(to->moment, to->moment) == 0.0)
		status = hawser__reader_fail(reader, &tree->at, "%s: no force and no moment: give force: [x, "
		                             "y, z] or moment: [x, y, z], or leave it out", section);
	history = hawser__tree_find(tree, "factor");
	return status || !history ? status : factor(reader, to, history, section);
}

enum hawser_status hawser__rod_read_loads(struct hawser__reader *reader, struct hawser_rod *rod,
                                          const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	rod->load = hawser__tree_items(reader, &status, tree, "loads", sizeof *rod->load, 0, 0,
	                               "{at: end, force: [0 N, -5 N, 0 N]}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next)
		status = load(reader, rod, one);
	return status;
}

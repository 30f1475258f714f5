/* ropeway/read/towers.c - read the towers of a ropeway.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/read/read.h"

enum { SHEAVES = 100 }; /* most of a battery: real ones have up to 16 */

static enum hawser_status train(struct hawser__reader *reader, struct hawser_ropeway_tower *tower,
                                const struct hawser__tree *tree, const char *section)
{
	double count = 0.0, gap;
	char what[HAWSER__CALLED];
	enum hawser_status status;

	snprintf(what, sizeof what, "%.60s.sheaves", section);
	status = hawser__tree_keys(reader, tree, what, "ropeway.ropeway.towers[].sheaves");
	if (!status)
		status = hawser__ropeway_number(reader, &count, tree, what, "count", "1",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status && (count != floor(count) || count > SHEAVES))
		status = hawser__reader_fail(reader, &hawser__tree_find(tree, "count")->at,
		                             "%s.count: %.9g is not "
		                             "a whole number from 1 to %d",
		                             what, count, SHEAVES);
	if (!status)
		status = hawser__ropeway_number(reader, &tower->spacing, tree, what, "spacing", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status)
		status = hawser__ropeway_number(reader, &tower->sheave, tree, what, "radius", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (status)
		return status;
	tower->sheaves = (int)count;
	if (!(tower->radius > tower->sheave))
		return hawser__reader_fail(
			reader, &tree->at,
			"%s: the battery's radius %.9g m, of the circle that "
			"its sheaves touch from within, must be larger than the %.9g m of a "
			"sheave",
			what, tower->radius, tower->sheave);
	if ((tower->sheaves - 1)*tower->spacing > 2.0*tower->radius)
		return hawser__reader_fail(reader, &tree->at, "%s: %d sheaves at %.9g m are longer than the "
		                           "battery's diameter: give it a larger radius than %.9g m", what,
		                           tower->sheaves, tower->spacing, tower->radius);
	gap = 2.0*(tower->radius - tower->sheave)*sin(0.5*tower->spacing/tower->radius);
	if (tower->sheaves > 1 && gap < 2.0*tower->sheave)
		return hawser__reader_fail(reader, &tree->at,
		                           "%s: the middles of two sheaves are %.9g m apart, "
		                           "less than two radii of %.9g m: give a larger spacing",
		                           what, gap, tower->sheave);
	return HAWSER_OK;
}

static enum hawser_status name_of(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                  const struct hawser__tree *tree)
{
	struct hawser_ropeway_tower *tower = &rw->tower[rw->towers];
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	const char *text = "";
	enum hawser_status status = HAWSER_OK;

	snprintf(tower->name, sizeof tower->name, "p%d", rw->towers);
	if (name)
		status = hawser__tree_text(reader, &text, name, "towers.name");
	if (!status && name)
		status = hawser__tree_name(reader, tower->name, name, text, "towers.name");
	for (int i = 0; i < rw->towers && !status; i++)
		if (!strcmp(rw->tower[i].name, tower->name))
			status = hawser__reader_fail(reader, name ? &name->at : &tree->at,
			                             "two towers have the name %s: give different ones (without "
			                             "one, the first is p0, the next p1 and so on)", tower->name);
	return status;
}

/* A point has no axis to turn about. */
static enum hawser_status inertia(struct hawser__reader *reader, struct hawser_ropeway_tower *tower,
                                  const struct hawser__tree *tree, const char *section)
{
	double radius = tower->sheaves ? tower->sheave : tower->radius;
	enum hawser_status status = hawser__ropeway_number(reader, &tower->inertia, tree, section,
	                                                   "inertia", "kg m2", HAWSER__TREE_NOT_NEGATIVE,
	                                                   0);

	if (!status && tower->inertia > 0.0 && !(radius > 0.0))
		status = hawser__reader_fail(reader, &hawser__tree_find(tree, "inertia")->at,
		                             "%s.inertia: a sheave of the radius 0 does not turn: give it a "
		                             "radius, or leave the inertia out", section);
	return status;
}

/* Towers are given from the bottom station on, and are between the stations. */
static enum hawser_status order(struct hawser__reader *reader, const struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser_ropeway_tower *tower = &rw->tower[rw->towers];
	double before = rw->towers ? tower[-1].at[0] : rw->bottom[0];

	if (!(tower->at[0] > before))
		return hawser__reader_fail(reader, &tree->at,
		                           "tower %s: x = %.9g m is not beyond x = %.9g m of %s: "
		                           "give the towers by x, from the bottom station on",
		                           tower->name, tower->at[0], before,
		                           rw->towers ? tower[-1].name : "bottom.at");
	if (!(tower->at[0] < rw->top[0]))
		return hawser__reader_fail(reader, &tree->at, "tower %s: x = %.9g m is not below x = %.9g m of "
		                           "top.at", tower->name, tower->at[0], rw->top[0]);
	return HAWSER_OK;
}

static enum hawser_status tower_of(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                   const struct hawser__tree *tree)
{
	static const char *const battery[] = {"auto", "support", "compression"};
	struct hawser_ropeway_tower *tower = &rw->tower[rw->towers];
	const struct hawser__tree *one;
	char section[HAWSER__CALLED], what[HAWSER__CALLED];
	int index = 0;
	enum hawser_status status = hawser__tree_keys(reader, tree, "a tower", "ropeway.ropeway.towers[]");

	if (!status)
		status = name_of(reader, rw, tree);
	if (status)
		return status;
	tower->file_line = tree->at.set ? 0 : (int)tree->at.line;
	snprintf(section, sizeof section, "towers.%s", tower->name);
	status = hawser__ropeway_place(reader, tower->at, tree, section);
	if (!status)
		status = order(reader, rw, tree);
	one = hawser__tree_find(tree, "battery");
	snprintf(what, sizeof what, "%.60s.battery", section);
	if (one && !status)
		status = hawser__tree_word(reader, &index, one, what, battery, 3);
	tower->battery = (enum hawser_ropeway_battery)index;
	if (!status)
		status = hawser__ropeway_number(reader, &tower->radius, tree, section, "radius", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (!status)
		status = hawser__ropeway_number(reader, &tower->friction, tree, section, "friction", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status && tower->friction > 10.0) /* the limit of hawser_line_solve */
		return hawser__reader_fail(reader, &hawser__tree_find(tree, "friction")->at, "%s.friction = "
		                           "%.9g is out of range: it must be from 0 to 10, a coefficient such "
		                           "as 0.03 and no per cent", section, tower->friction);
	one = hawser__tree_find(tree, "sheaves");
	if (!status && one)
		status = train(reader, tower, one, section);
	return status ? status : inertia(reader, tower, tree, section);
}

enum hawser_status hawser__ropeway_towers(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                          const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at, "towers must be a list of mappings, such as "
		                           "[{at: [40 m, 0 m], battery: support, radius: 12 m}]");
	rw->tower = calloc((size_t)tree->children + 1, sizeof *rw->tower);
	if (!rw->tower)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		status = tower_of(reader, rw, one);
		rw->towers += !status;
	}
	return status;
}

/* ropeway/read/towers.c - read the towers of a ropeway.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ropeway/read/read.h"

static enum hawser_status train(struct hawser__reader *reader, const struct hawser_ropeway_tower *tower,
                                const struct hawser__tree *tree, const char *section)
{
	char what[HAWSER__CALLED];
	double gap;

	snprintf(what, sizeof what, "%.60s.sheaves", section);
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
	struct hawser_ropeway_tower *tower = &rw->tower[rw->towers];
	const struct hawser__tree *sheaves = hawser__tree_find(tree, "sheaves");
	char section[HAWSER__CALLED];
	enum hawser_status status = hawser__tree_name_item(reader, tower->name, sizeof *tower, rw->towers,
	                                                   tree, "towers", 'p');

	tower->file_line = tree->at.set ? 0 : (int)tree->at.line;
	snprintf(section, sizeof section, "towers.%s", tower->name);
	if (!status)
		status = hawser__tree_fill(reader, tower, tree, section, "ropeway.ropeway.towers[]");
	if (!status)
		status = order(reader, rw, tree);
	if (!status && sheaves)
		status = train(reader, tower, sheaves, section);
	if (!status && tower->inertia > 0.0 && !((sheaves ? tower->sheave : tower->radius) > 0.0))
		status = hawser__reader_fail(reader, &hawser__tree_find(tree, "inertia")->at,
		                             "%s.inertia: a sheave of the radius 0 does not turn: give it a "
		                             "radius, or leave the inertia out", section);
	return status;
}

enum hawser_status hawser__ropeway_towers(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                          const struct hawser__tree *tree)
{
	enum hawser_status status;

	rw->tower = hawser__tree_items(reader, &status, tree, "towers", sizeof *rw->tower, 0, 0,
	                               "{at: [40 m, 0 m], battery: support, radius: 12 m}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next) {
		status = tower_of(reader, rw, one);
		rw->towers += !status;
	}
	return status;
}

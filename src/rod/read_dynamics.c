/* rod/read_dynamics.c - what moving ends of a scene of kind `rod` ask for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>

#include "rod/read.h"
#include "rod/so3.h"

enum hawser_status hawser__rod_check_drive(struct hawser__reader *reader, struct hawser_rod *rod,
                                           int end, const struct hawser__tree *tree)
{
	const struct hawser__tree *turn = hawser__tree_find(tree, "spin");
	const struct hawser__tree *path = hawser__tree_find(tree, "path");
	const char *section = end ? "end" : "start";
	double *axis = rod->drive[end].axis, length;
	char what[HAWSER__ROD_CALLED];
	enum hawser_status status;

	if (turn && rod->hold[end] != HAWSER_ROD_CLAMPED)
		return hawser__reader_fail(reader, &turn->at, "%s.spin: an end that spins must be held by its "
		                           "axes too: give hold: clamped, or leave the spin out", section);
	if (path && rod->hold[end] == HAWSER_ROD_FREE)
		return hawser__reader_fail(reader, &path->at, "%s.path: the end is free: give hold: hinged or "
		                           "hold: clamped, or leave the path out", section);
	if (!turn)
		return HAWSER_OK;
	snprintf(what, sizeof what, "%s.spin.axis", section);
	status = hawser__rod_direction(reader, axis, hawser__tree_find(turn, "axis"), what);
	length = sqrt(hawser__dot(axis, axis));
	for (int k = 0; k < 3 && !status; k++)
		axis[k] /= length;
	return status;
}

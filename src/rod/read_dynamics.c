/* rod/read_dynamics.c - read what motions need of a scene of kind `rod`: damping, steps, moving ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/read.h"
#include "rod/so3.h"

enum hawser_status hawser__rod_read_dynamics(struct hawser__reader *reader, struct hawser_rod *rod,
                                             const struct hawser__tree *root)
{
	const struct hawser__tree *damping = hawser__tree_find(root, "damping"), *rho;
	const struct hawser__tree *tree = hawser__tree_find(root, "dynamics"), *from;
	static const char *const states[] = {"equilibrium", "rest"};
	enum hawser_status status = damping ? hawser__tree_keys(reader, damping, "damping", "rod.damping")
	                                    : HAWSER_OK;

	if (!status && damping)
		status = hawser__tree_number_of(reader, &rod->alpha, damping, "damping", "alpha", "s^-1",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (status || !tree)
		return status;
	status = hawser__tree_keys(reader, tree, "dynamics", "rod.dynamics");
	if (!status)
		status = hawser__tree_number_of(reader, &rod->rho_inf, tree, "dynamics", "rho_inf", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	rho = hawser__tree_find(tree, "rho_inf");
	if (!status && rod->rho_inf > 1.0)
		status = hawser__reader_fail(reader, &rho->at, "dynamics.rho_inf: %.9g is above 1: from 0 "
		                             "(what is faster than the step is damped) to 1 (nothing is)",
		                             rod->rho_inf);
	from = hawser__tree_find(tree, "from");
	if (!status && from)
		status = hawser__tree_word(reader, &rod->from_rest, from, "dynamics.from", states, 2);
	return status ? status
		: hawser__tree_number_of(reader, &rod->step, tree, "dynamics", "step", "s",
		                         HAWSER__TREE_POSITIVE, 0);
}

static enum hawser_status spin(struct hawser__reader *reader, struct hawser_rod *rod, int end,
                               const struct hawser__tree *tree, const char *section)
{
	struct hawser_rod_drive *drive = &rod->drive[end];
	const struct hawser__tree *axis;
	char what[HAWSER__ROD_CALLED];
	double length;
	enum hawser_status status = hawser__tree_keys(reader, tree, section, "rod.start.spin");

	if (!status && rod->hold[end] != HAWSER_ROD_CLAMPED)
		status = hawser__reader_fail(reader, &tree->at, "%s: an end that spins must be held by its "
		                             "axes too: give hold: clamped, or leave the spin out", section);
	axis = hawser__tree_find(tree, "axis");
	if (!status && !axis)
		status = hawser__reader_fail(reader, &tree->at, "%s.axis is missing: give a direction, such as "
		                             "[0, 1, 0]", section);
	snprintf(what, sizeof what, "%s.axis", section);
	if (!status)
		status = hawser__rod_direction(reader, drive->axis, axis, what);
	length = sqrt(hawser__dot(drive->axis, drive->axis));
	for (int k = 0; k < 3 && !status; k++)
		drive->axis[k] /= length;
	if (!status)
		status = hawser__tree_number_of(reader, &drive->speed, tree, section, "speed", "rad/s",
		                                HAWSER__TREE_ANY, 1);
	return status ? status
		: hawser__tree_number_of(reader, &drive->rise, tree, section, "rise", "s",
		                         HAWSER__TREE_NOT_NEGATIVE, 0);
}

enum hawser_status hawser__rod_read_drive(struct hawser__reader *reader, struct hawser_rod *rod,
                                          int end, const struct hawser__tree *tree)
{
	const struct hawser__tree *turn = hawser__tree_find(tree, "spin");
	const struct hawser__tree *path = hawser__tree_find(tree, "path");
	char section[16], what[HAWSER__ROD_CALLED];
	const char *text = NULL;
	enum hawser_status status = HAWSER_OK;

	snprintf(section, sizeof section, end ? "end.spin" : "start.spin");
	if (turn)
		status = spin(reader, rod, end, turn, section);
	if (status || !path)
		return status;
	snprintf(what, sizeof what, end ? "end.path" : "start.path");
	if (rod->hold[end] == HAWSER_ROD_FREE)
		return hawser__reader_fail(reader, &path->at, "%s: the end is free: give hold: hinged or hold: "
		                           "clamped, or leave the path out", what);
	status = hawser__tree_text(reader, &text, path, what);
	if (!status && !(rod->drive[end].path = strdup(text)))
		status = hawser__no_memory(reader->report, "scene");
	return status;
}

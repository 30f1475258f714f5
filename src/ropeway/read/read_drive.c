/* ropeway/read/read_drive.c - read the drive of a ropeway, with its brake.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "ropeway/read/read.h"

static enum hawser_status brake(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *force;
	enum hawser_status status = hawser__tree_keys(reader, tree, "drive.brake",
	                                              "ropeway.ropeway.top.drive.brake");

	if (!status)
		status = hawser__ropeway_number(reader, &rw->brake, tree, "drive.brake", "deceleration",
		                                "m/s^2", HAWSER__TREE_POSITIVE, 0);
	if (!status)
		status = hawser__ropeway_number(reader, &rw->brake_force, tree, "drive.brake", "force", "N",
		                                HAWSER__TREE_POSITIVE, 0);
	force = hawser__tree_find(tree, "force");
	if (!status && force && rw->brake > 0.0)
		return hawser__reader_fail(reader, &force->at, "drive.brake has deceleration and force: give "
		                           "the deceleration that a controlled brake keeps, or the force "
		                           "of one "
		                           "that is applied");
	if (!status && !force && !(rw->brake > 0.0))
		return hawser__reader_fail(reader, &tree->at, "drive.brake needs deceleration (m/s^2) or force "
		                           "(N at the bullwheel's circumference)");
	return status;
}

enum hawser_status hawser__ropeway_drive(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                         const struct hawser__tree *tree)
{
	const struct {
		const char *key, *unit;
		double *to;
		enum hawser__tree_range range;
	} number[] = {
		{"speed", "m/s", &rw->speed, HAWSER__TREE_NOT_NEGATIVE},
		{"friction", "1", &rw->drive_friction, HAWSER__TREE_NOT_NEGATIVE},
		{"ramp", "s", &rw->ramp, HAWSER__TREE_NOT_NEGATIVE},
		{"wrap", "rad", &rw->wrap, HAWSER__TREE_POSITIVE},
		{"inertia", "kg m2", &rw->top_inertia, HAWSER__TREE_NOT_NEGATIVE},
		{"force", "N", &rw->drive_most, HAWSER__TREE_POSITIVE},
	};
	const struct hawser__tree *of;
	enum hawser_status status = hawser__tree_keys(reader, tree, "drive", "ropeway.ropeway.top.drive");

	rw->drive_line = tree->at.set ? 0 : (int)tree->at.line;
	for (size_t i = 0; i < sizeof number/sizeof *number && !status; i++)
		status = hawser__ropeway_number(reader, number[i].to, tree, "drive", number[i].key,
		                                number[i].unit, number[i].range, 0);
	rw->drive = hawser__tree_find(tree, "friction") != NULL;
	rw->coasts = hawser__tree_find(tree, "inertia") != NULL;
	of = hawser__tree_find(tree, "brake");
	return status || !of ? status : brake(reader, rw, of);
}

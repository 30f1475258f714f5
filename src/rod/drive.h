/* rod/drive.h - how a held end of a rod moves: it spins, and goes along a path.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_DRIVE_H
#define HAWSER_ROD_DRIVE_H

#include "net/motion/motion.h"
#include "rod/motion.h"

struct hawser__rod_drive {
	const struct hawser_rod_drive *as; /* what the scene says */
	struct hawser__rod_node place;     /* of the end at t = 0 */
	double along[3];                   /* axis in the section's axes, which the spin does not change */
	double from[3];                    /* m, displacement at t = 0 */
	struct hawser__support_table table; /* rows 0: no path */
};

/* Of an end of a mesh, whose goal has the place; *open is 0 if it does not move. The structure must
 * stay where it is. */
enum hawser_status hawser__rod_drive_open(struct hawser__rod_drive *drive, int *open,
                                          const struct hawser__rod_mesh *mesh, int end, double until,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__rod_drive_clear(struct hawser__rod_drive *drive);
/* A function for hawser__rod_motion.guide. */
void hawser__rod_drive_at(void *drive, struct hawser__rod_guide *to, double t);

#endif

/* rod/run.h - a motion with its rows: what integrate.c and its parts share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_RUN_H
#define HAWSER_ROD_RUN_H

#include <hawser/rod_motion.h>

#include "net/motion/motion.h"
#include "rod/motion.h"

/* --- drive.c: how a held end of a rod moves: it spins, and goes along a path --- */

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

/* A motion on a mesh. */
struct hawser__rod_twin {
	struct hawser__rod_mesh mesh;
	struct hawser__rod_motion motion;
	struct hawser__rod_drive drive[2];
	int parts;               /* steps to one of the first motion */
	int live;                /* 0: it has failed, or is not wanted */
};

/* begin.c: mesh, supports and the state at t = 0. The structure must stay where it is. */
enum hawser_status hawser__rod_twin_open(struct hawser__rod_twin *twin, const struct hawser_rod *rod,
                                         int refine, double until, int rest,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__rod_twin_clear(struct hawser__rod_twin *twin);

/* rows.c: memory for these rows; the state as the next row, of which the caller may end the run. */
enum hawser_status hawser__rod_rows_open(struct hawser_rod_motion *to, size_t rows, size_t probes,
                                         size_t nodes, struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__rod_row(struct hawser_rod_motion *to, struct hawser__rod_twin *twin,
                                   double turned, const struct hawser_rod_motion_options *options,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* motion_state.c: the state as numbers, with the next step's length h; *state [*states] is
 * allocated. */
enum hawser_status hawser__rod_state_save(double **state, int *states,
                                          const struct hawser__rod_motion *motion, double h,
                                          double turned, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* Of another kind of files: the numbers of such a state; into and out of state [size]. take returns 0
 * if they belong to another rod. */
int hawser__rod_state_size(const struct hawser__rod_mesh *mesh);
void hawser__rod_state_give(double *state, const struct hawser__rod_motion *motion, double h,
                            double turned);
int hawser__rod_state_take(struct hawser__rod_motion *motion, double *h, double *turned,
                           double *state);
enum hawser_status hawser__rod_state_read(struct hawser__rod_motion *motion, double *h, double *turned,
                                          const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#endif

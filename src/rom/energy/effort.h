/* rom/energy/effort.h - which of the two forms of the energy is evaluated: tensors or functions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EFFORT_H
#define HAWSER_ROM_EFFORT_H

/* What is evaluated: a force, or a force with its tangent; at one state, or at each of several in
 * one call. */
enum hawser__effort_task {
	HAWSER__FORCE,
	HAWSER__TANGENT,
	HAWSER__FORCES,
	HAWSER__TANGENTS,
	HAWSER__TASKS
};

/* Estimated times in nanoseconds for each task. */
struct hawser__effort {
	double tensors[HAWSER__TASKS];
	double functions[HAWSER__TASKS];
};

/* The size of a model. */
struct hawser__size {
	int n, in, out;        /* coordinates; modes in the plane and out of it */
	int points;            /* of the grid */
	int condensed;
	double cubics;         /* entries of C */
};

void hawser__effort(struct hawser__effort *effort, const struct hawser__size *size);

/* Additions and multiplications of a force, or of force and tangent, by functions. */
double hawser__function_flops(const struct hawser__size *size, int tangent);

#endif

/* ropeway/read/read.h - reading a scene of kind `ropeway`: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_READ_H
#define HAWSER_ROPEWAY_READ_H

#include <hawser/obstacles.h>
#include <hawser/ropeway.h>
#include "scene/tree.h"

enum { HAWSER__CALLED = 96 }; /* size of "towers.NAME.sheaves.KEY" */

/* A circle of a span over obstacles, as the table of keys has it. */
struct hawser__round {
	struct hawser_line_sheave sheave;
	struct hawser_obstacle of;
	int side; /* 0: above, 1: below */
};

/* towers.c: the list of towers; the stations are known. */
enum hawser_status hawser__ropeway_towers(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                          const struct hawser__tree *tree) HAWSER_MUST_CHECK;

#endif

/* ropeway/modes/plan.h - what moves in a rope over sheaves, before it is divided into systems.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_PLAN_H
#define HAWSER_ROPEWAY_PLAN_H

#include "ropeway/modes/modes.h"

/* Everything that moves in one plane, before it is divided into systems. */
struct hawser__lmode_draft {
	struct hawser__lmode *rope;
	enum hawser_plane plane;
	struct hawser__lmode_segment *segment;
	double *border_map;   /* [segments][ends][2][borders] */
	struct hawser__lmode_node *node;
	struct hawser__lmode_pendulum *pendulum;
	struct hawser__lmode_border *border;
	int *node_chain, *root; /* [nodes], [chains] */
	int segments, nodes, pendulums, borders, chains;
	int borders_most;
};

/* modes_systems.c: add the systems of the draft to its rope. */
enum hawser_status hawser__lmode_divide(struct hawser__lmode_draft *draft,
                                        struct hawser_report *report);

#endif

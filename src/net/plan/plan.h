/* net/plan/plan.h - parts of a plan of a net: see hawser/net_plan.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_PLAN_PARTS_H
#define HAWSER_NET_PLAN_PARTS_H

#include <hawser/net_modes.h>
#include <hawser/net_plan.h>

#include "net/net.h"

struct hawser__net_planner {
	struct hawser_net_plan *plan;
	const struct hawser_net *net;
	struct hawser_net_plan_options options; /* settled */
	struct hawser__mesh mesh;        /* as the scene has it */
	struct hawser_net_statics st;    /* solved if st.x is not NULL */
	struct hawser_net_modes modes;   /* solved if modes.omega is not NULL */
	struct hawser_net_motion motion; /* its beginning, if motion.time is not NULL */
	struct hawser_report report;     /* of what could not be done */
	double flops, entries, bytes;    /* of a factorization of the stiffness: operations, entries,
	memory */
	double analysed, factored, solved; /* s, measured */
	double table_end;                /* s, of the shortest table of a support */
	int still[3];                    /* 1: nothing moves the net along this axis */
	int slack;                       /* cables with slack elements */
};

/* plan-cost.c: rows of jobs. Failures of a job are its row; returned are those of memory and
 * arguments. */
enum hawser_status hawser__plan_statics(struct hawser__net_planner *planner,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plan_modes(struct hawser__net_planner *planner,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plan_motion(struct hawser__net_planner *planner,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* plan-mesh.c: rows of cables. */
enum hawser_status hawser__plan_mesh(struct hawser__net_planner *planner,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* plan-words.c: decisions and warnings. */
enum hawser_status hawser__plan_words(struct hawser__net_planner *planner,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* net/water/flow.h - how the water flows at the places of a motion: a current over the height and over
 * time, waves. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WATER_FLOW_H
#define HAWSER_NET_WATER_FLOW_H

#include <hawser/water.h>

#include "net/motion/motion.h"

struct hawser__near;
struct hawser__water_flow {
	const struct hawser_water *of;
	struct hawser__near *near;           /* of a sea, else NULL */
	struct hawser__support_table series; /* of the current over time; rows 0: none */
	double t, later[3], rate[3];         /* s; m/s, m/s^2: of that current, beyond that of t = 0 */
};
/* At a place. */
struct hawser__water_there {
	double u[3], du[3]; /* m/s, m/s^2 */
	double surface;     /* m */
};

/* For so many places; to be released also after a failure. */
enum hawser_status hawser__water_flow_open(struct hawser__water_flow *flow,
                                           const struct hawser_water *of, int places,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__water_flow_clear(struct hawser__water_flow *flow);
/* The time of what is asked for next. */
void hawser__water_flow_time(struct hawser__water_flow *flow, double t);
/* At x [3] (m). place: one of a motion, which moves little, or -1: waves exactly, so that nothing
 * which comes later depends on this call. */
void hawser__water_flow_at(struct hawser__water_there *at, const struct hawser__water_flow *flow,
                           int place, const double x[3]);

#endif

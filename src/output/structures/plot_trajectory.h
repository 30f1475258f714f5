/* output/structures/plot_trajectory.h - a path from above, and velocity and acceleration over time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_TRAJECTORY_H
#define HAWSER_OUTPUT_PLOT_TRAJECTORY_H

#include "output/output.h"

/* A time and the state there. */
struct hawser__trajectory_point {
	double t, state[HAWSER_PATH_ORDERS][3];
};

struct hawser__trajectory_picture {
	const struct hawser__trajectory_point *point; /* [points] */
	int points;
	const struct hawser_waypoint *waypoint;       /* [waypoints] those in the range, or none */
	int waypoints, first;                         /* number of the first, from 0 */
};
enum hawser_status hawser__plot_trajectory(const char *path,
                                           const struct hawser__trajectory_picture *of,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* output/structures/structures.h - pictures of structures; how they look is said in the source of each,
 * plot_NAME.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_STRUCTURES_H
#define HAWSER_OUTPUT_STRUCTURES_H

#include <hawser/line_modes.h>
#include <hawser/net_modes.h>
#include <hawser/obstacles.h>
#include <hawser/rod_motion.h>
#include <hawser/ropeway.h>
#include <hawser/tow.h>
#include <hawser/transient.h>

#include "output/drawing/figure.h"
#include "output/output.h"

/* A net in perspective, its cables coloured by their tension; plot_mooring.c: one in water, from two
 * sides. */
enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
	HAWSER_MUST_CHECK;
enum hawser_status hawser__plot_mooring(const char *path, const struct hawser_net *net,
                                        const struct hawser_net_statics *st,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* plot_bed.c: a bed with heights in its views, of the box from low [3] to high [3]: put below the
 * cables, y over x; and drawn as contours, z over x. */
void hawser__plot_bed_section(struct hawser__figure *figure, const struct hawser_surface *bed,
                              const struct hawser_net_statics *st, const double low[3],
                              const double high[3]);
void hawser__plot_bed_contours(struct hawser__figure *figure, const struct hawser_surface *bed,
                               const double low[3], const double high[3]);
/* Mode shapes of a net in perspective, one panel a mode. */
enum hawser_status hawser__plot_net_modes(const char *path, const struct hawser_net_modes *modes,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* A span over obstacles: the rope with the circles and the same rope without them; tensions, with the
 * limits of friction. */
enum hawser_status hawser__plot_obstacles(const char *path, const struct hawser_obstacles *scene,
                                          const struct hawser_obstacles_statics *st,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Heights (0) or tensions (1) of a rope, at so many points of each piece. */
void hawser__plot_rope(struct hawser__figure *figure, const struct hawser_line_statics *st, int tension,
                       int points);

/* A ropeway: the line with its towers, carriers and reactions; tensions; with worst values also their
 * envelope and the least forces on the batteries. */
enum hawser_status hawser__plot_ropeway(const char *path, const struct hawser_ropeway *ropeway,
                                        const struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway_worst *worst /* or NULL */,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* It in motion over time, and a carrier that passes a battery. */
enum hawser_status hawser__plot_transient(const char *path, const struct hawser_ropeway *ropeway,
                                          const struct hawser_transient *run,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plot_carrier_passing(const char *path, const struct hawser_passing *passing,
                                                struct hawser_report *report) HAWSER_MUST_CHECK;

/* A rod under load and at rest, in perspective; forces and moments along it. */
enum hawser_status hawser__plot_rod(const char *path, const struct hawser_rod *rod,
                                    const struct hawser_rod_statics *st,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* A motion: shapes at some times, the first probe (its name) and the energies over time. */
enum hawser_status hawser__plot_rod_motion(const char *path, const struct hawser_rod_motion *motion,
                                           const char *probe, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The steady state of a towed body: its shape in two views, and the tension. */
enum hawser_status hawser__plot_tow(const char *path, const struct hawser_tow *tow,
                                    const struct hawser_tow_steady *steady,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* A towed body in time: its way, tilt and tensions. */
enum hawser_status hawser__plot_tow_motion(const char *path, const struct hawser_tow_motion *motion,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- plot_ropeway_modes.c: modes of a rope over sheaves along its profile, a panel each: of a
 * ropeway, or of a span over obstacles --- */

struct hawser__ropeway_modes_picture {
	const struct hawser_line_modes *modes;
	const char *what;        /* "towers", "obstacles": in the legend */
	int posts;               /* 1: a line below each tower */
	int towers;
	const double (*tower)[2]; /* [towers] m, points at which the rope passes them */
	double end[2][2];        /* m, of the line */
	int carriers[HAWSER_LINE_LANES];
	int spans;               /* of all lanes, those of a lane one after the other */
	const char *const *name; /* [spans] "p0 to p1" */
	const double *share;     /* [modes->n][spans] of the kinetic energy */
};
enum hawser_status hawser__plot_ropeway_modes(const char *path,
                                              const struct hawser__ropeway_modes_picture *of,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- plot_trajectory.c: a path from above, and velocity and acceleration over time --- */

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

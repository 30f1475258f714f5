/* output/structures/plot_ropeway_modes.h - modes of a rope over sheaves along its profile, a panel
 * each: of a ropeway, or of a span over obstacles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_ROPEWAY_MODES_H
#define HAWSER_OUTPUT_PLOT_ROPEWAY_MODES_H

#include <hawser/line_modes.h>

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

#endif

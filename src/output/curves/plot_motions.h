/* output/curves/plot_motions.h - curves over time, in panels one below the other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_MOTIONS_H
#define HAWSER_OUTPUT_PLOT_MOTIONS_H

#include "output/output.h"

enum { HAWSER__MOTION_CURVES = 8, HAWSER__MOTION_PANELS = 4 };
struct hawser__motion_panel {
	struct hawser__axis axis; /* of the values */
	int stride;        /* of the values of successive rows */
	int curves;
	struct hawser__motion_curve {
		const char *label;   /* "": not in the legend */
		int colour;          /* 0: black and wide, below those that follow; the same in all panels; -1:
		                      * a band from -value to value */
		const double *value; /* [rows*stride], the first one at its own place */
	} curve[HAWSER__MOTION_CURVES];
};
struct hawser__motions {
	int rows, panels;
	const double *time; /* [rows] s */
	struct hawser__axis axis; /* of time */
	struct hawser__motion_panel panel[HAWSER__MOTION_PANELS];
};
enum hawser_status hawser__plot_motions(const char *path, const struct hawser__motions *of,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

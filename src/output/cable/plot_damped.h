/* output/cable/plot_damped.h - the picture of hawser modes --over.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_DAMPED_H
#define HAWSER_OUTPUT_PLOT_DAMPED_H

#include "output/output.h"

/* Damping ratios over a key of the scene. */
enum { HAWSER__DAMPED_CURVES = 8 };
struct hawser__damped {
	int points, curves, logarithmic;
	const double *x; /* [points] SI */
	double *y;       /* [curves][points] ratios, NAN for nothing */
	char title[HAWSER__DAMPED_CURVES][32];
	int plane[HAWSER__DAMPED_CURVES]; /* 0: in plane, solid */
	struct hawser__axis axis;
};
enum hawser_status hawser__plot_damped(const char *path, const struct hawser__damped *of,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

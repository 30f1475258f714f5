/* output/curves/plot_sweep.h - the picture of hawser sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_SWEEP_H
#define HAWSER_OUTPUT_PLOT_SWEEP_H

#include "output/output.h"

enum { HAWSER__SWEEP_PANELS = 6, HAWSER__SWEEP_CURVES = 12, HAWSER__SWEEP_LABEL = 120 };
/* Curves of several quantities, one panel each, over one abscissa; in the units of the titles. */
struct hawser__sweep_picture {
	int panels, curves, points;
	int logarithmic; /* 1: the abscissa */
	const char *x_title;
	char y_title[HAWSER__SWEEP_PANELS][HAWSER__SWEEP_LABEL]; /* [panels] */
	char label[HAWSER__SWEEP_CURVES][HAWSER__SWEEP_LABEL];   /* [curves] for the legend; "": none */
	const double *x; /* [points] ascending */
	const double *y; /* [panels][curves][points] NAN where there is none */
};
enum hawser_status hawser__plot_sweep(const char *path, const struct hawser__sweep_picture *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

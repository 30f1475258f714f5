/* output/structures/plot_track.h - frequencies of a ropeway along a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_TRACK_H
#define HAWSER_OUTPUT_PLOT_TRACK_H

#include <hawser/campbell.h>
#include <hawser/ropeway_modes.h>

#include "output/output.h"

struct hawser__track_picture {
	const struct hawser_ropeway_track *track;
	const char *x_title, *y_title;
	double x_per, y_per;  /* of the axes: values, and rad/s */
	double slope;         /* rad/s of the line of the first harmonic per value */
	int harmonics, logarithmic;
	const struct hawser_campbell_resonance *resonance; /* [resonances], marked */
	int resonances;
};
enum hawser_status hawser__plot_track(const char *path, const struct hawser__track_picture *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

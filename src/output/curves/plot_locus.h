/* output/curves/plot_locus.h - the picture of loci of bifurcations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_LOCUS_H
#define HAWSER_OUTPUT_PLOT_LOCUS_H

#include "output/output.h"

/* Loci of bifurcations in the plane of frequency and a parameter. */
struct hawser__locus_picture {
	const struct hawser_locus *locus;
	struct hawser__axis axis[2];
	double per_omega; /* shown unit per unit of the model */
	double from[2], to[2];
};
enum hawser_status hawser__plot_locus(const char *path, const struct hawser__locus_picture *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

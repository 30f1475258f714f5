/* output/cable/plot_profile.h - performance profiles: the part of problems that each method
 * solves within a multiple of the least time, and within a number of iterations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_PROFILE_H
#define HAWSER_OUTPUT_PLOT_PROFILE_H

#include "output/output.h"

enum { HAWSER__PROFILE_CURVES = 16 };
struct hawser__profile {
	int problems, curves;
	const char *unit;     /* what is solved, "Nets solved" */
	int timed;            /* 0: no panel of times */
	struct hawser__profile_curve {
		const char *label;
		int colour, dashed;     /* colour: a method, from 0; dashed: another start */
		const double *value[2]; /* [problems], ascending: ratio of time, iterations; INFINITY: not
		                         * solved */
	} curve[HAWSER__PROFILE_CURVES];
};
enum hawser_status hawser__plot_profile(const char *path, const struct hawser__profile *of,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* output/cable/plot_cases.h - the picture of hawser statics --cases.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_CASES_H
#define HAWSER_OUTPUT_PLOT_CASES_H

#include "output/drawing/axis.h"

enum { HAWSER__CASE_VALUES = 4 };

struct hawser__cases_picture {
	int cases;
	const char *const *name; /* [cases] */
	const double *value;     /* [cases][HAWSER__CASE_VALUES] largest tension and H (N), sag and
	                          * blowout (m); not a number: not drawn */
	struct hawser__axis tension, length;
};

enum hawser_status hawser__plot_cases(const char *path, const struct hawser__cases_picture *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

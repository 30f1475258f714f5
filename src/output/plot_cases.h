/* output/plot_cases.h - the picture of hawser statics --cases.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_CASES_H
#define HAWSER_OUTPUT_PLOT_CASES_H

#include <hawser/status.h>

enum { HAWSER__CASE_VALUES = 4 };

struct hawser__cases_picture {
	int cases;
	const char *const *name; /* [cases] */
	const double *value;     /* [cases][HAWSER__CASE_VALUES] largest tension and H (N), sag and
	                          * blowout (m); not a number: not drawn */
	double per;              /* N, unit of the axis of tensions */
};

/* `tension`: title of the axis of tensions. */
enum hawser_status hawser__plot_cases(const char *path, const struct hawser__cases_picture *of,
                                      const char *tension, struct hawser_report *report);

#endif

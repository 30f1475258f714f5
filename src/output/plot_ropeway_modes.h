/* output/plot_ropeway_modes.h - modes of a ropeway along the profile of its line, a panel each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_ROPEWAY_MODES_H
#define HAWSER_OUTPUT_PLOT_ROPEWAY_MODES_H

#include <hawser/ropeway_modes.h>

#include "output/output.h"

struct hawser__ropeway_modes_picture {
	const struct hawser_ropeway_statics *st;
	const struct hawser_line_modes *modes;
	int spans;               /* of both lanes: lanes*(towers + 1) */
	const char *const *name; /* [spans] "p0 to p1" */
	const double *share;     /* [modes->n][spans] of the kinetic energy */
};
enum hawser_status hawser__plot_ropeway_modes(const char *path,
                                              const struct hawser__ropeway_modes_picture *of,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

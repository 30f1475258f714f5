/* cli/modes/campbell_result.h - a Campbell diagram as table, JSON and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CAMPBELL_RESULT_H
#define HAWSER_CLI_CAMPBELL_RESULT_H

#include "cli/frame/view.h"


struct cli_campbell_result {
	const struct cli_common *common;
	struct hawser_scene scene;
	struct hawser_campbell campbell;
	int hertz;      /* unit of table and picture */
	double spacing; /* m */
	int harmonics;  /* number of excitation lines; 0 without a spacing */
	struct hawser_campbell_resonance *resonance; /* [resonances] */
	int resonances;
};

/* Convert rad/s to the unit of the table. */
double cli_campbell_in_unit(const struct cli_campbell_result *result, double omega);
extern const struct cli_showing cli_campbell_showing;
/* Title of the axis of speed, re or im. */
struct hawser__axis cli_campbell_axis(const char *column,
                                      const struct cli_campbell_result *result);
enum hawser_status cli_campbell_draw(const char *path, const void *result,
                                     struct hawser_report *report);
void cli_campbell_free(struct cli_campbell_result *result);

#endif

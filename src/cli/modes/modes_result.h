/* cli/modes/modes_result.h - modes of a cable, at rest or travelling, as a table, as JSON and as
 * a picture. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_RESULT_H
#define HAWSER_CLI_MODES_RESULT_H

#include "cli/frame/view.h"

struct cli_modes_result {
	const struct cli_common *common;
	const char *view; /* of the picture: "components", "profile" or "waves" */
	struct hawser_scene scene;
	struct hawser_modes modes; /* complex if the cable travels */
	int points;    /* of a shape; 0: no shapes in table and JSON */
	double *S;     /* [points] m */
	double *shape; /* [points][n][parts] see cli_modes_sample */
};
/* S and shape, where there are points. */
enum hawser_status cli_modes_sample(struct cli_modes_result *result,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct cli_showing cli_modes_showing;

#endif

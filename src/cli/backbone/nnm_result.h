/* cli/backbone/nnm_result.h - nonlinear normal modes as a table, JSON and a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_NNM_RESULT_H
#define HAWSER_CLI_NNM_RESULT_H

#include <hawser/nnm.h>

#include "cli/frame/cli.h"
#include "cli/frame/view.h"

struct cli_nnm_result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_nnm *nnm;
	int mode, depth, periods; /* index of the mode */
};
extern const struct cli_showing cli_nnm_showing;
extern const struct cli_listing cli_nnm_listing[];

#endif

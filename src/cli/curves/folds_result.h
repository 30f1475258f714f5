/* cli/curves/folds_result.h - output of hawser folds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FOLDS_RESULT_H
#define HAWSER_CLI_FOLDS_RESULT_H

#include "cli/frame/cli.h"

struct cli_folds_result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_folds *folds;
	double from, to; /* scaled */
	double load_from, load_to;
	const char *label; /* of --from-label, or NULL */
};
extern const struct cli_showing cli_folds_showing;
enum hawser_status cli_folds_draw(const char *path, const void *result,
                                  struct hawser_report *report);

#endif

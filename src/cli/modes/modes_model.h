/* cli/modes/modes_model.h - hawser modes of a reduced model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_MODEL_H
#define HAWSER_CLI_MODES_MODEL_H

#include "cli/frame/view.h"

/* The `n` slowest, or all (n 0). */
enum hawser_status cli_modes_model(const struct cli_common *common, int n,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_modes_model_field[], cli_modes_model_member[];

#endif

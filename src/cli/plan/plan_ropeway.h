/* cli/plan/plan_ropeway.h - hawser plan of a scene of kind `ropeway`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_ROPEWAY_H
#define HAWSER_CLI_PLAN_ROPEWAY_H

#include "cli/frame/view.h"

/* Print what is modelled, what not and why, the settings, and the measured time of a state. */
enum hawser_status cli_plan_ropeway(const struct cli_common *common,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_plan_ropeway_row[];

#endif

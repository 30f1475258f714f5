/* cli/plan/plan_model.h - hawser plan of a reduced model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_MODEL_H
#define HAWSER_CLI_PLAN_MODEL_H

#include "cli/frame/view.h"

/* from, to: frequencies as in the command line. */
enum hawser_status cli_plan_model(const struct cli_common *common, const char *from, const char *to,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_plan_model_field[], cli_plan_model_member[];
/* plan_ropeway.c */
extern const struct hawser__field cli_plan_ropeway_row[];

#endif

/* cli/load_history.h - integrate --load. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LOAD_HISTORY_H
#define HAWSER_CLI_LOAD_HISTORY_H

#include "cli/cli.h"

/* Give the model the load per length over time that the table at `path` has, in place of the harmonic
 * load of the scene, along the axes and on the part that load.frame and load.extent name. */
enum hawser_status cli_load_history(struct cli_model *model, const char *path,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

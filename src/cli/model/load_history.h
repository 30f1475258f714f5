/* cli/model/load_history.h - integrate --load and --motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LOAD_HISTORY_H
#define HAWSER_CLI_LOAD_HISTORY_H

#include "cli/frame/cli.h"

/* Give the model the load per length over time that the table at `load` has, in place of the section
 * load of the scene, along the axes and on the part that load.frame and load.extent name, and the
 * displacements of the ends that the table at `motion` has. Either may be NULL. The other harmonic
 * loads of the scene remain. */
enum hawser_status cli_load_history(struct cli_model *model, const char *load, const char *motion,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* A sentence if the ends move at the scaled time t, with which a run begins at rest. Returns whether
 * there is one. */
int cli_motion_warning(char *text, size_t size, const struct cli_model *model, double t);

#endif

/* cli/model/state.h - JSON of states, to read an initial state or the end of a result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATE_H
#define HAWSER_CLI_STATE_H

#include <jansson.h>

#include "cli/frame/cli.h"

/* The JSON of a file (`-`: standard input), which the caller releases; NULL if it is not JSON. */
enum hawser_status cli_state_root(json_t **root, const char *path,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* The message that the file has no state for a model of n coordinates. */
enum hawser_status cli_state_refuse(struct hawser_report *report, const char *path, int n,
                                    const char *why);

/* last.c: the first difference between the scene or model of a result and the present one, but for the
 * key `but`, or NULL. `then`: the model, with the natural frequencies of the result. */
const char *cli_last_difference(char *name, size_t size, const json_t *root, const char *but,
                                const struct cli_model *model, const struct cli_model *then,
                                const struct cli_common *common, enum hawser_status *status);

/* Read a list of 2n numbers in SI as a scaled state of the model. Returns 0 if it is none. */
int cli_state_take(double *state, const json_t *list, const struct cli_model *model);

/* --- load_history.c: integrate --load and --motion --- */

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

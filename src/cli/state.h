/* cli/state.h - what reading a state and reading where a result ended have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATE_H
#define HAWSER_CLI_STATE_H

#include <jansson.h>

#include "cli/cli.h"

/* The JSON of a file, `-` being standard input; *root is NULL where it is none, and the caller's. */
enum hawser_status cli_state_root(json_t **root, const char *path,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* The last state there, to `state`, [2n], scaled; path is for the message. */
enum hawser_status cli_state_of(double *state, const json_t *root, const char *path,
                                const struct cli_model *model,
                                struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

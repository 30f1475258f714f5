/* cli/state.h - JSON of states, to read an initial state or the end of a result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATE_H
#define HAWSER_CLI_STATE_H

#include <jansson.h>

#include "cli/cli.h"

/* The JSON of a file (`-`: standard input), which the caller releases; NULL if it is not JSON. */
enum hawser_status cli_state_root(json_t **root, const char *path,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* The message that the file has no state for a model of n coordinates. */
enum hawser_status cli_state_refuse(struct hawser_report *report, const char *path, int n,
                                    const char *why);

#endif

/* cli/curves/frf_lift.h - where a response takes the rope of a ropeway off a sheave.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_LIFT_H
#define HAWSER_CLI_FRF_LIFT_H

#include "cli/frame/cli.h"

/* As cli_frf_slack: a sentence about where the rope leaves a sheave, if it does. */
int cli_frf_lift(char *text, size_t size, const struct cli_frf_result *result);
/* The least angle of contact of the curve, as a comment; nothing of models without sheaves. */
void cli_frf_lift_comment(struct hawser__table *table, const struct cli_frf_result *result);
/* JSON: sheaves, and lift. */
void cli_frf_sheaves_json(struct hawser__json *json, json_t *into, const void *result);
void cli_frf_lift_json(struct hawser__json *json, json_t *into, const void *result);

#endif

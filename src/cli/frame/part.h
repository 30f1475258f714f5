/* cli/frame/part.h - the option --part K/N of maps and sweeps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PART_H
#define HAWSER_CLI_PART_H

#include "cli/frame/cli.h"

/* *number, from 1, of *parts; both stay as they are if `text` is NULL. A part is kept in a checkpoint
 * and has no result: options that write one are refused. other: the name of a further one that is
 * given, or NULL. */
enum hawser_status cli_part_read(int *number, int *parts, const char *text, const char *command,
                                 const char *checkpoint, const struct cli_common *common,
                                 const char *other, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* cli/frame/kinds.h - the kinds of scenes, and options that are for some of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_KINDS_H
#define HAWSER_CLI_KINDS_H

#include "cli/frame/cli.h"

/* Refuse the first option that is given and is not for inputs of this kind. */
enum hawser_status cli_kind_check(const char *command, const struct cli_common *common,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

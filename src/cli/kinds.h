/* cli/kinds.h - the kinds of scenes, and options that are for some of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_KINDS_H
#define HAWSER_CLI_KINDS_H

#include "cli/cli.h"

enum { CLI_KINDS = CLI_SPAN | CLI_NET | CLI_ROPEWAY }; /* those that each command tells apart */

/* The kind of the input, of these; one of another is taken for a span, whose reader refuses it. */
enum cli_kind cli_kind_of(const struct cli_common *common, unsigned kinds);
/* Refuse the first option that is given and is not for inputs of this kind. */
enum hawser_status cli_kind_check(const char *command, const struct cli_common *common,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* cli/kinds.h - the kinds of scenes, and options that are for some of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_KINDS_H
#define HAWSER_CLI_KINDS_H

#include "cli/cli.h"

/* Bits, of hawser_kind. */
enum cli_kind {
	CLI_SPAN = 1 << HAWSER_KIND_SPAN,
	CLI_NET = 1 << HAWSER_KIND_NET,
	CLI_ROPEWAY = 1 << HAWSER_KIND_ROPEWAY,
	CLI_OBSTACLES = 1 << HAWSER_KIND_OBSTACLES
};
enum { CLI_KINDS = CLI_SPAN | CLI_NET | CLI_ROPEWAY }; /* those that each command tells apart */

/* The kind of the input, of these; one of another is taken for a span, whose reader refuses it. */
enum cli_kind cli_kind_of(const struct cli_common *common, unsigned kinds);

/* An option of the command line; a list is ended by a row without name. */
struct cli_given {
	const char *name; /* without "--" */
	int given;
	unsigned kinds;   /* for which it is */
};
/* Refuse the first option that is given and is not for scenes of this kind. */
enum hawser_status cli_kind_check(const struct cli_given *list, const char *command,
                                  const struct cli_common *common,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

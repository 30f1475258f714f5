/* cli/frame/colour.h - colour of messages and of hawser check, on terminals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_COLOUR_H
#define HAWSER_CLI_COLOUR_H

#include <stdio.h>

enum cli_colour { CLI_ERROR, CLI_WARNING, CLI_GOOD, CLI_PLACE, CLI_PLAIN };

/* The code that begins a colour (CLI_PLAIN: ends it), or "" where the stream gets none. */
const char *cli_colour(FILE *stream, enum cli_colour colour);

/* A message on standard error: of a failure (CLI_ERROR) or a warning. A place in a file is bold. */
void cli_say(enum cli_colour rank, const char *message);

#endif

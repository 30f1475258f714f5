/* cli/within.h - commands that run in another command: hawser report.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_WITHIN_H
#define HAWSER_CLI_WITHIN_H

#include "cli/cli.h"

/* --- main.c --- */

/* Run the command that argv [argc] begins with, as the program does. */
enum hawser_status cli_execute(int argc, char **argv, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The command that "hawser COMMAND ..." runs, or NULL. */
const struct cli_command *cli_command_called(const char *line);

/* --- echo.c --- */

/* From now on add warnings, a line each, to *text, which the caller frees, in place of standard
 * error; NULL: no longer. */
void cli_warn_into(char **text);

/* --- signals.c --- */

/* Temporary files: `remove` removes them if the handler of a signal ends the program, and they do
 * not count as written. It only calls what a handler may call. NULL: there are none any longer. */
void cli_temporary(void (*remove)(void));

#endif

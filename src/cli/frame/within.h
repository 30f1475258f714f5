/* cli/frame/within.h - commands that run in another command: hawser report and hawser sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_WITHIN_H
#define HAWSER_CLI_WITHIN_H

#include "cli/frame/cli.h"

/* --- main.c --- */

/* The program: argv [argc] as main() has it. Returns its exit status. */
int cli_main(int argc, char **argv);
/* Run the command that argv [argc] begins with, as the program does. */
enum hawser_status cli_execute(int argc, char **argv, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The command that argv [argc] begins with, of *words words, or NULL. */
const struct cli_command *cli_find(int *words, int argc, char **argv);
/* The command that "hawser COMMAND ..." runs, or NULL. */
const struct cli_command *cli_command_called(const char *line);

/* --- document.c --- */

/* Commands that run in this one and have the same input take this document, which is not read again;
 * NULL: no longer. */
void cli_document_within(const char *input, const struct hawser_document *document);

/* --- deliver.c --- */

/* A result, as cli_show would write it. */
struct cli_taken {
	const struct hawser__table *table;
	struct hawser__json *json;          /* NULL without --json */
	const struct hawser__field *fields; /* of JSON; NULL: its members are written by a function */
	const struct hawser__scale *scale;  /* of their units */
};
/* From now on results are handed to this function in place of being written; NULL: no longer. It
 * returns the status of writing. */
struct cli_taker {
	enum hawser_status (*take)(void *data, const struct cli_taken *result,
	                           struct hawser_report *report);
	void *data;
};
void cli_show_to(const struct cli_taker *taker);

/* --- echo.c --- */

/* From now on add warnings, a line each, to *text, which the caller frees, in place of standard
 * error; NULL: no longer. */
char **cli_warn_into(char **text);
/* 1: warnings are dropped, as of a trial; 0: no longer. */
void cli_warn_off(int off);
/* Add "warnings", and forget them after a result. */
void cli_warnings_json(struct hawser__json *json);
void cli_warnings_end(void);

/* --- signals.c --- */

/* Temporary files: `remove` removes them if the handler of a signal ends the program, and they do
 * not count as written. It only calls what a handler may call. NULL: there are none any longer. */
void cli_temporary(void (*remove)(void));

#endif

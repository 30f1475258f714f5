/* cli/frame/progress.h - the line on standard error that shows what a long computation is doing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PROGRESS_H
#define HAWSER_CLI_PROGRESS_H

#include <stdio.h>

#include <hawser/progress.h>
#include <hawser/status.h>

/* From this call on SIGUSR1 does not end the program; it requests one line of progress, whatever
 * standard error is. */
void cli_catch_questions(void);

/* A line on standard error that is rewritten ten times a second, if it is a terminal. All zero
 * before use. */
struct cli_progress {
	int quiet, shown;
	double last;
};
void cli_progress_show(struct cli_progress *progress, const char *format, ...) HAWSER_PRINTF(2, 3);
/* Print a line that is kept, if standard error is a terminal. */
void cli_progress_note(int quiet, const char *format, ...) HAWSER_PRINTF(2, 3);
void cli_progress_end(struct cli_progress *progress);

/* Data of cli_watch. */
struct cli_watch {
	struct cli_progress progress;
	const char *label; /* shown in place of the stage; NULL: the stage */
};
/* The function of struct hawser_progress: shows the state, and ends the computation if the user has
 * interrupted the program. */
int cli_watch(void *data, const struct hawser_progress_state *state);
/* The same, but shows nothing. data is not read. */
int cli_watch_silently(void *data, const struct hawser_progress_state *state);

/* --- colour.c: colour of messages and of hawser check, on terminals --- */

enum cli_colour { CLI_ERROR, CLI_WARNING, CLI_GOOD, CLI_PLACE, CLI_PLAIN };

/* The code that begins a colour (CLI_PLAIN: ends it), or "" where the stream gets none. */
const char *cli_colour(FILE *stream, enum cli_colour colour);

/* A message on standard error: of a failure (CLI_ERROR) or a warning. A place in a file is bold. */
void cli_say(enum cli_colour rank, const char *message);

#endif

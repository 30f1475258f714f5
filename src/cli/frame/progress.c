/* cli/frame/progress.c - the progress of long computations on standard error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli/frame/cli.h"
#include "cli/frame/progress.h"
#include "core/progress.h"

enum { LINE_SIZE = 200 };
static const double interval_secs = 0.1, line_secs = 0.5; /* of a line that is rewritten, or kept */
static volatile sig_atomic_t asked;
static struct hawser__forecast forecast; /* of the whole run, whatever its stages are */

static void ask(int number)
{
	(void)number;
	asked = 1;
}

void cli_catch_questions(void)
{
	struct sigaction action;

	memset(&action, 0, sizeof action);
	action.sa_handler = ask;
	action.sa_flags = SA_RESTART;
	sigaction(SIGUSR1, &action, NULL);
}

static double seconds(clockid_t clock)
{
	struct timespec now;

	clock_gettime(clock, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

double cli_seconds(void)
{
	return seconds(CLOCK_MONOTONIC);
}

double cli_processor_seconds(void)
{
	return seconds(CLOCK_THREAD_CPUTIME_ID);
}

/* Whether another program reads the lines: each is kept, and the mark of one that is rewritten tells it
 * from messages. */
static int in_lines(void)
{
	const char *how = getenv("HAWSER_PROGRESS");

	return how && strcmp(how, "lines") == 0;
}

/* Whether a line is due, and its end: a line requested by a signal is kept. */
static int due(struct cli_progress *progress, const char **end)
{
	double now;

	*end = "";
	if (asked) {
		asked = 0;
		*end = "\n";
		return 1;
	}
	if (!in_lines() && (progress->quiet || !isatty(STDERR_FILENO)))
		return 0;
	now = cli_seconds();
	if (now - progress->last < (in_lines() ? line_secs : interval_secs))
		return 0;
	*end = in_lines() ? "\n" : "";
	progress->last = now;
	return 1;
}

static void show(struct cli_progress *progress, const char *text, const char *end)
{
	if (progress->shown || !*end || in_lines())
		fputs("\r\033[K", stderr);
	progress->shown = !*end;
	fputs(text, stderr);
	fputs(end, stderr);
	fflush(stderr);
}

void cli_progress_show(struct cli_progress *progress, const char *format, ...)
{
	char text[LINE_SIZE];
	const char *end;
	va_list args;

	if (!due(progress, &end))
		return;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	show(progress, text, end);
}

int cli_watch(void *data, const struct hawser_progress_state *state)
{
	struct cli_watch *watch = data;
	struct hawser_progress_state shown = *state;
	char text[LINE_SIZE];
	const char *end;

	hawser__forecast_hear(&forecast, state);
	if (due(&watch->progress, &end)) {
		if (watch->label)
			shown.stage = watch->label;
		hawser__forecast_tell(&forecast, &shown);
		hawser_progress_text(&shown, text, sizeof text);
		show(&watch->progress, text, end);
	}
	return cli_interrupted();
}

int cli_watch_silently(void *data, const struct hawser_progress_state *state)
{
	(void)data, (void)state;
	return cli_interrupted();
}

void cli_progress_note(int quiet, const char *format, ...)
{
	va_list args;

	if (quiet || !isatty(STDERR_FILENO))
		return;
	va_start(args, format);
	vfprintf(stderr, format, args);
	va_end(args);
	fputc('\n', stderr);
}

void cli_progress_end(struct cli_progress *progress)
{
	if (progress->shown)
		fputs("\r\033[K", stderr);
	progress->shown = 0;
}

/* cli/progress.c - long work: what it is doing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <signal.h>
#include <stdarg.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli/cli.h"

static const double interval_secs = 0.1;
static volatile sig_atomic_t asked;

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

/* Whether a line is due, and how it ends: where somebody asked for it, it stays. */
static int due(struct cli_progress *progress, const char **end)
{
	double now;

	*end = "";
	if (asked) {
		asked = 0;
		*end = "\n";
		return 1;
	}
	if (progress->quiet || !isatty(STDERR_FILENO))
		return 0;
	now = cli_seconds();
	if (now - progress->last < interval_secs)
		return 0;
	progress->last = now;
	return 1;
}

void cli_progress_show(struct cli_progress *progress, const char *format, ...)
{
	const char *end;
	va_list args;

	if (!due(progress, &end))
		return;
	if (progress->shown || !*end)
		fputs("\r\033[K", stderr);
	progress->shown = !*end;
	va_start(args, format);
	vfprintf(stderr, format, args);
	va_end(args);
	fputs(end, stderr);
	fflush(stderr);
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

/* cli/frame/signals.c - Ctrl-C, SIGTERM and SIGHUP end every command within a second, without
 * incomplete files.
 *
 * Computations that check cli_interrupted end by themselves; their results so far are written and
 * state that they are incomplete. A computation that does not end within `grace` (the construction
 * of a model with sixty modes, a wait for input) is ended by the handler of a timer. A second
 * signal ends it at once.
 *
 * No file is left incomplete: while a file is being written, file.c blocks the signals and the
 * timer. Results are written to their end, however long that takes, except to a pipe or a terminal;
 * a picture that gnuplot has not finished is omitted.
 *
 * A signal may be delivered to any thread, but file.c can block it only in its own thread (OpenBLAS
 * has threads that were started before main). In other threads the handlers therefore pass it on to
 * the main thread.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "cli/frame/ranks.h"
#include "cli/frame/within.h"

/* Time from the signal to the forced end, and between two checks while a result is being written. */
static const struct itimerspec grace = {.it_value = {.tv_nsec = 600000000}};
static const struct itimerspec again = {.it_value = {.tv_nsec = 50000000}};

static volatile sig_atomic_t interrupted, writing, written;
static void (*volatile clean)(void); /* removes temporary files; NULL: there are none */
static pthread_t main_thread;
static timer_t timer;

static void end_now(void)
{
	static const char none[] = "hawser: interrupted; no result is written\n";
	static const char some[] = "hawser: interrupted; the files that were written are complete, the "
	                           "rest is left out\n";

	if (cli_ranks_silent())
		; /* rank 0 tells it */
	else if (written)
		(void)!write(STDERR_FILENO, some, sizeof some - 1);
	else
		(void)!write(STDERR_FILENO, none, sizeof none - 1);
	if (clean)
		clean();
	_exit(128 + interrupted);
}

/* In another thread than the main one: send the signal to the main thread, and return 1. */
static int pass_on(int number)
{
	if (pthread_equal(pthread_self(), main_thread))
		return 0;
	pthread_kill(main_thread, number);
	return 1;
}

static void catch(int number)
{
	int error = errno;

	if (pass_on(number))
		return;
	if (!interrupted) {
		interrupted = number;
		timer_settime(timer, 0, &grace, NULL);
	} else if (!hawser__picture_stop()) {
		end_now();
	}
	errno = error;
}

static void time_is_up(int number)
{
	int error = errno;

	if (pass_on(number))
		return;
	if (interrupted && !hawser__picture_stop() && !writing)
		end_now();
	timer_settime(timer, 0, &again, NULL);
	errno = error;
}

static void handle(int number, void (*handler)(int))
{
	struct sigaction action, old;

	memset(&action, 0, sizeof action);
	action.sa_handler = handler;
	action.sa_flags = SA_RESTART;
	/* one handler at a time; ignored signals (background of a script) remain ignored */
	sigfillset(&action.sa_mask);
	if (sigaction(number, NULL, &old) == 0 && old.sa_handler != SIG_IGN)
		sigaction(number, &action, NULL);
}

void cli_catch_interrupts(void)
{
	struct sigevent event;

	memset(&event, 0, sizeof event);
	event.sigev_notify = SIGEV_SIGNAL;
	event.sigev_signo = SIGALRM;
	main_thread = pthread_self();
	(void)signal(SIGALRM, SIG_DFL); /* even where it was ignored */
	if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0)
		return;
	handle(SIGALRM, time_is_up);
	handle(SIGINT, catch);
	handle(SIGTERM, catch);
	handle(SIGHUP, catch);
}

int cli_interrupted(void)
{
	return interrupted;
}

void cli_writing(int to_files)
{
	struct stat info;

	writing = to_files || (fstat(STDOUT_FILENO, &info) == 0 && S_ISREG(info.st_mode));
}

void cli_written(const char *path)
{
	if (path && strcmp(path, "-") != 0 && !clean)
		written = 1;
}

void cli_temporary(void (*remove)(void))
{
	clean = remove;
}

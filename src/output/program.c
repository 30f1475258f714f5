/* output/program.c - see program.h. A message of the program is reported by its first line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <limits.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/report.h"
#include "output/output.h"
#include "output/program.h"

extern char **environ;

enum { ARGUMENTS = 32 };

static enum hawser_status no_gnuplot(const char *at, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
	                    "cannot draw: no gnuplot program found%s; install gnuplot (Debian: "
	                    "gnuplot-nox), or write the numbers with --tsv", at);
}

static enum hawser_status no_ffmpeg(const char *at, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
	                    "cannot make an .mp4: no ffmpeg program found%s; install ffmpeg, or give a "
	                    "name that ends in .gif", at);
}

const struct hawser__program hawser__gnuplot = {"gnuplot", "HAWSER_GNUPLOT", no_gnuplot};
const struct hawser__program hawser__ffmpeg = {"ffmpeg", "HAWSER_FFMPEG", no_ffmpeg};

/* Write the path of the program into found[size]; returns 0 if it is not found. */
static int find_program(char *found, size_t size, const struct hawser__program *program)
{
	const char *wanted = getenv(program->variable), *folder = getenv("PATH"), *end;

	if (wanted && *wanted && strchr(wanted, '/'))
		return snprintf(found, size, "%s", wanted) < (int)size && access(found, X_OK) == 0;
	if (!wanted || !*wanted)
		wanted = program->name;
	for (; folder && *folder; folder = *end ? end + 1 : end) {
		end = strchrnul(folder, ':');
		if (snprintf(found, size, "%.*s/%s", (int)(end - folder), folder, wanted) < (int)size &&
		    access(found, X_OK) == 0)
			return 1;
	}
	return 0;
}

static enum hawser_status missing(const struct hawser__program *program, struct hawser_report *report)
{
	const char *wanted = getenv(program->variable);
	char at[PATH_MAX + 64] = "";

	if (wanted)
		snprintf(at, sizeof at, " at %s=%s", program->variable, wanted);
	return program->missing(at, report);
}

enum hawser_status hawser__program_check(const struct hawser__program *program,
                                         struct hawser_report *report)
{
	char path[PATH_MAX];

	return find_program(path, sizeof path, program) ? HAWSER_OK : missing(program, report);
}

/* 1 if a program may be running, and its process id; 0: none. */
static volatile sig_atomic_t drawing;
static volatile pid_t running;

int hawser__picture_stop(void)
{
	if (drawing && running > 0)
		kill(running, SIGKILL);
	return drawing;
}

/* Wait for it with interrupts unblocked, see hawser__picture_stop. The process id is cleared
 * before the system can reuse it. */
static int wait_for(pid_t child, int *state, const sigset_t *signals)
{
	sigset_t held;
	siginfo_t info;
	int error = 0;

	running = child;
	drawing = 1;
	pthread_sigmask(SIG_SETMASK, signals, &held);
	while (waitid(P_PID, (id_t)child, &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
		;
	pthread_sigmask(SIG_SETMASK, &held, NULL);
	drawing = 0;
	running = 0;
	while (!error && waitpid(child, state, 0) < 0)
		if (errno != EINTR)
			error = errno;
	return error;
}

static int spawn(pid_t *child, const char *path, char *const *arguments, int in, int out,
                 int complaints, const sigset_t *signals)
{
	posix_spawn_file_actions_t actions;
	posix_spawnattr_t attributes;
	int error;

	posix_spawn_file_actions_init(&actions);
	posix_spawnattr_init(&attributes);
	posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
	posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
	posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
	posix_spawnattr_setsigmask(&attributes, signals);
	posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
	error = posix_spawn(child, path, &actions, &attributes, arguments, environ);
	posix_spawnattr_destroy(&attributes);
	posix_spawn_file_actions_destroy(&actions);
	return error;
}

/* First line of the messages that is neither blank nor a caret. */
static void first_complaint(char *line, int size, FILE *complaints)
{
	rewind(complaints);
	while (fgets(line, size, complaints)) {
		line[strcspn(line, "\n")] = '\0';
		if (line[strspn(line, " \t^")] != '\0')
			return;
	}
	snprintf(line, (size_t)size, "no message");
}

enum hawser_status hawser__program_run(const struct hawser__program *program,
                                       const char *const *arguments, int count, FILE *in, FILE *out,
                                       const sigset_t *signals, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	char path[PATH_MAX], line[200], *list[ARGUMENTS + 2] = {NULL};
	FILE *complaints = tmpfile();
	int error, state = 0;
	pid_t child;

	if (!complaints)
		return hawser__fail(report, HAWSER_ERR_IO, "picture",
		                    "cannot write a temporary file for %s: %s", program->name,
		                    strerror(errno));
	if (!find_program(path, sizeof path, program)) {
		fclose(complaints);
		return missing(program, report);
	}
	/* POSIX does not change the arguments, though they are not const */
	list[0] = (char *)(size_t)program->name;
	for (int i = 0; i < count && i < ARGUMENTS; i++)
		list[i + 1] = (char *)(size_t)arguments[i];
	error = spawn(&child, path, list, fileno(in), fileno(out), fileno(complaints), signals);
	if (!error)
		error = wait_for(child, &state, signals);
	first_complaint(line, sizeof line, complaints);
	if (error)
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture", "cannot run %s: %s", path,
		                      strerror(error));
	else if (WIFSIGNALED(state))
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
		                      "%s was ended by signal %d; no picture is written", path,
		                      WTERMSIG(state));
	else if (WEXITSTATUS(state) != 0)
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
		                      "%s failed with status %d (%s); no picture is written", path,
		                      WEXITSTATUS(state), line);
	fclose(complaints);
	return status;
}

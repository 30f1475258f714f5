/* cli/report/report_pdf.c - PDF of a report, by a browser without window or by weasyprint, whichever is
 * found first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/report/report.h"
#include "core/report.h"

extern char **environ;

static const char *const programs[] = {"chromium", "chromium-browser", "google-chrome", "weasyprint"};
enum { PROGRAMS = sizeof programs/sizeof *programs, WEASYPRINT = PROGRAMS - 1 };

static int ends_in(const char *path, const char *suffix)
{
	size_t length = strlen(path), part = strlen(suffix);

	return length > part && strcasecmp(path + length - part, suffix) == 0;
}

int cli_report_is_pdf(const char *path)
{
	return ends_in(path, ".pdf");
}

enum hawser_status cli_report_name(const char *path, struct hawser_report *report)
{
	return strcmp(path, "-") == 0 || ends_in(path, ".html") || ends_in(path, ".htm") ||
	       cli_report_is_pdf(path) ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "report", "cannot tell the kind of report from "
		               "the name %s: it must end in .html or .pdf (or be - for HTML on standard "
		               "output)", path);
}

static int is_there(const char *name)
{
	const char *list = getenv("PATH"), *end;
	char path[PATH_MAX];

	for (; list && *list; list = *end ? end + 1 : end) {
		int length;

		end = strchrnul(list, ':');
		length = snprintf(path, sizeof path, "%.*s/%s", (int)(end - list), list, name);
		if (length < (int)sizeof path && access(path, X_OK) == 0)
			return 1;
	}
	return 0;
}

/* Index of the program to use; PROGRAMS: none. */
static int choose(void)
{
	int i = 0;

	while (i < PROGRAMS && !is_there(programs[i]))
		i++;
	return i;
}

enum hawser_status cli_report_pdf_check(struct hawser_report *report)
{
	if (choose() < PROGRAMS)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "report",
	                    "cannot make a PDF: neither chromium nor weasyprint is found; install one "
	                    "of them (Debian: chromium, weasyprint), or write -o report.html and print "
	                    "it from a browser");
}

/* Run it with its messages discarded; *state as of waitpid(2). Returns 0 or the cause. */
static int run(char *const *argument, int *state)
{
	posix_spawn_file_actions_t actions;
	pid_t child;
	int error;

	posix_spawn_file_actions_init(&actions);
	posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
	posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
	posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
	error = posix_spawnp(&child, argument[0], &actions, NULL, argument, environ);
	posix_spawn_file_actions_destroy(&actions);
	while (!error && waitpid(child, state, 0) < 0)
		if (errno != EINTR)
			error = errno;
	return error;
}

enum hawser_status cli_report_pdf(const char *pdf, const char *html, struct hawser_report *report)
{
	char name[32], input[PATH_MAX + 8], output[PATH_MAX + 32], page[PATH_MAX];
	char headless[] = "--headless", gpu[] = "--disable-gpu", foot[] = "--no-pdf-header-footer";
	char old_foot[] = "--print-to-pdf-no-header", sandbox[] = "--no-sandbox";
	int which = choose(), state = 0, error;
	enum hawser_status status = cli_report_pdf_check(report);

	if (status)
		return status;
	snprintf(name, sizeof name, "%s", programs[which]);
	snprintf(page, sizeof page, "%s", pdf);
	snprintf(input, sizeof input, "file://%s", html);
	snprintf(output, sizeof output, "--print-to-pdf=%s", pdf);
	if (which == WEASYPRINT) {
		char *const argument[] = {name, input, page, NULL};

		error = run(argument, &state);
	} else { /* a browser has no sandbox when root runs it */
		char *const argument[] = {name, headless, gpu, foot, old_foot, output, input,
		                          geteuid() == 0 ? sandbox : NULL, NULL};

		error = run(argument, &state);
	}
	if (error)
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "report",
		                    "cannot run %s: %s; no PDF is written", name, strerror(error));
	if (!WIFEXITED(state) || WEXITSTATUS(state) != 0 || access(pdf, R_OK) != 0)
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "report",
		                    "%s made no PDF of the report; write -o report.html and print it from a "
		                    "browser", name);
	return HAWSER_OK;
}

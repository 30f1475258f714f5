/* tests/serve.c - the program for the scripts of tests/cli: `tests/commands serve` reads command lines
 * and runs each in a process forked from this one. Loading the program with its libraries takes ten
 * times as long.
 *
 * A request is words, each with a null byte behind it: the number of arguments (-1 ends the server),
 * the folder to run in, the script's scratch folder, the arguments. In the scratch folder are the
 * files in, out, err and env, the environment as `export -p` prints it. The answer is a line with the
 * status as a shell has it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/frame/within.h"
#include "tests/serve.h"

enum { WORDS = 1000, ENVIRONMENT = 1 << 17 };

void redirect(int to, const char *name, int flags)
{
	int from = open(name, flags | O_CLOEXEC, 0666);

	if (from < 0 || dup2(from, to) < 0)
		_exit(126);
	close(from);
}

static int shell_status(int status)
{
	return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

static const char *skip(const char *text, const char *word)
{
	size_t length = strlen(word);

	return strncmp(text, word, length) == 0 ? text + length : text;
}

/* One word of a shell, up to a line's end outside quotes; *text moves behind it. */
static void unquote(char *word, const char **text)
{
	const char *at = *text;

	for (char quote = 0; *at && (quote || *at != '\n'); at++)
		if (quote ? *at == quote : *at == '\'' || *at == '"')
			quote = quote ? 0 : *at;
		else if (*at == '\\' && quote != '\'' && at[1])
			*word++ = *++at;
		else
			*word++ = *at;
	*word = '\0';
	*text = *at ? at + 1 : at;
}

/* The environment from lines such as: export NAME='VALUE'. */
static void take_environment(const char *name)
{
	static char text[ENVIRONMENT], kept[ENVIRONMENT];
	char *word = kept;
	FILE *file = fopen(name, "r");
	size_t got = file ? fread(text, 1, sizeof text - 1, file) : sizeof text;

	if (got >= sizeof text - 1)
		_exit(126);
	fclose(file);
	clearenv();
	for (const char *at = text; *at; word += strlen(word) + 1) {
		at = skip(skip(at, "export "), "declare -x ");
		unquote(word, &at);
		if (strchr(word, '='))
			putenv(word);
	}
}

static _Noreturn void run_here(int count, char **word)
{
	char **argument = word + 2;

	if (chdir(word[1]))
		_exit(126);
	take_environment("env");
	redirect(0, "in", O_RDONLY);
	redirect(1, "out", O_WRONLY | O_CREAT | O_TRUNC);
	redirect(2, "err", O_WRONLY | O_CREAT | O_TRUNC);
	if (chdir(word[0]))
		_exit(126);
	free(word[1]); /* else it would count as leaked */
	argument[-1] = (char[]){"hawser"};
	exit(cli_main(count + 1, argument - 1));
}

/* The next `count` words, which the caller frees. Returns 1, or 0 at the end. */
static int read_words(char **word, int count, FILE *from)
{
	int i;

	for (i = 0; i < count; i++) {
		size_t size = 0;

		word[i] = NULL;
		if (getdelim(&word[i], &size, '\0', from) <= 0)
			break;
	}
	word[i] = NULL;
	return i == count;
}

int serve(void)
{
	static char *word[WORDS + 3], *number[2];
	FILE *requests = fdopen(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3), "r");
	int answers = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3), status, count;
	pid_t child;

	if (!requests || answers < 0)
		return 2;
	for (; read_words(number, 1, requests) && (count = atoi(number[0])) >= 0; free(number[0])) {
		if (count > WORDS || !read_words(word, count + 2, requests))
			return 2;
		child = fork();
		if (child == 0)
			run_here(count, word);
		if (child < 0 || waitpid(child, &status, 0) < 0)
			return 2;
		dprintf(answers, "%d\n", shell_status(status));
		for (int i = 0; i < count + 2; i++)
			free(word[i]);
	}
	return 0;
}

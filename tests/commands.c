/* tests/commands.c - tests of the command line by tables, tests/cli/NAME.table: `tests/commands list`
 * prints their names, `tests/commands cli/NAME` runs one, `tests/commands serve` runs the commands
 * of scripts (tests/serve.c). Commands run in processes forked from this one, which has the program
 * in it: nothing is loaded, and what a command leaves ends with it.
 *
 *   hawser WORDS [<FILE]  a command, with quotes and these variables as in a shell: $top, the source
 *                         tree; $scenes, $chairlift, $reference, $duffing in it; $work, the folder
 *                         where commands run
 *   STATUS~ REGEX         below it: its exit status, and an extended regular expression that a line
 *                         of standard error has in it; where the status is not 0, standard error is
 *                         one message of at most two lines, and standard output is empty
 *   STATUS= TEXT          the whole of standard error, without "hawser: "
 *   STATUS                the status; with 0, nothing on standard error
 *   prints REGEX          further lines: standard output has a line with this in it
 *   lacks REGEX           or has none
 *   sh COMMAND            a line of shell in the same folder; it must succeed
 *   env NAME VALUE        a variable of the environment, from here on
 *   file NAME             the lines up to one with `end` alone are a file there
 *   # ...                 a comment
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <fcntl.h>
#include <regex.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/frame/within.h"
#include "tests/serve.h"
#include "tests/tap.h"

enum { LINE = 4096, WORDS = 256, NAME_SIZE = 300 };

static char scratch[] = "/tmp/hawser-commands.XXXXXX", top[LINE];

/* A command that has run. */
static struct {
	char line[LINE];
	char out[1 << 16], err[1 << 16]; /* what it wrote, cut off */
	int status;                      /* exit status, or 1000 + the signal that ended it */
	int judged;                      /* 1: its status was compared */
} run;

static _Noreturn void give_up(const char *what, const char *name)
{
	printf("Bail out! %s %s\n", what, name);
	exit(1);
}

/* The value of a variable; *length is that of its name. */
static const char *variable(const char *name, size_t *length)
{
	static char value[2*LINE];
	static const char *const known[][2] = {
		{"scenes", "/notebooks-data/scenes"},
		{"chairlift", "/notebooks-data/scenes/b-table-4.2.yaml"},
		{"duffing", "/tests/reference/duffing-nlvib-01.json"},
		{"reference", "/tests/reference"},
		{"top", ""},
	};

	*length = strlen("work");
	if (strncmp(name, "work", *length) == 0)
		return getcwd(value, sizeof value);

	for (size_t i = 0; i < sizeof known/sizeof *known; i++) {
		*length = strlen(known[i][0]);
		if (strncmp(name, known[i][0], *length) == 0) {
			snprintf(value, sizeof value, "%s%s", top, known[i][1]);
			return value;
		}
	}
	give_up("no variable", name);
	return NULL;
}

/* The words of a line, as a shell has them; they stay in `text` [2*LINE]. Returns their number. */
static int split(char **word, char *text, const char *line)
{
	int count = 0;
	size_t length;

	for (char quote = 0; *line;) {
		while (*line == ' ')
			line++;
		if (!*line)
			break;
		word[count++] = text;
		if (count == WORDS)
			give_up("too many words:", line);
		for (; *line && (quote || *line != ' '); line++)
			if (quote ? *line == quote : *line == '\'' || *line == '"')
				quote = quote ? 0 : *line;
			else if (*line == '$' && quote != '\'') {
				const char *value = variable(line + 1, &length);

				text += sprintf(text, "%s", value);
				line += length;
			} else if (*line == '\\' && quote != '\'' && line[1])
				*text++ = *++line;
			else
				*text++ = *line;
		*text++ = '\0';
	}
	word[count] = NULL;
	return count;
}

static void slurp(char *text, size_t size, const char *name)
{
	FILE *file = fopen(name, "r");
	size_t got = file ? fread(text, 1, size - 1, file) : 0;

	text[got] = '\0';
	if (file)
		fclose(file);
}

/* Start a command in a process of its own and wait. */
static void command(const char *line)
{
	static char text[2*LINE + 8*WORDS];
	char *word[WORDS + 1];
	const char *input = "/dev/null";
	int status, count = split(word, text, line);
	pid_t child;

	if (count > 1 && word[count - 1][0] == '<')
		input = word[--count] + 1;
	word[count] = NULL;
	fflush(stdout);
	child = fork();
	if (child == 0) {
		redirect(0, input, O_RDONLY);
		redirect(1, "../out", O_WRONLY | O_CREAT | O_TRUNC);
		redirect(2, "../err", O_WRONLY | O_CREAT | O_TRUNC);
		exit(cli_main(count, word));
	}
	if (child < 0 || waitpid(child, &status, 0) < 0)
		give_up("cannot run", line);
	run.status = WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
	snprintf(run.line, sizeof run.line, "%s", line);
	slurp(run.out, sizeof run.out, "../out");
	slurp(run.err, sizeof run.err, "../err");
}

static int has(const char *text, const char *pattern)
{
	regex_t regex;
	int found;

	if (regcomp(&regex, pattern, REG_EXTENDED | REG_NOSUB | REG_NEWLINE))
		give_up("no regular expression:", pattern);
	found = regexec(&regex, text, 0, NULL, 0) == 0;
	regfree(&regex);
	return found;
}

/* One message: "hawser: ..." and at most one line of advice. */
static int is_message(const char *text)
{
	const char *end = strchr(text, '\n');

	end = end && end[1] ? strchr(end + 1, '\n') : end;
	return strncmp(text, "hawser: ", 8) == 0 && end && !end[1];
}

/* What went wrong, behind the failed check. */
static void show(const char *want)
{
	printf("# wanted: %s\n# exit status %d, standard error:\n", want, run.status);
	for (char *line = strtok(run.err, "\n"); line; line = strtok(NULL, "\n"))
		printf("# %s\n", line);
}

/* The line below a command: "1~ REGEX", "1= TEXT", "1". */
static void judge(const char *line)
{
	char *rest;
	int right, want = (int)strtol(line, &rest, 10);
	const char *text = rest + (*rest ? strspn(rest + 1, " ") + 1 : 0);
	char whole[LINE + 16];

	right = run.status == want && (want == 0 || !run.out[0]);
	snprintf(whole, sizeof whole, "hawser: %s\n", text);
	if (*rest == '~')
		right = right && has(run.err, text) && (want == 0 || is_message(run.err));
	else if (*rest == '=')
		right = right && strcmp(run.err, whole) == 0;
	else
		right = right && (want || !run.err[0]);
	run.judged = 1;
	if (!ok(right, "status %d: %s", want, run.line))
		show(line);
}

/* A file of the lines up to `end`. */
static void make_file(const char *name, FILE *table)
{
	char line[LINE];
	FILE *file = fopen(name, "w");

	if (!file)
		give_up("cannot write", name);
	while (fgets(line, sizeof line, table) && strcmp(line, "end\n") != 0)
		fputs(line, file);
	fclose(file);
}

static void shell(const char *line)
{
	int status;

	fflush(stdout);
	status = system(line);
	if (status)
		give_up("a line of shell failed:", line);
}

/* NAME VALUE, in which variables have their values. */
static void set(const char *line)
{
	static char text[2*LINE + 8*WORDS];
	char *word[WORDS + 1];

	if (split(word, text, line) != 2 || setenv(word[0], word[1], 1))
		give_up("NAME VALUE is wanted:", line);
}

static void follow(const char *line, FILE *table)
{
	if (line[0] == '#' || !line[0])
		return;
	if (strncmp(line, "hawser ", 7) == 0) {
		if (run.line[0] && !run.judged)
			give_up("no status below", run.line);
		run.judged = 0;
		command(line);
	} else if (strncmp(line, "file ", 5) == 0)
		make_file(line + 5, table);
	else if (strncmp(line, "sh ", 3) == 0)
		shell(line + 3);
	else if (strncmp(line, "prints ", 7) == 0)
		ok(has(run.out, line + 7), "  prints %s", line + 7);
	else if (strncmp(line, "lacks ", 6) == 0)
		ok(!has(run.out, line + 6), "  lacks %s", line + 6);
	else if (strncmp(line, "env ", 4) == 0)
		set(line + 4);
	else if (line[0] >= '0' && line[0] <= '9')
		judge(line);
	else
		give_up("not understood:", line);
}

/* The folder of the commands, and what their environment tells lines of shell. */
static void prepare(void)
{
	char folder[LINE];

	if (!mkdtemp(scratch))
		give_up("cannot make", scratch);
	snprintf(folder, sizeof folder, "%s/work", scratch);
	if (mkdir(folder, 0777) || chdir(folder))
		give_up("cannot enter", folder);
	setenv("top", top, 1);
	setenv("LC_ALL", "C", 1);
}

/* The table in memory: a file that is open would be moved by the exit of a command's process. */
static FILE *text_of(const char *path)
{
	static char text[1 << 20];
	struct stat info;

	if (stat(path, &info) || !info.st_size || info.st_size >= (off_t)sizeof text)
		return NULL;
	slurp(text, sizeof text, path);
	return fmemopen(text, (size_t)info.st_size, "r");
}

static int run_table(const char *name)
{
	char path[2*LINE], line[LINE], remove[LINE];
	FILE *table;

	snprintf(path, sizeof path, "%s/tests/%s.table", top, name);
	table = text_of(path);
	if (!table) {
		fprintf(stderr, "no table %s\n", path);
		return 2;
	}
	prepare();
	while (fgets(line, sizeof line, table)) {
		line[strcspn(line, "\n")] = '\0';
		follow(line, table);
	}
	fclose(table);
	if (run.line[0] && !run.judged)
		give_up("no status below", run.line);
	if (chdir("/") == 0) {
		snprintf(remove, sizeof remove, "rm -rf %s", scratch);
		shell(remove);
	}
	return done_testing();
}

static int list(void)
{
	char path[2*LINE];
	DIR *folder;
	struct dirent *entry;

	snprintf(path, sizeof path, "%s/tests/cli", top);
	folder = opendir(path);
	while (folder && (entry = readdir(folder))) {
		const char *suffix = strrchr(entry->d_name, '.');

		if (suffix && strcmp(suffix, ".table") == 0)
			printf("cli/%.*s\n", (int)(suffix - entry->d_name), entry->d_name);
	}
	if (folder)
		closedir(folder);
	return 0;
}

int main(int argc, char **argv)
{
	if (!getenv("SRCDIR") || !realpath(getenv("SRCDIR"), top)) {
		fputs("SRCDIR must be the top of the source tree\n", stderr);
		return 2;
	}
	if (argc != 2)
		return 2;
	if (strcmp(argv[1], "serve") == 0)
		return serve();
	return strcmp(argv[1], "list") == 0 ? list() : run_table(argv[1]);
}

/* tests/run_list.c - which tests tests/run runs: cases of programs, and scripts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/run.h"

_Noreturn void stop(const char *what, const char *name)
{
	fprintf(stderr, "tests/run: %s %s%s%s\n", what, name, errno ? ": " : "",
	        errno ? strerror(errno) : "");
	exit(2);
}

/* Path of a source or a script, as people write it, to the name of a test: tests/property/test-frf
 * to property/frf. */
static void plain_name(char name[NAME], const char *path)
{
	const char *kind = strncmp(path, "./", 2) == 0 ? path + 2 : path, *base;
	size_t length;

	if (strstr(kind, "tests/"))
		kind = strstr(kind, "tests/") + 6;
	base = strrchr(kind, '/') ? strrchr(kind, '/') + 1 : kind;
	snprintf(name, NAME, "%.*s%s", (int)(base - kind), kind,
	         strncmp(base, "test-", 5) == 0 ? base + 5 : base);
	length = strlen(name);
	if (length > 3 && strcmp(name + length - 3, ".sh") == 0)
		name[length - 3] = '\0';
}

/* Does a pattern name this test: its name, its path, or the program of all its cases? */
static int is_named(const struct test *test, const char *const *patterns, int count)
{
	char name[NAME];

	for (int i = 0; i < count; i++) {
		plain_name(name, patterns[i]);
		if (fnmatch(name, test->name, 0) == 0 ||
		    (!test->script && strcmp(patterns[i], test->program) == 0))
			return 1;
	}
	return 0;
}

int is_listed(const char *path, const char *name)
{
	char line[512], first[NAME];
	FILE *file = path ? fopen(path, "r") : NULL;
	int found = 0;

	if (path && !file)
		stop("cannot read", path);
	while (file && !found && fgets(line, sizeof line, file))
		found = sscanf(line, "%127s", first) == 1 && strcmp(first, name) == 0;
	if (file)
		fclose(file);
	return found;
}

static int is_left_out(const struct run *run, const char *name)
{
	int found = 0;

	for (int i = 0; i < run->out_count; i++)
		found |= is_listed(run->out[i], name);
	return found;
}

static void add(struct run *run, const char *name, const char *program, int script)
{
	struct test test = {.program = program, .script = script, .expected_secs = -1, .planned = -1};

	if (strlen(name) >= NAME) {
		errno = 0;
		stop("too long a name:", name);
	}
	strcpy(test.name, name);
	if ((run->only_count && !is_named(&test, run->only, run->only_count)) ||
	    (run->chosen && !is_listed(run->chosen, name)) ||
	    is_named(&test, run->without, run->without_count) || is_left_out(run, name))
		return;
	run->tests = realloc(run->tests, (size_t)(run->count + 1)*sizeof *run->tests);
	if (!run->tests)
		stop("no memory for", name);
	run->tests[run->count++] = test;
}

static void add_program(struct run *run, const char *program)
{
	char name[NAME], command[2*NAME];
	FILE *list;

	snprintf(command, sizeof command, "%s list", program);
	list = popen(command, "r");
	if (!list)
		stop("cannot start", program);
	while (fgets(name, sizeof name, list)) {
		name[strcspn(name, "\n")] = '\0';
		add(run, name, program, 0);
	}
	errno = 0;
	if (pclose(list) != 0)
		stop("cannot list the cases of", program);
}

void gather(struct run *run, int count, char **argument)
{
	char name[NAME];

	for (int i = 0; i < count; i++)
		if (strlen(argument[i]) > 3 && strcmp(argument[i] + strlen(argument[i]) - 3, ".sh") == 0) {
			plain_name(name, argument[i]);
			add(run, name, argument[i], 1);
		} else {
			add_program(run, argument[i]);
		}
	errno = 0;
	for (int i = 0; i < run->only_count; i++) {
		int named = 0;

		for (int k = 0; k < run->count; k++)
			named |= is_named(&run->tests[k], &run->only[i], 1);
		if (!named)
			stop("no test is named", run->only[i]);
	}
}

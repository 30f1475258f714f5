/* tests/run.h - the tests that tests/run runs (run.c), and how it chooses them (run_list.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_RUN_H
#define HAWSER_TESTS_RUN_H

#include <sys/types.h>

enum { NAME = 128, PATTERNS = 1000, JOBS = 64, FILES = 4 };

struct test {
	char name[NAME];          /* KIND/NAME */
	const char *program;      /* its path; a script's own */
	int script;               /* 1: no argument */
	double expected_secs;     /* processor time in the last run, or -1 */
	pid_t pid;                /* while it runs */
	double began;             /* clock, s */
	double processor, clock;  /* s, when it has run */
	int passed, failed, skipped, planned, status, done;
};

struct run {
	struct test *tests;          /* [count] */
	int count, ran, broken;
	const char *only[PATTERNS], *without[PATTERNS];
	int only_count, without_count;
	int jobs;
	const char *results, *logs, *wrapper;
	double limit_secs;        /* processor time above which a test fails, or 0 */
	const char *exceptions;   /* file: names of tests that may take longer, each with the reason */
	const char *chosen, *out[FILES]; /* files: names of the only tests, and of tests to leave out */
	int out_count;
	const char *counts;       /* folder of what gcov counts, or NULL */
	double began, told;
};

/* Ends the program with a message, and what errno says. */
_Noreturn void stop(const char *what, const char *name);

/* The tests of the programs and the scripts that are named. */
void gather(struct run *run, int count, char **argument);

/* Is the name the first word of a line of the file? NULL: no. */
int is_listed(const char *path, const char *name);

#endif

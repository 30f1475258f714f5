/* tests/cases.c - main of a program of test cases: `tests/response list` prints their names,
 * `tests/response property/frf` runs one. The table is made from the names of the program's sources
 * (tests/local.mk).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "tests/cases.h"

/* Of OpenBLAS, whose threads wait for each other where a test has threads of its own: with more threads
 * than processors a test of 3 s took minutes. Another BLAS has no such function. */
void openblas_set_num_threads(int threads) __attribute__((weak));

static const struct test_case *find(const char *name)
{
	for (const struct test_case *row = test_cases; row->name; row++)
		if (strcmp(row->name, name) == 0)
			return row;
	return NULL;
}

static int list(void)
{
	for (const struct test_case *row = test_cases; row->name; row++)
		puts(row->name);
	return 0;
}

int main(int argc, char **argv)
{
	int failed = 0;

	if (argc == 2 && strcmp(argv[1], "list") == 0)
		return list();
	if (openblas_set_num_threads)
		openblas_set_num_threads(1);
	for (int i = 1; i < argc; i++)
		if (!find(argv[i])) {
			fprintf(stderr, "%s: no case %s (%s list prints them)\n", argv[0], argv[i],
			        argv[0]);
			return 2;
		}
	for (int i = 1; i < argc; i++)
		failed |= find(argv[i])->run();
	if (argc < 2)
		fprintf(stderr, "usage: %s list | CASE...\n", argv[0]);
	return argc < 2 ? 2 : failed != 0;
}

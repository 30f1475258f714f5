/* tests/tap.h - output in the Test Anything Protocol: one line per check, with values on failure.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TAP_H
#define HAWSER_TESTS_TAP_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int tap_count, tap_failed;

/* The function of a case, KIND_NAME in the file tests/KIND/test-NAME.c: its checks, then
 * `return done_testing();`. */
#define CASE(name)  \
	int name(void); \
	int name(void)

/* One check. Returns the condition, so that a test can stop early. */
static inline int ok(int condition, const char *format, ...)
{
	va_list args;

	printf("%s %d - ", condition ? "ok" : "not ok", ++tap_count);
	va_start(args, format);
	vprintf(format, args);
	va_end(args);
	putchar('\n');
	if (!condition)
		tap_failed++;
	return condition;
}

/* |got - want| <= tolerance*|want|; prints all three on failure. */
static inline int close_to(double got, double want, double tolerance, const char *what)
{
	double error = want != 0.0 ? fabs(got - want)/fabs(want) : fabs(got);

	return ok(error <= tolerance, "%s: %.15g against %.15g, relative error %.2e <= %.1e", what,
	          got, want, error, tolerance);
}

/* The path of a file below the top of the source tree. It holds until the next call but one. */
static inline const char *source_file(const char *format, ...)
{
	static char paths[2][4096];
	static int last;
	const char *top = getenv("SRCDIR");
	char *path = paths[last = !last];
	int used = snprintf(path, sizeof *paths, "%s/", top ? top : ".");
	va_list args;

	va_start(args, format);
	vsnprintf(path + used, sizeof *paths - (size_t)used, format, args);
	va_end(args);
	return path;
}

/* Last line of a case: the plan. Returns the exit status. */
static inline int done_testing(void)
{
	printf("1..%d\n", tap_count);
	return tap_failed != 0;
}

#endif

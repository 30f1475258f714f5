/* tests/tap.h - output in the Test Anything Protocol: one line per check, with values on failure.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TAP_H
#define HAWSER_TESTS_TAP_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
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

/* Last line of a case: the plan. Returns the exit status. */
static inline int done_testing(void)
{
	printf("1..%d\n", tap_count);
	return tap_failed != 0;
}

#endif

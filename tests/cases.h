/* tests/cases.h - the table of a program of test cases, which tests/cases.sh writes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_CASES_H
#define HAWSER_TESTS_CASES_H

struct test_case {
	const char *name; /* "property/frf": of the function property_frf in tests/property/test-frf.c */
	int (*run)(void); /* prints TAP; 0 if all checks passed */
};

extern const struct test_case test_cases[]; /* [number of cases + 1]: the last name is NULL */

#endif

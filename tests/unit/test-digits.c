/* Numbers as text: the same characters as printf with 17 digits, in the form that JSON wants.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "tests/tap.h"

static struct hawser__powers powers;
static int wrong;

/* %.17g with ".0" after an integer, and exponents without "+" and leading zeros. */
static void expected(char *text, size_t size, double value)
{
	char *e, *from;

	snprintf(text, size - 2, "%.17g", value);
	if (!strpbrk(text, ".e"))
		strcat(text, ".0");
	if (!(e = strchr(text, 'e')))
		return;
	from = e + 1 + (e[1] == '+' || e[1] == '-');
	e += 1 + (e[1] == '-');
	from += strspn(from, "0");
	memmove(e, from, strlen(from) + 1);
}

static void compare(double value)
{
	char want[40], got[HAWSER__DIGITS_SIZE];
	size_t length;

	if (!isfinite(value))
		return;
	expected(want, sizeof want, value);
	length = hawser__digits(got, value, &powers);
	if (strcmp(want, got) != 0 || length != strlen(got)) {
		if (wrong++ == 0)
			printf("# %s is written as %s\n", want, got);
	}
}

static void around(double value)
{
	compare(nextafter(value, -INFINITY));
	compare(value);
	compare(nextafter(value, INFINITY));
}

static uint64_t random_bits(void)
{
	static uint64_t state = 88172645463325252u; /* xorshift (Marsaglia 2003) */

	state ^= state << 13;
	state ^= state >> 7;
	state ^= state << 17;
	return state;
}

CASE(unit_digits)
{
	hawser__powers_make(&powers);
	for (int k = -323; k <= 308; k++) {
		char text[16];

		snprintf(text, sizeof text, "1e%d", k);
		around(strtod(text, NULL));
	}
	compare(0.0);
	compare(-0.0);
	ok(wrong == 0, "zero, and all powers of ten with their neighbours");
	wrong = 0;
	for (int k = -1074; k <= 1023; k++)
		around(ldexp(1.0, k));
	ok(wrong == 0, "all powers of two with their neighbours");
	wrong = 0;
	for (int i = 0; i < 100000; i++) {
		uint64_t bits = random_bits();
		double value;

		memcpy(&value, &bits, sizeof value);
		compare(value);
	}
	ok(wrong == 0, "random bits");
	wrong = 0;
	for (int i = 0; i < 100000; i++) /* many of these are ties of the 18th digit */
		compare(((double)(random_bits() % 2000001) - 1e6)/(double)(1 << random_bits() % 30));
	ok(wrong == 0, "short binary fractions");
	return done_testing();
}

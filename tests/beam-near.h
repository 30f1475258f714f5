/* tests/beam-near.h - compare two numbers, with a formatted name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_BEAM_NEAR_H
#define HAWSER_TESTS_BEAM_NEAR_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "tests/tap.h"

static inline int near_to(double got, double want, double within, const char *format, ...)
{
	char text[200];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	return ok(fabs(got - want) <= within, "%s: %.15g, expected %.15g within %.1e", text, got, want,
	        within);
}

#endif

/* tests/extremes/modes-quad.c - a frequency's error in quadruple precision, for where the extended one
 * of the sweep's own check has not the digits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/extremes/modes-count.h"
#include "tests/extremes/modes-quad.h"

double quad_frequency_error(const struct hawser_statics *st, enum hawser_plane plane, double omega,
                            int steps)
{
	return count_error(st, plane, omega, steps);
}

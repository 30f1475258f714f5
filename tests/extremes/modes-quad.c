/* tests/extremes/modes-quad.c - the error of a frequency in quadruple precision, for scenes in which
 * the extended precision of the sweep's own check is not sufficient.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/extremes/modes-count.h"
#include "tests/extremes/modes-quad.h"

double quad_frequency_error(const struct hawser_statics *st, enum hawser_plane plane, double omega,
                            int steps)
{
	return count_error(st, plane, omega, steps);
}

/* tests/extremes/modes-quad.h - see modes-quad.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_QUAD_H
#define HAWSER_TESTS_MODES_QUAD_H

#include <hawser/modes.h>

double quad_frequency_error(const struct hawser_statics *st, enum hawser_plane plane, double omega,
                            int steps);

#endif

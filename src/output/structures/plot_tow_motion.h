/* output/structures/plot_tow_motion.h - a towed body in time: its way, tilt and tensions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_TOW_MOTION_H
#define HAWSER_OUTPUT_PLOT_TOW_MOTION_H

#include <hawser/tow.h>

#include "output/output.h"

enum hawser_status hawser__plot_tow_motion(const char *path, const struct hawser_tow_motion *motion,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

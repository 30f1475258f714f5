/* output/structures/plot_rod.h - a rod under load and at rest, in perspective; forces and
 * moments along it. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_ROD_H
#define HAWSER_OUTPUT_PLOT_ROD_H

#include <hawser/rod.h>
#include <hawser/rod_motion.h>

#include "output/output.h"

enum hawser_status hawser__plot_rod(const char *path, const struct hawser_rod *rod,
                                    const struct hawser_rod_statics *st,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* A motion: shapes at some times, the first probe (its name) and the energies over time. */
enum hawser_status hawser__plot_rod_motion(const char *path, const struct hawser_rod_motion *motion,
                                           const char *probe, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#endif

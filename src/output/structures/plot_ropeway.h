/* output/structures/plot_ropeway.h - a ropeway: the line with its towers, carriers and reactions;
 * tensions; with worst values also their envelope and the least forces on the batteries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_ROPEWAY_H
#define HAWSER_OUTPUT_PLOT_ROPEWAY_H

#include <hawser/ropeway.h>

#include "output/output.h"

enum hawser_status hawser__plot_ropeway(const char *path, const struct hawser_ropeway *ropeway,
                                        const struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway_worst *worst /* or NULL */,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

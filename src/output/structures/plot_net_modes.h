/* output/structures/plot_net_modes.h - mode shapes of a net in perspective, one panel a mode.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_NET_MODES_H
#define HAWSER_OUTPUT_PLOT_NET_MODES_H

#include <hawser/net_modes.h>

#include "output/output.h"

enum hawser_status hawser__plot_net_modes(const char *path, const struct hawser_net_modes *modes,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

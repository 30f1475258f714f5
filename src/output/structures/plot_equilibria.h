/* output/structures/plot_equilibria.h - the equilibria of a net of bars, seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_EQUILIBRIA_H
#define HAWSER_OUTPUT_PLOT_EQUILIBRIA_H

#include <hawser/net_equilibria.h>

#include "output/output.h"

/* Stable ones are solid, unstable ones dashed; that of the cables, without compression, is wide. */
enum hawser_status hawser__plot_equilibria(const char *path, const struct hawser_net *net,
                                           const struct hawser_net_equilibria *found,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

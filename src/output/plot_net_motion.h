/* output/plot_net_motion.h - the motion of a net over time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_NET_MOTION_H
#define HAWSER_OUTPUT_PLOT_NET_MOTION_H

#include <hawser/net_motion.h>

#include "output/output.h"

/* Displacements and tensions of the first probes, the energies and, if there are any, the number of
 * slack elements; names [motion->probes]. */
enum hawser_status hawser__plot_net_motion(const char *path, const struct hawser_net_motion *motion,
                                           const char *const *names, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#endif

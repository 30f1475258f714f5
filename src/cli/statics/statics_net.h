/* cli/statics/statics_net.h - hawser statics of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_NET_H
#define HAWSER_CLI_STATICS_NET_H

#include "cli/frame/cli.h"

/* method: a row of hawser_net_method, or NULL; profile: 1 for the table of points along the cables;
 * vtk: a file, or NULL. */
enum hawser_status cli_statics_net(const struct cli_common *common, const char *method, int profile,
                                   const char *vtk, struct hawser_report *report) HAWSER_MUST_CHECK;
/* All equilibria of bars in place of the cables, from so many random starts. */
enum hawser_status cli_equilibria_net(const struct cli_common *common, int starts,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

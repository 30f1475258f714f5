/* cli/statics/statics_net.h - equilibria of bars in place of the cables of a net.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_NET_H
#define HAWSER_CLI_STATICS_NET_H

#include "cli/frame/view.h"

/* All equilibria of bars in place of the cables, from so many random starts. */
enum hawser_status cli_equilibria_net(const struct cli_common *common, int starts,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_equilibria_net_field[], cli_equilibria_net_member[];

#endif

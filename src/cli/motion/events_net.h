/* cli/motion/events_net.h - cables of a net that part, and winches, in the output of hawser integrate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_EVENTS_NET_H
#define HAWSER_CLI_EVENTS_NET_H

#include <hawser/net_motion.h>

#include "cli/frame/view.h"

struct cli_events {
	const struct hawser_net *net;
	const struct hawser_net_parted *failure; /* [failures] */
	const struct hawser_net_wound *winch;    /* [winches] */
	int failures, winches;
};
/* Options of the view. */
enum { CLI_FAILURES = 2, CLI_WINCHES = 4 };
extern const struct hawser__field cli_events_field[];
void cli_events_comments(struct hawser__table *table, const struct cli_events *events);

#endif

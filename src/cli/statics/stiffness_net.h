/* cli/statics/stiffness_net.h - hawser statics --stiffness: the stiffness of a net at its nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STIFFNESS_NET_H
#define HAWSER_CLI_STIFFNESS_NET_H

#include <hawser/net.h>

#include "cli/frame/view.h"

struct cli_stiffness {
	int rows; /* 0: not asked for */
	struct hawser_net_stiffness of;
};
/* nodes: names between commas, or NULL; about: "x,y,z", each a number in m or with a unit, or NULL. */
enum hawser_status cli_stiffness_fill(struct cli_stiffness *stiffness, const struct hawser_net *net,
                                      const char *nodes, const char *about,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_stiffness_comments(struct hawser__table *table, const struct cli_stiffness *stiffness);

/* Options of the view: stiffness is asked for; and of turns. */
enum { CLI_STIFFNESS = 4, CLI_STIFFNESS_TURNS = 8 };
/* Columns; rows of the parent's member `stiffness`; members of JSON. */
extern const struct hawser__field cli_stiffness_field[], cli_stiffness_member[];
extern const struct hawser__list cli_stiffness_list;

#endif

/* cli/modes/modes_net.h - hawser modes of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_NET_H
#define HAWSER_CLI_MODES_NET_H

#include "cli/frame/cli.h"
#include "output/fields/fields.h"

/* n: number of modes, 0 for the default; shapes 1: at the nodes of the mesh in JSON too; vtk: a file,
 * or NULL; contact: in place of contact.modes, or NULL. */
enum hawser_status cli_modes_net(const struct cli_common *common, int n, int shapes, const char *vtk,
                                 const char *contact, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Columns of the table, keys of JSON. */
extern const struct hawser__field cli_modes_net_field[], cli_modes_net_member[];

#endif

/* cli/frame/mesh_net.h - the mesh of a net's scene: elements that are not given, and its error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MESH_NET_H
#define HAWSER_CLI_MESH_NET_H

#include <hawser/net.h>

#include "cli/frame/view.h"

struct cli_mesh {
	struct hawser_net net;
	struct hawser_net_mesh_error error; /* of the equilibrium */
};
/* Read the scene, and choose the elements that it does not give: the same for all commands. */
enum hawser_status cli_mesh_open(struct hawser_net *net, const struct cli_common *common,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* The error of the tensions: a comment, and of a struct cli_mesh the object `mesh_error`. */
void cli_mesh_comment(struct hawser__table *table, const struct cli_mesh *mesh);
extern const struct hawser__field cli_mesh_field[];
/* What must be said of a large one, in text [CLI_WARNING_SIZE]; "" if it is small. */
void cli_mesh_warning(char *text, const struct cli_mesh *mesh);

/* Arrays [nodes][3], in JSON by name: of all nodes, and of supports. Context: the net. */
extern const struct hawser__vector cli_nodes, cli_supports;
#define CLI_NODES_AT(type, member, of) \
	.kind = HAWSER__VECTOR, .vector = &(of), HAWSER__PLACE(type, member)

#endif

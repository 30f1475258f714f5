/* cli/frame/mesh_net.h - the mesh of a net's scene: elements that are not given, and its error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MESH_NET_H
#define HAWSER_CLI_MESH_NET_H

#include <hawser/net.h>

#include "cli/frame/cli.h"

/* Read the scene, and choose the elements that it does not give: the same for all commands. */
enum hawser_status cli_mesh_open(struct hawser_net *net, const struct cli_common *common,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* The error of the tensions: a comment, and the object `mesh_error`. */
void cli_mesh_comment(struct hawser__table *table, const struct hawser_net *net,
                      const struct hawser_net_mesh_error *error);
void cli_mesh_json(struct hawser__json *json, json_t *into, const struct hawser_net *net,
                   const struct hawser_net_mesh_error *error);
/* What must be said of a large one, in text [CLI_WARNING_SIZE]; "" if it is small. */
void cli_mesh_warning(char *text, const struct hawser_net *net,
                      const struct hawser_net_mesh_error *error);

#endif

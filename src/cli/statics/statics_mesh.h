/* cli/statics/statics_mesh.h - hawser statics --model fe: a mesh in place of the catenary.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_MESH_H
#define HAWSER_CLI_STATICS_MESH_H

#include "cli/frame/view.h"

extern const struct hawser__field cli_statics_mesh_field[]; /* of a struct hawser_net_span_statics */
void cli_statics_mesh_comments(struct hawser__table *table,
                               const struct hawser_net_span_statics *mesh);
/* Whether the options --model, --elements and --points go together. */
enum hawser_status cli_statics_mesh_check(const char *model, int points, int usual,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* The mesh; its nodes are the *profile [mesh->points], which the caller frees. */
enum hawser_status cli_statics_mesh(struct hawser__spot **profile,
                                    struct hawser_net_span_statics *mesh,
                                    const struct hawser_scene *scene,
                                    const struct hawser_statics *statics, int elements,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

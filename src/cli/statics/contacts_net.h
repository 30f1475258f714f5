/* cli/statics/contacts_net.h - what a net touches, in the output of hawser statics and modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CONTACTS_NET_H
#define HAWSER_CLI_CONTACTS_NET_H

#include <hawser/net.h>

#include "output/output.h"

/* A comment for each obstacle, and how well the contacts are solved. */
void cli_contacts_comments(struct hawser__table *table, const struct hawser_net *net,
                           const struct hawser_net_statics *st);
/* contacts [{..}]. */
void cli_contacts_list(struct hawser__json *json, const struct hawser_net *net,
                       const struct hawser_net_contact *all, int contacts);
/* The same of a statics, and complementarity. */
void cli_contacts_json(struct hawser__json *json, const struct hawser_net *net,
                       const struct hawser_net_statics *st);
/* The points along the cables, with their tensions and what they touch: contact is an enum
 * hawser_net_contact_state. */
enum hawser_status cli_contacts_vtk(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* Of a point of the profile: the obstacle, the forces of the contact, and its state. */
void cli_contacts_row(struct hawser__table *row, const struct hawser_net *net,
                      const struct hawser_net_statics *st, const struct hawser_net_point *point);

#endif

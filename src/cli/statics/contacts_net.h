/* cli/statics/contacts_net.h - what a net touches, in the output of hawser statics and modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CONTACTS_NET_H
#define HAWSER_CLI_CONTACTS_NET_H

#include <hawser/net.h>

#include "cli/frame/view.h"

/* A comment for each obstacle, and how well the contacts are solved. */
void cli_contacts_comments(struct hawser__table *table, const struct hawser_net *net,
                           const struct hawser_net_statics *st);
/* `contacts`, a list of objects. */
struct cli_contacts {
	const struct hawser_net *net;
	const struct hawser_net_contact *contact; /* [contacts] */
	int contacts;
	double apart;
};
extern const struct hawser__field cli_contacts_field[], cli_apart_field[];
/* The points along the cables, with their tensions and what they touch: contact is an enum
 * hawser_net_contact_state. */
enum hawser_status cli_contacts_vtk(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* Of a point of the profile: the obstacle, the forces of the contact, and its state. */
struct cli_touch {
	const char *obstacle, *state; /* "-", "open" */
	double r_N, r_T;
};
struct cli_touch cli_contacts_at(const struct hawser_net *net, const struct hawser_net_statics *st,
                                 const struct hawser_net_point *point);

#endif

/* net/value.h - values of a tree: numbers with units, vectors, names; keys that a mapping may have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_VALUE_H
#define HAWSER_NET_VALUE_H

#include <hawser/net.h>
#include "net/tree.h"

enum hawser__net_range { HAWSER__NET_ANY, HAWSER__NET_POSITIVE, HAWSER__NET_NOT_NEGATIVE };

/* A tree must be a mapping whose keys are among `keys`, such as "EA, rho, length0". */
enum hawser_status hawser__net_keys(struct hawser__reader *reader, const struct hawser__tree *tree,
                                    const char *what, const char *keys) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_number(struct hawser__reader *reader, double *value,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *unit, enum hawser__net_range range)
	HAWSER_MUST_CHECK;
enum hawser_status hawser__net_vector(struct hawser__reader *reader, double value[3],
                                      const struct hawser__tree *tree, const char *what,
                                      const char *unit) HAWSER_MUST_CHECK;
/* Letters, digits, _ and -, not only digits. */
enum hawser_status hawser__net_name(struct hawser__reader *reader, char name[HAWSER_NET_NAME],
                                    const struct hawser__tree *tree, const char *text,
                                    const char *what) HAWSER_MUST_CHECK;
/* The text of a scalar; fails for others. */
enum hawser_status hawser__net_text(struct hawser__reader *reader, const char **text,
                                    const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* loads.c: `loads` and `supports` of the scene, whose nodes and cables are known. */
enum hawser_status hawser__net_loads(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_supports(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* names.c: sort the names, of nodes and of cables if there are any yet. */
enum hawser_status hawser__net_index(struct hawser__reader *reader, struct hawser_net *net)
	HAWSER_MUST_CHECK;
/* The node or cable of this name; fails if there is none. `what` begins the message. */
int hawser__net_node_of(const struct hawser_net *net, const char *name);
int hawser__net_cable_of(const struct hawser_net *net, const char *name);
enum hawser_status hawser__net_find_node(struct hawser__reader *reader, int *node,
                                         const struct hawser_net *net,
                                         const struct hawser__tree *tree, const char *name,
                                         const char *what) HAWSER_MUST_CHECK;

#endif

/* net/read/read.h - reading a scene of kind `net`: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_READ_H
#define HAWSER_NET_READ_H

#include <hawser/net.h>
#include "scene/tree.h"

/* loads.c: `loads` and `supports` of the scene, whose nodes and cables are known. */
enum hawser_status hawser__net_loads(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_supports(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* passing.c: `passing` of the scene, as loads of cables. */
struct hawser__net_passing {
	double weight, mass, spacing, first, speed; /* N or kg, m, m, m/s; 0: not given */
	int harmonics;
};
enum hawser_status hawser__net_passing(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* loads.c: room for one more load. */
enum hawser_status hawser__net_more(struct hawser_net_load **list, int count,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* absorbed.c: `absorbers` of the scene. */
struct hawser__net_absorber_given {
	struct hawser_net_absorber of;
	double omega;             /* rad/s, in place of the stiffness; 0: not given */
};
enum hawser_status hawser__net_absorbers(struct hawser__reader *reader, struct hawser_net *net,
                                         const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* bodies.c: `bodies` of the scene, whose rods become cables. */
enum hawser_status hawser__net_bodies(struct hawser__reader *reader, struct hawser_net *net,
                                      const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* Masses with hangers become nodes and cables, after all others are known. */
enum hawser_status hawser__net_hangers(struct hawser__reader *reader, struct hawser_net *net)
	HAWSER_MUST_CHECK;
/* water.c: `water` and `buoys` of the scene, and whether a cable has what it needs in it. */
enum hawser_status hawser__net_water(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_buoys(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_wet(struct hawser__reader *reader, const struct hawser_water *water,
                                   const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* What the tables of keys leave of `water`: waves and currents; g in m/s^2. */
enum hawser_status hawser__water_read(struct hawser__reader *reader, struct hawser_water *water,
                                      double g, const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* Refuse the height y (m) of what is named there, below the bed of the water. */
enum hawser_status hawser__water_bed(struct hawser__reader *reader, const struct hawser_water *water,
                                     double y, const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* blown.c: `wind` of the scene; that of a cable, whose mapping is `tree`. */
enum hawser_status hawser__net_wind(struct hawser__reader *reader, struct hawser_net *net,
                                    const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_section(struct hawser__reader *reader, struct hawser_net *net, int cable,
                                       const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* Refuse nodes below the depth of the water. */
enum hawser_status hawser__net_bed(struct hawser__reader *reader, const struct hawser_net *net,
                                   const struct hawser__tree *nodes) HAWSER_MUST_CHECK;
/* read.c: a mapping of nodes, whose values have this key. */
enum hawser_status hawser__net_of_nodes(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree, const char *path,
                                        const char *example) HAWSER_MUST_CHECK;
/* read-span.c: nodes, supports and the cable of a span. */
enum hawser_status hawser__net_of_span(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *root) HAWSER_MUST_CHECK;
/* events.c: `failures` and `winches` of the scene. */
enum hawser_status hawser__net_failures(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_winches(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* obstacles.c: `obstacles` and `contact` of the scene, and whether its supports are outside them. */
enum hawser_status hawser__net_obstacles(struct hawser__reader *reader, struct hawser_net *net,
                                         const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_contact(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* pulled.c: the ways of contact.sliding: pulled. */
enum hawser_status hawser__net_pulled(struct hawser__reader *reader, struct hawser_net *net,
                                      const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_room(struct hawser__reader *reader, const struct hawser_net *net,
                                    const struct hawser__tree *root) HAWSER_MUST_CHECK;
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

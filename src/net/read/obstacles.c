/* net/read/obstacles.c - obstacles of a net's scene, what the scene says of contact, and whether
 * there is room. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/heights.h"
#include "core/report.h"
#include "net/net.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };

/* Of the distance of a place from the origin: a support may touch an obstacle, whose gap is then
 * round-off of units and of normals. */
static const double TOUCHES = 1e-9;

enum hawser_status hawser__net_obstacles(struct hawser__reader *reader, struct hawser_net *net,
                                         const struct hawser__tree *tree)
{
	enum hawser_status status;

	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			return hawser__reader_fail(reader, &tree->at, "obstacles: cable %s has no length0, and "
			                           "form finding does not know obstacles: give its length0",
			                           net->cable[c].name);
	status = hawser__surfaces_read(reader, &net->surface, &net->surfaces, tree,
	                               hawser__net_rounding(net));
	for (int s = 0; s < net->surfaces && !status; s++)
		for (int c = 0; c < net->cables && net->surface[s].stiffness > 0.0; c++)
			if (!(net->cable[c].line.diameter > 0.0))
				return hawser__reader_fail(reader, &tree->at, "obstacles.%s.stiffness is per "
				                           "diameter, and cable %s has none: give it one, such as "
				                           "diameter: 0.1 m", net->surface[s].name,
				                           net->cable[c].name);
	return status;
}

static enum hawser_status way(struct hawser__reader *reader, struct hawser_net *net,
                              const struct hawser__tree *tree)
{
	struct hawser_net_path *path = &net->contact.path[net->contact.paths];
	char what[CALLED], shown[HAWSER__SHOWN];
	enum hawser_status status;

	snprintf(what, sizeof what, "contact.path.%s", hawser__shown(shown, tree->name));
	status = hawser__net_find_node(reader, &path->node, net, tree, tree->name, "contact.path");
	if (status)
		return status;
	if (!net->node[path->node].support)
		return hawser__reader_fail(reader, &tree->at, "%s: the node is no support: a way is that of a "
		                           "support", what);
	if (tree->kind != HAWSER__SEQUENCE || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "%s must be a list of places, such as "
		                           "[[380 m, 200 m, 0 m]]; the way ends where nodes has the support",
		                           what);
	path->x = calloc((size_t)tree->children, sizeof *path->x);
	if (!path->x)
		return hawser__no_memory(reader->report, "scene");
	net->contact.paths++;
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next)
		status = hawser__tree_vector(reader, path->x[path->points++], 3, one, what, "m");
	return status;
}

static enum hawser_status ways(struct hawser__reader *reader, struct hawser_net *net,
                               const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "contact.path must be a mapping of supports to "
		                           "their ways, such as {B: [[380 m, 200 m, 0 m]]}");
	net->contact.path = calloc((size_t)tree->children, sizeof *net->contact.path);
	if (!net->contact.path)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next)
		status = way(reader, net, one);
	for (int i = 1; i < net->contact.paths && !status; i++)
		if (net->contact.path[i].points != net->contact.path[0].points)
			status = hawser__reader_fail(reader, &tree->at, "contact.path: %s has %d places and %s "
			                             "%d: give as many, since the supports go from one to the "
			                             "next together", net->node[net->contact.path[0].node].name,
			                             net->contact.path[0].points,
			                             net->node[net->contact.path[i].node].name,
			                             net->contact.path[i].points);
	return status;
}

enum hawser_status hawser__net_contact(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "path");
	enum hawser_status status = HAWSER_OK;

	if (!net->surfaces)
		return hawser__reader_fail(reader, &tree->at, "contact is of obstacles, and the scene has "
		                           "none: add the section obstacles");
	for (int i = 0; i < net->surfaces && net->contact.history; i++)
		if (net->surface[i].axial > 0.0)
			return hawser__reader_fail(reader, &tree->at, "contact.sliding does not know the axial and "
			                           "transverse friction of obstacles.%s: give one number",
			                           net->surface[i].name);
	if (!one && net->contact.history == HAWSER_NET_PULLED)
		return hawser__net_pulled(reader, net, tree);
	if (!status && !one && net->contact.history)
		status = hawser__reader_fail(reader, &tree->at, "contact.sliding: history needs contact.path, "
		                             "the way of one or more supports to their places, such as path: "
		                             "{B: [[380 m, 200 m, 0 m]]}");
	if (!status && one && net->contact.history != HAWSER_NET_HISTORY)
		status = hawser__reader_fail(reader, &one->at, "contact.path is of sliding: history: give "
		                             "that, or leave path out");
	return status || !one ? status : ways(reader, net, one);
}

static enum hawser_status outside(struct hawser__reader *reader, const struct hawser_net *net,
                                  const struct hawser__mark *at, const char *what, const double x[3])
{
	double reach = fabs(x[0]) + fabs(x[1]) + fabs(x[2]);

	for (int i = 0; i < net->surfaces; i++) {
		const struct hawser_surface *surface = &net->surface[i];
		double g = hawser_surface_gap(NULL, NULL, surface, x);
		double own = fabs(surface->at[0]) + fabs(surface->at[1]) + fabs(surface->at[2]);

		if (g < -TOUCHES*(reach + own + surface->radius))
			return hawser__reader_fail(reader, at, "%s is %.6g m inside obstacle %s: move it, or the "
			                           "obstacle%s", what, -g, surface->name,
			                           surface->heights ? " (the free side of a bed is above it)"
			                           : surface->kind == HAWSER_SURFACE_PLANE
			                           ? " (the free side of a plane is that of its normal)" : "");
	}
	return HAWSER_OK;
}

/* Two planes that face each other and have no room between them. */
static enum hawser_status facing(struct hawser__reader *reader, const struct hawser_net *net,
                                 const struct hawser__tree *root)
{
	for (int i = 0; i < net->surfaces; i++)
		for (int j = 0; j < i; j++) {
			const struct hawser_surface *a = &net->surface[j], *b = &net->surface[i];
			double along = a->normal[0]*b->normal[0] + a->normal[1]*b->normal[1] +
			               a->normal[2]*b->normal[2], room;

			if (a->kind != HAWSER_SURFACE_PLANE || b->kind != HAWSER_SURFACE_PLANE ||
			    along > -1.0 + 1e-12)
				continue;
			room = hawser_surface_gap(NULL, NULL, a, b->at);
			if (room < 0.0)
				return hawser__reader_fail(reader, &hawser__tree_find(root, "obstacles")->at,
				                           "obstacles %s and %s leave no room: they face each other, "
				                           "and overlap by %.6g m: correct a point or a normal",
				                           a->name, b->name, -room);
		}
	return HAWSER_OK;
}

enum hawser_status hawser__net_room(struct hawser__reader *reader, const struct hawser_net *net,
                                    const struct hawser__tree *root)
{
	const struct hawser__tree *nodes = hawser__tree_find(root, "nodes");
	const struct hawser__tree *node = nodes ? nodes->child : NULL;
	const struct hawser__tree *contact = hawser__tree_find(root, "contact");
	enum hawser_status status = facing(reader, net, root);
	char what[CALLED];

	for (int i = 0; i < net->nodes && !status; i++, node = node ? node->next : NULL) {
		if (hawser__touch_around(net) && !net->node[i].support && !net->node[i].placed)
			return hawser__reader_fail(reader, node ? &node->at : &root->at, "node %s has no place, "
			                           "and an obstacle has side: around: the places of all nodes say "
			                           "how the cables go around it: give it one", net->node[i].name);
		if (!net->node[i].support && !net->node[i].placed)
			continue;
		snprintf(what, sizeof what, "%s %s", net->node[i].support ? "support" : "node",
		         net->node[i].name);
		status = outside(reader, net, node ? &node->at : &root->at, what, net->node[i].x);
	}
	for (int i = 0; i < net->contact.paths && !status; i++)
		for (int j = 0; j < net->contact.path[i].points && !status; j++) {
			snprintf(what, sizeof what, "place %d of contact.path.%s", j + 1,
			         net->node[net->contact.path[i].node].name);
			status = outside(reader, net, &contact->at, what, net->contact.path[i].x[j]);
		}
	return status;
}

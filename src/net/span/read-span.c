/* net/span/read-span.c - the scene of a span in water, or whose obstacles are not all circles: a net of
 * one cable between the supports A and B. Spans over circles alone have exact catenaries and arcs
 * (hawser/obstacles.h). SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"

/* The section of this name into a structure. */
static enum hawser_status section(struct hawser__reader *reader, void *to,
                                  const struct hawser__tree *root, const char *name)
{
	const struct hawser__tree *found = hawser__tree_find(root, name);
	char of[32];

	snprintf(of, sizeof of, "mesh.%s", name);
	return found ? hawser__tree_fill(reader, to, found, name, of)
		: hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "%s is missing: the "
		                      "scene of a span needs cable, span and tension (see "
		                      "hawser-scene(5))", name);
}

enum hawser_status hawser__net_of_span(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *root)
{
	const struct hawser__tree *kind = hawser__tree_find(root, "kind");
	const struct hawser__tree *tension = hawser__tree_find(root, "tension");
	struct hawser_net_cable *to;
	struct hawser_net_node *node;
	enum hawser_status status = hawser__tree_keys(reader, root, "the scene", "mesh");

	if (!status && kind)
		status = hawser__tree_value(reader, net, kind, "kind", "mesh.kind");
	if (status)
		return status;
	net->node = node = calloc(2, sizeof *net->node);
	net->cable = to = calloc(1, sizeof *net->cable);
	if (!node || !to)
		return hawser__no_memory(reader->report, "scene");
	net->nodes = 2;
	net->cables = 1;
	for (int i = 0; i < 2; i++) {
		snprintf(node[i].name, sizeof node[i].name, "%c", "AB"[i]);
		node[i].placed = node[i].support = 1;
		memset(node[i].held, 1, sizeof node[i].held);
	}
	snprintf(to->name, sizeof to->name, "cable");
	to->to = 1;
	to->elements_given = hawser__tree_find(hawser__tree_find(root, "cable"), "elements") != NULL;
	for (int end = 0; end < 2; end++) {
		const struct hawser__tree *one = hawser__tree_find(tension, end ? "T1" : "T0");

		if (one)
			return hawser__reader_fail(reader, &one->at, "tension.T%d: in water, and with planes "
			                           "and segments, the unstretched length must be known: give "
			                           "tension.length0, in m",
			                           end);
	}
	status = section(reader, &node[1], root, "span");
	if (!status)
		status = section(reader, to, root, "cable");
	if (!status)
		status = section(reader, to, root, "tension");
	return status ? status : hawser__net_index(reader, net);
}

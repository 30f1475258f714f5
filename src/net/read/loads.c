/* net/read/loads.c - supports, their motion, and loads of a net's scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };

enum hawser_status hawser__net_more(struct hawser_net_load **list, int count,
                                    struct hawser_report *report)
{
	return hawser__more(list, count, sizeof **list) ? hawser__no_memory(report, "net") : HAWSER_OK;
}

/* A harmonic has a frequency or a multiple. */
static enum hawser_status frequency(struct hawser__reader *reader, const struct hawser_net_load *load,
                                    const struct hawser__tree *tree, const char *what,
                                    const char *section)
{
	if (!load->harmonic || (load->Omega > 0.0) != (load->multiple > 0))
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->at, "%s%s needs one of Omega (rad/s) and multiple, of "
	                           "the frequency of a response, not both", what, section);
}

/* One load of a node or cable: a vector, or a mapping. */
static enum hawser_status load_of(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree, int node, int cable,
                                  const char *what)
{
	struct hawser_net_load *load;
	enum hawser_status status = hawser__net_more(&net->load, net->loads, reader->report);

	if (status)
		return status;
	load = &net->load[net->loads];
	memset(load, 0, sizeof *load);
	load->node = node;
	load->cable = cable;
	load->harmonic = hawser__tree_find(tree, "harmonic") != NULL;
	if (tree->kind == HAWSER__MAPPING || cable >= 0)
		status = hawser__tree_fill(reader, load, tree, what, cable < 0 ? "net.loads.*"
		                                                               : "net.loads.**");
	else
		status = hawser__tree_vector(reader, load->value, 3, tree, what, "N");
	if (!status)
		status = frequency(reader, load, hawser__tree_find(tree, "harmonic"), what, ".harmonic");
	net->loads += !status;
	return status;
}

enum hawser_status hawser__net_loads(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "loads must be a mapping of the names of nodes "
		                           "and cables to their loads");
	for (const struct hawser__tree *entry = tree->child; entry && !status; entry = entry->next) {
		int node = hawser__net_node_of(net, entry->name), cable = hawser__net_cable_of(net,
		                                                                               entry->name);
		int several = entry->kind == HAWSER__SEQUENCE && entry->child &&
		              entry->child->kind == HAWSER__MAPPING;
		char what[CALLED], shown[HAWSER__SHOWN];

		snprintf(what, sizeof what, "loads.%s", hawser__shown(shown, entry->name));
		if (node < 0 && cable < 0)
			return hawser__reader_fail(reader, &entry->at, "%s: there is no node or cable of this "
			                           "name", what);
		if (!several)
			status = load_of(reader, net, entry, node, cable, what);
		for (const struct hawser__tree *one = several ? entry->child : NULL; one && !status;
		     one = one->next)
			status = load_of(reader, net, one, node, cable, what);
	}
	return status;
}

/* The directions of a list such as [y, z]. */
static enum hawser_status directions(struct hawser__reader *reader, unsigned char held[3],
                                     const struct hawser__tree *tree, const char *what)
{
	int good = tree->kind == HAWSER__SEQUENCE && tree->children > 0;

	memset(held, 0, 3);
	for (const struct hawser__tree *one = good ? tree->child : NULL; one; one = one->next) {
		const char *text = one->text ? one->text : "", *at = strchr("xyz", *text);

		if (strlen(text) != 1 || !at)
			good = 0;
		else
			held[at - "xyz"] = 1;
	}
	return good ? HAWSER_OK
	            : hawser__reader_fail(reader, &tree->at, "%s must be a list of the directions that are "
	                                  "held, such as [x, y, z]", what);
}

static enum hawser_status motion_of(struct hawser__reader *reader, struct hawser_net *net, int node,
                                    const struct hawser__tree *tree, const char *what)
{
	enum hawser_status status = hawser__tree_keys(reader, tree, "motion", "net.supports.*.motion");

	for (const struct hawser__tree *one = status ? NULL : tree->child; one &&
	     !status; one = one->next) {
		char axis[CALLED], path[] = "net.supports.*.motion.x";
		int k = *one->name - 'x';
		struct hawser_net_load *motion;

		status = hawser__net_more(&net->motion, net->motions, reader->report);
		if (status)
			return status;
		motion = &net->motion[net->motions];
		memset(motion, 0, sizeof *motion);
		motion->node = node;
		motion->cable = -1;
		net->node[node].held[k] = 1; /* by what moves it */
		motion->harmonic = 1;
		path[sizeof path - 2] = *one->name;
		snprintf(axis, sizeof axis, "%.200s.motion.%c", what, *one->name);
		status = hawser__tree_fill(reader, motion, one, axis, path);
		if (!status)
			status = frequency(reader, motion, one, axis, "");
		net->motions += !status;
	}
	return status;
}

static enum hawser_status support(struct hawser__reader *reader, struct hawser_net *net, int node,
                                  const struct hawser__tree *entry, const char *what)
{
	struct hawser_net_node *to = &net->node[node];
	const struct hawser__tree *fixed, *motion, *table;
	enum hawser_status status;

	to->support = 1;
	memset(to->held, 1, 3);
	if (entry->kind == HAWSER__SCALAR && entry->text && !strcmp(entry->text, "fixed"))
		return HAWSER_OK;
	if (entry->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &entry->at, "%s must be the word fixed, or a mapping such "
		                           "as {fixed: [y, z]}", what);
	status = hawser__tree_fill(reader, to, entry, what, "net.supports.*");
	if (status)
		return status;
	fixed = hawser__tree_find(entry, "fixed");
	motion = hawser__tree_find(entry, "motion");
	table = hawser__tree_find(entry, "table");
	if (fixed)
		status = directions(reader, to->held, fixed, what);
	if (!status && motion && table)
		status = hawser__reader_fail(reader, &table->at, "%s has motion and table: give one of them",
		                             what);
	if (!status && motion)
		status = motion_of(reader, net, node, motion, what);
	return status;
}

enum hawser_status hawser__net_supports(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "supports must be a mapping of nodes, such as "
		                           "{A: fixed}");
	for (const struct hawser__tree *entry = tree->child; entry && !status; entry = entry->next) {
		char what[CALLED], shown[HAWSER__SHOWN];
		int node;

		snprintf(what, sizeof what, "supports.%s", hawser__shown(shown, entry->name));
		status = hawser__net_find_node(reader, &node, net, entry, entry->name, what);
		if (!status && !net->node[node].placed)
			status = hawser__reader_fail(reader, &entry->at, "%s: this node has no position: give "
			                             "nodes.%s: [x, y, z]", what, net->node[node].name);
		if (!status)
			status = support(reader, net, node, entry, what);
	}
	return status;
}

/* net/read/absorbed.c - absorbers and pendulums at nodes of a net's scene.
 *
 * A pendulum is a mass on a cable of one element without mass, so that its large motions, its tension
 * and the weight on its node are those of any mesh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };
static const double stiff = 1e6; /* EA of a hanger over the weight on it: 1e-6 longer */

static enum hawser_status check(struct hawser__reader *reader,
                                const struct hawser__net_absorber_given *given,
                                const struct hawser__tree *tree, const char *what)
{
	if (!(given->of.mass > 0.0))
		return hawser__reader_fail(reader, &tree->at, "%s.mass is missing: give the mass that moves",
		                           what);
	if ((given->of.stiffness > 0.0) == (given->omega > 0.0))
		return hawser__reader_fail(reader, &tree->at, "%s needs stiffness or frequency, and not both: "
		                           "without a spring it does not stay at its joint", what);
	if (!(hawser__norm(given->of.direction) > 0.0))
		return hawser__reader_fail(reader, &tree->at, "%s.direction has no length: give one, such as "
		                           "[0, 1, 0]", what);
	return HAWSER_OK;
}

static enum hawser_status absorber(struct hawser__reader *reader, struct hawser_net *net,
                                   const struct hawser__tree *tree)
{
	struct hawser__net_absorber_given given = {.of.direction = {0.0, 1.0, 0.0}};
	struct hawser_net_absorber *to = &net->absorber[net->absorbers];
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	const struct hawser__tree *at = hawser__tree_find(tree, "at");
	const char *text = "";
	char what[CALLED];
	double length;
	enum hawser_status status;

	snprintf(what, sizeof what, "absorbers[%d]", net->absorbers);
	snprintf(given.of.name, sizeof given.of.name, "absorber_%d", net->absorbers);
	status = hawser__tree_fill(reader, &given, tree, what, "net.absorbers[]");
	if (!status && name)
		status = hawser__tree_text(reader, &text, name, "name");
	if (!status && name)
		status = hawser__tree_name(reader, given.of.name, name, text, "name");
	if (!status && !at)
		status = hawser__reader_fail(reader, &tree->at, "%s.at is missing: give the name of a node",
		                             what);
	if (!status)
		status = hawser__tree_text(reader, &text, at, "at");
	if (!status)
		status = hawser__net_find_node(reader, &given.of.node, net, at, text, what);
	if (!status)
		status = check(reader, &given, tree, what);
	if (status)
		return status;
	*to = given.of;
	to->stiffness += to->mass*given.omega*given.omega;
	length = hawser__norm(to->direction);
	for (int k = 0; k < 3; k++)
		to->direction[k] /= length;
	net->node[to->node].mass += to->mass;
	net->absorbers++;
	return HAWSER_OK;
}

enum hawser_status hawser__net_absorbers(struct hawser__reader *reader, struct hawser_net *net,
                                         const struct hawser__tree *tree)
{
	enum hawser_status status;

	net->absorber = hawser__tree_items(reader, &status, tree, "absorbers", sizeof *net->absorber, 1, 0,
	                                   "{at: J, mass: 20 kg, frequency: 1.2 Hz, damping: 15 N.s/m}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status; one = one->next)
		status = absorber(reader, net, one);
	return status;
}

/* The mass of a node with a hanger becomes a node NAME_load on a cable NAME_hanger. */
static enum hawser_status hang(struct hawser__reader *reader, struct hawser_net *net, int node)
{
	struct hawser_net_node *from = &net->node[node], *to = &net->node[net->nodes];
	struct hawser_net_cable *cable = &net->cable[net->cables];
	char name[HAWSER_NET_NAME];

	*to = (struct hawser_net_node){.placed = from->placed, .mass = from->hung};
	*cable = (struct hawser_net_cable){.from = node, .to = net->nodes, .EA = stiff*from->hung*net->g,
		.value = from->hanger/(1.0 + 1.0/stiff), .elements = 1, .elements_given = 1};
	for (int k = 0; k < 3; k++)
		to->x[k] = from->x[k] - (k == 1 ? from->hanger : 0.0);
	memcpy(name, from->name, sizeof name);
	if (snprintf(to->name, sizeof to->name, "%s_load", name) >= (int)sizeof to->name ||
	    snprintf(cable->name, sizeof cable->name, "%s_hanger", name) >= (int)sizeof cable->name ||
	    hawser__net_node_of(net, to->name) >= 0 || hawser__net_cable_of(net, cable->name) >= 0)
		return hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "masses.%s: its hanger "
		                           "makes the node %s and the cable %s, whose names are taken or too "
		                           "long: give the node another name", name, to->name, cable->name);
	net->nodes++;
	net->cables++;
	return HAWSER_OK;
}

enum hawser_status hawser__net_hangers(struct hawser__reader *reader, struct hawser_net *net)
{
	int nodes = net->nodes, count = 0;
	struct hawser_net_node *node;
	struct hawser_net_cable *cable;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < nodes; i++) {
		net->node[i].mass += net->node[i].hanger > 0.0 ? 0.0 : net->node[i].hung;
		count += net->node[i].hanger > 0.0;
	}
	if (count == 0)
		return HAWSER_OK;
	if (!(net->g > 0.0))
		return hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "masses: g is 0, and a "
		                           "mass on a hanger is a pendulum by its weight: leave the hanger "
		                           "out");
	if ((node = realloc(net->node, (size_t)(nodes + count)*sizeof *node)))
		net->node = node;
	if ((cable = realloc(net->cable, (size_t)(net->cables + count)*sizeof *cable)))
		net->cable = cable;
	if (!node || !cable)
		return hawser__no_memory(reader->report, "scene");
	for (int i = 0; i < nodes && !status; i++)
		if (net->node[i].hanger > 0.0)
			status = hang(reader, net, i);
	return status ? status : hawser__net_index(reader, net);
}

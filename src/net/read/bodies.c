/* net/read/bodies.c - `bodies` of a net's scene: nodes that move together.
 *
 * A rod is a cable between two nodes of the body, whose elements stay as they are, so that its weight,
 * inertia and loads of the water are those of any mesh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64, ELEMENTS = 20 };
/* EA of a rod, N: its strain is 0, and any number serves. */
static const double ANY_EA = 1.0;

/* What a node of a body cannot have. */
static const char *contradicts(const struct hawser_net *net, int node)
{
	const struct hawser_net_node *of = &net->node[node];

	for (int i = 0; i < net->absorbers; i++)
		if (net->absorber[i].node == node)
			return "an absorber";
	for (int i = 0; i < net->motions; i++)
		if (net->motion[i].node == node)
			return "the motion of a support";
	for (int k = 0; k < 3; k++) {
		if (of->spring[k] > 0.0 || of->damper[k] > 0.0)
			return "a spring or a damper to the ground: give it a cable to a support";
		if (of->support && !of->held[k])
			return "a support that holds some directions alone: a hinge holds all";
	}
	return of->table ? "the motion of a support" : of->hanger > 0.0 ? "a hanger" : NULL;
}

static enum hawser_status members(struct hawser__reader *reader, struct hawser_net *net,
                                  struct hawser_net_body *body, const struct hawser__tree *tree,
                                  const char *what)
{
	const struct hawser__tree *list = hawser__tree_find(tree, "nodes");
	enum hawser_status status = HAWSER_OK;

	if (!list || list->kind != HAWSER__SEQUENCE || !list->child)
		return hawser__reader_fail(reader, &tree->at, "%s.nodes must be a list of nodes, such as "
		                           "[f1, f2, f3]", what);
	body->node = calloc((size_t)list->children, sizeof *body->node);
	if (!body->node)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = list->child; one && !status; one = one->next) {
		const char *text = "", *why = NULL;
		int node = 0;

		status = hawser__tree_text(reader, &text, one, "nodes");
		if (!status)
			status = hawser__net_find_node(reader, &node, net, one, text, what);
		if (!status && !net->node[node].placed)
			status = hawser__reader_fail(reader, &one->at, "%s: node %s has no place, from which the "
			                             "shape of the body follows: give nodes.%s: [x, y, z]", what,
			                             text, text);
		if (!status && net->node[node].body)
			status = hawser__reader_fail(reader, &one->at, "%s: node %s is in a body already", what,
			                             text);
		if (!status && (why = contradicts(net, node)))
			status = hawser__reader_fail(reader, &one->at, "%s: node %s is of a rigid body, and has "
			                             "%s", what, text, why);
		if (status)
			return status;
		net->node[node].body = net->bodies + 1;
		memset(net->node[node].held, 1, sizeof net->node[node].held);
		body->node[body->nodes++] = node;
	}
	return status;
}

static enum hawser_status end_of_rod(struct hawser__reader *reader, int *node,
                                     const struct hawser_net *net, const struct hawser__tree *tree,
                                     const char *key, const char *what)
{
	const struct hawser__tree *end = hawser__tree_find(tree, key);
	const char *text;
	enum hawser_status status;

	if (!end)
		return hawser__reader_fail(reader, &tree->at, "%s.%s is missing: give a node of the body",
		                           what, key);
	status = hawser__tree_text(reader, &text, end, what);
	if (!status)
		status = hawser__net_find_node(reader, node, net, end, text, what);
	if (!status && net->node[*node].body != net->bodies + 1)
		status = hawser__reader_fail(reader, &end->at, "%s.%s: node %s is not of this body: add it to "
		                             "its nodes", what, key, text);
	return status;
}

static enum hawser_status rod(struct hawser__reader *reader, struct hawser_net *net,
                              const struct hawser__tree *tree, const char *body, int number)
{
	struct hawser_net_cable *to = &net->cable[net->cables];
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	char what[CALLED + 40];
	const char *text = "";
	double square = 0.0;
	enum hawser_status status;

	*to = (struct hawser_net_cable){.EA = ANY_EA, .elements = ELEMENTS, .elements_given = 1,
	                                .rod = net->bodies + 1};
	snprintf(what, sizeof what, "%s.rods[%d]", body, number);
	snprintf(to->name, sizeof to->name, "%.16s_rod%d", net->body[net->bodies].name, number % 100000);
	status = hawser__tree_fill(reader, to, tree, what, "net.bodies.*.rods[]");
	if (!status && name)
		status = hawser__tree_text(reader, &text, name, "name");
	if (!status && name)
		status = hawser__tree_name(reader, to->name, name, text, "name");
	if (!status)
		status = end_of_rod(reader, &to->from, net, tree, "from", what);
	if (!status)
		status = end_of_rod(reader, &to->to, net, tree, "to", what);
	if (!status)
		status = hawser__net_wet(reader, &net->water, tree, what);
	for (int k = 0; k < 3 && !status; k++)
		square += pow(net->node[to->to].x[k] - net->node[to->from].x[k], 2.0);
	to->value = sqrt(square);
	if (!status && !(to->value > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s has no length: give two nodes at different "
		                             "places", what);
	if (!status && (hawser__net_node_of(net, to->name) >= 0 ||
	                hawser__net_cable_of(net, to->name) >= 0))
		status = hawser__reader_fail(reader, &tree->at, "%s: there is a node or a cable %s already: "
		                             "give it another name", what, to->name);
	net->cables += !status;
	return status ? status : hawser__net_index(reader, net);
}

static enum hawser_status rods(struct hawser__reader *reader, struct hawser_net *net,
                               const struct hawser__tree *tree, const char *what)
{
	struct hawser_net_cable *cable;
	enum hawser_status status = HAWSER_OK;
	int number = 0;

	if (!tree)
		return HAWSER_OK;
	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at, "%s.rods must be a list, such as [{from: A, to: "
		                           "B, rho: 200 kg/m, diameter: 0.8 m}]", what);
	cable = realloc(net->cable, (size_t)(net->cables + tree->children + 1)*sizeof *cable);
	if (!cable)
		return hawser__no_memory(reader->report, "scene");
	net->cable = cable;
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next)
		status = rod(reader, net, one, what, number++);
	return status;
}

static enum hawser_status body_of(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	struct hawser_net_body *to = &net->body[net->bodies];
	char what[CALLED], shown[HAWSER__SHOWN];
	double most, sum;
	enum hawser_status status;

	snprintf(what, sizeof what, "bodies.%s", hawser__shown(shown, tree->name));
	status = hawser__tree_name(reader, to->name, tree, tree->name, "bodies");
	if (!status && hawser__net_node_of(net, to->name) >= 0)
		status = hawser__reader_fail(reader, &tree->at, "%s is the name of a node: give the body "
		                             "another one", what);
	if (!status)
		status = hawser__tree_fill(reader, to, tree, what, "net.bodies.*");
	for (int k = 0; k < 3; k++)
		to->axes[k][k] = 1.0;
	if (!status)
		status = members(reader, net, to, tree, what);
	if (!status && (to->mass > 0.0) != (hawser__tree_find(tree, "centre") != NULL))
		status = hawser__reader_fail(reader, &tree->at, "%s needs mass and centre together: the place "
		                             "[x, y, z] of the centre of its mass", what);
	most = fmax(to->inertia[0], fmax(to->inertia[1], to->inertia[2]));
	sum = to->inertia[0] + to->inertia[1] + to->inertia[2];
	if (!status && most > 0.0 && (!(to->mass > 0.0) || most > 0.5*sum*(1.0 + 1e-12)))
		status = hawser__reader_fail(reader, &tree->at, "%s.inertia must be three moments of inertia "
		                             "of a mass, none larger than the sum of the others", what);
	if (!status)
		status = rods(reader, net, hawser__tree_find(tree, "rods"), what);
	net->bodies++; /* with its list of nodes, to be released */
	return status;
}

enum hawser_status hawser__net_bodies(struct hawser__reader *reader, struct hawser_net *net,
                                      const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "bodies must be a mapping of names, such as "
		                           "{platform: {nodes: [f1, f2], mass: 40 t, centre: [0, -9 m, 0]}}");
	if (net->contact.history)
		return hawser__reader_fail(reader, &tree->at, "bodies contradict contact.sliding: the way of a "
		                           "body is not known: leave one of them out");
	net->body = calloc((size_t)tree->children, sizeof *net->body);
	if (!net->body)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next)
		status = body_of(reader, net, one);
	return status;
}

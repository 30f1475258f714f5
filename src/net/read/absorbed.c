/* net/read/absorbed.c - absorbers at nodes of a net's scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };

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

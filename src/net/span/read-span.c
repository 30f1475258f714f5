/* net/span/read-span.c - the scene of a span whose obstacles are not all circles: a net of one
 * cable between the supports A and B. Spans over circles alone have exact catenaries and arcs
 * (hawser/obstacles.h). SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"

enum { ELEMENTS = 200, MOST = 1000000 };
#define KEYS "kind, cable, span, tension, g, obstacles, contact, damping, dynamics"

static enum hawser_status number(struct hawser__reader *reader, double *value,
                                 const struct hawser__tree *section, const char *key, const char *unit,
                                 enum hawser__tree_range range)
{
	const struct hawser__tree *one = hawser__tree_find(section, key);
	char what[64];

	snprintf(what, sizeof what, "%.30s.%.30s", section->name, key);
	return one ? hawser__tree_number(reader, value, one, what, unit, range)
	           : hawser__reader_fail(reader, &section->at, "%s is missing: give it in %s", what, unit);
}

/* A section that must be there, with these keys only. */
static enum hawser_status section(struct hawser__reader *reader, const struct hawser__tree **found,
                                  const struct hawser__tree *root, const char *name, const char *keys)
{
	*found = hawser__tree_find(root, name);
	if (!*found)
		return hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "%s is missing: the "
		                           "scene of a span needs cable, span and tension (see "
		                           "hawser-scene(5))", name);
	return hawser__tree_keys(reader, *found, name, keys);
}

static enum hawser_status elements(struct hawser__reader *reader, struct hawser_net_cable *cable,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "elements");
	double n = ELEMENTS;
	enum hawser_status status = one ? hawser__tree_number(reader, &n, one, "cable.elements", "1",
	                                                      HAWSER__TREE_POSITIVE) : HAWSER_OK;

	if (!status && (n != floor(n) || n > MOST))
		return hawser__reader_fail(reader, &one->at, "cable.elements: %.9g is not a whole number from "
		                           "1 to %d", n, MOST);
	cable->elements = status ? 1 : (int)n;
	cable->elements_given = one != NULL;
	return status;
}

static enum hawser_status length_of(struct hawser__reader *reader, struct hawser_net_cable *cable,
                                    const struct hawser__tree *root)
{
	const struct hawser__tree *tension;
	enum hawser_status status = section(reader, &tension, root, "tension", "length0, T0, T1");

	for (int end = 0; end < 2 && !status; end++) {
		const struct hawser__tree *one = hawser__tree_find(tension, end ? "T1" : "T0");

		if (one)
			return hawser__reader_fail(reader, &one->at, "tension.T%d: with planes and segments the "
			                           "unstretched length must be known: give tension.length0, in m",
			                           end);
	}
	return status ? status : number(reader, &cable->value, tension, "length0", "m",
	                                HAWSER__TREE_POSITIVE);
}

enum hawser_status hawser__net_of_span(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *root)
{
	const struct hawser__tree *kind = hawser__tree_find(root, "kind"), *cable, *span;
	struct hawser_net_cable *to;
	struct hawser_net_node *node;
	enum hawser_status status = hawser__tree_keys(reader, root, "a span with planes or segments", KEYS);

	if (!status && kind && (!kind->text || strcmp(kind->text, "span") != 0))
		return hawser__reader_fail(reader, &kind->at, "kind must be span in a scene with span");
	if (!status)
		status = section(reader, &cable, root, "cable", "EA, rho, elements");
	if (!status)
		status = section(reader, &span, root, "span", "d, h");
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
	status = number(reader, &node[1].x[0], span, "d", "m", HAWSER__TREE_POSITIVE);
	if (!status && hawser__tree_find(span, "h"))
		status = number(reader, &node[1].x[1], span, "h", "m", HAWSER__TREE_ANY);
	if (!status)
		status = number(reader, &to->EA, cable, "EA", "N", HAWSER__TREE_POSITIVE);
	if (!status)
		status = number(reader, &to->rho, cable, "rho", "kg/m", HAWSER__TREE_NOT_NEGATIVE);
	if (!status)
		status = elements(reader, to, cable);
	if (!status)
		status = length_of(reader, to, root);
	return status ? status : hawser__net_index(reader, net);
}

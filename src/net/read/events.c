/* net/read/events.c - what happens to cables of a net in time: they part, and winches take them in.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };

/* The cable that a text names. */
static enum hawser_status cable_of(struct hawser__reader *reader, int *cable,
                                   const struct hawser_net *net, const struct hawser__tree *at,
                                   const char *name, const char *what)
{
	*cable = name ? hawser__net_cable_of(net, name) : -1;
	if (*cable < 0)
		return hawser__reader_fail(reader, &at->at, "%s: there is no cable %s", what,
		                           name ? name : "without a name");
	if ((net->cable[*cable].rows || net->cable[*cable].dynamic > 0.0) &&
	    (!strncmp(what, "winches", 7) || net->cable[*cable].rho == 0.0))
		return hawser__reader_fail(reader, &at->at, "%s: cable %s has EA by a table or with dynamic, "
		                           "which winches, and failures of cables without mass, do not know: "
		                           "give a number", what, net->cable[*cable].name);
	return net->cable[*cable].given == HAWSER_NET_LENGTH0 ? HAWSER_OK
		: hawser__reader_fail(reader, &at->at, "%s: cable %s has no length0: give it", what,
		                      net->cable[*cable].name);
}

/* 0 or 1: the end of a cable whose node has this name; -1: neither. */
static int end_of(const struct hawser_net *net, int cable, const struct hawser__tree *tree)
{
	int node = tree && tree->text ? hawser__net_node_of(net, tree->text) : -1;

	return node < 0 ? -1 : node == net->cable[cable].from ? 0 : node == net->cable[cable].to ? 1 : -1;
}

/* Where it parts: at an end, or at a part of its unstretched length. */
static enum hawser_status place_of(struct hawser__reader *reader, struct hawser_net_failure *to,
                                   const struct hawser_net *net, const struct hawser__tree *at,
                                   const char *what)
{
	int end = end_of(net, to->cable, at);
	char called[CALLED];

	if (end >= 0) {
		to->part = end;
		return HAWSER_OK;
	}
	if (at->text && hawser__net_node_of(net, at->text) >= 0)
		return hawser__reader_fail(reader, &at->at, "%s.at: cable %s does not end at node %s", what,
		                           net->cable[to->cable].name, at->text);
	snprintf(called, sizeof called, "%.64s.at", what);
	if (hawser__tree_number(reader, &to->part, at, called, "1", HAWSER__TREE_NOT_NEGATIVE))
		return HAWSER_ERR_SCENE;
	return to->part <= 1.0 ? HAWSER_OK
		: hawser__reader_fail(reader, &at->at, "%s is %.6g: give the node of an end, or a part of "
		                      "the unstretched length from the end `from`, such as 40 %%", called,
		                      to->part);
}

static enum hawser_status failure(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree, const char *what)
{
	struct hawser_net_failure *to = &net->failure[net->failures];
	const struct hawser__tree *cable = hawser__tree_find(tree, "cable");
	const struct hawser__tree *at = hawser__tree_find(tree, "at");
	enum hawser_status status;

	*to = (struct hawser_net_failure){.time = -1.0};
	status = hawser__tree_fill(reader, to, tree, what, "net.failures[]");
	if (!status && (!cable || !at))
		status = hawser__reader_fail(reader, &tree->at, "%s needs cable, at (where it parts, a node "
		                             "or a part of its length), and time or tension", what);
	if (!status && (to->time >= 0.0) == (to->tension > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s needs time or tension, and not both", what);
	if (!status)
		status = cable_of(reader, &to->cable, net, cable, cable->text, what);
	return status ? status : place_of(reader, to, net, at, what);
}

enum hawser_status hawser__net_failures(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree)
{
	enum hawser_status status;

	net->failure = hawser__tree_items(reader, &status, tree, "failures", sizeof *net->failure, 1, 0,
	                                  "{cable: c, at: B, time: 5 s}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next) {
		char what[CALLED];

		snprintf(what, sizeof what, "failures[%d]", net->failures);
		status = failure(reader, net, one, what);
		net->failures += !status;
	}
	return status;
}

static enum hawser_status winch(struct hawser__reader *reader, struct hawser_net *net,
                                const struct hawser__tree *tree)
{
	struct hawser_net_winch *to = &net->winch[net->winches];
	const struct hawser__tree *end = hawser__tree_find(tree, "end");
	char what[CALLED], shown[HAWSER__SHOWN];
	enum hawser_status status;

	snprintf(what, sizeof what, "winches.%s", hawser__shown(shown, tree->name));
	status = cable_of(reader, &to->cable, net, tree, tree->name, what);
	if (!status)
		status = hawser__tree_fill(reader, to, tree, what, "net.winches.*");
	if (!status && (to->speed != 0.0) == (to->tension > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s needs speed or tension, and not both",
		                             what);
	if (!status && (to->tension > 0.0) != (to->limit > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s needs tension and limit together: the "
		                             "limit is the largest speed, such as 0.5 m/s", what);
	if (!status && (to->end = end_of(net, to->cable, end)) < 0)
		status = hawser__reader_fail(reader, &tree->at, "%s.end must be the node at an end of the "
		                             "cable, where the winch is", what);
	return status;
}

enum hawser_status hawser__net_winches(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "winches must be a mapping of cables, such as "
		                           "{c: {end: B, speed: -1 m/s, rise: 2 s}}");
	net->winch = calloc((size_t)tree->children, sizeof *net->winch);
	if (!net->winch)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		status = winch(reader, net, one);
		net->winches += !status;
	}
	return status;
}

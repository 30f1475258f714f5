/* net/read/read.c - read a scene of kind `net`: nodes, cables, masses, damping, dynamics, and
 * the rules that involve several of them. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "core/append.h"
#include "core/report.h"
#include "net/read/read.h"
#include "scene/tree_keys.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64 };

static enum hawser_status nodes(struct hawser__reader *reader, struct hawser_net *net,
                                const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "nodes must be a mapping of names to "
		                           "positions, such as {A: [0 m, 0 m, 0 m], J: {}}");
	net->node = calloc((size_t)tree->children, sizeof *net->node);
	if (!net->node)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *entry = tree->child; entry && !status; entry = entry->next) {
		struct hawser_net_node *node = &net->node[net->nodes++];
		char what[CALLED], shown[HAWSER__SHOWN];

		snprintf(what, sizeof what, "nodes.%s", hawser__shown(shown, entry->name));
		status = hawser__tree_name(reader, node->name, entry, entry->name, "nodes");
		if (status || (entry->kind == HAWSER__MAPPING && !entry->children))
			continue;
		node->placed = 1;
		if (entry->kind != HAWSER__SEQUENCE)
			status = hawser__reader_fail(reader, &entry->at, "%s must be a list of 3 numbers in m, "
			                             "or {} for a node whose position is to be found", what);
		else
			status = hawser__tree_vector(reader, node->x, 3, entry, what, "m");
	}
	return status;
}

static enum hawser_status end_of(struct hawser__reader *reader, int *node, const struct hawser_net *net,
                                 const struct hawser__tree *tree, const char *key, const char *name)
{
	const struct hawser__tree *end = hawser__tree_find(tree, key);
	char what[CALLED];
	const char *text;
	enum hawser_status status;

	snprintf(what, sizeof what, "cables.%s.%s", name, key);
	if (!end)
		return hawser__reader_fail(reader, &tree->at, "%s is missing: give the name of a node", what);
	status = hawser__tree_text(reader, &text, end, what);
	return status ? status : hawser__net_find_node(reader, node, net, end, text, what);
}

/* Rows [strain, tension] of EA: {table: ...}. */
static enum hawser_status law_of(struct hawser__reader *reader, struct hawser_net_cable *cable,
                                 const struct hawser__tree *tree)
{
	const struct hawser__tree *rows = hawser__tree_find(tree, "table");
	double slope, strain = 0.0, tension = 0.0;
	enum hawser_status status = HAWSER_OK;

	if (!rows || rows->kind != HAWSER__SEQUENCE || !rows->child || rows->children > HAWSER_NET_LAW)
		return hawser__reader_fail(reader, &tree->at, "EA of cable %s must be a number or {table: "
		                           "[[0.01, 1 MN], [0.02, 3 MN]]}, 1 to %d strains with tensions",
		                           cable->name, HAWSER_NET_LAW);
	for (const struct hawser__tree *one = rows->child; one && !status; one = one->next) {
		double *row = cable->law[cable->rows++];

		if (one->kind != HAWSER__SEQUENCE || one->children != 2)
			return hawser__reader_fail(reader, &one->at, "EA.table of cable %s: a row must be [strain, "
			                           "tension], such as [1 %%, 1 MN]", cable->name);
		status = hawser__tree_number(reader, &row[0], one->child, "EA.table", "1", HAWSER__TREE_ANY);
		if (!status)
			status = hawser__tree_number(reader, &row[1], one->child->next, "EA.table", "N",
			                             HAWSER__TREE_ANY);
		slope = (row[1] - tension)/(row[0] - strain);
		if (!status && (row[0] <= strain || row[1] <= tension || !isfinite(slope) ||
		                row[0] - row[1]/slope <= -1.0))
			status = hawser__reader_fail(reader, &one->at, "EA.table of cable %s: strain %g and "
			                             "tension %g N do not follow %g and %g N: both must rise "
			                             "from row to row, from (0, 0) on, with a slope above the "
			                             "tension over 1 + strain", cable->name, row[0], row[1],
			                             strain, tension);
		strain = row[0];
		tension = row[1];
	}
	cable->EA = status ? 0.0 : cable->law[0][1]/cable->law[0][0];
	if (!status && (cable->given != HAWSER_NET_LENGTH0 || cable->damper > 0.0))
		return hawser__reader_fail(reader, &tree->at, "cable %s has a table of EA, which needs length0 "
		                           "and no damper: give its length0", cable->name);
	return status;
}

/* EA: {static: ..., dynamic: ..., viscosity: ...}. */
static enum hawser_status creeping(struct hawser__reader *reader, struct hawser_net_cable *cable,
                                   const struct hawser__tree *tree)
{
	static const char *const key[] = {"static", "dynamic", "viscosity"};
	double *const to[] = {&cable->EA, &cable->dynamic, &cable->viscosity};
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < 3 && !status; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, key[i]);

		status = !one ? HAWSER_ERR_SCENE
			: hawser__tree_number(reader, to[i], one, "EA", i < 2 ? "N" : "N.s", HAWSER__TREE_POSITIVE);
		if (!one || (!status && i == 1 && !(cable->dynamic > cable->EA)))
			return hawser__reader_fail(reader, &tree->at, "EA of cable %s needs static, dynamic above "
			                           "it, and viscosity, such as {static: 20 MN, dynamic: 50 MN, "
			                           "viscosity: 0.2 GN s}", cable->name);
	}
	if (!status && (cable->axial > 0.0 || cable->damper > 0.0))
		return hawser__reader_fail(reader, &tree->at, "cable %s has EA with viscosity, which is its "
		                           "damping: leave axial and damper out", cable->name);
	return status;
}

static enum hawser_status cable_of(struct hawser__reader *reader, struct hawser_net *net,
                                   const struct hawser__tree *tree)
{
	struct hawser_net_cable *cable = &net->cable[net->cables];
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	const struct hawser__tree *EA = hawser__tree_find(tree, "EA");
	const char *text = "";
	char what[CALLED];
	enum hawser_status status = HAWSER_OK;

	snprintf(cable->name, sizeof cable->name, "c%d", net->cables);
	if (name)
		status = hawser__tree_text(reader, &text, name, "name");
	if (!status && name)
		status = hawser__tree_name(reader, cable->name, name, text, "name");
	snprintf(what, sizeof what, "cables.%s", cable->name);
	if (!status)
		status = hawser__tree_fill(reader, cable, tree, what, "net.cables[]");
	cable->elements_given = hawser__tree_find(tree, "elements") != NULL;
	if (!status && EA && EA->kind == HAWSER__MAPPING)
		status = hawser__tree_find(EA, "table") || !hawser__tree_find(EA, "static")
			? law_of(reader, cable, EA) : creeping(reader, cable, EA);
	if (!status && cable->damper > 0.0 && cable->given != HAWSER_NET_LENGTH0)
		status = hawser__reader_fail(reader, &tree->at, "cable %s has a damper and no length0, on "
		                             "which its axial damping depends: give length0, or axial",
		                             cable->name);
	cable->axial += status ? 0.0 : cable->damper*cable->value/cable->EA;
	if (!status)
		status = end_of(reader, &cable->from, net, tree, "from", cable->name);
	if (!status)
		status = end_of(reader, &cable->to, net, tree, "to", cable->name);
	if (!status && cable->from == cable->to)
		status = hawser__reader_fail(reader, &tree->at, "cable %s begins and ends at node %s: give two "
		                             "nodes", cable->name, net->node[cable->to].name);
	return status;
}

/* A cable between two supports must not be shorter than two thirds of its chord. */
static enum hawser_status plausible(struct hawser__reader *reader, const struct hawser_net *net,
                                    const struct hawser__tree *tree, int number)
{
	const struct hawser_net_cable *cable = &net->cable[number];
	const struct hawser_net_node *a = &net->node[cable->from], *b = &net->node[cable->to];
	double chord = sqrt((a->x[0] - b->x[0])*(a->x[0] - b->x[0]) +
	                    (a->x[1] - b->x[1])*(a->x[1] - b->x[1]) +
	                    (a->x[2] - b->x[2])*(a->x[2] - b->x[2]));

	for (int k = 0; k < 3; k++)
		if (!a->held[k] || !b->held[k])
			return HAWSER_OK;
	if (chord == 0.0)
		return hawser__reader_fail(reader, &tree->at, "cable %s: its nodes %s and %s are in one "
		                           "place: correct their coordinates, or leave the cable out",
		                           cable->name, a->name, b->name);
	if (cable->given != HAWSER_NET_LENGTH0 || 1.5*cable->value > chord)
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->at, "cable %s: its unstretched length %.6g m is far "
	                           "below the distance %.6g m of its supports %s and %s, a strain of "
	                           "%.0f %%: correct length0 and its unit, or the places of these nodes",
	                           cable->name, cable->value, chord, a->name, b->name,
	                           100.0*(chord/cable->value - 1.0));
}

static enum hawser_status cables(struct hawser__reader *reader, struct hawser_net *net,
                                 const struct hawser__tree *tree)
{
	enum hawser_status status;

	net->cable = hawser__tree_items(reader, &status, tree, "cables", sizeof *net->cable, 1, 0,
	                                "{name: c1, from: A, to: B, EA: 100 MN, rho: 5 kg/m, length0: "
	                                "101 m}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next) {
		status = cable_of(reader, net, one);
		net->cables += !status;
	}
	return status;
}

enum hawser_status hawser__net_of_nodes(struct hawser__reader *reader, struct hawser_net *net,
                                        const struct hawser__tree *tree, const char *path,
                                        const char *example)
{
	const char *section = path + strlen("net.");
	char key[32];
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "%s must be a mapping of nodes, such as %s",
		                           section, example);
	snprintf(key, sizeof key, "%s.*", path);
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		int node;

		status = hawser__net_find_node(reader, &node, net, one, one->name, section);
		if (!status)
			status = hawser__tree_value(reader, &net->node[node], one, section, key);
	}
	return status;
}

static enum hawser_status masses(struct hawser__reader *reader, struct hawser_net *net,
                                 const struct hawser__tree *tree)
{
	return hawser__net_of_nodes(reader, net, tree, "net.masses", "{J: 12 kg}");
}

static enum hawser_status dampers(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	return hawser__net_of_nodes(reader, net, tree, "net.dampers", "{J: [0, 300 N.s/m, 0]}");
}

static enum hawser_status springs(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	return hawser__net_of_nodes(reader, net, tree, "net.springs", "{J: [0, 3 kN/m, 0]}");
}

static enum hawser_status release(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	struct hawser_net_dynamics *to = &net->dynamics;
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at,
		                           "release must be a list of supports, such as [B]");
	to->release = calloc((size_t)tree->children + 1, sizeof *to->release);
	if (!to->release)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		const char *text;
		int node = 0;

		status = hawser__tree_text(reader, &text, one, "release");
		if (!status)
			status = hawser__net_find_node(reader, &node, net, one, text, "release");
		if (!status && !net->node[node].support)
			status = hawser__reader_fail(reader, &one->at, "release: node %s is no support",
			                             net->node[node].name);
		to->release[to->releases++] = node;
	}
	return status;
}

/* Is it one of the schemes? */
static enum hawser_status known(struct hawser__reader *reader, const struct hawser__tree *tree,
                                const char *scheme)
{
	char names[160] = "";
	int i = 0;

	for (; hawser_net_scheme(i) && strcmp(hawser_net_scheme(i)->name, scheme) != 0; i++)
		hawser__append(names, sizeof names, ", ", "%s", hawser_net_scheme(i)->name);
	return hawser_net_scheme(i) ? HAWSER_OK
	       : hawser__reader_fail(reader, &tree->at, "there is no scheme %.40s: the schemes are %s",
	                             scheme, names);
}

static enum hawser_status dynamics(struct hawser__reader *reader, struct hawser_net *net,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *list = hawser__tree_find(tree, "release");
	const struct hawser__tree *scheme = hawser__tree_find(tree, "scheme");
	const char *text;
	enum hawser_status status = list ? release(reader, net, list) : HAWSER_OK;

	if (net->dynamics.from && !strcmp(net->dynamics.from, "statics")) {
		free(net->dynamics.from);
		net->dynamics.from = NULL;
	}
	if (!status && scheme)
		status = hawser__tree_text(reader, &text, scheme, "scheme");
	if (!status && scheme)
		status = hawser__tree_name(reader, net->dynamics.scheme, scheme, text, "scheme");
	if (!status && scheme)
		status = known(reader, scheme, net->dynamics.scheme);
	return status;
}

/* Rules over all names, cables and supports. */
static enum hawser_status rules(struct hawser__reader *reader, struct hawser_net *net,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *one = tree ? tree->child : NULL;
	char what[CALLED];
	enum hawser_status status = HAWSER_OK;
	int blown = 0;

	for (int i = 0; one && !status; i++, one = one->next) { /* the rods of bodies come after them */
		const char *name = net->cable[i].name;

		if (hawser__net_node_of(net, name) >= 0)
			status = hawser__reader_fail(reader, &one->at, "%s is the name of a node and of a cable: "
			                             "give different ones", name);
		else if (hawser__net_cable_of(net, name) != i)
			status = hawser__reader_fail(reader, &one->at, "two cables have the name %s: give "
			                             "different ones", name);
		if (!status)
			status = plausible(reader, net, one, i);
		snprintf(what, sizeof what, "cable %s", name);
		if (!status)
			status = hawser__net_wet(reader, &net->water, one, what);
		if (!status)
			status = hawser__net_section(reader, net, i, one, what);
		blown |= net->cable[i].wind != NULL;
	}
	if (!status && tree && net->winds && !blown)
		status = hawser__reader_fail(reader, &tree->at, "the wind passes by all cables, since none has "
		                             "a diameter: give wind.diameter, or that of a cable in "
		                             "cables.NAME.wind");
	return status;
}

/* Does a cable end at it, or a body carry it? */
static int is_reached(const struct hawser_net *net, int node)
{
	for (int i = 0; i < net->cables; i++)
		if (net->cable[i].from == node || net->cable[i].to == node)
			return 1;
	for (int b = 0; b < net->bodies; b++)
		for (int i = 0; i < net->body[b].nodes; i++)
			if (net->body[b].node[i] == node)
				return 1;
	return 0;
}

/* Fail for a node that may move and that nothing holds. An obstacle could. */
static enum hawser_status reached(struct hawser__reader *reader, const struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	const struct hawser__tree *one = tree && !net->surfaces ? tree->child : NULL;

	for (int i = 0; one; i++, one = one->next) {
		const struct hawser_net_node *node = &net->node[i];

		if (!(node->held[0] && node->held[1] && node->held[2]) && !is_reached(net, i))
			return hawser__reader_fail(reader, &one->at, "no cable and no body reaches node %s, so "
			                           "that it has no equilibrium: give a cable that ends there, "
			                           "make it a support, or leave it out", node->name);
	}
	return HAWSER_OK;
}

enum { DYNAMICS = 7 }; /* the first section below that spans have too */

/* The sections of nets from number `from` on. */
static enum hawser_status common(struct hawser__reader *reader, struct hawser_net *net,
                                 const struct hawser__tree *root, int from)
{
	static const struct {
		const char *name;
		enum hawser_status (*read)(struct hawser__reader *, struct hawser_net *,
		                           const struct hawser__tree *);
		int required;
	} part[] = {{"nodes", nodes, 1}, {"cables", cables, 1}, {"supports", hawser__net_supports, 1},
	            {"masses", masses, 0}, {"dampers", dampers, 0}, {"springs", springs, 0},
	            {"absorbers", hawser__net_absorbers, 0}, {"loads", hawser__net_loads, 0},
	            {"passing", hawser__net_passing, 0}, {"dynamics", dynamics, 0},
	            {"water", hawser__net_water, 0}, {"buoys", hawser__net_buoys, 0},
	            {"obstacles", hawser__net_obstacles, 0}, {"contact", hawser__net_contact, 0},
	            {"failures", hawser__net_failures, 0}, {"winches", hawser__net_winches, 0},
	            {"wind", hawser__net_wind, 0}, {"bodies", hawser__net_bodies, 0}};
	static const char *const plain[] = {"g", "damping", "dynamics", "contact", "water"};
	enum hawser_status status = HAWSER_OK;

	net->g = 9.81;
	net->dynamics.rho_inf = -1.0;
	net->g_given = hawser__tree_find(root, "g") != NULL;
	net->axial_given = hawser__tree_find(hawser__tree_find(root, "damping"), "axial") != NULL;
	for (size_t i = 0; i < sizeof plain/sizeof *plain && !status; i++) {
		const struct hawser__tree *tree = hawser__tree_find(root, plain[i]);
		char path[32];

		snprintf(path, sizeof path, "net.%s", plain[i]);
		if (tree)
			status = hawser__tree_value(reader, net, tree, plain[i], path);
	}
	for (size_t i = (size_t)from; i < sizeof part/sizeof *part && !status; i++) {
		const struct hawser__tree *tree = hawser__tree_find(root, part[i].name);

		if (tree)
			status = part[i].read(reader, net, tree);
		else if (part[i].required && !(i == 2 && hawser__tree_find(root, "obstacles")) &&
		         !(i > 0 && hawser__tree_find(root, "bodies")))
			status = hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1},
			                             "a net needs %s (see hawser-scene(5))", part[i].name);
		if (!status && i < 2)
			status = hawser__net_index(reader, net);
	}
	if (!status && net->surfaces && (net->absorbers || hawser__tree_find(root, "springs")))
		return hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "obstacles contradict "
		                           "absorbers and springs: give a cable from the joint to a mass, or "
		                           "to a support, in place of them");
	return status ? status : hawser__net_room(reader, net, root);
}

/* A word that is no kind's is read here. */
static enum hawser_status check_kind(struct hawser__reader *reader, const struct hawser__tree *kind)
{
	char near[HAWSER__TEXT_ROOM], shown[HAWSER__SHOWN];

	if (!kind || (kind->text && (!strcmp(kind->text, "net") || !strcmp(kind->text, "span"))))
		return HAWSER_OK;
	hawser__tree_nearest(near, kind->text ? kind->text : "", "span, net, ropeway, rod, tow");
	return hawser__reader_fail(reader, &kind->at, "kind must be span, net, ropeway, rod or tow, not "
	                           "%s%s%s%s", kind->text ? hawser__shown(shown, kind->text) : "a list",
	                           *near ? ": did you mean " : "", near, *near ? "?" : "");
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_net *net = scene;
	enum hawser_status status = check_kind(reader, hawser__tree_find(root, "kind"));

	if (!status && hawser__tree_find(root, "span")) {
		status = hawser__net_of_span(reader, net, root);
		if (!status)
			status = common(reader, net, root, DYNAMICS);
		return status ? status
			: hawser__net_wet(reader, &net->water, hawser__tree_find(root, "cable"), "cable");
	}
	if (!status)
		status = hawser__tree_keys(reader, root, "the scene", "net");
	if (!status)
		status = common(reader, net, root, 0);
	if (!status)
		status = hawser__net_bed(reader, net, hawser__tree_find(root, "nodes"));
	if (!status)
		status = rules(reader, net, hawser__tree_find(root, "cables"));
	if (!status)
		status = reached(reader, net, hawser__tree_find(root, "nodes"));
	return status ? status : hawser__net_hangers(reader, net);
}

HAWSER__TREE_SCENES(net, "net",
	"a scene of kind net is a mapping with at least nodes, cables and supports (see "
	"hawser-scene(5))",
	"cables.c1.EA=100 MN", 'c')

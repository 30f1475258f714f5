/* net/read/read.c - read a scene of kind `net`: nodes, cables, masses, damping, dynamics, and
 * the rules that involve several of them. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "core/report.h"
#include "net/read/read.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64, ELEMENTS = 20 };

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

/* What fixes the length of the cable: exactly one of the keys. */
static enum hawser_status given(struct hawser__reader *reader, struct hawser_net_cable *cable,
                                const struct hawser__tree *tree)
{
	static const struct {
		const char *key, *unit;
	} way[] = {{"length0", "m"}, {"tension", "N"}, {"force_density", "N/m"}, {"sag", "m"}};
	const struct hawser__tree *found = NULL;
	char what[CALLED];

	for (size_t i = 0; i < sizeof way/sizeof *way; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, way[i].key);

		if (one && found)
			return hawser__reader_fail(reader, &one->at, "cable %s has %s and %s: give one of length0, "
			                           "tension, force_density and sag", cable->name,
			                           way[cable->given].key, way[i].key);
		if (one) {
			found = one;
			cable->given = (enum hawser_net_given)i;
		}
	}
	if (!found)
		return hawser__reader_fail(reader, &tree->at, "cable %s has no length: give one of length0, "
		                           "tension, force_density and sag", cable->name);
	snprintf(what, sizeof what, "cables.%s.%s", cable->name, way[cable->given].key);
	return hawser__tree_number(reader, &cable->value, found, what, way[cable->given].unit,
	                          HAWSER__TREE_POSITIVE);
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

static enum hawser_status count_of(struct hawser__reader *reader, int *value,
                                   const struct hawser__tree *tree, const char *what)
{
	double number = ELEMENTS;
	enum hawser_status status =
		tree ? hawser__tree_number(reader, &number, tree, what, "1", HAWSER__TREE_POSITIVE) : HAWSER_OK;

	if (!status && (number != floor(number) || number > 1e9))
		return hawser__reader_fail(reader, &tree->at,
		                           "%s: %.9g is not a whole number from 1 to 10^9", what,
		                           number);
	*value = status ? 1 : (int)number;
	return status;
}

static enum hawser_status cable_of(struct hawser__reader *reader, struct hawser_net *net,
                                   const struct hawser__tree *tree)
{
	struct hawser_net_cable *cable = &net->cable[net->cables];
	const struct hawser__tree *name, *EA, *rho;
	const char *text = "";
	char what[CALLED];
	enum hawser_status status =
		hawser__tree_keys(reader, tree, "a cable", "net.cables[]");

	if (status)
		return status;
	name = hawser__tree_find(tree, "name");
	snprintf(cable->name, sizeof cable->name, "c%d", net->cables);
	if (name)
		status = hawser__tree_text(reader, &text, name, "name");
	if (!status && name)
		status = hawser__tree_name(reader, cable->name, name, text, "name");
	if (!status)
		status = end_of(reader, &cable->from, net, tree, "from", cable->name);
	if (!status)
		status = end_of(reader, &cable->to, net, tree, "to", cable->name);
	if (!status && cable->from == cable->to)
		status = hawser__reader_fail(reader, &tree->at, "cable %s begins and ends at node %s: give two "
		                             "nodes", cable->name, net->node[cable->to].name);
	if (status)
		return status;
	EA = hawser__tree_find(tree, "EA");
	rho = hawser__tree_find(tree, "rho");
	if (!EA || !rho)
		return hawser__reader_fail(reader, &tree->at, "cable %s has no %s", cable->name,
		                           EA ? "rho, in kg/m" : "EA, in N");
	snprintf(what, sizeof what, "cables.%s.EA", cable->name);
	status = hawser__tree_number(reader, &cable->EA, EA, what, "N", HAWSER__TREE_POSITIVE);
	snprintf(what, sizeof what, "cables.%s.rho", cable->name);
	if (!status)
		status = hawser__tree_number(reader, &cable->rho, rho, what, "kg/m", HAWSER__TREE_NOT_NEGATIVE);
	snprintf(what, sizeof what, "cables.%s.elements", cable->name);
	if (!status)
		status = count_of(reader, &cable->elements, hawser__tree_find(tree, "elements"), what);
	cable->elements_given = hawser__tree_find(tree, "elements") != NULL;
	return status ? status : given(reader, cable, tree);
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
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "cables must be a list of mappings, such as "
		                           "[{name: c1, from: A, to: B, EA: 100 MN, rho: 5 kg/m, "
		                           "length0: 101 m}]");
	net->cable = calloc((size_t)tree->children, sizeof *net->cable);
	if (!net->cable)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		status = cable_of(reader, net, one);
		net->cables += !status;
	}
	return status;
}

static enum hawser_status masses(struct hawser__reader *reader, struct hawser_net *net,
                                 const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "masses must be a mapping of nodes, such as "
		                           "{J: 12 kg}");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		int node;

		status = hawser__net_find_node(reader, &node, net, one, one->name, "masses");
		if (!status)
			status = hawser__tree_number(reader, &net->node[node].mass, one, "masses", "kg",
			                            HAWSER__TREE_NOT_NEGATIVE);
	}
	return status;
}

static enum hawser_status optional(struct hawser__reader *reader, double *value,
                                   const struct hawser__tree *tree, const char *key, const char *unit,
                                   enum hawser__tree_range range)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);

	return one ? hawser__tree_number(reader, value, one, key, unit, range) : HAWSER_OK;
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
		snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i ? ", " : "",
		         hawser_net_scheme(i)->name);
	return hawser_net_scheme(i) ? HAWSER_OK
	       : hawser__reader_fail(reader, &tree->at, "there is no scheme %.40s: the schemes are %s",
	                             scheme, names);
}

/* Do the surfaces of obstacles move before the motion begins, or do they start with it? */
static enum hawser_status started(struct hawser__reader *reader, struct hawser_net *net,
                                  const struct hawser__tree *tree)
{
	const char *text;
	enum hawser_status status = hawser__tree_text(reader, &text, tree, "surfaces");

	if (status)
		return status;
	net->dynamics.surfaces_start = strcmp(text, "start") == 0;
	return net->dynamics.surfaces_start || strcmp(text, "moving") == 0 ? HAWSER_OK
	       : hawser__reader_fail(reader, &tree->at, "surfaces of obstacles are moving (before the "
	                             "motion begins, too) or start (with it), not %.40s", text);
}

static enum hawser_status dynamics(struct hawser__reader *reader, struct hawser_net *net,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *from, *list, *scheme, *step, *surfaces;
	const char *text;
	enum hawser_status status =
		hawser__tree_keys(reader, tree, "dynamics", "net.dynamics");

	if (status)
		return status;
	from = hawser__tree_find(tree, "from");
	list = hawser__tree_find(tree, "release");
	scheme = hawser__tree_find(tree, "scheme");
	step = hawser__tree_find(tree, "step");
	surfaces = hawser__tree_find(tree, "surfaces");
	if (from)
		status = hawser__tree_text(reader, &text, from, "from");
	if (!status && from && strcmp(text, "statics") != 0 && !(net->dynamics.from = strdup(text)))
		status = hawser__no_memory(reader->report, "scene");
	if (!status && list)
		status = release(reader, net, list);
	if (!status && scheme)
		status = hawser__tree_text(reader, &text, scheme, "scheme");
	if (!status && scheme)
		status = hawser__tree_name(reader, net->dynamics.scheme, scheme, text, "scheme");
	if (!status && scheme)
		status = known(reader, scheme, net->dynamics.scheme);
	if (!status)
		status = surfaces ? started(reader, net, surfaces) : HAWSER_OK;
	if (!status)
		status = optional(reader, &net->dynamics.rho_inf, tree, "rho_inf", "1",
		                  HAWSER__TREE_NOT_NEGATIVE);
	if (!status && step && !(step->text && !strcmp(step->text, "auto")))
		status = hawser__tree_number(reader, &net->dynamics.step, step, "step", "s",
		                            HAWSER__TREE_POSITIVE);
	return status;
}

/* Rules over all names, cables and supports. */
static enum hawser_status rules(struct hawser__reader *reader, const struct hawser_net *net,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *one = tree->child;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < net->cables && !status; i++, one = one->next) {
		const char *name = net->cable[i].name;

		if (hawser__net_node_of(net, name) >= 0)
			status = hawser__reader_fail(reader, &one->at, "%s is the name of a node and of a cable: "
			                             "give different ones", name);
		else if (strcmp(name, net->cable[net->order[net->nodes + i]].name) != 0 &&
		         hawser__net_cable_of(net, name) != i)
			status = hawser__reader_fail(reader, &one->at, "two cables have the name %s: give "
			                             "different ones", name);
		if (!status)
			status = plausible(reader, net, one, i);
	}
	return status;
}

enum { DYNAMICS = 5 }; /* the first section below that spans have too */

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
	            {"masses", masses, 0}, {"loads", hawser__net_loads, 0}, {"dynamics", dynamics, 0},
	            {"obstacles", hawser__net_obstacles, 0}, {"contact", hawser__net_contact, 0}};
	const struct hawser__tree *damping = hawser__tree_find(root, "damping");
	enum hawser_status status;

	net->g = 9.81;
	net->dynamics.rho_inf = -1.0;
	net->g_given = hawser__tree_find(root, "g") != NULL;
	status = optional(reader, &net->g, root, "g", "m/s^2", HAWSER__TREE_NOT_NEGATIVE);
	for (size_t i = (size_t)from; i < sizeof part/sizeof *part && !status; i++) {
		const struct hawser__tree *tree = hawser__tree_find(root, part[i].name);

		if (tree)
			status = part[i].read(reader, net, tree);
		else if (part[i].required && !(i == 2 && hawser__tree_find(root, "obstacles")))
			status = hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1},
			                             "a net needs %s (see hawser-scene(5))", part[i].name);
		if (!status && i < 2)
			status = hawser__net_index(reader, net);
	}
	if (!status && damping) {
		status = hawser__tree_keys(reader, damping, "damping", "net.damping");
		if (!status)
			status = optional(reader, &net->alpha, damping, "alpha", "kg/m/s",
			                  HAWSER__TREE_NOT_NEGATIVE);
		if (!status)
			status = optional(reader, &net->axial, damping, "axial", "s", HAWSER__TREE_NOT_NEGATIVE);
		net->axial_given = hawser__tree_find(damping, "axial") != NULL;
	}
	return status ? status : hawser__net_room(reader, net, root);
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_net *net = scene;
	const struct hawser__tree *kind = hawser__tree_find(root, "kind");
	enum hawser_status status;

	if (hawser__tree_find(root, "span")) {
		status = hawser__net_of_span(reader, net, root);
		return status ? status : common(reader, net, root, DYNAMICS);
	}
	status = hawser__tree_keys(reader, root, "a scene of kind net", "net");
	if (status)
		return status;
	if (kind && (!kind->text || strcmp(kind->text, "net") != 0))
		return hawser__reader_fail(reader, &kind->at,
		                           "kind must be net here, and span, ropeway, rod or tow "
		                           "in scenes of other kinds");
	status = common(reader, net, root, 0);
	return status ? status : rules(reader, net, hawser__tree_find(root, "cables"));
}

static void clear(void *scene)
{
	hawser_net_clear(scene);
}

static const struct hawser__tree_form form = {
	{"a scene of kind net is a mapping with at least nodes, cables and supports (see "
	"hawser-scene(5))", "cables.c1.EA=100 MN", 'c'},
	sizeof(struct hawser_net), offsetof(struct hawser_net, name), interpret, clear};

enum hawser_status hawser_net_of(struct hawser_net *net, const struct hawser_document *from,
                                 const char *const *set, size_t nset, struct hawser_report *report)
{
	return hawser__tree_scene(net, &form, from, set, nset, report);
}

enum hawser_status hawser_net_open(struct hawser_net *net, const char *path,
                                   const char *const *set, size_t nset, struct hawser_report *report)
{
	return hawser__tree_scene_open(net, &form, path, set, nset, report);
}

/* ropeway/read/obstacles_read.c - read the scene of a span that passes over or under circles.
 *
 * The keys that spans have without obstacles, and those of obstacles that nothing computes yet, are
 * refused by name: nothing of a scene is silently left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/obstacles.h>
#include "core/report.h"
#include "ropeway/statics/line.h"
#include "ropeway/read/read.h"

enum { MOST = 100 }; /* obstacles of a scene: each pair is checked for overlap */
enum { STOPS = 100 }; /* of a path: each takes 20 steps */

/* A key that is one of hawser but not with obstacles. */
struct later {
	const char *key, *why;
};

/* Fail if the mapping has one of the keys [count]. */
static enum hawser_status not_yet(struct hawser__reader *reader, const struct hawser__tree *tree,
                                  const char *section, const struct later *later, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, later[i].key);

		if (one)
			return hawser__reader_fail(reader, &one->at, "%s%s%s: not yet with obstacles: %s", section,
			                           *section ? "." : "", later[i].key, later[i].why);
	}
	return HAWSER_OK;
}
#define NOT_YET(reader, tree, section, later) \
	not_yet(reader, tree, section, later, sizeof (later)/sizeof *(later))

static enum hawser_status rotation(struct hawser__reader *reader, struct hawser__round *circle,
                                   const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *inertia = hawser__tree_find(tree, "inertia");
	int turns = circle->of.rotation == HAWSER_ROTATION_FREE;

	/* A circle that turns freely takes no moment: the tensions are those without friction. */
	circle->sheave.friction = turns ? 0.0 : circle->of.friction;
	if (inertia && !turns)
		return hawser__reader_fail(reader, &inertia->at, "%s.inertia is of a circle that turns with "
		                           "the rope: give rotation: free, or leave it out", section);
	return !inertia || circle->sheave.radius > 0.0 ? HAWSER_OK
		: hawser__reader_fail(reader, &inertia->at, "%s.inertia: a circle of radius 0 does not "
		                      "turn: leave it out, or give a radius", section);
}

static enum hawser_status obstacle(struct hawser__reader *reader, struct hawser_obstacles *of,
                                   const struct hawser__tree *tree)
{
	static const struct later later[] = {
		{"plane", "circles are the only obstacles"}, {"segment", "circles are the only obstacles"},
		{"velocity", "surfaces are at rest"}};
	struct hawser_line_sheave *sheave = &of->line.sheave[of->line.sheaves];
	struct hawser__round circle = {.side = 0};
	struct hawser_report report = {0};
	char section[HAWSER__CALLED];
	enum hawser_status status = NOT_YET(reader, tree, "obstacles", later);

	if (!status)
		status = hawser__tree_name_item(reader, sheave->name, sizeof *sheave, of->line.sheaves, tree,
		                                "obstacles", 's');
	snprintf(section, sizeof section, "obstacles.%s", sheave->name);
	if (!status)
		status = hawser__tree_fill(reader, &circle, tree, section, "obstacles.obstacles[]");
	if (!status && !hawser__tree_find(tree, "circle"))
		status = hawser__reader_fail(reader, &tree->at, "%s.circle is missing: give, for example, "
		                             "circle: {centre: [150 m, -8 m], radius: 10 m}", section);
	if (!status)
		status = rotation(reader, &circle, tree, section);
	if (status)
		return status;
	memcpy(circle.sheave.name, sheave->name, sizeof sheave->name);
	circle.sheave.side = circle.side ? -1 : 1;
	circle.sheave.file_line = tree->at.set ? 0 : (int)tree->at.line;
	*sheave = circle.sheave;
	of->obstacle[of->line.sheaves++] = circle.of;
	status = hawser__line_check(&of->line, &report);
	return status == HAWSER_OK ? status
	                           : hawser__reader_fail(reader, &tree->at, "%s", report.message);
}

static enum hawser_status obstacles(struct hawser__reader *reader, struct hawser_obstacles *of,
                                    const struct hawser__tree *tree)
{
	enum hawser_status status;

	of->line.sheave = hawser__tree_items(reader, &status, tree, "obstacles", sizeof *of->line.sheave,
	                                     1, MOST, "{circle: {centre: [150 m, -8 m], radius: 10 m}, "
	                                     "friction: 0.1}");
	of->obstacle = status ? NULL : calloc((size_t)tree->children, sizeof *of->obstacle);
	if (!status && !of->obstacle)
		status = hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next)
		status = obstacle(reader, of, one);
	return status;
}

/* contact.path and contact.winch: the path of sliding: history. */
static enum hawser_status path(struct hawser__reader *reader, struct hawser_obstacles *of,
                               const struct hawser__tree *tree)
{
	static const char *const ends[] = {"A", "B"};
	static const char *const key[] = {"T0", "T1", "length0"};
	const struct hawser__tree *list = hawser__tree_find(tree, "path");
	const struct hawser__tree *winch = hawser__tree_find(tree, "winch"), *other = list ? list : winch;
	const char *unit = of->line.given == HAWSER_LINE_LENGTH0 ? "m" : "N";
	int own = of->line.given == HAWSER_LINE_T_B;
	enum hawser_status status = HAWSER_OK;

	if (!winch)
		of->winch = own;
	if (!of->history && other)
		return hawser__reader_fail(reader, &other->at, "contact.%s is of sliding: history: give that, "
		                           "or leave it out", list ? "path" : "winch");
	if (!of->history)
		return HAWSER_OK;
	if (!list || list->kind != HAWSER__SEQUENCE || list->children < 1 || list->children > STOPS)
		return hawser__reader_fail(reader, list ? &list->at : &tree->at, "contact.sliding: history "
		                           "needs contact.path, a list of 1 to %d values that tension.%s had "
		                           "before, such as [%.6g %s]", STOPS, key[of->line.given],
		                           1.1*of->line.value, unit);
	if (of->line.given != HAWSER_LINE_LENGTH0 && of->winch != own)
		return hawser__reader_fail(reader, &winch->at, "contact.winch: %s: with tension.%s the rope is "
		                           "paid in and out at end %s", ends[of->winch], key[of->line.given],
		                           ends[own]);
	of->path = calloc((size_t)list->children, sizeof *of->path);
	if (!of->path)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = list->child; one && !status; one = one->next)
		status = hawser__tree_number(reader, &of->path[of->stops++], one, "contact.path", unit,
		                             HAWSER__TREE_POSITIVE);
	return status;
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_obstacles *of = scene;
	static const struct later of_span[] = {
		{"ends", "the cable is without bending stiffness"}, {"travel", "the cable is at rest"},
		{"support", "the ends are fixed"}, {"damping", "statics and undamped modes need none"},
		{"load", "the weight is the only load"}, {"temperature", "length0 is the one at rest"},
		{"attach", "the cable carries nothing"}, {"loads", "the weight is the only load"},
		{"cases", "there are no load cases"}, {"model", "there is no reduced model"},
		{"beam", "a beam passes no obstacles"}},
		of_cable[] = {{"EI", "the cable is without bending stiffness"}},
		of_tension[] = {
		{"H", "the horizontal tension differs from side to side: give T0, T1 or length0"},
		{"sag", "each free part has its own: give T0, T1 or length0"},
		{"branch", "the taut equilibrium is the one computed"},
		{"state", "there is no static load"}},
		of_contact[] = {{"restitution", "it is of motions, which obstacles do not have yet: give 0, or "
		                 "leave it out"}};
	const struct hawser__tree *list = hawser__tree_find(root, "obstacles");
	const struct hawser__tree *contact = hawser__tree_find(root, "contact");
	const struct hawser__tree *bounce = hawser__tree_find(contact, "restitution");
	double restitution = 0.0;
	enum hawser_status status = NOT_YET(reader, root, "", of_span);

	of->line.lift = 1;
	of->modes = -1;
	if (!status)
		status = NOT_YET(reader, hawser__tree_find(root, "cable"), "cable", of_cable);
	if (!status)
		status = NOT_YET(reader, hawser__tree_find(root, "tension"), "tension", of_tension);
	if (!status)
		status = hawser__tree_fill(reader, of, root, "", "obstacles");
	if (!status && bounce)
		status = hawser__tree_value(reader, &restitution, bounce, "contact.restitution",
		                            "obstacles.contact.restitution");
	if (!status && restitution > 0.0)
		status = NOT_YET(reader, contact, "contact", of_contact);
	if (!status && !list)
		status = hawser__reader_fail(reader, &root->at, "the section obstacles is missing: give a list "
		                             "of circles");
	if (!status)
		status = obstacles(reader, of, list);
	of->history = of->line.sliding == HAWSER_LINE_HELD;
	return status || !contact ? status : path(reader, of, contact);
}

HAWSER__TREE_SCENES(obstacles, "obstacles",
	"the scene of a span with obstacles is a mapping with the sections cable, span, "
	"tension and obstacles (see hawser-scene(5), OBSTACLES)",
	"obstacles.s0.friction=0.2", 's')

void hawser_obstacles_clear(struct hawser_obstacles *of)
{
	if (!of)
		return;
	free(of->name);
	free(of->line.sheave);
	free(of->obstacle);
	free(of->path);
	memset(of, 0, sizeof *of);
}

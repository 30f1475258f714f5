/* ropeway/read/obstacles_read.c - read the scene of a span that passes over or under circles.
 *
 * The keys that spans have without obstacles, and those of obstacles that nothing computes yet, are
 * refused by name: nothing of a scene is silently left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
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

static enum hawser_status cable(struct hawser__reader *reader, struct hawser_line *line,
                                const struct hawser__tree *tree)
{
	static const struct later later[] = {{"EI", "the cable is without bending stiffness"}};
	const struct hawser__tree *EA;
	enum hawser_status status = NOT_YET(reader, tree, "cable", later);

	if (!status)
		status = hawser__tree_keys(reader, tree, "cable", "obstacles.cable");
	EA = hawser__tree_find(tree, "EA");
	if (!status && EA && EA->text && !strcmp(EA->text, ".inf"))
		line->EA = INFINITY;
	else if (!status)
		status = hawser__ropeway_number(reader, &line->EA, tree, "cable", "EA", "N",
		                                HAWSER__TREE_POSITIVE, 1);
	return status ? status : hawser__ropeway_number(reader, &line->rho, tree, "cable", "rho", "kg/m",
	                                                HAWSER__TREE_POSITIVE, 1);
}

static enum hawser_status span(struct hawser__reader *reader, struct hawser_line *line,
                               const struct hawser__tree *tree)
{
	enum hawser_status status = hawser__tree_keys(reader, tree, "span", "obstacles.span");

	if (!status)
		status = hawser__ropeway_number(reader, &line->B[0], tree, "span", "d", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	return status ? status : hawser__ropeway_number(reader, &line->B[1], tree, "span", "h", "m",
	                                                HAWSER__TREE_ANY, 1);
}

static enum hawser_status tension(struct hawser__reader *reader, struct hawser_line *line,
                                  const struct hawser__tree *tree)
{
	static const struct later later[] = {
		{"H", "the horizontal tension differs from side to side: give T0, T1 or length0"},
		{"sag", "each free part has its own: give T0, T1 or length0"},
		{"branch", "the taut equilibrium is the one computed"},
		{"state", "there is no static load"}};
	static const struct {
		const char *key, *unit;
		enum hawser_line_given given;
	} way[] = {{"T0", "N", HAWSER_LINE_T_A}, {"T1", "N", HAWSER_LINE_T_B},
	           {"length0", "m", HAWSER_LINE_LENGTH0}};
	const struct hawser__tree *found = NULL;
	enum hawser_status status = NOT_YET(reader, tree, "tension", later);
	size_t chosen = 0;

	if (!status)
		status = hawser__tree_keys(reader, tree, "tension", "obstacles.tension");
	for (size_t i = 0; i < sizeof way/sizeof *way && !status; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, way[i].key);

		if (one && found)
			return hawser__reader_fail(reader, &one->at, "tension has %s and %s: give one of T0, T1 "
			                           "and length0", way[chosen].key, way[i].key);
		if (one) {
			found = one;
			chosen = i;
		}
	}
	if (!status && !found)
		status = hawser__reader_fail(reader, &tree->at, "tension needs one of T0 (N, at end A), T1 (N, "
		                             "at end B) and length0 (m, unstretched)");
	if (status)
		return status;
	line->given = way[chosen].given;
	return hawser__ropeway_number(reader, &line->value, tree, "tension", way[chosen].key,
	                              way[chosen].unit, HAWSER__TREE_POSITIVE, 1);
}

static enum hawser_status name_of(struct hawser__reader *reader, struct hawser_obstacles *of,
                                  const struct hawser__tree *tree)
{
	struct hawser_line_sheave *sheave = &of->line.sheave[of->line.sheaves];
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	const char *text = "";
	enum hawser_status status = HAWSER_OK;

	snprintf(sheave->name, sizeof sheave->name, "s%d", of->line.sheaves);
	if (name)
		status = hawser__tree_text(reader, &text, name, "obstacles.name");
	if (!status && name)
		status = hawser__tree_name(reader, sheave->name, name, text, "obstacles.name");
	for (int i = 0; i < of->line.sheaves && !status; i++)
		if (!strcmp(of->line.sheave[i].name, sheave->name))
			status = hawser__reader_fail(reader, name ? &name->at : &tree->at,
			                             "two obstacles have the name %s: give different ones "
			                             "(without one, the first is s0, the next s1 and so on)",
			                             sheave->name);
	return status;
}

static enum hawser_status circle(struct hawser__reader *reader, struct hawser_line_sheave *sheave,
                                 const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "circle"), *centre;
	char what[HAWSER__CALLED];
	enum hawser_status status;

	snprintf(what, sizeof what, "%.60s.circle", section);
	if (!one)
		return hawser__reader_fail(reader, &tree->at, "%s is missing: give, for example, circle: "
		                           "{centre: [150 m, -8 m], radius: 10 m}", what);
	status = hawser__tree_keys(reader, one, what, "obstacles.obstacles[].circle");
	centre = hawser__tree_find(one, "centre");
	if (!status && !centre)
		status = hawser__reader_fail(reader, &one->at, "%s.centre is missing: give [x, y] in m", what);
	if (!status)
		status = hawser__ropeway_number(reader, &sheave->radius, one, what, "radius", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	snprintf(what, sizeof what, "%.60s.circle.centre", section);
	return status ? status : hawser__tree_vector(reader, sheave->centre, 2, centre, what, "m");
}

/* The index of the word `key` of an obstacle, unchanged if it is not given. */
static enum hawser_status word(struct hawser__reader *reader, int *index,
                               const struct hawser__tree *tree, const char *section, const char *key,
                               const char *const *words, int count)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	char what[HAWSER__CALLED];

	snprintf(what, sizeof what, "%.60s.%s", section, key);
	return one ? hawser__tree_word(reader, index, one, what, words, count) : HAWSER_OK;
}

static enum hawser_status rotation(struct hawser__reader *reader, struct hawser_line_sheave *sheave,
                                   struct hawser_obstacle *of, const struct hawser__tree *tree,
                                   const char *section)
{
	static const char *const words[] = {"locked", "free", "drive"};
	const struct hawser__tree *inertia = hawser__tree_find(tree, "inertia");
	int index = 0;
	enum hawser_status status = word(reader, &index, tree, section, "rotation", words, 3);

	of->rotation = (enum hawser_rotation)index;
	if (!status && inertia && of->rotation != HAWSER_ROTATION_FREE)
		status = hawser__reader_fail(reader, &inertia->at, "%s.inertia is of a circle that turns with "
		                             "the rope: give rotation: free, or leave it out", section);
	if (!status && inertia && sheave->radius == 0.0)
		status = hawser__reader_fail(reader, &inertia->at, "%s.inertia: a circle of radius 0 does not "
		                             "turn: leave it out, or give a radius", section);
	if (!status)
		status = hawser__ropeway_number(reader, &sheave->inertia, tree, section, "inertia", "kg.m^2",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status)
		status = hawser__ropeway_number(reader, &of->friction, tree, section, "friction", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	/* A circle that turns freely takes no moment: the tensions are those without friction. */
	sheave->friction = of->rotation == HAWSER_ROTATION_FREE ? 0.0 : of->friction;
	return status;
}

static enum hawser_status obstacle(struct hawser__reader *reader, struct hawser_obstacles *of,
                                   const struct hawser__tree *tree)
{
	static const struct later later[] = {
		{"plane", "circles are the only obstacles"}, {"segment", "circles are the only obstacles"},
		{"velocity", "surfaces are at rest"}};
	static const char *const sides[] = {"above", "below"}, *const no_yes[] = {"no", "yes"};
	struct hawser_line_sheave *sheave = &of->line.sheave[of->line.sheaves];
	struct hawser_obstacle *one = &of->obstacle[of->line.sheaves];
	struct hawser_report report = {0};
	char section[HAWSER__CALLED];
	int side = 0, groove = 1;
	enum hawser_status status = NOT_YET(reader, tree, "obstacles", later);

	if (!status)
		status = hawser__tree_keys(reader, tree, "an obstacle", "obstacles.obstacles[]");
	if (!status)
		status = name_of(reader, of, tree);
	if (status)
		return status;
	snprintf(section, sizeof section, "obstacles.%s", sheave->name);
	status = circle(reader, sheave, tree, section);
	if (!status)
		status = word(reader, &side, tree, section, "side", sides, 2);
	if (!status)
		status = word(reader, &groove, tree, section, "groove", no_yes, 2);
	sheave->side = side ? -1 : 1;
	sheave->file_line = tree->at.set ? 0 : (int)tree->at.line;
	one->groove = groove;
	if (!status)
		status = rotation(reader, sheave, one, tree, section);
	if (status)
		return status;
	of->line.sheaves++;
	status = hawser__line_check(&of->line, &report);
	return status == HAWSER_OK ? status
	                           : hawser__reader_fail(reader, &tree->at, "%s", report.message);
}

static enum hawser_status obstacles(struct hawser__reader *reader, struct hawser_obstacles *of,
                                    const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "obstacles must be a list of mappings in the "
		                           "order of x, such as [{circle: {centre: [150 m, -8 m], radius: 10 "
		                           "m}, friction: 0.1}]");
	if (tree->children > MOST)
		return hawser__reader_fail(reader, &tree->at, "%d obstacles are more than %d: give fewer",
		                           tree->children, MOST);
	of->line.sheave = calloc((size_t)tree->children, sizeof *of->line.sheave);
	of->obstacle = calloc((size_t)tree->children, sizeof *of->obstacle);
	if (!of->line.sheave || !of->obstacle)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next)
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
	enum hawser_status status;

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
	status = word(reader, &of->winch, tree, "contact", "winch", ends, 2);
	if (!status && of->line.given != HAWSER_LINE_LENGTH0 && of->winch != own)
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

static enum hawser_status contact(struct hawser__reader *reader, struct hawser_obstacles *of,
                                  const struct hawser__tree *tree)
{
	static const char *const sliding[] = {"none", "toward-A", "toward-B", "history"};
	static const char *const modes[] = {"slip", "stick"};
	const struct hawser__tree *one;
	double restitution = 0.0;
	int index = 0;
	enum hawser_status status = hawser__tree_keys(reader, tree, "contact", "obstacles.contact");

	if (!status)
		status = word(reader, &index, tree, "contact", "sliding", sliding, 4);
	of->history = index == 3;
	if (!status)
		status = path(reader, of, tree);
	of->line.sliding = index == 1 ? HAWSER_LINE_TOWARD_A
	                   : index == 2 ? HAWSER_LINE_TOWARD_B
	                   : index == 3 ? HAWSER_LINE_HELD : HAWSER_LINE_NONE;
	if (!status)
		status = word(reader, &of->modes, tree, "contact", "modes", modes, 2);
	one = hawser__tree_find(tree, "restitution");
	if (!status && one)
		status = hawser__tree_number(reader, &restitution, one, "contact.restitution", "1",
		                             HAWSER__TREE_NOT_NEGATIVE);
	if (!status && restitution > 0.0)
		status = hawser__reader_fail(reader, &one->at, "contact.restitution: not yet: it is of "
		                             "motions, which obstacles do not have yet: give 0, or leave it "
		                             "out");
	return status;
}

static enum hawser_status sections(struct hawser__reader *reader, struct hawser_obstacles *of,
                                   const struct hawser__tree *root)
{
	static const struct {
		const char *name, *such;
	} part[] = {{"cable", "{EA: 40 MN, rho: 4 kg/m}"}, {"span", "{d: 300 m, h: 0 m}"},
	            {"tension", "{T0: 50 kN}"}, {"obstacles", "a list of circles"}};
	const struct hawser__tree *found[4], *other = hawser__tree_find(root, "contact");
	enum hawser_status status = HAWSER_OK;

	for (size_t i = 0; i < sizeof part/sizeof *part; i++) {
		found[i] = hawser__tree_find(root, part[i].name);
		if (!found[i])
			return hawser__reader_fail(reader, &root->at, "the section %s is missing: give %s",
			                           part[i].name, part[i].such);
	}
	status = cable(reader, &of->line, found[0]);
	if (!status)
		status = span(reader, &of->line, found[1]);
	if (!status)
		status = tension(reader, &of->line, found[2]);
	if (!status)
		status = obstacles(reader, of, found[3]);
	return status || !other ? status : contact(reader, of, other);
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_obstacles *of = scene;
	static const struct later later[] = {
		{"ends", "the cable is without bending stiffness"}, {"travel", "the cable is at rest"},
		{"support", "the ends are fixed"}, {"damping", "statics and undamped modes need none"},
		{"load", "the weight is the only load"}, {"temperature", "length0 is the one at rest"},
		{"attach", "the cable carries nothing"}, {"loads", "the weight is the only load"},
		{"cases", "there are no load cases"}, {"model", "there is no reduced model"},
		{"beam", "a beam passes no obstacles"}};
	const struct hawser__tree *kind = hawser__tree_find(root, "kind");
	const struct hawser__tree *g = hawser__tree_find(root, "g");
	enum hawser_status status = NOT_YET(reader, root, "", later);

	if (!status)
		status = hawser__tree_keys(reader, root, "a span with obstacles", "obstacles");
	if (!status && kind && (!kind->text || strcmp(kind->text, "span") != 0))
		status = hawser__reader_fail(reader, &kind->at, "kind must be span in a scene with obstacles "
		                             "or contact");
	of->line.g = 9.81;
	of->line.lift = 1;
	of->modes = -1;
	if (!status && g)
		status = hawser__tree_number(reader, &of->line.g, g, "g", "m/s^2", HAWSER__TREE_POSITIVE);
	return status ? status : sections(reader, of, root);
}

static void clear(void *scene)
{
	hawser_obstacles_clear(scene);
}

static const struct hawser__tree_form form = {
	{"the scene of a span with obstacles is a mapping with the sections cable, span, "
	"tension and obstacles (see hawser-scene(5), OBSTACLES)", "obstacles.s0.friction=0.2", 's'},
	sizeof(struct hawser_obstacles), offsetof(struct hawser_obstacles, name), interpret, clear};

enum hawser_status hawser_obstacles_of(struct hawser_obstacles *of,
                                       const struct hawser_document *from,
                                       const char *const *set, size_t nset,
                                       struct hawser_report *report)
{
	return hawser__tree_scene(of, &form, from, set, nset, report);
}

enum hawser_status hawser_obstacles_open(struct hawser_obstacles *of, const char *path,
                                         const char *const *set, size_t nset,
                                         struct hawser_report *report)
{
	return hawser__tree_scene_open(of, &form, path, set, nset, report);
}

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

/* ropeway/read/read.c - read a scene of kind `ropeway`: rope, stations, carriers, load cases, and the
 * rules that involve several of them. Towers are read in towers.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/read/read.h"

#define PI 3.14159265358979323846 /* to the digits of a double */

enum hawser_status hawser__ropeway_number(struct hawser__reader *reader, double *value,
                                          const struct hawser__tree *tree, const char *section,
                                          const char *key, const char *unit,
                                          enum hawser__tree_range range, int required)
{
	return hawser__tree_number_of(reader, value, tree, section, key, unit, range, required);
}

enum hawser_status hawser__ropeway_place(struct hawser__reader *reader, double at[2],
                                         const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "at");
	char what[HAWSER__CALLED];

	snprintf(what, sizeof what, "%s.at", section);
	if (!one)
		return hawser__reader_fail(reader, &tree->at, "%s is missing: give [x, y] in m", what);
	return hawser__tree_vector(reader, at, 2, one, what, "m");
}

static enum hawser_status rope(struct hawser__reader *reader, struct hawser_ropeway *rw,
                               const struct hawser__tree *tree)
{
	enum hawser_status status = hawser__tree_keys(reader, tree, "rope", "ropeway.ropeway.rope");

	if (!status)
		status = hawser__ropeway_number(reader, &rw->EA, tree, "rope", "EA", "N",
		                                HAWSER__TREE_POSITIVE, 1);
	return status ? status : hawser__ropeway_number(reader, &rw->rho, tree, "rope", "rho", "kg/m",
	                                                HAWSER__TREE_POSITIVE, 1);
}

/* Two numbers, the first below the second, with 0 between them. */
static enum hawser_status stops(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || tree->children != 2)
		return hawser__reader_fail(reader, &tree->at, "tension.travel must be a list of 2 numbers in "
		                           "m, the stops of the carriage from its place with the empty rope, "
		                           "such as [-1 m, 4 m]");
	for (int k = 0; k < 2 && !status; k++, child = child->next)
		status = hawser__tree_number(reader, &rw->travel[k], child, "tension.travel", "m",
		                             HAWSER__TREE_ANY);
	if (!status && !(rw->travel[0] <= 0.0 && rw->travel[1] >= 0.0))
		status = hawser__reader_fail(reader, &tree->at, "tension.travel: %.9g m to %.9g m does not "
		                             "contain 0, the place of the carriage with the empty rope",
		                             rw->travel[0], rw->travel[1]);
	rw->stops = 1;
	return status;
}

static enum hawser_status tension(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                  const struct hawser__tree *tree)
{
	static const struct {
		const char *key, *unit;
	} way[] = {{"counterweight", "N"}, {"T0", "N"}, {"length0", "m"}, {"T_empty", "N"}};
	const struct hawser__tree *found = NULL, *travel;
	enum hawser_status status = hawser__tree_keys(reader, tree, "tension",
	                                              "ropeway.ropeway.bottom.tension");

	for (size_t i = 0; i < sizeof way/sizeof *way && !status; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, way[i].key);

		if (one && found)
			return hawser__reader_fail(reader, &one->at, "tension has %s and %s: give one of "
			                           "counterweight, T0, length0 and T_empty", way[rw->tension].key,
			                           way[i].key);
		if (one) {
			found = one;
			rw->tension = (enum hawser_ropeway_tension)i;
		}
	}
	if (status)
		return status;
	rw->tension_line = tree->at.set ? 0 : (int)tree->at.line;
	if (!found)
		return hawser__reader_fail(reader, &tree->at, "tension needs one of counterweight (N, of both "
		                           "lanes), T0 (N, of each lane), length0 (m, of the whole loop; the "
		                           "carriage is fixed) and T_empty (N, of the empty rope; the carriage "
		                           "is fixed)");
	status = hawser__ropeway_number(reader, &rw->value, tree, "tension", way[rw->tension].key,
	                                way[rw->tension].unit, HAWSER__TREE_POSITIVE, 1);
	travel = hawser__tree_find(tree, "travel");
	if (!status && travel && rw->tension > HAWSER_ROPEWAY_T0)
		return hawser__reader_fail(reader, &travel->at, "tension.travel is for a carriage that moves, "
		                           "and %s fixes it", way[rw->tension].key);
	return status || !travel ? status : stops(reader, rw, travel);
}

static enum hawser_status bottom(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                 const struct hawser__tree *tree)
{
	const struct hawser__tree *of;
	enum hawser_status status = hawser__tree_keys(reader, tree, "bottom", "ropeway.ropeway.bottom");

	if (!status)
		status = hawser__ropeway_place(reader, rw->bottom, tree, "bottom");
	if (!status)
		status = hawser__ropeway_number(reader, &rw->bottom_radius, tree, "bottom", "radius", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (!status)
		status = hawser__ropeway_number(reader, &rw->carriage, tree, "bottom", "mass", "kg",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status)
		status = hawser__ropeway_number(reader, &rw->bottom_friction, tree, "bottom", "friction", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status)
		status = hawser__ropeway_number(reader, &rw->bottom_inertia, tree, "bottom", "inertia", "kg m2",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	of = hawser__tree_find(tree, "tension");
	if (!status && rw->bottom_friction >= 1.0)
		status = hawser__reader_fail(reader, &hawser__tree_find(tree, "friction")->at,
		                             "bottom.friction "
		                             "is %.9g, but must be below 1: it is the resistance of the "
		                             "bullwheel as a part of the force on it",
		                             rw->bottom_friction);
	if (!status && !of)
		status = hawser__reader_fail(reader, &tree->at, "bottom.tension is missing: give, for example, "
		                             "tension: {counterweight: 168 kN}");
	return status ? status : tension(reader, rw, of);
}

static enum hawser_status top(struct hawser__reader *reader, struct hawser_ropeway *rw,
                              const struct hawser__tree *tree)
{
	const struct hawser__tree *of;
	enum hawser_status status = hawser__tree_keys(reader, tree, "top", "ropeway.ropeway.top");

	if (!status)
		status = hawser__ropeway_place(reader, rw->top, tree, "top");
	if (!status)
		status = hawser__ropeway_number(reader, &rw->top_radius, tree, "top", "radius", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	of = hawser__tree_find(tree, "drive");
	if (status || !of)
		return status;
	return hawser__ropeway_drive(reader, rw, of);
}

/* A wheel without radius does not turn. */
static enum hawser_status wheels(struct hawser__reader *reader, const struct hawser_ropeway *rw,
                                 const struct hawser__tree *tree)
{
	if (rw->bottom_inertia > 0.0 && rw->bottom_radius == 0.0)
		return hawser__reader_fail(reader, &tree->at, "bottom.inertia with bottom.radius = 0: give the "
		                           "bullwheel a radius");
	if (rw->top_inertia > 0.0 && rw->top_radius == 0.0)
		return hawser__reader_fail(reader, &tree->at, "top.drive.inertia with top.radius = 0: give the "
		                           "bullwheel a radius");
	return HAWSER_OK;
}

/* One mass for both lanes, or {up, down}. */
static enum hawser_status masses(struct hawser__reader *reader, double mass[HAWSER_ROPEWAY_LANES],
                                 const struct hawser__tree *tree, const char *section)
{
	char what[HAWSER__CALLED];
	enum hawser_status status;

	snprintf(what, sizeof what, "%s.mass", section);
	if (tree->kind != HAWSER__MAPPING) {
		status = hawser__tree_number(reader, mass, tree, what, "kg", HAWSER__TREE_NOT_NEGATIVE);
		mass[HAWSER_ROPEWAY_DOWN] = mass[HAWSER_ROPEWAY_UP];
		return status;
	}
	status = hawser__tree_keys(reader, tree, what, "ropeway.ropeway.carriers.mass");
	if (!status)
		status = hawser__ropeway_number(reader, &mass[HAWSER_ROPEWAY_UP], tree, what, "up", "kg",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	return status ? status
	              : hawser__ropeway_number(reader, &mass[HAWSER_ROPEWAY_DOWN], tree, what, "down",
	                                       "kg", HAWSER__TREE_NOT_NEGATIVE, 1);
}

static double reduced(double phase, double spacing)
{
	double left = fmod(phase, spacing);

	return left < 0.0 ? left + spacing : left;
}

static enum hawser_status phases(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                 const struct hawser__tree *tree)
{
	const struct hawser__tree *phase = hawser__tree_find(tree, "phase");
	char shown[HAWSER__SHOWN];
	const char *text = "";
	enum hawser_status status = phase ? hawser__tree_text(reader, &text, phase, "carriers.phase")
	                                  : HAWSER_OK;

	rw->sweep = !strcmp(text, "sweep");
	if (!status && isalpha((unsigned char)*text) && !rw->sweep)
		return hawser__reader_fail(reader, &phase->at, "carriers.phase: \"%s\" must be a length in m, "
		                           "or sweep", hawser__shown(shown, text));
	if (!status && !rw->sweep)
		status = hawser__ropeway_number(reader, &rw->phase, tree, "carriers", "phase", "m",
		                                HAWSER__TREE_ANY, 0);
	rw->phase = reduced(rw->phase, rw->spacing);
	rw->phase_down = rw->spacing - rw->phase;
	if (!status)
		status = hawser__ropeway_number(reader, &rw->phase_down, tree, "carriers", "phase_down", "m",
		                                HAWSER__TREE_ANY, 0);
	rw->phase_down = reduced(rw->phase_down, rw->spacing);
	return status;
}

static enum hawser_status carriers(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *mass;
	enum hawser_status status = hawser__tree_keys(reader, tree, "carriers",
	                                              "ropeway.ropeway.carriers");

	if (!status)
		status = hawser__ropeway_number(reader, &rw->spacing, tree, "carriers", "spacing", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	mass = hawser__tree_find(tree, "mass");
	if (!status && !mass)
		status = hawser__reader_fail(reader, &tree->at, "carriers.mass is missing: give the mass of a "
		                             "carrier in kg, or {up: 400 kg, down: 250 kg}");
	if (!status)
		status = masses(reader, rw->mass, mass, "carriers");
	if (!status)
		status = hawser__ropeway_number(reader, &rw->empty, tree, "carriers", "empty", "kg",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status)
		status = hawser__ropeway_number(reader, &rw->hanger, tree, "carriers", "hanger", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	return status ? status : phases(reader, rw, tree);
}

/* full, empty, up and down; or, after full, those of the scene. */
static enum hawser_status cases(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser_ropeway_case usual[] = {
		{"full", {rw->mass[0], rw->mass[1]}}, {"empty", {rw->empty, rw->empty}},
		{"up", {rw->mass[0], rw->empty}}, {"down", {rw->empty, rw->mass[1]}}};
	int own = tree ? tree->children : 3;
	enum hawser_status status = HAWSER_OK;

	if (tree && tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at, "cases must be a list of load cases, such as "
		                           "[{name: half, mass: {up: 200 kg, down: 0 kg}}]");
	rw->load_case = calloc((size_t)own + 1, sizeof *rw->load_case);
	if (!rw->load_case)
		return hawser__no_memory(reader->report, "scene");
	rw->cases = own + 1;
	for (int i = 0; i < rw->cases && (i == 0 || !tree); i++)
		rw->load_case[i] = usual[i];
	for (const struct hawser__tree *one = tree ? tree->child : NULL, *name, *mass; one && !status;
	     one = one->next) {
		struct hawser_ropeway_case *to = &rw->load_case[1 + tree->children - own--];
		const char *text = "";

		status = hawser__tree_keys(reader, one, "a load case", "ropeway.ropeway.cases[]");
		if (status)
			return status;
		name = hawser__tree_find(one, "name");
		mass = hawser__tree_find(one, "mass");
		if (!name || !mass)
			return hawser__reader_fail(reader, &one->at, "a load case needs name and mass, such as "
			                           "{name: half, mass: {up: 200 kg, down: 0 kg}}");
		status = hawser__tree_text(reader, &text, name, "cases.name");
		if (!status)
			status = hawser__tree_name(reader, to->name, name, text, "cases.name");
		for (int i = 0; i < (int)(to - rw->load_case) && !status; i++)
			if (!strcmp(rw->load_case[i].name, to->name))
				status = hawser__reader_fail(reader, &name->at, "two load cases have the name %s%s",
				                             to->name,
				                             i ? "" : ", which is that of the carriers' masses");
		if (!status)
			status = masses(reader, to->mass, mass, "cases");
	}
	return status;
}

static enum hawser_status words(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	static const char *const down[] = {"off", "on"};
	static const char *const sliding[] = {"running", "rest", "reverse"};
	const struct hawser__tree *one = hawser__tree_find(tree, "down");
	enum hawser_status status = HAWSER_OK;
	int index = 1;

	if (one)
		status = hawser__tree_word(reader, &index, one, "down", down, 2);
	rw->lanes = 1 + index;
	if (!status && rw->lanes == 1 && rw->tension == HAWSER_ROPEWAY_LENGTH0)
		return hawser__reader_fail(
			reader, &one->at,
			"down is off, and tension.length0 is the length of "
			"the loop of both lanes: leave down out, or give T_empty instead");
	one = hawser__tree_find(tree, "sliding");
	index = 0;
	if (one && !status)
		status = hawser__tree_word(reader, &index, one, "sliding", sliding, 3);
	rw->sliding = (enum hawser_ropeway_sliding)index;
	return status;
}

static enum hawser_status ropeway(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                  const struct hawser__tree *tree)
{
	static const struct {
		const char *name;
		enum hawser_status (*read)(struct hawser__reader *, struct hawser_ropeway *,
		                           const struct hawser__tree *);
		int required;
	} part[] = {{"rope", rope, 1}, {"bottom", bottom, 1}, {"top", top, 1},
	            {"towers", hawser__ropeway_towers, 0}, {"carriers", carriers, 0}};
	enum hawser_status status = hawser__tree_keys(reader, tree, "ropeway", "ropeway.ropeway");

	rw->wrap = PI;
	for (size_t i = 0; i < sizeof part/sizeof *part && !status; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, part[i].name);

		if (one)
			status = part[i].read(reader, rw, one);
		else if (part[i].required)
			status = hawser__reader_fail(reader, &tree->at, "ropeway needs %s (see hawser-scene(5), "
			                             "ROPEWAYS)", part[i].name);
		if (!status && i == 2 && !(rw->top[0] > rw->bottom[0]))
			status = hawser__reader_fail(reader, &one->at,
			                             "top.at: x = %.9g m is not beyond x = %.9g m "
			                             "of bottom.at",
			                             rw->top[0], rw->bottom[0]);
	}
	if (!status)
		status = wheels(reader, rw, tree);
	if (!status)
		status = words(reader, rw, tree);
	return status ? status : cases(reader, rw, hawser__tree_find(tree, "cases"));
}

/* What the rope does on its sheaves as it vibrates. */
static enum hawser_status contact(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                  const struct hawser__tree *tree)
{
	static const char *const words[] = {"slip", "stick", "roll"};
	const struct hawser__tree *one;
	enum hawser_status status = hawser__tree_keys(reader, tree, "contact", "ropeway.contact");
	int index;

	one = status ? NULL : hawser__tree_find(tree, "modes");
	if (one)
		status = hawser__tree_word(reader, &index, one, "contact.modes", words, 3);
	if (one && !status)
		rw->hold = (enum hawser_ropeway_hold)(index + 1);
	return status;
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_ropeway *rw = scene;
	const struct hawser__tree *kind, *g, *section, *touch;
	enum hawser_status status = hawser__tree_keys(reader, root, "a scene of kind ropeway", "ropeway");

	rw->g = 9.81;
	if (status)
		return status;
	kind = hawser__tree_find(root, "kind");
	g = hawser__tree_find(root, "g");
	section = hawser__tree_find(root, "ropeway");
	touch = hawser__tree_find(root, "contact");
	if (kind && (!kind->text || strcmp(kind->text, "ropeway") != 0))
		return hawser__reader_fail(reader, &kind->at, "kind must be ropeway");
	if (g)
		status = hawser__tree_number(reader, &rw->g, g, "g", "m/s^2", HAWSER__TREE_POSITIVE);
	if (!status && touch)
		status = contact(reader, rw, touch);
	if (!status && !section)
		status = hawser__reader_fail(reader, &root->at, "the section ropeway is missing (see "
		                             "hawser-scene(5), ROPEWAYS)");
	return status ? status : ropeway(reader, rw, section);
}

static void clear(void *scene)
{
	hawser_ropeway_clear(scene);
}

static const struct hawser__tree_form form = {
	{"a scene of kind ropeway is a mapping with the section ropeway (see hawser-scene(5), ROPEWAYS)",
	"ropeway.towers.p3.friction=0.02", 'p'},
	sizeof(struct hawser_ropeway), offsetof(struct hawser_ropeway, name), interpret, clear};

enum hawser_status hawser_ropeway_of(struct hawser_ropeway *rw, const struct hawser_document *from,
                                     const char *const *set, size_t nset, struct hawser_report *report)
{
	return hawser__tree_scene(rw, &form, from, set, nset, report);
}

enum hawser_status hawser_ropeway_open(struct hawser_ropeway *rw, const char *path,
                                       const char *const *set, size_t nset,
                                       struct hawser_report *report)
{
	return hawser__tree_scene_open(rw, &form, path, set, nset, report);
}

void hawser_ropeway_clear(struct hawser_ropeway *rw)
{
	if (!rw)
		return;
	free(rw->name);
	free(rw->tower);
	free(rw->load_case);
	memset(rw, 0, sizeof *rw);
}

/* contact/surface_read.c - read the section `obstacles`: planes, segments and circles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/surface_read.h"
#include "core/report.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64, MOST = 100 }; /* obstacles: each node may touch each of them */

static enum hawser_status name_of(struct hawser__reader *reader, struct hawser_surface *all, int number,
                                  const struct hawser__tree *tree)
{
	const struct hawser__tree *name = hawser__tree_find(tree, "name");
	const char *text = "";
	enum hawser_status status = HAWSER_OK;

	snprintf(all[number].name, sizeof all[number].name, "s%d", number);
	if (name)
		status = hawser__tree_text(reader, &text, name, "obstacles.name");
	if (!status && name)
		status = hawser__tree_name(reader, all[number].name, name, text, "obstacles.name");
	for (int i = 0; i < number && !status; i++)
		if (!strcmp(all[i].name, all[number].name))
			status = hawser__reader_fail(reader, name ? &name->at : &tree->at,
			                             "two obstacles have the name %s: give different ones "
			                             "(without one, the first is s0, the next s1 and so on)",
			                             all[number].name);
	return status;
}

/* A list of two or three numbers; without the third, along z, it is 0. */
static enum hawser_status vector(struct hawser__reader *reader, double value[3],
                                 const struct hawser__tree *tree, const char *section, const char *key,
                                 const char *unit, int most)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	char what[CALLED];

	snprintf(what, sizeof what, "%.80s.%s", section, key);
	if (!one)
		return hawser__reader_fail(reader, &tree->at, "%s is missing: give [x, y%s]%s%s", what,
		                           most == 3 ? ", z" : "", strcmp(unit, "1") ? " in " : "",
		                           strcmp(unit, "1") ? unit : "");
	return hawser__tree_vector(reader, value, most == 3 && one->children == 2 ? 2 : most, one, what,
	                           unit);
}

static enum hawser_status number(struct hawser__reader *reader, double *value,
                                 const struct hawser__tree *tree, const char *section, const char *key,
                                 const char *unit, enum hawser__tree_range range, int required)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	char what[CALLED];

	snprintf(what, sizeof what, "%.80s.%s", section, key);
	if (!one && required)
		return hawser__reader_fail(reader, &tree->at, "%s is missing: give it in %s", what, unit);
	return one ? hawser__tree_number(reader, value, one, what, unit, range) : HAWSER_OK;
}

/* The shape, of the mapping below the key that is the kind. */
static enum hawser_status shape(struct hawser__reader *reader, struct hawser_surface *surface,
                                const struct hawser__tree *tree, const char *section)
{
	static const char *const keys[] = {"net.obstacles[].plane", "net.obstacles[].segment",
	                                   "net.obstacles[].circle"};
	char what[CALLED];
	enum hawser_status status;

	snprintf(what, sizeof what, "%.60s.%s", section, tree->name);
	status = hawser__tree_keys(reader, tree, what, keys[surface->kind]);
	if (status)
		return status;
	if (surface->kind == HAWSER_SURFACE_PLANE) {
		status = vector(reader, surface->at, tree, what, "point", "m", 3);
		return status ? status : vector(reader, surface->normal, tree, what, "normal", "1", 3);
	}
	if (surface->kind == HAWSER_SURFACE_SEGMENT) {
		status = vector(reader, surface->at, tree, what, "from", "m", 2);
		return status ? status : vector(reader, surface->to, tree, what, "to", "m", 2);
	}
	status = vector(reader, surface->at, tree, what, "centre", "m", 3);
	return status ? status : number(reader, &surface->radius, tree, what, "radius", "m",
	                                HAWSER__TREE_NOT_NEGATIVE, 1);
}

/* Which kind it is: exactly one of the keys. */
static enum hawser_status kind_of(struct hawser__reader *reader, const struct hawser__tree **found,
                                  struct hawser_surface *surface, const struct hawser__tree *tree)
{
	static const char *const keys[] = {"plane", "segment", "circle"};

	*found = NULL;
	for (int i = 0; i < 3; i++) {
		const struct hawser__tree *one = hawser__tree_find(tree, keys[i]);

		if (one && *found)
			return hawser__reader_fail(reader, &one->at, "obstacles.%s has %s and %s: give one of "
			                           "plane, segment and circle", surface->name,
			                           keys[surface->kind], keys[i]);
		if (one) {
			*found = one;
			surface->kind = (enum hawser_surface_kind)i;
		}
	}
	return *found ? HAWSER_OK
		: hawser__reader_fail(reader, &tree->at, "obstacles.%s has no shape: give one of plane, "
		                      "segment and circle, such as plane: {point: [0, 0], normal: [0, 1]}",
		                      surface->name);
}

static enum hawser_status motion(struct hawser__reader *reader, struct hawser_surface *surface,
                                 const struct hawser__tree *tree, const char *section)
{
	if (!hawser__tree_find(tree, "velocity"))
		return HAWSER_OK;
	if (surface->kind == HAWSER_SURFACE_PLANE)
		return vector(reader, surface->velocity, tree, section, "velocity", "m/s", 3);
	return number(reader, &surface->speed, tree, section, "velocity", "m/s", HAWSER__TREE_ANY, 0);
}

/* A groove: of circles. */
static enum hawser_status groove(struct hawser__reader *reader, struct hawser_surface *surface,
                                 const struct hawser__tree *tree, const char *section)
{
	static const char *const words[] = {"no", "yes"};
	const struct hawser__tree *one = hawser__tree_find(tree, "groove");
	char what[CALLED];

	if (!one)
		return HAWSER_OK;
	snprintf(what, sizeof what, "%.80s.groove", section);
	if (surface->kind != HAWSER_SURFACE_CIRCLE || surface->side == HAWSER_SIDE_INSIDE)
		return hawser__reader_fail(reader, &one->at, "%s: a groove is of circles that cables pass "
		                           "outside: leave it out", what);
	return hawser__tree_word(reader, &surface->groove, one, what, words, 2);
}

static enum hawser_status rotation(struct hawser__reader *reader, struct hawser_surface *surface,
                                   const struct hawser__tree *tree, const char *section)
{
	static const char *const words[] = {"locked", "free", "drive"};
	const struct hawser__tree *one = hawser__tree_find(tree, "rotation");
	char what[CALLED];
	int index = 0;
	enum hawser_status status = HAWSER_OK;

	snprintf(what, sizeof what, "%.80s.rotation", section);
	if (one)
		status = hawser__tree_word(reader, &index, one, what, words, 3);
	surface->rotation = (enum hawser_surface_rotation)index;
	return status ? status : number(reader, &surface->inertia, tree, section, "inertia", "kg.m^2",
	                                HAWSER__TREE_NOT_NEGATIVE, 0);
}

static enum hawser_status obstacle(struct hawser__reader *reader, struct hawser_surface *all,
                                   int number_of, const struct hawser__tree *tree)
{
	static const char *const sides[] = {"above", "below", "left", "right", "inside", "around"};
	struct hawser_surface *surface = &all[number_of];
	const struct hawser__tree *found, *side;
	struct hawser_report report = {0};
	char section[CALLED], what[CALLED];
	int index = 0;
	enum hawser_status status;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "an obstacle is a mapping, such as {plane: "
		                           "{point: [0, 0], normal: [0, 1]}, friction: 0.5}");
	status = name_of(reader, all, number_of, tree);
	snprintf(section, sizeof section, "obstacles.%s", surface->name);
	if (!status)
		status = hawser__tree_keys(reader, tree, "an obstacle", "net.obstacles[]");
	if (!status)
		status = kind_of(reader, &found, surface, tree);
	if (!status)
		status = shape(reader, surface, found, section);
	side = hawser__tree_find(tree, "side");
	snprintf(what, sizeof what, "%.80s.side", section);
	if (!status && side && surface->kind == HAWSER_SURFACE_PLANE)
		return hawser__reader_fail(reader, &side->at, "%s: the free side of a plane is that of its "
		                           "normal: leave side out", what);
	if (!status && side)
		status = hawser__tree_word(reader, &index, side, what, sides, 6);
	surface->side = (enum hawser_surface_side)index;
	if (!status)
		status = number(reader, &surface->friction, tree, section, "friction", "1",
		                HAWSER__TREE_NOT_NEGATIVE, 0);
	if (!status)
		status = groove(reader, surface, tree, section);
	if (!status)
		status = rotation(reader, surface, tree, section);
	if (!status)
		status = motion(reader, surface, tree, section);
	if (!status && hawser_surface_settle(surface, &report))
		status = hawser__reader_fail(reader, &tree->at, "%s.%s", section, report.message);
	return status;
}

enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	if (tree->kind != HAWSER__SEQUENCE || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "obstacles must be a list of mappings, such as "
		                           "[{plane: {point: [0, 0], normal: [0, 1]}, friction: 0.5}]");
	if (tree->children > MOST)
		return hawser__reader_fail(reader, &tree->at, "%d obstacles are more than %d: give fewer",
		                           tree->children, MOST);
	*surface = calloc((size_t)tree->children, sizeof **surface);
	if (!*surface)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		status = obstacle(reader, *surface, *count, one);
		*count += !status;
	}
	return status;
}

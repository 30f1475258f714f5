/* rod/read.c - read a scene of kind `rod`: its segments and ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/read.h"
#include "rod/so3.h"
#include "scene/tree_keys.h"

enum { ELEMENTS = 20, MOST_ELEMENTS = 100000 };

enum hawser_status hawser__rod_numbers(struct hawser__reader *reader, double *value, int count,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit, enum hawser__tree_range range)
{
	const struct hawser__tree *child = tree->child;
	enum hawser_status status = HAWSER_OK;

	if (count == 2 && tree->kind == HAWSER__SCALAR) {
		status = hawser__tree_number(reader, value, tree, what, unit, range);
		value[1] = value[0];
		return status;
	}
	if (tree->kind != HAWSER__SEQUENCE || tree->children != count)
		return hawser__reader_fail(reader, &tree->at, "%s must be %s in %s", what,
		                           count == 2 ? "a number, or a list of 2 numbers for e2 and e3,"
		                                      : "a list of 3 numbers for e1, e2 and e3", unit);
	for (int k = 0; k < count && !status; k++, child = child->next)
		status = hawser__tree_number(reader, &value[k], child, what, unit, range);
	return status;
}

/* The numbers section.key; unchanged if not given and not required. */
static enum hawser_status numbers(struct hawser__reader *reader, double *value, int count,
                                  const struct hawser__tree *tree, const char *section,
                                  const char *key, const char *unit, enum hawser__tree_range range,
                                  int required)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	char what[HAWSER__ROD_CALLED];

	snprintf(what, sizeof what, "%s.%s", section, key);
	if (one)
		return hawser__rod_numbers(reader, value, count, one, what, unit, range);
	return required ? hawser__reader_fail(reader, &tree->at, "%s is missing: give it in %s", what, unit)
	                : HAWSER_OK;
}

static enum hawser_status elements_of(struct hawser__reader *reader, struct hawser_rod_segment *segment,
                                      const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "elements");
	double count = ELEMENTS, least;
	double turn = sqrt(hawser__dot(segment->curvature, segment->curvature))*segment->length;
	enum hawser_status status = hawser__tree_number_of(reader, &count, tree, section, "elements", "1",
	                                                   HAWSER__TREE_POSITIVE, 0);

	if (status)
		return status;
	if (count != floor(count) || count > MOST_ELEMENTS)
		return hawser__reader_fail(reader, one ? &one->at : &tree->at, "%s.elements: %.9g is not a "
		                           "whole number from 1 to %d", section, count, MOST_ELEMENTS);
	segment->elements = (int)count;
	least = floor(turn/acos(-1.0)) + 1.0;
	return count >= least ? HAWSER_OK
		: hawser__reader_fail(reader, one ? &one->at : &tree->at, "%s.elements: with %.0f elements one "
		                      "turns by %.4g rad at rest, which must be less than pi: give at least "
		                      "%.0f",
		                      section, count, turn/count, least);
}

static enum hawser_status segment(struct hawser__reader *reader, struct hawser_rod *rod,
                                  const struct hawser__tree *tree, const char *section)
{
	static const struct {
		const char *key, *unit;
		enum hawser__tree_range range;
		size_t at;
		int count, required;
	} row[] = {
#define OF(member) offsetof(struct hawser_rod_segment, member)
		{"length", "m", HAWSER__TREE_POSITIVE, OF(length), 1, 1},
		{"EA", "N", HAWSER__TREE_POSITIVE, OF(EA), 1, 1},
		{"GA", "N", HAWSER__TREE_POSITIVE, OF(GA), 2, 1},
		{"EI", "N.m^2", HAWSER__TREE_POSITIVE, OF(EI), 2, 1},
		{"GJ", "N.m^2", HAWSER__TREE_POSITIVE, OF(GJ), 1, 1},
		{"rho", "kg/m", HAWSER__TREE_NOT_NEGATIVE, OF(rho), 1, 1},
		{"curvature", "m^-1", HAWSER__TREE_ANY, OF(curvature), 3, 0},
		{"inertia", "kg.m", HAWSER__TREE_POSITIVE, OF(inertia), 3, 0},
#undef OF
	};
	struct hawser_rod_segment *to = &rod->segment[rod->segments];
	enum hawser_status status = hawser__tree_keys(reader, tree, section, "rod.rod");

	for (size_t i = 0; i < sizeof row/sizeof *row && !status; i++) {
		double *value = (double *)(void *)((char *)to + row[i].at);

		status = row[i].count == 1
			? hawser__tree_number_of(reader, value, tree, section, row[i].key, row[i].unit,
			                         row[i].range, row[i].required)
			: numbers(reader, value, row[i].count, tree, section, row[i].key, row[i].unit, row[i].range,
			          row[i].required);
	}
	if (!status)
		status = elements_of(reader, to, tree, section);
	if (!status) {
		rod->length += to->length;
		rod->segments++;
	}
	return status;
}

static enum hawser_status segments(struct hawser__reader *reader, struct hawser_rod *rod,
                                   const struct hawser__tree *tree)
{
	int list = tree->kind == HAWSER__SEQUENCE;
	const struct hawser__tree *one = list ? tree->child : tree;
	enum hawser_status status = HAWSER_OK;
	char keys[HAWSER__TREE_LIST_SIZE];

	hawser__tree_key_list(keys, sizeof keys, "rod.rod");
	if (tree->kind == HAWSER__SCALAR || !tree->children)
		return hawser__reader_fail(reader, &tree->at, "rod must be a mapping, or a list of mappings, "
		                           "one a segment, with the keys %s", keys);
	rod->segment = calloc(list ? (size_t)tree->children : 1, sizeof *rod->segment);
	if (!rod->segment)
		return hawser__no_memory(reader->report, "scene");
	for (; one && !status; one = list ? one->next : NULL) {
		char section[32];

		snprintf(section, sizeof section, list ? "rod.i%d" : "rod", rod->segments);
		status = segment(reader, rod, one, section);
	}
	return status;
}

static enum hawser_status hold(struct hawser__reader *reader, enum hawser_rod_hold *to,
                               const struct hawser__tree *tree, const char *what)
{
	static const char *const words[] = {"clamped", "hinged", "free"};
	const struct hawser__tree *one = hawser__tree_find(tree, "hold");
	int index = (int)*to;
	enum hawser_status status = one ? hawser__tree_word(reader, &index, one, what, words, 3)
	                                : HAWSER_OK;

	*to = (enum hawser_rod_hold)index;
	return status;
}

/* A direction, which must not be 0. */
enum hawser_status hawser__rod_direction(struct hawser__reader *reader, double *to,
                                         const struct hawser__tree *tree, const char *what)
{
	enum hawser_status status = hawser__tree_vector(reader, to, 3, tree, what, "1");

	if (!status && !(hawser__dot(to, to) > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s is [0, 0, 0]: give a direction", what);
	return status;
}

/* tangent and normal of an end. Without a normal, e2 is as far upwards as the tangent permits, and x of
 * a vertical tangent. */
static enum hawser_status axes(struct hawser__reader *reader, double tangent[3], double normal[3],
                               const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *along = hawser__tree_find(tree, "tangent");
	const struct hawser__tree *across = hawser__tree_find(tree, "normal");
	char what[HAWSER__ROD_CALLED];
	double c[3];
	enum hawser_status status = HAWSER_OK;

	snprintf(what, sizeof what, "%s.tangent", section);
	if (along)
		status = hawser__rod_direction(reader, tangent, along, what);
	snprintf(what, sizeof what, "%s.normal", section);
	if (!status && across)
		status = hawser__rod_direction(reader, normal, across, what);
	if (status)
		return status;
	if (!across) {
		int upright = tangent[0] == 0.0 && tangent[2] == 0.0;

		normal[0] = upright;
		normal[1] = !upright;
		normal[2] = 0.0;
	}
	hawser__cross(c, tangent, normal);
	if (across && hawser__dot(c, c) <= 1e-12*hawser__dot(tangent, tangent)*hawser__dot(normal, normal))
		return hawser__reader_fail(reader, &across->at, "%s is along the tangent [%g, %g, %g]: give "
		                           "another direction, of which the part across the tangent counts",
		                           what, tangent[0], tangent[1], tangent[2]);
	return HAWSER_OK;
}

static enum hawser_status start(struct hawser__reader *reader, struct hawser_rod *rod,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *at = hawser__tree_find(tree, "at");
	const struct hawser__tree *winch = hawser__tree_find(tree, "winch");
	enum hawser_status status = HAWSER_OK;

	if (tree)
		status = hawser__tree_keys(reader, tree, "start", "rod.start");
	if (!status && at)
		status = hawser__tree_vector(reader, rod->at, 3, at, "start.at", "m");
	if (!status)
		status = axes(reader, rod->tangent, rod->normal, tree, "start");
	if (!status)
		status = hold(reader, &rod->hold[0], tree, "start.hold");
	if (!status && winch && rod->hold[0] == HAWSER_ROD_FREE)
		status = hawser__reader_fail(reader, &winch->at, "start.winch: the start is free: give hold: "
		                             "hinged or hold: clamped, or leave the winch out");
	if (!status && winch)
		status = hawser__rod_read_winch(reader, &rod->winch, winch, "start.winch", "rod.start.winch");
	return status ? status : hawser__rod_read_drive(reader, rod, 0, tree);
}

/* Nodes of the first segment go through the material; loads that begin or end within it would, too. */
static enum hawser_status unmarked(struct hawser__reader *reader, const struct hawser_rod *rod,
                                   const struct hawser__tree *tree)
{
	double end = rod->segment[0].length, near = 1e-9*rod->length;

	for (int l = 0; l < rod->loads && rod->winch.on; l++) {
		const double at[2] = {rod->load[l].from, rod->load[l].to};

		for (int k = 0; k < 2; k++)
			if (at[k] > near && at[k] < end - near)
				return hawser__reader_fail(reader, &tree->at, "loads.i%d: %.9g m is within the first "
				                           "segment, of %.9g m, which start.winch makes longer: put "
				                           "loads at its ends, or beyond it", l, at[k], end);
	}
	return HAWSER_OK;
}

static enum hawser_status end(struct hawser__reader *reader, struct hawser_rod *rod,
                              const struct hawser__tree *tree)
{
	const struct hawser__tree *at = hawser__tree_find(tree, "at");
	const struct hawser__tree *tangent = hawser__tree_find(tree, "tangent");
	enum hawser_status status = hawser__tree_keys(reader, tree, "end", "rod.end");

	if (!status)
		status = hold(reader, &rod->hold[1], tree, "end.hold");
	if (!status && at && rod->hold[1] == HAWSER_ROD_FREE)
		status = hawser__reader_fail(reader, &at->at, "end.at: the end is free: give hold: hinged or "
		                             "hold: clamped, or leave the place out");
	if (!status && at)
		status = hawser__tree_vector(reader, rod->end_at, 3, at, "end.at", "m");
	if (!status && !tangent && hawser__tree_find(tree, "normal"))
		status = hawser__reader_fail(reader, &hawser__tree_find(tree, "normal")->at,
		                             "end.normal: give end.tangent too");
	if (!status && tangent && rod->hold[1] != HAWSER_ROD_CLAMPED)
		status = hawser__reader_fail(reader, &tangent->at, "end.tangent: the end turns freely: give "
		                             "hold: clamped, or leave the tangent out");
	if (!status && tangent)
		status = axes(reader, rod->end_tangent, rod->end_normal, tree, "end");
	rod->placed = at != NULL;
	rod->turned = tangent != NULL;
	return status ? status : hawser__rod_read_drive(reader, rod, 1, tree);
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_rod *rod = scene;
	const struct hawser__tree *kind = hawser__tree_find(root, "kind");
	const struct hawser__tree *tree = hawser__tree_find(root, "rod");
	const struct hawser__tree *last = hawser__tree_find(root, "end");
	char keys[HAWSER__TREE_LIST_SIZE];
	enum hawser_status status = hawser__tree_keys(reader, root, "a scene of kind rod", "rod");

	hawser__tree_key_list(keys, sizeof keys, "rod.rod");
	rod->g = 9.81;
	rod->tangent[0] = 1.0;
	rod->hold[1] = HAWSER_ROD_FREE;
	rod->rho_inf = -1.0;
	if (!status && kind && (!kind->text || strcmp(kind->text, "rod") != 0))
		status = hawser__reader_fail(reader, &kind->at, "kind must be rod");
	if (!status && !tree)
		status = hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "the section rod is "
		                             "missing: give its %s (see hawser-scene(5))", keys);
	if (!status && hawser__tree_find(root, "g"))
		status = hawser__tree_number(reader, &rod->g, hawser__tree_find(root, "g"), "g", "m/s^2",
		                             HAWSER__TREE_NOT_NEGATIVE);
	if (!status)
		status = segments(reader, rod, tree);
	if (!status)
		status = start(reader, rod, hawser__tree_find(root, "start"));
	if (!status && last)
		status = end(reader, rod, last);
	tree = hawser__tree_find(root, "loads");
	if (!status && tree)
		status = hawser__rod_read_loads(reader, rod, tree);
	if (!status && tree)
		status = unmarked(reader, rod, tree);
	return status ? status : hawser__rod_read_dynamics(reader, rod, root);
}

static void clear(void *scene)
{
	hawser_rod_clear(scene);
}

static const struct hawser__tree_form form = {
	{"a scene of kind rod is a mapping with at least rod (see hawser-scene(5))",
	"loads.i0.force=[0 N, -5 N, 0 N]", 'i'},
	sizeof(struct hawser_rod), offsetof(struct hawser_rod, name), interpret, clear};

enum hawser_status hawser_rod_of(struct hawser_rod *rod, const struct hawser_document *from,
                                 const char *const *set, size_t nset, struct hawser_report *report)
{
	return hawser__tree_scene(rod, &form, from, set, nset, report);
}

enum hawser_status hawser_rod_open(struct hawser_rod *rod, const char *path,
                                   const char *const *set, size_t nset, struct hawser_report *report)
{
	return hawser__tree_scene_open(rod, &form, path, set, nset, report);
}

void hawser_rod_clear(struct hawser_rod *rod)
{
	if (!rod)
		return;
	free(rod->name);
	free(rod->segment);
	for (int i = 0; i < rod->loads; i++)
		free(rod->load[i].factor);
	free(rod->load);
	free(rod->drive[0].path);
	free(rod->drive[1].path);
	free(rod->winch.row);
	memset(rod, 0, sizeof *rod);
}

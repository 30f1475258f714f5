/* rod/read.c - read a scene of kind `rod`: its segments and ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"
#include "rod/read.h"
#include "rod/so3.h"
#include "scene/tree_keys.h"

/* One element must not turn by pi at rest. */
static enum hawser_status turns(struct hawser__reader *reader, const struct hawser_rod_segment *segment,
                                const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "elements");
	double turn = sqrt(hawser__dot(segment->curvature, segment->curvature))*segment->length;
	double least = floor(turn/acos(-1.0)) + 1.0;

	return segment->elements >= least ? HAWSER_OK
		: hawser__reader_fail(reader, one ? &one->at : &tree->at, "%s.elements: with %d elements one "
		                      "turns by %.4g rad at rest, which must be less than pi: give at least "
		                      "%.0f", section, segment->elements, turn/segment->elements, least);
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
		struct hawser_rod_segment *to = &rod->segment[rod->segments];
		char section[32];

		snprintf(section, sizeof section, list ? "rod.i%d" : "rod", rod->segments);
		status = hawser__tree_fill(reader, to, one, section, "rod.rod");
		if (!status)
			status = turns(reader, to, one, section);
		if (!status)
			status = hawser__net_wet(reader, &rod->water, one, section);
		rod->length += to->length;
		rod->segments++;
	}
	return status;
}

static enum hawser_status direction(struct hawser__reader *reader, const double of[3],
                                    const struct hawser__tree *tree, const char *what)
{
	return hawser__dot(of, of) > 0.0 ? HAWSER_OK
		: hawser__reader_fail(reader, &tree->at, "%s is [0, 0, 0]: give a direction", what);
}

/* tangent and normal of an end. Without a normal, e2 is as far upwards as the tangent permits, and x of
 * a vertical tangent. */
static enum hawser_status axes(struct hawser__reader *reader, const double tangent[3], double normal[3],
                               const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *along = hawser__tree_find(tree, "tangent");
	const struct hawser__tree *across = hawser__tree_find(tree, "normal");
	char what[HAWSER__ROD_CALLED];
	double c[3];
	enum hawser_status status = HAWSER_OK;

	snprintf(what, sizeof what, "%s.tangent", section);
	if (along)
		status = direction(reader, tangent, along, what);
	snprintf(what, sizeof what, "%s.normal", section);
	if (!status && across)
		status = direction(reader, normal, across, what);
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

/* What `spin` and `path` of an end ask for; the axis gets the length 1. */
static enum hawser_status drive(struct hawser__reader *reader, struct hawser_rod *rod, int end,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *turn = hawser__tree_find(tree, "spin");
	const struct hawser__tree *path = hawser__tree_find(tree, "path");
	const char *section = end ? "end" : "start";
	double *axis = rod->drive[end].axis, length;
	char what[HAWSER__ROD_CALLED];
	enum hawser_status status;

	if (turn && rod->hold[end] != HAWSER_ROD_CLAMPED)
		return hawser__reader_fail(reader, &turn->at, "%s.spin: an end that spins must be held by its "
		                           "axes too: give hold: clamped, or leave the spin out", section);
	if (path && rod->hold[end] == HAWSER_ROD_FREE)
		return hawser__reader_fail(reader, &path->at, "%s.path: the end is free: give hold: hinged or "
		                           "hold: clamped, or leave the path out", section);
	if (!turn)
		return HAWSER_OK;
	snprintf(what, sizeof what, "%s.spin.axis", section);
	status = direction(reader, axis, hawser__tree_find(turn, "axis"), what);
	length = sqrt(hawser__dot(axis, axis));
	for (int k = 0; k < 3 && !status; k++)
		axis[k] /= length;
	return status;
}

static enum hawser_status start(struct hawser__reader *reader, struct hawser_rod *rod,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *winch = hawser__tree_find(tree, "winch");
	enum hawser_status status = axes(reader, rod->tangent, rod->normal, tree, "start");

	if (!status && winch && rod->hold[0] == HAWSER_ROD_FREE)
		status = hawser__reader_fail(reader, &winch->at, "start.winch: the start is free: give hold: "
		                             "hinged or hold: clamped, or leave the winch out");
	if (!status && winch)
		status = hawser__rod_read_winch(reader, &rod->winch, winch, "start.winch", "rod.start.winch");
	return status ? status : drive(reader, rod, 0, tree);
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
	enum hawser_status status = HAWSER_OK;

	if (at && rod->hold[1] == HAWSER_ROD_FREE)
		status = hawser__reader_fail(reader, &at->at, "end.at: the end is free: give hold: hinged or "
		                             "hold: clamped, or leave the place out");
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
	return status ? status : drive(reader, rod, 1, tree);
}

/* What the water asks of the ends. */
static enum hawser_status submerged(struct hawser__reader *reader, const struct hawser_rod *rod,
                                    const struct hawser__tree *root)
{
	const struct hawser__tree *first = hawser__tree_find(root, "start");
	const struct hawser__tree *at = hawser__tree_find(first, "at");
	const struct hawser__tree *winch = hawser__tree_find(first, "winch");
	enum hawser_status status = hawser__water_bed(reader, &rod->water, rod->at[1], at ? at : root,
	                                              "start.at");

	at = hawser__tree_find(hawser__tree_find(root, "end"), "at");
	if (!status && at)
		status = hawser__water_bed(reader, &rod->water, rod->end_at[1], at, "end.at");
	return status || !winch || !(rod->water.density > 0.0) ? status
		: hawser__reader_fail(reader, &winch->at, "start.winch in water: the added mass of a rod that "
		                      "lengthens is not known here; leave water out, or give a net with "
		                      "winches, whose cables do not bend");
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_rod *rod = scene;
	const struct hawser__tree *tree = hawser__tree_find(root, "rod");
	const struct hawser__tree *last = hawser__tree_find(root, "end");
	enum hawser_status status = hawser__tree_fill(reader, rod, root, "", "rod");
	char keys[HAWSER__TREE_LIST_SIZE];

	hawser__tree_key_list(keys, sizeof keys, "rod.rod");
	if (!status && !tree)
		status = hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "the section rod is "
		                             "missing: give its %s (see hawser-scene(5))", keys);
	if (!status)
		status = hawser__water_read(reader, &rod->water, rod->g, hawser__tree_find(root, "water"));
	if (!status)
		status = segments(reader, rod, tree);
	if (!status)
		status = start(reader, rod, hawser__tree_find(root, "start"));
	if (!status && last)
		status = end(reader, rod, last);
	if (!status)
		status = submerged(reader, rod, root);
	tree = hawser__tree_find(root, "loads");
	if (!status && tree)
		status = hawser__rod_read_loads(reader, rod, tree);
	return status || !tree ? status : unmarked(reader, rod, tree);
}

HAWSER__TREE_SCENES(rod, "rod",
	"a scene of kind rod is a mapping with at least rod (see hawser-scene(5))",
	"loads.i0.force=[0 N, -5 N, 0 N]", 'i')

void hawser_rod_clear(struct hawser_rod *rod)
{
	if (!rod)
		return;
	free(rod->name);
	free(rod->segment);
	for (int i = 0; i < rod->loads; i++)
		free(rod->load[i].factor);
	free(rod->load);
	hawser_water_clear(&rod->water);
	free(rod->drive[0].path);
	free(rod->drive[1].path);
	free(rod->winch.row);
	memset(rod, 0, sizeof *rod);
}

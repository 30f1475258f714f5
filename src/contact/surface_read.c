/* contact/surface_read.c - read the section `obstacles`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "contact/heights.h"

enum { CALLED = HAWSER__TEXT_ROOM + 64, MOST = 100 }; /* obstacles: each node may touch each of them */

/* What a shape does not have. */
static enum hawser_status fits(struct hawser__reader *reader, const struct hawser_surface *surface,
                               const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *side = hawser__tree_find(tree, "side");
	const struct hawser__tree *groove = hawser__tree_find(tree, "groove");
	const struct hawser__tree *velocity = hawser__tree_find(tree, "velocity");
	int plane = surface->kind == HAWSER_SURFACE_PLANE;
	int bed = surface->kind == HAWSER_SURFACE_PROFILE || surface->kind == HAWSER_SURFACE_GRID;

	if (side && (plane || bed))
		return hawser__reader_fail(reader, &side->at, "%s.side: the free side %s: leave side out",
		                           section, plane ? "of a plane is that of its normal"
		                                          : "of a profile or grid is above it");
	if (surface->rounding > 0.0 && !bed)
		return hawser__reader_fail(reader, &tree->at, "%s.rounding is of a profile or grid: leave it "
		                           "out", section);
	if (velocity && surface->kind == HAWSER_SURFACE_GRID)
		return hawser__reader_fail(reader, &velocity->at, "%s.velocity: a grid does not move: leave "
		                           "velocity out", section);
	if (groove && (surface->kind != HAWSER_SURFACE_CIRCLE || surface->side == HAWSER_SIDE_INSIDE))
		return hawser__reader_fail(reader, &groove->at, "%s.groove: a groove is of circles that cables "
		                           "pass outside: leave it out", section);
	return !velocity || plane == (velocity->kind == HAWSER__SEQUENCE) ? HAWSER_OK
		: hawser__reader_fail(reader, &velocity->at, "%s.velocity must be %s in m/s", section,
		                      plane ? "a list [x, y, z]" : "a single number");
}

static enum hawser_status obstacle(struct hawser__reader *reader, struct hawser_surface *all,
                                   int number, const struct hawser__tree *tree, double round)
{
	struct hawser_surface *surface = &all[number];
	struct hawser_report report = {0};
	char section[CALLED];
	enum hawser_status status = hawser__tree_name_item(reader, surface->name, sizeof *surface, number,
	                                                   tree, "obstacles", 's');

	snprintf(section, sizeof section, "obstacles.%s", surface->name);
	if (!status)
		status = hawser__tree_fill(reader, surface, tree, section, "net.obstacles[]");
	if (!status)
		status = fits(reader, surface, tree, section);
	if (!status && surface->kind >= HAWSER_SURFACE_PROFILE)
		status = hawser__heights_read(reader, surface, tree, section,
		                              surface->rounding > 0.0 ? surface->rounding : round);
	if (!status && hawser_surface_settle(surface, &report))
		status = hawser__reader_fail(reader, &tree->at, "%s.%s", section, report.message);
	return status;
}

enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree, double round)
{
	enum hawser_status status;

	*surface = hawser__tree_items(reader, &status, tree, "obstacles", sizeof **surface, 1, MOST,
	                              "{plane: {point: [0, 0], normal: [0, 1]}, friction: 0.5}");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next)
		status = obstacle(reader, *surface, (*count)++, one, round);
	return status;
}

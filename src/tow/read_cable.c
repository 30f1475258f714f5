/* tow/read_cable.c - read the sections of a towed body besides its path: cable, air, body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "net/read/read.h"
#include "tow/read.h"

enum { MOST = 1000 /* parts of a cable */ };

static enum hawser_status segment(struct hawser__reader *reader, const struct hawser_water *water,
                                  struct hawser_tow_segment *to, const struct hawser__tree *tree,
                                  const char *section)
{
	const struct hawser__tree *shedding, *added;
	enum hawser_status status = hawser__tree_fill(reader, to, tree, section, "tow.cable.segments[]");

	if (status)
		return status;
	shedding = hawser__tree_find(tree, "shedding");
	if (shedding && !(to->diameter > 0.0))
		return hawser__reader_fail(reader, &shedding->at, "%s.shedding needs the diameter, which is "
		                           "not given", section);
	if (shedding && water->density > 0.0)
		return hawser__reader_fail(reader, &shedding->at, "%s.shedding in water: the lift of vortices "
		                           "is that of air; leave it out", section);
	if (water->density > 0.0)
		return hawser__net_wet(reader, water, tree, section);
	added = hawser__tree_find(tree, "added_mass");
	if (added)
		return hawser__reader_fail(reader, &added->at, "%s.added_mass is of water, and the scene has "
		                           "none: add water: {density: 1025 kg/m^3}", section);
	return !hawser__tree_find(tree, "drag") || hawser__tree_find(tree, "diameter") ? HAWSER_OK
		: hawser__reader_fail(reader, &tree->at, "%s.diameter is missing: give it in m, for the drag",
		                      section);
}

enum hawser_status hawser__tow_cable(struct hawser__reader *reader, struct hawser_tow *tow,
                                     const struct hawser__tree *tree)
{
	const struct hawser__tree *list = tree ? hawser__tree_find(tree, "segments") : NULL;
	enum hawser_status status = tree ? hawser__tree_keys(reader, tree, "cable", "tow.cable")
	                                 : HAWSER_OK;

	if (status || !tree)
		return status;
	tow->segment = hawser__tree_items(reader, &status, list ? list : tree, "cable.segments",
	                                  sizeof *tow->segment, 1, MOST, "{length: 14 m, rho: 58 g/m, "
	                                  "diameter: 8 mm, drag: {normal: 1.2}}");
	for (const struct hawser__tree *one = status ? NULL : list->child; one && !status;
	     one = one->next) {
		char what[HAWSER__TOW_WHAT];

		snprintf(what, sizeof what, "cable.segments[%d]", tow->segments);
		status = segment(reader, &tow->water, &tow->segment[tow->segments++], one, what);
	}
	return status;
}

/* Wind in time, of a file beside the scene. */
static enum hawser_status gusts(struct hawser__reader *reader, struct hawser_tow *tow,
                                const struct hawser__tree *tree, const struct hawser__tree *wind)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "file");
	enum hawser_status status;

	if (!one)
		return HAWSER_OK;
	if (wind)
		return hawser__reader_fail(reader, &wind->at, "air has wind and file: remove one of them");
	if (tow->density == 0.0)
		return hawser__reader_fail(reader, &one->at, "air.file, a wind, in air of density 0 has no "
		                           "effect: give the density, such as 1.2 kg/m^3, or no wind");
	status = hawser__tow_file(reader, &tow->gust, &tow->gusts, one, "air.file");
	for (int k = 0; k < 3 && !status; k++)
		tow->wind[k] = tow->gust[0].at[0][k];
	return status;
}

enum hawser_status hawser__tow_air(struct hawser__reader *reader, struct hawser_tow *tow,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *wind = hawser__tree_find(tree, "wind");
	enum hawser_status status = gusts(reader, tow, tree, wind);

	if (!status && wind && tow->density == 0.0 && (tow->wind[0] != 0.0 || tow->wind[1] != 0.0 ||
	                                               tow->wind[2] != 0.0))
		status = hawser__reader_fail(reader, &wind->at, "air.wind in air of density 0 has no "
		                             "effect: give the density, such as 1.2 kg/m^3, or no wind");
	return status;
}

enum hawser_status hawser__tow_body(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *tree)
{
	struct hawser_tow_body *body = &tow->body;
	const struct hawser__tree *ring = hawser__tree_find(tree, "ring");
	const struct hawser__tree *joint = hawser__tree_find(tree, "joint");

	if (!tree)
		return HAWSER_OK;
	for (int k = 0; k < 3 && ring; k++) {
		static const char *const key[] = {"mass", "CdA", "inertia"};
		const struct hawser__tree *one = hawser__tree_find(tree, key[k]);

		if (one)
			return hawser__reader_fail(reader, &one->at, "body has ring and %s: a ring has its "
			                           "own mass, drag and inertia; remove one of them", key[k]);
	}
	if (joint && !ring)
		return hawser__reader_fail(reader, &joint->at, "body.joint is of a ring: a mass is a point, "
		                           "which has no attitude; leave it out");
	if (joint && joint->kind == HAWSER__MAPPING)
		body->joint = HAWSER_TOW_SPRING;
	body->kind = ring ? HAWSER_TOW_RING : HAWSER_TOW_MASS;
	if (ring && body->ring.drag.radius >= body->ring.radius)
		return hawser__reader_fail(reader, &ring->at, "body.ring.tube, the radius of the tube, "
		                           "must be less than the radius of the ring");
	return ring || body->mass > 0.0 ? HAWSER_OK
		: hawser__reader_fail(reader, &tree->at, "body.mass is missing: give it in kg, or a ring");
}

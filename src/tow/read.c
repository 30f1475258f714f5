/* tow/read.c - read the scene of a towed body: its sections.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "net/read/read.h"
#include "rod/read.h"
#include "tow/read.h"

#define STRAIN 0.2 /* of the cable by its load at rest: more is no small strain */

/* Drag coefficients ask for the density of the air. */
static enum hawser_status in_air(struct hawser__reader *reader, const struct hawser_tow *tow,
                                 const struct hawser__tree *root)
{
	double drag = tow->body.CdA + tow->body.ring.drag.normal + tow->body.ring.drag.tangential;

	for (int i = 0; i < tow->segments; i++)
		drag += tow->segment[i].normal + tow->segment[i].tangential;
	if (drag > 0.0 && !hawser__tree_find(root, "air") && !hawser__tree_find(root, "water"))
		return hawser__reader_fail(reader, &root->at, "cable or body has drag, but the section air "
		                           "is missing: give air: {density: 1.2 kg/m^3}");
	return HAWSER_OK;
}

/* What water asks of the other sections, and what they ask of it. */
static enum hawser_status in_water(struct hawser__reader *reader, struct hawser_tow *tow,
                                   const struct hawser__tree *root)
{
	static const char *const other[] = {"air", "winch"}, *const of_water[] = {"volume", "added_mass"};
	const struct hawser__tree *body = hawser__tree_find(root, "body"), *one;
	int wet = tow->water.density > 0.0;

	for (int i = 0; i < 2; i++) {
		if (wet && (one = hawser__tree_find(root, other[i])) != NULL)
			return hawser__reader_fail(reader, &one->at, i ? "winch in water: the added mass of a "
			                           "cable that lengthens is not known here; leave out one of both"
			                           : "the scene has air and water: what is above the surface has "
			                           "no loads; leave out one of both");
		if ((!wet || (body && hawser__tree_find(body, "ring"))) &&
		    (one = hawser__tree_find(body, of_water[i])) != NULL)
			return hawser__reader_fail(reader, &one->at, "body.%s is of a mass in water: add water: "
			                           "{density: 1025 kg/m^3}, and no ring, or leave it out",
			                           of_water[i]);
	}
	one = hawser__tree_find(body, "ring");
	if (wet && one)
		return hawser__reader_fail(reader, &one->at, "body.ring in water: buoyancy and added mass of a "
		                           "ring are not known; give mass, volume, CdA and added_mass");
	if (wet)
		tow->density = tow->water.density;
	return HAWSER_OK;
}

/* In water of finite depth the path begins, and its waypoints are, above the bed. */
static enum hawser_status on_bed(struct hawser__reader *reader, const struct hawser_tow *tow,
                                 const struct hawser__tree *section)
{
	const struct hawser__tree *list = hawser__tree_find(section, "waypoints");
	const struct hawser__tree *one = list ? list->child : NULL;
	const struct hawser__tree *start = hawser__tree_find(section, "start");
	enum hawser_status status = HAWSER_OK;
	char what[40];

	if (tow->path.kind != HAWSER_PATH_WAYPOINTS)
		return hawser__water_bed(reader, &tow->water, tow->path.origin[1], start ? start : section,
		                         "the towing point");
	for (int i = 0; i < tow->waypoints && !status; i++, one = one ? one->next : NULL) {
		snprintf(what, sizeof what, "waypoint %d of the path", i + 1);
		status = hawser__water_bed(reader, &tow->water, tow->waypoint[i].at[0][1], one ? one : section,
		                           what);
	}
	return status;
}

/* Stresses are linear in strains, which holds for small ones. */
static enum hawser_status borne(struct hawser__reader *reader, const struct hawser_tow *tow,
                                const struct hawser__tree *root)
{
	const struct hawser__tree *body = hawser__tree_find(root, "body");
	double weight = tow->body.mass*tow->g;

	for (int i = tow->segments - 1; i >= 0; i--) {
		const struct hawser_tow_segment *segment = &tow->segment[i];

		weight += segment->length*segment->rho*tow->g;
		if (weight > STRAIN*segment->EA)
			return hawser__reader_fail(reader, body ? &body->at : &root->at, "the body and the cable "
			                           "below the top of cable.segments[%d] weigh %.6g N, which "
			                           "stretches it by %.3g of its length (EA %.6g N): give a larger "
			                           "EA, or a smaller mass", i, weight, weight/segment->EA,
			                           segment->EA);
	}
	return HAWSER_OK;
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_tow *tow = scene;
	const struct hawser__tree *section = hawser__tree_find(root, "tow");
	const struct hawser__tree *winch = hawser__tree_find(root, "winch");
	enum hawser_status status = hawser__tree_fill(reader, tow, root, "", "tow");

	if (!status && !section)
		status = hawser__reader_fail(reader, &root->at, "the section tow is missing: give, for "
		                             "example, tow: {orbit: {radius: 100 m, speed: 20 m/s}}");
	if (!status)
		status = hawser__tow_path(reader, tow, section);
	if (!status)
		status = hawser__water_read(reader, &tow->water, tow->g, hawser__tree_find(root, "water"));
	if (!status)
		status = on_bed(reader, tow, section);
	if (!status)
		status = hawser__tow_cable(reader, tow, hawser__tree_find(root, "cable"));
	if (!status)
		status = hawser__tow_air(reader, tow, hawser__tree_find(root, "air"));
	if (!status)
		status = hawser__tow_body(reader, tow, hawser__tree_find(root, "body"));
	if (!status && winch)
		status = hawser__rod_read_winch(reader, &tow->winch, winch, "winch", "tow.winch");
	if (!status)
		status = in_water(reader, tow, root);
	tow->body.ring.drag.density = tow->density;
	if (!status)
		status = borne(reader, tow, root);
	return status ? status : in_air(reader, tow, root);
}

HAWSER__TREE_SCENES(tow, "tow",
	"the scene of a towed body is a mapping with the section tow (see hawser-scene(5), "
	"TOW)",
	"tow.orbit.radius=80 m", 'p')

void hawser_tow_clear(struct hawser_tow *tow)
{
	if (!tow)
		return;
	free(tow->name);
	free(tow->waypoint);
	free(tow->segment);
	free(tow->gust);
	free(tow->winch.row);
	hawser_water_clear(&tow->water);
	hawser_path_clear(&tow->path);
	memset(tow, 0, sizeof *tow);
}

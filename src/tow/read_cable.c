/* tow/read_cable.c - read the sections of a towed body besides its path: cable, air, body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/read.h"

enum { MOST = 1000,      /* parts of a cable */
       ELEMENTS = 100000 /* of a part: more make no result better */ };

/* A whole number in a range; unchanged if it is not given. */
static enum hawser_status whole(struct hawser__reader *reader, int *to, const struct hawser__tree *tree,
                                const char *section, const char *key, int least, int most)
{
	const struct hawser__tree *one = hawser__tree_find(tree, key);
	double number = 0.0;
	enum hawser_status status = hawser__tree_number_of(reader, &number, tree, section, key, "1",
	                                                   HAWSER__TREE_ANY, 0);

	if (status || !one)
		return status;
	if (number != floor(number) || number < least || number > most)
		return hawser__reader_fail(reader, &one->at, "%s.%s must be a whole number from %d to %d",
		                           section, key, least, most);
	*to = (int)number;
	return HAWSER_OK;
}

static enum hawser_status drag(struct hawser__reader *reader, double *normal, double *tangential,
                               const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "drag");
	char what[HAWSER__TOW_WHAT];
	enum hawser_status status;

	snprintf(what, sizeof what, "%.60s.drag", section);
	if (!one)
		return HAWSER_OK;
	status = hawser__tree_keys(reader, one, what, "tow.body.ring.drag");
	if (!status)
		status = hawser__tree_number_of(reader, normal, one, what, "normal", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	return status ? status : hawser__tree_number_of(reader, tangential, one, what, "tangential", "1",
	                                                HAWSER__TREE_NOT_NEGATIVE, 0);
}

static enum hawser_status shedding(struct hawser__reader *reader, struct hawser_tow_segment *to,
                                   const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "shedding");
	char what[HAWSER__TOW_WHAT];
	enum hawser_status status;

	if (!one)
		return HAWSER_OK;
	snprintf(what, sizeof what, "%.60s.shedding", section);
	if (!(to->diameter > 0.0))
		return hawser__reader_fail(reader, &one->at, "%s needs the diameter, which is not given", what);
	status = hawser__tree_keys(reader, one, what, "tow.cable.segments[].shedding");
	if (!status)
		status = hawser__tree_number_of(reader, &to->lift, one, what, "lift", "1",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	return status ? status : hawser__tree_number_of(reader, &to->strouhal, one, what, "strouhal", "1",
	                                                HAWSER__TREE_POSITIVE, 1);
}

/* EA, which may be .inf, and is where it is not given. */
static enum hawser_status stiffness(struct hawser__reader *reader, double *EA,
                                    const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *one = hawser__tree_find(tree, "EA");

	*EA = INFINITY;
	if (one && one->text && !strcmp(one->text, ".inf"))
		return HAWSER_OK;
	return hawser__tree_number_of(reader, EA, tree, section, "EA", "N", HAWSER__TREE_POSITIVE, 0);
}

static enum hawser_status segment(struct hawser__reader *reader, struct hawser_tow_segment *to,
                                  const struct hawser__tree *tree, const char *section)
{
	enum hawser_status status = hawser__tree_keys(reader, tree, section, "tow.cable.segments[]");

	if (!status)
		status = hawser__tree_number_of(reader, &to->length, tree, section, "length", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status)
		status = hawser__tree_number_of(reader, &to->rho, tree, section, "rho", "kg/m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (!status)
		status = hawser__tree_number_of(reader, &to->diameter, tree, section, "diameter", "m",
		                                HAWSER__TREE_NOT_NEGATIVE,
		                                hawser__tree_find(tree, "drag") != NULL);
	if (!status)
		status = stiffness(reader, &to->EA, tree, section);
	if (!status)
		status = hawser__tree_number_of(reader, &to->EI, tree, section, "EI", "N.m^2",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	for (int k = 0; k < 2 && !status; k++) /* without bending they have no effect */
		status = hawser__tree_number_of(reader, k ? &to->GA : &to->GJ, tree, section, k ? "GA" : "GJ",
		                                k ? "N" : "N.m^2", HAWSER__TREE_POSITIVE, 0);
	if (!status)
		status = whole(reader, &to->elements, tree, section, "elements", 1, ELEMENTS);
	if (!status)
		status = shedding(reader, to, tree, section);
	return status ? status : drag(reader, &to->normal, &to->tangential, tree, section);
}

enum hawser_status hawser__tow_cable(struct hawser__reader *reader, struct hawser_tow *tow,
                                     const struct hawser__tree *tree)
{
	const struct hawser__tree *list = tree ? hawser__tree_find(tree, "segments") : NULL;
	enum hawser_status status = tree ? hawser__tree_keys(reader, tree, "cable", "tow.cable")
	                                 : HAWSER_OK;

	if (status || !tree)
		return status;
	if (!list || list->kind != HAWSER__SEQUENCE || !list->children || list->children > MOST)
		return hawser__reader_fail(reader, list ? &list->at : &tree->at, "cable.segments must be a "
		                           "list of 1 to %d parts of the cable, such as [{length: 14 m, "
		                           "rho: 58 g/m, diameter: 8 mm, drag: {normal: 1.2}}]", MOST);
	tow->segment = calloc((size_t)list->children, sizeof *tow->segment);
	if (!tow->segment)
		return hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = list->child; one && !status; one = one->next) {
		char what[HAWSER__TOW_WHAT];

		snprintf(what, sizeof what, "cable.segments[%d]", tow->segments);
		status = segment(reader, &tow->segment[tow->segments++], one, what);
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
	const struct hawser__tree *wind = tree ? hawser__tree_find(tree, "wind") : NULL;
	enum hawser_status status = tree ? hawser__tree_keys(reader, tree, "air", "tow.air")
	                                 : HAWSER_OK;

	if (status || !tree)
		return status;
	if (!status)
		status = hawser__tree_number_of(reader, &tow->density, tree, "air", "density", "kg/m^3",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (!status && wind)
		status = hawser__tree_vector(reader, tow->wind, 3, wind, "air.wind", "m/s");
	if (!status)
		status = gusts(reader, tow, tree, wind);
	if (!status && wind && tow->density == 0.0 && (tow->wind[0] != 0.0 || tow->wind[1] != 0.0 ||
	                                       tow->wind[2] != 0.0))
		status = hawser__reader_fail(reader, &wind->at, "air.wind in air of density 0 has no "
		                             "effect: give the density, such as 1.2 kg/m^3, or no wind");
	return status;
}

static enum hawser_status ring(struct hawser__reader *reader, struct hawser_tow_body *body,
                               const struct hawser__tree *tree)
{
	enum hawser_status status = hawser__tree_keys(reader, tree, "body.ring", "tow.body.ring");

	body->kind = HAWSER_TOW_RING;
	if (!status)
		status = hawser__tree_number_of(reader, &body->ring.radius, tree, "body.ring", "radius", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status)
		status = hawser__tree_number_of(reader, &body->ring.drag.radius, tree, "body.ring", "tube", "m",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status && body->ring.drag.radius >= body->ring.radius)
		status = hawser__reader_fail(reader, &tree->at, "body.ring.tube, the radius of the tube, "
		                             "must be less than the radius of the ring");
	if (!status)
		status = hawser__tree_number_of(reader, &body->mass, tree, "body.ring", "mass", "kg",
		                                HAWSER__TREE_POSITIVE, 1);
	if (!status)
		status = hawser__tree_number_of(reader, &body->offset, tree, "body.ring", "offset", "m",
		                                HAWSER__TREE_NOT_NEGATIVE, 1);
	if (!status)
		status = whole(reader, &body->ring.segments, tree, "body.ring", "segments", 8, ELEMENTS);
	return status ? status : drag(reader, &body->ring.drag.normal, &body->ring.drag.tangential, tree,
	                              "body.ring");
}

/* How a ring is held by a cable with EI: a word, or {torsion: stiffness}. */
static enum hawser_status joint(struct hawser__reader *reader, struct hawser_tow_body *body,
                                const struct hawser__tree *tree)
{
	static const char *const words[] = {"clamped", "free"};
	const struct hawser__tree *one = hawser__tree_find(tree, "joint");
	enum hawser_status status;
	int word = 0;

	if (!one)
		return HAWSER_OK;
	if (!hawser__tree_find(tree, "ring"))
		return hawser__reader_fail(reader, &one->at, "body.joint is of a ring: a mass is a point, "
		                           "which has no attitude; leave it out");
	if (one->kind == HAWSER__MAPPING) {
		body->joint = HAWSER_TOW_SPRING;
		status = hawser__tree_keys(reader, one, "body.joint", "tow.body.joint");
		return status ? status : hawser__tree_number_of(reader, &body->torsion, one, "body.joint",
		                                                "torsion", "N.m/rad", HAWSER__TREE_POSITIVE, 1);
	}
	status = hawser__tree_word(reader, &word, one, "body.joint", words, 2);
	body->joint = word ? HAWSER_TOW_JOINT : HAWSER_TOW_CLAMPED;
	return status;
}

enum hawser_status hawser__tow_body(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *tree)
{
	struct hawser_tow_body *body = &tow->body;
	const struct hawser__tree *of_ring = tree ? hawser__tree_find(tree, "ring") : NULL;
	enum hawser_status status = HAWSER_OK;

	if (!tree)
		return status;
	status = hawser__tree_keys(reader, tree, "body", "tow.body");
	for (int k = 0; k < 3 && !status && of_ring; k++) {
		static const char *const key[] = {"mass", "CdA", "inertia"};
		const struct hawser__tree *one = hawser__tree_find(tree, key[k]);

		if (one)
			status = hawser__reader_fail(reader, &one->at, "body has ring and %s: a ring has its "
			                             "own mass, drag and inertia; remove one of them", key[k]);
	}
	if (!status)
		status = joint(reader, body, tree);
	if (status || of_ring)
		return status ? status : ring(reader, body, of_ring);
	body->kind = HAWSER_TOW_MASS;
	status = hawser__tree_number_of(reader, &body->mass, tree, "body", "mass", "kg",
	                                HAWSER__TREE_POSITIVE, 1);
	if (!status)
		status = hawser__tree_number_of(reader, &body->inertia, tree, "body", "inertia", "kg.m^2",
		                                HAWSER__TREE_NOT_NEGATIVE, 0);
	return status ? status : hawser__tree_number_of(reader, &body->CdA, tree, "body", "CdA", "m^2",
	                                                HAWSER__TREE_NOT_NEGATIVE, 0);
}

/* ropeway/read/obstacles_rows.c - the keys of spans over obstacles. See scene/tree_rows.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/obstacles.h>
#include "ropeway/read/read.h"
#include "scene/tree_rows.h"

#define SPAN_AT(member) offsetof(struct hawser_obstacles, member)
#define CIRCLE_AT(member) offsetof(struct hawser__round, member)

static const struct hawser__tree_key obstacles_rows[] = {
	HEAD("obstacles", "span", POSITIVE, SPAN_AT(line.g))
	SECTION("obstacles.cable", REQUIRED, "the cable")
	NUMBER("obstacles.cable.EA", REQUIRED, "N", POSITIVE_OR_INF, SPAN_AT(line.EA), NULL,
	       "axial stiffness; .inf: inextensible")
	NUMBER("obstacles.cable.rho", REQUIRED, "kg/m", POSITIVE, SPAN_AT(line.rho), NULL,
	       "mass per unstretched length")
	INTEGER("obstacles.cable.elements", MESH, 1, 1000000, NOWHERE, "200",
	        "number of elements, with planes or segments")
	SECTION("obstacles.span", REQUIRED, "the positions of the ends")
	NUMBER("obstacles.span.d", REQUIRED, "m", POSITIVE, SPAN_AT(line.B[0]), NULL,
	       "horizontal distance of the ends")
	NUMBER("obstacles.span.h", REQUIRED, "m", ANY, SPAN_AT(line.B[1]), NULL,
	       "height of end B above end A")
	SECTION("obstacles.tension", REQUIRED, "what fixes the tension")
	CHOICE("obstacles.tension.T0", "N", SPAN_AT(line.value), SPAN_AT(line.given), "tension at end A")
	CHOICE("obstacles.tension.T1", "N", SPAN_AT(line.value), SPAN_AT(line.given), "tension at end B")
	CHOICE("obstacles.tension.length0", "m", SPAN_AT(line.value), SPAN_AT(line.given),
	       "unstretched length")
	LIST("obstacles.obstacles", REQUIRED, "circles in the order of x")
	MAPPING("obstacles.obstacles[]", OPTIONAL, "an obstacle")
	TEXT("obstacles.obstacles[].name", OPTIONAL, NOWHERE, "s0, s1 and so on", "name")
	CIRCLE("obstacles.obstacles[].circle", ONE_OF, NOWHERE, CIRCLE_AT(sheave.centre),
	       CIRCLE_AT(sheave.radius))
	MAPPING("obstacles.obstacles[].plane", MESH, "a plane")
	VECTOR("obstacles.obstacles[].plane.point", 3, REQUIRED, "m", ANY, NOWHERE, NULL,
	       "a point of it")
	VECTOR("obstacles.obstacles[].plane.point", 2, REQUIRED, "m", ANY, NOWHERE, NULL,
	       "a point of it, z = 0")
	VECTOR("obstacles.obstacles[].plane.normal", 3, REQUIRED, "1", ANY, NOWHERE, NULL,
	       "normal towards the net")
	VECTOR("obstacles.obstacles[].plane.normal", 2, REQUIRED, "1", ANY, NOWHERE, NULL,
	       "normal towards the net")
	MAPPING("obstacles.obstacles[].segment", MESH, "a segment, which extends along z")
	VECTOR("obstacles.obstacles[].segment.from", 2, REQUIRED, "m", ANY, NOWHERE, NULL,
	       "[x, y] of its first end")
	VECTOR("obstacles.obstacles[].segment.to", 2, REQUIRED, "m", ANY, NOWHERE, NULL,
	       "[x, y] of its last end")
	WORD("obstacles.obstacles[].side", OPTIONAL, "above|below", CIRCLE_AT(side), "above",
	     "side where the rope passes")
	NUMBER("obstacles.obstacles[].friction", OPTIONAL, "1", NOT_NEGATIVE, CIRCLE_AT(of.friction), "0",
	       "coefficient of friction")
	WORD("obstacles.obstacles[].groove", OPTIONAL, "no|yes", CIRCLE_AT(of.groove), "yes",
	     "whether a groove holds the rope in the vertical plane")
	WORD("obstacles.obstacles[].rotation", OPTIONAL, "locked|free|drive", CIRCLE_AT(of.rotation),
	     "locked", "how it turns: free without resistance, so that friction does not change the "
	     "tensions; drive: a motor holds or turns it, as locked for statics and modes")
	NUMBER("obstacles.obstacles[].inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE,
	       CIRCLE_AT(sheave.inertia), NULL,
	       "moment of inertia of a circle that turns with the rope, in modes")
	SECTION("obstacles.contact", OPTIONAL, "contact with the obstacles")
	WORD("obstacles.contact.sliding", OPTIONAL, "none|toward-A|toward-B|history",
	     SPAN_AT(line.sliding), "none", "which way the rope slides over all circles that are not free")
	LIST("obstacles.contact.path", OPTIONAL,
	     "with history: values that the given tension or length had before its own one")
	NUMBER("obstacles.contact.path[]", OPTIONAL, NULL, POSITIVE, NOWHERE, NULL,
	       "a value, in the unit of what is given")
	WORD("obstacles.contact.winch", OPTIONAL, "A|B", SPAN_AT(winch), "A, with T1 B",
	     "with history: end at which the rope is paid in and out; with T0 it is A, with T1 B")
	WORD("obstacles.contact.modes", OPTIONAL, "slip|stick", SPAN_AT(modes),
	     "slip if no touched circle has friction or if the rope slides, else stick",
	     "what the rope does on the circles as it vibrates: it slides without resistance; or points in "
	     "contact do not move, or turn with a circle that is free")
	NUMBER("obstacles.contact.restitution", OPTIONAL, "1", NOT_NEGATIVE, NOWHERE, NULL,
	       "of impacts; only 0 yet")
};

const struct hawser__tree_table hawser__tree_of_obstacles = {
	"obstacles", "A span over obstacles", obstacles_rows, sizeof obstacles_rows/sizeof *obstacles_rows,
	NULL, {"obstacles", "contact"}};

/* ropeway/read/ropeway_rows.c - the keys of scenes of kind `ropeway`. See scene/tree_rows.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/ropeway.h>
#include "scene/tree_rows.h"

#define RW_AT(member) offsetof(struct hawser_ropeway, member)
#define TOWER_AT(member) offsetof(struct hawser_ropeway_tower, member)

#define LANES(path, at) \
	BOTH(path, REQUIRED, "kg", NOT_NEGATIVE, at, NULL, "mass of a carrier, of both lanes; 0: none") \
	SECTION(path, REQUIRED, "mass of a carrier of each lane") \
	NUMBER(path ".up", REQUIRED, "kg", NOT_NEGATIVE, at, NULL, "of the lane to the top station") \
	NUMBER(path ".down", REQUIRED, "kg", NOT_NEGATIVE, at + sizeof(double), NULL, \
	       "of the lane to the bottom station")
#define TENSION(key, unit, doc) \
	CHOICE("ropeway.ropeway.bottom.tension." key, unit, RW_AT(value), RW_AT(tension), doc)

static const struct hawser__tree_key ropeway_rows[] = {
	HEAD("ropeway", "ropeway", POSITIVE, RW_AT(g))
	SECTION("ropeway.ropeway", REQUIRED, "the hauling rope of a ropeway, with two lanes")
	SECTION("ropeway.ropeway.rope", REQUIRED, "the rope")
	NUMBER("ropeway.ropeway.rope.EA", REQUIRED, "N", POSITIVE, RW_AT(EA), NULL, "axial stiffness")
	NUMBER("ropeway.ropeway.rope.rho", REQUIRED, "kg/m", POSITIVE, RW_AT(rho), NULL,
	       "mass per unstretched length")
	SECTION("ropeway.ropeway.bottom", REQUIRED, "the bottom station")
	VECTOR("ropeway.ropeway.bottom.at", 2, REQUIRED, "m", ANY, RW_AT(bottom), NULL,
	       "[x, y] where the rope leaves it")
	NUMBER("ropeway.ropeway.bottom.radius", REQUIRED, "m", NOT_NEGATIVE, RW_AT(bottom_radius), NULL,
	       "radius of its bullwheel")
	SECTION("ropeway.ropeway.bottom.tension", REQUIRED, "what gives the rope its tension")
	TENSION("counterweight", "N", "force on the carriage, which both lanes carry: the tension of a "
	        "lane is half of it, and rho v^2 more if the rope runs")
	TENSION("T0", "N", "tension of each lane")
	TENSION("length0", "m", "unstretched length of the loop; the carriage is fixed")
	TENSION("T_empty", "N", "tension of the rope without carriers, at rest; the carriage is fixed")
	VECTOR("ropeway.ropeway.bottom.tension.travel", 2, OPTIONAL, "m", ANY, RW_AT(travel), NULL,
	       "stops of a carriage that moves, from its place with the empty rope, positive towards the "
	       "line")
	NUMBER("ropeway.ropeway.bottom.mass", OPTIONAL, "kg", NOT_NEGATIVE, RW_AT(carriage), NULL,
	       "of the carriage and of what moves with it; without it the carriage does not vibrate")
	NUMBER("ropeway.ropeway.bottom.friction", OPTIONAL, "1", NOT_NEGATIVE, RW_AT(bottom_friction),
	       "0", "resistance of the bullwheel as a part of the force on it, below 1")
	NUMBER("ropeway.ropeway.bottom.inertia", OPTIONAL, "kg m2", NOT_NEGATIVE, RW_AT(bottom_inertia),
	       "0", "moment of inertia of the bullwheel")
	SECTION("ropeway.ropeway.top", REQUIRED, "the top station")
	VECTOR("ropeway.ropeway.top.at", 2, REQUIRED, "m", ANY, RW_AT(top), NULL,
	       "[x, y] where the rope leaves it")
	NUMBER("ropeway.ropeway.top.radius", REQUIRED, "m", NOT_NEGATIVE, RW_AT(top_radius), NULL,
	       "radius of its bullwheel")
	SECTION("ropeway.ropeway.top.drive", OPTIONAL, "its drive")
	NUMBER("ropeway.ropeway.top.drive.speed", OPTIONAL, "m/s", NOT_NEGATIVE, RW_AT(speed), "0",
	       "speed of the rope")
	NUMBER("ropeway.ropeway.top.drive.friction", OPTIONAL, "1", NOT_NEGATIVE, RW_AT(drive_friction),
	       NULL, "coefficient of friction of the rope on the bullwheel")
	NUMBER("ropeway.ropeway.top.drive.ramp", OPTIONAL, "s", NOT_NEGATIVE, RW_AT(ramp), NULL,
	       "time of a start")
	NUMBER("ropeway.ropeway.top.drive.wrap", OPTIONAL, "rad", POSITIVE, RW_AT(wrap), "pi",
	       "wrap of the rope")
	NUMBER("ropeway.ropeway.top.drive.inertia", OPTIONAL, "kg m2", NOT_NEGATIVE, RW_AT(top_inertia),
	       NULL, "moment of inertia of the bullwheel with its drive; without it, it keeps its speed as "
	       "the rope vibrates")
	NUMBER("ropeway.ropeway.top.drive.force", OPTIONAL, "N", POSITIVE, RW_AT(drive_most), NULL,
	       "largest force of the drive at the circumference of the bullwheel")
	SECTION("ropeway.ropeway.top.drive.brake", OPTIONAL, "how it brakes: one of")
	NUMBER("ropeway.ropeway.top.drive.brake.deceleration", OPTIONAL, "m/s^2", POSITIVE, RW_AT(brake),
	       NULL, "deceleration of the rope, of a brake that is controlled")
	NUMBER("ropeway.ropeway.top.drive.brake.force", OPTIONAL, "N", POSITIVE, RW_AT(brake_force), NULL,
	       "force at the circumference, of one that is applied")
	LIST("ropeway.ropeway.towers", OPTIONAL, "towers in the order of x")
	MAPPING("ropeway.ropeway.towers[]", OPTIONAL, "a tower")
	TEXT("ropeway.ropeway.towers[].name", OPTIONAL, NOWHERE, "p0, p1 and so on", "name")
	VECTOR("ropeway.ropeway.towers[].at", 2, REQUIRED, "m", ANY, TOWER_AT(at), NULL,
	       "[x, y] of the summit of its battery: the highest point of the circle of a support battery, "
	       "which is below the rope, and the lowest of a compression battery")
	WORD("ropeway.ropeway.towers[].battery", OPTIONAL, "auto|support|compression", TOWER_AT(battery),
	     "auto", "side of the sheaves; auto: by the reaction of catenaries that are joined at the "
	     "summits and carry the loaded carriers of lane up as weight per length")
	NUMBER("ropeway.ropeway.towers[].radius", REQUIRED, "m", NOT_NEGATIVE, TOWER_AT(radius), NULL,
	       "radius of the circle of its battery; 0: a point")
	LIMITED("ropeway.ropeway.towers[].friction", OPTIONAL, "1", NOT_NEGATIVE, 10.0,
	        TOWER_AT(friction), "0",
	        "coefficient of friction of the rope, such as 0.03, and no per cent")
	SECTION("ropeway.ropeway.towers[].sheaves", OPTIONAL,
	        "a train of sheaves in place of the circle, which they touch from within, in the middle of "
	        "the rope's contact; they are fixed, and the rope may pass the outer ones without contact")
	INTEGER("ropeway.ropeway.towers[].sheaves.count", REQUIRED, 1, 100, TOWER_AT(sheaves), NULL,
	        "number of sheaves")
	NUMBER("ropeway.ropeway.towers[].sheaves.spacing", REQUIRED, "m", POSITIVE, TOWER_AT(spacing),
	       NULL, "distance along the circle")
	NUMBER("ropeway.ropeway.towers[].sheaves.radius", REQUIRED, "m", NOT_NEGATIVE, TOWER_AT(sheave),
	       NULL, "radius of a sheave")
	NUMBER("ropeway.ropeway.towers[].inertia", OPTIONAL, "kg m2", NOT_NEGATIVE, TOWER_AT(inertia),
	       "0", "moment of inertia of a sheave, for modes of sheaves that roll; that of a circle of "
	       "radius R for n sheaves of radius r and inertia J is n J R^2/r^2")
	SECTION("ropeway.ropeway.carriers", OPTIONAL, "chairs or cabins")
	NUMBER("ropeway.ropeway.carriers.spacing", REQUIRED, "m", POSITIVE, RW_AT(spacing), NULL,
	       "unstretched distance")
	LANES("ropeway.ropeway.carriers.mass", RW_AT(mass))
	NUMBER("ropeway.ropeway.carriers.empty", OPTIONAL, "kg", NOT_NEGATIVE, RW_AT(empty), "0",
	       "mass of an empty one")
	WORD("ropeway.ropeway.carriers.phase", OPTIONAL, "sweep", CHECKED, NULL,
	     "worst values over a spacing")
	NUMBER("ropeway.ropeway.carriers.phase", OPTIONAL, "m", ANY, RW_AT(phase), "0",
	       "distance of the first of lane up from the bottom station")
	NUMBER("ropeway.ropeway.carriers.phase_down", OPTIONAL, "m", ANY, RW_AT(phase_down),
	       "spacing minus phase", "that of the first of lane down; they move in opposite directions")
	HANGER("ropeway.ropeway.carriers.hanger", RW_AT(hanger))
	WORD("ropeway.ropeway.down", OPTIONAL, "off|on", RW_AT(lanes), "on", "off leaves lane down out")
	WORD("ropeway.ropeway.sliding", OPTIONAL, "running|rest|reverse", RW_AT(sliding), "running",
	     "which way friction acts on the sheaves: against the rope that moves as the drive pulls it; "
	     "at rest none acts, and tensions that it could hold are reported; or the other way")
	LIST("ropeway.ropeway.cases", OPTIONAL,
	     "load cases besides full; without them empty, up (loaded up, empty down) and down")
	MAPPING("ropeway.ropeway.cases[]", OPTIONAL, "a load case")
	TEXT("ropeway.ropeway.cases[].name", REQUIRED, NOWHERE, NULL, "name")
	LANES("ropeway.ropeway.cases[].mass", offsetof(struct hawser_ropeway_case, mass))
	SECTION("ropeway.contact", OPTIONAL, "contact in vibrations")
	WORD("ropeway.contact.modes", OPTIONAL, "auto|slip|stick|roll", RW_AT(hold), "auto",
	     "what the rope does on the sheaves as it vibrates; auto: it slips if it runs (drive.speed is "
	     "above 0 and sliding is not rest), and sticks if it is at rest")
};

const struct hawser__tree_table hawser__tree_of_ropeway = {
	"ropeway", "A ropeway", ropeway_rows, sizeof ropeway_rows/sizeof *ropeway_rows,
	"ropeway", {"ropeway"}};

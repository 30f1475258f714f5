/* tow/tow_rows.c - the keys of scenes of towed bodies. See scene/tree_rows.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/tree_rows.h"
#include "tow/read.h"

#define TOW_AT(member) offsetof(struct hawser_tow, member)
#define FLIGHT_AT(member) offsetof(struct hawser__tow_flight, member)
#define PART_AT(member) offsetof(struct hawser_tow_segment, member)
#define TOW_WINCH_AT(member) offsetof(struct hawser_rod_winch, member)
#define POINT_AT(member) offsetof(struct hawser_waypoint, member)

#define DERIVATIVES(path) \
	VECTOR(path ".velocity", 3, OPTIONAL, "m/s", ANY, POINT_AT(at[1]), NULL, "velocity there") \
	VECTOR(path ".acceleration", 3, OPTIONAL, "m/s^2", ANY, POINT_AT(at[2]), NULL, \
	       "acceleration there") \
	VECTOR(path ".jerk", 3, OPTIONAL, "m/s^3", ANY, POINT_AT(at[3]), NULL, \
	       "third derivative there") \
	VECTOR(path ".snap", 3, OPTIONAL, "m/s^4", ANY, POINT_AT(at[4]), NULL, "fourth derivative there")
#define ORDERS "velocity|acceleration|jerk|snap"
#define END(path) \
	LIST(path, OPTIONAL, "derivatives that are 0 there") \
	WORD(path "[]", OPTIONAL, ORDERS, NOWHERE, NULL, "a derivative that is 0") \
	MAPPING(path, OPTIONAL, "derivatives that are given there") \
	DERIVATIVES(path)

static const struct hawser__tree_key tow_rows[] = {
	HEAD("tow", "tow", POSITIVE, TOW_AT(g))
	MAPPING("tow.tow", REQUIRED, "the path of the towing point")
	LIST("tow.tow.waypoints", ONE_OF, "at least two waypoints in the order of time")
	VECTOR("tow.tow.waypoints[]", 4, OPTIONAL, "s, m, m, m", ANY, NOWHERE, NULL, "[t, x, y, z]")
	MAPPING("tow.tow.waypoints[]", OPTIONAL, "a waypoint with derivatives")
	NUMBER("tow.tow.waypoints[].t", REQUIRED, "s", ANY, POINT_AT(t), NULL, "time")
	VECTOR("tow.tow.waypoints[].at", 3, REQUIRED, "m", ANY, POINT_AT(at[0]), NULL, "place")
	DERIVATIVES("tow.tow.waypoints[]")
	INTEGER("tow.tow.waypoints[].flat", OPTIONAL, 0, HAWSER_PATH_GIVEN - 1, NOWHERE, NULL,
	        "order up to which derivatives that are not given are 0")
	TEXT("tow.tow.file", ONE_OF, NOWHERE, NULL, "text file of lines t x y z (s, m), # begins a "
	     "comment; with a first line of column names, t_s x_m y_m z_m among them, it may have more "
	     "columns, as the tables of hawser-trajectory(1)")
	NUMBER("tow.tow.speed", ONE_OF, "m/s", ANY, FLIGHT_AT(velocity), NULL,
	       "straight flight, along x")
	VECTOR("tow.tow.speed", 3, ONE_OF, "m/s", ANY, FLIGHT_AT(velocity), NULL,
	       "straight flight: its velocity")
	SECTION("tow.tow.orbit", ONE_OF, "a horizontal circle, from centre + [radius, 0, 0] on")
	NUMBER("tow.tow.orbit.radius", REQUIRED, "m", POSITIVE, FLIGHT_AT(radius), NULL, "its radius")
	NUMBER("tow.tow.orbit.speed", REQUIRED, "m/s", ANY, FLIGHT_AT(speed), NULL,
	       "positive from x toward z, clockwise from above")
	VECTOR("tow.tow.orbit.centre", 3, OPTIONAL, "m", ANY, FLIGHT_AT(centre), "[0, 0, 0]",
	       "its centre")
	WORD("tow.tow.minimise", OPTIONAL, "snap|jerk|acceleration|none", FLIGHT_AT(minimise), "snap",
	     "whose squared integral is least over all paths through the waypoints")
	LIST("tow.tow.ends", OPTIONAL, "derivatives that are 0 at both ends")
	WORD("tow.tow.ends[]", OPTIONAL, ORDERS, NOWHERE, NULL, "a derivative that is 0")
	MAPPING("tow.tow.ends", OPTIONAL, "what is given at the ends; all else is free")
	END("tow.tow.ends.start")
	END("tow.tow.ends.end")
	VECTOR("tow.tow.start", 3, OPTIONAL, "m", ANY, FLIGHT_AT(start), "[0, 0, 0]",
	       "begin of straight flight")
	NUMBER("tow.tow.ramp", OPTIONAL, "s", NOT_NEGATIVE, FLIGHT_AT(ramp), "0",
	       "time in which the speed of straight flight or an orbit grows from 0")
	WORD("tow.tow.law", OPTIONAL, "smooth|erf", FLIGHT_AT(law), "smooth",
	     "how it grows: derivatives up to snap are continuous, or as (1 - erf(6 - 12 "
	     "(t/ramp)^0.6))/2")
	WORD("tow.tow.hinge", OPTIONAL, "free|clamped", FLIGHT_AT(clamped), "free",
	     "of a cable with EI, at the towing point, which it leaves downwards if clamped")
	MAPPING("tow.cable", OPTIONAL, "the cable")
	LIST("tow.cable.segments", REQUIRED, "its parts from the towing point on")
	MAPPING("tow.cable.segments[]", OPTIONAL, "a part")
	NUMBER("tow.cable.segments[].length", REQUIRED, "m", POSITIVE, PART_AT(length), NULL,
	       "unstretched length")
	NUMBER("tow.cable.segments[].EA", OPTIONAL, "N", POSITIVE_OR_INF, PART_AT(EA), ".inf",
	       "axial stiffness")
	NUMBER("tow.cable.segments[].EI", OPTIONAL, "N.m^2", NOT_NEGATIVE, PART_AT(EI), "0",
	       "bending stiffness; 0: a string")
	NUMBER("tow.cable.segments[].GJ", OPTIONAL, "N.m^2", POSITIVE, PART_AT(GJ), "that of EI",
	       "torsional stiffness of a cable with EI")
	NUMBER("tow.cable.segments[].GA", OPTIONAL, "N", POSITIVE, PART_AT(GA), "no shear",
	       "shear stiffness of a cable with EI")
	NUMBER("tow.cable.segments[].rho", REQUIRED, "kg/m", NOT_NEGATIVE, PART_AT(rho), NULL,
	       "mass per length")
	NUMBER("tow.cable.segments[].diameter", OPTIONAL, "m", NOT_NEGATIVE, PART_AT(diameter), NULL,
	       "diameter, of the drag")
	INTEGER("tow.cable.segments[].elements", OPTIONAL, 1, 100000, PART_AT(elements), "100",
	        "number of elements")
	DRAG("tow.cable.segments[].drag", OPTIONAL, PART_AT(normal), PART_AT(tangential))
	ADDED_MASS("tow.cable.segments[].added_mass", PART_AT(added_normal), PART_AT(added_tangential))
	SECTION("tow.cable.segments[].shedding", OPTIONAL, "lift of shed vortices, in motions")
	NUMBER("tow.cable.segments[].shedding.lift", REQUIRED, "1", NOT_NEGATIVE, PART_AT(lift), NULL,
	       "lift coefficient")
	NUMBER("tow.cable.segments[].shedding.strouhal", REQUIRED, "1", POSITIVE, PART_AT(strouhal),
	       NULL, "Strouhal number")
	SECTION("tow.air", OPTIONAL, "the air")
	NUMBER("tow.air.density", REQUIRED, "kg/m^3", NOT_NEGATIVE, TOW_AT(density), NULL, "density")
	VECTOR("tow.air.wind", 3, OPTIONAL, "m/s", ANY, TOW_AT(wind), "[0, 0, 0]",
	       "velocity of the wind")
	TEXT("tow.air.file", OPTIONAL, NOWHERE, NULL, "a file of the wind over time, in place of wind: "
	     "lines t wx wy wz (s, m/s), linear between; a steady state has that of the first line")
	WATER("tow.water", TOW_AT)
	WINCH("tow.winch", TOW_WINCH_AT)
	SECTION("tow.body", OPTIONAL, "what is towed; without it the end is free")
	SECTION("tow.body.ring", OPTIONAL, "a ring")
	NUMBER("tow.body.ring.radius", REQUIRED, "m", POSITIVE, TOW_AT(body.ring.radius), NULL,
	       "radius of the ring")
	NUMBER("tow.body.ring.tube", REQUIRED, "m", POSITIVE, TOW_AT(body.ring.drag.radius), NULL,
	       "radius of its tube")
	NUMBER("tow.body.ring.mass", REQUIRED, "kg", POSITIVE, TOW_AT(body.mass), NULL, "mass")
	NUMBER("tow.body.ring.offset", REQUIRED, "m", NOT_NEGATIVE, TOW_AT(body.offset), NULL,
	       "distance of its centre from the end of the cable")
	INTEGER("tow.body.ring.segments", OPTIONAL, 8, 100000, TOW_AT(body.ring.segments), "32",
	        "number of parts of its drag")
	DRAG("tow.body.ring.drag", OPTIONAL, TOW_AT(body.ring.drag.normal),
	     TOW_AT(body.ring.drag.tangential))
	NUMBER("tow.body.mass", OPTIONAL, "kg", POSITIVE, TOW_AT(body.mass), NULL,
	       "of a point, in place of a ring")
	NUMBER("tow.body.CdA", OPTIONAL, "m^2", NOT_NEGATIVE, TOW_AT(body.CdA), "0",
	       "drag coefficient times area")
	NUMBER("tow.body.volume", OPTIONAL, "m^3", NOT_NEGATIVE, TOW_AT(body.volume), "0",
	       "of a point in water: volume of the water that it displaces")
	NUMBER("tow.body.added_mass", OPTIONAL, "1", NOT_NEGATIVE, TOW_AT(body.added), "0",
	       "of a point in water: added mass over that of the water that is displaced")
	NUMBER("tow.body.inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE, TOW_AT(body.inertia), "0",
	       "of a point, about any axis; steady states do not depend on it")
	WORD("tow.body.joint", OPTIONAL, "clamped|free", TOW_AT(body.joint), "clamped",
	     "of a ring, with a cable with EI: clamped to the end of the cable, or a joint")
	SECTION("tow.body.joint", OPTIONAL, "a spring between the ring and the end of the cable")
	NUMBER("tow.body.joint.torsion", REQUIRED, "N.m/rad", POSITIVE, TOW_AT(body.torsion), NULL,
	       "moment over angle")
};

const struct hawser__tree_table hawser__tree_of_tow = {
	"tow", "A towed body", tow_rows, sizeof tow_rows/sizeof *tow_rows, "tow", {"tow"}};

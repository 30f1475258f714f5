/* rod/rod_rows.c - the keys of scenes of kind `rod`. See scene/tree_rows.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/rod.h>
#include "scene/tree_rows.h"

#define ROD_AT(member) offsetof(struct hawser_rod, member)
#define SEGMENT_AT(member) offsetof(struct hawser_rod_segment, member)
#define ROD_WINCH_AT(member) offsetof(struct hawser_rod_winch, member)

#define ROD_SEGMENT(path) \
	NUMBER(path ".length", REQUIRED, "m", POSITIVE, SEGMENT_AT(length), NULL, "unstretched length") \
	NUMBER(path ".EA", REQUIRED, "N", POSITIVE, SEGMENT_AT(EA), NULL, "axial stiffness") \
	BOTH(path ".GA", REQUIRED, "N", POSITIVE, SEGMENT_AT(GA), NULL, \
	     "shear stiffness, with the shear factor") \
	VECTOR(path ".GA", 2, REQUIRED, "N", POSITIVE, SEGMENT_AT(GA), NULL, \
	       "shear stiffnesses along e2 and e3") \
	BOTH(path ".EI", REQUIRED, "N.m^2", POSITIVE, SEGMENT_AT(EI), NULL, "bending stiffness") \
	VECTOR(path ".EI", 2, REQUIRED, "N.m^2", POSITIVE, SEGMENT_AT(EI), NULL, \
	       "bending stiffnesses about e2 and e3") \
	NUMBER(path ".GJ", REQUIRED, "N.m^2", POSITIVE, SEGMENT_AT(GJ), NULL, "torsional stiffness") \
	NUMBER(path ".rho", REQUIRED, "kg/m", NOT_NEGATIVE, SEGMENT_AT(rho), NULL, \
	       "mass per length; 0: without weight") \
	VECTOR(path ".curvature", 3, OPTIONAL, "m^-1", ANY, SEGMENT_AT(curvature), NULL, \
	       "at rest: [twist, about e2, about e3]") \
	VECTOR(path ".inertia", 3, OPTIONAL, "kg.m", POSITIVE, SEGMENT_AT(inertia), NULL, \
	       "of rotation per length, about e1, e2, e3; for motions") \
	LINE_IN_WATER(path, SEGMENT_AT) \
	INTEGER(path ".elements", OPTIONAL, 1, 100000, SEGMENT_AT(elements), "20", "number of elements")
#define PLACE(path, given, doc) \
	WORD(path, OPTIONAL, "start|end", NOWHERE, given, doc) \
	NUMBER(path, OPTIONAL, "m", NOT_NEGATIVE, NOWHERE, given, doc ": a length from the start")
#define HELD(path, of, given) \
	WORD(path ".hold", OPTIONAL, "clamped|hinged|free", ROD_AT(hold[of]), given, \
	     "how it is held: its place and axes, its place, or not at all")
#define DRIVE(name, of) \
	SECTION(name ".spin", OPTIONAL, "the end is turned about its place, in motions") \
	VECTOR(name ".spin.axis", 3, REQUIRED, "1", ANY, ROD_AT(drive[of].axis), NULL, \
	       "direction of the axis") \
	NUMBER(name ".spin.speed", REQUIRED, "rad/s", ANY, ROD_AT(drive[of].speed), NULL, \
	       "angular velocity") \
	NUMBER(name ".spin.rise", OPTIONAL, "s", NOT_NEGATIVE, ROD_AT(drive[of].rise), "0", \
	       "time in which it grows from 0") \
	TEXT(name ".path", OPTIONAL, ROD_AT(drive[of].path), NULL, \
	     "the end is moved: file of rows t x y z (s, m), in motions")
#define AXES(path, tangent, normal, given) \
	VECTOR(path ".tangent", 3, OPTIONAL, "1", ANY, tangent, given, "direction of e1 there") \
	VECTOR(path ".normal", 3, OPTIONAL, "1", ANY, normal, NULL, \
	       "direction whose part across the tangent is e2; without it upwards")

static const struct hawser__tree_key rod_rows[] = {
	HEAD("rod", "rod", NOT_NEGATIVE, ROD_AT(g))
	MAPPING("rod.rod", REQUIRED, "one segment")
	ROD_SEGMENT("rod.rod")
	LIST("rod.rod", REQUIRED, "segments from the start on")
	MAPPING("rod.rod[]", OPTIONAL, "a segment")
	ROD_SEGMENT("rod.rod[]")
	SECTION("rod.start", OPTIONAL, "the first end")
	VECTOR("rod.start.at", 3, OPTIONAL, "m", ANY, ROD_AT(at), "[0, 0, 0]", "its place")
	AXES("rod.start", ROD_AT(tangent), ROD_AT(normal), "[1, 0, 0]")
	HELD("rod.start", 0, "clamped")
	DRIVE("rod.start", 0)
	WINCH("rod.start.winch", ROD_WINCH_AT)
	SECTION("rod.end", OPTIONAL, "the last end")
	VECTOR("rod.end.at", 3, OPTIONAL, "m", ANY, ROD_AT(end_at), NULL,
	       "the place to which it is brought")
	AXES("rod.end", ROD_AT(end_tangent), ROD_AT(end_normal), NULL)
	HELD("rod.end", 1, "free")
	DRIVE("rod.end", 1)
	LIST("rod.loads", OPTIONAL, "loads at points, or per length")
	MAPPING("rod.loads[]", OPTIONAL, "a load")
	PLACE("rod.loads[].at", NULL, "point of the load")
	PLACE("rod.loads[].from", "start", "begin of a load per length")
	PLACE("rod.loads[].to", "end", "end of a load per length")
	VECTOR("rod.loads[].force", 3, OPTIONAL, "N, or N/m", ANY, NOWHERE, NULL,
	       "force; per length without at")
	VECTOR("rod.loads[].moment", 3, OPTIONAL, "N.m, or N", ANY, NOWHERE, NULL,
	       "moment; per length without at")
	WORD("rod.loads[].frame", OPTIONAL, "fixed|follower", offsetof(struct hawser_rod_load, follower),
	     "fixed", "axes: x, y, z, or e1, e2, e3 of the section, with which the load turns")
	LIST("rod.loads[].factor", OPTIONAL,
	     "its history in motions: [time, factor], linear between; two at one time: a jump")
	VECTOR("rod.loads[].factor[]", 2, OPTIONAL, "s, 1", ANY, NOWHERE, NULL, "[time, factor]")
	WATER("rod.water", ROD_AT)
	SECTION("rod.damping", OPTIONAL, "damping, of motions")
	NUMBER("rod.damping.alpha", REQUIRED, "s^-1", NOT_NEGATIVE, ROD_AT(alpha), NULL,
	       "damping force per mass and velocity, and moment per inertia and angular velocity")
	SECTION("rod.dynamics", OPTIONAL, "time integration")
	LIMITED("rod.dynamics.rho_inf", OPTIONAL, "1", NOT_NEGATIVE, 1.0, ROD_AT(rho_inf), "0.8",
	        "0 (what is faster than the step is damped) to 1 (nothing is)")
	NUMBER("rod.dynamics.step", OPTIONAL, "s", POSITIVE, ROD_AT(step), NULL, "step in time")
	WORD("rod.dynamics.from", OPTIONAL, "equilibrium|rest", ROD_AT(from_rest), "equilibrium",
	     "first state: the equilibrium of a held rod, or the unloaded shape")
};

const struct hawser__tree_table hawser__tree_of_rod = {
	"rod", "A geometrically exact rod", rod_rows, sizeof rod_rows/sizeof *rod_rows,
	"rod", {"rod"}};

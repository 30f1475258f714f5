/* scene/tree_rows.c - the table of keys of scenes whose names are the user's: nets, ropeways, spans
 * over obstacles, rods, towed bodies.
 *
 * A path is the kind of the scene and the keys down to the value; [] is an item of a list, * a name
 * of the user, ** one of another sort in the same mapping. Rows of one path are other forms of its
 * value. The readers take from this table which keys a mapping may have (hawser__tree_keys), in
 * this order; `hawser schema` writes all of it. Numbers are read by the readers; a test compares
 * the units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "scene/tree_keys.h"

#define ANY HAWSER__TREE_ANY
#define POSITIVE HAWSER__TREE_POSITIVE
#define NOT_NEGATIVE HAWSER__TREE_NOT_NEGATIVE
#define OPTIONAL HAWSER__TREE_OPTIONAL
#define REQUIRED HAWSER__TREE_REQUIRED
#define ONE_OF HAWSER__TREE_ONE_OF
#define LATER HAWSER__TREE_LATER
#define MESH HAWSER__TREE_MESH

#define NUMBER(path, need, unit, range, doc) {path, HAWSER__TREE_NUMBER, 0, unit, range, need, doc},
#define INTEGER(path, need, doc) {path, HAWSER__TREE_INTEGER, 0, "1", POSITIVE, need, doc},
#define VECTOR(path, count, need, unit, range, doc) \
	{path, HAWSER__TREE_NUMBER, count, unit, range, need, doc},
#define WORD(path, need, words, doc) {path, HAWSER__TREE_WORD, 0, words, ANY, need, doc},
#define TEXT(path, need, doc) {path, HAWSER__TREE_TEXT, 0, "", ANY, need, doc},
#define MAPPING(path, need, doc) {path, HAWSER__TREE_MAPPING, 0, "", ANY, need, doc},
#define LIST(path, need, doc) {path, HAWSER__TREE_LIST, 0, "", ANY, need, doc},

/* What several kinds have. */
#define HEAD(kind, range) \
	WORD(kind ".kind", OPTIONAL, kind, "kind of the scene") \
	NUMBER(kind ".g", OPTIONAL, "m/s^2", range, "acceleration of gravity, downwards (9.81)")
#define DRAG(path) \
	MAPPING(path, OPTIONAL, "coefficients of the drag of air") \
	NUMBER(path ".normal", REQUIRED, "1", NOT_NEGATIVE, \
	       "across the axis, referred to the diameter") \
	NUMBER(path ".tangential", OPTIONAL, "1", NOT_NEGATIVE, "along it, referred to the surface (0)")
#define WAVE(path) \
	NUMBER(path ".Omega", REQUIRED, "rad/s", POSITIVE, "angular frequency") \
	NUMBER(path ".phase", OPTIONAL, "rad", ANY, "phase (0)")
#define LOAD_OF_NODE(path) \
	VECTOR(path ".force", 3, REQUIRED, "N", ANY, "force along x, y, z") \
	MAPPING(path ".harmonic", OPTIONAL, "its time function") \
	WAVE(path ".harmonic")
#define LOAD_OF_CABLE(path) \
	VECTOR(path ".per_length", 3, REQUIRED, "N/m", ANY, \
	       "force per unstretched length along x, y, z") \
	MAPPING(path ".harmonic", OPTIONAL, "its time function") \
	WAVE(path ".harmonic")
#define MOTION(path) \
	MAPPING(path, OPTIONAL, "harmonic motion in this direction") \
	NUMBER(path ".amplitude", REQUIRED, "m", ANY, "amplitude of the motion") \
	WAVE(path)
#define LANES(path) \
	NUMBER(path, REQUIRED, "kg", NOT_NEGATIVE, "mass of a carrier, of both lanes") \
	MAPPING(path, REQUIRED, "mass of a carrier of each lane") \
	NUMBER(path ".up", REQUIRED, "kg", NOT_NEGATIVE, "of the lane to the top station") \
	NUMBER(path ".down", REQUIRED, "kg", NOT_NEGATIVE, "of the lane to the bottom station")
#define CIRCLE(path, need) \
	MAPPING(path, need, "a circle, which extends along z") \
	VECTOR(path ".centre", 2, REQUIRED, "m", ANY, "[x, y] of its centre") \
	NUMBER(path ".radius", REQUIRED, "m", NOT_NEGATIVE, "its radius; 0: a point")
#define PLANE(path, need) \
	MAPPING(path, need, "a plane") \
	VECTOR(path ".point", 3, REQUIRED, "m", ANY, "a point of it") \
	VECTOR(path ".point", 2, REQUIRED, "m", ANY, "a point of it, z = 0") \
	VECTOR(path ".normal", 3, REQUIRED, "1", ANY, "normal towards the net") \
	VECTOR(path ".normal", 2, REQUIRED, "1", ANY, "normal towards the net")
#define SEGMENT_OF(path, need) \
	MAPPING(path, need, "a segment, which extends along z") \
	VECTOR(path ".from", 2, REQUIRED, "m", ANY, "[x, y] of its first end") \
	VECTOR(path ".to", 2, REQUIRED, "m", ANY, "[x, y] of its last end")
#define DERIVATIVES(path) \
	VECTOR(path ".velocity", 3, OPTIONAL, "m/s", ANY, "velocity there") \
	VECTOR(path ".acceleration", 3, OPTIONAL, "m/s^2", ANY, "acceleration there") \
	VECTOR(path ".jerk", 3, OPTIONAL, "m/s^3", ANY, "third derivative there") \
	VECTOR(path ".snap", 3, OPTIONAL, "m/s^4", ANY, "fourth derivative there")
#define ORDERS "velocity|acceleration|jerk|snap"
#define END(path) \
	LIST(path, OPTIONAL, "derivatives that are 0 there") \
	WORD(path "[]", OPTIONAL, ORDERS, "a derivative that is 0") \
	MAPPING(path, OPTIONAL, "derivatives that are given there") \
	DERIVATIVES(path)
#define SEGMENT(path) \
	NUMBER(path ".length", REQUIRED, "m", POSITIVE, "unstretched length") \
	NUMBER(path ".EA", REQUIRED, "N", POSITIVE, "axial stiffness") \
	NUMBER(path ".GA", REQUIRED, "N", POSITIVE, "shear stiffness, with the shear factor") \
	VECTOR(path ".GA", 2, REQUIRED, "N", POSITIVE, "shear stiffnesses along e2 and e3") \
	NUMBER(path ".EI", REQUIRED, "N.m^2", POSITIVE, "bending stiffness") \
	VECTOR(path ".EI", 2, REQUIRED, "N.m^2", POSITIVE, "bending stiffnesses about e2 and e3") \
	NUMBER(path ".GJ", REQUIRED, "N.m^2", POSITIVE, "torsional stiffness") \
	NUMBER(path ".rho", REQUIRED, "kg/m", NOT_NEGATIVE, "mass per length; 0: without weight") \
	VECTOR(path ".curvature", 3, OPTIONAL, "m^-1", ANY, "at rest: [twist, about e2, about e3]") \
	VECTOR(path ".inertia", 3, OPTIONAL, "kg.m", POSITIVE, \
	       "of rotation per length, about e1, e2, e3; for motions") \
	INTEGER(path ".elements", OPTIONAL, "number of elements (20)")
#define PLACE(path, doc) \
	WORD(path, OPTIONAL, "start|end", doc) \
	NUMBER(path, OPTIONAL, "m", NOT_NEGATIVE, doc ": a length from the start")
#define HOLD(path) \
	WORD(path ".hold", OPTIONAL, "clamped|hinged|free", \
	     "how it is held: start clamped and end free, unless it is given")
#define DRIVE(path) \
	MAPPING(path ".spin", OPTIONAL, "the end is turned, in motions") \
	VECTOR(path ".spin.axis", 3, REQUIRED, "1", ANY, "direction of the axis") \
	NUMBER(path ".spin.speed", OPTIONAL, "rad/s", ANY, "angular velocity") \
	NUMBER(path ".spin.rise", OPTIONAL, "s", NOT_NEGATIVE, "time in which it grows from 0 (0)") \
	TEXT(path ".path", OPTIONAL, \
	     "the end is moved: file of rows t x y z (s, m), in motions")
#define WINCH(path) \
	MAPPING(path, OPTIONAL, "the first segment is paid out or hauled in, in motions") \
	NUMBER(path ".speed", ONE_OF, "m/s", ANY, "paid out in this time; negative: hauled in") \
	NUMBER(path ".rise", OPTIONAL, "s", NOT_NEGATIVE, "time in which the speed grows from 0 (0)") \
	LIST(path ".times", OPTIONAL, "times of speeds or lengths") \
	NUMBER(path ".times[]", OPTIONAL, "s", ANY, "a time") \
	LIST(path ".speeds", ONE_OF, "speeds at these times") \
	NUMBER(path ".speeds[]", OPTIONAL, "m/s", ANY, "a speed") \
	LIST(path ".lengths", ONE_OF, "unstretched lengths of the segment at these times") \
	NUMBER(path ".lengths[]", OPTIONAL, "m", POSITIVE, "a length") \
	NUMBER(path ".least", OPTIONAL, "m", POSITIVE, \
	       "the segment must not become shorter (5 % of its length)")
#define AXES(path) \
	VECTOR(path ".tangent", 3, OPTIONAL, "1", ANY, "direction of e1 there ([1, 0, 0])") \
	VECTOR(path ".normal", 3, OPTIONAL, "1", ANY, "direction whose part across the tangent is e2")

static const struct hawser__tree_key rows[] = {
	HEAD("net", NOT_NEGATIVE)
	MAPPING("net.nodes", REQUIRED, "names of nodes and their places")
	VECTOR("net.nodes.*", 3, OPTIONAL, "m", ANY, "[x, y, z]; y is upwards")
	MAPPING("net.nodes.*", OPTIONAL, "{}: a node whose position is to be found")
	LIST("net.cables", REQUIRED, "cables between two nodes")
	MAPPING("net.cables[]", OPTIONAL, "a cable")
	TEXT("net.cables[].name", OPTIONAL, "name (c0, c1 and so on)")
	TEXT("net.cables[].from", REQUIRED, "node at its begin")
	TEXT("net.cables[].to", REQUIRED, "node at its end")
	NUMBER("net.cables[].EA", REQUIRED, "N", POSITIVE, "axial stiffness")
	NUMBER("net.cables[].rho", REQUIRED, "kg/m", NOT_NEGATIVE,
	       "mass per unstretched length; 0: without weight")
	NUMBER("net.cables[].length0", ONE_OF, "m", POSITIVE, "unstretched length")
	NUMBER("net.cables[].tension", ONE_OF, "N", POSITIVE,
	       "mean tension, from which the length follows")
	NUMBER("net.cables[].force_density", ONE_OF, "N/m", POSITIVE, "tension over length")
	NUMBER("net.cables[].sag", ONE_OF, "m", POSITIVE, "sag, from which the length follows")
	INTEGER("net.cables[].elements", OPTIONAL, "number of elements (20 to 400, by their error)")
	MAPPING("net.supports", OPTIONAL, "nodes that are held")
	WORD("net.supports.*", OPTIONAL, "fixed", "held in all directions")
	MAPPING("net.supports.*", OPTIONAL, "held in some directions, or moved")
	LIST("net.supports.*.fixed", OPTIONAL, "directions that are held")
	WORD("net.supports.*.fixed[]", OPTIONAL, "x|y|z", "a direction")
	MAPPING("net.supports.*.motion", OPTIONAL, "harmonic motion")
	MOTION("net.supports.*.motion.x")
	MOTION("net.supports.*.motion.y")
	MOTION("net.supports.*.motion.z")
	TEXT("net.supports.*.table", OPTIONAL,
	     "file with lines of t, x, y, z (s, m): motion by a table")
	MAPPING("net.masses", OPTIONAL, "masses of nodes")
	NUMBER("net.masses.*", OPTIONAL, "kg", NOT_NEGATIVE, "mass of this node")
	MAPPING("net.loads", OPTIONAL, "loads of nodes and cables")
	VECTOR("net.loads.*", 3, OPTIONAL, "N", ANY, "force on a node")
	MAPPING("net.loads.*", OPTIONAL, "load of a node")
	LOAD_OF_NODE("net.loads.*")
	LIST("net.loads.*", OPTIONAL, "several loads of a node")
	MAPPING("net.loads.*[]", OPTIONAL, "load of a node")
	LOAD_OF_NODE("net.loads.*[]")
	MAPPING("net.loads.**", OPTIONAL, "load of a cable")
	LOAD_OF_CABLE("net.loads.**")
	LIST("net.loads.**", OPTIONAL, "several loads of a cable")
	MAPPING("net.loads.**[]", OPTIONAL, "load of a cable")
	LOAD_OF_CABLE("net.loads.**[]")
	MAPPING("net.damping", OPTIONAL, "damping, of motions")
	NUMBER("net.damping.alpha", OPTIONAL, "kg/m/s", NOT_NEGATIVE,
	       "viscous force per length and velocity")
	NUMBER("net.damping.axial", OPTIONAL, "s", NOT_NEGATIVE, "T = EA (strain + axial d strain/dt)")
	MAPPING("net.dynamics", OPTIONAL, "time integration")
	TEXT("net.dynamics.from", OPTIONAL, "statics (the default), or a file of a state")
	LIST("net.dynamics.release", OPTIONAL, "supports that let go at t = 0")
	TEXT("net.dynamics.release[]", OPTIONAL, "a support")
	TEXT("net.dynamics.scheme", OPTIONAL, "method: hawser integrate has the list")
	NUMBER("net.dynamics.rho_inf", OPTIONAL, "1", NOT_NEGATIVE,
	       "spectral radius at infinite frequency, from 0 to 1")
	WORD("net.dynamics.surfaces", OPTIONAL, "moving|start",
	     "surfaces of obstacles move before t = 0 too (the default), or start then")
	WORD("net.dynamics.step", OPTIONAL, "auto", "step chosen by the program")
	NUMBER("net.dynamics.step", OPTIONAL, "s", POSITIVE, "step in time")
	LIST("net.obstacles", OPTIONAL, "surfaces that the nodes of the mesh do not pass")
	MAPPING("net.obstacles[]", OPTIONAL, "a surface")
	TEXT("net.obstacles[].name", OPTIONAL, "name (s0, s1 and so on)")
	PLANE("net.obstacles[].plane", ONE_OF)
	SEGMENT_OF("net.obstacles[].segment", ONE_OF)
	CIRCLE("net.obstacles[].circle", ONE_OF)
	WORD("net.obstacles[].side", OPTIONAL, "above|below|left|right|inside|around",
	     "side where the net is (above)")
	NUMBER("net.obstacles[].friction", OPTIONAL, "1", NOT_NEGATIVE, "coefficient of friction (0)")
	NUMBER("net.obstacles[].velocity", OPTIONAL, "m/s", ANY,
	       "speed of the surface along a segment or counterclockwise around a circle")
	VECTOR("net.obstacles[].velocity", 3, OPTIONAL, "m/s", ANY, "velocity of a plane")
	VECTOR("net.obstacles[].velocity", 2, OPTIONAL, "m/s", ANY, "velocity of a plane")
	WORD("net.obstacles[].groove", OPTIONAL, "no|yes", "whether a groove of a circle holds the rope")
	WORD("net.obstacles[].rotation", OPTIONAL, "locked|free|drive", "how a circle turns (locked)")
	NUMBER("net.obstacles[].inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE,
	       "moment of inertia of a circle that turns freely")
	MAPPING("net.contact", OPTIONAL, "contact with the obstacles")
	NUMBER("net.contact.restitution", OPTIONAL, "1", NOT_NEGATIVE,
	       "of impacts, from 0 (the default) to 1")
	WORD("net.contact.sliding", OPTIONAL, "none|history",
	     "friction of surfaces that move alone (none), or along the way of the supports (history)")
	MAPPING("net.contact.path", OPTIONAL, "ways of supports to their places")
	LIST("net.contact.path.*", OPTIONAL, "places, from the first on")
	VECTOR("net.contact.path.*[]", 3, OPTIONAL, "m", ANY, "a place")
	INTEGER("net.contact.steps", OPTIONAL, "steps between two places (20)")
	WORD("net.contact.modes", OPTIONAL, "slip|stick", "what the contacts do in vibrations")

	HEAD("ropeway", POSITIVE)
	MAPPING("ropeway.ropeway", REQUIRED, "the hauling rope of a ropeway, with two lanes")
	MAPPING("ropeway.ropeway.rope", REQUIRED, "the rope")
	NUMBER("ropeway.ropeway.rope.EA", REQUIRED, "N", POSITIVE, "axial stiffness")
	NUMBER("ropeway.ropeway.rope.rho", REQUIRED, "kg/m", POSITIVE, "mass per unstretched length")
	MAPPING("ropeway.ropeway.bottom", REQUIRED, "the bottom station")
	VECTOR("ropeway.ropeway.bottom.at", 2, REQUIRED, "m", ANY, "[x, y] where the rope leaves it")
	NUMBER("ropeway.ropeway.bottom.radius", REQUIRED, "m", NOT_NEGATIVE, "radius of its bullwheel")
	MAPPING("ropeway.ropeway.bottom.tension", REQUIRED, "what gives the rope its tension")
	NUMBER("ropeway.ropeway.bottom.tension.counterweight", ONE_OF, "N", POSITIVE,
	       "force on the carriage, which both lanes carry")
	NUMBER("ropeway.ropeway.bottom.tension.T0", ONE_OF, "N", POSITIVE, "tension of each lane")
	NUMBER("ropeway.ropeway.bottom.tension.length0", ONE_OF, "m", POSITIVE,
	       "unstretched length of the loop; the carriage is fixed")
	NUMBER("ropeway.ropeway.bottom.tension.T_empty", ONE_OF, "N", POSITIVE,
	       "tension of the rope without carriers, at rest; the carriage is fixed")
	VECTOR("ropeway.ropeway.bottom.tension.travel", 2, OPTIONAL, "m", ANY,
	       "stops of the carriage, from its place with the empty rope, positive towards the line")
	NUMBER("ropeway.ropeway.bottom.mass", OPTIONAL, "kg", NOT_NEGATIVE,
	       "of the carriage and of what moves with it; without it the carriage does not vibrate")
	NUMBER("ropeway.ropeway.bottom.friction", OPTIONAL, "1", NOT_NEGATIVE,
	       "resistance of the bullwheel as a part of the force on it, below 1 (0)")
	NUMBER("ropeway.ropeway.bottom.inertia", OPTIONAL, "kg m2", NOT_NEGATIVE,
	       "moment of inertia of the bullwheel (0)")
	MAPPING("ropeway.ropeway.top", REQUIRED, "the top station")
	VECTOR("ropeway.ropeway.top.at", 2, REQUIRED, "m", ANY, "[x, y] where the rope leaves it")
	NUMBER("ropeway.ropeway.top.radius", REQUIRED, "m", NOT_NEGATIVE, "radius of its bullwheel")
	MAPPING("ropeway.ropeway.top.drive", OPTIONAL, "its drive")
	NUMBER("ropeway.ropeway.top.drive.speed", OPTIONAL, "m/s", NOT_NEGATIVE,
	       "speed of the rope (0)")
	NUMBER("ropeway.ropeway.top.drive.friction", OPTIONAL, "1", NOT_NEGATIVE,
	       "coefficient of friction of the rope on the bullwheel")
	NUMBER("ropeway.ropeway.top.drive.ramp", OPTIONAL, "s", NOT_NEGATIVE, "time of a start")
	NUMBER("ropeway.ropeway.top.drive.wrap", OPTIONAL, "rad", POSITIVE, "wrap of the rope (pi)")
	NUMBER("ropeway.ropeway.top.drive.inertia", OPTIONAL, "kg m2", NOT_NEGATIVE,
	       "moment of inertia of the bullwheel with its drive; without it, it keeps its speed")
	NUMBER("ropeway.ropeway.top.drive.force", OPTIONAL, "N", POSITIVE, "largest force of the drive")
	MAPPING("ropeway.ropeway.top.drive.brake", OPTIONAL, "how it brakes")
	NUMBER("ropeway.ropeway.top.drive.brake.deceleration", OPTIONAL, "m/s^2", POSITIVE,
	       "deceleration of the rope")
	NUMBER("ropeway.ropeway.top.drive.brake.force", OPTIONAL, "N", POSITIVE, "force on the rope")
	LIST("ropeway.ropeway.towers", OPTIONAL, "towers in the order of x")
	MAPPING("ropeway.ropeway.towers[]", OPTIONAL, "a tower")
	TEXT("ropeway.ropeway.towers[].name", OPTIONAL, "name (p0, p1 and so on)")
	VECTOR("ropeway.ropeway.towers[].at", 2, REQUIRED, "m", ANY,
	       "[x, y] of the summit of its battery")
	WORD("ropeway.ropeway.towers[].battery", OPTIONAL, "auto|support|compression",
	     "side of the sheaves (auto: by the reaction)")
	NUMBER("ropeway.ropeway.towers[].radius", REQUIRED, "m", NOT_NEGATIVE,
	       "radius of the circle of its battery; 0: a point")
	NUMBER("ropeway.ropeway.towers[].friction", OPTIONAL, "1", NOT_NEGATIVE,
	       "coefficient of friction of the rope (0)")
	MAPPING("ropeway.ropeway.towers[].sheaves", OPTIONAL,
	        "a train of sheaves in place of the circle")
	INTEGER("ropeway.ropeway.towers[].sheaves.count", REQUIRED, "number of sheaves")
	NUMBER("ropeway.ropeway.towers[].sheaves.spacing", REQUIRED, "m", POSITIVE,
	       "distance along the circle")
	NUMBER("ropeway.ropeway.towers[].sheaves.radius", REQUIRED, "m", NOT_NEGATIVE,
	       "radius of a sheave")
	NUMBER("ropeway.ropeway.towers[].inertia", OPTIONAL, "kg m2", NOT_NEGATIVE,
	       "moment of inertia of a sheave (0)")
	MAPPING("ropeway.ropeway.carriers", OPTIONAL, "chairs or cabins")
	NUMBER("ropeway.ropeway.carriers.spacing", REQUIRED, "m", POSITIVE, "unstretched distance")
	LANES("ropeway.ropeway.carriers.mass")
	NUMBER("ropeway.ropeway.carriers.empty", OPTIONAL, "kg", NOT_NEGATIVE,
	       "mass of an empty one (0)")
	WORD("ropeway.ropeway.carriers.phase", OPTIONAL, "sweep", "worst values over a spacing")
	NUMBER("ropeway.ropeway.carriers.phase", OPTIONAL, "m", ANY,
	       "distance of the first of lane up from the bottom station (0)")
	NUMBER("ropeway.ropeway.carriers.phase_down", OPTIONAL, "m", ANY,
	       "that of the first of lane down (spacing minus phase)")
	NUMBER("ropeway.ropeway.carriers.hanger", OPTIONAL, "m", NOT_NEGATIVE,
	       "length at which the mass hangs below the rope")
	WORD("ropeway.ropeway.down", OPTIONAL, "off|on", "off leaves lane down out")
	WORD("ropeway.ropeway.sliding", OPTIONAL, "running|rest|reverse",
	     "which way friction acts on the sheaves (running)")
	LIST("ropeway.ropeway.cases", OPTIONAL, "load cases besides full")
	MAPPING("ropeway.ropeway.cases[]", OPTIONAL, "a load case")
	TEXT("ropeway.ropeway.cases[].name", REQUIRED, "name")
	LANES("ropeway.ropeway.cases[].mass")
	MAPPING("ropeway.contact", OPTIONAL, "contact in vibrations")
	WORD("ropeway.contact.modes", OPTIONAL, "slip|stick|roll",
	     "what the rope does on the sheaves as it vibrates")

	WORD("obstacles.kind", OPTIONAL, "span", "kind of the scene")
	NUMBER("obstacles.g", OPTIONAL, "m/s^2", POSITIVE, "acceleration of gravity, downwards (9.81)")
	MAPPING("obstacles.cable", REQUIRED, "the cable")
	NUMBER("obstacles.cable.EA", REQUIRED, "N", POSITIVE, "axial stiffness; .inf: inextensible")
	NUMBER("obstacles.cable.rho", REQUIRED, "kg/m", POSITIVE, "mass per unstretched length")
	INTEGER("obstacles.cable.elements", MESH, "number of elements, with planes or segments")
	MAPPING("obstacles.span", REQUIRED, "the positions of the ends")
	NUMBER("obstacles.span.d", REQUIRED, "m", POSITIVE, "horizontal distance of the ends")
	NUMBER("obstacles.span.h", REQUIRED, "m", ANY, "height of end B above end A")
	MAPPING("obstacles.tension", REQUIRED, "what fixes the tension")
	NUMBER("obstacles.tension.T0", ONE_OF, "N", POSITIVE, "tension at end A")
	NUMBER("obstacles.tension.T1", ONE_OF, "N", POSITIVE, "tension at end B")
	NUMBER("obstacles.tension.length0", ONE_OF, "m", POSITIVE, "unstretched length")
	LIST("obstacles.obstacles", REQUIRED, "circles in the order of x")
	MAPPING("obstacles.obstacles[]", OPTIONAL, "an obstacle")
	TEXT("obstacles.obstacles[].name", OPTIONAL, "name (s0, s1 and so on)")
	CIRCLE("obstacles.obstacles[].circle", ONE_OF)
	PLANE("obstacles.obstacles[].plane", MESH)
	SEGMENT_OF("obstacles.obstacles[].segment", MESH)
	WORD("obstacles.obstacles[].side", OPTIONAL, "above|below",
	     "side where the rope passes (above)")
	NUMBER("obstacles.obstacles[].friction", OPTIONAL, "1", NOT_NEGATIVE,
	       "coefficient of friction (0)")
	WORD("obstacles.obstacles[].groove", OPTIONAL, "no|yes",
	     "whether a groove holds the rope in the vertical plane (yes)")
	WORD("obstacles.obstacles[].rotation", OPTIONAL, "locked|free|drive", "how it turns (locked)")
	NUMBER("obstacles.obstacles[].inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE,
	       "moment of inertia of a circle that turns with the rope")
	MAPPING("obstacles.contact", OPTIONAL, "contact with the obstacles")
	WORD("obstacles.contact.sliding", OPTIONAL, "none|toward-A|toward-B|history",
	     "which way the rope slides (none)")
	LIST("obstacles.contact.path", OPTIONAL, "values that the given tension or length had before")
	NUMBER("obstacles.contact.path[]", OPTIONAL, NULL, POSITIVE,
	       "a value, in the unit of what is given")
	WORD("obstacles.contact.winch", OPTIONAL, "A|B", "end at which the rope is paid in and out")
	WORD("obstacles.contact.modes", OPTIONAL, "slip|stick",
	     "what the rope does on the circles as it vibrates")
	NUMBER("obstacles.contact.restitution", OPTIONAL, "1", NOT_NEGATIVE, "of impacts; only 0 yet")

	HEAD("rod", NOT_NEGATIVE)
	MAPPING("rod.rod", REQUIRED, "one segment")
	SEGMENT("rod.rod")
	LIST("rod.rod", REQUIRED, "segments from the start on")
	MAPPING("rod.rod[]", OPTIONAL, "a segment")
	SEGMENT("rod.rod[]")
	MAPPING("rod.start", OPTIONAL, "the first end")
	VECTOR("rod.start.at", 3, OPTIONAL, "m", ANY, "its place ([0, 0, 0])")
	AXES("rod.start")
	HOLD("rod.start")
	DRIVE("rod.start")
	WINCH("rod.start.winch")
	MAPPING("rod.end", OPTIONAL, "the last end")
	VECTOR("rod.end.at", 3, OPTIONAL, "m", ANY, "the place to which it is brought")
	AXES("rod.end")
	HOLD("rod.end")
	DRIVE("rod.end")
	LIST("rod.loads", OPTIONAL, "loads at points, or per length")
	MAPPING("rod.loads[]", OPTIONAL, "a load")
	PLACE("rod.loads[].at", "point of the load")
	PLACE("rod.loads[].from", "begin of a load per length (start)")
	PLACE("rod.loads[].to", "end of a load per length (end)")
	VECTOR("rod.loads[].force", 3, OPTIONAL, "N, or N/m", ANY, "force; per length without at")
	VECTOR("rod.loads[].moment", 3, OPTIONAL, "N.m, or N", ANY, "moment; per length without at")
	WORD("rod.loads[].frame", OPTIONAL, "fixed|follower",
	     "axes: x, y, z, or those of the section (fixed)")
	LIST("rod.loads[].factor", OPTIONAL, "its history: [time, factor], linear between")
	VECTOR("rod.loads[].factor[]", 2, OPTIONAL, "s, 1", ANY, "[time, factor]")
	MAPPING("rod.damping", OPTIONAL, "damping, of motions")
	NUMBER("rod.damping.alpha", REQUIRED, "s^-1", NOT_NEGATIVE,
	       "damping force per mass and velocity")
	MAPPING("rod.dynamics", OPTIONAL, "time integration")
	NUMBER("rod.dynamics.rho_inf", OPTIONAL, "1", NOT_NEGATIVE,
	       "spectral radius at infinite frequency, from 0 to 1")
	NUMBER("rod.dynamics.step", OPTIONAL, "s", POSITIVE, "step in time")
	WORD("rod.dynamics.from", OPTIONAL, "equilibrium|rest", "first state (equilibrium)")

	HEAD("tow", POSITIVE)
	MAPPING("tow.tow", REQUIRED, "the path of the towing point")
	LIST("tow.tow.waypoints", ONE_OF, "at least two waypoints in the order of time")
	VECTOR("tow.tow.waypoints[]", 4, OPTIONAL, "s, m, m, m", ANY, "[t, x, y, z]")
	MAPPING("tow.tow.waypoints[]", OPTIONAL, "a waypoint with derivatives")
	NUMBER("tow.tow.waypoints[].t", REQUIRED, "s", ANY, "time")
	VECTOR("tow.tow.waypoints[].at", 3, REQUIRED, "m", ANY, "place")
	DERIVATIVES("tow.tow.waypoints[]")
	NUMBER("tow.tow.waypoints[].flat", OPTIONAL, "1", NOT_NEGATIVE,
	       "order up to which derivatives that are not given are 0")
	TEXT("tow.tow.file", ONE_OF, "text file of lines t x y z (s, m)")
	NUMBER("tow.tow.speed", ONE_OF, "m/s", ANY, "straight flight, along x")
	VECTOR("tow.tow.speed", 3, ONE_OF, "m/s", ANY, "straight flight: its velocity")
	MAPPING("tow.tow.orbit", ONE_OF, "a horizontal circle")
	NUMBER("tow.tow.orbit.radius", REQUIRED, "m", POSITIVE, "its radius")
	NUMBER("tow.tow.orbit.speed", REQUIRED, "m/s", ANY, "positive from x toward z")
	VECTOR("tow.tow.orbit.centre", 3, OPTIONAL, "m", ANY, "its centre ([0, 0, 0])")
	WORD("tow.tow.minimise", OPTIONAL, "snap|jerk|acceleration|none",
	     "whose squared integral is least over all paths through the waypoints (snap)")
	LIST("tow.tow.ends", OPTIONAL, "derivatives that are 0 at both ends")
	WORD("tow.tow.ends[]", OPTIONAL, ORDERS, "a derivative that is 0")
	MAPPING("tow.tow.ends", OPTIONAL, "what is given at the ends")
	END("tow.tow.ends.start")
	END("tow.tow.ends.end")
	VECTOR("tow.tow.start", 3, OPTIONAL, "m", ANY, "begin of straight flight ([0, 0, 0])")
	NUMBER("tow.tow.ramp", OPTIONAL, "s", NOT_NEGATIVE, "time in which the speed grows from 0 (0)")
	WORD("tow.tow.law", OPTIONAL, "smooth|erf", "how it grows (smooth)")
	WORD("tow.tow.hinge", OPTIONAL, "free|clamped",
	     "of a cable with EI, at the towing point (free)")
	MAPPING("tow.cable", OPTIONAL, "the cable")
	LIST("tow.cable.segments", REQUIRED, "its parts from the towing point on")
	MAPPING("tow.cable.segments[]", OPTIONAL, "a part")
	NUMBER("tow.cable.segments[].length", REQUIRED, "m", POSITIVE, "unstretched length")
	NUMBER("tow.cable.segments[].EA", OPTIONAL, "N", POSITIVE, "axial stiffness (.inf)")
	NUMBER("tow.cable.segments[].EI", OPTIONAL, "N.m^2", NOT_NEGATIVE, "bending stiffness (0)")
	NUMBER("tow.cable.segments[].GJ", OPTIONAL, "N.m^2", POSITIVE,
	       "torsional stiffness of a cable with EI (that of EI)")
	NUMBER("tow.cable.segments[].GA", OPTIONAL, "N", POSITIVE,
	       "shear stiffness of a cable with EI (no shear)")
	NUMBER("tow.cable.segments[].rho", REQUIRED, "kg/m", NOT_NEGATIVE, "mass per length")
	NUMBER("tow.cable.segments[].diameter", OPTIONAL, "m", NOT_NEGATIVE, "diameter, of the drag")
	INTEGER("tow.cable.segments[].elements", OPTIONAL, "number of elements (100)")
	DRAG("tow.cable.segments[].drag")
	MAPPING("tow.cable.segments[].shedding", OPTIONAL, "forces of vortices")
	NUMBER("tow.cable.segments[].shedding.lift", REQUIRED, "1", NOT_NEGATIVE, "lift coefficient")
	NUMBER("tow.cable.segments[].shedding.strouhal", REQUIRED, "1", POSITIVE, "Strouhal number")
	MAPPING("tow.air", OPTIONAL, "the air")
	NUMBER("tow.air.density", REQUIRED, "kg/m^3", NOT_NEGATIVE, "density")
	VECTOR("tow.air.wind", 3, OPTIONAL, "m/s", ANY, "velocity of the wind ([0, 0, 0])")
	TEXT("tow.air.file", OPTIONAL, "a file of the wind over time, in place of wind")
	WINCH("tow.winch")
	MAPPING("tow.body", OPTIONAL, "what is towed")
	MAPPING("tow.body.ring", OPTIONAL, "a ring")
	NUMBER("tow.body.ring.radius", REQUIRED, "m", POSITIVE, "radius of the ring")
	NUMBER("tow.body.ring.tube", REQUIRED, "m", POSITIVE, "radius of its tube")
	NUMBER("tow.body.ring.mass", REQUIRED, "kg", POSITIVE, "mass")
	NUMBER("tow.body.ring.offset", REQUIRED, "m", NOT_NEGATIVE,
	       "distance of its centre from the end of the cable")
	INTEGER("tow.body.ring.segments", OPTIONAL, "number of parts of its drag (32)")
	DRAG("tow.body.ring.drag")
	NUMBER("tow.body.mass", OPTIONAL, "kg", POSITIVE, "of a point, in place of a ring")
	NUMBER("tow.body.CdA", OPTIONAL, "m^2", NOT_NEGATIVE, "drag coefficient times area (0)")
	NUMBER("tow.body.inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE, "of a point, about any axis (0)")
	WORD("tow.body.joint", OPTIONAL, "clamped|free", "of a ring, with a cable with EI (clamped)")
	MAPPING("tow.body.joint", OPTIONAL, "a spring between the ring and the end of the cable")
	NUMBER("tow.body.joint.torsion", REQUIRED, "N.m/rad", POSITIVE, "moment over angle")
};

const struct hawser__tree_key *hawser__tree_row(int index)
{
	return index >= 0 && index < (int)(sizeof rows/sizeof *rows) ? &rows[index] : NULL;
}

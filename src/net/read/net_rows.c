/* net/read/net_rows.c - the keys of scenes of kind `net`, and of spans that are meshes. See
 * scene/tree_rows.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/scene.h>

#include "net/read/read.h"
#include "scene/tree_rows.h"

#define NET_AT(member) offsetof(struct hawser_net, member)
#define NODE_AT(member) offsetof(struct hawser_net_node, member)
#define CABLE_AT(member) offsetof(struct hawser_net_cable, member)
#define LOAD_AT(member) offsetof(struct hawser_net_load, member)
#define PASS_AT(member) offsetof(struct hawser__net_passing, member)
#define ABSORBER_AT(member) offsetof(struct hawser__net_absorber_given, member)
#define BODY_AT(member) offsetof(struct hawser_net_body, member)
#define FAILURE_AT(member) offsetof(struct hawser_net_failure, member)
#define WINCH_AT(member) offsetof(struct hawser_net_winch, member)
#define SURFACE_AT(member) offsetof(struct hawser_surface, member)

#define WAVE(path) \
	NUMBER(path ".Omega", ONE_OF, "rad/s", POSITIVE, LOAD_AT(Omega), NULL, "angular frequency") \
	INTEGER(path ".multiple", ONE_OF, 1, 20, LOAD_AT(multiple), NULL, \
	        "in place of it, of the frequency of a response: for frf and what takes models") \
	NUMBER(path ".phase", OPTIONAL, "rad", ANY, LOAD_AT(phase), "0", "phase")
#define LOAD_OF(path, key, unit, doc) \
	VECTOR(path key, 3, REQUIRED, unit, ANY, LOAD_AT(value), NULL, doc) \
	SECTION(path ".harmonic", OPTIONAL, "its time function, cos(Omega t + phase)") \
	WAVE(path ".harmonic")
#define LOAD_OF_NODE(path) LOAD_OF(path, ".force", "N", "force along x, y, z")
#define LOAD_OF_CABLE(path) \
	LOAD_OF(path, ".per_length", "N/m", "force per unstretched length along x, y, z") \
	VECTOR(path ".extent", 2, OPTIONAL, "1", INCREASING, LOAD_AT(extent), "[0, 1]", \
	       "parts of the unstretched length between which it acts") \
	NUMBER(path ".harmonic.wavelength", OPTIONAL, "m", ANY, LOAD_AT(wavelength), NULL, \
	       "unstretched length over which the phase falls by 2 pi, of a load that runs towards its " \
	       "end; negative: towards its begin")
#define WIND_AT(member) offsetof(struct hawser_wind, member)
/* none: the default, of a cable words about it. */
#define SECTION_IN_WIND(path, none) \
	NUMBER(path ".diameter", OPTIONAL, "m", NOT_NEGATIVE, WIND_AT(diameter), none, \
	       "diameter to which drag and lift refer; 0: the wind passes by") \
	NUMBER(path ".angle", OPTIONAL, "rad", ANY, WIND_AT(angle), none, "as wind.angle of spans") \
	NUMBER(path ".drag", OPTIONAL, "1", ANY, WIND_AT(drag), none, "as wind.drag of spans") \
	LIST(path ".drag", OPTIONAL, "of the powers 0, 1, 2, ... of the angle of attack") \
	NUMBER(path ".drag[]", OPTIONAL, "1", ANY, NOWHERE, NULL, "factor of a power") \
	NUMBER(path ".lift", OPTIONAL, "1", ANY, WIND_AT(lift), none, "as wind.lift of spans") \
	LIST(path ".lift", OPTIONAL, "of the powers 0, 1, 2, ... of the angle of attack") \
	NUMBER(path ".lift[]", OPTIONAL, "1", ANY, NOWHERE, NULL, "factor of a power") \
	LIST(path ".table", OPTIONAL, "as wind.table of spans") \
	VECTOR(path ".table[]", 3, OPTIONAL, "rad, 1, 1", ANY, NOWHERE, NULL, \
	       "[angle of attack, drag coefficient, lift coefficient]") \
	TEXT(path ".table", OPTIONAL, NOWHERE, NULL, "a file of such rows, as of spans") \
	LIST(path ".reynolds", OPTIONAL, "as wind.reynolds of spans") \
	VECTOR(path ".reynolds[]", 2, OPTIONAL, "1", ANY, NOWHERE, NULL, \
	       "[Reynolds' number of the relative wind, drag coefficient]") \
	TEXT(path ".reynolds", OPTIONAL, NOWHERE, NULL, "a file of such rows") \
	NUMBER(path ".viscosity", OPTIONAL, "m^2/s", NOT_NEGATIVE, WIND_AT(viscosity), none, \
	       "as wind.viscosity of spans")
#define MOTION(path, k) \
	MAPPING(path, OPTIONAL, "harmonic motion in this direction") \
	NUMBER(path ".amplitude", REQUIRED, "m", ANY, LOAD_AT(value[k]), NULL, \
	       "amplitude of the motion") \
	WAVE(path)
/* A third number, along z, may be left out: 0. */
#define PLACE_OR(path, most, need, unit, at, doc) \
	VECTOR(path, 2, need, unit, ANY, at, NULL, doc ", z = 0") \
	VECTOR(path, most, need, unit, ANY, at, NULL, doc)

static const struct hawser__tree_key net_rows[] = {
	HEAD("net", "net", NOT_NEGATIVE, NET_AT(g))
	MAPPING("net.nodes", REQUIRED, "names of nodes and their places")
	VECTOR("net.nodes.*", 3, OPTIONAL, "m", ANY, NODE_AT(x), NULL, "[x, y, z]; y is upwards")
	MAPPING("net.nodes.*", OPTIONAL, "{}: a node whose position is to be found")
	LIST("net.cables", REQUIRED, "cables between two nodes")
	MAPPING("net.cables[]", OPTIONAL, "a cable")
	TEXT("net.cables[].name", OPTIONAL, NOWHERE, "c0, c1 and so on", "name")
	TEXT("net.cables[].from", REQUIRED, NOWHERE, NULL, "node at its begin")
	TEXT("net.cables[].to", REQUIRED, NOWHERE, NULL, "node at its end")
	NUMBER("net.cables[].EA", REQUIRED, "N", POSITIVE, CABLE_AT(EA), NULL, "axial stiffness")
	MAPPING("net.cables[].EA", REQUIRED, "a law of the tension: a table, or a rope that is stiffer "
	        "when it is quick")
	NUMBER("net.cables[].EA.static", OPTIONAL, "N", POSITIVE, NOWHERE, NULL, "EA at rest")
	NUMBER("net.cables[].EA.dynamic", OPTIONAL, "N", POSITIVE, NOWHERE, NULL, "EA of quick motions, of "
	       "a spring in line with another one, to which a dashpot is parallel")
	NUMBER("net.cables[].EA.viscosity", OPTIONAL, "N.s", POSITIVE, NOWHERE, NULL, "of the dashpot: "
	       "its tension over the rate of its strain")
	LIST("net.cables[].EA.table", OPTIONAL, "strains with tensions, rising from (0, 0) on: linear "
	     "between, and beyond the last row")
	VECTOR("net.cables[].EA.table[]", 2, OPTIONAL, "1, N", ANY, NOWHERE, NULL, "[strain, tension]")
	NUMBER("net.cables[].rho", REQUIRED, "kg/m", NOT_NEGATIVE, CABLE_AT(rho), NULL,
	       "mass per unstretched length; 0: without weight")
	NUMBER("net.cables[].axial", OPTIONAL, "s", NOT_NEGATIVE, CABLE_AT(axial), NULL,
	       "damping of its own, beside damping.axial: T = EA (strain + axial d strain/dt), as of a "
	       "damper")
	NUMBER("net.cables[].damper", OPTIONAL, "N.s/m", NOT_NEGATIVE, CABLE_AT(damper), "0",
	       "force over the rate of its length, beside axial: a damper between two cables is a cable")
	LINE_IN_WATER("net.cables[]", CABLE_AT)
	MAPPING("net.cables[].wind", OPTIONAL, "its own section in the wind")
	SECTION_IN_WIND("net.cables[].wind", "that of wind")
	CHOICE("net.cables[].length0", "m", CABLE_AT(value), CABLE_AT(given), "unstretched length")
	CHOICE("net.cables[].tension", "N", CABLE_AT(value), CABLE_AT(given),
	       "mean tension, from which the length follows")
	CHOICE("net.cables[].force_density", "N/m", CABLE_AT(value), CABLE_AT(given),
	       "tension over length")
	CHOICE("net.cables[].sag", "m", CABLE_AT(value), CABLE_AT(given),
	       "sag, from which the length follows")
	INTEGER("net.cables[].elements", OPTIONAL, 1, 1e9, CABLE_AT(elements), "20",
	        "number of elements; without it up to 400, by the error of the tensions (1e-3)")
	MAPPING("net.supports", OPTIONAL, "nodes that are held")
	WORD("net.supports.*", OPTIONAL, "fixed", NOWHERE, NULL, "held in all directions")
	MAPPING("net.supports.*", OPTIONAL, "held in some directions, or moved")
	LIST("net.supports.*.fixed", OPTIONAL, "directions that are held")
	WORD("net.supports.*.fixed[]", OPTIONAL, "x|y|z", NOWHERE, NULL, "a direction")
	MAPPING("net.supports.*.motion", OPTIONAL, "harmonic motion")
	MOTION("net.supports.*.motion.x", 0)
	MOTION("net.supports.*.motion.y", 1)
	MOTION("net.supports.*.motion.z", 2)
	TEXT("net.supports.*.table", OPTIONAL, NODE_AT(table), NULL,
	     "file with lines of t, x, y, z (s, m): motion by a table")
	MAPPING("net.masses", OPTIONAL, "masses of nodes")
	NUMBER("net.masses.*", OPTIONAL, "kg", NOT_NEGATIVE, NODE_AT(mass), NULL, "mass of this node")
	SECTION("net.masses.*", OPTIONAL, "one that hangs, as a pendulum")
	NUMBER("net.masses.*.mass", REQUIRED, "kg", POSITIVE, NODE_AT(hung), NULL, "mass of the load")
	HANGER("net.masses.*.hanger", NODE_AT(hanger))
	MAPPING("net.buoys", OPTIONAL, "bodies at nodes in water; spheres, where the surface cuts them")
	SECTION("net.buoys.*", OPTIONAL, "a body")
	NUMBER("net.buoys.*.mass", OPTIONAL, "kg", NOT_NEGATIVE, NODE_AT(buoy.mass), "0",
	       "mass, beside that in masses")
	NUMBER("net.buoys.*.volume", REQUIRED, "m^3", NOT_NEGATIVE, NODE_AT(buoy.volume), NULL,
	       "volume of the water that it displaces")
	NUMBER("net.buoys.*.CdA", OPTIONAL, "m^2", NOT_NEGATIVE, NODE_AT(buoy.CdA), "0",
	       "coefficient of the drag times area")
	NUMBER("net.buoys.*.added_mass", OPTIONAL, "1", NOT_NEGATIVE, NODE_AT(buoy.added), "0",
	       "added mass over the mass of the water that is displaced")
	MAPPING("net.bodies", OPTIONAL, "rigid bodies, of nodes that move together")
	MAPPING("net.bodies.*", OPTIONAL, "one of them: a support among its nodes is a hinge, two are an "
	        "axis")
	LIST("net.bodies.*.nodes", REQUIRED, "its nodes, which have places")
	TEXT("net.bodies.*.nodes[]", OPTIONAL, NOWHERE, NULL, "a node")
	NUMBER("net.bodies.*.mass", OPTIONAL, "kg", NOT_NEGATIVE, BODY_AT(mass), "0",
	       "mass, beside those of its nodes and rods")
	VECTOR("net.bodies.*.centre", 3, OPTIONAL, "m", ANY, BODY_AT(centre), NULL,
	       "[x, y, z] of the centre of this mass")
	VECTOR("net.bodies.*.inertia", 3, OPTIONAL, "kg.m^2", NOT_NEGATIVE, BODY_AT(inertia),
	       "[0, 0, 0]", "moments of inertia of this mass about axes through its centre along x, y, z")
	NUMBER("net.bodies.*.bearing", OPTIONAL, "m^2", NOT_NEGATIVE, BODY_AT(bearing), "0",
	       "area of each of its nodes on obstacles that give way, beside those of rods and lines there")
	LIST("net.bodies.*.rods", OPTIONAL, "straight parts between two of its nodes, as of steel tubes")
	MAPPING("net.bodies.*.rods[]", OPTIONAL, "one of them")
	TEXT("net.bodies.*.rods[].name", OPTIONAL, NOWHERE, "BODY_rod0, BODY_rod1 and so on", "name")
	TEXT("net.bodies.*.rods[].from", REQUIRED, NOWHERE, NULL, "node at its begin")
	TEXT("net.bodies.*.rods[].to", REQUIRED, NOWHERE, NULL, "node at its end")
	NUMBER("net.bodies.*.rods[].rho", OPTIONAL, "kg/m", NOT_NEGATIVE, CABLE_AT(rho), "0",
	       "mass per length")
	LINE_IN_WATER("net.bodies.*.rods[]", CABLE_AT)
	INTEGER("net.bodies.*.rods[].elements", OPTIONAL, 1, 1e6, CABLE_AT(elements), "20",
	        "parts with loads of the water at their ends")
	MAPPING("net.dampers", OPTIONAL, "dampers from nodes to the ground")
	VECTOR("net.dampers.*", 3, OPTIONAL, "N.s/m", NOT_NEGATIVE, NODE_AT(damper), NULL,
	       "force along x, y, z over the velocity of this node")
	MAPPING("net.springs", OPTIONAL, "springs from nodes to the ground, without force in the "
	        "equilibrium")
	VECTOR("net.springs.*", 3, OPTIONAL, "N/m", NOT_NEGATIVE, NODE_AT(spring), NULL,
	       "force along x, y, z over the displacement of this node")
	LIST("net.absorbers", OPTIONAL, "masses at nodes, on a spring and a damper")
	MAPPING("net.absorbers[]", OPTIONAL, "one of them: its weight is part of the equilibrium")
	TEXT("net.absorbers[].name", OPTIONAL, NOWHERE, "absorber_0, absorber_1 and so on", "name")
	TEXT("net.absorbers[].at", REQUIRED, NOWHERE, NULL, "the node")
	NUMBER("net.absorbers[].mass", REQUIRED, "kg", POSITIVE, ABSORBER_AT(of.mass), NULL,
	       "mass that moves along the direction relative to the node, and across it with the node")
	NUMBER("net.absorbers[].stiffness", ONE_OF, "N/m", POSITIVE, ABSORBER_AT(of.stiffness), NULL,
	       "spring between both")
	NUMBER("net.absorbers[].frequency", ONE_OF, "rad/s", POSITIVE, ABSORBER_AT(omega), NULL,
	       "in place of it: natural frequency where the node is held")
	NUMBER("net.absorbers[].damping", OPTIONAL, "N.s/m", NOT_NEGATIVE, ABSORBER_AT(of.damping), "0",
	       "damper between both")
	VECTOR("net.absorbers[].direction", 3, OPTIONAL, "1", ANY, ABSORBER_AT(of.direction), "[0, 1, 0]",
	       "its direction, which does not turn, along x, y, z; its length does not matter")
	MAPPING("net.loads", OPTIONAL, "loads of nodes and cables")
	VECTOR("net.loads.*", 3, OPTIONAL, "N", ANY, LOAD_AT(value), NULL, "force on a node")
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
	LIST("net.passing", OPTIONAL, "carriers that pass along ropes at equal distances")
	MAPPING("net.passing[]", OPTIONAL, "those of a rope")
	LIST("net.passing[].along", REQUIRED, "cables of the rope, with length0, as they are passed")
	TEXT("net.passing[].along[]", REQUIRED, NOWHERE, NULL, "a cable")
	NUMBER("net.passing[].weight", ONE_OF, "N", POSITIVE, PASS_AT(weight), NULL,
	       "weight of a carrier without inertia; its mean over the rope is a constant load")
	NUMBER("net.passing[].mass", ONE_OF, "kg", POSITIVE, PASS_AT(mass), NULL,
	       "mass of a carrier; its mean over the rope is added to rho")
	NUMBER("net.passing[].spacing", REQUIRED, "m", POSITIVE, PASS_AT(spacing), NULL,
	       "unstretched distance of the carriers")
	NUMBER("net.passing[].first", OPTIONAL, "m", ANY, PASS_AT(first), "0",
	       "unstretched distance of one from the begin of the rope at t = 0")
	INTEGER("net.passing[].harmonics", OPTIONAL, 1, 20, PASS_AT(harmonics), "3",
	        "multiples of the frequency 2 pi speed/spacing")
	NUMBER("net.passing[].speed", OPTIONAL, "m/s", POSITIVE, PASS_AT(speed), NULL,
	       "their speed; without it that of each frequency of a response")
	SECTION("net.damping", OPTIONAL, "damping, of motions")
	NUMBER("net.damping.alpha", OPTIONAL, "kg/m/s", NOT_NEGATIVE, NET_AT(alpha), NULL,
	       "viscous force per length and velocity")
	NUMBER("net.damping.axial", OPTIONAL, "s", NOT_NEGATIVE, NET_AT(axial), NULL,
	       "T = EA (strain + axial d strain/dt)")
	SECTION("net.damping.rayleigh", OPTIONAL, "of models, as of frf, alone: force mass M v")
	NUMBER("net.damping.rayleigh.mass", REQUIRED, "1/s", NOT_NEGATIVE, NET_AT(mass_rate), NULL,
	       "its coefficient")
	LIMITED("net.damping.ratio", OPTIONAL, "1", NOT_NEGATIVE, 0.99, NET_AT(ratio), NULL,
	        "of models, as of frf, alone: damping ratio of each mode")
	SECTION("net.dynamics", OPTIONAL, "time integration")
	TEXT("net.dynamics.from", OPTIONAL, NET_AT(dynamics.from), "statics",
	     "first state: the equilibrium (statics), or a file of a state")
	LIST("net.dynamics.release", OPTIONAL, "supports that let go at t = 0")
	TEXT("net.dynamics.release[]", OPTIONAL, NOWHERE, NULL, "a support")
	TEXT("net.dynamics.scheme", OPTIONAL, NOWHERE, NULL, "method: hawser integrate has the list")
	NUMBER("net.dynamics.rho_inf", OPTIONAL, "1", NOT_NEGATIVE, NET_AT(dynamics.rho_inf),
	       "by the scheme", "spectral radius at infinite frequency, from 0 to 1")
	WORD("net.dynamics.surfaces", OPTIONAL, "moving|start", NET_AT(dynamics.surfaces_start), "moving",
	     "surfaces of obstacles move before t = 0 too, or start then, as of a belt, which has no "
	     "equilibrium on wheels that turn")
	WORD("net.dynamics.step", OPTIONAL, "auto", CHECKED, NULL, "step chosen by the program")
	NUMBER("net.dynamics.step", OPTIONAL, "s", POSITIVE, NET_AT(dynamics.step), NULL, "step in time")
	LIST("net.failures", OPTIONAL, "of motions: cables that part")
	MAPPING("net.failures[]", OPTIONAL, "one of them")
	TEXT("net.failures[].cable", REQUIRED, NOWHERE, NULL, "the cable")
	TEXT("net.failures[].at", OPTIONAL, NOWHERE, NULL, "the node at one of its ends, which it leaves")
	NUMBER("net.failures[].at", OPTIONAL, "1", NOT_NEGATIVE, NOWHERE, NULL,
	       "or the part of its unstretched length from its end `from`: at the next node of the mesh")
	NUMBER("net.failures[].time", ONE_OF, "s", NOT_NEGATIVE, FAILURE_AT(time), NULL, "when it parts")
	NUMBER("net.failures[].tension", ONE_OF, "N", POSITIVE, FAILURE_AT(tension), NULL,
	       "or the tension there, with damping, at which it parts")
	MAPPING("net.winches", OPTIONAL, "of motions: cables that winches take in or pay out")
	MAPPING("net.winches.*", OPTIONAL, "the winch of this cable")
	TEXT("net.winches.*.end", REQUIRED, NOWHERE, NULL, "the node where it is")
	NUMBER("net.winches.*.speed", ONE_OF, "m/s", ANY, WINCH_AT(speed), NULL,
	       "rate of the unstretched length: negative takes in")
	NUMBER("net.winches.*.rise", OPTIONAL, "s", NOT_NEGATIVE, WINCH_AT(rise), "0",
	       "time in which the speed rises from 0, smoothly")
	NUMBER("net.winches.*.tension", ONE_OF, "N", POSITIVE, WINCH_AT(tension), NULL,
	       "tension at its end that it holds")
	NUMBER("net.winches.*.limit", OPTIONAL, "m/s", POSITIVE, WINCH_AT(limit), NULL,
	       "its largest speed then, where the tension differs by 5 %; linear between")
	WATER("net.water", NET_AT)
	MAPPING("net.wind", OPTIONAL, "steady wind, whose force follows the motion of the cables")
	NUMBER("net.wind.speed", REQUIRED, "m/s", NOT_NEGATIVE, WIND_AT(speed), NULL, "its speed")
	VECTOR("net.wind.direction", 3, OPTIONAL, "1", ANY, WIND_AT(direction), "[0, 0, 1]",
	       "direction towards which it blows; its length does not matter")
	NUMBER("net.wind.density", REQUIRED, "kg/m^3", POSITIVE, WIND_AT(density), NULL,
	       "density of the air")
	LIST("net.wind.profile", OPTIONAL, "its speed at heights over wind.speed, linear between")
	VECTOR("net.wind.profile[]", 2, OPTIONAL, "m, 1", ANY, NOWHERE, NULL,
	       "[y, factor], heights in ascending order")
	WORD("net.wind.form", OPTIONAL, "cubic|exact", WIND_AT(form), "cubic", "its force in reduced "
	     "models: to the third power of velocities, or integrated at every instant; integrate of the "
	     "mesh has the whole force")
	SECTION_IN_WIND("net.wind", "0")
	LIST("net.obstacles", OPTIONAL, "surfaces that the nodes of the mesh do not pass")
	MAPPING("net.obstacles[]", OPTIONAL, "a surface")
	TEXT("net.obstacles[].name", OPTIONAL, NOWHERE, "s0, s1 and so on", "name")
	SHAPE("net.obstacles[].plane", ONE_OF, SURFACE_AT(kind), "a plane")
	PLACE_OR("net.obstacles[].plane.point", 3, REQUIRED, "m", SURFACE_AT(at), "a point of it")
	PLACE_OR("net.obstacles[].plane.normal", 3, REQUIRED, "1", SURFACE_AT(normal),
	         "normal towards the net")
	SHAPE("net.obstacles[].segment", ONE_OF, SURFACE_AT(kind), "a segment, which extends along z")
	VECTOR("net.obstacles[].segment.from", 2, REQUIRED, "m", ANY, SURFACE_AT(at), NULL,
	       "[x, y] of its first end")
	VECTOR("net.obstacles[].segment.to", 2, REQUIRED, "m", ANY, SURFACE_AT(to), NULL,
	       "[x, y] of its last end")
	CIRCLE("net.obstacles[].circle", ONE_OF, SURFACE_AT(kind), SURFACE_AT(at), SURFACE_AT(radius))
	VECTOR("net.obstacles[].circle.centre", 3, REQUIRED, "m", ANY, SURFACE_AT(at), NULL,
	       "[x, y, z] of its centre, with that of its groove")
	ROW("net.obstacles[].profile", LIST, 0, "", ANY, 0, 0, ONE_OF, NOWHERE, 1, SURFACE_AT(kind), NULL,
	    "a bed along x below the net, which extends along z: its places, between them straight; "
	    "corners are rounded over an element")
	VECTOR("net.obstacles[].profile[]", 2, OPTIONAL, "m", ANY, NOWHERE, NULL, "[x, y], x rising")
	ROW("net.obstacles[].grid", TEXT, 0, "", ANY, 0, 0, ONE_OF, SURFACE_AT(file), 1, SURFACE_AT(kind),
	    NULL, "file of a bed below the net: points x y z in m, y upwards, every x with every z; or "
	    "the bathymetry of MoorDyn and MoorPy; rounded as profiles")
	NUMBER("net.obstacles[].rounding", OPTIONAL, "m", POSITIVE, SURFACE_AT(rounding), "an element",
	       "of a profile or grid: distance from a corner to where its rounding begins, at most half "
	       "way to the next one")
	WORD("net.obstacles[].side", OPTIONAL, "above|below|left|right|inside|around", SURFACE_AT(side),
	     "above", "side where the net is: left or right of a vertical segment, inside a circle, or "
	     "around one, as a belt: then all nodes must have places, cables begin straight between "
	     "them, and supports need not hold the net")
	NUMBER("net.obstacles[].friction", OPTIONAL, "1", NOT_NEGATIVE, SURFACE_AT(friction), "0",
	       "coefficient of friction")
	SECTION("net.obstacles[].friction", OPTIONAL, "of a plane that moves: an ellipse")
	NUMBER("net.obstacles[].friction.axial", REQUIRED, "1", POSITIVE, SURFACE_AT(axial), NULL,
	       "coefficient along cables")
	NUMBER("net.obstacles[].friction.transverse", REQUIRED, "1", POSITIVE, SURFACE_AT(friction), NULL,
	       "coefficient across them")
	NUMBER("net.obstacles[].stiffness", OPTIONAL, "Pa/m", POSITIVE, SURFACE_AT(stiffness), "rigid",
	       "of a plane, profile or grid that gives way, as a seabed: force per unstretched length over "
	       "the diameter and the depth")
	NUMBER("net.obstacles[].damping", OPTIONAL, "Pa.s/m", NOT_NEGATIVE, SURFACE_AT(damping), "0",
	       "of this: the same over the rate of the depth, in motions; it does not pull")
	NUMBER("net.obstacles[].velocity", OPTIONAL, "m/s", ANY, SURFACE_AT(speed), NULL,
	       "speed of the surface along a segment or profile, or counterclockwise around a circle")
	PLACE_OR("net.obstacles[].velocity", 3, OPTIONAL, "m/s", SURFACE_AT(velocity),
	         "velocity of a plane, along it")
	WORD("net.obstacles[].groove", OPTIONAL, "no|yes", SURFACE_AT(groove), "no",
	     "whether a groove of a circle holds along z what touches")
	WORD("net.obstacles[].rotation", OPTIONAL, "locked|free|drive", SURFACE_AT(rotation), "locked",
	     "of a circle: free turns without resistance, so that friction does not change tensions; "
	     "drive: a motor holds it, or turns it with the velocity")
	NUMBER("net.obstacles[].inertia", OPTIONAL, "kg.m^2", NOT_NEGATIVE, SURFACE_AT(inertia), NULL,
	       "moment of inertia of a circle that turns freely, in modes")
	SECTION("net.contact", OPTIONAL, "contact with the obstacles")
	LIMITED("net.contact.restitution", OPTIONAL, "1", NOT_NEGATIVE, 1.0, NET_AT(contact.restitution),
	        "0", "of impacts in motions: the normal velocity after over the one before, which does "
	        "not grow")
	WORD("net.contact.sliding", OPTIONAL, "none|history|pulled", NET_AT(contact.history), "none",
	     "friction of surfaces that move alone, along the way of the supports to their places, or as "
	     "they were pulled there from where lines hang loose: all of it towards the anchors")
	MAPPING("net.contact.path", OPTIONAL, "ways of supports to their places, of sliding: history: "
	        "from an equilibrium without friction to the places in nodes")
	LIST("net.contact.path.*", OPTIONAL, "places, from the first on")
	VECTOR("net.contact.path.*[]", 3, OPTIONAL, "m", ANY, NOWHERE, NULL, "a place")
	INTEGER("net.contact.steps", OPTIONAL, 1, 100000, NET_AT(contact.steps), "20",
	        "steps between two places")
	WORD("net.contact.modes", OPTIONAL, "statics|slip|stick", NET_AT(contact.modes), "statics",
	     "what the contacts do in vibrations: as in the equilibrium; all slide without resistance; "
	     "or what touches with friction does not move")
};

const struct hawser__tree_table hawser__tree_of_net = {
	"net", "A net of cables", net_rows, sizeof net_rows/sizeof *net_rows, "net", {"nodes"}};

/* Spans over planes and segments, and in water. */
static const struct hawser__tree_key mesh_rows[] = {
	HEAD("mesh", "span", NOT_NEGATIVE, NET_AT(g))
	MAPPING("mesh.cable", REQUIRED, "the cable")
	NUMBER("mesh.cable.EA", REQUIRED, "N", POSITIVE, CABLE_AT(EA), NULL, "axial stiffness")
	NUMBER("mesh.cable.rho", REQUIRED, "kg/m", NOT_NEGATIVE, CABLE_AT(rho), NULL,
	       "mass per unstretched length")
	LINE_IN_WATER("mesh.cable", CABLE_AT)
	INTEGER("mesh.cable.elements", OPTIONAL, 1, 1e6, CABLE_AT(elements), "200", "number of elements")
	MAPPING("mesh.span", REQUIRED, "the positions of the ends")
	NUMBER("mesh.span.d", REQUIRED, "m", POSITIVE, NODE_AT(x[0]), NULL,
	       "horizontal distance of the ends")
	NUMBER("mesh.span.h", OPTIONAL, "m", ANY, NODE_AT(x[1]), "0", "height of end B above end A")
	MAPPING("mesh.tension", REQUIRED, "what fixes the tension")
	NUMBER("mesh.tension.length0", REQUIRED, "m", POSITIVE, CABLE_AT(value), NULL,
	       "unstretched length")
	LIST("mesh.obstacles", OPTIONAL, "as those of nets")
	MAPPING("mesh.contact", OPTIONAL, "as that of nets")
	MAPPING("mesh.water", OPTIONAL, "as that of nets")
	MAPPING("mesh.damping", OPTIONAL, "as that of nets")
	MAPPING("mesh.dynamics", OPTIONAL, "as that of nets")
};

const struct hawser__tree_table hawser__tree_of_mesh = {
	"mesh", "A span that is a mesh", mesh_rows, sizeof mesh_rows/sizeof *mesh_rows, NULL, {NULL}};

/* scene/span_rows.c - the keys of spans. See scene/tree_rows.h. A new key is one row here and one
 * member of struct hawser_scene.
 *
 * The rows of values stand in a macro, which is expanded twice: into the public description of the keys
 * (hawser/scene.h), and into rows as other kinds have them, whose first ones these are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/tree_rows.h"

#define SPAN_AT(member) offsetof(struct hawser_scene, member)
#define PLACE_AT(member) offsetof(struct hawser_attachment, member)
#define PIECE_AT(member) offsetof(struct hawser_load_piece, member)
#define CASE_AT(member) offsetof(struct hawser_case, member)

#define SUPPORT(TO, end, of) \
	TO##_VECTOR("span.support." end ".stiffness", 3, OPTIONAL, "N/m", POSITIVE_OR_INF, \
	    SPAN_AT(of.stiffness), "[.inf, .inf, .inf]", \
	    "stiffness of the springs along x, y and z on which end " end " is held; .inf: rigid in " \
	    "this direction; see ELASTIC SUPPORTS") \
	TO##_NUMBER("span.support." end ".mass", OPTIONAL, "kg", NOT_NEGATIVE, SPAN_AT(of.mass), "0", \
	    "mass that moves with end " end " on its springs") \
	TO##_VECTOR("span.support." end ".motion", 3, OPTIONAL, "m", ANY, SPAN_AT(of.motion), "[0, 0, 0]", \
	    "amplitudes of the displacement of end " end " along x, y and z: " \
	    "motion*cos(harmonic*Omega*t + phase)") \
	TO##_NUMBER("span.support." end ".phase", OPTIONAL, "rad", ANY, SPAN_AT(of.phase), "0", \
	    "phase of the displacement of end " end "; the load has phase 0") \
	TO##_INTEGER("span.support." end ".harmonic", OPTIONAL, 1, 20, SPAN_AT(of.harmonic), "1", \
	    "frequency of the displacement of end " end ", as a multiple of the forcing frequency Omega")

/* Beside the rows of tree_rows.h: a number or words for 0 and infinity, a whole number or a word for 0,
 * and those that exclude each other, whose `member` of an enumeration goes to `pick`. */
#define TABLE(TO) \
	TO##_NUMBER("span.g", OPTIONAL, "m/s^2", POSITIVE, SPAN_AT(g), "9.81", \
	    "acceleration of gravity, downwards") \
	TO##_NUMBER("span.cable.EA", REQUIRED, "N", POSITIVE_OR_INF, SPAN_AT(cable.EA), NULL, \
	    "axial stiffness; .inf makes it inextensible, for statics only") \
	TO##_NUMBER("span.cable.rho", REQUIRED, "kg/m", POSITIVE, SPAN_AT(cable.rho), NULL, \
	    "mass per unstretched length") \
	TO##_NUMBER("span.cable.EI", OPTIONAL, "N.m^2", NOT_NEGATIVE, SPAN_AT(cable.EI), "0", \
	    "bending stiffness, against changes of the static shape; see BENDING") \
	TO##_NUMBER_OR("span.ends.A", "pinned|clamped", "N.m", NOT_NEGATIVE_OR_INF, SPAN_AT(ends[0]), "0", \
	    "end A with cable.EI: pinned, clamped, or a rotational stiffness in N.m per radian") \
	TO##_NUMBER_OR("span.ends.B", "pinned|clamped", "N.m", NOT_NEGATIVE_OR_INF, SPAN_AT(ends[1]), "0", \
	    "the same for end B") \
	TO##_NUMBER("span.span.d", REQUIRED, "m", POSITIVE, SPAN_AT(span.d), NULL, \
	    "horizontal distance between the ends") \
	TO##_NUMBER("span.span.h", REQUIRED, "m", ANY, SPAN_AT(span.h), NULL, \
	    "height of end B above end A; negative if B is lower") \
	TO##_NUMBER_CHOICE("span.tension.H", "N", POSITIVE, ONE_OF, SPAN_AT(tension.given), \
	    HAWSER_GIVEN_H, SPAN_AT(tension.value), "horizontal component of the tension") \
	TO##_NUMBER_CHOICE("span.tension.T0", "N", POSITIVE, ONE_OF, SPAN_AT(tension.given), \
	    HAWSER_GIVEN_T0, SPAN_AT(tension.value), \
	    "tension at end A") \
	TO##_NUMBER_CHOICE("span.tension.T1", "N", POSITIVE, ONE_OF, SPAN_AT(tension.given), \
	    HAWSER_GIVEN_T1, SPAN_AT(tension.value), \
	    "tension at end B") \
	TO##_NUMBER_CHOICE("span.tension.length0", "m", POSITIVE, ONE_OF, SPAN_AT(tension.given), \
	    HAWSER_GIVEN_LENGTH0, SPAN_AT(tension.value), \
	    "unstretched length of the cable") \
	TO##_NUMBER_CHOICE("span.tension.sag", "m", POSITIVE, ONE_OF, SPAN_AT(tension.given), \
	    HAWSER_GIVEN_SAG, SPAN_AT(tension.value), \
	    "largest vertical distance of the cable from its chord") \
	TO##_WORD("span.tension.branch", OPTIONAL, "taut|slack", SPAN_AT(tension.branch), "taut", \
	    "taut or slack equilibrium with the given T0 or T1; only with one of these") \
	TO##_WORD("span.tension.state", OPTIONAL, "reference|loaded", SPAN_AT(tension.state), "reference", \
	    "state to which the given quantity belongs: reference, without load.static and change " \
	    "of temperature; or loaded, with them; see STATIC LOADS AND TEMPERATURE") \
	TO##_NUMBER("span.travel.speed", REQUIRED, "m/s", ANY, SPAN_AT(travel.speed), NULL, \
	    "speed of the cable from end A to end B: unstretched length per time that passes a " \
	    "support") \
	TO##_WORD("span.travel.hold", REQUIRED, "tension|length", SPAN_AT(travel.hold), NULL, \
	    "quantity that keeps its value at rest when the cable travels: tension (the given one, " \
	    "or T0 if sag or length0 is given), as with a counterweight; or length, the unstretched " \
	    "length between the ends") \
	TO##_NUMBER("span.travel.fluctuation", OPTIONAL, "m/s", NOT_NEGATIVE, SPAN_AT(travel.fluctuation), \
	    "0", \
	    "amplitude V of the fluctuating speed, speed + V sin(Omega t)") \
	TO##_NUMBER("span.travel.braking", OPTIONAL, "s", NOT_NEGATIVE, SPAN_AT(travel.braking), "0", \
	    "duration, from t = 0, of a linear change of the speed to final, with constant " \
	    "unstretched length between the ends; for hawser integrate; 0: constant speed") \
	TO##_NUMBER("span.travel.final", OPTIONAL, "m/s", ANY, SPAN_AT(travel.final), "0", \
	    "speed after braking") \
	SUPPORT(TO, "A", support[0]) \
	SUPPORT(TO, "B", support[1]) \
	TO##_NUMBER_CHOICE("span.damping.alpha", "kg/m/s", NOT_NEGATIVE, AT_MOST_ONE, \
	    SPAN_AT(damping.kind), HAWSER_DAMPING_ALPHA, SPAN_AT(damping.alpha), \
	    "viscous force per unstretched length and velocity") \
	TO##_NUMBER("span.damping.rayleigh.mass", REQUIRED, "1/s", NOT_NEGATIVE, SPAN_AT(damping.mass), \
	    NULL, \
	    "factor of the mass matrix") \
	TO##_NUMBER("span.damping.rayleigh.stiffness", REQUIRED, "s", NOT_NEGATIVE, \
	    SPAN_AT(damping.stiffness), NULL, \
	    "factor of the stiffness matrix") \
	TO##_SERIES_CHOICE("span.damping.ratio", "1", NOT_NEGATIVE, AT_MOST_ONE, SPAN_AT(damping.kind), \
	    HAWSER_DAMPING_RATIO, SPAN_AT(damping.ratio), \
	    "fraction of critical damping: one number for every mode, or a list for the modes 1, 2, " \
	    "... of hawser modes; the last value of the list holds for all higher modes") \
	TO##_NUMBER("span.damping.drag", OPTIONAL, "kg/m^2", NOT_NEGATIVE, SPAN_AT(damping.drag), "0", \
	    "quadratic drag of air at rest, besides the damping above: force per unstretched length " \
	    "over the square of the velocity normal to the cable, which is density times drag " \
	    "coefficient times diameter over 2; for hawser integrate and hawser frf, with no " \
	    "horizontal static load") \
	TO##_NUMBER("span.wind.speed", REQUIRED, "m/s", NOT_NEGATIVE, SPAN_AT(wind.speed), NULL, \
	    "speed of the wind; see WIND") \
	TO##_VECTOR("span.wind.direction", 3, OPTIONAL, "1", ANY, SPAN_AT(wind.direction), "[0, 0, 1]", \
	    "direction towards which it blows, along x, y, z; its length does not matter, and its part " \
	    "along the cable has no effect") \
	TO##_NUMBER("span.wind.density", REQUIRED, "kg/m^3", POSITIVE, SPAN_AT(wind.density), NULL, \
	    "density of the air, or of the water") \
	TO##_NUMBER("span.wind.diameter", REQUIRED, "m", POSITIVE, SPAN_AT(wind.diameter), NULL, \
	    "diameter to which drag and lift refer") \
	TO##_NUMBER("span.wind.angle", OPTIONAL, "rad", ANY, SPAN_AT(wind.angle), "0", \
	    "angle of attack of the cable at rest, such as that of its ice: it is added to the angle " \
	    "that the motion of the cable gives the wind") \
	TO##_SERIES("span.wind.drag", "1", SPAN_AT(wind.drag), "0", \
	    "drag coefficient: a number, or a list of the factors of the powers 0, 1, 2, ... of the " \
	    "angle of attack in rad, which is positive for wind from below") \
	TO##_SERIES("span.wind.lift", "1", SPAN_AT(wind.lift), "0", \
	    "lift coefficient, likewise, positive upwards") \
	TO##_NUMBER("span.wind.viscosity", OPTIONAL, "m^2/s", NOT_NEGATIVE, SPAN_AT(wind.viscosity), "0", \
	    "kinematic viscosity of the air, for wind.reynolds") \
	TO##_WORD("span.wind.form", OPTIONAL, "cubic|exact", SPAN_AT(wind.form), "cubic", \
	    "force of the wind on the moving cable: cubic, to the third power of its velocity, as terms " \
	    "of the reduced model; or exact, integrated along the cable at every instant, for hawser " \
	    "integrate") \
	TO##_NUMBER("span.wind.wake.strouhal", OPTIONAL, "1", POSITIVE, SPAN_AT(wind.wake.strouhal), \
	    "0.2", \
	    "Strouhal's number: frequency of the vortices of a cable at rest over speed/diameter") \
	TO##_NUMBER("span.wind.wake.lift", OPTIONAL, "1", NOT_NEGATIVE, SPAN_AT(wind.wake.lift), "0.3", \
	    "amplitude of the lift coefficient of a cable at rest") \
	TO##_NUMBER("span.wind.wake.A", OPTIONAL, "1", NOT_NEGATIVE, SPAN_AT(wind.wake.A), "12", \
	    "coupling of the wake to the acceleration of the cable over the diameter") \
	TO##_NUMBER("span.wind.wake.epsilon", OPTIONAL, "1", NOT_NEGATIVE, SPAN_AT(wind.wake.epsilon), \
	    "0.3", "growth of the wake's oscillation from rest") \
	TO##_NUMBER("span.wind.wake.fluid_damping", OPTIONAL, "1", NOT_NEGATIVE, \
	    SPAN_AT(wind.wake.fluid_damping), "0.8", \
	    "damping across the flow, C_D/(4 pi strouhal); 0 with wind.drag, which damps by itself") \
	TO##_NUMBER("span.wind.wake.added_mass", OPTIONAL, "1", NOT_NEGATIVE, \
	    SPAN_AT(wind.wake.added_mass), "1", \
	    "mass of the fluid that moves with the cable over that of the displaced fluid; it has no " \
	    "weight") \
	TO##_INTEGER_OR("span.wind.wake.at", "modes", 1, 64, SPAN_AT(wind.wake.places), "modes", \
	    "an oscillator for each mode (modes), or this number of them at the middles of equal parts " \
	    "of the cable, which may have different speeds (wind.profile)") \
	TO##_WORD("span.load.frame", TOGETHER, "local|global", SPAN_AT(load.frame), NULL, \
	    "axes of the load: local is tangent, normal, binormal (e, n, z), global is x, y, z") \
	TO##_VECTOR("span.load.per_length", 3, TOGETHER, "N/m", ANY, SPAN_AT(load.per_length), NULL, \
	    "amplitude of the harmonic load per unstretched length along the three axes") \
	TO##_VECTOR("span.load.extent", 2, OPTIONAL, "1", INCREASING, SPAN_AT(load.extent), "[0, 1]", \
	    "loaded part, as fractions of the unstretched length from end A") \
	TO##_WORD("span.load.static.frame", OPTIONAL, "global", SPAN_AT(static_load.frame), "global", \
	    "axes of the static load: x, y, z") \
	TO##_VECTOR("span.load.static.per_length", 3, OPTIONAL, "N/m", ANY, \
	    SPAN_AT(static_load.per_length), "[0, 0, 0]", \
	    "constant force per unstretched length along x, y, z, in addition to the weight, such " \
	    "as a steady wind") \
	TO##_NUMBER("span.load.static.mass", OPTIONAL, "kg/m", NOT_NEGATIVE, SPAN_AT(static_load.mass), \
	    "0", \
	    "mass per unstretched length of what adheres to the cable, such as ice: its weight acts " \
	    "downwards, and its inertia is added to that of the cable") \
	TO##_NUMBER("span.temperature.change", REQUIRED, "K", CHANGE, SPAN_AT(temperature.change), NULL, \
	    "temperature minus that of the reference state: a difference, not a temperature in " \
	    "kelvin") \
	TO##_NUMBER("span.temperature.expansion", REQUIRED, "1/K", ANY, SPAN_AT(temperature.expansion), \
	    NULL, \
	    "relative change of the unstretched length per change of temperature") \
	TO##_POSITION("span.attach[].at", REQUIRED, INSIDE, PLACE_AT(at), NULL, \
	    "position on the cable from end A: a fraction of the unstretched length, such as 40 %, " \
	    "or an unstretched length, such as 12 m") \
	TO##_NUMBER("span.attach[].mass", OPTIONAL, "kg", NOT_NEGATIVE, PLACE_AT(mass), "0", \
	    "point mass; its weight is part of the static equilibrium") \
	TO##_VECTOR("span.attach[].force", 3, OPTIONAL, "N", ANY, PLACE_AT(force), "[0, 0, 0]", \
	    "dead force along x, y, z, part of the static equilibrium; it has no inertia") \
	TO##_VECTOR("span.attach[].spring", 3, OPTIONAL, "N/m", NOT_NEGATIVE, PLACE_AT(spring), \
	    "[0, 0, 0]", \
	    "springs to ground along x, y, z, unstressed in the static equilibrium") \
	TO##_VECTOR("span.attach[].damper", 3, OPTIONAL, "N.s/m", NOT_NEGATIVE, PLACE_AT(damper), \
	    "[0, 0, 0]", \
	    "viscous dampers along the axes of damper_frame") \
	TO##_WORD("span.attach[].damper_frame", OPTIONAL, "global|local", PLACE_AT(damper_local), \
	    "global", "axes of the dampers: global is x, y, z; local is tangent, normal, binormal of " \
	    "the cable at rest (e, n, z), for a damper across a stay") \
	TO##_WORD("span.attach[].damper_to", OPTIONAL, "ground|A|B", PLACE_AT(damper_to), "ground", \
	    "what they are fixed to: the ground, or what end A or B is fixed to, such as a deck that " \
	    "moves with it") \
	TO##_NUMBER("span.attach[].absorber_mass", OPTIONAL, "kg", NOT_NEGATIVE, PLACE_AT(absorber_mass), \
	    "0", \
	    "mass of an absorber, which moves along a direction relative to the point, on a spring " \
	    "and a damper between both; its weight is part of the static equilibrium") \
	TO##_NUMBER("span.attach[].absorber_stiffness", OPTIONAL, "N/m", NOT_NEGATIVE, \
	    PLACE_AT(absorber_stiffness), "0", \
	    "spring between the absorber's mass and the point") \
	TO##_NUMBER("span.attach[].absorber_damping", OPTIONAL, "N.s/m", NOT_NEGATIVE, \
	    PLACE_AT(absorber_damping), "0", \
	    "damper between the absorber's mass and the point") \
	TO##_NUMBER("span.attach[].absorber_cubic", OPTIONAL, "N/m^3", NOT_NEGATIVE, \
	    PLACE_AT(absorber_cubic), "0", \
	    "cubic spring between both, parallel to the linear one: its force is this times the " \
	    "cube of the displacement from the position at rest (a nonlinear energy sink)") \
	TO##_VECTOR("span.attach[].absorber_direction", 3, OPTIONAL, "1", ANY, \
	    PLACE_AT(absorber_direction), "[0, 1, 0]", \
	    "direction in which the absorber's mass moves relative to the point, along x, y, z; its " \
	    "length does not matter") \
	TO##_TEXT("span.attach[].name", OPTIONAL, NOWHERE, "", \
	    "name for messages, pictures and --set attach.NAME.KEY") \
	TO##_VECTOR("span.loads[].per_length", 3, OPTIONAL, "N/m", ANY, PIECE_AT(per_length), "[0, 0, 0]", \
	    "amplitude of a force per unstretched length along the three axes") \
	TO##_POSITION("span.loads[].from", OPTIONAL, WITHIN, PIECE_AT(from), "0", \
	    "begin of the part on which per_length acts, from end A: a fraction of the unstretched " \
	    "length, such as 20 %, or an unstretched length, such as 12 m") \
	TO##_POSITION("span.loads[].to", OPTIONAL, WITHIN, PIECE_AT(to), "1", "end of this part") \
	TO##_NUMBER("span.loads[].wave", OPTIONAL, "m", ANY, PIECE_AT(wave), "0", \
	    "wavelength, in unstretched length, of a per_length that runs along the cable: towards " \
	    "end B, or towards end A if it is negative; 0: the whole part in phase") \
	TO##_VECTOR("span.loads[].force", 3, OPTIONAL, "N", ANY, PIECE_AT(force), "[0, 0, 0]", \
	    "amplitude of a force at a point along the three axes, in place of per_length") \
	TO##_POSITION("span.loads[].at", OPTIONAL, INSIDE, PIECE_AT(at), "", \
	    "point of the force: a fraction of the unstretched length or an unstretched length") \
	TO##_WORD("span.loads[].frame", OPTIONAL, "local|global", PIECE_AT(frame), "global", \
	    "axes of per_length and force: local is tangent, normal, binormal (e, n, z), global is " \
	    "x, y, z") \
	TO##_INTEGER("span.loads[].harmonic", OPTIONAL, 1, 20, PIECE_AT(harmonic), "1", \
	    "frequency of the piece, as a multiple of the forcing frequency Omega") \
	TO##_NUMBER("span.loads[].phase", OPTIONAL, "rad", ANY, PIECE_AT(phase), "0", \
	    "phase of the piece; the section load has phase 0") \
	TO##_TEXT("span.loads[].name", OPTIONAL, NOWHERE, "", \
	    "name for messages and --set loads.NAME.KEY") \
	TO##_INTEGER_OR("span.model.modes", "auto", 1, 1000, SPAN_AT(model.modes), "5", \
	    "number of modes kept, the lowest of both planes together; auto chooses the modes that " \
	    "the accuracy requires; in a wind without a load, those up to the last that grows up to " \
	    "twice its speed") \
	TO##_NUMBER("span.model.accuracy", OPTIONAL, "1", OPEN_UNIT, SPAN_AT(model.accuracy), "0.005", \
	    "with modes: auto, required relative error of the folds (Omega) and peaks (Omega, " \
	    "amplitude) of displacement components with at least half of the largest amplitude; see " \
	    "hawser-frf(1)") \
	TO##_INTEGER("span.model.basis", OPTIONAL, 0, 100000, SPAN_AT(model.basis), "0", \
	    "number of functions per component for the modes; 0: as many as the tolerance requires " \
	    "(16 for the exact energy, 24 with cable.EI)") \
	TO##_NUMBER("span.model.tolerance", OPTIONAL, "1", OPEN_UNIT, SPAN_AT(model.tolerance), "1e-10", \
	    "required relative error of the frequencies of the modes kept") \
	TO##_WORD("span.model.condense", OPTIONAL, "static|none", SPAN_AT(model.condense), "static", \
	    "treatment of the modes not kept: static condensation, or none: their coordinates are 0") \
	TO##_WORD("span.model.inertia", OPTIONAL, "auto|none", SPAN_AT(model.inertia), "auto", \
	    "with condense: static, inertia of the condensed modes: auto adds shapes that represent " \
	    "it as coordinates if it changes a resonance frequency by more than 2e-4; none neglects " \
	    "it") \
	TO##_WORD("span.model.energy", OPTIONAL, "quartic|exact|auto", SPAN_AT(model.energy), "auto", \
	    "strain energy: quartic, a polynomial of degree 4, right up to the amplitudes that " \
	    "hawser rom tells; exact, a full-order model with all basis functions; or auto, " \
	    "quartic, and exact where the response shows that the polynomial is not good enough " \
	    "(hawser-frf(1))") \
	TO##_NUMBER_CHOICE("span.beam.mu", "1", POSITIVE, ONE_OF, SPAN_AT(beam.form), HAWSER_BEAM_MU, \
	    SPAN_AT(beam.mu), \
	    "L sqrt(T/EI) with the tension T at the outlet; the units are L for lengths and L^2 " \
	    "sqrt(rhoA/EI) for times, so that rigidity and mass are 1 (Dehadrai 2018, 8.3.1)") \
	TO##_NUMBER_CHOICE("span.beam.theta", "1", NOT_NEGATIVE, ONE_OF, SPAN_AT(beam.form), \
	    HAWSER_BEAM_THETA, SPAN_AT(beam.theta), \
	    "EI/(T L^2); the units are L for lengths and L sqrt(rhoA/T) for times, so that tension " \
	    "and mass are 1 (Dehadrai 2018, 9.3.1); 0 is a string (8.3.4 there)") \
	TO##_NUMBER("span.beam.rho", OPTIONAL, "1", ANY, SPAN_AT(beam.rho), NULL, \
	    "scaled weight along the direction of travel: decrease of the tension from the upper to " \
	    "the lower end, w L^3/EI with mu, w L/T with theta; like c, slenderness and v only with " \
	    "mu or theta") \
	TO##_NUMBER("span.beam.c", OPTIONAL, "1", NOT_NEGATIVE, SPAN_AT(beam.c), "0", \
	    "viscous force per length and velocity of the material") \
	TO##_NUMBER("span.beam.slenderness", OPTIONAL, "1", NOT_NEGATIVE, SPAN_AT(beam.slenderness), "0", \
	    "L sqrt(A/I) with mu, its inverse with theta; 0: without rotary inertia") \
	TO##_NUMBER("span.beam.v", OPTIONAL, "1", ANY, SPAN_AT(beam.v), "0", \
	    "speed from the lower to the upper end") \
	TO##_NUMBER_CHOICE("span.beam.EI", "N.m^2", NOT_NEGATIVE, ONE_OF, SPAN_AT(beam.form), \
	    HAWSER_BEAM_EI, SPAN_AT(beam.EI), \
	    "bending rigidity, of a beam in SI; 0 is a string") \
	TO##_NUMBER("span.beam.rhoA", OPTIONAL, "kg/m", POSITIVE, SPAN_AT(beam.rhoA), NULL, \
	    "mass per length; only with EI, like all following keys up to speed") \
	TO##_NUMBER("span.beam.L", OPTIONAL, "m", POSITIVE, SPAN_AT(beam.L), NULL, \
	    "distance of the supports") \
	TO##_NUMBER("span.beam.tension_end", OPTIONAL, "N", POSITIVE, SPAN_AT(beam.tension_end), NULL, \
	    "tension at the outlet, which is the upper end unless the beam is level") \
	TO##_NUMBER("span.beam.drag", OPTIONAL, "kg/m/s", NOT_NEGATIVE, SPAN_AT(beam.drag), "0", \
	    "viscous force per length and velocity of the material") \
	TO##_NUMBER("span.beam.gyration", OPTIONAL, "m", NOT_NEGATIVE, SPAN_AT(beam.gyration), "0", \
	    "radius of gyration of the cross-section, sqrt(I/A); 0: without rotary inertia") \
	TO##_WORD_CHOICE("span.beam.gravity", "along|across|none", AT_MOST_ONE, SPAN_AT(beam.weight), \
	    HAWSER_WEIGHT_GRAVITY, SPAN_AT(beam.gravity), \
	    "along: the beam travels vertically upwards, and its weight reduces the tension towards " \
	    "the lower end; across: it travels horizontally, and its weight only causes a static " \
	    "deflection") \
	TO##_NUMBER_CHOICE("span.beam.inclination", "rad", RIGHT_ANGLE, AT_MOST_ONE, SPAN_AT(beam.weight), \
	    HAWSER_WEIGHT_INCLINATION, SPAN_AT(beam.inclination), \
	    "angle of the direction of travel above the horizontal, in place of gravity; if it is " \
	    "negative, the tension is given at the lower end") \
	TO##_NUMBER("span.beam.speed", OPTIONAL, "m/s", ANY, SPAN_AT(beam.speed), "0", \
	    "speed towards the end at which the tension is given") \
	TO##_WORD("span.beam.ends", OPTIONAL, "simple|clamped", SPAN_AT(beam.ends), "simple", \
	    "supports: simple (deflection 0) or clamped (deflection and slope 0)") \
	TO##_WORD("span.beam.moment", OPTIONAL, "free|balanced", SPAN_AT(beam.moment), "free", \
	    "bending moment at simple ends with rotary inertia: free (0), or balanced (equal to the " \
	    "flux of rotary momentum through the support)")

/* A path without "span." */
#define KEY(path, unit, type, words, range, given, doc) \
	{&(path)[5], unit, type, words, range, given, doc},
#define RANGE_ANY "finite"
#define RANGE_POSITIVE "> 0"
#define RANGE_POSITIVE_OR_INF "> 0 or .inf"
#define RANGE_NOT_NEGATIVE ">= 0"
#define RANGE_NOT_NEGATIVE_OR_INF ">= 0 or .inf"
#define RANGE_RIGHT_ANGLE "within [-pi/2, pi/2]"
#define RANGE_OPEN_UNIT "between 0 and 1"
#define RANGE_INCREASING "within [0, 1], increasing"
#define RANGE_CHANGE "within [-300, 300]"
#define RANGE_WITHIN "within [0, 1], or a length >= 0"
#define RANGE_INSIDE "between 0 and 1, or a length > 0"

#define KEY_NUMBER(path, need, unit, range, at, given, doc) \
	KEY(path, unit, "number", NULL, RANGE_##range, given, doc)
#define KEY_NUMBER_OR(path, words, unit, range, at, given, doc) \
	KEY(path, unit, "number", words, RANGE_##range, given, doc)
#define KEY_NUMBER_CHOICE(path, unit, range, need, pick, member, at, doc) \
	KEY(path, unit, "number", NULL, RANGE_##range, NULL, doc)
#define KEY_SERIES_CHOICE(path, unit, range, need, pick, member, at, doc) \
	KEY(path, unit, "series", NULL, RANGE_##range, NULL, doc)
#define KEY_SERIES(path, unit, at, given, doc) KEY(path, unit, "series", NULL, "finite", given, doc)
#define KEY_VECTOR(path, count, need, unit, range, at, given, doc) \
	KEY(path, unit, "numbers[" #count "]", NULL, RANGE_##range, given, doc)
#define KEY_INTEGER(path, need, least, most, at, given, doc) \
	KEY(path, "1", "integer", NULL, "within [" #least ", " #most "]", given, doc)
#define KEY_INTEGER_OR(path, words, least, most, at, given, doc) \
	KEY(path, "1", "integer", words, "within [" #least ", " #most "]", given, doc)
#define KEY_WORD(path, need, words, at, given, doc) KEY(path, "", "word", words, "", given, doc)
#define KEY_WORD_CHOICE(path, words, need, pick, member, at, doc) \
	KEY(path, "", "word", words, "", NULL, doc)
#define KEY_POSITION(path, need, range, at, given, doc) \
	KEY(path, "1", "place", NULL, RANGE_##range, given, doc)
#define KEY_TEXT(path, need, at, given, doc) \
	KEY(path, "", "name", NULL, "letters, digits, _ and -, not a number", given, doc)

static const struct hawser_scene_key keys[] = {TABLE(KEY)};

enum { KEYS = sizeof keys/sizeof *keys };
_Static_assert((int)KEYS <= (int)HAWSER_SCENE_KEYS, "struct hawser_scene has room for so many keys");
_Static_assert(sizeof(enum hawser_hold) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_branch) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_state) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_condensation) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_inertia) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_beam_gravity) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_frame) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_energy) == sizeof(int), "a word is stored as an int");
_Static_assert(sizeof(enum hawser_wind_form) == sizeof(int), "a word is stored as an int");

#define ROW_NUMBER NUMBER
#define ROW_NUMBER_OR(path, words, unit, range, at, given, doc) \
	NUMBER(path, OPTIONAL, unit, range, at, given, doc)
#define ROW_NUMBER_CHOICE(path, unit, range, need, pick, member, at, doc) \
	{path, HAWSER__TREE_NUMBER, 0, unit, range, 0, 0, need, at, 1, pick, member, NULL, doc},
#define ROW_SERIES_CHOICE ROW_NUMBER_CHOICE
#define ROW_SERIES(path, unit, at, given, doc) NUMBER(path, OPTIONAL, unit, ANY, at, given, doc)
#define ROW_VECTOR VECTOR
#define ROW_INTEGER INTEGER
#define ROW_INTEGER_OR(path, words, least, most, at, given, doc) \
	INTEGER(path, OPTIONAL, least, most, at, given, doc)
#define ROW_WORD WORD
#define ROW_WORD_CHOICE(path, words, need, pick, member, at, doc) \
	{path, HAWSER__TREE_WORD, 0, words, ANY, 0, 0, need, at, 1, pick, member, NULL, doc},
#define ROW_POSITION POSITION
#define ROW_TEXT TEXT

#define LIST_OF_MOST(path, most, doc) \
	ROW(path, LIST, 0, "", ANY, 0, most, OPTIONAL, NOWHERE, 1, NOWHERE, NULL, doc)

static const struct hawser__tree_key span_rows[] = {
	/* cppcheck-suppress unknownMacro ; TABLE joins the names of the others */
	TABLE(ROW)
	SECTION("span.cable", REQUIRED, "the cable, uniform along its unstretched length")
	SECTION("span.ends", OPTIONAL,
	        "how the ends of a cable with cable.EI are held against rotation, in both planes")
	SECTION("span.span", REQUIRED, "the positions of the ends: A at the origin, B at (d, h)")
	SECTION("span.tension", REQUIRED,
	        "the quantity that determines the tension at rest: one of H, T0, T1, length0 and sag")
	SECTION("span.travel", OPTIONAL,
	        "the cable moves along itself, in at one end and out at the other")
	SECTION("span.support", OPTIONAL,
	        "springs on which the ends are held, and their prescribed harmonic motion; an end "
	        "that is not given is rigid and at rest")
	SECTION("span.support.A", OPTIONAL, "end A")
	SECTION("span.support.B", OPTIONAL, "end B")
	SECTION("span.damping", OPTIONAL,
	        "at most one kind of damping; without this section there is none. The dampers of "
	        "attachments add to it. Ratios are of the modes, without these dampers, also where "
	        "the model has only some of the modes or has the full energy; of a travelling cable "
	        "they are those of the apparent cable. Condensed modes respond without damping")
	{"span.damping.rayleigh", HAWSER__TREE_MAPPING, 0, "", ANY, 0, 0, AT_MOST_ONE, 0, 1,
	 SPAN_AT(damping.kind), HAWSER_DAMPING_RAYLEIGH, NULL,
	 "damping proportional to mass and stiffness; both factors are required"},
	SECTION("span.wind", OPTIONAL,
	        "steady wind whose force follows the motion of the cable; what it does to the cable at "
	        "rest is added to load.static")
	SECTION("span.wind.wake", OPTIONAL,
	        "oscillators for the vortices behind the cable; the defaults are those of Facchinetti, de "
	        "Langre, Biolley (2004). {} has all defaults")
	LIST("span.wind.drag", OPTIONAL, "of the powers 0, 1, 2, ... of the angle of attack")
	NUMBER("span.wind.drag[]", OPTIONAL, "1", ANY, NOWHERE, NULL, "factor of a power")
	LIST("span.wind.lift", OPTIONAL, "of the powers 0, 1, 2, ... of the angle of attack")
	NUMBER("span.wind.lift[]", OPTIONAL, "1", ANY, NOWHERE, NULL, "factor of a power")
	LIST_OF_MOST("span.wind.profile", HAWSER_WIND_ROWS,
	             "speed along the cable over wind.speed, linear between these places")
	VECTOR("span.wind.profile[]", 2, OPTIONAL, "1", NOT_NEGATIVE, NOWHERE, NULL,
	       "[place, factor]: fraction of the unstretched length from end A, in ascending order, and "
	       "the speed there over wind.speed")
	LIST_OF_MOST("span.wind.table", HAWSER_WIND_ROWS,
	             "drag and lift as a table, in place of wind.drag and wind.lift; a cubic spline goes "
	             "through it, which keeps its end values outside")
	VECTOR("span.wind.table[]", 3, OPTIONAL, "rad, 1, 1", ANY, NOWHERE, NULL,
	       "[angle of attack, drag coefficient, lift coefficient], angles in ascending order")
	TEXT("span.wind.table", OPTIONAL, NOWHERE, NULL,
	     "a file of such rows, a line each, in rad; in degrees if a first line of names has deg in it")
	LIST_OF_MOST("span.wind.reynolds", HAWSER_WIND_ROWS,
	             "drag coefficient at the angle of attack 0 over Reynolds' number, in place of "
	             "the first one of wind.drag; a cubic spline, as wind.table")
	VECTOR("span.wind.reynolds[]", 2, OPTIONAL, "1", ANY, NOWHERE, NULL,
	       "[Reynolds' number of the relative wind, drag coefficient], in ascending order")
	TEXT("span.wind.reynolds", OPTIONAL, NOWHERE, NULL, "a file of such rows")
	SECTION("span.load", OPTIONAL,
	        "a distributed load that varies as the cosine of the forcing phase")
	SECTION("span.load.static", OPTIONAL,
	        "a uniform load that is constant in time. A section load with nothing else is no "
	        "varying load")
	SECTION("span.temperature", OPTIONAL,
	        "a uniform change of the temperature of the cable; both keys are required")
	SECTION("span.model", OPTIONAL, "the reduced model. All keys have defaults")
	SECTION("span.beam", OPTIONAL,
	        "a beam or string that travels along itself between two supports, for hawser-beam(1); "
	        "it replaces cable, span, tension and all other sections")
	LIST_OF_MOST("span.attach", HAWSER_ATTACH_MAX,
	             "point masses on the cable, with springs, dampers, forces and absorbers")
	MAPPING("span.attach[]", OPTIONAL, "an attachment")
	LIST_OF_MOST("span.loads", HAWSER_LOADS_MAX,
	             "varying loads, which add to each other and to the section load")
	MAPPING("span.loads[]", OPTIONAL, "a load")
	LIST_OF_MOST("span.cases", HAWSER_CASES_MAX,
	             "load cases, for hawser statics --cases")
	MAPPING("span.cases[]", OPTIONAL, "a load case")
	TEXT("span.cases[].name", REQUIRED, NOWHERE, NULL, "its name: a word or a few")
	SECTION("span.cases[].load", OPTIONAL, "in place of the static load of the scene")
	SECTION("span.cases[].load.static", REQUIRED, "as load.static")
	WORD("span.cases[].load.static.frame", OPTIONAL, "global", CHECKED, "global",
	     "as load.static.frame")
	VECTOR("span.cases[].load.static.per_length", 3, OPTIONAL, "N/m", ANY, CASE_AT(per_length),
	       "[0, 0, 0]", "as load.static.per_length")
	NUMBER("span.cases[].load.static.mass", OPTIONAL, "kg/m", NOT_NEGATIVE, CASE_AT(mass), "0",
	       "as load.static.mass")
	SECTION("span.cases[].temperature", OPTIONAL, "in place of that of the scene")
	NUMBER("span.cases[].temperature.change", REQUIRED, "K", CHANGE, CASE_AT(change), NULL,
	       "as temperature.change")
	NUMBER("span.cases[].temperature.expansion", OPTIONAL, "1/K", ANY, CASE_AT(expansion), NULL,
	       "as temperature.expansion, which holds without it")
	SECTION("span.cases[].wind", OPTIONAL, "a speed in place of that of the scene's wind; without it, "
	        "the case is calm")
	NUMBER("span.cases[].wind.speed", REQUIRED, "m/s", NOT_NEGATIVE, CASE_AT(wind), NULL,
	       "as wind.speed")
	WORD("span.kind", OPTIONAL, "span", CHECKED, NULL, "kind of the scene")
	/* further forms of values above */
	LIMIT("span.ends.A", "pinned|clamped", SPAN_AT(ends[0]), NULL, "a hinge, or held")
	LIMIT("span.ends.B", "pinned|clamped", SPAN_AT(ends[1]), NULL, "a hinge, or held")
	WORD("span.model.modes", OPTIONAL, "auto", SPAN_AT(model.modes), NULL, "as the accuracy requires")
	WORD("span.wind.wake.at", OPTIONAL, "modes", SPAN_AT(wind.wake.places), NULL, "one for each mode")
	LIST("span.damping.ratio", AT_MOST_ONE, "of the modes 1, 2, ... of hawser modes")
	NUMBER("span.damping.ratio[]", OPTIONAL, "1", NOT_NEGATIVE, NOWHERE, NULL, "ratio of a mode")
};
const struct hawser__tree_table hawser__tree_of_span = {
	"span", "A span of cable", span_rows, sizeof span_rows/sizeof *span_rows, "span", {NULL}};

const struct hawser_scene_key *hawser_scene_key(int index)
{
	return index >= 0 && index < KEYS ? &keys[index] : NULL;
}

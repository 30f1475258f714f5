/* scene/keys.c - the table of keys. A new key is one ROW here and one field in struct
 * hawser_scene: reading, checking, --set, hawser_scene_get and hawser-scene(5) follow.
 *
 * The table is expanded twice: into the public description of the keys (hawser/scene.h) and into
 * the internal one, with the place and type of the stored value (keys.h). Defaults are text in SI,
 * read by the same code as the values of the user.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "scene/keys.h"

/* ROW(path, unit, type, words, range, default, field, group, member, doc) */
#define TABLE(ROW) \
	ROW("g", "m/s^2", NUMBER, NULL, POSITIVE, "9.81", g, FREE, 0, \
	    "acceleration of gravity, downwards") \
	ROW("cable.EA", "N", NUMBER, NULL, POSITIVE_OR_INF, NULL, cable.EA, FREE, 0, \
	    "axial stiffness; .inf makes it inextensible, for statics only") \
	ROW("cable.rho", "kg/m", NUMBER, NULL, POSITIVE, NULL, cable.rho, FREE, 0, \
	    "mass per unstretched length") \
	ROW("cable.EI", "N.m^2", NUMBER, NULL, NOT_NEGATIVE, "0", cable.EI, FREE, 0, \
	    "bending stiffness, against changes of the static shape; see BENDING") \
	ROW("ends.A", "N.m", NUMBER, "pinned|clamped", NOT_NEGATIVE_OR_INF, "0", ends[0], FREE, 0, \
	    "end A with cable.EI: pinned, clamped, or a rotational stiffness in N.m per radian") \
	ROW("ends.B", "N.m", NUMBER, "pinned|clamped", NOT_NEGATIVE_OR_INF, "0", ends[1], FREE, 0, \
	    "the same for end B") \
	ROW("span.d", "m", NUMBER, NULL, POSITIVE, NULL, span.d, FREE, 0, \
	    "horizontal distance between the ends") \
	ROW("span.h", "m", NUMBER, NULL, ANY, NULL, span.h, FREE, 0, \
	    "height of end B above end A; negative if B is lower") \
	ROW("tension.H", "N", NUMBER, NULL, POSITIVE, NULL, tension.value, TENSION, \
	    HAWSER_GIVEN_H, "horizontal component of the tension") \
	ROW("tension.T0", "N", NUMBER, NULL, POSITIVE, NULL, tension.value, TENSION, \
	    HAWSER_GIVEN_T0, "tension at end A") \
	ROW("tension.T1", "N", NUMBER, NULL, POSITIVE, NULL, tension.value, TENSION, \
	    HAWSER_GIVEN_T1, "tension at end B") \
	ROW("tension.length0", "m", NUMBER, NULL, POSITIVE, NULL, tension.value, TENSION, \
	    HAWSER_GIVEN_LENGTH0, "unstretched length of the cable") \
	ROW("tension.sag", "m", NUMBER, NULL, POSITIVE, NULL, tension.value, TENSION, \
	    HAWSER_GIVEN_SAG, "largest vertical distance of the cable from its chord") \
	ROW("tension.branch", "", WORD, "taut|slack", WORDS, "taut", tension.branch, FREE, 0, \
	    "taut or slack equilibrium with the given T0 or T1; only with one of these") \
	ROW("tension.state", "", WORD, "reference|loaded", WORDS, "reference", tension.state, FREE, 0, \
	    "state to which the given quantity belongs: reference, without load.static and change of " \
	    "temperature; or loaded, with them; see STATIC LOADS AND TEMPERATURE") \
	ROW("travel.speed", "m/s", NUMBER, NULL, ANY, NULL, travel.speed, FREE, 0, \
	    "speed of the cable from end A to end B: unstretched length per time that passes a support") \
	ROW("travel.hold", "", WORD, "tension|length", WORDS, NULL, travel.hold, FREE, 0, \
	    "quantity that keeps its value at rest when the cable travels: tension (the given one, or T0 " \
	    "if sag or length0 is given), as with a counterweight; or length, the unstretched length " \
	    "between the ends") \
	ROW("travel.fluctuation", "m/s", NUMBER, NULL, NOT_NEGATIVE, "0", travel.fluctuation, FREE, 0, \
	    "amplitude V of the fluctuating speed, speed + V sin(Omega t)") \
	ROW("travel.braking", "s", NUMBER, NULL, NOT_NEGATIVE, "0", travel.braking, FREE, 0, \
	    "duration, from t = 0, of a linear change of the speed to final, with constant unstretched " \
	    "length between the ends; for hawser integrate; 0: constant speed") \
	ROW("travel.final", "m/s", NUMBER, NULL, ANY, "0", travel.final, FREE, 0, \
	    "speed after braking") \
	ROW("support.A.stiffness", "N/m", TRIPLE, NULL, POSITIVE_OR_INF, "[.inf, .inf, .inf]", \
	    support[0].stiffness, FREE, 0, \
	    "stiffness of the springs along x, y and z on which end A is held; .inf: rigid in this " \
	    "direction; see ELASTIC SUPPORTS") \
	ROW("support.A.mass", "kg", NUMBER, NULL, NOT_NEGATIVE, "0", support[0].mass, FREE, 0, \
	    "mass that moves with end A on its springs") \
	ROW("support.A.motion", "m", TRIPLE, NULL, ANY, "[0, 0, 0]", support[0].motion, FREE, 0, \
	    "amplitudes of the displacement of end A along x, y and z: motion*cos(harmonic*Omega*t + " \
	    "phase)") \
	ROW("support.A.phase", "rad", NUMBER, NULL, ANY, "0", support[0].phase, FREE, 0, \
	    "phase of the displacement of end A; the load has phase 0") \
	ROW("support.A.harmonic", "1", INTEGER, NULL, MULTIPLE, "1", support[0].harmonic, FREE, 0, \
	    "frequency of the displacement of end A, as a multiple of the forcing frequency Omega") \
	ROW("support.B.stiffness", "N/m", TRIPLE, NULL, POSITIVE_OR_INF, "[.inf, .inf, .inf]", \
	    support[1].stiffness, FREE, 0, \
	    "stiffness of the springs along x, y and z on which end B is held") \
	ROW("support.B.mass", "kg", NUMBER, NULL, NOT_NEGATIVE, "0", support[1].mass, FREE, 0, \
	    "mass that moves with end B on its springs") \
	ROW("support.B.motion", "m", TRIPLE, NULL, ANY, "[0, 0, 0]", support[1].motion, FREE, 0, \
	    "amplitudes of the displacement of end B along x, y and z") \
	ROW("support.B.phase", "rad", NUMBER, NULL, ANY, "0", support[1].phase, FREE, 0, \
	    "phase of the displacement of end B") \
	ROW("support.B.harmonic", "1", INTEGER, NULL, MULTIPLE, "1", support[1].harmonic, FREE, 0, \
	    "frequency of the displacement of end B, as a multiple of the forcing frequency Omega") \
	ROW("damping.alpha", "kg/m/s", NUMBER, NULL, NOT_NEGATIVE, NULL, damping.alpha, DAMPING, \
	    HAWSER_DAMPING_ALPHA, "viscous force per unstretched length and velocity") \
	ROW("damping.rayleigh.mass", "1/s", NUMBER, NULL, NOT_NEGATIVE, NULL, damping.mass, \
	    DAMPING, HAWSER_DAMPING_RAYLEIGH, "factor of the mass matrix") \
	ROW("damping.rayleigh.stiffness", "s", NUMBER, NULL, NOT_NEGATIVE, NULL, \
	    damping.stiffness, DAMPING, HAWSER_DAMPING_RAYLEIGH, \
	    "factor of the stiffness matrix") \
	ROW("damping.ratio", "1", SERIES, NULL, NOT_NEGATIVE, NULL, damping.ratio, DAMPING, \
	    HAWSER_DAMPING_RATIO, "fraction of critical damping: one number for every mode, or a list " \
	    "for the modes 1, 2, ... of hawser modes; the last value of the list holds for all higher " \
	    "modes") \
	ROW("damping.drag", "kg/m^2", NUMBER, NULL, NOT_NEGATIVE, "0", damping.drag, FREE, 0, \
	    "quadratic drag of air at rest, besides the damping above: force per unstretched length over " \
	    "the square of the velocity normal to the cable, which is density times drag coefficient " \
	    "times diameter over 2; for hawser integrate and hawser frf, with no horizontal static load") \
	ROW("load.frame", "", WORD, "local|global", WORDS, NULL, load.frame, FREE, 0, \
	    "axes of the load: local is tangent, normal, binormal (e, n, z), global is x, y, z") \
	ROW("load.per_length", "N/m", TRIPLE, NULL, ANY, NULL, load.per_length, FREE, 0, \
	    "amplitude of the harmonic load per unstretched length along the three axes") \
	ROW("load.extent", "1", PAIR, NULL, INCREASING, "[0, 1]", load.extent, FREE, 0, \
	    "loaded part, as fractions of the unstretched length from end A") \
	ROW("load.static.frame", "", WORD, "global", WORDS, "global", static_load.frame, FREE, 0, \
	    "axes of the static load: x, y, z") \
	ROW("load.static.per_length", "N/m", TRIPLE, NULL, ANY, "[0, 0, 0]", static_load.per_length, FREE, \
	    0, "constant force per unstretched length along x, y, z, in addition to the weight, such as " \
	    "a steady wind") \
	ROW("load.static.mass", "kg/m", NUMBER, NULL, NOT_NEGATIVE, "0", static_load.mass, FREE, 0, \
	    "mass per unstretched length of what adheres to the cable, such as ice: its weight acts " \
	    "downwards, and its inertia is added to that of the cable") \
	ROW("temperature.change", "K", NUMBER, NULL, CHANGE, NULL, temperature.change, FREE, 0, \
	    "temperature minus that of the reference state: a difference, not a temperature in kelvin") \
	ROW("temperature.expansion", "1/K", NUMBER, NULL, ANY, NULL, temperature.expansion, FREE, 0, \
	    "relative change of the unstretched length per change of temperature") \
	ROW("attach.at", "1", PLACE, NULL, INSIDE, NULL, attach[0].at, FREE, 0, \
	    "position on the cable from end A: a fraction of the unstretched length, such as 40 %, or an " \
	    "unstretched length, such as 12 m") \
	ROW("attach.mass", "kg", NUMBER, NULL, NOT_NEGATIVE, "0", attach[0].mass, FREE, 0, \
	    "point mass; its weight is part of the static equilibrium") \
	ROW("attach.force", "N", TRIPLE, NULL, ANY, "[0, 0, 0]", attach[0].force, FREE, 0, \
	    "dead force along x, y, z, part of the static equilibrium; it has no inertia") \
	ROW("attach.spring", "N/m", TRIPLE, NULL, NOT_NEGATIVE, "[0, 0, 0]", attach[0].spring, FREE, 0, \
	    "springs to ground along x, y, z, unstressed in the static equilibrium") \
	ROW("attach.damper", "N.s/m", TRIPLE, NULL, NOT_NEGATIVE, "[0, 0, 0]", attach[0].damper, FREE, 0, \
	    "viscous dampers to ground along x, y, z") \
	ROW("attach.absorber_mass", "kg", NUMBER, NULL, NOT_NEGATIVE, "0", attach[0].absorber_mass, \
	    FREE, 0, "mass of an absorber, which moves along a direction relative to the point, on a " \
	    "spring and a damper between both; its weight is part of the static equilibrium") \
	ROW("attach.absorber_stiffness", "N/m", NUMBER, NULL, NOT_NEGATIVE, "0", \
	    attach[0].absorber_stiffness, FREE, 0, "spring between the absorber's mass and the point") \
	ROW("attach.absorber_damping", "N.s/m", NUMBER, NULL, NOT_NEGATIVE, "0", \
	    attach[0].absorber_damping, FREE, 0, "damper between the absorber's mass and the point") \
	ROW("attach.absorber_cubic", "N/m^3", NUMBER, NULL, NOT_NEGATIVE, "0", attach[0].absorber_cubic, \
	    FREE, 0, "cubic spring between both, parallel to the linear one: its force is this times the " \
	    "cube of the displacement from the position at rest (a nonlinear energy sink)") \
	ROW("attach.absorber_direction", "1", TRIPLE, NULL, ANY, "[0, 1, 0]", \
	    attach[0].absorber_direction, FREE, 0, "direction in which the absorber's mass moves " \
	    "relative to the point, along x, y, z; its length does not matter") \
	ROW("attach.name", "", NAME, NULL, NAMES, "", attach[0].name, FREE, 0, \
	    "name for messages, pictures and --set attach.NAME.KEY") \
	ROW("loads.per_length", "N/m", TRIPLE, NULL, ANY, "[0, 0, 0]", piece[0].per_length, FREE, 0, \
	    "amplitude of a force per unstretched length along the three axes") \
	ROW("loads.from", "1", PLACE, NULL, WITHIN, "0", piece[0].from, FREE, 0, \
	    "begin of the part on which per_length acts, from end A: a fraction of the unstretched " \
	    "length, such as 20 %, or an unstretched length, such as 12 m") \
	ROW("loads.to", "1", PLACE, NULL, WITHIN, "1", piece[0].to, FREE, 0, \
	    "end of this part") \
	ROW("loads.wave", "m", NUMBER, NULL, ANY, "0", piece[0].wave, FREE, 0, \
	    "wavelength, in unstretched length, of a per_length that runs along the cable: towards end " \
	    "B, or towards end A if it is negative; 0: the whole part in phase") \
	ROW("loads.force", "N", TRIPLE, NULL, ANY, "[0, 0, 0]", piece[0].force, FREE, 0, \
	    "amplitude of a force at a point along the three axes, in place of per_length") \
	ROW("loads.at", "1", PLACE, NULL, INSIDE, "", piece[0].at, FREE, 0, \
	    "point of the force: a fraction of the unstretched length or an unstretched length") \
	ROW("loads.frame", "", WORD, "local|global", WORDS, "global", piece[0].frame, FREE, 0, \
	    "axes of per_length and force: local is tangent, normal, binormal (e, n, z), global is x, y, " \
	    "z") \
	ROW("loads.harmonic", "1", INTEGER, NULL, MULTIPLE, "1", piece[0].harmonic, FREE, 0, \
	    "frequency of the piece, as a multiple of the forcing frequency Omega") \
	ROW("loads.phase", "rad", NUMBER, NULL, ANY, "0", piece[0].phase, FREE, 0, \
	    "phase of the piece; the section load has phase 0") \
	ROW("loads.name", "", NAME, NULL, NAMES, "", piece[0].name, FREE, 0, \
	    "name for messages and --set loads.NAME.KEY") \
	ROW("model.modes", "1", INTEGER, "auto", MODES, "5", model.modes, FREE, 0, \
	    "number of modes kept, the lowest of both planes together; auto chooses the modes that the " \
	    "accuracy requires") \
	ROW("model.accuracy", "1", NUMBER, NULL, OPEN_UNIT, "0.005", model.accuracy, FREE, 0, \
	    "with modes: auto, required relative error of the folds (Omega) and peaks (Omega, amplitude) " \
	    "of displacement components with at least half of the largest amplitude; see hawser-frf(1)") \
	ROW("model.basis", "1", INTEGER, NULL, BASIS, "0", model.basis, FREE, 0, \
	    "number of functions per component for the modes; 0: as many as the tolerance requires (16 " \
	    "for the exact energy, 24 with cable.EI)") \
	ROW("model.tolerance", "1", NUMBER, NULL, OPEN_UNIT, "1e-10", model.tolerance, FREE, 0, \
	    "required relative error of the frequencies of the modes kept") \
	ROW("model.condense", "", WORD, "static|none", WORDS, "static", model.condense, FREE, 0, \
	    "treatment of the modes not kept: static condensation, or none: their coordinates are 0") \
	ROW("model.inertia", "", WORD, "auto|none", WORDS, "auto", model.inertia, FREE, 0, \
	    "with condense: static, inertia of the condensed modes: auto adds shapes that represent it " \
	    "as coordinates if it changes a resonance frequency by more than 2e-4; none neglects it") \
	ROW("model.energy", "", WORD, "quartic|exact|auto", WORDS, "auto", model.energy, FREE, 0, \
	    "strain energy: quartic, a polynomial of degree 4, right up to the amplitudes that hawser " \
	    "rom tells; exact, a full-order model with all basis functions; or auto, quartic, and exact " \
	    "where the response shows that the polynomial is not good enough (hawser-frf(1))") \
	ROW("beam.mu", "1", NUMBER, NULL, POSITIVE, NULL, beam.mu, BEAM, HAWSER_BEAM_MU, \
	    "L sqrt(T/EI) with the tension T at the outlet; the units are L for lengths and " \
	    "L^2 sqrt(rhoA/EI) for times, so that rigidity and mass are 1 (Dehadrai 2018, 8.3.1)") \
	ROW("beam.theta", "1", NUMBER, NULL, NOT_NEGATIVE, NULL, beam.theta, BEAM, HAWSER_BEAM_THETA, \
	    "EI/(T L^2); the units are L for lengths and L sqrt(rhoA/T) for times, so that tension and " \
	    "mass are 1 (Dehadrai 2018, 9.3.1); 0 is a string (8.3.4 there)") \
	ROW("beam.rho", "1", NUMBER, NULL, ANY, NULL, beam.rho, FREE, 0, \
	    "scaled weight along the direction of travel: decrease of the tension from the upper to the " \
	    "lower end, w L^3/EI with mu, w L/T with theta; like c, slenderness and v only with mu or " \
	    "theta") \
	ROW("beam.c", "1", NUMBER, NULL, NOT_NEGATIVE, "0", beam.c, FREE, 0, \
	    "viscous force per length and velocity of the material") \
	ROW("beam.slenderness", "1", NUMBER, NULL, NOT_NEGATIVE, "0", beam.slenderness, FREE, 0, \
	    "L sqrt(A/I) with mu, its inverse with theta; 0: without rotary inertia") \
	ROW("beam.v", "1", NUMBER, NULL, ANY, "0", beam.v, FREE, 0, \
	    "speed from the lower to the upper end") \
	ROW("beam.EI", "N.m^2", NUMBER, NULL, NOT_NEGATIVE, NULL, beam.EI, BEAM, HAWSER_BEAM_EI, \
	    "bending rigidity, of a beam in SI; 0 is a string") \
	ROW("beam.rhoA", "kg/m", NUMBER, NULL, POSITIVE, NULL, beam.rhoA, FREE, 0, \
	    "mass per length; only with EI, like all following keys up to speed") \
	ROW("beam.L", "m", NUMBER, NULL, POSITIVE, NULL, beam.L, FREE, 0, \
	    "distance of the supports") \
	ROW("beam.tension_end", "N", NUMBER, NULL, POSITIVE, NULL, beam.tension_end, FREE, 0, \
	    "tension at the outlet, which is the upper end unless the beam is level") \
	ROW("beam.drag", "kg/m/s", NUMBER, NULL, NOT_NEGATIVE, "0", beam.drag, FREE, 0, \
	    "viscous force per length and velocity of the material") \
	ROW("beam.gyration", "m", NUMBER, NULL, NOT_NEGATIVE, "0", beam.gyration, FREE, 0, \
	    "radius of gyration of the cross-section, sqrt(I/A); 0: without rotary inertia") \
	ROW("beam.gravity", "", WORD, "along|across|none", WORDS, NULL, beam.gravity, WEIGHT, \
	    HAWSER_WEIGHT_GRAVITY, "along: the beam travels vertically upwards, and its weight reduces " \
	    "the tension towards the lower end; across: it travels horizontally, and its weight only " \
	    "causes a static deflection") \
	ROW("beam.inclination", "rad", NUMBER, NULL, RIGHT_ANGLE, NULL, beam.inclination, WEIGHT, \
	    HAWSER_WEIGHT_INCLINATION, "angle of the direction of travel above the horizontal, in place " \
	    "of gravity; if it is negative, the tension is given at the lower end") \
	ROW("beam.speed", "m/s", NUMBER, NULL, ANY, "0", beam.speed, FREE, 0, \
	    "speed towards the end at which the tension is given") \
	ROW("beam.ends", "", WORD, "simple|clamped", WORDS, "simple", beam.ends, FREE, 0, \
	    "supports: simple (deflection 0) or clamped (deflection and slope 0)") \
	ROW("beam.moment", "", WORD, "free|balanced", WORDS, "free", beam.moment, FREE, 0, \
	    "bending moment at simple ends with rotary inertia: free (0), or balanced (equal to the flux " \
	    "of rotary momentum through the support)")

#define TEXT_NUMBER "number"
#define TEXT_INTEGER "integer"
#define TEXT_PAIR "numbers[2]"
#define TEXT_TRIPLE "numbers[3]"
#define TEXT_SERIES "series"
#define TEXT_WORD "word"
#define TEXT_PLACE "place"
#define TEXT_NAME "name"

#define RANGE_ANY "finite"
#define RANGE_POSITIVE "> 0"
#define RANGE_POSITIVE_OR_INF "> 0 or .inf"
#define RANGE_NOT_NEGATIVE ">= 0"
#define RANGE_NOT_NEGATIVE_OR_INF ">= 0 or .inf"
#define RANGE_RIGHT_ANGLE "within [-pi/2, pi/2]"
#define RANGE_OPEN_UNIT "between 0 and 1"
#define RANGE_INCREASING "within [0, 1], increasing"
#define RANGE_MODES "within [1, 1000]"
#define RANGE_MULTIPLE "within [1, 20]"
#define RANGE_BASIS "within [0, 100000]"
#define RANGE_WITHIN "within [0, 1], or a length >= 0"
#define RANGE_INSIDE "between 0 and 1, or a length > 0"
#define RANGE_CHANGE "within [-300, 300]"
#define RANGE_NAMES "letters, digits, _ and -, not a number"
#define RANGE_WORDS ""

#define PUBLIC(path, unit, type, words, range, fallback, field, group, member, doc) \
	{path, unit, TEXT_##type, words, RANGE_##range, fallback, doc},
#define INTERNAL(path, unit, type, words, range, fallback, field, group, member, doc) \
	{HAWSER__##type, HAWSER__##range, HAWSER__##group, member, \
	 offsetof(struct hawser_scene, field)},

static const struct hawser_scene_key keys[] = {TABLE(PUBLIC)};
static const struct hawser__row rows[] = {TABLE(INTERNAL)};

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

static const struct hawser__section sections[] = {
	{"cable", 1, "The cable, uniform along its unstretched length."},
	{"ends", 0, "How the ends of a cable with cable.EI are held against rotation, in both planes."},
	{"span", 1, "The positions of the ends: A at the origin, B at (d, h)."},
	{"tension", 1,
	        "The quantity that determines the tension at rest: one of H, T0, T1, length0 and sag."},
	{"travel", 0, "The cable moves along itself, in at one end and out at the other."},
	{"support", 0,
	        "Springs on which the ends are held, and their prescribed harmonic motion; an end that is "
	            "not given is rigid and at rest."},
	{"support.A", 0, "End A."},
	{"support.B", 0, "End B."},
	{"damping", 0,
	        "At most one kind of damping; without this section there is none. The dampers of "
	            "attachments add to it. Ratios are of the modes, without these dampers, also where "
	            "the model has only some of the modes or has the full energy; of a travelling cable "
	            "they are those of the apparent cable. Condensed modes respond without damping."},
	{"damping.rayleigh", 0, "Damping proportional to mass and stiffness; both factors are required."},
	{"load", 0, "A distributed load that varies as the cosine of the forcing phase."},
	{"load.static", 0,
	        "A uniform load that is constant in time. A section load with nothing else is no varying "
	            "load."},
	{"temperature", 0, "A uniform change of the temperature of the cable; both keys are required."},
	{"model", 0, "The reduced model. All keys have defaults."},
	{"beam", 0,
	        "A beam or string that travels along itself between two supports, for hawser-beam(1); it "
	            "replaces cable, span, tension and all other sections."},
};
enum { SECTIONS = sizeof sections/sizeof *sections };

static const struct hawser__choice choices[HAWSER__GROUPS] = {
	[HAWSER__TENSION] = {"tension", "the tension", offsetof(struct hawser_scene, tension.given),
	                     "exactly one of H, T0, T1, length0, sag"},
	[HAWSER__DAMPING] = {"damping", "the kind of damping", offsetof(struct hawser_scene, damping.kind),
	                     "exactly one of alpha, rayleigh, ratio"},
	[HAWSER__BEAM] = {"beam", "the scale of the beam", offsetof(struct hawser_scene, beam.form),
	                  "exactly one of mu (Dehadrai 2018, 8.3.1), theta (9.3.1 there) and EI (SI)"},
	[HAWSER__WEIGHT] = {"beam", "the direction of the weight",
	                    offsetof(struct hawser_scene, beam.weight),
	                    "exactly one of gravity and inclination"},
};

const struct hawser_scene_key *hawser_scene_key(int index)
{
	return index >= 0 && index < KEYS ? &keys[index] : NULL;
}

const struct hawser__row *hawser__rows(void)
{
	return rows;
}

const struct hawser__section *hawser__sections(size_t *count)
{
	*count = SECTIONS;
	return sections;
}

const struct hawser__choice *hawser__choice(enum hawser__group group)
{
	return &choices[group];
}

int hawser__key_find(const char *path)
{
	for (int i = 0; i < KEYS; i++)
		if (!strcmp(keys[i].path, path))
			return i;
	return -1;
}

int hawser__section_find(const char *path)
{
	for (int i = 0; i < SECTIONS; i++)
		if (!strcmp(sections[i].path, path))
			return i;
	return -1;
}

int hawser__type_count(enum hawser__type type)
{
	return type == HAWSER__PAIR ? 2 : type == HAWSER__TRIPLE ? 3 : 0;
}

int hawser__count(const struct hawser_scene *scene, int index)
{
	return rows[index].type == HAWSER__SERIES ? scene->damping.ratios
	                                          : hawser__type_count(rows[index].type);
}

int hawser__in_range(int index, double value)
{
	switch (rows[index].range) {
	case HAWSER__POSITIVE_OR_INF: return value > 0.0;
	case HAWSER__POSITIVE: return value > 0.0 && isfinite(value);
	case HAWSER__NOT_NEGATIVE_OR_INF: return value >= 0.0;
	case HAWSER__NOT_NEGATIVE: return value >= 0.0 && isfinite(value);
	case HAWSER__RIGHT_ANGLE: return fabs(value) <= 1.5707963267948968; /* pi/2 rounded,
	                                                                     * inclusive */
	case HAWSER__OPEN_UNIT: return value > 0.0 && value < 1.0;
	case HAWSER__INCREASING: return value >= 0.0 && value <= 1.0;
	case HAWSER__MODES: return value >= 1.0 && value <= 1000.0;
	case HAWSER__MULTIPLE: return value >= 1.0 && value <= 20.0;
	case HAWSER__CHANGE: return fabs(value) <= 300.0; /* K: beyond, expansion is not linear */
	case HAWSER__BASIS: return value >= 0.0 && value <= 100000.0;
	case HAWSER__WITHIN: return value >= 0.0 && isfinite(value);
	case HAWSER__INSIDE: return value > 0.0 && isfinite(value);
	case HAWSER__ANY:
	case HAWSER__NAMES:
	case HAWSER__WORDS: break;
	}
	return isfinite(value);
}

int hawser__chosen(const struct hawser_scene *scene, enum hawser__group group)
{
	int member;

	memcpy(&member, (const char *)scene + choices[group].offset, sizeof member);
	return member;
}

void hawser__choose(struct hawser_scene *scene, enum hawser__group group, int member)
{
	memcpy((char *)scene + choices[group].offset, &member, sizeof member);
}

/* 1 if a key of a beam, other than the one that selects the form, applies to the form of this
 * scene. */
static int of_beam(const struct hawser_scene *scene, const char *leaf)
{
	static const char *const scaled[] = {"rho", "c", "slenderness", "v"};

	if (!strcmp(leaf, "ends") || !strcmp(leaf, "moment"))
		return scene->beam.form != HAWSER_BEAM_NONE;
	for (size_t i = 0; i < sizeof scaled/sizeof *scaled; i++)
		if (!strcmp(leaf, scaled[i]))
			return scene->beam.form == HAWSER_BEAM_MU || scene->beam.form == HAWSER_BEAM_THETA;
	return scene->beam.form == HAWSER_BEAM_EI;
}

int hawser__applies(const struct hawser_scene *scene, int index)
{
	const struct hawser__row *row = &rows[index];

	if (row->group != HAWSER__FREE)
		return hawser__chosen(scene, row->group) == row->member &&
		       (row->group != HAWSER__WEIGHT || scene->beam.form == HAWSER_BEAM_EI);
	if (hawser__child_of(keys[index].path, "beam"))
		return of_beam(scene, hawser__leaf(keys[index].path));
	if (hawser__list_of(index)) /* items.c has the items */
		return 0;
	if (scene->beam.form)
		return !strcmp(keys[index].path, "g");
	if (hawser__child_of(keys[index].path, "load"))
		return scene->load.present;
	if (hawser__child_of(keys[index].path, "load.static"))
		return scene->static_load.present;
	if (hawser__child_of(keys[index].path, "temperature"))
		return scene->temperature.present;
	if (!strcmp(keys[index].path, "tension.state"))
		return scene->static_load.present || scene->temperature.present;
	if (hawser__child_of(keys[index].path, "support.A"))
		return scene->support[0].present;
	if (hawser__child_of(keys[index].path, "support.B"))
		return scene->support[1].present;
	if (!strcmp(keys[index].path, "damping.drag"))
		return scene->damping.drag > 0.0;
	if (hawser__child_of(keys[index].path, "ends"))
		return scene->cable.EI > 0.0;
	if (!strcmp(keys[index].path, "travel.final"))
		return scene->travel.present && scene->travel.braking > 0.0;
	if (hawser__child_of(keys[index].path, "travel"))
		return scene->travel.present;
	if (!strcmp(keys[index].path, "tension.branch"))
		return scene->tension.given == HAWSER_GIVEN_T0 ||
		       scene->tension.given == HAWSER_GIVEN_T1;
	return 1;
}

int hawser__place_in(int index, double value, int by_length)
{
	return hawser__in_range(index, value) &&
	       (by_length || (rows[index].range == HAWSER__INSIDE ? value < 1.0 : value <= 1.0));
}

void *hawser__field(const struct hawser_scene *scene, int index, int item)
{
	const struct hawser__items *list = hawser__list_of(index);

	return (char *)(uintptr_t)scene + rows[index].offset + (list ? (size_t)item*list->size : 0);
}

double hawser__stored(const struct hawser_scene *scene, int index, int element, int item)
{
	const char *at = hawser__field(scene, index, item);
	double number;
	int whole;

	if (rows[index].type == HAWSER__INTEGER) {
		memcpy(&whole, at, sizeof whole);
		return whole;
	}
	memcpy(&number, at + (element > 0 ? (size_t)element : 0)*sizeof number, sizeof number);
	return number;
}

int hawser__is_word(const struct hawser_scene *scene, int index)
{
	if (rows[index].type == HAWSER__INTEGER && keys[index].words)
		return hawser__stored(scene, index, 0, 0) == 0.0;
	return rows[index].type == HAWSER__WORD;
}

void hawser__word(char *word, size_t size, const char *words, int choice)
{
	while (choice-- > 0)
		words += strcspn(words, "|") + 1;
	snprintf(word, size, "%.*s", (int)strcspn(words, "|"), words);
}

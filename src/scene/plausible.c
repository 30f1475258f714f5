/* scene/plausible.c - the table of plausibility bounds, one row per rule.
 *
 * The bounds follow from materials and existing structures, with a margin: a false alarm does more
 * harm than an undetected error by a factor of less than ten. They are to detect factors of a
 * thousand and more.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>

#include <hawser/plausible.h>

#include "scene/keys.h"

static const struct hawser_plausible_rule rules[HAWSER__RULES] = {
	[HAWSER__RULE_LENGTH] = {"the distance of the ends", "", "m", 1e-3, 1e5, "span.d span.h",
		"The longest spans are a few kilometres; a space tether has 30 km."},
	[HAWSER__RULE_GRAVITY] = {"gravity", "", "m/s^2", 0.0, 100.0, "g",
		"981 is in cm/s^2; on Jupiter it is 25 m/s^2."},
	[HAWSER__RULE_MASS] = {"the mass per length", "", "kg/m", 1e-8, 5e4, "cable.rho",
		"Spider silk has 1e-8, the main cable of a suspension bridge 1e4."},
	[HAWSER__RULE_SOUND] = {"the speed of sound along the cable", "sqrt(EA/rho)", "m/s", 100.0,
		15000.0, "cable.EA cable.rho",
		"It is sqrt(E/density): 5000 m/s in steel, 4000 in a rope of it, 500 to 2000 in "
		"polyamide, 10000 in carbon or polyethylene fibres; rubber alone has less than 100."},
	[HAWSER__RULE_STRAIN] = {"the static strain", "largest tension/EA", "", 0.0, 0.05,
		"cable.EA tension",
		"Steel yields below 1 %, and stiff fibres break at 4 %; the material is taken to be linear."},
	[HAWSER__RULE_STRENGTH] = {"the tension per mass", "largest tension/rho", "N m/kg", 0.0, 5e6,
		"tension cable.rho",
		"Steel wire breaks at 0.25e6, and the strongest fibres at 4e6."},
	[HAWSER__RULE_SAG] = {"the sag per distance of the ends", "", "", 0.0, 1000.0,
		"tension cable.rho",
		"A lift's hanging cable may have 100."},
	[HAWSER__RULE_SPEED] = {"the speed of travel", "", "m/s", 0.0, 300.0,
		"travel.speed travel.fluctuation travel.final",
		"A hoist runs at 20 m/s, yarn and wire at 100."},
	[HAWSER__RULE_LOAD] = {"the load on the span per tension",
		"where it is more than ten times the weight", "", 0.0, 1.0, "load.per_length tension",
		"Wind and ice are a few times the weight of a cable."},
	[HAWSER__RULE_DAMPING] = {"the damping ratio of the first mode", "", "", 0.0, 0.3,
		"damping damping.rayleigh.stiffness",
		"Cables have 0.0005 to 0.05 in air; 0.5 is not 0.5 %."},
	[HAWSER__RULE_BEAM_LENGTH] = {"the length", "", "m", 1e-4, 1e5, "beam.L", ""},
	[HAWSER__RULE_BEAM_MASS] = {"the mass per length", "", "kg/m", 1e-8, 5e4, "beam.rhoA", ""},
	[HAWSER__RULE_BEAM_STIFFNESS] = {"the bending rigidity per mass and length",
		"sqrt(EI/rhoA)/L", "m/s", 0.0, 4500.0, "beam.EI beam.rhoA beam.L",
		"It is the speed of sound times the radius of gyration over the length, which in a beam is "
		"far below 0.3."},
	[HAWSER__RULE_BEAM_STRENGTH] = {"the tension per mass", "tension_end/rhoA", "N m/kg", 0.0, 5e6,
		"beam.tension_end beam.rhoA", ""},
	[HAWSER__RULE_BEAM_SPEED] = {"the speed of travel", "", "m/s", 0.0, 300.0, "beam.speed", ""},
};

const struct hawser_plausible_rule *hawser_plausible_rule(int index)
{
	return index >= 0 && index < HAWSER__RULES ? &rules[index] : NULL;
}

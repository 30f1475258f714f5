/* scene/plausible.h - indices of the rules of plausibility.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

/* In the order in which they are reported; those of beams last. */
enum hawser__rule {
	HAWSER__RULE_LENGTH,
	HAWSER__RULE_GRAVITY,
	HAWSER__RULE_MASS,
	HAWSER__RULE_SOUND,
	HAWSER__RULE_STRAIN,
	HAWSER__RULE_STRENGTH,
	HAWSER__RULE_SAG,
	HAWSER__RULE_SPEED,
	HAWSER__RULE_LOAD,
	HAWSER__RULE_DAMPING,
	HAWSER__RULE_BEAM_LENGTH,
	HAWSER__RULE_BEAM_MASS,
	HAWSER__RULE_BEAM_STIFFNESS,
	HAWSER__RULE_BEAM_STRENGTH,
	HAWSER__RULE_BEAM_SPEED,
	HAWSER__RULES
};

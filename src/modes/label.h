/* modes/label.h - norm, sign and names of a mode, whatever method found it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_LABEL_H
#define HAWSER_MODES_LABEL_H

#include <hawser/modes.h>

/* Mode k, whose shape and slope stand on the grid: scale to unit norm, fix the sign, and set family,
 * symmetry and axial_share. Returns the norm that it had. */
double hawser__mode_label(struct hawser_modes *modes, int k);

#endif

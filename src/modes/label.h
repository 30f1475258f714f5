/* modes/label.h - norm, sign and names of a mode, whatever method found it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_LABEL_H
#define HAWSER_MODES_LABEL_H

#include <hawser/modes.h>

/* Room for n modes on a grid of `points` nodes. Status: _MEMORY. */
enum hawser_status hawser__modes_allocate(struct hawser_modes *modes, int n, int points,
                                          struct hawser_report *report);

/* A copy with room for `more` modes behind the others, all zero. Statuses: _MEMORY. */
enum hawser_status hawser__modes_extend(struct hawser_modes *with, const struct hawser_modes *modes,
                                        int more, struct hawser_report *report);

/* Mode k, whose shape and slope are there, gets sign, norm, family, symmetry and participation; returns
 * the norm that it had. */
double hawser__mode_label(struct hawser_modes *modes, int k);

/* Every mode, whose plane, omega, shape and slope are there, gets the rest. The statics must be in
 * *modes. Status: _NAN. */
enum hawser_status hawser__modes_label(struct hawser_modes *modes, struct hawser_report *report);

#endif

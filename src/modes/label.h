/* modes/label.h - norm, sign and names of a mode, whatever method found it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_LABEL_H
#define HAWSER_MODES_LABEL_H

#include <hawser/modes.h>

/* Room for n modes on a grid of `points` nodes. Status: _MEMORY. */
enum hawser_status hawser__modes_allocate(struct hawser_modes *modes, int n, int points,
                                          struct hawser_report *report);

/* Every mode, whose plane, omega, shape and slope are there, gets the rest. The statics must be in
 * *modes. Status: _NAN. */
enum hawser_status hawser__modes_label(struct hawser_modes *modes, struct hawser_report *report);

#endif

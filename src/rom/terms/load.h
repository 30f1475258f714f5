/* rom/terms/load.h - the varying load of a scene as forces on modes: see load.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LOAD_H
#define HAWSER_ROM_LOAD_H

#include <hawser/rom.h>
#include "statics/load.h"

/* The force of harmonic h on mode j, scaled. */
double hawser__loads_work(const struct hawser__loads *loads, int h,
                          const struct hawser_modes *modes, int j);

/* Largest force on mode j of all multiples of the frequency; of a single cosine with its sign. */
double hawser__loads_most(const struct hawser__loads *loads, const struct hawser_modes *modes, int j);

#endif

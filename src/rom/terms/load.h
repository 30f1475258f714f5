/* rom/terms/load.h - the varying load of a scene as forces on modes: see load.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LOAD_H
#define HAWSER_ROM_LOAD_H

#include <hawser/rom.h>
#include "statics/load.h"

/* work [modes->n]: the forces of harmonic h on the modes, scaled. */
enum hawser_status hawser__loads_work(double *work, const struct hawser__loads *loads, int h,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* most [modes->n]: largest forces of all multiples of the frequency; of a single cosine with its
 * sign. */
enum hawser_status hawser__loads_most(double *most, const struct hawser__loads *loads,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* response/branch/collide.h - multipliers that collide, leave the unit circle and return within
 * one step of the continuation. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_COLLIDE_H
#define HAWSER_RESPONSE_COLLIDE_H

#include <complex.h>

#include "response/branch/station.h"

/* Whether two pairs of the m multipliers, or one of undecided ones, may be outside the unit
 * circle somewhere between station[step] and station[step + 1] of four successive stations, at which
 * they are inside. If each pair was identified at all stations, *followed has HAWSER__ALONE where all
 * are inside and the two of none can have met and left the circle, and HAWSER__TOGETHER where no two
 * pairs can have met and left it, nor have met if one is outside. work is [7 m/2]. Reads `turning` of
 * the first station and sets that of the others. */
#define HAWSER__ALONE 1
#define HAWSER__TOGETHER 2
int hawser__collide(int *followed, const struct hawser__station *const station[4], int step, int m,
                    double complex *work);

#endif

/* statics/precision.h - how well double precision determines a static solution.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_PRECISION_H
#define HAWSER_STATICS_PRECISION_H

#include "statics/catenary.h"

/* Largest relative error of H, T0, T1, length0, length and sag by round-off, where `given` is exact
 * and, of a tension, that at `end`. */
double hawser__statics_precision(const struct hawser__catenary *cat,
                                 const struct hawser__chord *chord, enum hawser_given given,
                                 enum hawser__end end);

#endif

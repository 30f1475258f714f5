/* statics/precision.h - estimate of the round-off error of a static solution.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_PRECISION_H
#define HAWSER_STATICS_PRECISION_H

#include "statics/catenary.h"

/* Estimate of the largest relative round-off error of H, T0, T1, length0, length and sag for an
 * exact given quantity; for a given tension, `end` is its end. */
double hawser__statics_precision(const struct hawser__catenary *cat,
                                 const struct hawser__chord *chord, enum hawser_given given,
                                 enum hawser__end end);

#endif

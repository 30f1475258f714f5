/* statics/travel.h - the travelling cable within the statics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_TRAVEL_H
#define HAWSER_STATICS_TRAVEL_H

#include <hawser/statics.h>

/* rho (v^2 + V^2/2), N, of the actual rho. */
static inline double hawser__thrust(const struct hawser_statics *st)
{
	const struct hawser_motion *motion = &st->motion;
	double square = motion->speed*motion->speed + 0.5*motion->fluctuation*motion->fluctuation;

	return st->span.rho/(1.0 - motion->mach2)*square;
}

#endif

/* water/profile.h - the factors of linear waves over the height and over time, of water/waves.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_PROFILE_H
#define HAWSER_WATER_PROFILE_H

#include <hawser/waves.h>

/* C and S of hawser/waves.h at y (m) above the mean surface, in this depth. */
struct hawser__profile {
	double C, S;
};
struct hawser__profile hawser__wave_profile(double k, double y, double depth);

/* The height (m) above the mean surface at which the formulas are taken, for y above it. *beyond: by
 * this more on the tangent there. */
double hawser__wave_height(double *beyond, const struct hawser_waves *waves, double y,
                           double elevation);

/* The flow of waves that have grown, of velocities u and accelerations du along them and upwards. */
void hawser__wave_flow(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                       const double u[2], const double du[2], double t);
/* The factor by which the waves have grown at a time, and its *rate (1/s). */
double hawser__wave_growth(double *rate, const struct hawser_waves *waves, double t);

#endif

/* water/regular.h - a regular wave at its phase, with derivatives: see regular.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_REGULAR_H
#define HAWSER_WATER_REGULAR_H

#include <hawser/waves.h>

/* A wave of any frequency, with the direction, depth, surface and stretching of `of`. */
struct hawser__regular {
	const struct hawser_waves *of;
	double amplitude, phase; /* m, rad */
	double omega, k, slope;  /* rad/s, 1/m; dk/domega, s/m */
};
/* amplitude and phase: those of the scene's wave. */
struct hawser__regular hawser__regular_wave(const struct hawser_waves *waves, double omega, double g);

/* The water at a place: as struct hawser_wave_flow, and the derivatives by the place (entries 0 to 2)
 * and by omega, with the phase omega t held (entry 3). */
struct hawser__regular_flow {
	double elevation, u[3], du[3];
	double elevation_by[4], u_by[3][4], du_by[3][4];
};
/* At x [3] (m), when omega t is tau. Without ramp. */
void hawser__regular_at(struct hawser__regular_flow *flow, const struct hawser__regular *wave,
                        const double x[3], double tau);

#endif

/* hawser/water.h - the water around cables: its level, and how it flows.
 *
 * Axes as for nets: x and z horizontal, y upwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_H
#define HAWSER_WATER_H

#ifdef __cplusplus
extern "C" {
#endif

/* The current at a height. */
struct hawser_water_level {
	double y;    /* m */
	double u[3]; /* m/s */
};

struct hawser_water {
	double density; /* kg/m^3; 0: there is no water */
	double surface; /* m, mean level: above it is no water */
	double depth;   /* m, below the surface; infinite: deep; 0: not given */
	struct hawser_water_level *current; /* [levels] upwards, linear between, and as at the ends beyond
	                                     * them; owned */
	int levels;     /* 0: no current */
};

/* Velocity u[3] (m/s) and, unless NULL, acceleration du[3] (m/s^2) of the water at a place x[3] (m)
 * below the surface and a time t (s). */
void hawser_water_at(double u[3], double du[3], const struct hawser_water *water, const double x[3],
                     double t);

#ifdef __cplusplus
}
#endif
#endif

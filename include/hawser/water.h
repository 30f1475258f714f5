/* hawser/water.h - the water around cables: its level, and how it flows.
 *
 * Axes as for nets: x and z horizontal, y upwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_H
#define HAWSER_WATER_H

#include <hawser/waves.h>

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
	int air;        /* 1: it is the wind of a net, everywhere, without buoyancy and added mass; its
	                 * force is on the cables' sections (struct hawser_net_cable, wind) */
	double depth;   /* m, below the surface; infinite: deep; 0: not given */
	struct hawser_water_level *current; /* [levels] upwards, linear between, and as at the ends beyond
	                                     * them; owned */
	int levels;     /* 0: no current */
	char *file;     /* of velocities over time, lines `t ux uy uz` (s, m/s), a cubic spline, and as at
	                 * the ends beyond: of them `current` has that of t = 0; NULL: none; owned */
	struct hawser_waves_given given; /* the waves as the scene has them */
	struct hawser_waves waves; /* [count] 0: none; owned */
};

/* A round line in the water. Coefficients of the drag are referred to the diameter and to the surface
 * (drag.h), those of the added mass to the mass of the water that the line displaces. */
struct hawser_water_line {
	double diameter;                       /* m */
	double normal, tangential;             /* drag: cn, ct */
	double added_normal, added_tangential; /* added mass */
};

/* A body at a node: a sphere, where the surface cuts it. */
struct hawser_water_buoy {
	double mass;   /* kg */
	double volume; /* m^3 */
	double CdA;    /* m^2: coefficient of the drag times area */
	double added;  /* added mass over that of the water that it displaces */
};

/* Release what it owns; all is zero then. */
void hawser_water_clear(struct hawser_water *water);

#ifdef __cplusplus
}
#endif
#endif

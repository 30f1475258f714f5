/* rom/terms/morison.h - the force of the water on the coordinates of a net's model: see morison.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_MORISON_H
#define HAWSER_ROM_MORISON_H

#include "net/net.h"
#include "net/water/water.h"

enum { HAWSER__MORISON_MOST = 128 }; /* columns: coordinates and motions of supports */

struct hawser__rom_morison {
	struct hawser__mesh mesh; /* lengths, gravity and water alone, as hawser__water_ends reads them */
	struct hawser__mesh_water wet;
	struct hawser_water water;
	struct hawser_water_buoy *buoy; /* [buoys] */
	int elements, buoys;  /* those that have drag or displace water */
	int n, columns, width; /* coordinates; then motions of supports; padded */
	int *node;            /* [2 elements] of the mesh */
	int *k, *sine;        /* [columns - n] those are cos(k tau), or sine */
	double (*place)[3];   /* [2 elements + buoys] m, at the equilibrium: ends of elements, then buoys */
	double *shape;        /* [2 elements + buoys][3][width] m */
	double *spring;       /* [n][columns] N m: of the buoyancy, which K has */
	double *still;        /* [n] N m: the force at the equilibrium, which statics has */
	double time, unit;    /* s, of the model; N m of a coordinate's force */
	int waves;            /* 1: there is a wave, of the model's frequency */
	struct hawser__hold hold;
};

/* a [n] = the acceleration by the water beyond statics, stiffness and added mass; and, unless NULL,
 * its derivatives by_u and by_v [n][n], and by_omega [n] with tau held. `still`: without waves, and
 * with supports at rest. */
void hawser__rom_morison_at(const struct hawser__rom_morison *of, double *a, double *by_u, double *by_v,
                        double *by_omega, const double *u, const double *v, double tau, double omega,
                        int still);
void hawser__rom_morison_free(struct hawser__rom_morison *of);

#endif

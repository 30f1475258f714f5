/* rod/water.h - the loads of the water on a rod, at rest and in motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_WATER_H
#define HAWSER_ROD_WATER_H

#include "net/water/flow.h"

struct hawser__rod_mesh;
struct hawser__rod_motion;

struct hawser__rod_water {
	const struct hawser_water *of;    /* NULL: none, and nothing else is set */
	double part;                      /* of all loads, in statics */
	double band;                      /* m: the rod comes out of the water over this height at least */
	double velocity[3], spin, lift;   /* of the axes in statics, m/s, rad/s about y; their height, m */
	double (*load)[2][3];             /* [elements] N: on both ends, as last found in statics */
	double wet;                       /* m, unstretched length in the water, then */
	struct hawser__water_flow flow;   /* of a motion */
	struct {
		int node;                     /* -1: none */
		struct hawser_water_buoy of;  /* its mass is not used */
	} buoy;                           /* a body at a node */
};

/* Loads on a mesh at rest into mesh->r and, with `tangent`, their derivatives into its matrix. */
void hawser__rod_water_load(struct hawser__rod_mesh *mesh, int tangent);
/* Those of a motion: a hawser__rod_loading, whose data is not used. */
int hawser__rod_water_push(void *data, struct hawser__rod_motion *motion, double t, int tangent);
void hawser__rod_water_still(struct hawser__rod_mesh *mesh);

#endif

/* net/water/water.h - the loads of the water on a mesh, where its nodes are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WATER_H
#define HAWSER_NET_WATER_H

#include "net/net.h"
#include "water/morison.h"

/* Of a mesh in water. Loads go to the ends of elements, drag with the velocity there. */
struct hawser__mesh_water {
	const struct hawser_water *of;
	const struct hawser_water_line **line; /* [elements] */
	const struct hawser__section **section; /* [elements] in the wind, NULL: of one that is not in it;
	                         * all NULL: water */
	double (*dead)[3];      /* [nodes] N: what is in mesh->force without the water */
	double (*load)[2][3];   /* [elements] N: of the water on both ends of an element, as last found */
	double *wet;            /* [elements] m, unstretched length in the water */
	double (*mass)[2][3][3]; /* [elements] kg: added mass of both ends */
	double (*spring)[2][2];  /* [elements] N/m: of the derivatives what is buoyancy, upwards */
	double (*slope)[6][6];  /* [elements] N/m: their derivatives by both ends */
	struct hawser__mesh_buoy {
		int node, element, end; /* it is this end of this element; of bodies 0, where none is */
		const struct hawser_water_buoy *of;
		double load[3], slope[3][3], mass[3][3], spring;
	} *buoy;                /* [buoys] */
	int buoys;
	int follows;            /* 1: mesh->force follows mesh->q (net/water/water-statics.c) */
	double part;            /* of the current: 1, or less on the way to it */
	double least;           /* m: least height over which a line or a buoy comes out of the water */
	double band;            /* m: height over which a line and a buoy come out of the water, if that is
	                         * more than a hundredth of a line's diameter, and the diameter of a buoy */
};

/* d: vector along element e. With slopes = 0, by_r and by_d of what is wet are left as they were. */
void hawser__water_ends(struct hawser__water_end end[2], const struct hawser__mesh *mesh, int e,
                        const double d[3], const struct hawser__water_past past[2], int slopes);
/* Kinetic energy of the water that moves with it, J, for the heights and velocities of its ends. */
double hawser__water_carried(const struct hawser__mesh *mesh, int e, const double d[3],
                             const double height[2], const double *const v[2]);
/* wind.c: the same of a net in the wind, and what it needs. */
void hawser__wind_ends(struct hawser__water_end end[2], const struct hawser__mesh *mesh, int e,
                       const double d[3], const struct hawser__water_past past[2], int slopes);
enum hawser_status hawser__wind_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same of a buoy, without by_d; of by_y the first. */
void hawser__water_buoy(struct hawser__water_end *end, const struct hawser__mesh *mesh,
                        const struct hawser_water_buoy *buoy, const struct hawser__water_past *past);

/* Room for it, and what does not change. Nothing without water. */
enum hawser_status hawser__water_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Loads and derivatives at mesh->q, at rest; mesh->force gets the loads. */
void hawser__water_load(struct hawser__mesh *mesh);
/* Take the derivatives of the loads off a matrix of the mesh, and off its product with u [nodes]. */
struct hawser__klu;
void hawser__water_matrix(struct hawser__klu *klu, const struct hawser__mesh *mesh);
void hawser__water_spread(double (*force)[3], const struct hawser__mesh *mesh, const double (*u)[3]);
/* Added mass number j of the mesh at its places, kg, at a node, which is this end of an element but for
 * those of bodies; returns 0 beyond the last. */
struct hawser__water_mass {
	int node, element, end;
	const double (*mass)[3];
};
int hawser__water_mass(struct hawser__water_mass *at, const struct hawser__mesh *mesh, int j);
/* Stiffness number j of the buoyancy, by the heights of two nodes, N/m, the ends of an element but for
 * bodies; returns 0 beyond the last. */
struct hawser__water_spring {
	int node[2], element;
	double k[2][2];
};
int hawser__water_spring(struct hawser__water_spring *at, const struct hawser__mesh *mesh, int j);
/* 1 if there is a current, so that the loads have no energy. */
int hawser__water_flows(const struct hawser__mesh *mesh);

#endif

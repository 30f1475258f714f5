/* net/water/water.h - the loads of the water on a mesh, where its nodes are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WATER_H
#define HAWSER_NET_WATER_H

#include "net/net.h"

/* Of a mesh in water. Loads go to the ends of elements, drag with the velocity there. */
struct hawser__mesh_water {
	const struct hawser_water *of;
	const struct hawser_water_line **line; /* [elements] */
	double (*dead)[3];      /* [nodes] N: what is in mesh->force without the water */
	double (*load)[2][3];   /* [elements] N: of the water on both ends of an element, as last found */
	double (*slope)[6][6];  /* [elements] N/m: their derivatives by both ends */
	struct hawser__mesh_buoy {
		int node, element, end; /* it is this end of this element */
		const struct hawser_water_buoy *of;
		double load[3], slope[3][3];
	} *buoy;                /* [buoys] */
	int buoys;
	int follows;            /* 1: mesh->force follows mesh->q (net/water/statics.c) */
	double part;            /* of the current: 1, or less on the way to it */
	double band;            /* m: height over which a line comes out of the water, if that is more than
	                         * a hundredth of its diameter */
};

/* What flows past an end of an element. */
struct hawser__water_past {
	double height;     /* m, above the surface */
	double r[3];       /* m/s, of the water relative to the line */
	double du[3], a[3]; /* m/s^2, of the water and of the line */
};
/* What the water does to an end of an element, and the derivatives of the load. */
struct hawser__water_end {
	double load[3], drag[3]; /* N: all, and of it the drag */
	double mass[3][3];       /* kg: added mass */
	double by_r[3][3];       /* by the relative velocity */
	double by_d[3][3];       /* by the vector along the element */
	double by_y[2][3];       /* by the heights of both ends */
};
/* d: vector along element e. */
void hawser__water_ends(struct hawser__water_end end[2], const struct hawser__mesh *mesh, int e,
                        const double d[3], const struct hawser__water_past past[2]);
/* The same of a buoy, without by_d; of by_y the first. */
void hawser__water_buoy(struct hawser__water_end *end, const struct hawser__mesh *mesh,
                        const struct hawser_water_buoy *buoy, const struct hawser__water_past *past);

/* Room for it, and what does not change. Nothing without water. */
enum hawser_status hawser__water_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Loads and derivatives at mesh->q, at rest; mesh->force gets the loads. */
void hawser__water_load(struct hawser__mesh *mesh);
/* 1 if there is a current, so that the loads have no energy. */
int hawser__water_flows(const struct hawser__mesh *mesh);

#endif

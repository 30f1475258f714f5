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

/* Room for it, and what does not change. Nothing without water. */
enum hawser_status hawser__water_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Loads and derivatives at mesh->q, at rest; mesh->force gets the loads. */
void hawser__water_load(struct hawser__mesh *mesh);
/* 1 if there is a current, so that the loads have no energy. */
int hawser__water_flows(const struct hawser__mesh *mesh);

#endif

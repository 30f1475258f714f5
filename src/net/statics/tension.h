/* net/statics/tension.h - tensions at the nodes of a mesh, and what obstacles carry at supports.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_TENSION_H
#define HAWSER_NET_TENSION_H

#include "net/net.h"

struct hawser__tensions {
	const struct hawser__mesh *mesh;
	const struct hawser_net *net;
	const double (*x)[3];        /* [nodes] m */
	const double *T;             /* [elements] N */
	const double (*obstacle)[3]; /* [nodes] N: forces of obstacles; NULL: there are none */
	const double (*v)[3], (*a)[3]; /* [nodes] m/s, m/s^2; NULL: at rest, without harmonic loads */
	double t, far;               /* s; far as in struct hawser__motion */
};
/* Tension at node i of a cable, from its end `from` (0) on, N. */
double hawser__tension_at(const struct hawser__tensions *of, int cable, int i);
/* The vector of that tension, along the cable from its end `from` on. */
void hawser__tension_vector(double t[3], const struct hawser__tensions *of, int cable, int i);
/* The least tension between its nodes i and i + 1, N. */
double hawser__tension_least(const struct hawser__tensions *of, int cable, int i);
/* The forces of obstacles that touch, added to force [nodes][3]. */
void hawser__tension_obstacles(double (*force)[3], const struct hawser__mesh *mesh);
/* What an obstacle carries of the half elements at a node that a support holds on it, N; returns the
 * number of the obstacle, -1 if there is none. *length0: of these halves, m. */
int hawser__tension_rests(double force[3], double *length0, const struct hawser__tensions *of,
                          int node);

#endif

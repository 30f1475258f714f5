/* net/motion/motion-bed.h - planes that give way, in the time steps of a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_BED_H
#define HAWSER_NET_MOTION_BED_H

#include "core/hold.h"
#include "net/motion/motion.h"

/* A node and a plane. */
struct hawser__bed_node {
	int touch;           /* of the mesh */
	double k, c;         /* N/m, N s/m */
	double n0[3], n1[3]; /* normal at both ends of the step */
	double n[3];         /* its mean: the direction of the force */
	double n_x[3][3];    /* 1/m, the derivative of that by the place at the end */
	double v[3];         /* m/s of the surface */
	double s0, s1;       /* m, depth at both ends of the step, below 0 above the plane */
	double more, slope;  /* N, N/m: of touchdowns at it in the step, and by s1 */
	double push[3];      /* the force of the plane, and of friction that slides, over that across it */
};

/* An element that may lie in part. */
struct hawser__touchdown {
	int element, end[2]; /* end: of the list of nodes */
	double k, w, curvature, L;
	double energy0, F0[2]; /* J, N: at the beginning of the step */
	double F_s[2][2];    /* N/m, of its mean force by s1 */
};

struct hawser__bed {
	int nodes, touchdowns;
	double reach;        /* m: an element that is higher is free */
	struct hawser__bed_node *node;
	struct hawser__touchdown *touchdown;
	int *first;          /* [nodes of the motion] 1 + the first of the list that is of it; 0: none */
	struct hawser__hold hold;
};

/* The forces of planes on the mesh, at the end of the last step at rest. */
void hawser__bed_forces(struct hawser__mesh *mesh, const struct hawser__bed *bed);

/* motion-touchdown.c: of an element and the plane at both its ends, but for `end`; 0 if there is none.
 * Its energy (J) at the depths s beyond that of the ends, its derivatives F (N) and theirs, or NULL;
 * a step begins at s0; and its mean force to s1 with the derivative by that. */
int hawser__touchdown_of(struct hawser__touchdown *of, const struct hawser__motion *motion, int e,
                         const struct hawser_surface *plane);
double hawser__touchdown_energy(double F[2], double (*F_s)[2], const struct hawser__touchdown *of,
                                const double s[2]);
void hawser__touchdown_begin(struct hawser__touchdown *of, const double s0[2]);
void hawser__touchdown_mean(double F[2], double (*F_s)[2], const struct hawser__touchdown *of,
                            const double s0[2], const double s1[2]);

#endif

/* net/motion/motion-body.h - rigid bodies in a step.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_BODY_H
#define HAWSER_NET_MOTION_BODY_H

#include <lapacke.h>

#include "net/body.h"
#include "net/motion/motion.h"

struct hawser__motion_body {
	int motions, node;     /* its motions; its hinge, -1: none */
	int along;             /* its farthest node, if all are on a line with its place; else -1 */
	double motion[6][6];   /* columns: displacement, turn */
	double X[3], w[3];     /* m; of the step */
	double by[6];          /* the last correction: displacement, small turn */
	double reach;          /* m, the longest arm */
};

struct hawser__motion_bodies {
	struct hawser__motion_body *body; /* [bodies] */
	int bodies, motions;   /* motions: of all */
	double h;              /* s, of the step */
	double (*r0)[3], (*r1)[3]; /* [nodes] m: arms of nodes of bodies, at both ends of the step */
	double (*F)[3], (*answer)[3]; /* [nodes] N: the residual; work space */
	double (*column)[3];   /* [motions][nodes] answers of all nodes to the motions */
	double *S, *sum;       /* [motions][motions] column by column; [motions] */
	lapack_int *pivot;     /* [motions] */
	struct hawser__hold hold;
};

#endif

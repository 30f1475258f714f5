/* net/balance/nodal.h - sparse matrices over the nodes of a mesh, of square blocks, and their LU
 * factors. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_NODAL_H
#define HAWSER_NET_NODAL_H

#include "net/net.h"

/* Blocks of nodes that share an element are not 0. Rows of blocks are in the order of elimination;
 * blocks are column by column. */
struct hawser__nodal {
	int rows, width;      /* nodes that can move; rows of a block */
	int *row;             /* [nodes of the mesh] -1: held */
	int *first, *later;   /* [rows + 1], [links] of each row the later ones it is linked to */
	double *diagonal;     /* [rows][width*width] */
	double *below, *beside; /* [links][width*width] blocks (later, row) and (row, later) */
	int *pivot;           /* [rows][width] */
	struct hawser__hold hold;
};

/* The pattern, eliminated in an order of least degree; hawser__nodal_room: storage for blocks of
 * width w. Clear it, on failure too. */
enum hawser_status hawser__nodal_open(struct hawser__nodal *blocks, const struct hawser__mesh *mesh,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__nodal_room(struct hawser__nodal *blocks, int width,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__nodal_clear(struct hawser__nodal *blocks);

/* Floating-point operations of the factors with blocks of that width. */
double hawser__nodal_work(const struct hawser__nodal *blocks, int width);

void hawser__nodal_zero(struct hawser__nodal *blocks);
/* The block of two rows that are the same, or linked. */
double *hawser__nodal_at(const struct hawser__nodal *blocks, int row, int column);
/* 0: a block that is divided by is singular. Blocks are divided by in this order whatever their size:
 * what that loses, further steps of Newton's method make up for. */
int hawser__nodal_factor(struct hawser__nodal *blocks);
/* x [rows*width] in place. */
void hawser__nodal_solve(const struct hawser__nodal *blocks, double *x);

#endif

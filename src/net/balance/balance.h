/* net/balance/balance.h - periodic motions of a mesh by harmonic balance of all its nodes; see
 * balance.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_BALANCE_H
#define HAWSER_NET_BALANCE_H

#include "net/net.h"

/* --- nodal.c: sparse matrices of square blocks over the nodes of a mesh, and their LU --- */

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

enum { HAWSER__MESH_PARTS = 9 }; /* PARTS: entries of a 3 by 3 matrix */

/* A motion y [size]: of each row of `blocks` three components, of each component mean, cosine, sine of
 * the multiples of Omega from the lowest on, m; then Omega, rad/s. */
struct hawser__mesh_balance {
	const struct hawser__mesh *mesh; /* in equilibrium; `multiple` of waves and motions is set */
	double mass_rate;     /* 1/s */
	double ratio;         /* damping ratio, and the modes of which it is: */
	double stroke_ratio;  /* the same of what strokes of absorbers add to the masses */
	int modes;
	const double *mode;   /* [modes][nodes][3] of the mass 1, times the mass */
	const double *rated;  /* [modes] 2*ratio*omega, rad/s */
	double *modal;        /* [2][modes][width] work space */
	int order, width, rows; /* highest harmonic; coefficients 2*order + 1; samples of a period */
	size_t size;
	struct hawser__nodal blocks;
	double *basis, *rate; /* [width][rows] functions and their derivatives by the phase */
	double *project;      /* [rows][width] coefficients from samples */
	double *load, *motion; /* [nodes][3][width] N; m of held directions */
	double *x, *other;    /* [nodes][3][width] of a motion, and of a change of it */
	double *place, *speed; /* [nodes][3][rows] displacement and its derivative by the phase; */
	double *moved, *faster; /* those of the change */
	double *force, *series; /* [elements][3][rows], [elements][3][width] N */
	double *out;          /* [nodes][3][width] N, what is not in balance */
	double *weighted;     /* [rows][PARTS][width] of an element: project times dF/dd, or dF/dd'; */
	double *G;            /* [width][PARTS][width] by functions of d, then projections */
	double *sweep;        /* [size] F^-1 dR/dOmega of the factors F that there are, and -1 */
	double *spare, *work; /* [size] */
	double Omega;         /* rad/s, of x */
	double scale, unit;   /* of the metric: of the motion, m, and of Omega, rad/s */
	int factored;         /* 1: there are factors */
	struct hawser__hold hold;
};

/* order: of the harmonics. Clear it, on failure too. */
enum hawser_status hawser__mesh_balance_open(struct hawser__mesh_balance *balance,
                                             const struct hawser__mesh *mesh, double mass_rate,
                                             int order, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__mesh_balance_clear(struct hawser__mesh_balance *balance);

/* What is not in balance, [size - 1] N; and its derivative along v [size] there. */
void hawser__mesh_balance_residual(struct hawser__mesh_balance *balance, double *residual,
                                   const double *y);
void hawser__mesh_balance_product(struct hawser__mesh_balance *balance, double *product,
                                  const double *v);
/* balance_jacobian.c: the factors of that derivative by the motion, at the motion y; 0: it is singular.
 * With a damping ratio, all modes have that of what else moves there. */
int hawser__mesh_balance_factor(struct hawser__mesh_balance *balance, const double *y);

/* The metric is that of the motion y. */
void hawser__mesh_balance_metric(struct hawser__mesh_balance *balance, const double *y);
double hawser__mesh_balance_dot(const struct hawser__mesh_balance *balance, const double *a,
                                const double *b);
/* balance_newton.c: y becomes the motion of the mesh in the plane through it that is normal to
 * `along`, which becomes the unit tangent there. *lost 1: it is not found, or is farther away than
 * `far` in the metric. */
void hawser__mesh_balance_correct(struct hawser__mesh_balance *balance, double *y, double *along,
                                  int *lost, double far);

/* Coefficients [width] of a node along axis k; NULL: it does not move there. */
const double *hawser__mesh_balance_at(const struct hawser__mesh_balance *balance, const double *y,
                                      int node, int k);
/* Least tension over the period of all elements, N; *element has it. */
double hawser__mesh_balance_tension(struct hawser__mesh_balance *balance, const double *y,
                                    int *element);

/* How an element stretches, at a phase. */
struct hawser__mesh_stretch {
	double T, l, e[3];    /* N, m, along it */
	double stiff, viscous; /* N/m, N s/m: EA/L0, and times `axial` */
	double aside[3];      /* 1/s: velocity across it over its length */
};
void hawser__mesh_balance_stretch(struct hawser__mesh_stretch *stretch,
                                  const struct hawser__mesh_balance *balance, int element, int row,
                                  double Omega);

#endif

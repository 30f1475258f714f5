/* response/orbit/balance_blocks.h - an approximate inverse of the Jacobian of harmonic balance, by
 * collocation over the period.
 *
 * The Jacobian of the balanced equations represents the linear equations
 *
 *   u'' + D(t) u' + K(t) u + b(t) dOmega = r(t),    u periodic
 *
 * As a dense matrix over all harmonics it costs (n H)^3 to factorise. Here the period is divided
 * into K steps with S Radau nodes each. The equations of each step, of order Sn, are factorised
 * separately and give the transition matrix of the step. One more matrix of order 2n + 1 has the
 * condition of periodicity and the border. The cost is proportional to the number of harmonics and
 * to n^3.
 *
 *   K      steps; S nodes each, HAWSER__BLOCK_NODES
 *   w, f   coordinates with an active pair: slow ones, and fast ones that follow statically
 *          (balance_fast.c)
 *   X      [Sw][2w + 1] accelerations at the nodes of a step per state at its start, and per dOmega
 *   A      [2w][2w + 1] state at the end of a step per the same
 *
 * GMRES is preconditioned with it (balance_solve.c). The method is Radau IIA, of order 2S - 1 and
 * L-stable: free vibrations of coordinates that are too fast for the steps decay. Gauss nodes would
 * keep them undamped, with wrong frequencies, and they would resonate.
 *
 * All arrays are floats: steps that are right to 1e-3 need no more digits, and the factors of many
 * steps exceed the cache.
 *
 * Reference: Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BALANCE_BLOCKS_H
#define HAWSER_RESPONSE_BALANCE_BLOCKS_H

#include "response/orbit/collocation.h"

/* S. A factorisation costs S^2 for each node. Half as many steps of 8 nodes save no iterations;
 * twice as many steps of 2 nodes double them. */
#define HAWSER__BLOCK_NODES 4

struct hawser__balance;

struct hawser__blocks {
	struct hawser__collocation radau;
	double weight[HAWSER__BLOCK_NODES]; /* weights of the quadrature over a step */
	int steps, w, f, order, width, spread; /* harmonics of the table, and of T */
	int *member;          /* [w + f] coordinates, the slow ones first */
	double h;             /* duration of a step */
	double omega;
	int harmonics;        /* of T that are included */
	float *T;             /* [2 spread + 1][n][n] the tangent's Fourier coefficients */
	float *resist;        /* [2 spread + 1][n][n] those of balance->resist; empty without terms */
	int more;             /* 1: with terms */
	float *table;        /* [K][S][2 width + 1] 1, cos, sin, ... at the nodes */
	float *start;        /* [K][2 width + 1] the same at the starts of the steps */
	float *stiff, *damp; /* [S][n][n] at the nodes of a step */
	float *slow, *mass;  /* [S][w][w] the condensed stiffness and mass at the nodes of a step */
	float *scale;        /* [w] frequency that displacements are multiplied by in a state */
	float *series;       /* [2 order + 1][w + f] scratch: coefficients */
	float *forcing;      /* [K][S][w] right sides, then accelerations at the nodes */
	float *displacement; /* [K][S][w] scratch */
	float *column;       /* [K][S][w] derivative of the defects by Omega at the nodes */
	float *fast;         /* [K][S][f] right sides, then displacements at the nodes */
	float *fast_column;  /* [K][S][f] as column */
	float *fast_room;    /* [2 f w + f] scratch */
	float *plane;        /* [K][2w] coefficients in the border of the state at the beginning of a
	                       * step */
	float *A;            /* [K][2w][2w + 1] */
	float *prefix;       /* [2w][2w + 1] product of A, and [2w][2w + 1] scratch */
	float *closing;      /* [2w + 1][2w + 1] factors */
	float *state;        /* [3][2w + 1] scratch */
	float *lu;           /* [K][Sw][Sw] */
	float *X;            /* [K][2w + 1][Sw] by columns */
	/* transposed, so that columns are contiguous */
	float *inverse;      /* [SK][f][f] of K_ff */
	float *follow;       /* [SK][w][f] -K_ff^-1 K_fs */
	float *weigh;        /* [SK][f][w] -K_sf K_ff^-1 */
	int *pivot, *last;    /* [K][Sw]; [2w + 1 + f] */
	float *memory;        /* of them all */
};

void hawser__blocks_init(struct hawser__blocks *blocks);
void hawser__blocks_release(struct hawser__blocks *blocks);

/* Allocate the arrays for the active pairs. Returns 1 on failure. */
int hawser__blocks_arrange(struct hawser__blocks *blocks, const struct hawser__balance *balance);

/* Factorise for the last derivatives, with `row` [size] as border. Returns 1 if singular. */
int hawser__blocks_factor(struct hawser__blocks *blocks, struct hawser__balance *balance,
                          const double *row);

/* Replace x [P + 1] by an approximation of M^-1 x, where M is the scaled bordered matrix. */
void hawser__blocks_apply(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                          double *x);

/* Number of operations of a factorisation for the active pairs. */
double hawser__blocks_cost(const struct hawser__balance *balance);

/* The same with the sampled tangents that it needs; and of an application, with a product with the
 * Jacobian. */
double hawser__blocks_factored(const struct hawser__blocks *blocks,
                               const struct hawser__balance *balance);
double hawser__blocks_applied(const struct hawser__blocks *blocks,
                              const struct hawser__balance *balance);

/* --- balance_substitute.c --- */

typedef float hawser__floats __attribute__((vector_size(4*HAWSER__BLOCK_NODES), aligned(4), may_alias));

/* Replace the diagonal of the factors lu [count][count] of LAPACK by its reciprocals. */
void hawser__blocks_invert_diagonal(float *lu, int count);
/* x [count] = the solution of the equations with these factors lu [count][count], by columns, and the
 * row interchanges pivot [count], for the right side x. `count` must be a multiple of S. */
void hawser__blocks_substitute(float *x, const float *lu, const int *pivot, int count);

/* --- balance_nodes.c --- */

/* Set the tables of cosines and sines at the nodes. */
void hawser__blocks_tabulate(struct hawser__blocks *blocks);
/* Number of harmonics of T that the preconditioner includes. */
int hawser__blocks_harmonics(const struct hawser__balance *balance);
/* Set stiff and damp at the nodes of a step. */
void hawser__blocks_evaluate(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                             int step);

/* --- balance_fast.c --- */

/* slow [S][w][w]: the condensed stiffness from K [S][n][n] at the nodes of a step. Also stores the
 * matrices for the calls below. Returns 1 if the stiffness of the fast coordinates is singular. */
int hawser__blocks_condense(struct hawser__blocks *blocks, float *slow, const float *K, int n,
                            int step);

/* Subtract from slow [SK][w] the effect of the right sides of the fast coordinates [SK][f], at the
 * nodes of `steps` steps from `first`. */
void hawser__blocks_load_slow(struct hawser__blocks *blocks, float *slow, const float *fast,
                              int first, int steps);

/* Replace the right sides fast [SK][f] by displacements, for displacements `slow` [SK][w] of the
 * slow coordinates; `column` [SK][f] is the derivative by Omega. */
void hawser__blocks_follow(struct hawser__blocks *blocks, float *fast, const float *slow,
                           const float *column, double domega);

#endif

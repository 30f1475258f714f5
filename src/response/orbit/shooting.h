/* response/orbit/shooting.h - multiple shooting for forced periodic orbits; a method of method.h.
 *
 *    y     unknowns [size]: node states x_0 .. x_{S-1} [m] each, then Omega; size = S m + 1
 *    r     defects [S m]: flow(x_i) - x_{i+1}, the last against x_0
 *    metric: |dy|^2 = mean over nodes and components of (dx_ij/scale_j)^2 + (dOmega/W)^2, with scale_j
 *          the size of component j over the orbit, but at least a small fraction of X, the size of the
 *          whole state: a resonance of a small coordinate bends the curve as well
 *
 * The linear algebra uses scaled unknowns (x_j/scale_j, Omega/W) and rows. The entries of the
 * bordered matrix are then of order one, and LU with partial pivoting is accurate enough up to some
 * hundred unknowns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SHOOTING_H
#define HAWSER_RESPONSE_SHOOTING_H

#include "core/hold.h"
#include "response/time/flow.h"
#include "response/orbit/method.h"

#define HAWSER_MAX_SEGMENTS 64 /* a segment may have five e-folds of damping: 320 per period */

struct hawser__shooting {
	struct hawser__orbit base;
	struct hawser__flow flow;
	int segments, steps;       /* steps: per segment */
	double omega;              /* of the last computed derivatives */
	int sample_capacity;       /* number of rows allocated for `samples` */
	double *scale;             /* [m] metric: sizes of the components */
	double *defect;            /* [S m] */
	int coarse;                /* steps per segment while a finer mesh is compared with it;
	                            * otherwise 0 */
	double *finer;             /* [S m] workspace: ends of the segments in finer steps */
	double *A, *b;             /* [S][m][m], [S][m], one behind the other: what orbits are kept of */
	double *matrix;            /* [size][size] bordered matrix, column-major, or its LU */
	int *pivot;                /* [size] */
	double *schur, *floquet_work; /* scratch */
	double *rates, *node;      /* [S][m] of a cycle: change of the nodes with the phase; the nodes */
	double *reduced;           /* [3 m m + 40 m] scratch */
	double factor_flops;       /* of all factorisations so far */
	double norm;               /* 1-norm of the bordered matrix */
	double *estimate;          /* [4 size] and int [size]: workspace of the condition estimate */
	int *estimate_int;
	struct hawser__hold hold;
};

enum hawser_status hawser__shooting_init(struct hawser__shooting *shooting,
                                         const struct hawser_rom *rom, int segments, int steps,
                                         struct hawser_report *report);
void hawser__shooting_release(struct hawser__shooting *shooting);

/* Change the mesh; the nodes do not change. */
enum hawser_status hawser__shooting_remesh(struct hawser__shooting *shooting, int steps,
                                           struct hawser_report *report);

/* shooting_mesh.c: initial numbers of segments and of steps per segment at omega; and the mesh that
 * the tolerance requires (method.h: refine, relax, enrich, sharpen). */
int hawser__shooting_segments(const struct hawser_rom *rom, double omega);
int hawser__shooting_steps(const struct hawser_rom *rom, double omega, int segments);
enum hawser_status hawser__shooting_refine(struct hawser__orbit *orbit, int *again,
                                           double tolerance, double omega,
                                           struct hawser_report *report);
enum hawser_status hawser__shooting_relax(struct hawser__orbit *orbit, double tolerance,
                                          struct hawser_report *report);
enum hawser_status hawser__shooting_enrich(struct hawser__orbit *orbit, int most,
                                           struct hawser_report *report);
enum hawser_status hawser__shooting_sharpen(struct hawser__orbit *orbit, int on,
                                            struct hawser_report *report);

/* shooting_free.c: the factors [order][order] of the product whose eigenvalues are a cycle's
 * multipliers, without the one that is 1, in shooting->schur; returns their order. */
int hawser__shooting_reduce(struct hawser__shooting *shooting);
/* Before the bordered matrix is factorised: keep corrections from turning the orbit. */
void hawser__shooting_border(struct hawser__shooting *shooting);
/* In the right side dy [size] of a correction: turn it back to the anchor. */
void hawser__shooting_hold(const struct hawser__shooting *shooting, double *dy);

/* shooting_guess.c: add_wave and from_state of method.h. */
void hawser__shooting_add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k,
                               double omega);
enum hawser_status hawser__shooting_from_state(struct hawser__orbit *orbit, double *y, const double *x,
                                               double omega, struct hawser_report *report);

#endif

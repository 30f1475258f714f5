/* response/shooting.h - multiple shooting for forced periodic orbits; a method of method.h.
 *
 *   y     unknowns [size]: node states x_0 .. x_{S-1} [m] each, then Omega; size = S m + 1
 *   r     defects [S m]: flow(x_i) - x_{i+1}, the last against x_0
 *   metric: |dy|^2 = mean over nodes and components of (dx_ij/scale_j)^2 + (dOmega/W)^2, with scale_j
 *         the size of component j over the orbit, but no less than a small part of X, the size of the
 *         whole. A resonance of a coordinate that is small still bends the curve.
 *
 * The linear algebra works on scaled unknowns (x_j over scale_j, Omega over W) and rows: the bordered
 * matrix has entries of order one, and LU with partial pivoting is enough up to some hundreds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SHOOTING_H
#define HAWSER_RESPONSE_SHOOTING_H

#include "response/flow.h"
#include "response/method.h"

#define HAWSER_MAX_SEGMENTS 64 /* each loses five e-folds of damping: 320 in a period */
#define HAWSER_REMEMBERED 8 /* orbits whose transition matrices are kept */

struct hawser__shooting {
	struct hawser__orbit base;
	struct hawser__flow flow;
	int segments, steps;       /* steps a segment */
	double omega;              /* of the last derived defects */
	int sample_capacity;       /* rows `samples` can hold */
	double *scale;             /* [m] metric: sizes of the components */
	double *defect;            /* [S m] */
	int coarse;                /* steps a segment while a finer mesh is compared with; else 0 */
	double *finer;             /* [S m] scratch: ends in finer steps */
	double *A, *b;             /* [S][m][m], [S][m] */
	double *matrix;            /* [size][size] bordered matrix, column-major, or its LU */
	int *pivot;                /* [size] */
	double *schur, *floquet_work; /* scratch */
	double factor_flops;       /* of the factorisations so far */
	double norm;               /* 1-norm of the bordered matrix */
	double *estimate;          /* [4 size] and int [size]: workspace of the condition estimate */
	int *estimate_int;
	double *memory;            /* [HAWSER_REMEMBERED] y, A and b of orbits */
	int kept;                  /* orbits kept so far */
};

enum hawser_status hawser__shooting_init(struct hawser__shooting *shooting,
                                         const struct hawser_rom *rom, int segments, int steps,
                                         struct hawser_report *report);
void hawser__shooting_release(struct hawser__shooting *shooting);

/* Change the mesh; the nodes stay. */
enum hawser_status hawser__shooting_remesh(struct hawser__shooting *shooting, int steps,
                                           struct hawser_report *report);

/* shooting_mesh.c: segments, and steps a segment, to begin with at omega; and the mesh that the
 * tolerance asks for (method.h: refine, relax, enrich, sharpen). */
int hawser__shooting_segments(const struct hawser_rom *rom, double omega);
int hawser__shooting_steps(const struct hawser_rom *rom, double omega, int segments);
enum hawser_status hawser__shooting_refine(struct hawser__orbit *orbit, int *again,
                                           double tolerance, double omega,
                                           struct hawser_report *report);
enum hawser_status hawser__shooting_relax(struct hawser__orbit *orbit, double tolerance,
                                          struct hawser_report *report);
enum hawser_status hawser__shooting_enrich(struct hawser__orbit *orbit,
                                           struct hawser_report *report);
enum hawser_status hawser__shooting_sharpen(struct hawser__orbit *orbit, int on,
                                            struct hawser_report *report);

/* shooting_guess.c: see method.h, keep and guess. _init returns 1 when out of memory. */
int hawser__shooting_guess_init(struct hawser__shooting *shooting);
void hawser__shooting_keep(struct hawser__orbit *orbit, const double *y);
int hawser__shooting_guess(struct hawser__orbit *orbit, const double *y, const double *row);

#endif

/* response/shooting.h - multiple shooting for forced periodic orbits.
 *
 *   y     unknowns [size]: node states x_0 .. x_{S-1} [m] each, then Omega; size = S m + 1
 *   r     defects [S m]: flow(x_i) - x_{i+1}, the last against x_0
 *   t     tangent of the branch [size], of unit length in the metric
 *   metric: |dy|^2 = mean over nodes and components of (dx_ij/scale_j)^2 + (dOmega/W)^2, with scale_j
 *         the size of component j over the orbit, but no less than a small part of X, the size of the
 *         whole, and W the natural width in Omega. An arclength step is a relative change of each
 *         component: nothing has to be tuned by hand when amplitudes span decades, and a resonance of
 *         a coordinate that is small still bends the curve.
 *
 * The linear algebra works on scaled unknowns (x_j over scale_j, Omega over W) and rows: the bordered
 * matrix has entries of order one, and LU with partial pivoting is enough up to some hundreds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SHOOTING_H
#define HAWSER_RESPONSE_SHOOTING_H

#include <hawser/orbit.h>

#include "response/flow.h"

struct hawser__shooting {
	struct hawser__flow flow;
	int n, m, segments, steps; /* steps a segment */
	int size;
	int sample_capacity;       /* rows `samples` can hold */
	double X, W;               /* metric: size of the orbit, width in Omega */
	double *scale;             /* [m] metric: sizes of the components */
	double *defect;            /* [S m] */
	double *A, *b;             /* [S][m][m], [S][m] */
	double *samples;           /* [S steps][n] u on the mesh, of the last flow */
	double *matrix;            /* [size][size] bordered matrix, column-major, or its LU */
	int *pivot;                /* [size] */
	double *rhs;               /* [size] */
	double *copy, *schur, *floquet_work; /* scratch */
	double *log_modulus, *argument;      /* [m] of the last hawser__shooting_multipliers */
	double det_sign, det_log;  /* of the bordered matrix of the last factorisation */
	double norm;               /* its 1-norm */
	double *estimate;          /* [4 size] and int [size]: workspace of the condition estimate */
	int *estimate_int;
	double mesh;               /* estimated mesh error of the last flow, absolute */
	struct hawser_orbit_cost cost;
};

enum hawser_status hawser__shooting_init(struct hawser__shooting *shooting,
                                         const struct hawser_rom *rom, int segments, int steps,
                                         struct hawser_report *report);
void hawser__shooting_clear(struct hawser__shooting *shooting);

/* Change the mesh; the nodes stay. */
enum hawser_status hawser__shooting_remesh(struct hawser__shooting *shooting, int steps,
                                           struct hawser_report *report);

/* Set the metric from an orbit y. */
void hawser__shooting_metric(struct hawser__shooting *shooting, const double *y);
double hawser__shooting_distance2(const struct hawser__shooting *shooting, const double *a,
                                  const double *b);
double hawser__shooting_dot(const struct hawser__shooting *shooting, const double *a,
                            const double *b);

/* Defects at y; with derive also A, b and samples. Returns their largest Euclidean norm over X;
 * NaN or infinity when the flow blew up. */
double hawser__shooting_defects(struct hawser__shooting *shooting, const double *y, int derive);

/* Factorise the bordered matrix with `row` [size] (a direction in y; the row is its metric dual) as
 * the last line. Returns 0, or 1 when it is singular to working precision. */
int hawser__shooting_factor(struct hawser__shooting *shooting, const double *row);

/* Solve for dy [size]: linearised defects + J dy = 0 and <row, dy> = last. */
void hawser__shooting_solve(struct hawser__shooting *shooting, double *dy, const double *defect,
                            double last);

/* What a correction did. */
struct hawser__correction {
	int iterations;
	double contraction; /* first ratio of successive steps; 0 when one step was enough */
	double residual;    /* largest defect over X at the end */
	double first;       /* length of the first step in the metric: how far the prediction was off */
};

/* Correct y onto the branch in the plane <row, y - y_pred> = 0, to `tolerance` (defect and step,
 * relative to X). On success the derivatives are those at y. Returns 0, or 1 when it did not
 * converge. */
int hawser__shooting_correct(struct hawser__shooting *shooting, double *y,
                             struct hawser__correction *correction, const double *row,
                             double tolerance);

/* Norm of the inverse of the bordered matrix last factorised: what a defect, relative to X, grows
 * to in the orbit. Infinite where the orbit is not determined. */
double hawser__shooting_amplification(struct hawser__shooting *shooting);

/* Unit tangent t [size] at the last corrected y, from the current factorisation, on the side to
 * which that factorisation's row points. */
void hawser__shooting_tangent(struct hawser__shooting *shooting, double *t);

/* Floquet multipliers of the last derived flow. */
enum hawser_status hawser__shooting_multipliers(struct hawser__shooting *shooting,
                                                struct hawser_report *report);

#endif

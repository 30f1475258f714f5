/* response/flow.h - the flow of the forced model over a stretch of phase on a fixed mesh, with its
 * exact derivatives.
 *
 *   tau        phase Omega t; the independent variable
 *   x          state [m], m = 2n: u then v = du/dt (time derivative, not by tau)
 *   X          derivative [m][w]: by the initial state, then by Omega in column m; w is m + 1
 * padded
 *              with zeros to whole blocks (core/hot.h)
 *
 * The mesh is fixed, so the computed flow is a smooth function of x and Omega, and X is the exact
 * derivative of what is computed (Bock's internal differentiation): Newton converges to round-off
 * whatever the mesh error, and the mesh error is estimated apart. Error control with a variable
 * step would add noise of the size of the tolerance to every residual.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FLOW_H
#define HAWSER_RESPONSE_FLOW_H

#include <hawser/rom.h>

/* A frequency for a message, for "%.9g%s": in rad/s where the model knows its unit of time. */
#define HAWSER_SHOWN(rom, omega) (omega)/(rom)->time, (rom)->scaled ? " rad/s" : ""

struct hawser__flow {
	const struct hawser_rom *rom;
	int n, m, w, padded;    /* padded: m in whole blocks */
	double *slope;          /* [stages][padded] stage slopes of the state */
	double *x, *stage;      /* [padded] the state, at the step's start and at a stage */
	double *acc, *by_omega; /* [n] */
	double *by_u, *by_v;    /* [n][n] */
	double *X, *X_stage;    /* [m][w] */
	double *X_slope;        /* [stages][m][w] */
	double *memory;         /* what holds all of the above */
	long stages;            /* stages taken so far */
};

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__flow_clear(struct hawser__flow *flow);

/* A stretch of phase: `steps` steps of length h from tau. */
struct hawser__stretch {
	double tau, h;
	int steps;
};

/* Carry x [m] over the stretch. samples [steps][n] receives u at the start of each step, unless
 * NULL. Returns the sum over the steps of the estimated local errors (Euclidean norm of x's). */
double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega);

/* The same with A [m][m] = d x(end) / d x(start) and b [m] = d x(end) / d Omega. */
double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega);

#endif

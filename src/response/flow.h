/* response/flow.h - the flow of the forced model over stretches of phase on a fixed mesh, with its
 * exact derivatives.
 *
 *   tau        phase Omega t; the independent variable
 *   x          state [m], m = 2n: u then v = du/dt (time derivative, not by tau)
 *   lane       one of up to HAWSER_LANES stretches that are carried together
 *   U, V       derivative of u and of v [n][w]: by the initial state, then by Omega in
 *              column m; w is m + 1 padded with zeros to whole blocks (core/hot.h)
 *
 * The mesh is fixed, so the computed flow is a smooth function of x and Omega, and the derivative is
 * that of what is computed (Bock's internal differentiation): Newton converges to round-off
 * whatever the mesh error, and the mesh error is estimated apart. Error control with a variable
 * step would add noise of the size of the tolerance to every residual.
 *
 * The segments of an orbit do not depend on each other: their states are carried four at a time, one
 * in each place of a vector. Their tangents at a step's stages are kept, and the derivatives follow,
 * stretch by stretch, from those (variation.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FLOW_H
#define HAWSER_RESPONSE_FLOW_H

#include <hawser/rom.h>

#include "response/nystrom.h"

/* A frequency for a message, for "%.9g%s": in rad/s where the model knows its unit of time. */
#define HAWSER_SHOWN(rom, omega) (omega)/(rom)->time, (rom)->scaled ? " rad/s" : ""

struct hawser__flow {
	const struct hawser_rom *rom;
	int n, m, w;
	int coupled;            /* f depends on v, by other dampings than the coordinate's own */
	int damping_varies;     /* the model has harmonics with D */
	int dampings;           /* different values on the diagonal of D */
	int *damping_of;        /* [n] which of them */
	double *damping;        /* [dampings] */
	struct hawser__nystrom *nystrom; /* [dampings] of the step at hand */
	double *coupling;       /* [n][n] D without what is in the formula */
	double *turn;           /* [harmonics][stages][2] cos, sin of k c_s h */
	/* lanes; all [..][HAWSER_LANES] */
	double *phase;          /* [harmonics][2] cos, sin of k tau at the step's start */
	double *wave;           /* [harmonics] factor of a harmonic at the stage */
	double *u, *v;          /* [n] at the step's start */
	double *stage_u, *stage_v; /* [n] */
	double *force;          /* [n] restoring */
	double *f;              /* [stages][n] */
	double *by_u;           /* [stages][n][n] minus the derivative of f by u */
	double *by_v;           /* [stages][n][n] the same by v, where coupled */
	double *f_omega;        /* [stages][n] explicit derivative of f by Omega */
	double *u_omega, *v_omega; /* [stages + 1][n] what a step's length depending on Omega adds */
	double *work;           /* of the kernel */
	/* one lane */
	double *U, *V;          /* [HAWSER_LANES][n][w] */
	double *F;              /* [stages][n][w] derivative of f */
	double *stage_U, *stage_V; /* [n][w] */
	double *memory;         /* what holds all the doubles above */
	long stages;            /* stages taken so far */
	double flops;           /* additions and multiplications in them, of the stretches asked for */
};

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__flow_clear(struct hawser__flow *flow);

/* `count` stretches of phase, each of `steps` steps of length h: one begins at tau, the next one at
 * tau + apart, and so on. */
struct hawser__stretch {
	double tau, h;
	int steps, count;
	double apart;
};

/* Carry x [count][m] over the stretches. samples [count][steps][n] receives u at the start of each
 * step, unless NULL. Returns the sum over the steps of the estimated local errors (Euclidean norm of
 * x's). */
double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega);

/* The same with A [count][m][m] = d x(end) / d x(start) and b [count][m] = d x(end) / d Omega. */
double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega);

/* variation.c: U and V of a lane over the step whose stages are in `flow`. */
void hawser__flow_vary(struct hawser__flow *flow, int lane);

#endif

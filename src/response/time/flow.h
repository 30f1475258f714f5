/* response/time/flow.h - the flow of the forced model over stretches of phase on a fixed mesh, with its
 * exact derivatives.
 *
 *    tau        phase Omega t; the independent variable
 *    x          state [m], m = 2n: u then v = du/dt (time derivative, not by tau)
 *    lane       one of up to HAWSER_LANES stretches that are integrated together
 *    U, V       derivative of u and of v [n][w]: by the initial state, then by Omega in
 *               column m; w is m + 1 padded with zeros to whole blocks (core/hot.h)
 *
 * Since the mesh is fixed, the computed flow is a smooth function of x and Omega, and the
 * derivative is that of the computed flow (Bock's internal differentiation). Newton's method
 * therefore converges to round-off whatever the error of the mesh is, which is estimated
 * separately. Error control with variable steps would add noise of the size of the tolerance to
 * every residual.
 *
 * The segments of an orbit are independent of each other: the states of four segments are
 * integrated together in vector registers. The tangents at the stages of a step are stored, and the
 * derivatives are computed from them, segment by segment (variation.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FLOW_H
#define HAWSER_RESPONSE_FLOW_H

#include <hawser/rom.h>

#include "response/time/nystrom.h"
#include "rom/terms/terms.h"

/* Arguments for "%.9g%s" that print a frequency, in rad/s if the model has a unit of time. */
#define HAWSER_SHOWN(rom, omega) \
	(omega)*hawser__rom_periods(rom)/(rom)->time, (rom)->scaled ? " rad/s" : ""

struct hawser__flow {
	const struct hawser_rom *rom;
	int n, m, w;
	int coupled;            /* 1: f depends on v by more than the damping of each coordinate by
	                         * itself */
	int damping_varies;     /* the model has harmonics with D */
	int harmonics;          /* number for which there is room */
	int more;               /* 1: the model has terms (rom/terms/terms.h) */
	int dampings;           /* number of different values on the diagonal of D */
	int *damping_of;        /* [n] index of the value of each coordinate */
	double *damping;        /* [dampings] */
	struct hawser__nystrom *nystrom; /* [dampings] formula of the present step */
	double *coupling;       /* [n][n] D without the part that is in the formula */
	double *turn;           /* [harmonics][stages][2] cos, sin of k c_s h */
	/* lanes; all [..][HAWSER_LANES] */
	double *phase;          /* [harmonics][2] cos, sin of k tau at the step's start */
	double at[4], h;        /* phase at the step's start, by lane (HAWSER_LANES); length of the step */
	double *wave;           /* [harmonics] value of a harmonic at the stage */
	double *u, *v;          /* [n] at the step's start */
	double *stage_u, *stage_v; /* [n] */
	double *force;          /* [n] restoring */
	double *f;              /* [stages][n] */
	double *by_u;           /* [stages][n][n] minus the derivative of f by u */
	double *by_v;           /* [stages][n][n] the same by v, where coupled */
	double *f_omega;        /* [stages][n] explicit derivative of f by Omega */
	double *u_omega, *v_omega; /* [stages + 1][n] terms due to the dependence of the step length on
	                            * Omega */
	double *work;           /* workspace of the kernel */
	/* one lane */
	double *U, *V;          /* [HAWSER_LANES][n][w] */
	double *F;              /* [stages][n][w] derivative of f */
	double *stage_U, *stage_V; /* [n][w] */
	double *memory;         /* memory of all arrays above */
	double drained;         /* sum over the stretches, since it was set to 0, of the integral over time
	                         * of the trace of the derivative of drag by v */
	long stages;            /* number of stages computed so far */
	double flops;           /* additions and multiplications in them, without unused lanes */
};

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report);
/* Another model with as many coordinates and harmonics; 1 if it has not. */
int hawser__flow_place(struct hawser__flow *flow, const struct hawser_rom *rom);
void hawser__flow_clear(struct hawser__flow *flow);

/* `count` stretches of phase, each of `steps` steps of length h. The first begins at tau, the next
 * one at tau + apart, and so on. */
struct hawser__stretch {
	double tau, h;
	int steps, count;
	double apart;
};

/* Additions and multiplications of a step of one stretch, with derive: and of its derivatives. */
double hawser__flow_flops(const struct hawser__flow *flow, int derive);

/* Integrate x [count][m] over the stretches. samples [count][steps][n], unless NULL, become u at
 * the start of each step. Returns the sum of the estimated local errors over the steps (Euclidean
 * norm of the errors of x). */
double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega);

/* The same with A [count][m][m] = d x(end) / d x(start) and b [count][m] = d x(end) / d Omega. */
double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega);

/* flow_drag.c: add the drag of the model at stage s to f and, with `derive`, to by_v; the same with its
 * terms (rom/terms/terms.h). */
void hawser__flow_drag(struct hawser__flow *flow, int s, int derive, int live, double omega);
void hawser__flow_more(struct hawser__flow *flow, int s, int derive, int live, double omega);

/* variation.c: U and V of a lane over the step whose stages are in `flow`. */
void hawser__flow_vary(struct hawser__flow *flow, int lane);

#endif

/* response/locus/folds.h - the equations of a fold in (Omega, load), by harmonic balance.
 *
 *   F      balanced equations at the active unknowns, scaled (balance.h)
 *   J      dF/dy; A = [J b; c^T 0], nonsingular at a fold and near it
 *   v, g   A [v; g] = [0; 1]: v is the null vector of J where g = 0
 *   w      A^T [w; g] = [0; 1]
 *   z      unknowns [size]: Fourier coefficients, Omega, load factor
 *
 * The fold is F = 0, g = 0: two equations' worth of freedom less one, a curve. With these borders
 * g_z = -w^T J_z v (Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.3;
 * Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., 10.3.1). One factorisation of A serves
 * the border's vectors, Newton's step and the tangent: the step is sought as
 * dy = p_r + p_Omega dOmega + p_load dload + a v, where the condition that A's last component
 * vanishes, g's equation and the plane determine dOmega, dload and a.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_H
#define HAWSER_RESPONSE_FOLDS_H

#include <hawser/folds.h>

#include "core/hold.h"
#include "response/orbit/balance.h"
#include "response/orbit/load.h"

/* Test functions along a fold curve. */
enum { HAWSER_FOLD_CUSP = 0, HAWSER_FOLD_STATIONARY, HAWSER_FOLD_TESTS };

struct hawser__fold {
	struct hawser__balance balance;
	struct hawser__load load;
	int size;          /* of z */
	double *weight;    /* [size] of the metric */
	double L;          /* unit of the load factor in the metric */
	int room, samples; /* numbers of unknowns and of samples per period for which memory is
	                    * allocated */
	double *A;         /* [P + 1][P + 1] by rows, or its LU */
	int *pivot;        /* [P + 1] */
	double sign;       /* of the determinant of A, */
	int orientation;   /* and of the whole system with its last row, when it was solved last */
	double *b, *c;     /* [size] borders in the scaled unknowns, at the positions of the
	                    * coefficients */
	double *x;         /* [4][P + 1] p_r, p_Omega, p_load, v, each with its last component */
	double *w;         /* [P + 1] */
	double *F;         /* [P] defects, scaled */
	double *g_y;       /* [P] */
	double g, g_omega, g_load;
	double F_omega, F_load; /* w^T dF/dOmega and w^T dF/dload, scaled */
	double second;     /* w^T F_yy v v */
	double *wave_v, *wave_w, *wave_g; /* [2 top + 1][n] Fourier coefficients */
	double *zero;      /* [size] */
	double *time_u, *time_v, *time_w, *time_q; /* [R][n] */
	double *plus, *minus; /* [R][n][n] tangents */
	double *force;     /* [R][n] */
	double *work;      /* of hawser__rom_tangents */
	double *step;      /* [size] */
	long solves;
	struct hawser__hold unknowns, times; /* what has `room` and `samples` */
};

enum hawser_status hawser__fold_open(struct hawser__fold *fold, const struct hawser_rom *rom,
                                     struct hawser_report *report);
void hawser__fold_close(struct hawser__fold *fold);

/* The orbit with the Fourier coefficients and Omega of z. */
static inline struct hawser__orbit *hawser__fold_orbit(struct hawser__fold *fold)
{
	return &fold->balance.base;
}

/* folds_system.c: the defect at z relative to the size of the orbit; derive: 1: with tangents. */
double hawser__fold_defect(struct hawser__fold *fold, const double *z, int derive);
/* folds_system.c: evaluate all of the above at z, with the borders b and c. *residual becomes the
 * defect relative to the size of the orbit; NAN if A is singular. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__fold_evaluate(struct hawser__fold *fold, double *residual,
                                         const double *z, struct hawser_report *report);
/* dz [size]: the Newton step; if `homogeneous`, the direction of the curve with <row, dz> = last.
 * Returns 1 if the system is singular. */
int hawser__fold_solve(struct hawser__fold *fold, double *dz, const double *row, int homogeneous,
                       double last);
/* Take the current v and w as the next borders. */
void hawser__fold_update(struct hawser__fold *fold);
/* Borders for an orbit without known null vectors. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__fold_border(struct hawser__fold *fold, const double *z,
                                       struct hawser_report *report);

/* folds_second.c: g_y, g_omega, g_load and second, from v and w at the last evaluation. */
void hawser__fold_differentiate(struct hawser__fold *fold);
/* dF/dload at the active unknowns, scaled, [P]. */
void hawser__fold_by_load(struct hawser__fold *fold, double *by_load);

/* The metric of z: that of the orbit, with the relative change of the load. Valid until the metric
 * of the orbit or L changes. */
struct hawser__metric hawser__fold_metric(struct hawser__fold *fold);

#endif

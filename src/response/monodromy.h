/* response/monodromy.h - Floquet multipliers of an orbit that is known as a Fourier series.
 *
 * The variational equation
 *
 *     x'' + D(t) x' + K(t) x = 0,    K = C_0/2 + sum of C_k cos(k Omega t) + S_k sin(k Omega t)
 *
 * is linear with known coefficients, so its transition matrices need no orbit to be integrated with
 * them. Each step is a collocation at 8 Gauss nodes (order 16), in the accelerations a_i at the nodes:
 *
 *     a_i + K_i (x_0 + c_i h v_0 + h^2 sum B_ij a_j) + D_i (v_0 + h sum A_ij a_j) = 0
 *
 * with B = A A (and not the second integral of the interpolated acceleration, with which it would
 * not be A-stable).
 *
 * Why so: it is A-stable, and of a coordinate that is too fast for the steps (in a full-order
 * model there are frequencies 1e4 times Omega) the growth still is right. With the mean damping
 * a = tr D/n taken out by x = exp(-a t/2) z, collocation at Gauss nodes is symplectic for
 * symmetric K and the rest of D zero: moduli are right to round-off, and only phases carry an
 * error. Sorted eigenvalues of the Hill matrix (truncated) would have neither.
 *
 * Coordinates that nothing couples (out of plane from in plane, antisymmetric from symmetric) are
 * treated apart: the cost is cubic.
 *
 * Reference: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.7; Hairer,
 * Lubich and Wanner, Geometric Numerical Integration, II.1.3 and VI.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_MONODROMY_H
#define HAWSER_RESPONSE_MONODROMY_H

#include <hawser/orbit.h>

#include "response/collocation.h"

struct hawser__monodromy {
	int n;
	int steps;              /* a period */
	int table_steps, order; /* what the table below was made for */
	double error;           /* estimated, of the last multipliers' logarithms */
	struct hawser__collocation gauss;
	int *part, *member;     /* [n] component of a coordinate; coordinates by components */
	int parts;
	double *scale;          /* [n] frequency by which displacements are scaled */
	double *table;          /* [steps][8][2 order + 1] 1/2, cos, sin, ... at the nodes */
	size_t table_room;
	double *stiff, *damp;   /* [8][n][n] at the nodes of a step */
	double *matrix;         /* [8 n][8 n] column-major */
	double *rhs;            /* [2 n][8 n] column-major */
	int *pivot;             /* [8 n] */
	double *step, *product; /* [2n][2n] */
	double *factor;         /* [factors][2n][2n] */
	double *floquet_work;
	double *memory;
};

#define HAWSER__FACTORS 64 /* of the product, at most */

enum hawser_status hawser__monodromy_init(struct hawser__monodromy *monodromy, int n,
                                          struct hawser_report *report);
void hawser__monodromy_release(struct hawser__monodromy *monodromy);

/* log_modulus and argument [2n] of the orbit whose tangent has the Fourier coefficients T
 * [2 order + 1][n][n] (the constant one twice); rom gives D and its harmonics. */
enum hawser_status hawser__monodromy_multipliers(struct hawser__monodromy *monodromy,
                                                 double *log_modulus, double *argument,
                                                 const struct hawser_rom *rom, const double *T,
                                                 int order, double omega,
                                                 struct hawser_report *report);

#endif

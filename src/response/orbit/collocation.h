/* response/orbit/collocation.h - Gauss nodes on [0, 1], and integrals of the polynomials through them.
 *
 * I_m and J_m are the first and second integrals of P_m(2x - 1) from 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_COLLOCATION_H
#define HAWSER_RESPONSE_COLLOCATION_H

/* Nodes per step. 8 to 10 need the fewest evaluations for tolerances from 1e-6 to 1e-12 (measured
 * by bench/integrate). */
#define HAWSER__NODES 8

struct hawser__collocation {
	int nodes; /* at most HAWSER__NODES */
	double node[HAWSER__NODES]; /* c_i */
	double transform[HAWSER__NODES][HAWSER__NODES]; /* alpha_m = sum_i transform[m][i] a_i */
	double once[HAWSER__NODES][HAWSER__NODES];  /* v at node i per a_j: I times transform */
	double twice[HAWSER__NODES][HAWSER__NODES]; /* u at node i per a_j: J times transform */
	double end_once[HAWSER__NODES], end_twice[HAWSER__NODES]; /* the same at x = 1 */
};

void hawser__collocation_make(struct hawser__collocation *table);

/* The same with s `nodes`, 1 to HAWSER__NODES, of the Radau rule whose last node is the end of the
 * step. With hawser__collocation_indirect this is the method Radau IIA, of order 2s - 1, L-stable:
 * components that are too fast for the step decay at once. */
void hawser__collocation_make_radau(struct hawser__collocation *table, int nodes);

/* Compute u at the nodes from v at the nodes as v from a: the Gauss method for the first-order
 * system. Its u is less accurate by one degree, but the method is A-stable and symplectic. The
 * double integration of the accelerations is not: with steps too long for a stiff coordinate, that
 * coordinate grows. */
void hawser__collocation_indirect(struct hawser__collocation *table);

/* I_m(x) and J_m(x), [HAWSER__NODES] each. */
void hawser__collocation_integrals(double *once, double *twice, double x);

/* P_0 .. P_{count-1} at z, [count]. */
void hawser__legendre(double *p, double z, int count);

#endif

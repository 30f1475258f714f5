/* response/collocation.h - Gauss nodes on [0, 1], and integrals of the polynomials through them.
 *
 * I_m and J_m are the first and second integrals of P_m(2x - 1) from 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_COLLOCATION_H
#define HAWSER_RESPONSE_COLLOCATION_H

/* Nodes a step. 8 to 10 need the fewest evaluations for tolerances from 1e-6 to 1e-12. */
#define HAWSER__NODES 8

struct hawser__collocation {
	double node[HAWSER__NODES]; /* c_i */
	double transform[HAWSER__NODES][HAWSER__NODES]; /* alpha_m = sum_i transform[m][i] a_i */
	double once[HAWSER__NODES][HAWSER__NODES];  /* v at node i per a_j: I times transform */
	double twice[HAWSER__NODES][HAWSER__NODES]; /* u at node i per a_j: J times transform */
	double end_once[HAWSER__NODES], end_twice[HAWSER__NODES]; /* the same at x = 1 */
};

void hawser__collocation_make(struct hawser__collocation *table);

/* The same with the nodes of the Radau rule that has the end of the step as its last: with
 * hawser__collocation_indirect the method Radau IIA, of order 2s - 1 = 15, which is L-stable: what is
 * too fast for the step dies out at once. */
void hawser__collocation_make_radau(struct hawser__collocation *table);

/* Let u at the nodes follow from v at the nodes, as v does from a: the Gauss method for the system of
 * first order. Its u is less accurate by one degree, but it is A-stable and symplectic, which
 * integrating the accelerations twice is not: with steps too long for a stiff coordinate that
 * grows. */
void hawser__collocation_indirect(struct hawser__collocation *table);

/* I_m(x) and J_m(x), [HAWSER__NODES] each. */
void hawser__collocation_integrals(double *once, double *twice, double x);

/* P_0 .. P_{count-1} at z, [count]. */
void hawser__legendre(double *p, double z, int count);

#endif

/* response/time/nystrom.h - the formula of tableau.c for u'' = f(u, v, t) - d v.
 *
 *    H      step in time; a, b, e5, e3 as in the tableau; e a column of ones
 *    f      slopes: acceleration at the stages, without the damping d of the coordinate itself
 *    R      (I + H d a)^-1, a polynomial in a
 *
 * u and v at a stage are linear in u and v of the step and in f at the previous stages. With v and
 * the damping eliminated once for a step length,
 *
 *      u_s = u + H (aRe)_s v + H^2 (aRa)_sl f_l        v_s = (1 - H d (aRe)_s) v + H (aR)_sl f_l
 *
 * and the same with b in place of a at the end of the step. In exact arithmetic the method is the
 * same. If f does not depend on v, v at the stages is never computed, which halves the sums of the
 * variational equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_NYSTROM_H
#define HAWSER_RESPONSE_NYSTROM_H

/* --- tableau.c: the Runge-Kutta formula of the period map ---
 *
 * The method of Dormand and Prince of order 8 with 12 stages, and the two comparison formulas of
 * orders 5 and 3 for its error estimate (Hairer, Norsett and Wanner, Solving Ordinary
 * Differential Equations I, 2nd ed., II.5 and II.10, "DOP853"). It is explicit, since the models
 * are not stiff in the range of a response; of high order, since shooting needs 1e-9 and better;
 * and has few stages for its order. A test of the order of convergence checks the coefficients. */

#define HAWSER_RK_STAGES 12 /* of DOP853 */

struct hawser__tableau {
	double a[HAWSER_RK_STAGES][HAWSER_RK_STAGES]; /* strictly lower */
	double b[HAWSER_RK_STAGES], c[HAWSER_RK_STAGES];
	double e5[HAWSER_RK_STAGES], e3[HAWSER_RK_STAGES]; /* differences to orders 5 and 3 */
};

extern const struct hawser__tableau hawser__dop853;

enum {
	HAWSER_RK_END = HAWSER_RK_STAGES, /* row of the step's end */
	HAWSER_RK_FIVE, HAWSER_RK_THREE,  /* rows of the two comparison formulas: their terms of u and
	                                   * v */
	HAWSER_RK_ROWS
};

/* u_s = u + uv v + sum uf f, v_s = v + vv v + sum vf f; and the terms of the derivatives by Omega
 * for a step H = h/Omega with fixed h. The rows of the comparison formulas do not contain u and v
 * themselves. */
struct hawser__nystrom {
	double uv[HAWSER_RK_ROWS], uf[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double vv[HAWSER_RK_ROWS], vf[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double uv_omega[HAWSER_RK_ROWS], uf_omega[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double vv_omega[HAWSER_RK_ROWS], vf_omega[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
};

/* d times |h|/omega should not be large, since coefficients of both signs grow with its powers. */
void hawser__nystrom(struct hawser__nystrom *nystrom, double damping, double h, double omega);

#endif

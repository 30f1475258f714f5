/* response/nystrom.h - the formula of tableau.h written for u'' = f(u, v, t) - d v.
 *
 *   H      step in time; a, b, e5, e3 the tableau's; e a column of ones
 *   f      slopes: acceleration without the damping d of its own coordinate, at the stages
 *   R      (I + H d a)^-1, a polynomial in a
 *
 * A stage's u and v are linear in the step's u, v and in the f of the stages before. Eliminating v
 * and the damping once for a step length,
 *
 *     u_s = u + H (aRe)_s v + H^2 (aRa)_sl f_l        v_s = (1 - H d (aRe)_s) v + H (aR)_sl f_l
 *
 * and the same with b for a at the step's end. It is the same method in exact arithmetic; where f does
 * not depend on v the stages' v are never formed, and that halves the sums of the variational
 * equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_NYSTROM_H
#define HAWSER_RESPONSE_NYSTROM_H

#include "response/tableau.h"

enum {
	HAWSER_RK_END = HAWSER_RK_STAGES, /* row of the step's end */
	HAWSER_RK_FIVE, HAWSER_RK_THREE,  /* rows of the two comparisons: what they add to u and v */
	HAWSER_RK_ROWS
};

/* u_s = u + uv v + sum uf f,  v_s = v + vv v + sum vf f; and what their derivatives by Omega add for
 * a step H = h/Omega of fixed h. The rows of the comparisons are without u and v themselves. */
struct hawser__nystrom {
	double uv[HAWSER_RK_ROWS], uf[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double vv[HAWSER_RK_ROWS], vf[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double uv_omega[HAWSER_RK_ROWS], uf_omega[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
	double vv_omega[HAWSER_RK_ROWS], vf_omega[HAWSER_RK_ROWS][HAWSER_RK_STAGES];
};

/* d times |h|/omega should not be large: coefficients of both signs grow with its powers. */
void hawser__nystrom(struct hawser__nystrom *nystrom, double damping, double h, double omega);

#endif

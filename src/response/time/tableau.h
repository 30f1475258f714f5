/* response/time/tableau.h - the Runge-Kutta formula of the period map.
 *
 * The method of Dormand and Prince of order 8 with 12 stages, and the two comparison formulas of
 * orders 5 and 3 for its error estimate (Hairer, Norsett and Wanner, Solving Ordinary Differential
 * Equations I, 2nd ed., II.5 and II.10, "DOP853"). It is explicit, since the models are not stiff
 * in the range of a response; of high order, since shooting needs 1e-9 and better; and has few
 * stages for its order. A test of the order of convergence checks the coefficients.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_TABLEAU_H
#define HAWSER_RESPONSE_TABLEAU_H

#define HAWSER_RK_STAGES 12 /* of DOP853 */

struct hawser__tableau {
	double a[HAWSER_RK_STAGES][HAWSER_RK_STAGES]; /* strictly lower */
	double b[HAWSER_RK_STAGES], c[HAWSER_RK_STAGES];
	double e5[HAWSER_RK_STAGES], e3[HAWSER_RK_STAGES]; /* differences to orders 5 and 3 */
};

extern const struct hawser__tableau hawser__dop853;

#endif

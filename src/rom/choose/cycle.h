/* rom/choose/cycle.h - a forced periodic orbit as a Fourier series, to start a continuation by another
 * program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_CYCLE_H
#define HAWSER_ROM_CYCLE_H

#include <hawser/rom.h>

/* u_j(tau) = cosine[0][j] + sum over h of cosine[h][j] cos(h tau) + sine[h][j] sin(h tau). */
struct hawser__cycle {
	int n, order;   /* coordinates; highest h */
	double *cosine; /* [order+1][n] */
	double *sine;   /* [order+1][n] */
};

/* The orbit at Omega = omega, by Newton's method from rest; if that fails, with a forcing that
 * grows from zero. HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__cycle_find(struct hawser__cycle *cycle, const struct hawser_rom *rom,
                                      double omega, struct hawser_report *report);
void hawser__cycle_clear(struct hawser__cycle *cycle);

#endif

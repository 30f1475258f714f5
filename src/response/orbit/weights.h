/* response/orbit/weights.h - what a tolerance allows for coordinates that follow others.
 *
 *   U_k    amplitude of u_k: its largest value of late, forgotten over about a period of the slowest
 *          coordinate
 *   V_k    amplitude of u_k', at least sqrt(K_kk) U_k
 *
 * The weights are rtol U_k + atol and rtol V_k + atol. For a coordinate that swings at its own
 * frequency V_k is the largest velocity anyway. One that is much faster than the motion follows the
 * others with a small velocity; weights from this velocity would resolve its free vibration long
 * after that is a small part of its displacement.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_WEIGHTS_H
#define HAWSER_RESPONSE_WEIGHTS_H

#include "response/time/stepper.h"

struct hawser__weights {
	double *weight;      /* [2n] what the tolerance allows of u and u' */
	double *past, *now;  /* [2n] amplitudes before the step in progress, and with it */
	double forget;       /* rate at which amplitudes fade */
};

/* 0, or -1 when memory runs out. */
int hawser__weights_init(struct hawser__weights *weights, const struct hawser__stepper *stepper);
void hawser__weights_clear(struct hawser__weights *weights);

/* For a step of length h from y [2n], with `count` states at stage [count][2n]. */
void hawser__weights_set(struct hawser__weights *weights, const struct hawser__stepper *stepper,
                         const double *y, const double *stage, int count, double h);

/* The step for which they were set last is accepted. */
void hawser__weights_keep(struct hawser__weights *weights);

#endif

/* ropeway/modes/running.h - complex modes of a rope that runs over its sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_RUNNING_H
#define HAWSER_ROPEWAY_RUNNING_H

#include "ropeway/modes/modes.h"

/* Complex modes of a system. */
struct hawser__lmode_running {
	int n, iterations;
	double *omega, *error, *condition; /* [n] ascending */
	double *x, *strain;  /* [n][2][size], [n][2][strains]: real and imaginary parts */
};

/* As many modes as `resting`, on the same grids; the last of them may not have converged. */
enum hawser_status hawser__lmode_running(struct hawser__lmode_running *pairs,
                                         struct hawser__lmode_system *system,
                                         const struct hawser__lmode *rope,
                                         const struct hawser__lmode_pairs *resting,
                                         struct hawser_report *report);
/* Carry them over to finer grids that resolve `omega`; sets errors. */
enum hawser_status hawser__lmode_running_refine(struct hawser__lmode_running *pairs,
                                                struct hawser__lmode_system *system,
                                                const struct hawser__lmode *rope, double omega,
                                                struct hawser_report *report);
void hawser__lmode_running_clear(struct hawser__lmode_running *pairs);

#endif

/* response/orbit/start.h - the first orbit of a branch.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_START_H
#define HAWSER_RESPONSE_START_H

#include "response/orbit/method.h"

/* How far the load could be raised. */
struct hawser__raised {
	int lone;    /* set by the caller: only the orbit that grows out of rest with the load is wanted */
	double most; /* set by the caller: work, s (hawser_orbit_work), at which it ends; 0: no limit */
	double load; /* factor of the load; -1: that was not tried, or other loads would not help */
	double *x;   /* [m] state of the orbit at this load, where it is above 0 */
};

/* 1 if the orbits so far took more than raised->most. */
int hawser__start_spent(const struct hawser__orbit *orbit, const struct hawser__raised *raised);

/* Find the orbit y [size] at Omega = omega: from `start` [m] (state at phase 0) or, if that is
 * NULL, from the linear response. If Newton's method fails, or raised->lone and it ends far from
 * there, the load is increased from zero. With
 * HAWSER_ERR_CONVERGENCE and raised->load >= 0, the report is left to the caller. */
enum hawser_status hawser__start(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, const double *start,
                                 double omega, double tolerance, struct hawser__raised *raised,
                                 struct hawser_report *report);

#endif

/* response/start.h - the first orbit of a branch.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_START_H
#define HAWSER_RESPONSE_START_H

#include "response/method.h"

/* Find the orbit y [size] at Omega = omega: from `start` [m] (state at phase 0) or, if that is
 * NULL, from the linear response. If Newton's method fails, the load is increased from zero. */
enum hawser_status hawser__start(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, const double *start,
                                 double omega, double tolerance, struct hawser_report *report);

#endif

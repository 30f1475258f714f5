/* response/start.h - the first orbit of a branch.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_START_H
#define HAWSER_RESPONSE_START_H

#include "response/method.h"

/* Orbit y [size] at Omega = omega: from `start` [m] (state at phase 0), or, when that is NULL, from
 * the linear response; when Newton fails from there, by raising the load from nothing. */
enum hawser_status hawser__start(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, const double *start,
                                 double omega, double tolerance, struct hawser_report *report);

#endif

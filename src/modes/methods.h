/* modes/methods.h - checks common to all methods for modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_METHODS_H
#define HAWSER_MODES_METHODS_H

#include <hawser/modes.h>

/* Check that the scaled quantities of the statics are valid and that the cable is extensible.
 * Statuses: _ARGUMENT, _NO_SOLUTION, _NAN. */
enum hawser_status hawser__modes_check_statics(const struct hawser_statics *statics,
                                               struct hawser_report *report);

/* Check number of modes, basis and tolerance. Status: _ARGUMENT. */
enum hawser_status hawser__modes_check_options(const struct hawser_modes_options *options,
                                               struct hawser_report *report);

/* Fail with _CONVERGENCE since mode k (from 0) is the first whose error estimate is 1 or more.
 * omega is in rad/s; solved->n, basis and method are the settings of the solution. */
enum hawser_status hawser__modes_unknown(int k, double omega, enum hawser_plane plane, double error,
                                         const struct hawser_modes_options *solved,
                                         struct hawser_report *report);

#endif

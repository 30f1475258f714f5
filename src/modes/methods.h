/* modes/methods.h - what every way to modes checks first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_METHODS_H
#define HAWSER_MODES_METHODS_H

#include <hawser/modes.h>

/* The scaled quantities of the statics make sense, and the cable is extensible. Statuses: _ARGUMENT,
 * _NO_SOLUTION, _NAN. */
enum hawser_status hawser__modes_check_statics(const struct hawser_statics *statics,
                                               struct hawser_report *report);

/* Number, basis and tolerance make sense. Status: _ARGUMENT. */
enum hawser_status hawser__modes_check_options(const struct hawser_modes_options *options,
                                               struct hawser_report *report);

/* Refuses a result whose mode k (from 0) is the first that has a stated error of 1 or more; omega is in
 * rad/s; solved->n, basis and method are what it was computed with. Status: _CONVERGENCE. */
enum hawser_status hawser__modes_unknown(int k, double omega, enum hawser_plane plane, double error,
                                         const struct hawser_modes_options *solved,
                                         struct hawser_report *report);

#endif

/* modes/methods.h - checks common to all methods for modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_METHODS_H
#define HAWSER_MODES_METHODS_H

#include <hawser/modes.h>

/* Check that the scaled quantities of the statics are valid and that the cable is extensible.
 * Statuses: _ARGUMENT, _NO_SOLUTION, _NAN. */
enum hawser_status hawser__modes_check_statics(const struct hawser_statics *statics,
                                               struct hawser_report *report);

/* 1 if an attachment has an absorber; and the refusal of absorbers that undamped modes do not have.
 * Status: _ARGUMENT. */
int hawser__has_absorbers(const struct hawser_statics *statics);
enum hawser_status hawser__check_absorbers(const struct hawser_statics *statics,
                                           struct hawser_report *report);

/* --- chain.c: point masses joined by springs --- */

enum hawser_status hawser__chain_solve(struct hawser_modes *modes,
                                       const struct hawser_statics *statics,
                                       const struct hawser_modes_options *options,
                                       struct hawser_report *report);

/* --- fdm.c: finite differences of the equations of motion --- */

enum hawser_status hawser__fdm_solve(struct hawser_modes *modes,
                                     const struct hawser_statics *statics,
                                     const struct hawser_modes_options *options,
                                     struct hawser_report *report);

/* The matrix A of the N - 1 inner points, dense, with A Y = omega^2 Y for a cable at rest: [n][n]
 * row-major, zero on entry; n = 2(N - 1) in the plane, with U and V alternating, and N - 1 out of
 * it. */
enum hawser_status hawser__fdm_dense(double *A, const struct hawser_statics *statics,
                                     enum hawser_plane plane, int N, struct hawser_report *report);

/* Shape and slope, [points][3] each and zero on entry, from the values x[n] at the inner points. */
enum hawser_status hawser__fdm_sample(double *shape, double *slope, const struct hawser_grid *grid,
                                      const double *x, const struct hawser_statics *statics,
                                      enum hawser_plane plane, int N, struct hawser_report *report);

#endif

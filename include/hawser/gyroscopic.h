/* hawser/gyroscopic.h - linear modes of a travelling cable about its steady state.
 *
 * Let q be the coordinates of the modes of the apparent cable at rest (struct hawser_motion), whose
 * stiffness K = diag(omega^2) is positive. Then
 *
 *   q'' + 2 nu G q' + K q = 0,    G skew (hawser_modes_convection)
 *
 * and the state (K^1/2 q, q') satisfies a first-order system with a real skew matrix. Its
 * eigenvalues are +-i omega, with a real part of exactly 0. The shapes are complex; a motion is the
 * real part of (shape) exp(i omega t).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_GYROSCOPIC_H
#define HAWSER_GYROSCOPIC_H

#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Row `index` of the table of methods for complex modes, from 0, the default first; NULL beyond the
 * last. Static storage. */
const struct hawser_modes_method *hawser_complex_modes_method(int index);

/* Compute complex modes, with the settings and statuses of hawser_modes_solve; options->method NULL
 * is "spectral". At speed 0 the method "spectral" gives the same frequencies and shapes as the
 * method of that name for modes at rest, to the last bit (shapes up to a sign). Release with
 * hawser_modes_clear. */
enum hawser_status hawser_complex_modes_solve(struct hawser_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* Real coordinates in place of modes at rest, for reduced models: 2 options->n of them, which span both
 * parts of the options->n lowest complex modes, without longitudinal motion. Shapes are orthonormal
 * and the energy is diagonal; `omega` is a frequency at rest, ascending, of a mode at rest where
 * several parts agree on it. A bare cable in its plane. Statuses of hawser_complex_modes_solve and
 * HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser_complex_modes_span(struct hawser_modes *modes,
                                             const struct hawser_statics *statics,
                                             const struct hawser_modes_options *options,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* The shape of mode k at s as the sum of a wave running downstream (with the cable) and a wave
 * running upstream, separated by the local wave speeds: downstream[6] and upstream[6], ordered as
 * the shape of hawser_modes_at. The modes are complex ones. */
void hawser_complex_modes_waves(const struct hawser_modes *modes, double *downstream,
                                double *upstream, int k, double s);

/* If the cable of the statics travels, these functions are hawser_complex_modes_solve and
 * hawser_complex_modes_method; otherwise they are hawser_modes_solve and hawser_modes_method. */
enum hawser_status hawser_steady_modes_solve(struct hawser_modes *modes,
                                             const struct hawser_statics *statics,
                                             const struct hawser_modes_options *options,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
const struct hawser_modes_method *hawser_steady_modes_method(const struct hawser_statics *statics,
                                                             int index);

#ifdef __cplusplus
}
#endif
#endif

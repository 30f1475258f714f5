/* modes/spectral.h - hp Legendre-Galerkin method with error control.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_SPECTRAL_H
#define HAWSER_MODES_SPECTRAL_H

#include <hawser/modes.h>

enum hawser_status hawser__spectral_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* Error estimate of a frequency whose relative change by one step with the exact operator is
 * `moved`. */
double hawser__spectral_estimate(double moved, int elements);

/* Bound of the relative round-off error of a frequency: the smallest error estimate. */
double hawser__spectral_round_off(int elements);

/* Adaptation of the basis: the error estimate to be reached, and whether a larger basis may still
 * lower it, since it is large or fell by half from `before` to `worst`. */
double hawser__spectral_target(const struct hawser_modes_options *options, int elements);
int hawser__spectral_improves(double worst, double before);

/* Failures: more modes than a basis of `basis` functions per component has; the modes need more
 * functions than allowed; the tolerance was not met with that many. */
enum hawser_status hawser__spectral_too_few(int n, int basis, struct hawser_report *report);
enum hawser_status hawser__spectral_too_many(int n, int functions, int most,
                                             struct hawser_report *report);
enum hawser_status hawser__spectral_unsettled(const struct hawser_modes_options *options,
                                              double worst, int functions, int tries,
                                              struct hawser_report *report);

#endif

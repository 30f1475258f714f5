/* modes/spectral.h - the converged method.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_SPECTRAL_H
#define HAWSER_MODES_SPECTRAL_H

#include <hawser/modes.h>

enum hawser_status hawser__spectral_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* Error of a frequency that one application of the exact operator moves by `moved`, relative. */
double hawser__spectral_estimate(double moved, int elements);

/* What round-off of the exact operator changes of a frequency at most, relative: the least error that
 * can be stated. */
double hawser__spectral_round_off(int elements);

/* Refusals: more functions would be needed than are allowed; not even those did. */
enum hawser_status hawser__spectral_too_many(int n, int functions, int most,
                                             struct hawser_report *report);
enum hawser_status hawser__spectral_unsettled(const struct hawser_modes_options *options,
                                              double worst, int functions, int tries,
                                              struct hawser_report *report);

#endif

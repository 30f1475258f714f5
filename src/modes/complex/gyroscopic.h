/* modes/complex/gyroscopic.h - the code common to the methods for modes of a travelling cable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_GYROSCOPIC_H
#define HAWSER_MODES_GYROSCOPIC_H

#include <hawser/gyroscopic.h>

enum hawser_status hawser__gyroscopic_solve(struct hawser_modes *modes,
                                            const struct hawser_statics *statics,
                                            const struct hawser_modes_options *options,
                                            struct hawser_report *report);
enum hawser_status hawser__gyroscopic_analytic(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_modes_options *options,
                                               struct hawser_report *report);
enum hawser_status hawser__gyroscopic_fdm(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* Modes by a method for cables at rest, converted to complex modes, for a cable that does not
 * travel. */
enum hawser_status hawser__gyroscopic_at_rest(struct hawser_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              const char *method, struct hawser_report *report);

/* Set norm, phase, shares, family and symmetry of complex mode k from its eigenvalue, shape and
 * slope; returns its norm before. For hawser__modes_label. */
double hawser__complex_label(struct hawser_modes *modes, int k);

#endif
